//! What all plates around a circular hole share: the hole, and the fan of cells between it and the outline.

use stickslip_fem_core::generate::{
    self, Generate, GenerateError, Growth, MeshEstimate, PlateWithHole,
};
use stickslip_fem_core::mesh::{Mesh, Point};

use super::outline::{Divided, Edge, Meshing, Role};
use crate::declaration::{Key, POSITIVE, REQUIRED, length, table_as};

/// Name in scenes of all plates with a hole.
pub(super) const NAME: &str = "plate_with_hole";

pub(super) const MEANING: &str =
    "a plate around a circular hole at the origin; edges `hole` and those of its outline";

#[rustfmt::skip]
pub(super) const ROWS: &[Key] = &[
    length("hole_radius", REQUIRED, r#""5 mm""#, "radius of the hole").range(POSITIVE),
    table_as("outline", REQUIRED, r#".strip = { half_width = "40 mm", left = "180 mm", right = "40 mm" }"#, "outer edge"),
];

/// The keys that divide the plate.
pub(super) const MESH_KEYS: &[&str] = &["spacing", "angles", "fine_to", "coarse_spacing", "layers"];

/// Layers that start with square cells.
pub(super) const SQUARE: Growth = Growth::Geometric { aspect: 1.0 };

/// The hole as a scene gives it.
pub(super) struct Hole<'a> {
    /// Its radius `[mm]`.
    pub(super) radius: f64,
    /// Its radius as it is written.
    pub(super) text: &'a str,
}

/// The edge of a hole.
pub(super) fn edge(radius: f64) -> Edge {
    Edge::circular("hole", Role::Hole, radius, "plate_with_hole.hole_radius")
}

/// A mesh between the hole and `outline`, with `part` times as many layers as half the circle has divisions where the scene gives none.
pub(super) fn meshing(
    hole_radius: f64,
    outline: generate::Outline,
    part: f64,
    divided: &Divided<'_>,
) -> Meshing {
    let chosen = (part * divided.half_count()).round() as usize;
    let layers = (divided.layers).unwrap_or_else(|| chosen.max(4).min(divided.most_layers));
    let plate = PlateWithHole {
        hole_radius,
        outline,
        extent: divided.extent,
        angles: divided.angles.to_vec(),
        layers,
        growth: SQUARE,
        far_cells: ((divided.half_count() / 4.0).round() as usize).max(3),
        kind: divided.kind,
    };
    let centre = divided.centre;
    Meshing {
        generator: Box::new(Moved { plate, centre }),
        layers: Some(layers),
    }
}

/// A plate whose hole is somewhere else than at the origin.
struct Moved {
    plate: PlateWithHole,
    centre: Point,
}

impl Generate for Moved {
    type Output = Mesh;

    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        self.plate.estimate()
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        let mesh = self.plate.generate_within(limit)?;
        Ok(mesh.translated(self.centre)?)
    }
}
