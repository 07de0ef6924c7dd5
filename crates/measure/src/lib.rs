//! From fringe pictures and measured displacements to friction: findings as plain data.
//!
//! ```text
//! experiment file ──► Experiment ──► fringes ──► reduce ──► hybrid ──► identify
//!                                    pictures    measured   edge       friction
//!                                                fields     stresses
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`chain`] | the stages one after the other, and their findings |
//! | [`measured`] | displacements with their standard deviation and mask |
//! | [`laws`] | friction laws fitted by contact solves, and compared |
//! | [`whole`] | the whole plate under its remote load, its hole displaced as measured |
//! | [`analysed`] | edge stresses by localized hybrid analysis, with bands and checks |
//! | [`identified`] | slip zones, and the friction coefficients that they share |
//! | [`finding`] | warnings and remarks on all these, as data |
//! | [`truth`], [`synthesis`] | the solution of a scene, and synthetic pictures of it |
//!
//! Four commands stop at four depths of this chain; each runs all stages before it.

pub mod analysed;
pub mod chain;
mod ends;
mod error;
pub mod finding;
pub mod identified;
pub mod laws;
pub mod measured;
mod region_mesh;
pub mod synthesis;
pub mod truth;
pub mod whole;

/// The crate whose vectors and matrices findings hold.
pub use nalgebra;
/// The crates of experiments, runs, meshes, laws, contacts and measured data that findings hold.
pub use {
    stickslip_contact, stickslip_engine, stickslip_experiment, stickslip_fem_core,
    stickslip_friction, stickslip_hybrid, stickslip_scene,
};

pub use error::ExperimentError;
pub use finding::Finding;
