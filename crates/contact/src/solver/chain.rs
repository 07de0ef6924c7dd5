//! A solver made of solvers.

use nalgebra::DVector;

use super::attempt::Attempt;
use super::balance::{clear, impossible};
use super::{
    Continuation, Enumeration, FailureCause, InterfaceSolver, Pivoting, SemismoothNewton,
    StatusIteration, Step, StepFailure, StepSolution, Stop, Unresolved, Work,
};

use crate::state::Status;
use crate::uniqueness::{NEAR_BOUND, uniqueness_bound};

/// Tries its members in order until one solves the step, or until the step is proved to have no solution. On ordinary steps it
/// costs what its first member costs. Where at most six points touch, under friction near or beyond the estimated bound of
/// uniqueness, the statuses of these are enumerated, and the solution nearest to the last accepted state is taken. All its answers
/// are verified: what a member returns unverified counts as a failure.
#[derive(Debug)]
pub struct Chain {
    members: Vec<Box<dyn InterfaceSolver>>,
}

impl Chain {
    /// A chain of `members`, the fastest first, the one that always ends last.
    pub fn new(members: Vec<Box<dyn InterfaceSolver>>) -> Self {
        Self { members }
    }

    /// Semismooth Newton, then pivoting, then enumeration of small problems, then continuation: the default.
    pub fn newton_first() -> Self {
        Self::new(vec![
            Box::new(SemismoothNewton::default()),
            Box::new(Pivoting::default()),
            Box::new(Enumeration::default()),
            Box::new(Continuation::default()),
        ])
    }

    /// `solver` alone, with the proof before the search.
    pub fn alone(solver: Box<dyn InterfaceSolver>) -> Self {
        Self::new(vec![solver])
    }

    /// The report's status iteration, then as [`Chain::newton_first`].
    pub fn status_first() -> Self {
        Self::new(vec![
            Box::new(StatusIteration::default()),
            Box::new(SemismoothNewton::default()),
            Box::new(Pivoting::default()),
            Box::new(Enumeration::default()),
            Box::new(Continuation::default()),
        ])
    }
}

impl Default for Chain {
    fn default() -> Self {
        Self::newton_first()
    }
}

impl InterfaceSolver for Chain {
    fn name(&self) -> &'static str {
        "chain"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Self::solve_by(&self.members, step)
    }

    /// With its first member only.
    fn try_quickly(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Self::solve_by(&self.members[..self.members.len().min(1)], step)
    }
}

impl Chain {
    fn solve_by(
        members: &[Box<dyn InterfaceSolver>],
        step: &Step<'_>,
    ) -> Result<StepSolution, StepFailure> {
        if let Some(solution) = unchanged(step) {
            return Ok(solution);
        }
        let mut failure = StepFailure {
            attempts: Vec::new(),
            work: Work::default(),
            best: None,
        };
        if let Some(cause) = impossible(step) {
            failure.attempts.push(("force balance", cause));
            if !failure.is_unresolved() {
                return Err(failure);
            }
        }
        for (index, member) in members.iter().enumerate() {
            match verified(member.as_ref(), step) {
                Ok(solution) => {
                    return Ok(among_several(step, after(failure, solution)));
                }
                Err(next) => {
                    failure.attempts.extend(next.attempts);
                    failure.work += next.work;
                    failure = failure.with_best(next.best);
                    if !failure.is_unresolved() {
                        return Err(failure);
                    }
                    // Bodies that travel before they touch, or that nothing loads any more: a search among points that close without force may
                    // go round in circles.
                    if index == 0
                        && let Some(solution) = released(step)
                    {
                        return Ok(after(failure, solution));
                    }
                }
            }
        }
        // Solvers that follow a law of unbounded slope at vanishing pressure may miss a release.
        let at_first = || released_at(step, &step.committed.rigid.map(|_| 0.0));
        match released(step).or_else(at_first) {
            Some(solution) => Ok(after(failure, solution)),
            None => Err(failure),
        }
    }
}

/// The answer of `member`, a failure where it is not verified.
fn verified(member: &dyn InterfaceSolver, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
    let solution = member.solve(step)?;
    if solution.stop == Stop::Verified {
        return Ok(solution);
    }
    let StepSolution {
        solver,
        work,
        trial,
        residuals,
        ..
    } = solution;
    let violation = residuals.largest();
    let failure = StepFailure::new(solver, FailureCause::Inaccurate { violation }, work);
    Err(failure.with_best(Some(Box::new(Unresolved {
        solver,
        trial,
        residuals,
    }))))
}

/// The solution nearest to the last accepted state where there may be several and few points touch; `solution` elsewhere, at
/// the cost of looking at its statuses.
fn among_several(step: &Step<'_>, solution: StepSolution) -> StepSolution {
    let enumeration = Enumeration::default();
    if solution.solutions.is_some() {
        return solution;
    }
    let Some(points) = enumeration.candidates(&solution) else {
        return solution;
    };
    let coefficient = step.coefficient_of(&points);
    let mut together = vec![Status::Open; step.count()];
    for &point in &points {
        together[point] = Status::Stick;
    }
    let unique = |status: &[Status]| {
        uniqueness_bound(step.problem, status).is_some_and(|bound| coefficient < NEAR_BOUND * bound)
    };
    let few = |status: &&&Vec<Status>| {
        let touching = status.iter().filter(|status| status.touches()).count();
        (1..=enumeration.points).contains(&touching)
    };
    // Another solution may touch at all of them, or where the last state did.
    let touches = [&solution.trial.status, &step.committed.status, &together];
    let alone = coefficient == 0.0 || touches.iter().filter(few).all(|status| unique(status));
    if alone {
        return solution;
    }
    enumeration.nearest_to_last(step, &points, solution)
}

/// The last accepted state as the solution of a step without change of load: what has been reached stays.
fn unchanged(step: &Step<'_>) -> Option<StepSolution> {
    Attempt::run(step, "no change", |attempt| {
        let trial = attempt.unchanged().ok_or(FailureCause::Limit(0))?;
        attempt.accept(trial)
    })
    .ok()
}

/// `solution`, found after `failure`.
fn after(failure: StepFailure, mut solution: StepSolution) -> StepSolution {
    solution.work += failure.work;
    solution.attempts = failure.attempts;
    solution
}

/// The state without any contact force, with the bodies where they are, or as near to there as they can be without penetration.
pub(crate) fn released(step: &Step<'_>) -> Option<StepSolution> {
    let here = &step.committed.rigid;
    released_at(step, here).or_else(|| released_at(step, &clear(step)?))
}

fn released_at(step: &Step<'_>, rigid: &DVector<f64>) -> Option<StepSolution> {
    Attempt::run(step, "release", |attempt| {
        let trial = attempt.released(rigid);
        attempt.accept(trial)
    })
    .ok()
}
