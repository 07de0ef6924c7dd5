//! The undeformed edges of contacts whose gaps follow the displacement.

use stickslip_contact::deformed::{Curve, CurveEnds};
use stickslip_contact::{ContactPoint, Facing, Stencil};

use super::projection::{Side, Tied};
use crate::model::ModelError;
use crate::results::EdgeKind;
use crate::series::SeriesBody;
use stickslip_scene::schema::GapKind;

/// Nodes and the means of their hats that are closer are one place `[rad]`.
const EQUAL: f64 = 1e-9;

impl Tied<'_> {
    /// The edges `first` and `second` of the contact with the number `index`, tied at `points`; `series` are those of its bodies that are one.
    pub(super) fn facing<'s>(
        &self,
        index: usize,
        [first, second]: [&Side<'_>; 2],
        points: &[ContactPoint],
        mut series: impl Iterator<Item = &'s SeriesBody>,
    ) -> Result<Facing, ModelError> {
        series.try_for_each(check_spacing)?;
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
        let nodes = second.edge.nodes.len();
        let curve = Curve::new(
            self.geometry.second(edge.centre.unwrap_or_default()),
            (0..nodes).map(|k| second.local.start + k).collect(),
            second.edge.parameter.clone(),
            second.edge.order,
            if round && !self.half {
                CurveEnds::Closed
            } else {
                CurveEnds::Open {
                    mirrored: [self.half, self.half && round],
                }
            },
        );
        Ok(Facing {
            first: (0..points.len()).map(|k| first.position(k)).collect(),
            centre: edge.centre,
            second: curve.map_err(|what| self.refuse(what))?,
        })
    }
}

/// Refuses a body by series whose nodes are not equally spaced.
fn check_spacing(body: &SeriesBody) -> Result<(), ModelError> {
    let nodes = body.nodes();
    let means = nodes.mean_angles();
    let mut apart = means.iter().zip(nodes.angles());
    if apart.all(|(mean, at)| (mean - at).abs() <= EQUAL) {
        return Ok(());
    }
    Err(ModelError::Unsupported {
        key: "analysis.kinematics".into(),
        what: "\"deformed-gaps\" needs equally spaced nodes on bodies by series: slopes are differences of neighbours, and pressures do not converge \
               where spacings differ. Space the nodes equally, or say kinematics = \"small\""
            .into(),
    })
}

fn refused(index: usize, key: &str, what: String) -> ModelError {
    ModelError::Unsupported {
        key: format!("contacts.{index}.{key}"),
        what,
    }
}
