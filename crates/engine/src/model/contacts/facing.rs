//! The undeformed edges of contacts whose gaps follow the displacement.

use stickslip_contact::deformed::{Curve, CurveEnds};
use stickslip_contact::{ContactPoint, Facing, Stencil};
use stickslip_series::Nodes;

use super::projection::{Side, Tied};
use crate::model::ModelError;
use crate::model::plan::Plan;
use crate::results::EdgeKind;
use crate::series::SeriesBody;
use stickslip_scene::schema::GapKind;

/// Nodes and the means of their hats that are closer are one place `[rad]`.
const EQUAL: f64 = 1e-9;

/// Of two `bodies` in contact the one by series that touches one of elements, and the nodes of the second one by series.
pub(super) fn by_series<'p>(
    plan: &'p Plan<'_>,
    bodies: [usize; 2],
) -> (Option<&'p SeriesBody>, Option<&'p Nodes>) {
    let series = |own: usize| plan.bodies[own].series.as_deref();
    let is_of_elements = |&own: &usize| !plan.is_rigid(own) && series(own).is_none();
    let beside_elements = bodies.into_iter().find_map(series);
    let beside_elements = beside_elements.filter(|_| bodies.iter().any(is_of_elements));
    (
        beside_elements,
        series(bodies[1]).and_then(SeriesBody::circle_nodes),
    )
}

impl Tied<'_> {
    /// The edges `first` and `second` of the contact with the number `index`, tied at `points`; `beside_elements` is the body by series that touches one of elements, `faced` are the nodes of
    /// a second body by series.
    pub(super) fn facing(
        &self,
        index: usize,
        [first, second]: [&Side<'_>; 2],
        points: &[ContactPoint],
        (beside_elements, faced): (Option<&SeriesBody>, Option<&Nodes>),
    ) -> Result<Facing, ModelError> {
        beside_elements.map_or(Ok(()), check_spacing)?;
        let Some(shape) = self.geometry.second(first.edge.centre.unwrap_or_default()) else {
            let what = format!(
                "analysis.kinematics = \"deformed-gaps\" is for circles in holes and cylinders on blocks, and contact '{}' is one of other edges; say kinematics = \"small\"",
                self.contact.name
            );
            return Err(refused(index, "first", what));
        };
        if self.contact.gap != GapKind::Exact {
            let what = format!(
                "analysis.kinematics = \"deformed-gaps\" measures gaps of the true shapes, and contact '{}' has another `gap`; leave it out, or \
                 say kinematics = \"small\"",
                self.contact.name
            );
            return Err(refused(index, "gap", what));
        }
        let single = |point: &ContactPoint| [&point.first, &point.second].map(Stencil::node);
        if points.iter().any(|point| single(point).contains(&None)) {
            let what = format!(
                "analysis.kinematics = \"deformed-gaps\" needs pairs of nodes, and contact '{}' is tied by a mortar projection; give both edges the \
                 same divisions, or say kinematics = \"small\"",
                self.contact.name
            );
            return Err(refused(index, "projection", what));
        }
        let edge = first.edge;
        let round = matches!(edge.kind, EdgeKind::Circle { .. });
        // Displacements of series are means over hats, which are about other places than nodes where neighbours are unequally far.
        let means = (self.means.as_ref()).filter(|means| !are_equal(means, &second.edge.parameter));
        let place = |k: usize| match (edge.kind, means) {
            (EdgeKind::Circle { centre, radius }, Some(means)) => {
                let (sin, cos) = means[k].sin_cos();
                [centre[0] + radius * cos, centre[1] + radius * sin]
            }
            _ => first.position(k),
        };
        let (angles, means) = match faced {
            // Nodes of a second body may stand where those of the first face them.
            Some(faced) if !are_equal(faced.angles(), &second.edge.parameter) => {
                (faced.angles().to_vec(), Some(faced.mean_angles()))
            }
            _ => (second.edge.parameter.clone(), means.cloned()),
        };
        let curve = Curve::new(
            shape,
            second.local.clone(),
            angles,
            second.edge.order,
            if round && !self.half {
                CurveEnds::Closed
            } else {
                CurveEnds::Open {
                    mirrored: [self.half, self.half && round],
                }
            },
        );
        let curve = match means {
            Some(means) => curve.and_then(|curve| curve.standing_at(means)),
            None => curve,
        };
        Ok(Facing {
            first: (0..points.len()).map(place).collect(),
            centre: edge.centre,
            second: curve.map_err(|cause| self.refuse(cause.to_string()))?,
        })
    }
}

/// Refuses a body by series whose nodes are not equally spaced: means over its hats are not at nodes of elements.
fn check_spacing(body: &SeriesBody) -> Result<(), ModelError> {
    let Some(nodes) = body.circle_nodes() else {
        return Ok(());
    };
    if are_equal(&nodes.mean_angles(), nodes.angles()) {
        return Ok(());
    }
    Err(ModelError::Unsupported {
        key: "analysis.kinematics".into(),
        what: "\"deformed-gaps\" needs equally spaced nodes where a body by series touches one of elements: displacements of the one are means \
               about its nodes, those of the other are at nodes. Space the nodes equally, or say kinematics = \"small\""
            .into(),
    })
}

fn are_equal(means: &[f64], angles: &[f64]) -> bool {
    let mut both = means.iter().zip(angles);
    both.all(|(mean, at)| (mean - at).abs() <= EQUAL)
}

fn refused(index: usize, key: &str, what: String) -> ModelError {
    ModelError::Unsupported {
        key: format!("contacts.{index}.{key}"),
        what,
    }
}
