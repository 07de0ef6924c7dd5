//! Checks of parameters.

use super::FringeError;

/// Refuses the parameter `name` unless it `fits`.
pub(super) fn parameter(
    name: &'static str,
    value: f64,
    fits: bool,
    range: &'static str,
) -> Result<(), FringeError> {
    if fits {
        Ok(())
    } else {
        Err(FringeError::Parameter { name, value, range })
    }
}

/// Refuses the parameter `name` unless it is finite and at least 0.
pub(super) fn not_negative(name: &'static str, value: f64) -> Result<(), FringeError> {
    let fits = value >= 0.0 && value.is_finite();
    parameter(name, value, fits, "finite and at least 0")
}

/// Refuses the parameter `name` unless it is finite and positive.
pub(super) fn positive(name: &'static str, value: f64) -> Result<(), FringeError> {
    parameter(
        name,
        value,
        value > 0.0 && value.is_finite(),
        "finite and positive",
    )
}
