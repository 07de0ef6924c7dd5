//! `block`: x in [−half_length, half_length], y in [−depth, 0]; stands for the half-plane y ≤ 0.

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::Point;

use super::line_contact;
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::units::{Length, Quantity};

pub(super) use super::line_contact::MESH_KEYS;

pub(super) const MEANING: &str = "|x| ≤ half_length, −depth ≤ y ≤ 0; its top is the edge `contact`; edges `contact`, \
    `bottom`, `left`, `right`";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    length("half_length", REQUIRED, r#""40 mm""#, "half of its size along x").range(POSITIVE),
    length("depth", REQUIRED, r#""40 mm""#, "size along y").range(POSITIVE),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    half_length: Quantity<Length>,
    depth: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str = r#"block = { half_length = "20 mm", depth = "18 mm" }"#;

impl Keys {
    pub(super) fn read(&self, _: &str, _: &mut dyn Sizes) -> Block {
        let Self { half_length, depth } = self;
        Block {
            half_length: half_length.value(),
            depth: depth.value(),
        }
    }
}

/// x in [−half_length, half_length], y in [−depth, 0]; stands for the half-plane y ≤ 0.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Block {
    /// `[mm]`
    pub half_length: f64,
    /// `[mm]`
    pub depth: f64,
}

impl Outline for Block {
    fn name(&self) -> &'static str {
        "block"
    }

    fn edges(&self) -> Vec<Edge> {
        let [[left, bottom], [right, top]] = self.bounds();
        vec![
            Edge::straight("contact", [[right, top], [left, top]]).with_role(Role::Surface),
            Edge::straight("bottom", [[left, bottom], [right, bottom]]),
            Edge::straight("left", [[left, top], [left, bottom]]),
            Edge::straight("right", [[right, bottom], [right, top]]),
        ]
    }

    fn bounds(&self) -> [Point; 2] {
        [[-self.half_length, -self.depth], [self.half_length, 0.0]]
    }

    fn mirror(&self) -> Option<usize> {
        Some(0)
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        MESH_KEYS
    }

    fn fine_to(&self, given: Option<f64>) -> Option<f64> {
        Some(line_contact::fine_to(given, self.half_length))
    }

    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        line_contact::meshing(self, divided)
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        format!(
            "block {} long and {} deep",
            show(2.0 * self.half_length),
            show(self.depth)
        )
    }
}
