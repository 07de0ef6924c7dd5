//! One load step of frictional contact, and the family of solvers for it.
//!
//! ```text
//! g_n ≥ 0,  λ_n ≥ 0,  g_n λ_n = 0
//! |λ_t| ≤ F_stick where Δs = 0 (stick),   λ_t = −F_slip sign(Δs) where Δs ≠ 0 (slip)
//! ```
//!
//! | solver | idea | ends |
//! | --- | --- | --- |
//! | [`StatusIteration`] | guess open/stick/slip, solve, correct all at once (Post & Reddy 1988, II 2.1) | may cycle, and says so |
//! | [`SemismoothNewton`] | the same solves, corrected by the projection (Alart & Curnier 1991), with rules against repetition | may cycle, and says so |
//! | [`TrescaFixedPoint`] | a convex problem with given bounds, then new bounds (Panagiotopoulos 1975) | at its tolerance for small μ; may stall for large |
//! | [`Pivoting`] | Lemke's complementary pivoting (Cottle, Pang & Stone 1992) | after finitely many pivots; with a solution where all bodies are supported |
//! | [`PrincipalPivoting`] | exchange of single complementary pairs, least index first (Murty 1974) | for small μ; detects repetition |
//! | [`GaussSeidel`] | each point solved exactly, in turn (Jean 1999) | at its tolerance for small μ |
//! | [`Penalty`] | contact springs | with an answer of the springs' accuracy |
//! | [`AugmentedLagrangian`] | contact springs, and multipliers that take over from them (Hestenes 1969, Powell 1969) | at its tolerance, whatever the springs |
//! | [`Continuation`] | the solution followed from a simpler problem | with a solution, if the path has no fold that it cannot jump |
//! | [`Enumeration`] | every combination of statuses | after 4ⁿ solves, with a proof if there is no solution |
//! | [`Chain`] | a solver made of solvers: the next one takes over where one fails | with its last member |

mod accept;
mod active_set;
mod attempt;
mod augmented;
mod balance;
mod boxed;
mod chain;
mod complementarity;
mod continuation;
mod enumeration;
mod frozen;
mod gauss_seidel;
mod hold;
mod lemke;
mod mixing;
mod penalty;
mod pivoting;
mod principal;
mod residual;
mod rules;
mod step;
mod tableau;
mod tresca;

use thiserror::Error;

pub(crate) use balance::{balanced_by, settled};
pub(crate) use chain::released;

pub use active_set::{SemismoothNewton, StatusIteration};
pub use augmented::AugmentedLagrangian;
pub use chain::Chain;
pub use continuation::Continuation;
pub use enumeration::Enumeration;
pub use frozen::{FreeMotions, Frozen, FrozenSystem, SlipLine};
pub use gauss_seidel::{Acceleration, GaussSeidel};
pub use penalty::Penalty;
pub use pivoting::Pivoting;
pub use principal::PrincipalPivoting;
pub use residual::Residuals;
pub use step::Step;
pub use tresca::TrescaFixedPoint;

use crate::state::TrialState;

/// What a solver did, each in its own units.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Work {
    /// Interface solves with frozen statuses, the confirming one included.
    pub solves: usize,
    /// Complementary pivots.
    pub pivots: usize,
    /// Sweeps over all contact points.
    pub sweeps: usize,
    /// Updates of friction bounds or multipliers by an outer iteration.
    pub updates: usize,
    /// Factorisations: dense ones of the interface, or sparse ones of whole bodies where a solver works on these.
    pub factorisations: usize,
    /// Floating-point operations of the dominant kernels (factorisations, pivots, products with the compliance).
    pub operations: u64,
}

impl std::ops::AddAssign for Work {
    fn add_assign(&mut self, other: Self) {
        self.solves += other.solves;
        self.pivots += other.pivots;
        self.sweeps += other.sweeps;
        self.updates += other.updates;
        self.factorisations += other.factorisations;
        self.operations += other.operations;
    }
}

/// Why a solver stopped with the state it returns.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Stop {
    /// All conditions are met to 1e-10 of their scales.
    #[default]
    Verified,
    /// The solver's own, looser tolerance is met; the residuals say what is left.
    Tolerance,
    /// The regularised problem is solved; the residuals say how far that is from the contact problem.
    Regularised,
}

/// A solution of one step.
#[derive(Clone, Debug)]
pub struct StepSolution {
    /// The proposed state.
    pub trial: TrialState,
    /// How well it meets the conditions.
    pub residuals: Residuals,
    /// Points that stick although a slip at once would be admissible too (μ_d p < |λ_t| ≤ μ_s p).
    pub doubtful: usize,
    /// Work of all solvers that were tried.
    pub work: Work,
    /// Name of the solver that found it.
    pub solver: &'static str,
    /// Why it stopped. Solvers that are members of a [`Chain`] return verified solutions only.
    pub stop: Stop,
    /// Number of distinct solutions of the step, where the statuses of the points that touch in it were enumerated (of all
    /// points, where these are few enough); this one is the nearest to the last accepted state.
    pub solutions: Option<usize>,
    /// Solvers that were tried before it, each with its reason.
    pub attempts: Vec<(&'static str, FailureCause)>,
}

/// Why a solver did not solve a step.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FailureCause {
    /// The statuses repeat.
    #[error("the statuses of {} points repeat with period {period}", points.len())]
    Cycled {
        /// Number of iterations after which the statuses return.
        period: usize,
        /// Points whose status changes within the cycle.
        points: Vec<usize>,
    },
    /// The iteration limit was reached.
    #[error("not converged after {0} iterations")]
    Limit(usize),
    /// The interface matrix of the current statuses is singular.
    #[error("the interface matrix of the current statuses is singular")]
    Singular,
    /// Pivoting ended on a ray, which proves nothing for friction.
    #[error("complementary pivoting ended on a ray")]
    Ray,
    /// A candidate does not meet the conditions.
    #[error("the candidate violates the contact conditions by {violation:.1e} of their scale")]
    Inaccurate {
        /// Largest relative violation.
        violation: f64,
    },
    /// No combination of statuses meets the conditions.
    #[error("none of {combinations} combinations of statuses meets the contact conditions{}", if *proved { " (proved)" } else { "" })]
    NoSolution {
        /// Number of combinations.
        combinations: usize,
        /// Whether that is a proof: a body floats, the law is linear within the step, and every combination has one solution
        /// that misses the conditions by far more than rounding.
        proved: bool,
    },
    /// The problem is too large for enumeration.
    #[error("{points} points are more than {limit}")]
    TooManyPoints {
        /// Number of points.
        points: usize,
        /// Largest number that is tried.
        limit: usize,
    },
    /// The work that is given to a search was done.
    #[error(
        "given up after {operations:.1e} floating-point operations, of {limit:.1e} that it may take"
    )]
    Effort {
        /// Operations done.
        operations: u64,
        /// Operations that the search may take.
        limit: u64,
    },
    /// A floating body's load cannot be balanced: a rigid motion along which the load works separates, or slides along,
    /// every contact.
    #[error("the load cannot be balanced: nothing stops a rigid motion on which it does work{}", if *proved { " (proved)" } else { "" })]
    Unbalanced {
        /// The rigid motion α, one number per mode.
        motion: Vec<f64>,
        /// Whether that motion is a proof (Farkas): no admissible contact force works against it, whatever the points remember
        /// of slip.
        proved: bool,
    },
}

impl FailureCause {
    /// What kind of failure it is, in a word or two.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Cycled { .. } => "cycled",
            Self::Limit(_) => "iteration limit",
            Self::Singular => "singular matrix",
            Self::Ray => "ray",
            Self::Inaccurate { .. } => "inaccurate",
            Self::NoSolution { .. } => "no solution among all statuses",
            Self::TooManyPoints { .. } => "too many points",
            Self::Effort { .. } => "work limit",
            Self::Unbalanced { .. } => "no balance",
        }
    }
}

/// A step that was not solved: what each solver said, the work spent, and the state that came closest.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("{}{}", reasons(attempts), best_residual(best.as_deref()))]
pub struct StepFailure {
    /// Each solver that was tried, with its reason.
    pub attempts: Vec<(&'static str, FailureCause)>,
    /// Work of all of them.
    pub work: Work,
    /// The state that met the conditions best, if a solver has one: no solution, and never committed.
    pub best: Option<Box<Unresolved>>,
}

/// The best state of a step that no solver solved.
#[derive(Clone, Debug, PartialEq)]
pub struct Unresolved {
    /// The state.
    pub trial: TrialState,
    /// How far it is from meeting the conditions.
    pub residuals: Residuals,
}

fn reasons(attempts: &[(&'static str, FailureCause)]) -> String {
    let reason = |(solver, cause): &(&'static str, FailureCause)| format!("{solver}: {cause}");
    attempts.iter().map(reason).collect::<Vec<_>>().join("; ")
}

fn best_residual(best: Option<&Unresolved>) -> String {
    best.map_or_else(String::new, |state| {
        let residual = state.residuals.largest();
        format!("; the best state violates the contact conditions by {residual:.1e} of their scale")
    })
}

impl StepFailure {
    /// The failure of one solver after `work`, without a state.
    pub fn new(solver: &'static str, cause: FailureCause, work: Work) -> Self {
        Self {
            attempts: vec![(solver, cause)],
            work,
            best: None,
        }
    }

    /// The same failure with a state that came close; the better one is kept.
    #[must_use]
    pub fn with_best(mut self, candidate: Option<Box<Unresolved>>) -> Self {
        if let Some(candidate) = candidate
            && candidate.residuals.largest().is_finite()
            && self
                .best
                .as_ref()
                .is_none_or(|best| candidate.residuals.largest() < best.residuals.largest())
        {
            self.best = Some(candidate);
        }
        self
    }

    /// Whether the step is left open: no solution was found, and none was proved not to exist.
    pub fn is_unresolved(&self) -> bool {
        !self.attempts.iter().any(|(_, cause)| {
            matches!(
                cause,
                FailureCause::Unbalanced { proved: true, .. }
                    | FailureCause::NoSolution { proved: true, .. }
            )
        })
    }

    /// Whether the load at the end of the step was proved to have no balance, whatever the contact points remember of slip, so
    /// that no smaller increments reach it.
    pub fn is_proved_impossible(&self) -> bool {
        self.attempts
            .iter()
            .any(|(_, cause)| matches!(cause, FailureCause::Unbalanced { proved: true, .. }))
    }
}

/// Solves one load step: problem, loads and the last accepted state in; a verified solution or a typed failure out.
pub trait InterfaceSolver: std::fmt::Debug + Send + Sync {
    /// Name for results.
    fn name(&self) -> &'static str;

    /// Solves `step`.
    ///
    /// # Errors
    /// [`StepFailure`] with the reason of every solver that was tried.
    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure>;

    /// Solves `step` by its cheapest means only: what cut-back calls between the whole increment and the smallest part.
    ///
    /// # Errors
    /// [`StepFailure`], also where [`InterfaceSolver::solve`] would find a solution.
    fn try_quickly(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        self.solve(step)
    }
}
