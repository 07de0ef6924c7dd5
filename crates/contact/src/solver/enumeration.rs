//! All combinations of statuses, one after the other: slow, and the last word on small problems.
//!
//! Every solution of a step has a status at each of its n points, so 4ⁿ interface solves find it, or prove that there is
//! none where each of them is regular and the law's bound is proportional to pressure.

use super::active_set::settle;
use super::attempt::Attempt;
use super::residual::Scales;
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};
use crate::state::Status;

/// Exhaustive enumeration of statuses, which counts the solutions. Of several it returns the one whose statuses differ at the
/// fewest points from the last accepted ones, and among these the one that has moved least.
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
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl Enumeration {
    fn run(self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        let step = attempt.step;
        let count = step.count();
        if count > self.points {
            return Err(FailureCause::TooManyPoints {
                points: count,
                limit: self.points,
            });
        }
        let mut proved = (0..count).all(|k| step.problem.law(k).is_linear());
        let mut found: Vec<StepSolution> = Vec::new();
        let mut status = vec![Status::Open; count];
        let mut combinations = 0;
        loop {
            combinations += 1;
            match settle(&status, attempt) {
                Ok(solution) => keep(step, &mut found, solution),
                Err(FailureCause::Singular) => proved = false,
                Err(_) => {}
            }
            if !advance(step, &mut status) {
                break;
            }
        }
        let solutions = Some(found.len());
        let nearest = found.into_iter().min_by(|a, b| {
            let (a, b) = (distance(step, a), distance(step, b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        });
        match nearest {
            Some(solution) => Ok(StepSolution {
                solutions,
                ..solution
            }),
            None => Err(FailureCause::NoSolution {
                combinations,
                proved,
            }),
        }
    }
}

/// Adds `solution`. The same forces may be found with several statuses, on the border between them; of these the statuses
/// nearest to the last accepted ones are kept.
fn keep(step: &Step<'_>, found: &mut Vec<StepSolution>, solution: StepSolution) {
    const SAME: f64 = 1e-8;
    let scale = Scales::of(step, &solution.trial.forces, &solution.trial.motion).force;
    let same = |other: &&mut StepSolution| {
        (&other.trial.forces - &solution.trial.forces).amax() <= SAME * scale
    };
    match found.iter_mut().find(same) {
        Some(other) if distance(step, &solution).0 < distance(step, other).0 => *other = solution,
        Some(_) => {}
        None => found.push(solution),
    }
}

/// Number of points whose status is not the last accepted one, and the largest change of motion `[length]` since then.
fn distance(step: &Step<'_>, solution: &StepSolution) -> (usize, f64) {
    let changes = (solution.trial.status.iter())
        .zip(&step.committed.status)
        .filter(|(new, old)| new != old)
        .count();
    let moved = (&solution.trial.motion - &step.committed.motion).amax();
    (changes, moved)
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
