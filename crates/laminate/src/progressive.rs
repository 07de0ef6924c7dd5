//! Materials with history for plane elements: a laminate in plane stress, ply by ply, at one point.
//!
//! ```text
//! ε_k = T_k ε,     σ_k = Q_k (ε_k − α ΔT − ε^p_k)            every ply has the membrane strain ε; Q_k by its damage
//! σ̄ = Σ_k (h_k/h) T_kᵀ σ_k,     C̄ = ∂σ̄/∂ε                   mean stress N/h and its tangent
//! w = Σ_k (h_k/h) ½ σ_k · (ε_k − α ΔT − ε^p_k)               stored;   ∫ σ̄ · dε = Δw + dissipated  at constant temperature
//! ```
//!
//! A model takes the committed state and a total strain, and returns stress, tangent and a *trial* state. The trial becomes the
//! committed state only by [`PointHistory::commit`]: a rejected step leaves no trace. All models share one record,
//! [`PointState`], so an element can be asked to take any of them.
//!
//! | model                  | a ply                                                                     |
//! |------------------------|---------------------------------------------------------------------------|
//! | [`PlyDiscount`]        | loses stiffness at once when its failure criterion is met                 |
//! | [`TsaiHillPlasticity`] | flows when the Tsai–Hill quadratic reaches its yield stress               |

mod closest_point;
mod discount;
mod plasticity;
mod state;

pub use closest_point::{ClosestPoint, YieldSurface};
pub use discount::PlyDiscount;
pub use plasticity::TsaiHillPlasticity;
pub use state::{LayerState, PointHistory, PointResponse, PointState};

use std::fmt::Debug;

use stickslip_fem_core::material::PlaneStiffness;
use thiserror::Error;

use crate::failure::FailureError;
use crate::laminate::Laminate;

/// A model that cannot be built, or a step that it cannot take.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ProgressiveError {
    /// A strain or temperature that is not finite.
    #[error("strain {strain:?} at the temperature rise {temperature} is not finite")]
    NotFinite {
        /// The strain asked for.
        strain: [f64; 3],
        /// The temperature rise asked for.
        temperature: f64,
    },
    /// A state of another laminate.
    #[error("the state has {given} layers, the laminate {layers}")]
    LayerCount {
        /// Layers of the laminate.
        layers: usize,
        /// Layers of the state.
        given: usize,
    },
    /// Strengths for which the Tsai–Hill quadratic is no ellipse.
    #[error(
        "ply '{ply}': y = {across} is too large beside xt = {xt} and xc = {xc}: the Tsai-Hill quadratic is then no closed surface; \
         the largest y is {limit}"
    )]
    OpenYieldSurface {
        /// Name of the ply.
        ply: String,
        /// The larger of Y_t and Y_c `[stress]`.
        across: f64,
        /// X_t `[stress]`.
        xt: f64,
        /// X_c `[stress]`.
        xc: f64,
        /// Y must be less `[stress]`.
        limit: f64,
    },
    /// A hardening that softens or is not finite.
    #[error("hardening = {value} must be finite and not negative")]
    Hardening {
        /// The value given `[1/stress]`.
        value: f64,
    },
    /// The return mapping did not reach the yield surface to rounding.
    #[error(
        "layer {layer}: return mapping stopped {distance:.1e} off the yield surface after {iterations} iterations"
    )]
    ReturnMapping {
        /// Index of the layer, from the bottom, from 0.
        layer: usize,
        /// Distance, relative to the yield stress.
        distance: f64,
        /// Iterations taken.
        iterations: usize,
    },
    /// The failure criterion refused.
    #[error(transparent)]
    Failure(#[from] FailureError),
}

/// A laminate with history at one point, in plane stress and held flat: where it could bend, a lay-up that is not symmetric is softer
/// ([`Laminate::coupling`] says by how much).
pub trait PointModel: Debug + Send + Sync {
    /// The undamaged laminate.
    fn laminate(&self) -> &Laminate;

    /// Stress, tangent and trial state for the total strain `strain` (xx, yy, xy) at the temperature rise `temperature`
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

    /// Mean stiffness `[stress]` with the damage of `state`, if failed plies kept the part `part` in [0, 1] of what the model leaves
    /// them; `None` for a model whose plies do not fail. What a body bears for any `part` it bears by what is sound.
    fn weakened_stiffness(&self, state: &PointState, part: f64) -> Option<PlaneStiffness> {
        let _ = (state, part);
        None
    }

    /// The state before any load: no strain, no stress, no damage. The residual stress of a cure is that of a first step to its
    /// temperature change and the laminate's free thermal strain
    /// ([`LaminateMembrane`](crate::LaminateMembrane) as a material has it).
    fn initial_state(&self) -> PointState {
        PointState::initial(self.laminate().layers().len())
    }
}

fn check_step(
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
