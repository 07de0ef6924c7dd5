//! What becomes of a step's solution once it is accepted.

use nalgebra::DVector;

use super::{frictionless, least_motion};
use crate::solver::{Residuals, Step};
use crate::state::{ContactState, Status, TrialState};

/// An accepted increment of load.
#[derive(Clone, Debug)]
pub struct Increment {
    /// Contact at its end.
    pub state: ContactState,
    /// How well the state meets the conditions.
    pub residuals: Residuals,
    /// Work lost to friction at each point `[force·length]`: slip times the mean of the slip forces at both ends.
    pub friction_work: DVector<f64>,
    /// Slip of each point `[length]`, first body against the second along e_t; zero where it did not slip.
    pub slip: DVector<f64>,
}

impl Increment {
    /// Accepts `trial` as the end of `step`: bodies that hang loose take the place to which they move least, histories advance, and points
    /// without friction slip along their motion.
    pub fn accept(step: &Step<'_>, mut trial: TrialState) -> Self {
        least_motion::take(step, &mut trial);
        frictionless::slide(step, &mut trial);
        // Those of the state that is kept, with the statuses that it has now.
        let residuals = Residuals::of(step, &trial);
        let committed = step.committed;
        let mut friction_work = DVector::zeros(trial.status.len());
        let mut slips = friction_work.clone();
        for (k, status) in trial.status.iter().enumerate() {
            if status.slip_sign() != 0.0 {
                let slip = trial.motion[2 * k + 1] - committed.tangential_displacement(k);
                // A sticking point starts to slip at its bound, not at the force it had before; a point that closes or goes on
                // slipping starts at the force it had.
                let end = trial.forces[2 * k + 1];
                let before = committed.status[k];
                let start = if before == *status || before == Status::Open {
                    committed.tangential_force(k)
                } else {
                    end
                };
                friction_work[k] = -f64::midpoint(start, end) * slip;
                slips[k] = slip;
            }
        }
        Self {
            state: committed.advance(trial, step.multipliers()),
            residuals,
            friction_work,
            slip: slips,
        }
    }
}
