//! The last gate of every solver: what does not meet the conditions is no solution.

use super::frozen::Frozen;
use super::step::Step;
use super::{FailureCause, Residuals, StepSolution, Stop, Work};
use crate::state::{Status, TrialState};

/// Relative size below which a violation is rounding.
pub(super) const ROUNDING: f64 = 1e-12;
/// Largest relative residual of an accepted solution.
const ACCEPTED: f64 = 1e-10;

/// Turns a solve with consistent statuses into a solution, if it meets the conditions.
pub(super) fn accept(
    step: &Step<'_>,
    frozen: Frozen,
    status: Vec<Status>,
    solver: &'static str,
    work: Work,
) -> Result<StepSolution, FailureCause> {
    let trial = TrialState {
        forces: frozen.forces,
        motion: step.total_motion(frozen.motion),
        rigid: frozen.rigid,
        status,
    };
    let residuals = Residuals::of(step, &trial);
    let violation = residuals.largest();
    if violation > ACCEPTED || violation.is_nan() {
        return Err(FailureCause::Inaccurate { violation });
    }
    let doubtful = (0..step.count())
        .filter(|&k| {
            trial.status[k] == Status::Stick && step.problem.points()[k].slides && {
                let bound = step.bound(k, trial.forces[2 * k], 0.0);
                trial.forces[2 * k + 1].abs() > bound.slip * (1.0 + ROUNDING)
                    && bound.stick > bound.slip
            }
        })
        .count();
    Ok(StepSolution {
        trial,
        residuals,
        doubtful,
        work,
        solver,
        stop: Stop::Verified,
    })
}
