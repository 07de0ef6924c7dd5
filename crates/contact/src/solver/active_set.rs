//! Solvers that guess the statuses, solve, and correct the guess.

use std::collections::HashMap;

use super::accept::{ACCEPTED, ROUNDING};
use super::attempt::Attempt;
use super::candidate::Candidate;
use super::frozen::{self, Condensed, Frozen, FrozenSystem, SlipLine, solve};
use super::hold::hold;
use super::residual::Scales;
use super::rules::{Change, Rules};
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution};
use crate::state::Status;

/// The status iteration of Post & Reddy (1988, II 2.1): solve with frozen statuses, then correct all of them at once. A
/// penetrating point closes and sticks, a pulled one opens, one loaded beyond its bound slips against the force, one that
/// slips along the force sticks. Fast; it can cycle, and says so.
#[derive(Clone, Copy, Debug)]
pub struct StatusIteration {
    /// Largest number of solves.
    pub limit: usize,
}

impl Default for StatusIteration {
    fn default() -> Self {
        Self { limit: 60 }
    }
}

/// Semismooth Newton method on the projection form of the conditions (Alart & Curnier 1991), written as an active-set
/// iteration: each solve with frozen statuses is a Newton step, and the next statuses follow from its result. A pressed point
/// that penetrates closes, a pulled one opens, a sticking one beyond its bound slips. A point that closes, or slips along its
/// force, sticks if the force that would stop its motion lies within the bound, that force being estimated by the compliance of
/// all touching points together; otherwise it slips (the other way).
///
/// Steps are whole ones: there is no merit function and no line search, and nothing decreases from step to step. What stands
/// in their place are rules against repetition, which may still fail, and then say so:
///
/// - where statuses would repeat, only the changes at least half as bad as the worst are made, up to twelve times; from then on
///   one change at a time, the worst, until statuses repeat once more ([`FailureCause::Cycled`]);
/// - from the first repetition, or from the 30th solve, points that have slipped are held by their slip traction only, not by a
///   larger bound of sticking: of a law that drops, which leaves several answers, that takes one;
/// - a floating body that its statuses leave free is stopped by the open point that its motion closes first, else by the
///   slipping points that it would turn first;
/// - the law is linearised at a normal force that falls by at most a factor of ten per solve.
#[derive(Clone, Copy, Debug)]
pub struct SemismoothNewton {
    /// Largest number of solves.
    pub limit: usize,
}

impl Default for SemismoothNewton {
    fn default() -> Self {
        Self { limit: 200 }
    }
}

impl SemismoothNewton {
    /// The same iteration with its linear problems solved by `system`; `name` is the solver's name in results.
    ///
    /// # Errors
    /// [`StepFailure`] as by [`InterfaceSolver::solve`].
    pub fn solve_with(
        &self,
        step: &Step<'_>,
        system: &dyn FrozenSystem,
        name: &'static str,
    ) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, name, |attempt| {
            let mut iteration = Iteration::new(step, Rules::Projection);
            iteration.system = system;
            iteration.iterate(self.limit, attempt)
        })
    }
}

impl InterfaceSolver for StatusIteration {
    fn name(&self) -> &'static str {
        "status iteration"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| {
            Iteration::new(step, Rules::Report).iterate(self.limit, attempt)
        })
    }
}

impl InterfaceSolver for SemismoothNewton {
    fn name(&self) -> &'static str {
        "semismooth Newton"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| {
            Iteration::new(step, Rules::Projection).iterate(self.limit, attempt)
        })
    }
}

struct Iteration<'a> {
    step: &'a Step<'a>,
    system: &'a dyn FrozenSystem,
    rules: Rules,
    status: Vec<Status>,
    lines: Vec<SlipLine>,
    /// Normal forces at which `lines` touch the law.
    linearised_at: Vec<f64>,
    /// Iteration in which each set of statuses was met.
    seen: HashMap<Vec<Status>, usize>,
    /// Statuses of each iteration, to name the points of a cycle.
    trail: Vec<Vec<Status>>,
    /// Cycles that were broken so far.
    breaks: usize,
    /// Points that lost their bound of sticking: those that slipped since the first break.
    slipped: Vec<bool>,
}

impl<'a> Iteration<'a> {
    fn new(step: &'a Step<'a>, rules: Rules) -> Self {
        let at_rest = vec![0.0; step.count()];
        Self::starting_at(
            step,
            rules,
            step.starting_status(),
            step.starting_forces(),
            &at_rest,
        )
    }

    fn starting_at(
        step: &'a Step<'a>,
        rules: Rules,
        status: Vec<Status>,
        normal: Vec<f64>,
        slip: &[f64],
    ) -> Self {
        let lines = (0..step.count())
            .map(|k| slip_line(step, k, normal[k], slip[k]))
            .collect();
        Self {
            step,
            system: &Condensed,
            rules,
            status,
            lines,
            linearised_at: normal,
            seen: HashMap::new(),
            trail: Vec::new(),
            breaks: 0,
            slipped: vec![false; step.count()],
        }
    }

    fn iterate(
        &mut self,
        limit: usize,
        attempt: &mut Attempt<'_>,
    ) -> Result<StepSolution, FailureCause> {
        for count in 0..limit {
            self.remember_slips(count);
            let work = &mut attempt.work;
            let frozen = self
                .system
                .solve(self.step, &self.status, &self.lines, work)?;
            if let Some(direction) = &frozen.unbalanced {
                let held = hold(self.step, &self.status, &frozen, direction.as_slice())?;
                if !held.is_empty() {
                    let (status, violation) = (Status::Stick, f64::INFINITY);
                    let change = |point| Change {
                        point,
                        status,
                        violation,
                    };
                    self.apply(&held.into_iter().map(change).collect::<Vec<_>>())?;
                    continue;
                }
            }
            let scales = Scales::of(self.step, &frozen.forces, &frozen.motion);
            let (rules, status) = (self.rules, &self.status);
            let changes = rules.changes(self.step, status, &self.slipped, &frozen, scales);
            let settled = self.relinearise(&frozen, scales);
            let trial = attempt.trial(&frozen, &self.status);
            if changes.is_empty() && settled {
                return attempt.accept(trial);
            }
            attempt.offer(&trial);
            if !changes.is_empty() {
                self.apply(&changes)?;
            }
        }
        Err(FailureCause::Limit(limit))
    }

    /// Applies `changes`. Where that would repeat statuses, the report's rules give up; the projection's first apply the
    /// worse half of the changes only and forget what they saw, and after a few such breaks change one point at a time.
    fn apply(&mut self, changes: &[Change]) -> Result<(), FailureCause> {
        const BREAKS: usize = 12;
        self.seen.insert(self.status.clone(), self.trail.len());
        self.trail.push(self.status.clone());
        if self.breaks < BREAKS {
            let next = self.with(changes.iter());
            let Some(&first) = self.seen.get(&next) else {
                self.status = next;
                return Ok(());
            };
            if self.rules == Rules::Report {
                return Err(self.cycle(first));
            }
            self.breaks += 1;
            self.seen.clear();
            self.trail.clear();
            let worst = changes
                .iter()
                .fold(0.0, |worst: f64, change| worst.max(change.violation));
            self.status = self.with(
                changes
                    .iter()
                    .filter(|change| change.violation >= 0.5 * worst),
            );
            return Ok(());
        }
        let worst = changes
            .iter()
            .max_by(|a, b| a.violation.total_cmp(&b.violation));
        let next = self.with(worst.into_iter());
        if let Some(&first) = self.seen.get(&next) {
            return Err(self.cycle(first));
        }
        self.status = next;
        Ok(())
    }

    /// Once the iteration has run in a circle, or long, slipping points lose their bound of sticking for the rest of it.
    fn remember_slips(&mut self, count: usize) {
        const LONG: usize = 30;
        if self.rules == Rules::Projection && (self.breaks > 0 || count > LONG) {
            for (slipped, status) in self.slipped.iter_mut().zip(&self.status) {
                *slipped |= status.slip_sign() != 0.0;
            }
        }
    }

    fn with<'c>(&self, changes: impl Iterator<Item = &'c Change>) -> Vec<Status> {
        let mut next = self.status.clone();
        for change in changes {
            next[change.point] = change.status;
        }
        next
    }

    fn cycle(&self, first: usize) -> FailureCause {
        let repeated = &self.trail[first..];
        let points = (0..self.status.len())
            .filter(|&k| repeated.iter().any(|status| status[k] != repeated[0][k]))
            .collect();
        FailureCause::Cycled {
            period: repeated.len(),
            points,
        }
    }

    /// Linearises the law about the new iterate; returns whether the slip tractions were already met. The force at which it
    /// is linearised falls by steps, because a law may be infinitely steep at zero, where an early iterate often is.
    fn relinearise(&mut self, frozen: &Frozen, scales: Scales) -> bool {
        const FALL: f64 = 0.1;
        let mut settled = true;
        for k in 0..self.status.len() {
            let (force, slip) = (frozen.forces[2 * k].max(0.0), frozen.motion[2 * k + 1]);
            let sign = self.status[k].slip_sign();
            if sign != 0.0 && self.step.problem.points()[k].slides {
                let bound = self.step.bound(k, force, slip).slip;
                settled &=
                    (frozen.forces[2 * k + 1] + sign * bound).abs() <= ROUNDING * scales.force;
            }
            if self.status[k].touches() {
                self.linearised_at[k] = force.max(FALL * self.linearised_at[k]);
                self.lines[k] = slip_line(self.step, k, self.linearised_at[k], slip);
            }
        }
        settled
    }
}

/// Confirms the statuses of a `candidate` that is exact up to rounding or springs, correcting them where they are not; where ties send the correction round, as they are.
pub(super) fn confirm(
    candidate: &Candidate,
    attempt: &mut Attempt<'_>,
) -> Result<StepSolution, FailureCause> {
    const LIMIT: usize = 30;
    let (status, normal) = (candidate.status.clone(), candidate.normal.clone());
    let step = attempt.step;
    Iteration::starting_at(step, Rules::Projection, status, normal, &candidate.slip)
        .iterate(LIMIT, attempt)
        .or_else(|cause| examine(candidate, attempt).map_err(|_| cause))
}

/// The state with the statuses of `candidate`, which is not expected to be a solution but may be.
pub(super) fn examine(
    candidate: &Candidate,
    attempt: &mut Attempt<'_>,
) -> Result<StepSolution, FailureCause> {
    let step = attempt.step;
    let lines: Vec<SlipLine> = (0..step.count())
        .map(|k| slip_line(step, k, candidate.normal[k], candidate.slip[k]))
        .collect();
    let frozen = solve(step, &candidate.status, &lines, &mut attempt.work)?;
    let trial = attempt.trial(&frozen, &candidate.status);
    attempt.accept(trial)
}

/// Whether rounding may move the solution with these statuses by `f64::EPSILON / tolerance` of itself, under laws that are
/// linear.
pub(super) fn undetermined(step: &Step<'_>, status: &[Status], tolerance: f64) -> bool {
    let normal = step.starting_forces();
    let lines: Vec<SlipLine> = (0..step.count())
        .map(|k| slip_line(step, k, normal[k], 0.0))
        .collect();
    frozen::undetermined(step, status, &lines, tolerance)
}

/// Solves with these statuses, changing only where the law is linearised.
pub(super) fn settle(
    status: &[Status],
    attempt: &mut Attempt<'_>,
) -> Result<StepSolution, FailureCause> {
    const LIMIT: usize = 20;
    let step = attempt.step;
    let mut iteration = Iteration::new(step, Rules::Projection);
    iteration.status = status.to_vec();
    let linear = (0..step.count()).all(|k| step.problem.law(k).is_linear());
    for _ in 0..LIMIT {
        let frozen = solve(step, &iteration.status, &iteration.lines, &mut attempt.work)?;
        let scales = Scales::of(step, &frozen.forces, &frozen.motion);
        if let Some(direction) = &frozen.unbalanced {
            let violation = direction.amax() / scales.force;
            if violation > ACCEPTED {
                return Err(FailureCause::Inaccurate { violation });
            }
        }
        if linear || iteration.relinearise(&frozen, scales) {
            return attempt.accept(attempt.trial(&frozen, &iteration.status));
        }
    }
    Err(FailureCause::Limit(LIMIT))
}

/// Linearises the slip traction of `point` about a normal force and a slip increment.
pub(super) fn slip_line(step: &Step<'_>, point: usize, normal: f64, slip: f64) -> SlipLine {
    let bound = step.bound(point, normal, slip);
    SlipLine {
        constant: bound.slip - bound.slip_dp * normal - bound.slip_ds * slip.abs(),
        normal: bound.slip_dp,
        slip: bound.slip_ds,
    }
}
