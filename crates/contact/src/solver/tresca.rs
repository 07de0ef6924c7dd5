//! The Tresca fixed point (Panagiotopoulos 1975; Nečas, Jarušek & Haslinger 1980): with the friction bounds F given, a step
//! is a convex problem with exactly one solution,
//!
//! ```text
//! min ½ λᵀA λ + λᵀd   over   λ_n ≥ 0,  |λ_t| ≤ F,  Gᵀλ + r = 0
//! ```
//!
//! and its normal forces give the next bounds, F ← F(λ_n). The map contracts for small μ; for large μ it is slow, or runs in
//! circles. Balance is enforced by multipliers: H = A + κ G Gᵀ, and α ← α + κ (Gᵀλ + r) until nothing is left (Hestenes
//! 1969, Powell 1969), so that no trace of κ remains in the answer.

use nalgebra::DVector;

use super::attempt::Attempt;
use super::boxed::Boxed;
use super::residual::read_statuses;
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};
use crate::state::{Status, TrialState};

/// Fixed point of the friction bounds, with an exact solution of the convex problem in each round.
#[derive(Clone, Copy, Debug)]
pub struct TrescaFixedPoint {
    /// Largest number of updates of the bounds.
    pub limit: usize,
    /// Largest relative residual at which it stops `[1]`.
    pub tolerance: f64,
}

impl Default for TrescaFixedPoint {
    fn default() -> Self {
        Self {
            limit: 500,
            tolerance: 1e-10,
        }
    }
}

impl InterfaceSolver for TrescaFixedPoint {
    fn name(&self) -> &'static str {
        "Tresca fixed point"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl TrescaFixedPoint {
    fn run(&self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        /// Updates without a better state after which the iteration counts as stalled.
        const PATIENCE: usize = 60;
        /// Forces that have faded to this part of the first or the last ones are on their way to none, which no relative measure
        /// sees.
        const FADED: f64 = 1e-9;
        let step = attempt.step;
        step.matrix()?;
        let mut convex = Convex::new(step);
        let mut bounds = Bounds::new(step);
        let (mut least, mut since) = (f64::INFINITY, 0);
        let mut largest = step.committed.forces.amax();
        for update in 1..=self.limit {
            attempt.work.updates += 1;
            let (forces, rigid) = convex.solve(attempt, &bounds.values)?;
            let motion = step.motion(&forces, &rigid);
            attempt.work.operations += 2 * (forces.len() * forces.len()) as u64;
            largest = largest.max(forces.amax());
            if forces.amax() <= FADED * largest {
                let released = attempt.released(&rigid);
                if let Ok(solution) = attempt.accept_within(released, self.tolerance) {
                    return Ok(solution);
                }
            }
            let status = read_statuses(step, &forces, &motion);
            bounds.update(step, &forces, &motion, &status);
            let trial = TrialState {
                forces,
                motion: step.total_motion(motion),
                rigid,
                status,
            };
            let residual = attempt.offer(&trial).largest();
            if residual <= self.tolerance {
                return attempt.accept_within(trial, self.tolerance);
            }
            if residual < 0.9 * least {
                (least, since) = (residual, 0);
            } else {
                since += 1;
                if since > PATIENCE {
                    return Err(FailureCause::Limit(update));
                }
            }
        }
        Err(FailureCause::Limit(self.limit))
    }
}

/// The friction bounds of all points.
struct Bounds {
    values: Vec<f64>,
    /// Points that slipped once stay on their slip traction, so that a drop of the traction ends.
    slipped: Vec<bool>,
}

impl Bounds {
    fn new(step: &Step<'_>) -> Self {
        let values = step
            .starting_forces()
            .into_iter()
            .enumerate()
            .map(|(k, force)| step.bound(k, force, 0.0).stick)
            .collect();
        Self {
            values,
            slipped: vec![false; step.count()],
        }
    }

    fn update(
        &mut self,
        step: &Step<'_>,
        forces: &DVector<f64>,
        motion: &DVector<f64>,
        status: &[Status],
    ) {
        for k in 0..self.values.len() {
            self.slipped[k] |= status[k].slip_sign() != 0.0;
            let bound = step.bound(k, forces[2 * k].max(0.0), motion[2 * k + 1]);
            self.values[k] = if self.slipped[k] {
                bound.slip
            } else {
                bound.stick
            };
        }
    }
}

/// The convex problem of given bounds, and the rigid motions of its last solution.
struct Convex {
    problem: Boxed,
    rigid: DVector<f64>,
    /// κ [length/force]·[mode]⁻².
    weight: f64,
}

impl Convex {
    fn new(step: &Step<'_>) -> Self {
        /// κ beside the compliance; each update of α shrinks the imbalance by about as much.
        const WEIGHT: f64 = 1e3;
        let weight = WEIGHT * step.balance_weight();
        let mut matrix = step.soft_compliance();
        let modes = step.problem.modes();
        matrix.gemm(weight, modes, &modes.transpose(), 1.0);
        Self {
            problem: Boxed::new(matrix),
            rigid: step.committed.rigid.clone(),
            weight,
        }
    }

    /// Forces and rigid motions. Bounds that hold no balance leave an imbalance, and the rigid motions as they were.
    fn solve(
        &mut self,
        attempt: &mut Attempt<'_>,
        bounds: &[f64],
    ) -> Result<(DVector<f64>, DVector<f64>), FailureCause> {
        const UPDATES: usize = 40;
        const BALANCED: f64 = 1e-13;
        let step = attempt.step;
        // Without load both the forces and what they leave unbalanced fade.
        let before = step.mode_load.amax().max(step.committed.forces.amax());
        let modes = step.problem.modes();
        let boxes: Vec<[f64; 2]> = (0..2 * step.count())
            .map(|row| match row % 2 {
                0 => [0.0, f64::INFINITY],
                _ if step.problem.points()[row / 2].slides => [-bounds[row / 2], bounds[row / 2]],
                _ => [0.0, 0.0],
            })
            .collect();
        let mut rigid = self.rigid.clone();
        let mut linear = step.free_motion.clone();
        linear.gemv(self.weight, modes, &step.mode_load, 1.0);
        for _ in 0..UPDATES {
            let mut shifted = linear.clone();
            shifted.gemv(1.0, modes, &rigid, 1.0);
            let forces = self.problem.solve(&shifted, &boxes, &mut attempt.work)?;
            let imbalance = step.imbalance(&forces);
            rigid.axpy(self.weight, &imbalance, 1.0);
            if imbalance
                .iter()
                .all(|force| force.abs() <= BALANCED * forces.amax().max(before))
            {
                self.rigid.clone_from(&rigid);
                return Ok((forces, rigid));
            }
        }
        let mut shifted = linear;
        shifted.gemv(1.0, modes, &self.rigid, 1.0);
        let forces = self.problem.solve(&shifted, &boxes, &mut attempt.work)?;
        Ok((forces, self.rigid.clone()))
    }
}
