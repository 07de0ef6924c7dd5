//! Places beside supports, where stresses of the model are no stresses of the part.
//!
//! ```text
//! σ ~ r^(λ − 1),   0 < λ < 1     at the distance r from the end of a clamped edge, or from a point that is held
//! ```
//!
//! There the stress grows without bound as the mesh is refined (Williams 1952), so the first ply would fail at a clamp, at a load
//! that depends on the mesh. Plies are not evaluated within a stated distance of such places; a note reports what would fail there first.

use stickslip_fem_core::mesh::Point;

use super::{RunError, Subject};
use crate::failure::Sites;
use crate::model::ModelError;
use crate::results::BesideSupports;

/// The distance, as a part of the body's smaller outer dimension, unless the scene gives one.
const CLEAR: f64 = 0.05;
/// Coordinates that are zero to rounding, and distances that are equal, as parts of the body's size.
const ROUNDING: f64 = 1e-9;

/// Nodes of a body by whether their plies are asked.
pub(super) struct Search {
    /// Distance from the places that are left out `[mm]`.
    distance: f64,
    kept: Vec<usize>,
    beside: Vec<usize>,
}

impl Subject<'_> {
    /// Which nodes are asked.
    ///
    /// # Errors
    /// [`ModelError::Unsupported`] if none is left.
    pub(super) fn search(&self) -> Result<Search, RunError> {
        let places = self.singular_places();
        let distance = self.failure.clear_of_supports;
        let distance = distance.unwrap_or_else(|| CLEAR * self.smaller_dimension());
        let reach = distance * (1.0 + ROUNDING);
        let nodes = self.mesh.nodes();
        let near = |&node: &usize| {
            let [x, y] = nodes[node];
            let within = |place: &Point| (x - place[0]).hypot(y - place[1]) <= reach;
            distance > 0.0 && places.iter().any(within)
        };
        let (beside, kept): (Vec<usize>, Vec<usize>) = (0..nodes.len()).partition(near);
        if kept.is_empty() {
            let length = self.model.request.units.length.show(distance);
            return Err(RunError::Model(ModelError::Unsupported {
                key: "failure.clear_of_supports".to_owned(),
                what: format!(
                    "all of body '{}' lies within {length} of the ends of its supports, so no ply is left to check",
                    self.name
                ),
            }));
        }
        Ok(Search {
            distance,
            kept,
            beside,
        })
    }

    /// Ends of supported edges and platens, and points that are held. An end on the line of symmetry does not count.
    fn singular_places(&self) -> Vec<Point> {
        let line = ROUNDING * self.smaller_dimension();
        let inner = |place: &Point| self.model.half && place[self.across].abs() <= line;
        let places = self.model.bodies[self.index].singular.iter();
        let places = places.map(|place| self.mesh.nodes()[place.node()]);
        places.filter(|place| !inner(place)).collect()
    }

    /// The smaller side of the box around the whole body `[mm]`.
    fn smaller_dimension(&self) -> f64 {
        let [low, high] = self.mesh.bounding_box();
        let side = |axis: usize| {
            let whole = if self.model.half && axis == self.across {
                2.0
            } else {
                1.0
            };
            whole * (high[axis] - low[axis])
        };
        side(0).min(side(1))
    }

    /// First-ply failure beside the supports by each criterion.
    pub(super) fn beside_supports(
        &self,
        search: &Search,
        steps: &[Sites],
    ) -> Result<Option<BesideSupports>, RunError> {
        if search.beside.is_empty() {
            return Ok(None);
        }
        Ok(Some(BesideSupports {
            distance: search.distance,
            sooner: self.at_places(steps, self.mesh.nodes(), &search.beside)?,
        }))
    }
}

impl Search {
    /// The places that are asked.
    pub(super) fn kept(&self, steps: Vec<Sites>, places: &[Point]) -> (Vec<Sites>, Vec<Point>) {
        if self.beside.is_empty() {
            return (steps, places.to_vec());
        }
        let kept = |sites: Sites| sites.chosen(&self.kept);
        let places = self.kept.iter().map(|&node| places[node]).collect();
        (steps.into_iter().map(kept).collect(), places)
    }
}
