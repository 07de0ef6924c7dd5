//! Laminated plates: from lay-up to stiffness, ply stresses and failure.
//!
//! ```text
//! (N, M) = [A B; B D] (ε⁰, κ),   A = Σ_k Q̄_k h_k,   σ_k = Q (T_k (ε⁰ + z κ) − α ΔT),   fails where index(σ_k) ≥ 1
//! ```
//!
//! A symmetric lay-up acts in its plane as the homogeneous plate with stiffness A/h, which is a
//! [`Material`] of `stickslip-fem-core`; its ply fractions are what the fibre-coverage
//! law of [`stickslip_friction`] asks for.
//!
//! # From lay-up to first-ply failure
//!
//! A quasi-isotropic plate of carbon and epoxy (the ply of the strength study in Post & Reddy 1988, part II, 4.4, in ksi and in)
//! is pulled with N_x/h = 1 ksi, once as it is and once with the residual stress of the cure:
//!
//! ```
//! use stickslip_laminate::failure::{MaximumStress, first_ply_failure, last_ply_failure};
//! use stickslip_laminate::{
//!     Curvature, Degradation, FailureMode, Laminate, LaminateLoad, Layup, Ply, PlyConstants, Strengths,
//! };
//!
//! let constants = PlyConstants {
//!     e1: 19_100.0, e2: 2_000.0, g12: 900.0, nu12: 0.3, alpha1: 0.2e-6, alpha2: 15.0e-6, thickness: 0.005,
//! };
//! let ply = Ply::new("carbon", constants, Strengths::in_plane(229.4, 252.1, 10.1, 32.0, 17.3))?;
//! let layup: Layup = "[0/±45/90]s".parse()?;
//! let laminate = Laminate::new(&layup, &ply)?;
//!
//! // Stiffness: a homogeneous plate, because the lay-up is symmetric. Plane elements take it as it is.
//! let moduli = laminate.membrane_moduli(Curvature::Suppressed);
//! assert!((moduli.ex - 7_761.0).abs() < 1.0 && (moduli.ex - moduli.ey).abs() < 1e-9);
//! let material = laminate.membrane_material()?;
//! assert!(material.coupling().is_symmetric());
//!
//! // First-ply failure: the 90° plies crack, and sooner when the laminate has cooled by 250 °F since its cure.
//! let pulled = LaminateLoad::membrane([laminate.thickness(), 0.0, 0.0]);
//! let cooled = LaminateLoad { temperature: -250.0, ..pulled };
//! let [first, residual] = [pulled, cooled].map(|load| first_ply_failure(&laminate, &load, &MaximumStress));
//! let (first, residual) = (first?, residual?);
//! assert_eq!((first.angle, first.assessment.mode), (90.0, FailureMode::MatrixTension));
//! assert!((first.assessment.reserve_factor - 42.81).abs() < 0.01);
//! assert!((residual.assessment.reserve_factor - 15.95).abs() < 0.01);
//!
//! // Ply discount goes on until the fibres of the 0° plies break.
//! let history = last_ply_failure(&laminate, &pulled, &MaximumStress, &Degradation::new(0.01, 0.1)?)?;
//! assert!((history.last_factor() - 80.74).abs() < 0.01);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Conventions
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
//! | [`contract`]    | what every criterion and every point model must fulfil, as checks for the tests of a new one |
//! | [`degradation`] | ply discount: what a failed ply still carries                                               |
//! | [`progressive`] | the trait [`PointModel`]: materials with history, by ply discount or plasticity             |
//!
//! Criteria and point models are found by the name that a file gives them, those of other crates included:
//! [`failure::criteria`], [`progressive::point_models`].

/// The README's example.
#[cfg(doctest)]
#[doc = include_str!("../README.md")]
struct Readme;

pub mod contract;
pub mod degradation;
pub mod failure;
mod failure_mode;
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
pub use stickslip_fem_core::material::{Material, MaterialError, PlaneStiffness};
pub use stickslip_friction::{FibreCoverage, FrictionError, FrictionLaw, Kernel, PlyFraction};
pub use strengths::{Strength, Strengths};

/// The crate behind the registries, by which criteria and point models elsewhere register. The `#[typetag::serde]` of a point model needs dependencies on `typetag` and `serde`.
pub use inventory;
