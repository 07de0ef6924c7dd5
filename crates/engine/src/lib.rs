//! From a checked scene to its solved load history.
//!
//! ```text
//! Scene ──► model ──► run ──► results
//!           bodies,   steps   numbers in base units
//!           pairs
//! ```
//!
//! | module | subject |
//! | --- | --- |
//! | [`model`] | meshes, bodies, contact pairs, load history, with the choices made |
//! | [`run`](mod@run) | condense the bodies, follow the history, recover what is reported |
//! | [`results`] | what a run yields |
//! | [`series`] | bodies without a mesh, and what is reported of them |

pub mod failure;
pub mod model;
pub mod run;
pub mod series;

/// The crates of scenes, bodies, laws, contacts, series, laminates and joints that models and results hold.
pub use {
    stickslip_contact, stickslip_fem_core, stickslip_friction, stickslip_joint, stickslip_laminate,
    stickslip_scene, stickslip_series,
};

pub use stickslip_results as results;

pub use results::{ContactFinding, Finding, JointFinding};
