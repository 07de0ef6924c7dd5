//! A checked scene in plain numbers.
//!
//! Base units throughout: mm, N, MPa, rad, K. Angles are counter-clockwise from +x, the load axis; names of bodies, materials and
//! sets refer to things that exist.

mod analysis;
mod bearing;
mod contact;
mod demand;
mod failure;
mod fastener;
mod loads;
mod lumped;
mod mesh;
mod output;
mod progressive;
mod set_ref;
mod supports;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::Point;

pub use super::material::{LaminateSheet, Material, OutOfPlane};
pub use crate::shape::Shape;
use crate::units::Unit;
pub use analysis::{Analysis, ComplianceChoice, KinematicsChoice, ModelChoice, Ramp, SolverChoice};
pub use bearing::BearingLaw;
pub use contact::{Contact, GapKind, ProjectionChoice};
pub use demand::{Accuracy, Bounds, Budget, Memory, RelativeError};
pub use failure::{Characteristic, EnvelopePlane, Envelopes, Failure};
pub use fastener::{Fastener, Springs};
pub use loads::{Load, LoadKind, PolarTable};
pub use lumped::{Formula, HuthJoint, Lap, LapPlate};
pub use mesh::{Division, Grading, MeshSettings};
pub use output::{FieldOutput, Output};
pub use progressive::{Control, Progressive, ProgressiveModel};
pub use set_ref::SetRef;
pub use supports::{Axes, Axis, Hold, Platen, SpringSize, SpringSupport, Support};

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

/// A body.
#[derive(Debug, Clone, PartialEq)]
pub struct Body {
    /// What it is made of.
    pub substance: Substance,
    /// Its outline.
    pub shape: Shape,
    /// Where the origin of its coordinates stands, unless a contact puts it into a hole `[mm]`.
    pub position: Point,
    /// How its compliance is found.
    pub model: BodyModel,
    /// How finely it is divided where it differs from [`Scene::mesh`](super::Scene::mesh); whole, with what it takes from there.
    pub mesh: Option<MeshSettings>,
}

/// What a body is made of.
#[derive(Debug, Clone, PartialEq)]
pub enum Substance {
    /// An elastic material of the scene.
    Elastic {
        /// Name of the material, defined in [`Scene::materials`](super::Scene::materials).
        material: String,
        /// Thickness `[mm]`.
        thickness: f64,
    },
    /// Nothing in it deforms.
    Rigid,
}

/// How the compliance of an elastic body is found.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyModel {
    /// By series where the scene gives no mesh and a series can hold the body, otherwise by finite elements.
    #[default]
    Auto,
    /// By series about the circle of its contact, without a factorisation.
    Series,
    /// As the half-plane that a block or a cylinder of a line contact stands for, in closed form.
    #[serde(rename = "half-plane")]
    HalfPlane,
    /// By condensed finite elements.
    Elements,
}

impl BodyModel {
    /// Whether it is left to the program.
    #[expect(
        clippy::trivially_copy_pass_by_ref,
        reason = "serde hands over references"
    )]
    pub(crate) fn is_auto(&self) -> bool {
        *self == Self::Auto
    }

    /// Whether the scene asks for a closed form, which has no mesh to solve on.
    pub fn is_closed_form(self) -> bool {
        matches!(self, Self::Series | Self::HalfPlane)
    }
}
