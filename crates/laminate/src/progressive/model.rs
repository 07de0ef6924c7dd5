//! The trait behind which all point models stand: committed state and strain in; stress, tangent and trial state out.

use std::fmt::Debug;

use stickslip_fem_core::material::PlaneStiffness;

use super::error::ProgressiveError;
use super::state::{PointResponse, PointState};
use crate::laminate::Laminate;

/// A laminate with history at one point, in plane stress and held flat: where it could bend, a lay-up that is not symmetric is softer
/// ([`Laminate::coupling`] says by how much).
pub trait PointModel: Debug + Send + Sync {
    /// The undamaged laminate.
    fn laminate(&self) -> &Laminate;

    /// Computes stress, tangent and trial state for the total strain `strain` (xx, yy, xy), dimensionless, at the temperature rise `temperature`
    /// `[temperature]` since the plies were free of stress, coming from the state `committed`.
    ///
    /// # Errors
    /// [`ProgressiveError::NotFinite`] or [`ProgressiveError::LayerCount`] for a step that makes no sense,
    /// [`ProgressiveError::ReturnMapping`] or [`ProgressiveError::Failure`] where the model itself fails.
    fn respond(
        &self,
        committed: &PointState,
        strain: [f64; 3],
        temperature: f64,
    ) -> Result<PointResponse, ProgressiveError>;

    /// Computes the mean stiffness (3×3, `[stress]`) with the damage of `state`, if failed plies kept the part `part` in [0, 1] of what the model leaves
    /// them; `None` for a model whose plies do not fail. What a body bears for any `part` it bears by what is sound.
    fn weakened_stiffness(&self, state: &PointState, part: f64) -> Option<PlaneStiffness> {
        let _ = (state, part);
        None
    }

    /// Makes the state before any load: no strain, no stress, no damage. The residual stress of a cure is that of a first step to its
    /// temperature change and the laminate's free thermal strain
    /// ([`LaminateMembrane`](crate::LaminateMembrane) as a material has it).
    fn initial_state(&self) -> PointState {
        PointState::initial(self.laminate().layers().len())
    }
}

/// Refuses a step that is not finite or starts from a state of another laminate; `strain` is dimensionless, `temperature` `[temperature]`.
///
/// # Errors
/// [`ProgressiveError::NotFinite`] for a strain or temperature rise that is not finite, [`ProgressiveError::LayerCount`] for a state
/// with another number of layers than `laminate`.
pub fn check_step(
    laminate: &Laminate,
    committed: &PointState,
    strain: [f64; 3],
    temperature: f64,
) -> Result<(), ProgressiveError> {
    if !strain
        .iter()
        .chain([&temperature])
        .all(|value| value.is_finite())
    {
        return Err(ProgressiveError::NotFinite {
            strain,
            temperature,
        });
    }
    let (layers, given) = (laminate.layers().len(), committed.layers.len());
    if layers != given {
        return Err(ProgressiveError::LayerCount { layers, given });
    }
    Ok(())
}
