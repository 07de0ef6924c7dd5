//! Numbers of findings with their units.

use serde::Serialize;

/// A length or an angle in base units; serialised as `{"unit": "mm", "value": 1.0}`.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "unit", content = "value")]
pub enum Quantity {
    /// `[mm]`.
    #[serde(rename = "mm")]
    Length(f64),
    /// `[rad]`.
    #[serde(rename = "rad")]
    Angle(f64),
    /// An arc length along an edge from its middle `[mm]`.
    #[serde(rename = "mm along the edge")]
    Along(f64),
    /// `[MPa]`.
    #[serde(rename = "MPa")]
    Stress(f64),
}

impl Quantity {
    /// Its magnitude.
    #[must_use]
    pub fn abs(self) -> Self {
        match self {
            Self::Length(value) => Self::Length(value.abs()),
            Self::Angle(value) => Self::Angle(value.abs()),
            Self::Along(value) => Self::Along(value.abs()),
            Self::Stress(value) => Self::Stress(value.abs()),
        }
    }

    /// Its number `[mm, rad or MPa]`.
    pub fn value(self) -> f64 {
        match self {
            Self::Length(value) | Self::Angle(value) | Self::Along(value) | Self::Stress(value) => {
                value
            }
        }
    }
}
