//! One step of Coulomb-type friction as a linear complementarity problem (Klarbring 1986), solved by pivoting.
//!
//! Pivoting finds the statuses of all points; an active-set iteration from there solves the forces, and corrects statuses
//! that rounding, springs or the law's curvature got wrong. A law that is not proportional to pressure enters by its
//! secant, F ≈ (F(p)/p) λ_n, and the problem is repeated with new secants until that iteration confirms the statuses.
//!
//! Of many points a part is pivoted first, the others being open; those of them that then overlap join it until none does.

use super::active_set::confirm;
use super::attempt::Attempt;
use super::candidate::Candidate;
use super::complementarity::Complementarity;
use super::lemke::pivot_operations;
use super::secants::{Secants, softnesses};
use super::step::Step;
use super::{FailureCause, InterfaceSolver, StepFailure, StepSolution, Work};
use crate::state::Status;

/// Complementary pivoting with covering vectors that exclude rays for supported bodies; it needs no start.
#[derive(Clone, Copy, Debug)]
pub struct Pivoting {
    /// Largest number of pivots per complementarity problem, in multiples of its order; rarely are more than two needed.
    pub pivots_per_unknown: usize,
    /// Floating-point operations after which a step is given up, as far as the complementarity problem that is pivoted had enough: four
    /// pivots per unknown.
    pub effort: u64,
    /// Number of covering vectors that are tried.
    pub covers: usize,
    /// Largest number of repetitions with new secants of the law.
    pub repetitions: usize,
}

impl Default for Pivoting {
    fn default() -> Self {
        Self {
            pivots_per_unknown: 10,
            effort: 20_000_000_000,
            covers: 4,
            repetitions: 20,
        }
    }
}

/// Pivots per unknown with which a complementarity problem that can be solved nearly always is.
const ENOUGH: u64 = 4;

/// Points above which only a part of them is chosen first: a pivot costs their number squared.
const MANY: usize = 256;

/// The points with which the search begins: all of a few, and of many every second, third and so on, with those that may touch.
fn first_chosen(step: &Step<'_>) -> Vec<usize> {
    let stride = step.count().div_ceil(MANY).max(1);
    let status = step.starting_status().into_iter().enumerate();
    let is_chosen = |(k, status): &(usize, Status)| k % stride == 0 || status.touches();
    status.filter(is_chosen).map(|(k, _)| k).collect()
}

/// How often the springs of floating bodies are put at rest.
fn rounds(step: &Step<'_>) -> usize {
    if step.mode_load.is_empty() { 1 } else { 3 }
}

impl InterfaceSolver for Pivoting {
    fn name(&self) -> &'static str {
        "pivoting"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        Attempt::run(step, self.name(), |attempt| self.run(attempt))
    }
}

impl Pivoting {
    fn run(&self, attempt: &mut Attempt<'_>) -> Result<StepSolution, FailureCause> {
        let step = attempt.step;
        step.matrix()?;
        let mut secants = Secants::new(step);
        let mut chosen = first_chosen(step);
        let (mut last, mut ended) = (FailureCause::Ray, FailureCause::Ray);
        for _ in 0..self.repetitions {
            let coefficients = secants.coefficients(step);
            let mut next = None;
            for &softness in softnesses(step) {
                let mut rest = step.committed.rigid.map(|_| 0.0);
                for round in 0..rounds(step) {
                    let problem = Complementarity::new(step, coefficients.clone(), softness, &rest);
                    // Which of several solutions is followed is settled by the first round.
                    let covers = if round == 0 { self.covers } else { 1 };
                    for cover in 0..covers {
                        let candidate =
                            match self.propose(&problem, cover, &mut chosen, &mut attempt.work)? {
                                Ok(candidate) => candidate,
                                Err(cause) => {
                                    ended = cause;
                                    continue;
                                }
                            };
                        match confirm(&candidate, attempt) {
                            Ok(solution) => return Ok(solution),
                            Err(cause) => last = cause,
                        }
                        next = Some(candidate);
                    }
                    match &next {
                        Some(candidate) => rest.clone_from(&candidate.rigid),
                        None => break,
                    }
                }
            }
            let Some(candidate) = next else {
                if chosen.len() == step.count() {
                    return Err(ended);
                }
                // A ray of a part says nothing of all points.
                chosen = (0..step.count()).collect();
                continue;
            };
            secants.advance(&candidate);
            if secants.coefficients(step) == coefficients {
                return Err(last);
            }
        }
        Err(last)
    }

    /// The solution with covering vector number `cover` on the points `chosen`, which get those that it lets overlap until there are none; or why there is none.
    ///
    /// # Errors
    /// [`FailureCause::Effort`] where no pivots are left.
    fn propose(
        &self,
        problem: &Complementarity<'_>,
        cover: usize,
        chosen: &mut Vec<usize>,
        work: &mut Work,
    ) -> Result<Result<Candidate, FailureCause>, FailureCause> {
        loop {
            let conditions = problem.among(chosen);
            let limit = self.pivots_left(conditions.order(), work.operations)?;
            match conditions.solve(cover, limit, work) {
                Ok(candidate) if !candidate.overlapping.is_empty() => {
                    chosen.extend(&candidate.overlapping);
                    chosen.sort_unstable();
                }
                ended => return Ok(ended),
            }
        }
    }

    /// Pivots that a problem of `order` pairs may have after `operations`.
    fn pivots_left(&self, order: usize, operations: u64) -> Result<usize, FailureCause> {
        let each = pivot_operations(order).max(1);
        let limit = self.effort.max(ENOUGH * order as u64 * each);
        let left = (limit.saturating_sub(operations) / each) as usize;
        match left.min(self.pivots_per_unknown * order) {
            0 if order > 0 => Err(FailureCause::Effort { operations, limit }),
            pivots => Ok(pivots),
        }
    }
}
