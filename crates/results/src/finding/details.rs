//! The numbers of findings that have several.

use serde::Serialize;

use crate::quantity::Quantity;

/// Solvers that failed before a step was solved.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FurtherSolvers {
    /// Load steps in which solvers failed.
    pub steps: Vec<usize>,
    /// What failed, and how often in all steps.
    pub failed: Vec<FailedSolver>,
    /// The first cycle of statuses, if one was met.
    pub cycle: Option<StatusCycle>,
}

/// How often a solver failed in one way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct FailedSolver {
    /// Name of the solver.
    pub solver: &'static str,
    /// What happened.
    pub reason: &'static str,
    /// How often.
    pub count: usize,
}

/// Statuses that repeated.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
pub struct StatusCycle {
    /// Number of iterations after which they return.
    pub period: usize,
    /// Number of points whose status changes.
    pub points: usize,
}

/// Friction beside the estimate of the coefficient up to which a step is unique.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct UniquenessBound {
    /// The load step nearest to its bound.
    pub step: usize,
    /// Its largest coefficient of friction (dimensionless).
    pub friction: f64,
    /// The estimate (dimensionless).
    pub estimate: f64,
    /// Number of enumerated solutions; `None` where they were not enumerated.
    pub solutions: Option<usize>,
    /// Whether another solver was asked.
    pub other_solver_asked: bool,
}

/// Another answer that another solver finds.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct SolverDependence {
    /// Load steps with another answer.
    pub steps: Vec<usize>,
    /// The load step whose tractions differ most.
    pub step: usize,
    /// The other solver in that step.
    pub solver: &'static str,
    /// Change of the largest pressure there, as a part of it `[1]`.
    pub peak_pressure_change: f64,
    /// Largest change of a traction there, as a part of the largest pressure `[1]`.
    pub traction_change: f64,
}

/// What more increments change of a load step with friction.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CoarseLoadPath {
    /// Load steps that change.
    pub steps: Vec<usize>,
    /// The load step whose tractions change most.
    pub step: usize,
    /// The larger number of increments.
    pub increments: usize,
    /// Largest change of a traction, as a part of the largest pressure `[1]`.
    pub traction_change: f64,
    /// Change of the work of friction, as a part of it `[1]`.
    pub dissipation_change: f64,
}

/// A body that moves as a whole without resistance.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct FreeBody {
    /// The body.
    pub body: String,
    /// How it moves.
    pub motion: FreeMotion,
    /// Contacts that slip in the motion.
    pub contacts: Vec<String>,
}

/// A body beyond its yield stress.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Yield {
    /// The body.
    pub body: String,
    /// Load steps in which it is beyond.
    pub steps: Vec<usize>,
    /// The load step with the largest stress.
    pub step: usize,
    /// The largest von Mises stress there `[MPa]`.
    pub von_mises: Quantity,
    /// The yield stress `[MPa]`.
    pub yield_stress: Quantity,
    /// Place x, y of the largest stress `[mm]`.
    pub at: [Quantity; 2],
}

/// What smaller increments change of an answer whose increments were cut back.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(tag = "kind", rename_all = "snake_case")]
pub enum CutBackEffect {
    /// Without friction no answer depends on the path.
    Frictionless,
    /// Smaller increments were not solved.
    Unknown,
    /// Nothing.
    Nothing,
    /// Slip and its work.
    Slip {
        /// The load step that changes most.
        step: usize,
        /// Number of increments.
        increments: usize,
        /// Largest change of a slip in the step, as a part of the largest `[1]`.
        slip_change: f64,
        /// Change of the work of friction, as a part of it `[1]`.
        dissipation_change: f64,
    },
    /// Tractions.
    Tractions {
        /// The load step that changes most.
        step: usize,
        /// Number of increments.
        increments: usize,
        /// Change of the largest pressure, as a part of it `[1]`.
        peak_pressure_change: f64,
        /// Largest change of a traction, as a part of the largest pressure `[1]`.
        traction_change: f64,
    },
}

/// A rigid motion that nothing resists.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum FreeMotion {
    /// The body turns.
    Rotation,
    /// The body slides along straight contacts.
    Translation,
}
