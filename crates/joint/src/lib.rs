//! Progressive failure of joints: bodies whose points have a history, in frictional contact with others.
//!
//! ```text
//! f_int(u) = f + Bᵀ λ,     f_int = t Σ_q w_q B_qᵀ σ_q,     σ_q by a point model and its history
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0,     |λ_t| ≤ F (stick),   λ_t = −F sign Δs (slip)
//! ```
//!
//! Newton's iteration linearises each such body about its present displacement. The linearised body is an ordinary
//! [`InterfaceOperator`](stickslip_fem_core::InterfaceOperator), so the contact is solved exactly in every iteration, by the same
//! solvers as between elastic bodies, and sees nothing of the history. States are committed with the increment and never before:
//! what is rejected leaves no trace.
//!
//! Where plies fail at once, as in ply discount, an increment alternates between equilibrium with the damage so far and the damage
//! that its strains make, at constant load, until no further ply fails. An increment in which too many plies fail by the load itself
//! is cut, so that those fail first that are to.
//!
//! Under given loads a history ends where the smallest increment finds no equilibrium, or none near: the load reached is the joint's
//! *strength*, a result. Supports that are driven ([`LoadCase::moves_supports`](stickslip_fem_core::LoadCase)) carry the curve past the
//! peak.
//!
//! | item | subject |
//! | --- | --- |
//! | [`ProgressiveBody`], [`JointBody`] | finite elements with a point model at every quadrature point; the bodies of a joint |
//! | [`Joint`], [`Gauge`], [`Options`] | bodies and pairs, where load and displacement are read, how a history is followed |
//! | [`Joint::follow`], [`JointHistory`], [`JointRecord`], [`JointState`] | the curve, the energies, the damage, the state |
//! | [`PlyEvent`], [`damage_map`] | which ply failed where, when and in which mode |
//! | [`call_mode`], [`ModeCall`], [`Hole`] | bearing, shear-out, net tension or mixed, and why |
//! | [`CrackBand`] | strengths by which ply discount dissipates the fracture energy on any mesh |
//!
//! A body's linearisation costs one sparse factorisation. Factors are kept by their tangents, so the elastic part of a history costs
//! one in all, as a linear body does.
//!
//! Limits. Displacements are small, contact is found on the undeformed geometry. Temperature does not change in a history: the
//! residual stresses of the cure are a state of rest ([`ProgressiveBody::at_temperature`]), so a joint that is loaded hot or cold is one
//! history at that temperature, and heating under load is none. Point models would take a temperature per increment, but the energies that
//! every increment is checked by are those of constant temperature, and bodies of given materials would need its strain as a load case,
//! which is refused ([`JointError::InitialStrain`]). A model may flow or fail at once; one that
//! does both has its failures taken at the end of a linear solve. A plate in plane stress knows no delamination and no clamping.

mod body;
mod crack_band;
mod damage;
mod energy;
mod error;
mod follow;
mod gauge;
mod increment;
mod joint;
mod mode_call;
mod operator;
mod record;
mod state;

pub use body::{JointBody, ProgressiveBody};
pub use crack_band::{CrackBand, CrackBandError, FractureEnergies};
pub use damage::{PlyDamage, PlyEvent, PlyEventKind, damage_map};
pub use error::{Halt, JointError};
pub use gauge::{Gauge, Mark, Pull};
pub use joint::{Joint, Options};
pub use mode_call::{DamageSite, Hole, JointMode, ModeCall, call_mode};
pub use record::{Ending, JointHistory, JointRecord};
pub use state::{BodyState, Energy, JointState};
