//! What a reader must know of a run, as kinds of findings with their numbers. `present` writes the sentences.
//!
//! Load steps are counted from 1. Parts are relative numbers without a dimension; everything else is a [`Quantity`].

mod details;

use serde::Serialize;
use stickslip_scene::shape::FileNote;

use super::ladder::LadderEnd;
use super::quantity::Quantity;

pub use details::{
    CoarseLoadPath, CutBackEffect, FailedSolver, FreeBody, FreeMotion, FurtherSolvers,
    SolverDependence, StatusCycle, UniquenessBound, Yield,
};

/// A remark or a warning about a run; serialised with its `kind` in snake case.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum Finding {
    /// Points stick with a traction between the dynamic and the static bound, where slip would be admissible too.
    PointsInDoubt {
        /// Load steps with such points.
        steps: Vec<usize>,
        /// Largest number of such points in a step.
        points: usize,
    },
    /// An answer does not meet the conditions of contact to rounding: that of an experimental solver, or a state that nearly does where cut-back ended.
    Unverified {
        /// Load steps with such answers.
        steps: Vec<usize>,
        /// Solvers of these steps.
        solvers: Vec<&'static str>,
        /// Largest residual, as a part of the scales of penetration, friction and balance `[1]`.
        residual: f64,
    },
    /// The first solver failed before a step was solved.
    FurtherSolvers(FurtherSolvers),
    /// An increment has several solutions, which were enumerated.
    SeveralSolutions {
        /// Load steps with such increments.
        steps: Vec<usize>,
        /// Largest number of solutions of an increment.
        solutions: usize,
    },
    /// Friction is near or beyond the estimate of the coefficient up to which a step is unique.
    NearUniquenessBound(UniquenessBound),
    /// Increments were cut back.
    CutBack {
        /// Load steps with increments that were halved.
        steps: Vec<usize>,
        /// What smaller increments change.
        effect: CutBackEffect,
    },
    /// Load steps with friction depend on the number of their increments.
    CoarseLoadPath(CoarseLoadPath),
    /// Whether load steps with friction depend on the number of their few increments is not known.
    LoadPathUnchecked {
        /// Load steps in which the load path begins or turns and that were not compared with finer ones.
        steps: Vec<usize>,
    },
    /// Another solver finds another answer from the same state before the step.
    SolverDependent(SolverDependence),
    /// Another solver should have been asked and gave no answer.
    NoOtherSolver {
        /// Load steps that would take more work than comparisons may.
        too_dear: Vec<usize>,
        /// Number of floating-point operations `[1]` that comparisons of a history may take.
        limit: f64,
        /// Load steps that the other solver did not solve.
        unsolved: Vec<usize>,
    },
    /// Rounding shows in the balance of forces.
    Unbalanced {
        /// Load steps above the usual residual.
        steps: Vec<usize>,
        /// Largest residual of balance, as a part of the load `[1]`.
        residual: f64,
        /// What ordinary rounding does not reach `[1]`.
        usual: f64,
    },
    /// What of the file of a body's mesh was passed over or changed.
    MeshFile {
        /// The body.
        body: String,
        /// What.
        notes: Vec<FileNote>,
    },
    /// A body whose file puts it somewhere else was moved into the hole that holds it.
    MovedIntoHole {
        /// The body.
        body: String,
        /// The hole.
        hole: String,
        /// By how much.
        distance: Quantity,
    },
    /// Bodies are held at single points, on whose nodes it depends how load is shared.
    PointSupports {
        /// The bodies.
        bodies: Vec<String>,
    },
    /// Displacements, stiffness and reactions have no error, because finer models of bodies have smaller cells in some places alone.
    SetsWithoutErrors {
        /// The bodies.
        bodies: Vec<String>,
    },
    /// Displacements under loads hang on points at which elements hold bodies, and have no limit.
    PointDisplacements {
        /// The bodies.
        bodies: Vec<String>,
        /// Names of the loads.
        loads: Vec<String>,
    },
    /// Forces act on single points, whose displacements and stresses have no limit.
    PointLoads {
        /// Names of the loads.
        loads: Vec<String>,
    },
    /// The largest stress along an edge is where a support ends, grows with every finer division and has no limit, so that no error is stated.
    NoLimitAtSupport {
        /// The edge.
        edge: String,
        /// Load steps with such stresses.
        steps: Vec<usize>,
    },
    /// The largest stress along an edge, or that at its bearing point, is where a traction along an edge ends, and depends on the side from which one comes.
    NoValueAtLoadEnd {
        /// The edge.
        edge: String,
        /// Load steps with such stresses.
        steps: Vec<usize>,
    },
    /// The largest stress along an edge is at a re-entrant corner, grows with every finer division and has no limit.
    NoLimitAtReentrantCorner {
        /// The edge.
        edge: String,
        /// Load steps with such stresses.
        steps: Vec<usize>,
        /// Angle of the corner inside the body `[degree]`.
        angle: f64,
        /// Power of the distance from the corner with which stress grows `[1]`, between −½ and 0, of an isotropic body with free sides.
        exponent: Option<f64>,
    },
    /// Forces on fasteners have a moment out of the plane.
    EccentricLayers {
        /// The fasteners.
        fasteners: Vec<String>,
    },
    /// The accuracy of numbers is asked for of which no error can be stated.
    AccuracyUnstated {
        /// The numbers.
        numbers: Vec<&'static str>,
    },
    /// The accuracy that is asked for is not reached.
    AccuracyMissed {
        /// The number whose error is farthest beyond it.
        number: &'static str,
        /// Its error, a part of the number `[1]`.
        error: f64,
        /// Why no finer model was tried.
        end: LadderEnd,
    },
    /// What gaps on the deformed geometry would change is in no stated error, because the model has none there.
    GeometryLeftOut {
        /// Why it has none.
        why: String,
    },
    /// What gaps on the deformed geometry would change is not known, and no errors are stated.
    GeometryUnchecked {
        /// Why the model on the deformed geometry gave no answer.
        why: String,
    },
    /// Contact parts and bears elsewhere within one increment.
    ContactParts {
        /// Load steps with such increments.
        steps: Vec<usize>,
    },
    /// A body moves as a whole without resistance, with slip.
    FreeBody(FreeBody),
    /// Bodies move together as one rigid body, without slip.
    FreeTogether {
        /// The bodies.
        bodies: Vec<String>,
        /// How they can move: one or both.
        motions: Vec<FreeMotion>,
    },
    /// Reserve factors multiply the interference of contacts.
    ReserveWithInterference {
        /// The contacts.
        contacts: Vec<String>,
    },
    /// The elastic stress of a body exceeds the yield stress of its material.
    Yields(Yield),
    /// Stresses on the contact edge of a body strain it by more than linear elasticity describes.
    LargeStrains {
        /// The body.
        body: String,
        /// The load step with the largest strain.
        step: usize,
        /// The largest stress there over the smallest modulus of the body `[1]`.
        strain: f64,
    },
    /// A finding about one contact; serialised with the `kind` of that.
    #[serde(untagged)]
    Contact {
        /// Name of the contact.
        contact: String,
        /// What was found.
        #[serde(flatten)]
        finding: ContactFinding,
    },
}

/// A finding about one contact.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum ContactFinding {
    /// Its bodies differ in thickness.
    UnequalThickness {
        /// First and second body.
        bodies: [String; 2],
        /// Their thickness `[mm]`.
        thickness: [Quantity; 2],
    },
    /// The clearance is wide for points that are paired at equal angles.
    WideClearance {
        /// Clearance as a part of the hole's radius `[1]`.
        clearance: f64,
    },
    /// The radius of one of its circles is fitted to nodes whose distance from it counts beside the clearance.
    FittedRadius {
        /// The circle.
        edge: String,
        /// How far its corner nodes were from it at most `[mm]`.
        off: Quantity,
        /// Clearance, negative for an interference `[mm]`.
        clearance: Quantity,
    },
    /// The radius that is given for one of its circles is farther from that of the nodes than they scatter, and that counts beside the clearance.
    OtherRadius {
        /// The circle.
        edge: String,
        /// The radius that is given `[mm]`.
        given: Quantity,
        /// That of the best circle through its corner nodes `[mm]`.
        fitted: Quantity,
        /// How far they are from that at most `[mm]`.
        off: Quantity,
    },
    /// It ends beyond the fine part of its mesh.
    BeyondFineMesh {
        /// The load step with the farthest end.
        step: usize,
        /// That end, θ `[rad]` or x `[mm]`.
        end: Quantity,
        /// Whether the other end is as far on the other side.
        both_ends: bool,
        /// Where the fine part of the mesh ends on either side `[rad or mm]`.
        limit: Quantity,
    },
    /// Its bearing point moves in the history.
    BearingPointWanders {
        /// The load step in which it is farthest from the place below.
        step: usize,
        /// Where it is then, θ `[rad]` or x `[mm]`.
        at: Quantity,
        /// The load step in which the contact force is largest.
        largest_step: usize,
        /// Where it is then, from where angles are counted.
        largest_at: Quantity,
    },
    /// The mesh does not resolve it.
    Unresolved {
        /// Load steps in which it touches along less than two element edges.
        steps: Vec<usize>,
        /// Fewest nodes of a part of the contact.
        nodes: usize,
    },
    /// The mesh does not resolve the largest pressure of an open edge.
    PeakUnresolved {
        /// Load steps in which less than two element edges carry more than half of it.
        steps: Vec<usize>,
        /// Fewest nodes that do.
        nodes: usize,
    },
    /// Numbers of it grow with every finer division and have no limit, so that no error is stated.
    NoLimit {
        /// Load steps with such numbers.
        steps: Vec<usize>,
        /// What they are.
        numbers: Vec<&'static str>,
    },
    /// On the deformed geometry its nodes are paired with others that are far from what they face.
    PairsApart {
        /// Load steps in which they are.
        steps: Vec<usize>,
        /// How far they are at an end of contact at most.
        apart: Quantity,
        /// The distance of nodes there.
        spacing: Quantity,
    },
    /// It is between half-planes, and errors contain neither what the outlines of the bodies nor what the curvature of their edges changes.
    OutlineLeftOut {
        /// The load step in which it reaches farthest.
        step: usize,
        /// The farthest place there, from where it starts.
        reach: Quantity,
        /// The smaller of the half length and the depth of the bodies.
        size: Quantity,
        /// Radius of curvature of the edges against each other; `None` of straight ones.
        radius: Option<Quantity>,
    },
    /// It touches where its edges cease to face each other, although the first goes on.
    BeyondFacing {
        /// The first load step in which it does.
        step: usize,
        /// The place.
        at: Quantity,
    },
    /// The corner of one of its bodies presses on the other, so that the largest pressure and the stress along the edge grow with every finer division and have no limit.
    NoLimitAtCorner {
        /// Load steps in which it does.
        steps: Vec<usize>,
        /// The places.
        at: Vec<Quantity>,
    },
    /// Its pressures node by node are not unique, because the first body has more nodes than the soft second one can follow.
    RipplingPressures {
        /// First and second body.
        bodies: [String; 2],
        /// Their numbers of nodes along the contact.
        nodes: [usize; 2],
        /// How many times as much the second body gives `[1]`.
        stiffness_ratio: f64,
    },
    /// It leaves a rigid motion of its bodies undetermined that changes no force, and with it gaps.
    GapsUndetermined {
        /// First and second body.
        bodies: [String; 2],
        /// Load steps with such increments.
        steps: Vec<usize>,
    },
    /// Friction leaves a rigid motion of its bodies along it undetermined, and with it slip.
    SlipUndetermined {
        /// First and second body.
        bodies: [String; 2],
        /// Load steps with such increments.
        steps: Vec<usize>,
    },
}

/// What the scene asks for and a followed joint has less of.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum JointFinding {
    /// A fracture energy lowers no strength on this mesh.
    CrackBandIdle {
        /// Key of the energy in `crack_band`.
        energy: &'static str,
        /// Width of a row of points from which it lowers a strength `[mm]`.
        row_width: Quantity,
        /// Size of a cell with such rows `[mm]`.
        cell_size: Quantity,
        /// Size of the largest cell `[mm]`.
        largest_cell: Quantity,
    },
    /// A fracture energy lowers a strength in some cells only.
    CrackBandPartial {
        /// Key of the energy in `crack_band`.
        energy: &'static str,
        /// Number of cells in which it does.
        lowered_cells: usize,
        /// Number of all cells.
        cells: usize,
        /// Size of a cell from which on it does `[mm]`.
        cell_size: Quantity,
    },
    /// An experimental solver returned answers that do not meet the conditions of contact to rounding.
    Unverified {
        /// Solvers of these increments.
        solvers: Vec<&'static str>,
        /// Largest residual, as a part of the scales of penetration, friction and balance `[1]`.
        residual: f64,
    },
    /// `analysis.substeps` and `analysis.ramp` do not divide the joint's increments.
    SubstepsIgnored,
    /// `failure.clear_of_supports` has no effect on the joint.
    ClearOfSupportsIgnored,
    /// Plies of further bodies do not fail.
    OtherBodiesIntact {
        /// The bodies.
        bodies: Vec<String>,
    },
}

impl Finding {
    /// Whether it says what stated errors contain.
    pub fn is_within_errors(&self) -> bool {
        match self {
            Self::CoarseLoadPath(_) | Self::LoadPathUnchecked { .. } => true,
            Self::Contact { finding, .. } => matches!(finding, ContactFinding::PairsApart { .. }),
            _ => false,
        }
    }

    /// The `finding` about the contact `name`.
    pub fn about(name: &str, finding: ContactFinding) -> Self {
        Self::Contact {
            contact: name.to_owned(),
            finding,
        }
    }
}
