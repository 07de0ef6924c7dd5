//! `cylinder`: a cap above an arc that touches the origin, y = R − √(R² − x²), up to y = depth, for |x| ≤ half_length.

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::Point;

use super::curve::Curve;
use super::line_contact;
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::document::child;
use crate::units::{Length, Quantity};

pub(super) use super::line_contact::MESH_KEYS;

pub(super) const MEANING: &str = "from the arc that touches the origin from above up to y = depth, |x| ≤ half_length; its \
    arc is the edge `contact`; edges `contact`, `top`";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    length("radius", REQUIRED, r#""50 mm""#, "radius R of the arc").range(POSITIVE),
    length("half_length", REQUIRED, r#""40 mm""#, "half of its size along x, less than the radius").range(POSITIVE),
    length("depth", REQUIRED, r#""40 mm""#,
        "height of the top above the origin, greater than the arc's rise at its ends, R − √(R² − half_length²)").range(POSITIVE),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    radius: Quantity<Length>,
    half_length: Quantity<Length>,
    depth: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str =
    r#"cylinder = { radius = "100 mm", half_length = "20 mm", depth = "18 mm" }"#;

impl Keys {
    pub(super) fn read(&self, table: &str, sizes: &mut dyn Sizes) -> Cylinder {
        let Self {
            radius,
            half_length,
            depth,
        } = self;
        let cylinder = Cylinder {
            radius: radius.value(),
            half_length: half_length.value(),
            depth: depth.value(),
        };
        if cylinder.half_length >= cylinder.radius {
            let allowed = format!("less than the radius, {}", radius.text());
            sizes.refuse(&child(table, "half_length"), half_length, &allowed);
        } else if cylinder.depth <= cylinder.rise() {
            let allowed = "greater than the arc's rise at its ends, R − sqrt(R² − half_length²)";
            sizes.refuse(&child(table, "depth"), depth, allowed);
        }
        cylinder
    }
}

/// Above an arc that touches the origin from above, y = R − √(R² − x²), up to y = depth, for |x| ≤ half_length.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cylinder {
    /// Radius R of the arc `[mm]`.
    pub radius: f64,
    /// `[mm]`, less than the radius.
    pub half_length: f64,
    /// `[mm]`, above the ends of the arc.
    pub depth: f64,
}

impl Cylinder {
    /// Height of the arc's ends.
    fn rise(&self) -> f64 {
        let (radius, half) = (self.radius, self.half_length);
        radius - (radius * radius - half * half).sqrt()
    }
}

impl Outline for Cylinder {
    fn name(&self) -> &'static str {
        "cylinder"
    }

    fn edges(&self) -> Vec<Edge> {
        let [[left, _], [right, top]] = self.bounds();
        let curve = Curve::Arc {
            centre: [0.0, self.radius],
            radius: self.radius,
            ends: [[left, self.rise()], [right, self.rise()]],
            turn: 2.0 * (self.half_length / self.radius).asin(),
        };
        let contact = Edge {
            name: "contact".into(),
            curve,
            role: Role::Cap,
            size: Some("cylinder.radius".into()),
        };
        vec![contact, Edge::straight("top", [[right, top], [left, top]])]
    }

    fn bounds(&self) -> [Point; 2] {
        [[-self.half_length, 0.0], [self.half_length, self.depth]]
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
            "cylinder of radius {}, {} long and {} high",
            show(self.radius),
            show(2.0 * self.half_length),
            show(self.depth)
        )
    }
}
