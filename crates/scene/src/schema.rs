//! A checked scene in plain numbers.
//!
//! Base units throughout: mm, N, MPa, rad, K. Angles are counter-clockwise from +x, the load axis; names of bodies, materials and
//! sets refer to things that exist.

mod analysis;
mod bearing;
mod demand;
mod failure;
mod fastener;
mod progressive;

use std::f64::consts::PI;
use std::fmt;
use std::path::PathBuf;

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_friction::FrictionLaw;
use stickslip_text::short;

pub use super::material::{LaminateSheet, Material, OutOfPlane};
pub use crate::shape::Shape;
use crate::units::Unit;
pub use analysis::{Analysis, ComplianceChoice, KinematicsChoice, ModelChoice, Ramp, SolverChoice};
pub use bearing::BearingLaw;
pub use demand::{Accuracy, Bounds, Budget, RelativeError};
pub use failure::{Characteristic, EnvelopePlane, Envelopes, Failure};
pub use fastener::{Fastener, Springs};
pub use progressive::{Control, Progressive, ProgressiveModel};

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

/// A set of a body, written `body.set`.
#[derive(Debug, Clone, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct SetRef {
    /// The body.
    pub body: String,
    /// Its edge or point.
    pub set: String,
}

impl fmt::Display for SetRef {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(formatter, "{}.{}", self.body, self.set)
    }
}

/// How finely the bodies are divided.
#[derive(Debug, Clone, PartialEq)]
pub struct MeshSettings {
    /// Element of the cells.
    pub element: ElementKind,
    /// Division along the contact edges.
    pub division: Division,
    /// Radial layers, or layers in depth; chosen from the division where it is `None`.
    pub layers: Option<usize>,
}

impl MeshSettings {
    /// The settings with corner nodes twice as close.
    #[must_use]
    pub fn finer(&self) -> Self {
        let Self {
            element,
            division,
            layers,
        } = self;
        Self {
            element: *element,
            division: division.finer(),
            layers: layers.map(|layers| 2 * layers),
        }
    }

    /// The settings with corner nodes twice as far apart.
    #[must_use]
    pub fn coarser(&self) -> Self {
        let Self {
            element,
            division,
            layers,
        } = self;
        Self {
            element: *element,
            division: division.coarser(),
            layers: layers.map(|layers| layers.div_ceil(2)),
        }
    }
}

/// Where the corner nodes of a contact edge lie.
#[derive(Debug, Clone, PartialEq)]
pub enum Division {
    /// At these angles `[rad]`, strictly increasing from 0 to at most 2π.
    AngleList(Vec<f64>),
    /// By angles `[rad]` from the bearing point θ = 0.
    Angular(Grading),
    /// By lengths `[mm]` from the point of first contact.
    Linear(Grading),
    /// At these places x `[mm]` along a line contact, strictly increasing, from one end of the edge to the other or from 0 to the end of a half.
    Places(Vec<f64>),
}

impl fmt::Display for Division {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::AngleList(angles) => write!(formatter, "{} angles", angles.len()),
            Self::Angular(grading) => {
                let degrees = grading.spacing.to_degrees();
                write!(formatter, "spacing {} deg", short(degrees))
            }
            Self::Linear(grading) => write!(formatter, "spacing {} mm", short(grading.spacing)),
            Self::Places(places) => write!(formatter, "{} places", places.len()),
        }
    }
}

impl Division {
    fn finer(&self) -> Self {
        match self {
            Self::AngleList(angles) => Self::AngleList(halved(angles)),
            Self::Places(places) => Self::Places(halved(places)),
            Self::Angular(grading) => Self::Angular(grading.scaled(0.5)),
            Self::Linear(grading) => Self::Linear(grading.scaled(0.5)),
        }
    }

    fn coarser(&self) -> Self {
        match self {
            Self::AngleList(angles) => {
                let mut kept: Vec<f64> = angles.iter().step_by(2).copied().collect();
                // A list ends at π, or goes around with an even number of angles.
                let goes_around = angles.last().is_some_and(|last| *last > PI + 1e-9);
                let is_odd = !kept.len().is_multiple_of(2);
                let ends = if goes_around {
                    is_odd
                } else {
                    angles.len().is_multiple_of(2)
                };
                kept.extend(angles.last().filter(|_| ends));
                Self::AngleList(kept)
            }
            Self::Angular(grading) => Self::Angular(grading.scaled(2.0)),
            Self::Linear(grading) => Self::Linear(grading.scaled(2.0)),
            Self::Places(places) => {
                let inner = places.iter().step_by(2).copied();
                let end = places.last().filter(|_| places.len().is_multiple_of(2));
                Self::Places(inner.chain(end.copied()).collect())
            }
        }
    }
}

/// `values` with their midpoints.
fn halved(values: &[f64]) -> Vec<f64> {
    let pairs = values.windows(2);
    let between = pairs.flat_map(|pair| [pair[0], f64::midpoint(pair[0], pair[1])]);
    between.chain(values.last().copied()).collect()
}

/// Equal spacing, and optionally coarser beyond some distance.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Grading {
    /// Spacing of corner nodes.
    pub spacing: f64,
    /// Up to where, measured from the bearing point; everywhere if `None`.
    pub fine_to: Option<f64>,
    /// Spacing that it grows to beyond; chosen by the generator if `None`.
    pub coarse_spacing: Option<f64>,
}

impl Grading {
    /// Spacings times `factor`.
    fn scaled(self, factor: f64) -> Self {
        let Self {
            spacing,
            fine_to,
            coarse_spacing,
        } = self;
        Self {
            spacing: factor * spacing,
            fine_to,
            coarse_spacing: coarse_spacing.map(|spacing| factor * spacing),
        }
    }
}

/// Two edges that may touch.
#[derive(Debug, Clone)]
pub struct Contact {
    /// Name in results.
    pub name: String,
    /// The edge that the normal points into: hole, or cylinder.
    pub first: SetRef,
    /// The other edge: rim of a pin, outer edge of a ring, or block.
    pub second: SetRef,
    /// How the initial gap is computed.
    pub gap: GapKind,
    /// How the two edges are tied to each other.
    pub projection: ProjectionChoice,
    /// Whether an initial overlap is meant.
    pub interference: bool,
    /// Its friction.
    pub law: Box<dyn FrictionLaw>,
}

/// How the initial gap between two circles is computed.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum GapKind {
    /// From the circles.
    #[default]
    Exact,
    /// c (1 − cos θ), clearance c: what closed forms assume.
    Linearised,
    /// From the nodes and straight facets of the mesh.
    Faceted,
}

/// How two edges in contact are tied to each other.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
pub enum ProjectionChoice {
    /// Pairs of nodes where the meshes match, dual mortar where they do not.
    #[default]
    Auto,
    /// Pairs of nodes; the meshes must match.
    Nodes,
    /// Mortar projection with the shape functions of the first edge.
    Mortar,
    /// Mortar projection with functions biorthogonal to them.
    DualMortar,
}

/// A coordinate axis.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Axis {
    /// The load axis.
    X,
    /// The other.
    Y,
}

impl Axis {
    /// As scenes write it.
    pub fn name(self) -> &'static str {
        match self {
            Self::X => "x",
            Self::Y => "y",
        }
    }
}

/// Some of the axes.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub struct Axes {
    /// Whether x is among them.
    pub x: bool,
    /// Whether y is among them.
    pub y: bool,
}

impl Axes {
    /// Their unit vectors.
    pub fn directions(self) -> Vec<[f64; 2]> {
        let all = [(self.x, [1.0, 0.0]), (self.y, [0.0, 1.0])];
        let among = all.into_iter().filter(|(is_among, _)| *is_among);
        among.map(|(_, direction)| direction).collect()
    }

    /// Those that are not among them.
    #[must_use]
    pub fn others(self) -> Self {
        Self {
            x: !self.x,
            y: !self.y,
        }
    }
}

/// Nodes whose displacement is given.
#[derive(Debug, Clone, PartialEq)]
pub struct Support {
    /// Where.
    pub on: SetRef,
    /// In which directions.
    pub hold: Hold,
    /// Displacement in each of them `[mm]`.
    pub displacement: f64,
}

/// Springs between a set and the ground.
#[derive(Debug, Clone, PartialEq)]
pub struct SpringSupport {
    /// Its number among the supports of the scene.
    pub index: usize,
    /// Where.
    pub on: SetRef,
    /// In which directions they act.
    pub hold: Hold,
    /// How stiff they are in each of them.
    pub stiffness: SpringSize,
}

/// How stiff springs are.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum SpringSize {
    /// All together `[N/mm]`.
    Whole(f64),
    /// Per area `[N/mm³]`.
    Bed(f64),
}

/// Directions in which a support holds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Hold {
    /// Along axes, at least one.
    Axes(Axes),
    /// Along the direction at this angle `[rad]` from +x.
    Direction(f64),
}

impl Hold {
    /// The unit vectors along which it holds, one or two.
    pub fn directions(self) -> Vec<[f64; 2]> {
        match self {
            Self::Axes(axes) => axes.directions(),
            Self::Direction(angle) => vec![[angle.cos(), angle.sin()]],
        }
    }
}

/// A rigid plate that an edge is glued to. It does not rotate.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Platen {
    /// The edge.
    pub on: SetRef,
    /// Axes along which it moves freely; along the others it is held.
    pub free: Axes,
}

/// A load and its history.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Name in results.
    pub name: String,
    /// What loads what.
    pub kind: LoadKind,
}

/// What loads what. Every `steps` has one entry per load step, and all loads act at once.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A total force on an edge of the whole body, spread evenly.
    Force {
        /// The edge.
        on: SetRef,
        /// Unit vector.
        direction: [f64; 2],
        /// Magnitudes `[N]`.
        steps: Vec<f64>,
    },
    /// An assumed pressure on half of a hole, in the place of a pin.
    Bearing {
        /// The hole.
        on: SetRef,
        /// Unit vector of the force on the body; the pressure's middle lies there.
        direction: [f64; 2],
        /// How the pressure is spread.
        law: BearingLaw,
        /// Magnitudes of the force on the whole hole `[N]`, at least 0.
        steps: Vec<f64>,
    },
    /// A pressure on an edge; positive pushes on the body, negative pulls.
    Pressure {
        /// The edge.
        on: SetRef,
        /// `[MPa]`
        steps: Vec<f64>,
    },
    /// Stresses on a circular edge, from a table.
    PolarTraction {
        /// The edge.
        on: SetRef,
        /// The table.
        table: PolarTable,
        /// Factors of the table's stresses.
        steps: Vec<f64>,
    },
    /// A temperature change of a body.
    Temperature {
        /// The body.
        body: String,
        /// `[K]`
        steps: Vec<f64>,
    },
}

impl LoadKind {
    /// Name of the body that it acts on.
    pub fn body(&self) -> &str {
        match self {
            Self::Force { on, .. }
            | Self::Bearing { on, .. }
            | Self::Pressure { on, .. }
            | Self::PolarTraction { on, .. } => &on.body,
            Self::Temperature { body, .. } => body,
        }
    }

    /// The history, in whatever unit it has.
    pub fn steps(&self) -> &[f64] {
        match self {
            Self::Force { steps, .. }
            | Self::Bearing { steps, .. }
            | Self::Pressure { steps, .. }
            | Self::PolarTraction { steps, .. }
            | Self::Temperature { steps, .. } => steps,
        }
    }
}

/// Stresses over the angle on a circle.
#[derive(Debug, Clone, PartialEq)]
pub struct PolarTable {
    /// The file that it was read from.
    pub file: PathBuf,
    /// Angles `[rad]`, strictly increasing.
    pub theta: Vec<f64>,
    /// σ_r `[MPa]`.
    pub radial: Vec<f64>,
    /// τ_rθ `[MPa]`.
    pub shear: Vec<f64>,
}

impl PolarTable {
    /// Whether the table ends at π and so stands for a load symmetric about the x axis.
    pub fn is_half(&self) -> bool {
        self.theta
            .last()
            .is_some_and(|last| (last - std::f64::consts::PI).abs() < 1e-9)
    }
}

/// What is written beside tables.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Output {
    /// For which steps fields are written as VTU.
    pub fields: FieldOutput,
    /// Whether figures are drawn.
    pub figures: bool,
    /// Whether the meshes of bodies are written for other programs.
    pub meshes: bool,
}

impl Default for Output {
    fn default() -> Self {
        Self {
            fields: FieldOutput::Peak,
            figures: true,
            meshes: false,
        }
    }
}

/// For which load steps fields are computed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum FieldOutput {
    /// None.
    None,
    /// Where the load is largest that acts on a part of the scene which contact does not link to others, for every such part.
    Peak,
    /// The last.
    Last,
    /// Each.
    All,
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Round bodies have an even number of angles all around, and lists of a half end at π.
    #[test]
    fn coarser_lists_of_angles_make_meshes_too() {
        for count in [340, 342, 360, 362] {
            let step = 2.0 * PI / f64::from(count);
            let around = Division::AngleList((0..count).map(|k| step * f64::from(k)).collect());
            let Division::AngleList(kept) = around.coarser() else {
                unreachable!();
            };
            assert!(kept.len().is_multiple_of(2) && kept.len() < 200, "{count}");
        }
        for count in [30, 31] {
            let step = PI / f64::from(count);
            let half = Division::AngleList((0..=count).map(|k| step * f64::from(k)).collect());
            let Division::AngleList(kept) = half.coarser() else {
                unreachable!();
            };
            assert!((kept[kept.len() - 1] - PI).abs() < 1e-12 && kept.len() < 20);
        }
    }
}
