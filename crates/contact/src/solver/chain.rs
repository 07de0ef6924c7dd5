//! A solver made of solvers.

use super::attempt::Attempt;
use super::balance::impossible;
use super::{
    Continuation, Enumeration, FailureCause, InterfaceSolver, Pivoting, SemismoothNewton,
    StatusIteration, Step, StepFailure, StepSolution, Work,
};

/// Tries its members in order until one solves the step, or until the step is proved to have no solution. On ordinary steps it
/// costs what its first member costs.
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
        if let Some(motion) = impossible(step) {
            let motion = motion.as_slice().to_vec();
            let proof = FailureCause::Unbalanced {
                motion,
                proved: true,
            };
            failure.attempts.push(("force balance", proof));
            return Err(failure);
        }
        for member in members {
            match member.solve(step) {
                Ok(mut solution) => {
                    solution.work += failure.work;
                    return Ok(solution);
                }
                Err(next) => {
                    failure.attempts.extend(next.attempts);
                    failure.work += next.work;
                    failure = failure.with_best(next.best);
                    if !failure.is_unresolved() {
                        return Err(failure);
                    }
                }
            }
        }
        released(step).ok_or(failure)
    }
}

/// The last accepted state as the solution of a step without change of load: what has been reached stays.
fn unchanged(step: &Step<'_>) -> Option<StepSolution> {
    Attempt::run(step, "no change", |attempt| {
        let trial = attempt.unchanged().ok_or(FailureCause::Limit(0))?;
        attempt.accept(trial)
    })
    .ok()
}

/// The state without any contact force, with the bodies where they are or where they were at first. Solvers that follow
/// a law of unbounded slope at vanishing pressure may miss it.
fn released(step: &Step<'_>) -> Option<StepSolution> {
    let places = [
        step.committed.rigid.clone(),
        step.committed.rigid.map(|_| 0.0),
    ];
    places.iter().find_map(|rigid| {
        Attempt::run(step, "release", |attempt| {
            let trial = attempt.released(rigid);
            attempt.accept(trial)
        })
        .ok()
    })
}
