//! Experiments as files: what was measured, and what is asked of it.

mod candidate;
mod format;
pub mod history;
mod plan;
mod settings;
mod specimen;
mod state;

pub use candidate::{Candidate, RefusedLaw};
pub use plan::{Experiment, IgnoredKey, VERSION};
pub use settings::{
    FreeMotion, FreeParameter, Identify, LawPlan, MeshPlan, Method, Reduce, RegionPlan,
    RegionShape, SectorPlan, SymmetryPlan, ZonePlan,
};
pub use specimen::{Area, Fringes, Hole, Specimen, SpecimenScene};
pub use state::{Direction, LineSource, PictureSource, Source, State, TableSource};
