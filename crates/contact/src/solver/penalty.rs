//! The penalty method: contact springs of stiffness k at each point,
//!
//! ```text
//! λ_n = k max(0, −g_n);     λ_t = λ_t,last − k Δs  where that is within ±F, else ±F
//! ```
//!
//! (Kikuchi & Oden 1988; with the stick spring at rest under the last accepted shear). In the solver's terms the springs add
//! the compliance 1/k to the bodies' own at each point, so the regularised step is solved exactly, by
//! [`SemismoothNewton`] or [`Pivoting`]. The answer penetrates and creeps by λ/k; its residuals give the amount.

use super::attempt::Attempt;
use super::residual::read_statuses;
use super::step::Step;
use super::{
    FailureCause, InterfaceSolver, Pivoting, Residuals, SemismoothNewton, StepFailure,
    StepSolution, Stop,
};
use crate::state::TrialState;

/// Contact springs of a stiffness that is given relative to the bodies'.
#[derive(Clone, Copy, Debug)]
pub struct Penalty {
    /// Stiffness of the springs, as a multiple of the inverse of the mean compliance of a contact component, > 0 `[1]`. A pressed point penetrates by its force over
    /// that stiffness.
    pub factor: f64,
}

impl Default for Penalty {
    fn default() -> Self {
        Self { factor: 100.0 }
    }
}

impl InterfaceSolver for Penalty {
    fn name(&self) -> &'static str {
        "penalty"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| {
            let mut rest = step.committed.forces.clone();
            for k in 0..step.count() {
                rest[2 * k] = 0.0;
            }
            let soft = step.softened(spring_compliance(step, self.factor), &rest);
            let (trial, residuals) = solve_softened(&soft, attempt)?;
            Ok(attempt.conclude(trial, residuals, Stop::Regularised))
        })
    }
}

/// Compliance `[length/force]` of springs `factor` times as stiff as a mean contact component.
pub(super) fn spring_compliance(step: &Step<'_>, factor: f64) -> f64 {
    step.mean_compliance() / factor.max(f64::MIN_POSITIVE)
}

/// Solves `soft`, the attempt's step with springs, and measures the answer against the step without them.
pub(super) fn solve_softened(
    soft: &Step<'_>,
    attempt: &mut Attempt<'_>,
) -> Result<(TrialState, Residuals), FailureCause> {
    let members: [&dyn InterfaceSolver; 2] = [&SemismoothNewton::default(), &Pivoting::default()];
    let mut last = FailureCause::Limit(0);
    for member in members {
        match member.solve(soft) {
            Ok(solution) => {
                attempt.spend(solution.work);
                let trial = without_springs(attempt.step, solution.trial);
                let residuals = attempt.offer(&trial);
                return Ok((trial, residuals));
            }
            Err(mut failure) => {
                attempt.spend(failure.work);
                if let Some(best) = failure.best.take() {
                    attempt.offer(&without_springs(attempt.step, best.trial));
                }
                if let Some((_, cause)) = failure.attempts.pop() {
                    last = cause;
                }
            }
        }
    }
    Err(last)
}

/// The motion of the bodies alone, and the statuses that it comes closest to.
fn without_springs(step: &Step<'_>, mut trial: TrialState) -> TrialState {
    let motion = step.motion(&trial.forces, &trial.rigid);
    trial.status = read_statuses(step, &trial.forces, &motion);
    trial.motion = step.total_motion(motion);
    trial
}
