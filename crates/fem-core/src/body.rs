//! Linear elastic bodies and their condensation.
//!
//! ```text
//! K u = f + Bᵀ λ   ⇒   u_c = C λ + u₀ + R α
//! ```
//!
//! [`ElasticBody`] is what is solved: mesh, materials, thickness, supports, unit loads. [`CondensedBody`] sees it from its contact
//! nodes, with C the compliance there, u₀ the answer to the loads and R the rigid motions that supports leave free;
//! [`TangentBody`] does so for one linearisation of a body whose points have a history. [`PartitionedBody`] prescribes displacements instead.

mod assembly;
mod condensed;
mod constraints;
mod elastic;
mod equations;
mod error;
mod free_motions;
mod partitioned;
mod parts;
mod regions;
mod springs;
mod tangent;
mod whole;

pub use assembly::internal_forces;
pub use condensed::{BodyBalance, BodyLoad, CondensedBody};
pub use elastic::{ElasticBody, LoadCase};
pub use equations::BodyStructure;
pub use error::BodyError;
pub use partitioned::{PartitionedBody, PartitionedStates, SparseRow};
pub use tangent::{Linearised, TangentBody};
pub use whole::InterfaceUnknown;
