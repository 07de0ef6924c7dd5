//! `plate_with_hole` with `outline.strip`.
//!
//! ```text
//!      half_width ┌──────────────────┐
//!                 │          ╭─╮     │
//!              0  │          ╰─╯     │
//!                 │                  │
//!     −half_width └──────────────────┘
//!               −left         0    right
//! ```

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate;
use stickslip_fem_core::mesh::Point;

use super::hole::{self, Hole};
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::document::child;
use crate::units::{Length, Quantity};

pub(super) const MEANING: &str =
    "−left ≤ x ≤ right, |y| ≤ half_width; edges `left`, `right`, `top`, `bottom`";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    length("half_width", REQUIRED, r#""40 mm""#, "half of the width").range(POSITIVE),
    length("left", REQUIRED, r#""40 mm""#, "distance to the edge at −x").range(POSITIVE),
    length("right", REQUIRED, r#""40 mm""#, "distance to the edge at +x").range(POSITIVE),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    half_width: Quantity<Length>,
    left: Quantity<Length>,
    right: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str = r#"plate_with_hole = { hole_radius = "5 mm", outline.strip = { half_width = "20 mm", left = "70 mm", right = "15 mm" } }"#;

impl Keys {
    pub(super) fn read(&self, table: &str, hole: &Hole<'_>, sizes: &mut dyn Sizes) -> Strip {
        let Self {
            half_width,
            left,
            right,
        } = self;
        let mut beyond = |name: &str, size: &Quantity<Length>| {
            let value = size.value();
            if value > 0.0 && value <= hole.radius {
                let allowed = format!("greater than the hole's radius, {}", hole.text);
                sizes.refuse(&child(table, name), size, &allowed);
            }
            value
        };
        Strip {
            hole_radius: hole.radius,
            half_width: beyond("half_width", half_width),
            left: beyond("left", left),
            right: beyond("right", right),
        }
    }
}

/// A strip around a circular hole: x in [−left, right], |y| ≤ half_width.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Strip {
    /// Radius of the hole `[mm]`.
    pub hole_radius: f64,
    /// Half of its width, from the centre of the hole to either side `[mm]`.
    pub half_width: f64,
    /// From the centre of the hole to the end at negative x `[mm]`.
    pub left: f64,
    /// From the centre of the hole to the end at positive x `[mm]`.
    pub right: f64,
}

impl Outline for Strip {
    fn name(&self) -> &'static str {
        hole::NAME
    }

    fn edges(&self) -> Vec<Edge> {
        let [[left, bottom], [right, top]] = self.bounds();
        let side = |name, ends| {
            let edge = Edge::straight(name, ends).with_role(Role::Side);
            edge.placed_by("plate_with_hole.outline.strip.half_width")
        };
        vec![
            hole::edge(self.hole_radius),
            Edge::straight("left", [[left, top], [left, bottom]])
                .placed_by("plate_with_hole.outline.strip.left"),
            Edge::straight("right", [[right, bottom], [right, top]])
                .with_role(Role::End)
                .placed_by("plate_with_hole.outline.strip.right"),
            side("top", [[right, top], [left, top]]),
            side("bottom", [[left, bottom], [right, bottom]]),
        ]
    }

    fn bounds(&self) -> [Point; 2] {
        [
            [-self.left, -self.half_width],
            [self.right, self.half_width],
        ]
    }

    fn mirror(&self) -> Option<usize> {
        Some(1)
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        hole::MESH_KEYS
    }

    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let outline = generate::Outline::Strip {
            half_width: self.half_width,
            left: self.left,
            right: self.right,
        };
        Ok(hole::meshing(self.hole_radius, outline, 0.4, divided))
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        format!(
            "strip {} wide, {} to the left and {} to the right of a hole of radius {}",
            show(2.0 * self.half_width),
            show(self.left),
            show(self.right),
            show(self.hole_radius)
        )
    }
}
