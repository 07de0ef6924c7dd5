//! Arithmetic of fringe orders.

/// A number less its nearest whole number.
pub(super) fn wrap(value: f64) -> f64 {
    value - value.round()
}
