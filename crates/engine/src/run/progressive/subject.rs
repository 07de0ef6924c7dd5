//! The body whose failure is followed, and what the scene says of it.

use stickslip_fem_core::mesh::Mesh;
use stickslip_joint::{CrackBand, CrackBandError, FractureEnergies};
use stickslip_laminate::Degradation;
use stickslip_scene::schema::{LaminateSheet, Progressive};

use crate::model::{FollowedJoint, Model, ModelBodyKind};
use crate::results::BodyFailure;
use crate::run::error::{ProgressiveRunError, RunError};

/// A body whose failure is followed.
pub(in crate::run) struct Subject<'a> {
    pub(super) sheet: &'a LaminateSheet,
    pub(super) followed: &'a FollowedJoint,
    pub(super) asked: &'a Progressive,
    pub(super) found: &'a BodyFailure,
}

impl<'a> Subject<'a> {
    pub(in crate::run) fn new(
        sheet: &'a LaminateSheet,
        followed: &'a FollowedJoint,
        found: &'a BodyFailure,
    ) -> Self {
        Self {
            sheet,
            followed,
            asked: &followed.asked,
            found,
        }
    }

    pub(super) fn refused(&self, cause: ProgressiveRunError) -> RunError {
        RunError::Progressive {
            body: self.asked.body.clone(),
            cause: Box::new(cause),
        }
    }

    /// Its mesh in `model`.
    pub(super) fn mesh<'m>(&self, model: &'m Model) -> Option<&'m Mesh> {
        match &model.bodies[self.found.body].kind {
            ModelBodyKind::Elastic(body) => Some(body.mesh()),
            ModelBodyKind::Rigid(_) => None,
        }
    }
}

/// Bands on `mesh`: rows of points of quadratic quadrilaterals are half a cell wide.
pub(super) fn crack_band(
    energies: FractureEnergies,
    degradation: Degradation,
    mesh: &Mesh,
) -> Result<CrackBand, CrackBandError> {
    let order = mesh.blocks().iter().map(|block| block.kind.order()).max();
    CrackBand::new(energies, degradation)?.with_width(1.0 / order.unwrap_or(1) as f64)
}
