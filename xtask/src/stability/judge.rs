//! What a method did with a problem, judged by others than itself.

use nalgebra::DVector;
use stickslip_contact::solver::{FailureCause, StepFailure, StepSolution, Stop};
use stickslip_contact::state::TrialState;
use stickslip_laboratory::discrete::Discrete;

use super::methods::{Method, is_too_large};
use super::outcome::{Outcome, regularised};
use super::row::Row;

/// Largest violation of the conditions, by the judge's own measure, of an answer that claims to be verified. Solvers accept
/// 1e-10 of their scales; the judge's may differ by the ratio of old to new forces and motions.
const VERIFIED: f64 = 1e-8;
/// Largest violation of an answer that claims to meet its own tolerance.
const TOLERATED: f64 = 1e-5;
/// Answers closer than this, relative to the largest contact force, are the same.
const SAME: f64 = 1e-5;
/// Answers of one step that are farther apart than this are two solutions; what is nearer may be one that the conditions
/// hardly determine, such as the width of a contact under very little load.
const DIFFERENT: f64 = 1e-3;

/// Lets `method` solve `given` and judges what it says. `answer` is a verified answer, if there is one.
pub(crate) fn judge(method: &Method, given: &Discrete, answer: Option<&TrialState>) -> Row {
    match method.solver.solve(&given.step()) {
        Ok(solution) => judge_solution(method, given, answer, &solution),
        Err(failure) => judge_failure(method, answer, &failure),
    }
}

fn judge_solution(
    method: &Method,
    given: &Discrete,
    answer: Option<&TrialState>,
    solution: &StepSolution,
) -> Row {
    let violation = given.check(&solution.trial);
    let floor = given.committed.forces.amax();
    let error = answer.map(|answer| distance(&solution.trial.forces, &answer.forces, floor));
    let known = given.solutions.as_ref();
    let listed = known.is_none_or(|known| {
        let mut states = known.states.iter();
        !known.complete
            || states.any(|state| distance(&solution.trial.forces, &state.forces, floor) < SAME)
    });
    let (mut outcome, mut note) = conditions_met(solution.stop, violation);
    if solution.stop == Stop::Regularised {
        outcome = regularised(error, violation);
    } else if outcome == Outcome::Solved && !listed && solution.stop == Stop::Verified {
        (outcome, note) = (Outcome::Wrong, "not among all solutions".into());
    } else if outcome == Outcome::Solved && error.is_some_and(|error| error > DIFFERENT) {
        outcome = Outcome::Other;
    }
    Row {
        method: method.name,
        steps: 1,
        outcome,
        error,
        violation: Some(violation),
        work: solution.work,
        note,
        ..Row::default()
    }
}

/// What an answer is by the conditions that it meets, for what it claims to be.
fn conditions_met(stop: Stop, violation: f64) -> (Outcome, String) {
    let limit = match stop {
        Stop::Regularised => return (regularised(None, violation), String::new()),
        Stop::Verified => VERIFIED,
        Stop::Tolerance => TOLERATED,
    };
    if violation <= limit {
        (Outcome::Solved, String::new())
    } else {
        let note = format!("claims a solution that violates the conditions by {violation:.1e}");
        (Outcome::Wrong, note)
    }
}

fn judge_failure(method: &Method, answer: Option<&TrialState>, failure: &StepFailure) -> Row {
    let last = failure.attempts.last().map(|(_, cause)| cause);
    let (outcome, note) = if proves_none(failure) {
        if answer.is_some() {
            (
                Outcome::Wrong,
                "claims a proof, but there is a solution".into(),
            )
        } else {
            (Outcome::Certified, failure.to_string())
        }
    } else if method.is_chain() {
        (Outcome::Unresolved, failure.to_string())
    } else {
        match last {
            Some(FailureCause::Cycled { .. }) => (Outcome::Cycled, failure.to_string()),
            Some(cause) if is_too_large(cause) => (Outcome::NotTried, String::new()),
            _ => (Outcome::Stopped, failure.to_string()),
        }
    };
    Row {
        method: method.name,
        steps: 1,
        outcome,
        violation: failure.best.as_ref().map(|best| best.residuals.largest()),
        work: failure.work,
        note,
        ..Row::default()
    }
}

/// Whether a failure claims that there is no solution.
pub(crate) fn proves_none(failure: &StepFailure) -> bool {
    failure.attempts.iter().any(|(_, cause)| {
        matches!(
            cause,
            FailureCause::Unbalanced { proved: true, .. }
                | FailureCause::NoSolution { proved: true, .. }
        )
    })
}

/// Largest difference of two force vectors over the largest force of the second, or `floor` if that is more: a step without load
/// is measured by what was there before it.
pub(crate) fn distance(forces: &DVector<f64>, answer: &DVector<f64>, floor: f64) -> f64 {
    let scale = answer.amax().max(floor).max(1e-6 * forces.amax());
    let difference = (forces - answer).amax();
    if scale > 0.0 {
        difference / scale
    } else {
        difference
    }
}

/// The row of an answer that is judged by its conditions alone.
pub(crate) fn accepted(method: &Method, solution: &StepSolution, violation: f64) -> Row {
    let (outcome, note) = conditions_met(solution.stop, violation);
    Row {
        method: method.name,
        steps: 1,
        outcome,
        violation: Some(violation),
        work: solution.work,
        note,
        ..Row::default()
    }
}
