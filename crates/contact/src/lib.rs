//! Frictional contact of condensed bodies over load histories.
//!
//! Elasticity is linear and expensive, contact nonlinear and cheap; they meet on the contact points. Bodies arrive as
//! [`InterfaceOperator`](stickslip_fem_core::InterfaceOperator)s, are assembled into an [`Interface`], which has one dense [`InterfaceProblem`] for all
//! bodies that contact links, and a [`LoadHistory`] walks these problems through its load steps with an [`InterfaceSolver`].
//!
//! ```text
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0;     |λ_t| ≤ F (stick),   λ_t = −F sign Δs (slip)
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`gap`] | initial gaps from the true geometry |
//! | [`mortar`] | contact points between edges whose nodes do not match |
//! | [`problem`] | pairs, points, and the operators of bodies in one problem |
//! | [`interface`] | all contacts, in parts that know nothing of each other |
//! | [`state`] | what is known at the end of a step |
//! | [`solver`] | the family of one-step solvers and their fallback chain |
//! | [`history`] | load steps, sub-steps, cut-back, dissipation |
//! | [`uniqueness`] | an estimate of the friction coefficient up to which a step has one solution |
//! | [`zones`] | where contact is open, sticks and slips, with interpolated ends |
//! | [`audit`] | equilibrium of every step |
//! | [`freedom`] | rigid motions that no contact resists |
//!
//! Signs: normals e_n point from the second body into the first, e_t is e_n turned by +90°. Forces λ act on the first
//! body; λ_n ≥ 0 presses; Δs is the motion of the first body against the second along e_t.

pub mod audit;
mod error;
pub mod freedom;
pub mod gap;
pub mod history;
pub mod interface;
pub mod mortar;
pub mod problem;
pub mod solver;
pub mod state;
pub mod uniqueness;
pub mod zones;

pub use error::ContactError;
pub use history::{Increment, LoadHistory, Ramp, StepRecord};
pub use interface::Interface;
pub use mortar::{EdgeSide, InitialGap, MortarError, Multipliers, Projected, Projection};
pub use problem::{ContactPair, ContactPoint, Contacts, InterfaceProblem, Stencil, StencilTerm};
pub use solver::{
    AugmentedLagrangian, Chain, Continuation, Enumeration, GaussSeidel, InterfaceSolver, Penalty,
    Pivoting, PrincipalPivoting, SemismoothNewton, StatusIteration, TrescaFixedPoint,
};
pub use state::{ContactState, Status};
pub use uniqueness::uniqueness_bound;
