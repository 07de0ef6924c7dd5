//! `plate_with_hole` with `outline.ring`: the body between two circles about one centre.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate;
use stickslip_fem_core::mesh::Point;

use super::hole::{self, Hole};
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::document::child;
use crate::units::{Length, Quantity};

pub(super) const MEANING: &str =
    "a circle around the hole; also in the hole that holds it; edges `outer`";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    length("radius", REQUIRED, r#""50 mm""#, "radius of the outer edge, greater than the hole's").range(POSITIVE),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    radius: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str =
    r#"plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "15 mm" }"#;

impl Keys {
    pub(super) fn read(&self, table: &str, hole: &Hole<'_>, sizes: &mut dyn Sizes) -> Ring {
        let Self { radius: given } = self;
        let radius = given.value();
        if radius > 0.0 && radius <= hole.radius {
            let allowed = format!("greater than the hole's radius, {}", hole.text);
            sizes.refuse(&child(table, "radius"), given, &allowed);
        }
        Ring {
            hole_radius: hole.radius,
            radius,
        }
    }
}

/// A ring: a plate with a concentric circle around its hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Ring {
    /// Radius of the hole `[mm]`.
    pub hole_radius: f64,
    /// Radius of the outer edge `[mm]`.
    pub radius: f64,
}

impl Outline for Ring {
    fn name(&self) -> &'static str {
        hole::NAME
    }

    fn turns_freely(&self) -> bool {
        true
    }

    fn edges(&self) -> Vec<Edge> {
        let key = "plate_with_hole.outline.ring.radius";
        let outer = Edge::circular("outer", Role::Rim, self.radius, key);
        vec![hole::edge(self.hole_radius), outer]
    }

    fn bounds(&self) -> [Point; 2] {
        [[-self.radius; 2], [self.radius; 2]]
    }

    fn mirror(&self) -> Option<usize> {
        Some(1)
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        hole::MESH_KEYS
    }

    /// A thin ring needs no more layers than square cells all through it do: ln(R/r) / Δθ, and a tenth more.
    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let part = f64::min(0.55, 1.1 * (self.radius / self.hole_radius).ln() / PI);
        let outline = generate::Outline::Ring {
            outer_radius: self.radius,
        };
        Ok(hole::meshing(self.hole_radius, outline, part, divided))
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        format!(
            "ring of radii {} and {}",
            show(self.hole_radius),
            show(self.radius)
        )
    }
}
