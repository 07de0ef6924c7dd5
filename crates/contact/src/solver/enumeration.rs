//! Tries all combinations of statuses, one after the other: slow, but exhaustive on small problems.
//!
//! Every solution of a step has a status at each of its n points, so 4ⁿ interface solves find it. A search without result
//! proves that there is no solution only where a body floats (a supported one always has a solution), where the law's bound is proportional
//! to pressure, and where every combination has one solution that misses the conditions by far more than rounding.

use super::active_set::{settle, undetermined};
use super::attempt::Attempt;
use super::residual::Scales;
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};
use crate::state::Status;

/// Relative violation up to which rounding may have made a solution look like none.
const BORDERLINE: f64 = 1e-6;

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
        let all: Vec<usize> = (0..count).collect();
        let mut found = Vec::new();
        let (combinations, settled) = visit(attempt, &all, &mut found);
        let solutions = Some(found.len());
        match nearest(step, found) {
            Some(solution) => Ok(StepSolution {
                solutions,
                ..solution
            }),
            None => Err(FailureCause::NoSolution {
                combinations,
                proved: settled && can_prove(step) && !any_undetermined(step, &all),
            }),
        }
    }

    /// The solution nearest to the last accepted state among `known` and all solutions in which no points touch but `points`, and
    /// how many these are.
    pub(super) fn nearest_to_last(
        self,
        step: &Step<'_>,
        points: &[usize],
        known: StepSolution,
    ) -> StepSolution {
        let searched = Attempt::run(step, self.name(), |attempt| {
            attempt.work = known.work;
            let mut found = vec![known.clone()];
            visit(attempt, points, &mut found);
            let solutions = Some(found.len());
            // There is at least the one that is known.
            let taken = nearest(step, found).unwrap_or_else(|| known.clone());
            let taken = if same(step, &taken, &known) {
                &known
            } else {
                &taken
            };
            Ok(StepSolution {
                solutions,
                attempts: known.attempts.clone(),
                ..taken.clone()
            })
        });
        searched.unwrap_or(known)
    }

    /// The points whose statuses may be enumerated around `known`: all of them, or those that touch in it; `None` where these
    /// are none or too many.
    pub(super) fn candidates(self, known: &StepSolution) -> Option<Vec<usize>> {
        let status = &known.trial.status;
        let few = status.len() <= self.points;
        let points: Vec<usize> = (0..status.len())
            .filter(|&k| few || status[k].touches())
            .collect();
        (1..=self.points).contains(&points.len()).then_some(points)
    }
}

/// Tries every combination of statuses of `points`, all others being open, and adds the solutions to `found`. Returns how many
/// combinations there are, and whether each of those that do not solve the step misses it by more than rounding.
fn visit(
    attempt: &mut Attempt<'_>,
    points: &[usize],
    found: &mut Vec<StepSolution>,
) -> (usize, bool) {
    let step = attempt.step;
    let mut settled = true;
    let mut status = vec![Status::Open; step.count()];
    let mut combinations = 0;
    loop {
        combinations += 1;
        match settle(&status, attempt) {
            Ok(solution) => keep(step, found, solution),
            Err(cause) => settled &= is_clear(&cause),
        }
        if !advance(step, points, &mut status) {
            return (combinations, settled);
        }
    }
}

/// Whether a combination that fails for `cause` fails by more than rounding.
fn is_clear(cause: &FailureCause) -> bool {
    matches!(cause, FailureCause::Inaccurate { violation } if *violation > BORDERLINE)
}

/// Whether the absence of solutions can be a proof at all.
fn can_prove(step: &Step<'_>) -> bool {
    step.problem.modes().ncols() > 0 && (0..step.count()).all(|k| step.problem.law(k).is_linear())
}

/// Whether rounding may have moved the solution of a combination by as much as is borderline.
fn any_undetermined(step: &Step<'_>, points: &[usize]) -> bool {
    let mut status = vec![Status::Open; step.count()];
    loop {
        if undetermined(step, &status, f64::EPSILON / BORDERLINE) {
            return true;
        }
        if !advance(step, points, &mut status) {
            return false;
        }
    }
}

/// Of `found` the solution nearest to the last accepted state, the first of equally near ones.
fn nearest(step: &Step<'_>, found: Vec<StepSolution>) -> Option<StepSolution> {
    found.into_iter().min_by(|a, b| {
        let (a, b) = (distance(step, a), distance(step, b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
    })
}

/// Adds `solution`. The same forces may be found with several statuses, on the border between them; of these the statuses
/// nearest to the last accepted ones are kept.
fn keep(step: &Step<'_>, found: &mut Vec<StepSolution>, solution: StepSolution) {
    match found.iter_mut().find(|other| same(step, other, &solution)) {
        Some(other) if distance(step, &solution).0 < distance(step, other).0 => *other = solution,
        Some(_) => {}
        None => found.push(solution),
    }
}

/// Whether two solutions have the same forces.
fn same(step: &Step<'_>, one: &StepSolution, other: &StepSolution) -> bool {
    const SAME: f64 = 1e-8;
    let scale = Scales::of(step, &other.trial.forces, &other.trial.motion).force;
    (&one.trial.forces - &other.trial.forces).amax() <= SAME * scale
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

/// The next combination of the statuses of `points`, counting with the first one as the lowest digit; false after the last.
fn advance(step: &Step<'_>, points: &[usize], status: &mut [Status]) -> bool {
    for &k in points {
        status[k] = match status[k] {
            Status::Open => Status::Stick,
            Status::Stick if step.problem.points()[k].slides => Status::SlipPositive,
            Status::SlipPositive => Status::SlipNegative,
            Status::Stick | Status::SlipNegative => Status::Open,
        };
        if status[k] != Status::Open {
            return true;
        }
    }
    false
}
