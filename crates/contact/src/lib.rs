//! Frictional contact of condensed bodies over load histories.
//!
//! Elasticity is linear and expensive, contact nonlinear and cheap; they meet on the contact points. Bodies arrive as
//! [`InterfaceOperator`](stickslip_fem_core::InterfaceOperator)s, are assembled into an [`Interface`], which has one dense [`InterfaceProblem`] for all
//! bodies that contact links. A [`LoadHistory`] takes these problems through its load steps with an [`InterfaceSolver`].
//!
//! ```text
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0;     |λ_t| ≤ F (stick),   λ_t = −F sign Δs (slip)
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`gap`] | initial gaps from the true geometry |
//! | [`mortar`] | contact points between edges whose nodes do not match |
//! | [`deformed`] | contact points on the deformed geometry |
//! | [`problem`] | pairs, points, and the operators of bodies in one problem |
//! | [`interface`] | all contacts, in independent parts |
//! | [`state`] | what is known at the end of a step |
//! | [`solver`] | the family of one-step solvers and their fallback chain |
//! | [`contract`] | what every solver must fulfil, as a check |
//! | [`history`] | load steps, sub-steps, cut-back, dissipation |
//! | [`thinned`] | load steps on some of the contact nodes |
//! | [`uniqueness`] | an estimate of the friction coefficient up to which a step has one solution |
//! | [`zones`] | where contact is open, sticks and slips, with interpolated ends |
//! | [`peaks`] | peaks of stress and pressure along an edge, with estimated errors |
//! | [`audit`] | equilibrium of every step |
//! | [`freedom`] | rigid motions that no contact resists |
//!
//! One point of an elastic body, pressed on a rigid ground with 2 and pushed along it with 1, sticks at μ = 0.6:
//!
//! ```
//! use std::sync::Arc;
//! use stickslip_contact::nalgebra::{DMatrix, DVector};
//! use stickslip_contact::{Chain, ContactPair, ContactPoint, InterfaceProblem, LoadHistory, Ramp, Status};
//! use stickslip_fem_core::{GivenBody, RigidBody};
//! use stickslip_friction::Coulomb;
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! // Compliances of 1; the load alone would move the point by 2 into the ground and by 1 along it.
//! let body = GivenBody::held(DMatrix::identity(2, 2), vec![DVector::from_vec(vec![1.0, -2.0])])?;
//! let ground = RigidBody::held(vec![[0.0, 0.0]], 1);
//! let point = ContactPoint {
//!     first: 0.into(),
//!     second: 0.into(),
//!     normal: [0.0, 1.0],
//!     gap: 0.0,
//!     area: 1.0,
//!     material_angle: 0.0,
//! };
//! let pair = ContactPair {
//!     origin: [0.0; 2],
//!     name: "ground".into(),
//!     first: 0,
//!     second: 1,
//!     points: vec![point],
//!     law: Arc::new(Coulomb::new(0.6)?),
//! };
//! let problem = InterfaceProblem::new(&[&body, &ground], vec![pair])?;
//! let history = LoadHistory::new(vec![vec![1.0]], 1, Ramp::Linear)?;
//! let records = history.follow(&problem, &Chain::default(), |_| {})?;
//! let end = &records[0].state;
//! assert_eq!(end.status, [Status::Stick]);
//! assert!((end.normal_force(0) - 2.0).abs() < 1e-12);
//! // Its tangent e_t points along −x.
//! assert!((end.tangential_force(0) - 1.0).abs() < 1e-12);
//! # Ok(())
//! # }
//! ```
//!
//! Signs: normals e_n point from the second body into the first, e_t is e_n turned by +90°. Forces λ act on the first
//! body; λ_n ≥ 0 presses; Δs is the motion of the first body against the second along e_t.

pub mod audit;
pub mod contract;
pub mod deformed;
mod error;
mod failure;
pub mod freedom;
pub mod gap;
pub mod history;
pub mod interface;
pub mod mortar;
pub mod peaks;
pub mod problem;
pub mod solver;
pub mod state;
pub mod thinned;
pub mod uniqueness;
pub mod zones;

/// The crate whose vectors and matrices states and problems are made of.
pub use nalgebra;
/// The crates of bodies and friction laws that contacts are between.
pub use {stickslip_fem_core, stickslip_friction};

pub use deformed::{DeformedGaps, Facing, Kinematics};
pub use error::ContactError;
pub use history::{Increment, LoadHistory, Ramp, StepRecord};
pub use interface::Interface;
pub use mortar::{EdgeSide, InitialGap, MortarError, Multipliers, Projected, Projection};
pub use problem::{
    Compliance, ContactPair, ContactPoint, Contacts, InterfaceProblem, Link, Stencil, StencilTerm,
};
pub use solver::{
    AugmentedLagrangian, Chain, Continuation, Enumeration, GaussSeidel, InterfaceSolver, Penalty,
    Pivoting, PrincipalPivoting, SemismoothNewton, SolverKind, StatusIteration, TrescaFixedPoint,
};
pub use state::{ContactState, Status};
pub use uniqueness::uniqueness_bound;
