//! Least-index principal pivoting of one step, repeated with new secants of the law.

use super::active_set::{confirm, examine};
use super::attempt::Attempt;
use super::complementarity::Complementarity;
use super::secants::{Secants, softnesses};
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};

/// Least-index principal pivoting; it needs no start. Statuses are confirmed and forces solved as in [`super::Pivoting`].
#[derive(Clone, Copy, Debug)]
pub struct PrincipalPivoting {
    /// Largest number of pivots per complementarity problem, in multiples of its order; no other problem is begun once as many
    /// were made in all.
    pub pivots_per_unknown: usize,
    /// Largest number of repetitions with new secants of the law.
    pub repetitions: usize,
}

impl Default for PrincipalPivoting {
    fn default() -> Self {
        Self {
            pivots_per_unknown: 50,
            repetitions: 20,
        }
    }
}

impl InterfaceSolver for PrincipalPivoting {
    fn name(&self) -> &'static str {
        "principal pivoting"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl PrincipalPivoting {
    fn run(&self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        let step = attempt.step;
        step.matrix()?;
        let mut secants = Secants::new(step);
        let all: Vec<usize> = (0..step.count()).collect();
        let mut last = FailureCause::Limit(0);
        for _ in 0..self.repetitions {
            let coefficients = secants.coefficients(step);
            let mut next = None;
            for &softness in softnesses(step) {
                let rest = step.committed.rigid.map(|_| 0.0);
                let problem = Complementarity::new(step, coefficients.clone(), softness, &rest);
                let conditions = problem.among(&all);
                if attempt.work.pivots > self.pivots_per_unknown * conditions.order() {
                    return Err(last);
                }
                let (candidate, outcome) =
                    conditions.solve_by_least_index(self.pivots_per_unknown, &mut attempt.work);
                match outcome.and_then(|()| confirm(&candidate, attempt)) {
                    Ok(solution) => return Ok(solution),
                    Err(cause) => last = cause,
                }
                next = Some(candidate);
            }
            let Some(candidate) = next else { break };
            secants.advance(&candidate);
            if secants.coefficients(step) == coefficients {
                return examine(&candidate, attempt).map_err(|_| last);
            }
        }
        Err(last)
    }
}
