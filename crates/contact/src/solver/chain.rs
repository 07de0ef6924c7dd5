//! A solver made of solvers.

use super::balance::impossible;
use super::{
    Enumeration, FailureCause, InterfaceSolver, Pivoting, SemismoothNewton, StatusIteration, Step,
    StepFailure, StepSolution, Work,
};

/// Tries its members in order until one solves the step, or until the load is proved to have no balance. On ordinary steps it costs what its first member costs.
#[derive(Debug)]
pub struct Chain {
    members: Vec<Box<dyn InterfaceSolver>>,
}

impl Chain {
    /// A chain of `members`, the fastest first, the one that always ends last.
    pub fn new(members: Vec<Box<dyn InterfaceSolver>>) -> Self {
        Self { members }
    }

    /// Semismooth Newton, then pivoting, then enumeration of small problems: the default.
    pub fn newton_first() -> Self {
        Self::new(vec![
            Box::new(SemismoothNewton::default()),
            Box::new(Pivoting::default()),
            Box::new(Enumeration::default()),
        ])
    }

    /// The report's status iteration, then as [`Chain::newton_first`].
    pub fn status_first() -> Self {
        Self::new(vec![
            Box::new(StatusIteration::default()),
            Box::new(SemismoothNewton::default()),
            Box::new(Pivoting::default()),
            Box::new(Enumeration::default()),
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
        for member in &self.members {
            match member.solve(step) {
                Ok(mut solution) => {
                    solution.work += failure.work;
                    return Ok(solution);
                }
                Err(next) => {
                    failure.attempts.extend(next.attempts);
                    failure.work += next.work;
                    failure = failure.with_best(next.best);
                    if failure.is_proved_impossible() {
                        break;
                    }
                }
            }
        }
        Err(failure)
    }
}
