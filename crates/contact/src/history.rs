//! Load histories: from one load step to the next by sub-steps, cut back where a solver fails. The parts of an [`Interface`] walk each
//! step side by side and are cut back each for itself; a history ends where the first of them does.

mod frictionless;
mod increment;
mod merged;
mod otherwise;
mod recovery;
mod travel;

use nalgebra::DVector;
use rayon::prelude::*;

use crate::audit::{Audit, LargestScales};
use crate::error::ContactError;
use crate::freedom::{loose_pairs, sliding_pairs};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::{FailureCause, InterfaceSolver, Residuals, Step, StepFailure, Work};
use crate::state::ContactState;
use crate::uniqueness::uniqueness_bound;

pub use increment::Increment;
pub use otherwise::{Difference, Missing, Otherwise};
pub use recovery::{Cycle, FailedAttempts, Recovery};
use travel::parts;
pub use travel::travelled;

/// How the load grows within the first load step, from nothing; later steps are always linear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ramp {
    /// In equal increments.
    #[default]
    Linear,
    /// P_k = P (k/n)²: finer where contact spreads fastest.
    Quadratic,
}

/// Load steps and how they are walked.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadHistory {
    steps: Vec<Vec<f64>>,
    substeps: usize,
    ramp: Ramp,
}

/// Smallest part of an increment to which cut-back goes.
const SMALLEST_PART: f64 = 1.0 / 1024.0;
/// Floating-point operations that failed attempts at a sub-step may cost before it is cut back no further, or twice those of the dearest
/// attempt where that is more.
const CUTBACK_EFFORT: u64 = 20_000_000_000;

impl LoadHistory {
    /// A history with `steps[k]` the multipliers of all load cases at the end of step `k`.
    ///
    /// # Errors
    /// [`ContactError::InvalidLoad`] if steps differ in length, a multiplier is not finite, or `substeps` is zero.
    pub fn new(steps: Vec<Vec<f64>>, substeps: usize, ramp: Ramp) -> Result<Self, ContactError> {
        if substeps == 0 {
            return Err(ContactError::InvalidLoad {
                step: 0,
                what: "0 sub-steps; at least 1 is needed".into(),
            });
        }
        let cases = steps.first().map_or(0, Vec::len);
        for (step, multipliers) in steps.iter().enumerate() {
            if multipliers.len() != cases {
                let what = format!(
                    "{} multipliers where the first step has {cases}",
                    multipliers.len()
                );
                return Err(ContactError::InvalidLoad { step, what });
            }
            if let Some(value) = multipliers.iter().find(|value| !value.is_finite()) {
                return Err(ContactError::InvalidLoad {
                    step,
                    what: format!("the multiplier {value} is not finite"),
                });
            }
        }
        Ok(Self {
            steps,
            substeps,
            ramp,
        })
    }

    /// Multipliers at the end of each step.
    pub fn steps(&self) -> &[Vec<f64>] {
        &self.steps
    }

    /// The history of the first `count` steps, all of them where there are fewer.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        Self {
            steps: self.steps[..count.min(self.steps.len())].to_vec(),
            ..*self
        }
    }

    /// Walks the history of one problem with `solver`; `observe` sees each record as soon as its step is accepted.
    ///
    /// # Errors
    /// [`ContactError::InvalidLoad`] if the problem has another number of load cases; [`ContactError::StepFailed`] with
    /// the step and the reasons of all solvers. Steps accepted before are in what `observe` saw.
    pub fn follow(
        &self,
        problem: &InterfaceProblem,
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(&StepRecord),
    ) -> Result<Vec<StepRecord>, ContactError> {
        let observe = |records: &[StepRecord]| records.iter().for_each(&mut observe);
        let steps = self.follow_all(&[problem], solver, observe);
        let steps = steps.map_err(|ended| *ended.error)?;
        Ok(steps.into_iter().flatten().collect())
    }

    /// Walks the history of all parts of `interface` with `solver`, one record of the whole for each step; `observe` is called as soon
    /// as a step is accepted. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// As [`follow`](Self::follow), for the part that comes to its end first, with its bodies.
    pub fn follow_parts(
        &self,
        interface: &Interface,
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(),
    ) -> Result<Vec<StepRecord>, ContactError> {
        let problems: Vec<&InterfaceProblem> =
            interface.parts().iter().map(Part::problem).collect();
        let steps = self.follow_all(&problems, solver, |_| observe());
        let steps = steps.map_err(|ended| interface.ended(ended.part, *ended.error))?;
        Ok(steps
            .into_iter()
            .map(|records| interface.merged(records))
            .collect())
    }

    /// The records of each step, one for each of `problems`; or the problem that comes to its end first, and why.
    fn follow_all(
        &self,
        problems: &[&InterfaceProblem],
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(&[StepRecord]),
    ) -> Result<Vec<Vec<StepRecord>>, Ended> {
        let unloaded: Vec<ContactState> = problems
            .iter()
            .map(|problem| ContactState::unloaded(problem))
            .collect();
        let mut scales = vec![LargestScales::default(); problems.len()];
        let mut steps: Vec<Vec<StepRecord>> = Vec::with_capacity(self.steps.len());
        for (index, target) in self.steps.iter().enumerate() {
            let last = steps.last();
            let walked = each(problems, |part, problem| {
                let start = last.map_or(&unloaded[part], |records| &records[part].state);
                self.walk(problem, solver, start, index, target)
            });
            let mut records = all_or_first_end(walked)?;
            for (record, scales) in records.iter_mut().zip(&mut scales) {
                scales.add(&mut record.audit);
            }
            observe(&records);
            steps.push(records);
        }
        for records in &mut steps {
            for (record, scales) in records.iter_mut().zip(&scales) {
                scales.measure(&mut record.audit);
            }
        }
        let bounds = each(problems, |part, problem| {
            estimate_uniqueness(problem, steps.iter().map(|records| &records[part]))
        });
        for (part, bound) in bounds.into_iter().enumerate() {
            if let Some((step, bound)) = bound {
                steps[step][part].uniqueness = bound;
            }
        }
        Ok(steps)
    }

    /// Fraction of a step's increment that is applied after the part `k` of it.
    fn fraction(&self, index: usize, part: f64) -> f64 {
        if index == 0 && self.ramp == Ramp::Quadratic {
            part * part
        } else {
            part
        }
    }

    /// Load multipliers after the part `part` of load step `index` from `start` to `target`.
    fn multipliers(
        &self,
        index: usize,
        start: &ContactState,
        target: &[f64],
        part: f64,
    ) -> Vec<f64> {
        let fraction = if part >= 1.0 {
            1.0
        } else {
            self.fraction(index, part)
        };
        // Exact at both ends, unlike from + fraction (to − from).
        let ends = start.multipliers.iter().zip(target);
        ends.map(|(from, to)| (1.0 - fraction) * from + fraction * to)
            .collect()
    }

    fn walk(
        &self,
        problem: &InterfaceProblem,
        solver: &dyn InterfaceSolver,
        start: &ContactState,
        index: usize,
        target: &[f64],
    ) -> Result<StepRecord, ContactError> {
        if target.len() != problem.load_cases() {
            let (given, cases) = (target.len(), problem.load_cases());
            let what = format!("{given} multipliers for {cases} load cases");
            return Err(ContactError::InvalidLoad { step: index, what });
        }
        let mut walk = Walk::new(start.clone());
        let whole = 1.0 / self.substeps as f64;
        for substep in 0..self.substeps {
            let (mut reached, end) = (substep as f64 * whole, (substep + 1) as f64 * whole);
            let mut part = end - reached;
            (walk.failed, walk.dearest) = (0, 0);
            while reached < end {
                let next = if end - reached <= part * (1.0 + 1e-9) {
                    end
                } else {
                    reached + part
                };
                let multipliers = self.multipliers(index, start, target, next);
                // Whether a step has a solution is asked of the whole solver at both ends of cut-back, not on the way.
                let quickly = part < 0.999 * whole && part > whole * SMALLEST_PART;
                match walk.advance(problem, solver, quickly, &multipliers) {
                    Ok(()) => reached = next,
                    // Also where a balance is proved impossible: the history then ends at the largest load that has one.
                    Err(cause) if part > whole * SMALLEST_PART && walk.may_cut_back(&cause) => {
                        walk.work += cause.work;
                        walk.recovery.add(&cause.attempts);
                        walk.cutbacks += 1;
                        part *= 0.5;
                    }
                    Err(mut cause) => {
                        cause.attempts.extend(walk.given_up());
                        return Err(ContactError::StepFailed {
                            step: index,
                            reached,
                            bodies: Vec::new(),
                            cause: Box::new(cause),
                        });
                    }
                }
            }
        }
        Ok(walk.finish(problem))
    }
}

/// `of` each of `problems` with its number, side by side where there are several.
fn each<T: Send>(
    problems: &[&InterfaceProblem],
    of: impl Fn(usize, &InterfaceProblem) -> T + Sync,
) -> Vec<T> {
    match problems {
        [only] => vec![of(0, only)],
        _ => problems
            .par_iter()
            .enumerate()
            .map(|(part, problem)| of(part, problem))
            .collect(),
    }
}

/// Where a history ends before its last step.
struct Ended {
    /// Number of the problem.
    part: usize,
    error: Box<ContactError>,
}

/// All records, or the part that reached least of the step, one with a proof before others.
fn all_or_first_end(
    walked: Vec<Result<StepRecord, ContactError>>,
) -> Result<Vec<StepRecord>, Ended> {
    let key = |error: &ContactError| match error {
        ContactError::StepFailed { reached, cause, .. } => (*reached, cause.is_unresolved()),
        _ => (-1.0, false),
    };
    let mut records = Vec::with_capacity(walked.len());
    let mut end: Option<Ended> = None;
    for (part, outcome) in walked.into_iter().enumerate() {
        match outcome {
            Ok(record) => records.push(record),
            Err(error) => {
                let first = |other: &Ended| key(&error) < key(&other.error);
                if end.as_ref().is_none_or(first) {
                    let error = Box::new(error);
                    end = Some(Ended { part, error });
                }
            }
        }
    }
    end.map_or(Ok(records), Err)
}

/// The step in which most points touch, the last of equal ones, and its estimated bound of uniqueness: it costs more than an
/// interface solve, and tells nothing new of fewer points under the same law.
fn estimate_uniqueness<'a>(
    problem: &InterfaceProblem,
    records: impl Iterator<Item = &'a StepRecord>,
) -> Option<(usize, Option<f64>)> {
    let touching = |(_, record): &(usize, &StepRecord)| {
        let status = record.state.status.iter();
        status.filter(|status| status.touches()).count()
    };
    let (step, record) = records.enumerate().max_by_key(touching)?;
    Some((step, uniqueness_bound(problem, &record.state.status)))
}

/// The increments of one load step as they are accepted.
struct Walk {
    state: ContactState,
    work: Work,
    residuals: Residuals,
    doubtful: usize,
    solvers: Vec<&'static str>,
    recovery: Recovery,
    solutions: Option<usize>,
    loose: Vec<usize>,
    sliding: Vec<usize>,
    parted: bool,
    coefficient: f64,
    increments: usize,
    cutbacks: usize,
    dissipation: f64,
    slip: DVector<f64>,
    /// Operations of failed attempts at the sub-step, and of the dearest of them.
    failed: u64,
    dearest: u64,
}

impl Walk {
    fn new(state: ContactState) -> Self {
        Self {
            slip: DVector::zeros(state.status.len()),
            state,
            work: Work::default(),
            residuals: Residuals::default(),
            doubtful: 0,
            solvers: Vec::new(),
            recovery: Recovery::default(),
            solutions: None,
            loose: Vec::new(),
            sliding: Vec::new(),
            parted: false,
            coefficient: 0.0,
            increments: 0,
            cutbacks: 0,
            dissipation: 0.0,
            failed: 0,
            dearest: 0,
        }
    }

    /// Counts the attempt that failed with `cause`; whether cut-back may go on after it.
    fn may_cut_back(&mut self, cause: &StepFailure) -> bool {
        self.failed += cause.work.operations;
        self.dearest = self.dearest.max(cause.work.operations);
        self.failed <= self.effort()
    }

    /// Operations that failed attempts may cost.
    fn effort(&self) -> u64 {
        CUTBACK_EFFORT.max(2 * self.dearest)
    }

    /// What ended cut-back before it came to its smallest part, if that was its work.
    fn given_up(&self) -> Option<(&'static str, FailureCause)> {
        let limit = self.effort();
        (self.failed > limit).then_some((
            "cut-back",
            FailureCause::Effort {
                operations: self.failed,
                limit,
            },
        ))
    }

    fn advance(
        &mut self,
        problem: &InterfaceProblem,
        solver: &dyn InterfaceSolver,
        quickly: bool,
        multipliers: &[f64],
    ) -> Result<(), StepFailure> {
        let ends = [&*self.state.multipliers, multipliers];
        let travelled = travelled(problem, &self.state, ends);
        let start = travelled.as_ref().unwrap_or(&self.state);
        let step = Step::new(problem, start, multipliers);
        let solution = if quickly {
            solver.try_quickly(&step)?
        } else {
            solver.solve(&step)?
        };
        self.parted |= parts(&start.forces, &solution.trial.forces);
        self.coefficient = step.largest_coefficient(&solution.trial);
        let increment = Increment::accept(&step, solution.trial);
        self.work += solution.work;
        let residuals = increment.residuals;
        self.residuals = self.residuals.worse(residuals);
        self.doubtful = self.doubtful.max(solution.doubtful);
        if !self.solvers.contains(&solution.solver) {
            self.solvers.push(solution.solver);
        }
        self.recovery.add(&solution.attempts);
        self.solutions = self.solutions.max(solution.solutions);
        self.increments += 1;
        self.dissipation += increment.dissipation;
        let (state, slip) = (increment.state, increment.slip);
        self.loose.extend(loose_pairs(problem, &state));
        let sliding = sliding_pairs(problem, start, &state, &slip);
        self.sliding.extend(sliding);
        self.slip += slip;
        self.state = state;
        Ok(())
    }

    fn finish(mut self, problem: &InterfaceProblem) -> StepRecord {
        for pairs in [&mut self.loose, &mut self.sliding] {
            pairs.sort_unstable();
            pairs.dedup();
        }
        StepRecord {
            audit: Audit::of(problem, &self.state),
            work: self.work,
            residuals: self.residuals,
            doubtful: self.doubtful,
            solvers: self.solvers,
            recovery: self.recovery,
            solutions: self.solutions,
            loose: self.loose,
            sliding: self.sliding,
            parted: self.parted,
            coefficient: self.coefficient,
            uniqueness: None,
            increments: self.increments,
            cutbacks: self.cutbacks,
            dissipation: self.dissipation,
            slip: self.slip,
            state: self.state,
            parts: Vec::new(),
        }
    }
}

/// One accepted load step, of one problem or of all parts of an [`Interface`].
#[derive(Clone, Debug)]
pub struct StepRecord {
    /// Contact at its end.
    pub state: ContactState,
    /// Work of all its increments, failed attempts included.
    pub work: Work,
    /// Largest residuals of its increments.
    pub residuals: Residuals,
    /// Largest number of points in doubt in an increment.
    pub doubtful: usize,
    /// Solvers that found its increments.
    pub solvers: Vec<&'static str>,
    /// What failed before these were found.
    pub recovery: Recovery,
    /// Largest number of solutions of an increment, where they were enumerated: those in which no other points touch than in its
    /// answer.
    pub solutions: Option<usize>,
    /// Pairs whose gaps contact leaves undetermined at the end of an increment, as by [`loose_pairs`].
    pub loose: Vec<usize>,
    /// Pairs whose slip friction leaves undetermined in an increment, as by [`sliding_pairs`].
    pub sliding: Vec<usize>,
    /// Whether contact parted and bore elsewhere in one increment: what bodies travelled in between is counted as slip.
    pub parted: bool,
    /// Largest coefficient of friction of the points in contact at its end (dimensionless).
    pub coefficient: f64,
    /// Estimate of the coefficient up to which its end has one solution, as by [`uniqueness_bound`]; made once in a history,
    /// when all steps are done, for the step in which most points touch.
    pub uniqueness: Option<f64>,
    /// Increments accepted.
    pub increments: usize,
    /// Increments that failed and were halved.
    pub cutbacks: usize,
    /// Work lost to friction in the step `[force·length]`: slip times the mean of the slip forces at both ends of each increment.
    pub dissipation: f64,
    /// Slip of each point in the step `[length]`, first body against the second along e_t; zero where it did not slip.
    pub slip: DVector<f64>,
    /// Equilibrium at its end.
    pub audit: Audit,
    /// The records of the parts of an [`Interface`] of several, of which this one holds sums and largest values; empty for one problem.
    pub parts: Vec<StepRecord>,
}

impl StepRecord {
    /// The record of part `part`.
    fn part(&self, part: usize) -> &Self {
        self.parts.get(part).unwrap_or(self)
    }
}
