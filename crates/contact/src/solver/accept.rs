//! What counts as met, and which statuses a state has.

use super::step::Step;
use super::{StepFailure, StepSolution, Stop};
use crate::state::{Status, TrialState};

/// Relative size below which a violation is rounding.
pub(super) const ROUNDING: f64 = 1e-12;
/// Largest relative residual of a verified solution.
pub(crate) const ACCEPTED: f64 = 1e-10;

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

/// Number of points of `trial` that stick although a slip at once would be admissible too.
pub(super) fn doubtful(step: &Step<'_>, trial: &TrialState) -> usize {
    (0..step.count())
        .filter(|&k| {
            trial.status[k] == Status::Stick && step.problem.points()[k].slides && {
                let bound = step.bound(k, trial.forces[2 * k], 0.0);
                trial.forces[2 * k + 1].abs() > bound.slip * (1.0 + ROUNDING)
                    && bound.stick > bound.slip
            }
        })
        .count()
}
