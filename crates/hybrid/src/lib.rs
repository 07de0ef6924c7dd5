//! From measured displacements to edge stresses and friction.
//!
//! Moiré gratings of frequency f show displacements as fringe orders N; a region of finite elements whose edge moves as measured, and
//! whose inner forces vanish, has the stresses that cannot be measured:
//!
//! ```text
//! U = N_x / f,   V = N_y / f,   f = (2/λ) sin α,
//! Δ² = K₂₂⁻¹ (F² − K²¹ Δ¹),   F¹ = (K¹¹ − K¹² K₂₂⁻¹ K²¹) Δ¹ + K¹² K₂₂⁻¹ F².
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`data`] | measured displacements: places, values, what failed, their deviation |
//! | [`moire`] | gratings: frequency, fringe orders, displacements, strains |
//! | [`fringe`] | fringe pictures: synthesis, phase, unwrapping, carrier |
//! | [`reduce`] | displacements of nodes from measured ones, with covariance |
//! | [`region`] | localized hybrid analysis of a region, with the covariance of all that follows |
//! | [`calibrate`] | parameters of any model by weighted least squares, with profiles, and the comparison of models |
//! | [`identify`] | friction coefficients from edge tractions, with intervals or the word that there is none |

pub mod calibrate;
pub mod data;
pub mod fringe;
pub mod identify;
pub mod moire;
mod random;
pub mod reduce;
pub mod region;
