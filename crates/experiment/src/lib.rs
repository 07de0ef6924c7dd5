//! Experiments as text files with units: what was measured, and what is asked of it, read and checked.
//!
//! An [`Experiment`] names its specimen (a body of a scene, or material, thickness and hole alone), one [`State`] per load with its fringe pictures,
//! fringe lines or table of displacements, and how friction is to be found. One that exists is checked: files and laws are named, ranges hold, keys without
//! effect are listed. Every quantity arrives in base units (mm, N, MPa, rad). The data themselves are read by what analyses them.
//!
//! | module | subject |
//! | --- | --- |
//! | [`history`] | the states as steps of the load history of their scene |
//! | [`templates`] | a commented experiment to start from |

mod candidate;
mod format;
pub mod history;
mod plan;
mod settings;
mod specimen;
mod state;
pub mod templates;

/// The crate whose values describe an experiment.
pub use stickslip_scene::serde_json;
/// The crates of laws, measured data and scenes that experiments hold.
pub use {stickslip_fem_core, stickslip_friction, stickslip_hybrid, stickslip_scene};

pub use candidate::{Candidate, RefusedLaw};
pub use plan::{Experiment, IgnoredKey, VERSION};
pub use settings::{
    FreeMotion, FreeParameter, Identify, LawPlan, MeshPlan, Method, Reduce, RegionPlan,
    RegionShape, SectorPlan, SymmetryPlan, ZonePlan,
};
pub use specimen::{Area, Fringes, Hole, Specimen, SpecimenScene};
pub use state::{Direction, LineSource, PictureSource, Source, State, TableSource};
