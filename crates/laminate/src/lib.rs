//! Laminated plates: from lay-up to stiffness, ply stresses and failure.
//!
//! ```text
//! (N, M) = [A B; B D] (ε⁰, κ),   A = Σ_k Q̄_k h_k,   σ_k = Q (T_k (ε⁰ + z κ) − α ΔT),   fails where index(σ_k) ≥ 1
//! ```
//!
//! A symmetric lay-up acts in its plane as the homogeneous plate with stiffness A/h, which is a
//! [`Material`](stickslip_fem_core::material::Material) of `stickslip-fem-core`; its ply fractions are what the fibre-coverage
//! law of [`stickslip_friction`] asks for.
//!
//! The crate is unit-free: any consistent set of units works. Vectors are (xx, yy, xy) or (11, 22, 12) with engineering shear
//! strain; angles of fibres are in degrees, counter-clockwise from x, as lay-ups are written.
//!
//! # Contents
//!
//! | module          | holds                                                                                       |
//! |-----------------|---------------------------------------------------------------------------------------------|
//! | [`ply`]         | [`Ply`]: constants, thickness, strengths, checked                                           |
//! | [`strengths`]   | [`Strengths`]: positive magnitudes, each optional                                           |
//! | [`layup`]       | [`Layup`]: the notation `[0/±45/90]s`                                                       |
//! | [`laminate`]    | [`Laminate`]: A, B, D, moduli, coupling, ply stresses, residual stresses, membrane material |
//! | [`failure`]     | the trait [`FailureCriterion`] and the criteria; first and last ply failure, envelopes      |
//! | [`degradation`] | ply discount: what a failed ply still carries                                               |
//! | [`progressive`] | the trait [`PointModel`]: materials with history, by ply discount or plasticity             |

pub mod degradation;
pub mod failure;
pub mod laminate;
pub mod layup;
pub mod ply;
pub mod progressive;
pub mod strengths;

pub use degradation::{Damage, Degradation};
pub use failure::{Assessment, FailureCriterion, FailureError, FailureMode, PlyLoading};
pub use laminate::{
    Curvature, Deformation, Laminate, LaminateError, LaminateLoad, LaminateMembrane,
};
pub use layup::{Layup, LayupError};
pub use ply::{Ply, PlyConstants, PlyError};
pub use progressive::{PointHistory, PointModel, PointState};
pub use strengths::{Strength, Strengths};
