//! One solver at work on one step: what it spent, and the best state that it has seen.

use nalgebra::DVector;

use super::accept::ACCEPTED;
use super::frozen::Frozen;
use super::step::Step;
use super::{FailureCause, Residuals, StepFailure, StepSolution, Stop, Unresolved, Work};
use crate::state::{Status, TrialState};

/// Forces that have fallen to this part of the last accepted ones are rounding.
const FADED: f64 = 1e-13;

/// The solver, its step, its work so far, and the state that met the conditions best.
#[derive(Debug)]
pub(super) struct Attempt<'a> {
    pub(super) step: &'a Step<'a>,
    name: &'static str,
    pub(super) work: Work,
    best: Option<Box<Unresolved>>,
}

impl<'a> Attempt<'a> {
    /// Lets `run` solve `step` under the name `name`, and completes what it returns.
    pub(super) fn run(
        step: &'a Step<'a>,
        name: &'static str,
        run: impl FnOnce(&mut Self) -> Result<StepSolution, FailureCause>,
    ) -> Result<StepSolution, StepFailure> {
        let mut attempt = Self {
            step,
            name,
            work: Work::default(),
            best: None,
        };
        match run(&mut attempt) {
            Ok(solution) => Ok(StepSolution {
                work: attempt.work,
                ..solution
            }),
            Err(cause) => Err(StepFailure::new(name, cause, attempt.work).with_best(attempt.best)),
        }
    }

    /// The state of a solve with frozen statuses.
    pub(super) fn trial(&self, frozen: &Frozen, status: &[Status]) -> TrialState {
        TrialState {
            forces: frozen.forces.clone(),
            motion: self.step.total_motion(frozen.motion.clone()),
            rigid: frozen.rigid.clone(),
            status: status.to_vec(),
        }
    }

    /// Remembers `trial` if it is the best so far, and returns how well it meets the conditions.
    pub(super) fn offer(&mut self, trial: &TrialState) -> Residuals {
        let residuals = Residuals::of(self.step, trial);
        let size = residuals.largest();
        if size.is_finite()
            && self
                .best
                .as_ref()
                .is_none_or(|best| size < best.residuals.largest())
        {
            let trial = trial.clone();
            self.best = Some(Box::new(Unresolved {
                solver: self.name,
                trial,
                residuals,
            }));
        }
        residuals
    }

    /// Turns `trial` into a solution if it meets the conditions to 1e-10 of their scales. Where all that is left of the last
    /// forces is rounding, and no forces are needed, forces and slip are zero.
    pub(super) fn accept(&mut self, trial: TrialState) -> Result<StepSolution, FailureCause> {
        let rounding = FADED * self.step.committed.forces.amax();
        let negligible = trial.forces.amax() <= rounding && self.step.mode_load.amax() <= rounding;
        let slips = || trial.status.iter().any(|status| status.slip_sign() != 0.0);
        if negligible && (trial.forces.amax() > 0.0 || slips()) {
            let released = self.released(&trial.rigid);
            if let Ok(solution) = self.accept_within(released, ACCEPTED) {
                return Ok(solution);
            }
        }
        self.accept_within(trial, ACCEPTED)
    }

    /// The state without contact forces, with the rigid motions `rigid`.
    pub(super) fn released(&self, rigid: &DVector<f64>) -> TrialState {
        let forces = DVector::zeros(2 * self.step.count());
        let motion = self.step.motion(&forces, rigid);
        TrialState {
            // Points that close without force neither stick nor slip.
            status: vec![Status::Open; self.step.count()],
            motion: self.step.total_motion(motion),
            rigid: rigid.clone(),
            forces,
        }
    }

    /// The last accepted state, if the load has not changed since.
    pub(super) fn unchanged(&self) -> Option<TrialState> {
        let (step, committed) = (self.step, self.step.committed);
        let still = step.with_load(0.0);
        if still.free_motion != step.free_motion || still.mode_load != step.mode_load {
            return None;
        }
        let resting = |status: &Status| match status {
            Status::Open => Status::Open,
            _ => Status::Stick,
        };
        let motion = step.motion(&committed.forces, &committed.rigid);
        Some(TrialState {
            forces: committed.forces.clone(),
            motion: step.total_motion(motion),
            rigid: committed.rigid.clone(),
            status: committed.status.iter().map(resting).collect(),
        })
    }

    /// Turns `trial` into a solution if it meets the conditions to `tolerance` of their scales.
    pub(super) fn accept_within(
        &mut self,
        trial: TrialState,
        tolerance: f64,
    ) -> Result<StepSolution, FailureCause> {
        let residuals = self.offer(&trial);
        let violation = residuals.largest();
        if violation > tolerance || violation.is_nan() {
            return Err(FailureCause::Inaccurate { violation });
        }
        let stop = if violation <= ACCEPTED {
            Stop::Verified
        } else {
            Stop::Tolerance
        };
        Ok(self.conclude(trial, residuals, stop))
    }

    /// The solution `trial`, of which `residuals` and `stop` say what it is worth.
    pub(super) fn conclude(
        &self,
        trial: TrialState,
        residuals: Residuals,
        stop: Stop,
    ) -> StepSolution {
        StepSolution {
            doubtful: super::accept::doubtful(self.step, &trial),
            trial,
            residuals,
            work: self.work,
            solver: self.name,
            stop,
            solutions: None,
            attempts: Vec::new(),
        }
    }

    /// Takes over what another solver spent on a relative of this step.
    pub(super) fn spend(&mut self, work: Work) {
        self.work += work;
    }
}
