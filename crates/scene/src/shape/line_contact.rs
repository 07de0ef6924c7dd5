//! Caps on surfaces, which are divided together: the contact nodes of one face those of the other.

use stickslip_fem_core::generate::{CylinderOnBlock, Generate, GenerateError, MeshEstimate};
use stickslip_fem_core::mesh::Mesh;

use super::curve::Curve;
use super::outline::{Divided, DivisionError, Meshing, Outline, Role};

/// The keys that divide a cap and its surface.
pub(super) const MESH_KEYS: &[&str] = &["spacing", "fine_to"];
/// Growth of cells from one to the next, in every division: half of it changes the approach of Q8 bodies by 7e-5, a fifth of what other causes
/// leave in the finest ladders, and costs eight times as much.
const GROWTH: f64 = 1.12;
/// Half of the fine zone where the scene does not say, as a part of the half length.
const FINE_PART: f64 = 1.0 / 8.0;

/// Half of the zone of equal spacing `[mm]`.
pub(super) fn fine_to(given: Option<f64>, half_length: f64) -> f64 {
    given.unwrap_or(half_length * FINE_PART)
}

/// The mesh of `own`, which has a cap or a surface, with its partner's grid lines.
pub(super) fn meshing(own: &dyn Outline, divided: &Divided<'_>) -> Result<Meshing, DivisionError> {
    let places = divided.places.map(<[f64]>::to_vec);
    let closest = places.as_ref().map(|places| {
        let widths = places.windows(2).map(|ends| ends[1] - ends[0]);
        widths.fold(f64::INFINITY, f64::min)
    });
    let spacing = divided
        .spacing
        .or(closest)
        .ok_or(DivisionError::NeedsLength)?;
    let partner = divided.partner.ok_or(DivisionError::NoPartner)?;
    let lengths = [own, partner].map(|shape| shape.bounds()[1][0]);
    let heights = [own, partner].map(|shape| {
        let [[_, low], [_, high]] = shape.bounds();
        high - low
    });
    let radius =
        [own, partner]
            .into_iter()
            .find_map(|shape| match shape.edge_with(Role::Cap)?.curve {
                Curve::Arc { radius, .. } => Some(radius),
                _ => None,
            });
    let half_width = lengths[0].min(lengths[1]);
    let height = heights[0].min(heights[1]);
    let (inner, growth) = match &places {
        // Nothing is solved on the rows.
        Some(_) => (
            spacing,
            GROWTH.max((height / spacing).powf(1.0 / divided.most_layers as f64)),
        ),
        None => (fine_to(divided.fine_to, half_width), GROWTH),
    };
    let cells = inner / spacing;
    if cells * cells > divided.most as f64 {
        return Err(DivisionError::TooManyNodes {
            nodes: cells * cells * 3.0,
        });
    }
    let pair = CylinderOnBlock {
        radius: radius.ok_or(DivisionError::NoPartner)?,
        half_width,
        height,
        inner,
        spacing,
        growth,
        columns: places,
        extent: divided.extent,
        kind: divided.kind,
    };
    let is_cap = own.edge_with(Role::Cap).is_some();
    Ok(Meshing {
        generator: Box::new(OneOfTwo { pair, is_cap }),
        layers: None,
    })
}

/// One body of the pair.
struct OneOfTwo {
    pair: CylinderOnBlock,
    is_cap: bool,
}

impl Generate for OneOfTwo {
    type Output = Mesh;

    /// Both bodies together.
    fn estimate(&self) -> Result<MeshEstimate, GenerateError> {
        self.pair.estimate()
    }

    fn generate_within(&self, limit: usize) -> Result<Mesh, GenerateError> {
        if self.is_cap {
            self.pair.upper_within(limit)
        } else {
            self.pair.lower_within(limit)
        }
    }
}
