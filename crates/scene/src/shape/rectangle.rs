//! `rectangle`: a coupon with x in [−width/2, width/2] and y in [−height, 0].

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate;
use stickslip_fem_core::mesh::Point;

use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::units::{Length, Quantity};

pub(super) const MESH_KEYS: &[&str] = &["spacing"];

pub(super) const MEANING: &str =
    "|x| ≤ width/2, −height ≤ y ≤ 0; edges `left`, `right`, `bottom`, `top`";

pub(super) const ROWS: &[Key] = &[
    length("width", REQUIRED, r#""40 mm""#, "size along x").range(POSITIVE),
    length("height", REQUIRED, r#""40 mm""#, "size along y").range(POSITIVE),
];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    width: Quantity<Length>,
    height: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str = r#"rectangle = { width = "60 mm", height = "20 mm" }"#;

impl Keys {
    pub(super) fn read(&self, _: &str, _: &mut dyn Sizes) -> Rectangle {
        let Self { width, height } = self;
        Rectangle {
            width: width.value(),
            height: height.value(),
        }
    }
}

/// x in [−width/2, width/2], y in [−height, 0].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rectangle {
    /// `[mm]`
    pub width: f64,
    /// `[mm]`
    pub height: f64,
}

impl Outline for Rectangle {
    fn name(&self) -> &'static str {
        "rectangle"
    }

    fn edges(&self) -> Vec<Edge> {
        let [[left, bottom], [right, top]] = self.bounds();
        vec![
            Edge::straight("left", [[left, top], [left, bottom]]),
            Edge::straight("right", [[right, bottom], [right, top]]),
            Edge::straight("bottom", [[left, bottom], [right, bottom]]),
            Edge::straight("top", [[right, top], [left, top]]),
        ]
    }

    fn bounds(&self) -> [Point; 2] {
        [[-self.width / 2.0, -self.height], [self.width / 2.0, 0.0]]
    }

    fn mirror(&self) -> Option<usize> {
        None
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        MESH_KEYS
    }

    /// Equal cells of the scene's spacing, or 20 across the shorter side.
    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let coarse = self.width.min(self.height) / 20.0;
        let spacing = divided.spacing.unwrap_or(coarse);
        let cells = |length: f64| ((length / spacing).ceil().clamp(1.0, 1e7)) as usize;
        let [[left, bottom], [right, top]] = self.bounds();
        let generator = generate::Rectangle::uniform(
            [left, right],
            [bottom, top],
            [cells(self.width), cells(self.height)],
            divided.kind,
        )?;
        Ok(Meshing {
            generator: Box::new(generator),
            layers: None,
        })
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        format!("rectangle {} by {}", show(self.width), show(self.height))
    }
}
