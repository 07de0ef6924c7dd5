//! What counts as met, and which statuses a state has.

use super::step::Step;
use crate::state::{Status, TrialState};

/// Relative size below which a violation is rounding.
pub(super) const ROUNDING: f64 = 1e-12;
/// Largest relative residual of a verified solution.
pub(crate) const ACCEPTED: f64 = 1e-10;

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
