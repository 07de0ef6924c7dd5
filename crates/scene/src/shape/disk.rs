//! `disk`: a pin.

use std::borrow::Cow;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::generate;
use stickslip_fem_core::mesh::Point;

use super::hole::SQUARE;
use super::outline::{Divided, DivisionError, Edge, Meshing, Outline, Role, Sizes};
use crate::declaration::{Key, POSITIVE, REQUIRED, length};
use crate::units::{Length, Quantity};

pub(super) use super::outline::CIRCLE_KEYS as MESH_KEYS;

pub(super) const MEANING: &str = "a disk around the origin, or in the hole that holds it; edges `rim`; points `centre`; areas `section`";

pub(super) const ROWS: &[Key] =
    &[length("radius", REQUIRED, r#""5 mm""#, "radius").range(POSITIVE)];

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Keys {
    radius: Quantity<Length>,
}

#[cfg(test)]
pub(super) const EXAMPLE: &str = r#"disk = { radius = "5 mm" }"#;

impl Keys {
    pub(super) fn read(&self, _: &str, _: &mut dyn Sizes) -> Disk {
        let Self { radius } = self;
        Disk {
            radius: radius.value(),
        }
    }
}

/// A disk.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Disk {
    /// Radius `[mm]`.
    pub radius: f64,
}

impl Outline for Disk {
    fn name(&self) -> &'static str {
        "disk"
    }

    fn turns_freely(&self) -> bool {
        true
    }

    fn edges(&self) -> Vec<Edge> {
        vec![Edge::circular("rim", Role::Rim, self.radius, "disk.radius")]
    }

    fn points(&self) -> Vec<(Cow<'static, str>, Point)> {
        vec![("centre".into(), [0.0; 2])]
    }

    fn areas(&self) -> &'static [&'static str] {
        &["section"]
    }

    fn bounds(&self) -> [Point; 2] {
        [[-self.radius; 2], [self.radius; 2]]
    }

    fn mirror(&self) -> Option<usize> {
        Some(1)
    }

    fn mesh_keys(&self) -> &'static [&'static str] {
        MESH_KEYS
    }

    fn is_similar(&self) -> bool {
        true
    }

    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
        let chosen = (0.22 * divided.half_count()).round() as usize;
        let layers = chosen.max(3).min(divided.most_layers);
        let generator = generate::Disk {
            radius: self.radius,
            centre: divided.centre,
            extent: divided.extent,
            angles: divided.angles.to_vec(),
            core: generate::Disk::CORE,
            layers,
            growth: SQUARE,
            kind: divided.kind,
        };
        Ok(Meshing {
            generator: Box::new(generator),
            layers: Some(layers),
        })
    }

    fn describe(&self, show: &dyn Fn(f64) -> String) -> String {
        format!("disk of radius {}", show(self.radius))
    }
}
