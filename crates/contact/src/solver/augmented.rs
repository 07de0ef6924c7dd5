//! The augmented Lagrangian: contact springs as in [`Penalty`](super::Penalty), at rest under multipliers that take over their
//! forces until the springs are empty,
//!
//! ```text
//! λ_n ← max(0, λ_n − k g_n),     λ_t ← λ_t − k Δs  cut off at ±F(λ_n)
//! ```
//!
//! with the bodies in equilibrium under the new forces (Uzawa's multiplier update: Hestenes 1969, Powell 1969; for friction
//! Alart & Curnier 1991, Simo & Laursen 1992). The answer does not depend on k. The number of updates does: each one shrinks
//! the error by the factor of 1/k to 1/k + a, a being the compliance of the stiffest pattern of contact forces.

use super::attempt::Attempt;
use super::penalty::{solve_softened, spring_compliance};
use super::{FailureCause, InterfaceSolver, Step, StepFailure, StepSolution};

/// Contact springs with multiplier updates.
#[derive(Clone, Copy, Debug)]
pub struct AugmentedLagrangian {
    /// Stiffness of the springs, as a multiple of the inverse of the mean compliance of a contact component `[1]`.
    pub factor: f64,
    /// Largest relative residual at which it stops `[1]`.
    pub tolerance: f64,
    /// Largest number of multiplier updates.
    pub limit: usize,
}

impl Default for AugmentedLagrangian {
    fn default() -> Self {
        Self {
            factor: 100.0,
            tolerance: 1e-10,
            limit: 200,
        }
    }
}

impl InterfaceSolver for AugmentedLagrangian {
    fn name(&self) -> &'static str {
        "augmented Lagrangian"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl AugmentedLagrangian {
    fn run(&self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        let step = attempt.step;
        let softness = spring_compliance(step, self.factor);
        let mut soft = step.softened(softness, &step.committed.forces);
        for _ in 0..self.limit {
            attempt.work.updates += 1;
            let (trial, residuals) = solve_softened(&soft, attempt)?;
            if residuals.largest() <= self.tolerance {
                return attempt.accept_within(trial, self.tolerance);
            }
            soft = step.softened(softness, &trial.forces).near(&trial);
        }
        Err(FailureCause::Limit(self.limit))
    }
}
