//! What every solver is, and what it returns.

use super::Step;
use crate::failure::{FailureCause, Residuals, StepFailure, Work};
use crate::state::TrialState;

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
    /// Why it stopped. Only solvers that are declared [`experimental`](super::SolverInfo::experimental) return other than verified solutions, and
    /// a [`Chain`](super::Chain) takes no such solution of a member.
    pub stop: Stop,
    /// Number of distinct solutions of the step, where the statuses of the points that touch in it were enumerated (of all
    /// points, where these are few enough); this one is the nearest to the last accepted state.
    pub solutions: Option<usize>,
    /// Solvers that were tried before it, each with its reason.
    pub attempts: Vec<(&'static str, FailureCause)>,
}
