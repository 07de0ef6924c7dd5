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
//!
//! Four commands go to four depths of this chain, each doing all that comes before.

mod format;
mod history;
pub mod laws;
pub mod plan;

pub use plan::Experiment;
