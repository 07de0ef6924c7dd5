//! A number with its unit, as it stands in `summary.json`.

use std::borrow::Cow;

use serde::Serialize;
use stickslip_scene::units::Unit;
use stickslip_text::tidy;

/// A number with its unit, null where it is not finite.
#[derive(Debug, Serialize)]
pub(crate) struct Quantity {
    value: Option<f64>,
    unit: Cow<'static, str>,
}

impl Quantity {
    pub(crate) fn new(value: f64, unit: impl Into<Cow<'static, str>>) -> Self {
        Self {
            value: tidy(value),
            unit: unit.into(),
        }
    }

    /// A number of base units in `unit`.
    pub(crate) fn of(unit: &Unit, value: f64) -> Self {
        Self::new(unit.from_base(value), unit.name)
    }
}

/// A place or a force.
#[derive(Debug, Serialize)]
pub(crate) struct Vector {
    x: Option<f64>,
    y: Option<f64>,
    unit: &'static str,
}

impl Vector {
    /// A vector of base units in `unit`.
    pub(crate) fn of(unit: &Unit, [x, y]: [f64; 2]) -> Self {
        Self {
            x: tidy(unit.from_base(x)),
            y: tidy(unit.from_base(y)),
            unit: unit.name,
        }
    }
}
