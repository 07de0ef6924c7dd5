//! The `stickslip` command: plane frictional contact from a scene file to tractions, pictures and a report.
//!
//! ```text
//! scene file ──► scene ───────► engine, ladder ──► present ──► files
//!                checked        model, run,        tables,
//!                               results            figures, pages
//! experiment ──► experiment ──► measure ─────────► present ──► files
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`cli`] | the command |
//! | [`keep`], [`folder`] | results and findings in folders that appear whole or not at all |
//! | [`host`] | files and the clock of the machine |
//! | [`sweep`] | many joints: the axes of a sweep, its engine, its table and pictures |
//! | [`scene`], [`units`], [`diagnostic`], [`limits`] | scene files, quantities with units, errors that point at a line (`stickslip-scene`) |
//! | [`model`], [`run`](mod@run), [`results`] | the solution and what is reported of it (`stickslip-engine`), to an accuracy (`stickslip-ladder`) |
//! | [`experiment`] | measured displacements (`stickslip-experiment`): fringe pictures, their reduction, hybrid analysis, friction (`stickslip-measure`) |
//! | [`output`] | results as files, figures, a page and a table (`stickslip-present`) |
//!
//! A program with friction laws of its own links them and calls [`cli::main`].

pub mod cli;
pub mod folder;
pub mod host;
pub mod keep;
pub mod sweep;

pub use stickslip_engine::{model, results};
pub use stickslip_present::results as output;
pub use stickslip_scene::{self as scene, diagnostic, limits, units};

/// Runs: of one model, and of finer and finer ones to an accuracy.
pub mod run {
    pub use stickslip_engine::run::*;
    pub use stickslip_ladder::run;
}

/// Experiments: from fringe pictures and measured displacements to friction.
pub mod experiment {
    pub use stickslip_experiment::*;
    pub use stickslip_experiment_pages::{check, report};
    pub use stickslip_measure::*;
}
