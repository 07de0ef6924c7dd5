//! The undeformed edges of contacts whose gaps follow the displacement.

use stickslip_contact::deformed::{Curve, CurveEnds};
use stickslip_contact::{ContactPoint, Facing, Stencil};
use stickslip_fem_core::mesh::Point;

use super::projection::{Side, Tied};
use crate::model::ModelError;
use crate::results::EdgeKind;
use stickslip_scene::schema::GapKind;

impl Tied<'_> {
    /// The edges `first` and `second` of the contact with the number `index`, tied at `points`.
    pub(super) fn facing(
        &self,
        index: usize,
        [first, second]: [&Side<'_>; 2],
        points: &[ContactPoint],
    ) -> Result<Facing, ModelError> {
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
            first: (0..points.len()).map(|k| self.place(first, k)).collect(),
            centre: edge.centre,
            second: match &self.means {
                Some(means) => curve.map_err(|what| self.refuse(what))?.with_places(means),
                None => curve.map_err(|what| self.refuse(what))?,
            },
        })
    }

    /// Where the force of the point `k` acts on the undeformed edge `first`.
    fn place(&self, first: &Side<'_>, k: usize) -> Point {
        match (&self.means, first.edge.kind) {
            (Some(means), EdgeKind::Circle { centre, radius }) => {
                let (sin, cos) = means[k].sin_cos();
                [centre[0] + radius * cos, centre[1] + radius * sin]
            }
            _ => first.position(k),
        }
    }
}

fn refused(index: usize, key: &str, what: String) -> ModelError {
    ModelError::Unsupported {
        key: format!("contacts.{index}.{key}"),
        what,
    }
}
