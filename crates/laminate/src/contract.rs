//! What every failure criterion and every point model must fulfil, as checks that a new one calls in its tests.
//!
//! | check                    | of                                                                      |
//! |--------------------------|-------------------------------------------------------------------------|
//! | [`check_criterion`]      | a [`FailureCriterion`](crate::FailureCriterion)                         |
//! | [`check_point_model`]    | a [`PointModel`](crate::PointModel)                                     |
//! | [`check_parameters`]     | the [`PointModelParameters`](crate::progressive::PointModelParameters) of a model that files can name |
//!
//! A criterion:
//!
//! ```text
//! index(0) < 1,  reserve factor(0) = ∞                       a ply without stress does not fail
//! |index| < ∞,  reserve factor ≥ 0                           everywhere in the sample
//! index(σ_held + s σ) < 1 for s < r,  ≥ 1 just beyond r      r the reserve factor: the first failure, and none before
//! r(k σ) = r(σ)/k                                            without residual stress
//! (index, r, mode)(σ₁, σ₂, −τ₁₂) = (index, r, mode)(σ₁, σ₂, τ₁₂)
//! assess(σ) = assess(σ)                                      always, whatever was asked before
//! a ply without a required strength, a stress that is not finite: the error that says so
//! ```
//!
//! A point model:
//!
//! ```text
//! respond(s₀, 0, 0) = (0, C, s₀)                  no stress without strain
//! respond(s, ε(s), ΔT(s)) = (σ(s), ·, s)          a step without change changes nothing
//! respond(s, ε, ΔT) = respond(s, ε, ΔT)           always, whatever was tried before: a trial leaves no trace
//! C = Cᵀ,   C = ∂σ/∂ε                             agrees with central differences where the response is smooth
//! dissipated(trial) ≥ dissipated(s),  stored ≥ 0  and damage never heals
//! ```
//!
//! The tangent is compared with central differences of the stress, in steps of 5·10⁻⁶ of the strain scale and to 10⁻⁴ of the stiffness, where
//! the response is smooth: where the two one-sided differences agree that well.
//!
//! Each runs over a sample that is the same each time, and ends with the first property that is broken, with the numbers:
//!
//! ```
//! use stickslip_laminate::contract::{CriterionSample, PointSample, check_criterion, check_point_model};
//! use stickslip_laminate::failure::TsaiHill;
//! use stickslip_laminate::progressive::TsaiHillPlasticity;
//! use stickslip_laminate::{Laminate, Ply, PlyConstants, Strengths};
//!
//! let constants = PlyConstants {
//!     e1: 140e3, e2: 9e3, g12: 5e3, nu12: 0.3, alpha1: 0.0, alpha2: 3e-5, thickness: 0.125, // N, mm, K
//! };
//! let ply = Ply::new("carbon", constants, Strengths::in_plane(1500.0, 1200.0, 50.0, 200.0, 70.0))?;
//! check_criterion(&TsaiHill, &CriterionSample::default_for(ply.clone(), [1500.0, 50.0, 70.0]))?;
//!
//! let model = TsaiHillPlasticity::with_shear_modulus(Laminate::new(&"[0/90]s".parse()?, &ply)?, 500.0)?;
//! check_point_model(&model, &PointSample::default_for(0.02, -150.0))?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod criterion;
mod point_model;

pub use criterion::{CriterionBreach, CriterionSample, CriterionViolation, check_criterion};
pub use point_model::{
    ParametersBreach, PointBreach, PointSample, PointViolation, check_parameters, check_point_model,
};
