//! The state that comes nearest to a solution, where there is no other.

use super::accept::doubtful;
use super::step::Step;
use super::{StepFailure, StepSolution, Stop};

/// Largest relative residual of a state that may stand for a solution where there is no other. A single node that touches cannot bear a load whose line misses it by as
/// little as its normal turns, the size of the strains there, and finer nodes can.
const NEARLY: f64 = 1e-5;

/// Whether the best state of `failure` nearly meets the conditions, and nothing proves that there is no solution.
pub(crate) fn is_near(failure: &StepFailure) -> bool {
    let may_be = failure.is_unresolved() && !failure.is_stopped();
    let mut best = failure.best.iter();
    may_be && best.any(|best| best.residuals.largest() <= NEARLY)
}

/// The best state of `failure` as a solution that is not verified, where it nearly meets the conditions.
pub(crate) fn nearly(
    step: &Step<'_>,
    mut failure: StepFailure,
) -> Result<StepSolution, StepFailure> {
    let is_near = is_near(&failure);
    let Some(best) = failure.best.take_if(|_| is_near) else {
        return Err(failure);
    };
    Ok(StepSolution {
        doubtful: doubtful(step, &best.trial),
        trial: best.trial,
        residuals: best.residuals,
        work: failure.work,
        solver: best.solver,
        stop: Stop::Tolerance,
        solutions: None,
        attempts: failure.attempts,
    })
}
