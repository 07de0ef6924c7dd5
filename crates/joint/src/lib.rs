//! Progressive failure of joints: bodies whose points have a history, in frictional contact with others.
//!
//! ```text
//! f_int(u) = f + Bᵀ λ,     f_int = t Σ_q w_q B_qᵀ σ_q,     σ_q by a point model and its history
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0,     |λ_t| ≤ F (stick),   λ_t = −F sign Δs (slip)
//! ```
//!
//! Newton's iteration linearises each such body about its present displacement. The linearised body is an ordinary
//! [`InterfaceOperator`](stickslip_fem_core::InterfaceOperator), so the contact is solved exactly in every iteration, by the same
//! solvers as between elastic bodies, and does not depend on the history. States are committed with the increment and never
//! before: a rejected increment leaves no trace.
//!
//! Where plies fail at once, as in ply discount, an increment alternates between equilibrium with the damage so far and the damage
//! that its strains make, at constant load, until no further ply fails. An increment in which too many plies fail by the load itself
//! is cut, so that plies fail in the right order.
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
//! A ply of 20 mm × 10 mm × 0.125 mm, pulled by a thousandth of its length, bears E₁ ε A:
//!
//! ```
//! use std::sync::Arc;
//! use stickslip_contact::Chain;
//! use stickslip_fem_core::generate::{Generate, Rectangle};
//! use stickslip_fem_core::mesh::ElementKind;
//! use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
//! use stickslip_joint::{Gauge, Joint, JointBody, Mark, ProgressiveBody, Pull};
//! use stickslip_laminate::degradation::Degradation;
//! use stickslip_laminate::failure::MaximumStress;
//! use stickslip_laminate::progressive::{PlyDiscount, PointModel};
//! use stickslip_laminate::{Laminate, Layup, Ply, PlyConstants, Strengths};
//!
//! # fn main() -> Result<(), Box<dyn std::error::Error>> {
//! # let constants = PlyConstants {
//! #     e1: 181_000.0, e2: 10_300.0, g12: 7_170.0, nu12: 0.28, alpha1: 0.0, alpha2: 0.0, thickness: 0.125,
//! # };
//! # let strengths = Strengths {
//! #     xt: Some(1500.0), xc: Some(1500.0), yt: Some(40.0), yc: Some(246.0), s12: Some(68.0), ..Strengths::default()
//! # };
//! let ply = Ply::new("T300/5208", constants, strengths)?;
//! let layup: Layup = "[0]".parse()?;
//! let laminate = Laminate::new(&layup, &ply)?;
//! let model: Arc<dyn PointModel> = Arc::new(PlyDiscount::new(
//!     laminate.clone(),
//!     Box::new(MaximumStress),
//!     Degradation::new(0.01, 0.1)?,
//! )?);
//! let mesh = Arc::new(Rectangle::uniform([0.0, 20.0], [0.0, 10.0], [2, 1], ElementKind::Q8)?.generate()?);
//! let nodes = |set: &str| mesh.node_set(set).unwrap_or_default().to_vec();
//! let hold = |set, direction, displacement| Support { nodes: nodes(set), direction, displacement };
//! let body = ElasticBody::new(Arc::clone(&mesh), vec![Arc::new(laminate.membrane_material()?)], laminate.thickness())?
//!     .with_supports([
//!         hold("left", HeldDirection::X, 0.0),
//!         hold("bottom", HeldDirection::Y, 0.0),
//!         hold("right", HeldDirection::X, 1.0),
//!     ])
//!     .with_load_cases(vec![LoadCase { moves_supports: true, ..LoadCase::default() }])?;
//! let body = ProgressiveBody::new(Arc::new(body), &[], &model)?;
//! let gauge = Gauge {
//!     pull: Pull::Supports { body: 0 },
//!     multiple: 1.0,
//!     direction: [1.0, 0.0],
//!     first: Mark::Node { body: 0, node: nodes("right")[0] },
//!     second: Mark::Fixed,
//!     free_travel: 0.0,
//! };
//! let joint = Joint::new(vec![JointBody::Progressive(Arc::new(body))], Vec::new(), gauge)?;
//! let history = joint.follow(&[vec![0.02]], &Chain::default(), |_, _| {})?;
//! let load = history.records[history.peak()].load;
//! assert!((load / (181_000.0 * 0.001 * 10.0 * 0.125) - 1.0).abs() < 1e-9);
//! # Ok(())
//! # }
//! ```
//!
//! A body's linearisation costs one sparse factorisation. Factors are kept by their tangents, so the elastic part of a history costs
//! one in all, as a linear body does.
//!
//! Limits. Displacements are small, contact is found on the undeformed geometry. Temperature does not change in a history: the residual
//! stresses of the cure are a state of rest ([`ProgressiveBody::at_temperature`]), so a joint that is loaded hot or cold is one history at
//! that temperature, and heating under load is not supported. Point models would take a temperature per increment, but the energies that
//! every increment is checked by are those of constant temperature, and bodies of given materials would need its strain as a load case,
//! which is refused ([`JointError::InitialStrain`]). A model may flow or fail at once; one that does both has its failures evaluated at the
//! end of a linear solve. A plate in plane stress knows no delamination and no clamping.

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

/// The crate whose vectors the contact states of a joint are made of.
pub use nalgebra;
/// The crates of bodies, contacts and laminates that joints are made of.
pub use {stickslip_contact, stickslip_fem_core, stickslip_laminate};

pub use body::{JointBody, ProgressiveBody};
pub use crack_band::{CrackBand, CrackBandError, FractureEnergies};
pub use damage::{PlyDamage, PlyEvent, PlyEventKind, damage_map};
pub use error::{Halt, JointError};
pub use gauge::{Gauge, Mark, Pull};
pub use joint::{Joint, Options};
pub use mode_call::{Basis, DamageSite, Hole, JointMode, ModeCall, ModeRule, Reserve, call_mode};
pub use record::{Ending, JointHistory, JointRecord};
pub use state::{BodyState, Energy, JointState};
