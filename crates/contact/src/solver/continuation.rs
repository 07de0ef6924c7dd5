//! Continuation: the step is reached from a simpler one, along
//!
//! ```text
//! F = τ F(λ_n)  (friction grows from none)    or    load = (1 − τ) last + τ new  (the load grows),    0 ≤ τ ≤ 1
//! ```
//!
//! with slip counted from the last accepted state throughout. Each τ starts from the statuses of the one before, and the
//! increment of τ is cut where that fails. At τ = 0 the first is a convex problem, and the second is solved by the last accepted state. A
//! path that turns back at a fold (Klarbring 1990) is left by a jump to whatever the solver finds beyond it.

use super::attempt::Attempt;
use super::{FailureCause, InterfaceSolver, SemismoothNewton, Step, StepFailure, StepSolution};
use crate::state::TrialState;

/// Continuation in the friction coefficient, then in the load.
#[derive(Clone, Copy, Debug)]
pub struct Continuation {
    /// Smallest part of the way `[1]`, beyond which a path is given up.
    pub smallest: f64,
    /// Floating-point operations after which no further point of a path is sought.
    pub effort: u64,
}

impl Default for Continuation {
    fn default() -> Self {
        Self {
            smallest: 1.0 / 256.0,
            effort: 100_000_000_000,
        }
    }
}

#[derive(Clone, Copy, Debug)]
enum Path {
    Friction,
    Load,
}

impl InterfaceSolver for Continuation {
    fn name(&self) -> &'static str {
        "continuation"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| {
            let mut last = FailureCause::Limit(0);
            for path in [Path::Friction, Path::Load] {
                match self.follow(path, attempt) {
                    Ok(trial) => return attempt.accept(trial),
                    Err(cause) => last = cause,
                }
            }
            Err(last)
        })
    }
}

impl Continuation {
    /// Follows `path` to its end.
    fn follow(self, path: Path, attempt: &mut Attempt<'_>) -> Result<TrialState, FailureCause> {
        let step = attempt.step;
        let at = |part: f64| match path {
            _ if part >= 1.0 => step.clone(),
            Path::Friction => step.with_friction(part),
            Path::Load => step.with_load(part),
        };
        let mut trial = solve_at(&at(0.0), attempt)?;
        let (mut reached, mut part) = (0.0, 0.25);
        while reached < 1.0 {
            if attempt.work.operations > self.effort {
                return Err(FailureCause::Effort {
                    operations: attempt.work.operations,
                    limit: self.effort,
                });
            }
            let next = if reached + part > 1.0 - 1e-9 {
                1.0
            } else {
                reached + part
            };
            match solve_at(&at(next).near(&trial), attempt) {
                Ok(found) => {
                    (trial, reached) = (found, next);
                    part *= 2.0;
                }
                Err(_) if part > self.smallest => part *= 0.5,
                Err(cause) => return Err(cause),
            }
        }
        Ok(trial)
    }
}

fn solve_at(step: &Step<'_>, attempt: &mut Attempt<'_>) -> Result<TrialState, FailureCause> {
    match SemismoothNewton::default().solve(step) {
        Ok(solution) => {
            attempt.spend(solution.work);
            Ok(solution.trial)
        }
        Err(mut failure) => {
            attempt.spend(failure.work);
            let last = failure.attempts.pop();
            Err(last.map_or(FailureCause::Limit(0), |(_, cause)| cause))
        }
    }
}
