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
mod error;
mod model;
mod plasticity;
mod registry;
mod state;

pub use closest_point::{ClosestPoint, YieldSurface};
pub use discount::{PlyDiscount, PlyDiscountParameters};
pub use error::ProgressiveError;
pub use model::{PointModel, check_step};
pub use plasticity::{PlasticityParameters, TsaiHillPlasticity};
pub use registry::{Dimension, ParameterInfo, PointModelInfo, PointModelParameters, point_models};
pub use state::{LayerState, PointHistory, PointResponse, PointState};
