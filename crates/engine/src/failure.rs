//! From the stresses of a laminated body to its plies, and to the load at which the first of them fails.
//!
//! ```text
//! ε = S σ̄ + ᾱ ΔT,   σ_k = Q_k (T_k ε − α ΔT) + Q_k (T_k ᾱ − α) ΔT_cure
//!
//! reserve factor of a step     smallest r ≥ 0 at which  σ_cure + r σ(step)  fails: all loads together, the cure held
//! first-ply failure            smallest s in [0, 1] at which  σ_cure + σ(k − 1) + s (σ(k) − σ(k − 1))  fails, in the first step k that has
//!                              one; where no step has, the load of the weakest step times its reserve factor
//! ```
//!
//! σ̄ is the mean stress over the thickness, ε the membrane strain, S the compliance and ᾱ the expansion of the laminate as a sheet; Q,
//! T and α are those of a ply. Contact is not linear in the load, so a reserve factor of a step is an extrapolation at fixed contact;
//! between two steps stresses are taken to change in proportion, which small steps make exact.
//!
//! A half model stands for both halves: at the mirror image of a place the shear stress has the other sign, and every ply is evaluated at
//! both. Where every ply has a counterpart of the opposite angle one half is enough, because no criterion depends on the sign of τ₁₂.

mod characteristic;
mod plies;
mod sampling;
mod tracker;

pub(crate) use characteristic::{Region, curve, joint_mode};
pub(crate) use plies::{PlyStresses, Sites};
pub(crate) use sampling::{Sample, locate};
pub(crate) use tracker::Tracker;
