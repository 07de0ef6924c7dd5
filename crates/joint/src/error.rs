//! Requests that a joint refuses, and why an increment of its load found no equilibrium.

use stickslip_contact::ContactError;
use stickslip_contact::solver::StepFailure;
use stickslip_fem_core::body::BodyError;
use stickslip_laminate::progressive::ProgressiveError;
use thiserror::Error;

/// A joint that cannot be built or followed at all. That a joint fails is not an error: see [`Ending`](crate::Ending).
#[derive(Clone, Debug, Error)]
#[non_exhaustive]
pub enum JointError {
    /// A body cannot be analysed or condensed.
    #[error("body {body}: {cause}")]
    Body {
        /// Index of the body.
        body: usize,
        /// Its reason.
        #[source]
        cause: BodyError,
    },
    /// A finite-element body refused.
    #[error(transparent)]
    Mesh(#[from] BodyError),
    /// The contact problem cannot be made.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// There is not one point model per cell.
    #[error("{models} point models for {cells} cells: each cell needs one")]
    ModelCount {
        /// Models given.
        models: usize,
        /// Cells of the mesh.
        cells: usize,
    },
    /// A point model refuses its state of rest.
    #[error("cell {cell}: {cause}")]
    Material {
        /// Index of the cell.
        cell: usize,
        /// Its reason.
        #[source]
        cause: ProgressiveError,
    },
    /// The residual stresses of the cure find no equilibrium.
    #[error(
        "cell {cell}: no strain frees the laminate of stress at the temperature rise {temperature}"
    )]
    Cure {
        /// Index of the cell.
        cell: usize,
        /// The temperature rise `[temperature]`.
        temperature: f64,
    },
    /// Bodies have different numbers of load cases.
    #[error(
        "body {body} has {found} load cases, the first body {expected}: they cannot share one load history"
    )]
    LoadCases {
        /// Index of the body.
        body: usize,
        /// Cases of the first body.
        expected: usize,
        /// Cases of this body.
        found: usize,
    },
    /// A load case with an initial strain.
    #[error(
        "body {body}, load case {case}: initial strains are not followed here; a laminate's cure is the body's own temperature"
    )]
    InitialStrain {
        /// Index of the body.
        body: usize,
        /// Index of the load case.
        case: usize,
    },
    /// The gauge reads a body, pair, node or point that does not exist.
    #[error("the gauge names {what} {index}, which the joint does not have")]
    Gauge {
        /// What it names: body, pair, node or point.
        what: &'static str,
        /// Its index.
        index: usize,
    },
    /// A direction or factor that is not finite, or a direction of no length.
    #[error("the gauge's {what} = {value} must be finite and not zero")]
    GaugeNumber {
        /// Which number.
        what: &'static str,
        /// The value given: a travel `[length]`, a factor or the length of a direction `[1]`.
        value: f64,
    },
    /// An option out of its range.
    #[error("option {name} = {value} must be {range}")]
    Option {
        /// The option.
        name: &'static str,
        /// The value given `[1]`.
        value: f64,
        /// Values that it may have.
        range: &'static str,
    },
    /// A load step that makes no sense.
    #[error("load step {}: {what}", .step + 1)]
    Load {
        /// Index of the step, from 0; messages count from 1.
        step: usize,
        /// What is wrong, with the numbers.
        what: String,
    },
    /// Not even the smallest part of the first increment has an equilibrium.
    #[error(
        "the joint has no equilibrium under the smallest part of its first load increment: {0}"
    )]
    NoStart(#[source] Halt),
}

/// Why an increment found no equilibrium.
#[derive(Clone, Debug, Error)]
#[non_exhaustive]
pub enum Halt {
    /// The contact has no solution.
    #[error("contact: {0}")]
    Contact(#[source] Box<StepFailure>),
    /// The contact problem cannot be made.
    #[error(transparent)]
    Interface(#[from] ContactError),
    /// The tangent stiffness of a body is not positive definite: it has reached its limit load.
    #[error("body {body} has no stiffness left: {cause}")]
    Stiffness {
        /// Index of the body.
        body: usize,
        /// Its reason.
        #[source]
        cause: BodyError,
    },
    /// The increment steps over a peak of the load.
    #[error(
        "the load falls within the increment: {before} was borne before, plies fail at {failing}"
    )]
    PastPeak {
        /// Largest load borne before `[force]`.
        before: f64,
        /// Load at which plies fail in the increment `[force]`.
        failing: f64,
    },
    /// A point model refused a strain.
    #[error("body {body}, point {point}: {cause}")]
    Material {
        /// Index of the body.
        body: usize,
        /// Index of the quadrature point.
        point: usize,
        /// Its reason.
        #[source]
        cause: ProgressiveError,
    },
    /// Newton's iteration did not converge.
    #[error("out of balance by {residual:.1e} of the forces after {iterations} iterations")]
    NotConverged {
        /// Iterations taken.
        iterations: usize,
        /// What is left, relative to the largest nodal force `[1]`.
        residual: f64,
    },
    /// Plies fail on and on at constant load.
    #[error("plies still fail after {passes} redistributions at constant load")]
    Cascade {
        /// Redistributions made.
        passes: usize,
    },
    /// The equilibrium after the plies failed is so far away that the joint has lost its load path.
    #[error(
        "the joint's secant stiffness falls to {stiffness:.3} of what it was: its load path is lost"
    )]
    LoadPathLost {
        /// Load per displacement, relative to the largest seen before `[1]`.
        stiffness: f64,
    },
    /// Next to nothing but what failed plies are left with holds the joint: without it there is no path from the supports to the loads.
    #[error("the joint is severed: it would bear more only by what failed plies are left with")]
    Severed,
    /// More plies fail at once than an increment should see.
    #[error("{failures} plies fail at once in one increment")]
    Burst {
        /// Quadrature points times plies that fail.
        failures: usize,
    },
}
