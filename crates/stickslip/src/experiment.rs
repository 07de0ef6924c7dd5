//! Experiments: from fringe pictures and measured displacements to friction.
//!
//! ```text
//! experiment file ──► Experiment ──► fringes ──► reduce ──► hybrid ──► identify
//!                     plan           pictures    measured   edge       friction
//!                                                fields     stresses
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`plan`] | what the file says, checked, in base units |
//! | [`check`] | an experiment read with its data, in a few lines |
//! | [`chain`], [`story`] | the stages one after the other, and the page that tells of them |
//! | [`measured`] | displacements with their deviation and mask |
//! | [`laws`] | friction laws fitted by contact solves, and compared |
//! | [`whole`] | the whole plate under its remote load, its hole displaced as measured |
//! | [`analysed`] | edge stresses by localized hybrid analysis, with bands and checks |
//! | [`identified`] | slip zones, and the friction coefficients that they share |
//! | [`truth`], [`synthesis`] | the solution of a scene, and synthetic pictures of it |
//!
//! Four commands go to four depths of this chain, each doing all that comes before.

pub mod analysed;
pub mod chain;
pub mod check;
mod error;
mod format;
mod gallery;
mod history;
pub mod identified;
pub mod laws;
pub mod measured;
pub mod plan;
pub mod story;
pub mod synthesis;
pub mod truth;
pub mod whole;

pub use error::ExperimentError;
pub use plan::Experiment;
