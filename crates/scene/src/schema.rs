//! The tables of a scene, a file each: as plain numbers, and as a file spells them (`…Format`) with the rows that declare their keys.
//!
//! Of a spelling the names of fields are the keys. Unknown keys are refused, every quantity carries its unit, and choices are externally tagged
//! (`shape.disk = { … }`). Keys that are right or wrong by themselves become numbers here; `build` checks what needs other tables.
//!
//! Of what is checked: base units throughout: mm, N, MPa, rad, K. Angles are counter-clockwise from +x, the load axis; names of bodies, materials and
//! sets refer to things that exist.

pub(crate) mod analysis;
mod bearing;
pub(crate) mod body;
pub(crate) mod contact;
mod demand;
pub(crate) mod failure;
pub(crate) mod fastener;
pub(crate) mod loads;
mod lumped;
pub(crate) mod mesh;
pub(crate) mod output;
pub(crate) mod progressive;
mod set_ref;
pub(crate) mod supports;

pub use super::material::{LaminateSheet, Material, OutOfPlane};
pub use crate::shape::Shape;
use crate::units::Unit;
pub use analysis::{Analysis, ComplianceChoice, KinematicsChoice, ModelChoice, Ramp, SolverChoice};
pub use bearing::BearingLaw;
pub(crate) use body::BodyFormat;
pub use body::{Body, BodyModel, Substance};
pub(crate) use contact::ContactFormat;
pub use contact::{Contact, GapKind, ProjectionChoice};
pub use demand::{Accuracy, Bounds, Budget, Memory, RelativeError};
pub(crate) use failure::FailureFormat;
pub use failure::{Characteristic, EnvelopePlane, Envelopes, Failure};
pub(crate) use fastener::FastenerFormat;
pub use fastener::{Fastener, Springs};
pub(crate) use loads::LoadFormat;
pub use loads::{Load, LoadKind, PolarTable};
pub use lumped::{Formula, HuthJoint, Lap, LapPlate};
pub(crate) use mesh::MeshFormat;
pub use mesh::{Division, Grading, MeshSettings};
pub use output::{FieldOutput, Output};
pub use progressive::{Control, Progressive, ProgressiveModel};
pub use set_ref::SetRef;
pub use supports::{Axes, Axis, Hold, Platen, SpringSize, SpringSupport, Support};
pub(crate) use supports::{PlatenFormat, SupportFormat};

/// Units that results are shown in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct DisplayUnits {
    /// Of lengths; `length.from_base(mm)` converts.
    pub length: &'static Unit,
    /// Of forces; `force.from_base(N)` converts.
    pub force: &'static Unit,
    /// Of stresses; `stress.from_base(MPa)` converts.
    pub stress: &'static Unit,
}
