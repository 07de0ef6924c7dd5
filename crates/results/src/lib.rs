//! What a run yields, in base units (mm, N, MPa, rad) but for values of loads, which have the unit of their scene: the source of every table, file and figure.

mod bypass;
mod displacement;
mod edges;
mod failure;
mod fastener;
mod finding;
mod frame;
mod ladder;
mod load_scale;
mod nodes;
mod placed;
mod problem;
mod progressive;
mod quantity;
mod resolution;
mod sharing;
mod stated;
mod stresses;
mod zones;

use std::sync::Arc;

/// The crates of scenes, meshes, contacts, laminates and joints that results hold.
pub use {
    stickslip_contact, stickslip_fem_core, stickslip_joint, stickslip_laminate, stickslip_scene,
};

pub use bypass::{PlateRows, RowForces};
pub use displacement::{LoadedSet, SetKind, SetMotion, SetNumbers, SetStated, Stiffness};
pub use edges::{EdgeGeometry, EdgeKind, EdgeResults, EdgeRow, SecondSide};
pub use failure::{
    BesideSupports, BodyFailure, CharacteristicFailure, EdgePlies, EdgePly, Envelope,
    EnvelopePoint, FailurePoint, FirstPly, JointFailure, JointMode, PlyGroup, PlyMap, PointErrors,
};
pub use fastener::{Fastener, FastenerStep, Layer, LayerStep};
pub use finding::{
    CoarseLoadPath, ContactFinding, CutBackEffect, FailedSolver, Finding, FreeBody, FreeMotion,
    FurtherSolvers, JointFinding, SolverDependence, StatusCycle, UniquenessBound, Yield,
};
pub use frame::{BearingSource, ContactFrame, wrapped};
pub use ladder::{Bounded, Ladder, LadderEnd, Rung};
pub use load_scale::LoadScale;
pub use nodes::{Nodes, Values, joined, values};
pub use problem::{Acting, Problem, Site, SitePart};
pub use progressive::{
    CurvePoint, EdgeStrain, LinearJoint, PlyLoss, ProgressiveEnd, ProgressiveFailure,
};
pub use quantity::Quantity;
pub use sharing::LoadShare;
pub use stated::{Errors, RowErrors, Stated};
pub use stresses::{BodyStresses, StressPeak, principal, von_mises};
pub use zones::ZoneRange;

use stickslip_contact::history::{Otherwise, Recovery};
use stickslip_contact::solver::{Residuals, Work};
use stickslip_fem_core::body::BodyBalance;
use stickslip_fem_core::mesh::Mesh;

use stickslip_scene::schema::DisplayUnits;

/// Everything that a run found.
#[derive(Clone, Debug)]
pub struct Results {
    /// Title of the scene.
    pub title: String,
    /// Name of the scene's file.
    pub source: String,
    /// SHA-256 of the resolved scene.
    pub scene_hash: String,
    /// The scene as text, with all defaults filled in.
    pub scene: String,
    /// What acts where.
    pub problem: Problem,
    /// Whether the meshes of bodies are written for other programs.
    pub meshes: bool,
    /// Units to show results in.
    pub units: DisplayUnits,
    /// What the program chose, and why.
    pub choices: Vec<Choice>,
    /// What compliances in blocks leave out; `None` where each is one matrix.
    pub blocks: Option<BlockError>,
    /// What a reader must know: several solutions, points in doubt, cut-backs.
    pub findings: Vec<Finding>,
    /// Bodies in the order of their names.
    pub bodies: Vec<BodySummary>,
    /// Sparse factorisations made.
    pub factorisations: usize,
    /// Contact edges, then further edges asked for: what does not change from step to step.
    pub edges: Vec<EdgeGeometry>,
    /// Sets of bodies that loads act on, then those that are held.
    pub sets: Vec<LoadedSet>,
    /// Bodies that contact links, each part solved apart from the others; empty stands for one part of everything.
    pub parts: Vec<ResultPart>,
    /// Fasteners in the order of their names.
    pub fasteners: Vec<Fastener>,
    /// Load steps.
    pub steps: Vec<StepResults>,
    /// Failure of the laminated bodies for which the scene requests it.
    pub failure: Vec<BodyFailure>,
    /// Wall time of each phase `[s]`.
    pub phases: Vec<(&'static str, f64)>,
    /// How the accuracy was sought; `None` where none was asked for and the scene gives a mesh.
    pub ladder: Option<Ladder>,
}

impl Results {
    /// The edge that tables show, as an index into [`edges`](Self::edges): the first contact edge, or the first edge without contact.
    pub fn main_edge(&self) -> Option<usize> {
        let contact = self.edges.iter().position(|edge| edge.contact);
        contact.or((!self.edges.is_empty()).then_some(0))
    }
}

/// Bodies that contact links, and what acts on them; nothing else does. All lists are ascending.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct ResultPart {
    /// Indices in [`Results::bodies`]; a rigid body that is held may be in several parts.
    pub bodies: Vec<usize>,
    /// Indices in [`Results::edges`].
    pub edges: Vec<usize>,
    /// Indices in [`StepResults::loads`].
    pub loads: Vec<usize>,
}

/// A choice that the program made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Choice {
    /// What was chosen, e.g. "model".
    pub what: String,
    /// The choice, e.g. "half".
    pub value: String,
    /// Why.
    pub reason: String,
}

impl Choice {
    /// [`what`](Self::what) of the geometry on which contact is found.
    pub const KINEMATICS: &str = "kinematics";
    /// [`what`](Self::what) of the solver of load steps.
    pub const SOLVER: &str = "solver";
}

/// The error of compliances in blocks, in the step in which they leave out most.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BlockError {
    /// Shapes of forces by which an edge acts on others, at most.
    pub rank: usize,
    /// Change of tractions by the displacements that are left out, as a part of the peak pressure `[1]`.
    pub tractions: f64,
    /// Largest displacement of a contact point that is left out `[mm]`.
    pub displacement: f64,
}

/// A body as it was modelled.
#[derive(Clone, Debug)]
pub struct BodySummary {
    /// Name in the scene.
    pub name: String,
    /// Its mesh; `None` for a rigid body.
    pub mesh: Option<Arc<Mesh>>,
    /// Number of unknowns.
    pub dofs: usize,
    /// Stored entries of its Cholesky factor.
    pub factor_entries: usize,
    /// Rigid motions that its supports leave free.
    pub free_motions: usize,
    /// Von Mises stress at which its material yields `[MPa]`, where the scene gives one.
    pub yield_stress: Option<f64>,
}

/// A load at the end of a step.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadValue {
    /// Name of the load.
    pub name: String,
    /// Its value in `unit`.
    pub value: f64,
    /// Display unit: of force, of stress, "K", or "1" for a factor.
    pub unit: String,
}

/// One load step.
#[derive(Clone, Debug)]
pub struct StepResults {
    /// Loads at its end.
    pub loads: Vec<LoadValue>,
    /// Whether the load by which the main edge's steps are counted is smaller in magnitude than in the step before.
    pub unloading: bool,
    /// Edges in the order of [`Results::edges`].
    pub edges: Vec<EdgeResults>,
    /// Force and displacement of the sets in the order of [`Results::sets`]; `None` where they are not recovered, as in cases of a sweep, and on
    /// half-planes, whose displacement has no bound.
    pub sets: Vec<Option<SetMotion>>,
    /// Estimated errors of the sets in the same order; empty where none were estimated.
    pub set_errors: Vec<SetNumbers>,
    /// Fasteners in the order of [`Results::fasteners`].
    pub fasteners: Vec<FastenerStep>,
    /// Work of the solvers.
    pub work: Work,
    /// Names of the solvers that found its increments.
    pub solvers: Vec<&'static str>,
    /// Increments that it was divided into.
    pub increments: usize,
    /// Increments that failed and were halved.
    pub cutbacks: usize,
    /// Points that stick although slip at once would be admissible too.
    pub doubtful: usize,
    /// What failed on the way, and what is known of further solutions.
    pub notes: StepNotes,
    /// Residuals of the contact conditions.
    pub residuals: Residuals,
    /// Largest unbalanced force or moment `[1]`, of the floating bodies in the interface problem, and of each elastic body's nodes,
    /// resultant and moment by its recovered displacements; relative to the body's own loads and contact forces in the step, or to a
    /// thousandth of its largest in the history where that is more.
    pub balance_residual: f64,
    /// Balance of each body with its reactions, by the recovered displacements; `None` for a rigid one.
    pub balance: Vec<Option<BodyBalance>>,
    /// Frictional dissipation in the step, whole model `[N·mm]`.
    pub dissipation: f64,
    /// Fields of each elastic body, where requested.
    pub fields: Vec<BodyFields>,
    /// Largest stresses, of bodies whose material has a yield stress in all steps, of other elastic ones in those with fields.
    pub stresses: Vec<BodyStresses>,
    /// Wall time of the step's contact solution `[s]`.
    pub seconds: f64,
}

impl StepResults {
    /// Estimated error of [`dissipation`](Self::dissipation) `[N·mm]`: the sum of those of all contacts; `None` where one has none.
    pub fn dissipation_error(&self, edges: &[EdgeGeometry]) -> Option<f64> {
        let contacts = edges.iter().zip(&self.edges).filter(|own| own.0.contact);
        contacts
            .map(|(_, edge)| edge.errors.get(Stated::FrictionWork))
            .sum()
    }
}

/// What a load step leaves to say of its solvers and of the number of its solutions.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StepNotes {
    /// Attempts that failed before its increments were solved.
    pub recovery: Recovery,
    /// Places x, y `[mm]` of the points of the first cycle.
    pub cycle_places: Vec<[f64; 2]>,
    /// Largest number of solutions of an increment in which no other points touch than in its answer, where they were enumerated: a
    /// lower bound on the number of its solutions.
    pub solutions: Option<usize>,
    /// Where other ways to the end of the step lead.
    pub otherwise: Otherwise,
    /// Largest coefficient of friction of the points in contact (dimensionless).
    pub friction: f64,
    /// Estimate of the coefficient up to which the step has one solution (dimensionless); in the step of the history in which most
    /// points touch.
    pub uniqueness: Option<f64>,
}

impl StepNotes {
    /// Number of solutions that are known, a lower bound on how many there are: those that were enumerated, and the one that another
    /// solver found; `None` where none was looked for.
    pub fn solutions_known(&self) -> Option<usize> {
        let asked = self.otherwise.other_solver;
        let by_another = asked.map(|other| if other.is_distinct() { 2 } else { 1 });
        self.solutions.max(by_another)
    }
}

/// Fields of a body at the end of a load step.
#[derive(Clone, Debug)]
pub struct BodyFields {
    /// Index of the body in [`Results::bodies`].
    pub body: usize,
    /// Displacements, interleaved `[mm]`.
    pub displacement: Vec<f64>,
    /// Averaged nodal stresses (xx, yy, xy) by patch recovery `[MPa]`.
    pub stress: Vec<[f64; 3]>,
    /// Stress σ_zz across the thickness at each node `[MPa]`; zero in plane stress.
    pub thickness_stress: Vec<f64>,
}
