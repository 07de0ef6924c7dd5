//! All combinations of statuses, one after the other: slow, and the last word on small problems.
//!
//! Every solution of a step has a status at each of its n points, so 4ⁿ interface solves find it, or prove that there is
//! none where each of them is regular and the law's bound is proportional to pressure.

use super::active_set::settle;
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution, Work};
use crate::state::Status;

/// Exhaustive enumeration of statuses. Of several solutions it returns the one whose statuses differ at the fewest points
/// from the committed ones.
#[derive(Clone, Copy, Debug)]
pub struct Enumeration {
    /// Largest number of points; at 6 it is 4096 small solves.
    pub points: usize,
}

impl Default for Enumeration {
    fn default() -> Self {
        Self { points: 6 }
    }
}

impl InterfaceSolver for Enumeration {
    fn name(&self) -> &'static str {
        "enumeration"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut work = Work::default();
        self.run(step, &mut work)
            .map_err(|cause| StepFailure::new(self.name(), cause, work))
    }
}

impl Enumeration {
    fn run(self, step: &Step<'_>, work: &mut Work) -> Result<StepSolution, FailureCause> {
        let count = step.count();
        if count > self.points {
            return Err(FailureCause::TooManyPoints {
                points: count,
                limit: self.points,
            });
        }
        let mut proved = (0..count).all(|k| step.problem.law(k).is_linear());
        let mut nearest: Option<(usize, StepSolution)> = None;
        let mut status = vec![Status::Open; count];
        let mut combinations = 0;
        loop {
            combinations += 1;
            match settle(step, &status, self.name(), work) {
                Ok(solution) => {
                    let changes = (0..count)
                        .filter(|&k| status[k] != step.committed.status[k])
                        .count();
                    if nearest.as_ref().is_none_or(|(fewest, _)| changes < *fewest) {
                        nearest = Some((changes, solution));
                    }
                }
                Err(FailureCause::Singular) => proved = false,
                Err(_) => {}
            }
            if !advance(step, &mut status) {
                break;
            }
        }
        match nearest {
            Some((_, solution)) => Ok(StepSolution {
                work: *work,
                ..solution
            }),
            None => Err(FailureCause::NoSolution {
                combinations,
                proved,
            }),
        }
    }
}

/// The next combination, counting with the first point as the lowest digit; false after the last one.
fn advance(step: &Step<'_>, status: &mut [Status]) -> bool {
    for (k, status) in status.iter_mut().enumerate() {
        *status = match *status {
            Status::Open => Status::Stick,
            Status::Stick if step.problem.points()[k].slides => Status::SlipPositive,
            Status::SlipPositive => Status::SlipNegative,
            Status::Stick | Status::SlipNegative => Status::Open,
        };
        if *status != Status::Open {
            return true;
        }
    }
    false
}
