//! Friction of a laboratory, and how its displacements are seen.

use serde_json::Value;

/// Friction of the truth.
#[derive(Clone, Debug)]
pub(super) struct Friction {
    /// Kind of the law, `coulomb` where there is no friction.
    pub(super) kind: &'static str,
    pub(super) fixed: f64,
    pub(super) moving: f64,
    /// Slip scale `[mm]` of `slip_power`.
    pub(super) scale: f64,
    pub(super) law: Value,
}

/// How displacements are seen.
#[derive(Clone, Debug)]
pub(super) enum Medium {
    /// A table on a square grid; errors are means over squares of `reach` places.
    Table { spacing: f64, reach: usize },
    /// Fringe pictures of 8 bits: lines per mm, carrier `[1/mm]`, pixel `[mm]`, light that falls off by this part towards the corners.
    Pictures {
        frequency: f64,
        carrier: f64,
        pixel: f64,
        falloff: f64,
    },
}

impl Friction {
    pub(super) fn named(&self) -> String {
        let none = self.moving == 0.0;
        format!("friction {}", if none { "none" } else { self.kind })
    }
}

impl Medium {
    pub(super) fn named(&self) -> String {
        let name = match self {
            Self::Table { reach: 1, .. } => "table, independent errors",
            Self::Table { .. } => "table, correlated errors",
            Self::Pictures { .. } => "fringe pictures",
        };
        name.to_owned()
    }
}
