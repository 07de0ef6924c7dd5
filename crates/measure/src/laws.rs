//! Friction laws fitted to measured displacements by contact solves.
//!
//! ```text
//! χ²(θ) = min over b of |L⁻¹ (m − u(θ) − Z b)|²,     u(θ): displacements of the scene's history under the law with parameters θ
//! ```
//!
//! m are the displacements of all states, Σ = L Lᵀ their covariance, Z b the unknown rigid motion of the grating in each state. Bodies are
//! condensed once, so that one χ² costs one history of small contact problems ([`ContactModel`]). The information criteria of the fits rank
//! the laws, and the profiles of χ² show which parameters the data determine ([`stickslip_hybrid::calibrate`]).
//!
//! | module | subject |
//! | --- | --- |
//! | [`ContactModel`], [`View`] | condensed scene, and displacements seen of it |
//! | [`Candidate`] | a law with free parameters, of any registered kind |
//! | [`Observation`] | the displacements of a state, with their covariance and nuisances |
//! | [`fit`], [`Comparison`] | fits of several laws to the same data, compared |
//! | [`stage`] | all of this for an experiment |
//! | [`Sensitivity`] | how far the edge moves when a parameter does, in fringes |
//! | [`Scale`] | the factor on the variance of a state, and its source |
//! | [`SharedNull`] | states whose errors are not independent of each other |
//! | [`MeshError`], [`fit_on_two_meshes`] | intervals that hold the error of the model's mesh |
//! | [`coefficient`] | the coefficient along the slip path |
//! | [`Discrepancy`] | the error due to the mesh of the model, where the truth is known |

mod compare;
mod comparison;
mod contact;
mod discrepancy;
mod known;
mod mesh_error;
mod observation;
mod resolved;
mod rings;
mod scale;
mod sensitivity;
mod shared_null;
mod stage;
mod transition;
mod verdict;

pub use crate::error::LawsError;
pub use compare::{fit, fit_on_two_meshes};
pub use comparison::{Comparison, Fit, StateFit};
pub use contact::{ContactModel, View};
pub use discrepancy::{Discrepancy, discrepancies};
pub use known::Known;
pub use mesh_error::{MeshError, StateMeshError, coarser};
pub use observation::{Nuisance, Observation, decimated};
pub use rings::Ring;
pub use scale::{Scale, ScaleSource};
pub use sensitivity::{Sensitivity, sensitivity};
pub use shared_null::SharedNull;
pub use stage::{LawStage, stage};
pub use stickslip_experiment::Candidate;
pub use transition::{coefficient, half_width, law_of, passes};
pub use verdict::Verdict;
