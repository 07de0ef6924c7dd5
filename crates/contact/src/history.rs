//! Load histories: from one load step to the next by sub-steps, cut back by a [`Walker`] where a solver fails. The parts of an [`Interface`] walk each
//! step side by side and are cut back each for itself; a history ends where the first of them does.

mod carry;
mod course;
mod events;
mod frictionless;
mod increment;
mod least_motion;
mod merged;
mod otherwise;
mod passes;
mod record;
mod recovery;
mod stages;
mod travel;
mod walker;

use std::convert::Infallible;

use stickslip_fem_core::parallel;

use crate::audit::LargestScales;
use crate::deformed::Kinematics;
use crate::error::ContactError;
use crate::interface::Interface;
use crate::problem::InterfaceProblem;
use crate::solver::nearest::is_near;
use crate::solver::{FailureCause, InterfaceSolver, Step, StepFailure};
use crate::state::ContactState;
use crate::thinned::{Thinned, Whole};
use crate::uniqueness::uniqueness_bound;

use carry::Carry;
use course::{Course, Means};
use events::Before;
pub use increment::Increment;
pub use otherwise::{Difference, Missing, Otherwise};
pub use record::StepRecord;
pub use recovery::{Cycle, FailedAttempts, Recovery};
use stages::Stages;
pub use stages::Thin;
pub use travel::travelled;
pub use walker::{Blocked, Effort, LoadIncrement, LoadPath, Progress, Walker};

/// How the load grows within the first load step, and within later ones that begin with all points open; others are always linear.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Ramp {
    /// In equal increments.
    #[default]
    Linear,
    /// P_k = P (k/n)²: finer where contact spreads fastest.
    Quadratic,
    /// As [`Quadratic`](Self::Quadratic), and where friction acts increments also end where points are about to close or to open: what sub-steps leave of friction then almost vanishes.
    Contact,
}

/// Load steps and how they are walked.
#[derive(Clone, Debug, PartialEq)]
pub struct LoadHistory {
    steps: Vec<Vec<f64>>,
    /// Sub-steps of each step.
    substeps: Vec<usize>,
    ramp: Ramp,
}

/// Smallest part of an increment to which cut-back goes.
const SMALLEST_PART: f64 = 1.0 / 1024.0;
/// Shortest increment that ends as a point closes or opens, as a part of a sub-step.
const SHORTEST: f64 = 1.0 / 256.0;
/// How many times longer such an increment is at least after one that failed, and may be shorter again after one that did not.
const LONGER: f64 = 8.0;
/// Floating-point operations that failed attempts at a sub-step may cost before it is cut back no further, or twice those of the most
/// expensive attempt where that is more; and that states of a load step may cost that only nearly meet the conditions.
const CUTBACK_EFFORT: u64 = 20_000_000_000;

impl LoadHistory {
    /// A history with `steps[k]` the multipliers `[1]` of all load cases at the end of step `k`.
    ///
    /// # Errors
    /// [`ContactError::InvalidLoad`] if steps differ in length, a multiplier is not finite, or `substeps` is zero.
    pub fn new(steps: Vec<Vec<f64>>, substeps: usize, ramp: Ramp) -> Result<Self, ContactError> {
        let substeps = vec![substeps; steps.len()];
        Self::divided(steps, substeps, ramp)
    }

    /// A history as by [`new`](Self::new), with `substeps[k]` sub-steps in step `k`.
    ///
    /// # Errors
    /// As [`new`](Self::new), and [`ContactError::InvalidLoad`] if steps and numbers of sub-steps differ in number.
    pub fn divided(
        steps: Vec<Vec<f64>>,
        substeps: Vec<usize>,
        ramp: Ramp,
    ) -> Result<Self, ContactError> {
        if substeps.len() != steps.len() {
            return Err(ContactError::InvalidLoad {
                step: steps.len().min(substeps.len()),
                what: format!(
                    "{} numbers of sub-steps for {} steps",
                    substeps.len(),
                    steps.len()
                ),
            });
        }
        if let Some(step) = substeps.iter().position(|&count| count == 0) {
            return Err(ContactError::InvalidLoad {
                step,
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

    /// Sub-steps of each step.
    pub fn substeps(&self) -> &[usize] {
        &self.substeps
    }

    /// How the load grows within the first step.
    pub fn ramp(&self) -> Ramp {
        self.ramp
    }

    /// Multipliers at the end of each step `[1]`.
    pub fn steps(&self) -> &[Vec<f64>] {
        &self.steps
    }

    /// The history of the first `count` steps, all of them where there are fewer.
    #[must_use]
    pub fn first(&self, count: usize) -> Self {
        let count = count.min(self.steps.len());
        Self {
            steps: self.steps[..count].to_vec(),
            substeps: self.substeps[..count].to_vec(),
            ramp: self.ramp,
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
        let stages = Stages::unchanging(vec![Course::small(problem)]);
        let steps = self.follow_all(&stages, solver, observe);
        let steps = steps.map_err(|ended| *ended.error)?;
        Ok(steps.into_iter().flatten().collect())
    }

    /// Walks the history of all parts of `interface` with `solver`, with contact as `kinematics` says, one record of the whole for each
    /// step; `observe` is called as soon as a step is accepted. The result does not depend on the number of threads.
    ///
    /// # Errors
    /// As [`follow`](Self::follow), for the part that comes to its end first, with its bodies.
    pub fn follow_parts(
        &self,
        interface: &Interface,
        kinematics: &Kinematics<'_>,
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(),
    ) -> Result<Vec<StepRecord>, ContactError> {
        let stages = Stages::unchanging(Course::of_parts(interface, kinematics));
        let steps = self.follow_all(&stages, solver, |_| observe());
        let steps = steps.map_err(|ended| interface.ended(ended.part, *ended.error))?;
        Ok(steps
            .into_iter()
            .map(|records| interface.merged(records))
            .collect())
    }

    /// Walks the history with each load step on its own nodes: of each step `wholes` has the bodies with all nodes, and `thinned` the chosen ones. Nodes of second edges may stand elsewhere from step to
    /// step on the deformed geometry. Returns one record of all points for each step; the records on the chosen nodes are for [`thinned_otherwise`](Self::thinned_otherwise). `observe` is called
    /// as soon as a step is accepted.
    ///
    /// # Errors
    /// As [`follow_parts`](Self::follow_parts), and [`ContactError::InvalidLoad`] if steps and choices of nodes differ in number.
    pub fn follow_thinned(
        &self,
        wholes: &[Whole<'_>],
        thinned: &[Thinned],
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(),
    ) -> Result<Thin, ContactError> {
        let stages = Stages::thinned(wholes, thinned, self.steps.len())?;
        let steps = self.follow_all(&stages, solver, |_| observe());
        let interface = |step: usize| thinned[step].interface();
        let steps = steps.map_err(|ended| interface(ended.step).ended(ended.part, *ended.error))?;
        let merged = steps.into_iter().enumerate();
        let own: Vec<StepRecord> = merged
            .map(|(step, records)| interface(step).merged(records))
            .collect();
        let all = own.iter().zip(wholes).zip(thinned);
        Ok(Thin {
            all: all
                .map(|((own, whole), thinned)| Carry { whole, thinned }.expand(own).0)
                .collect(),
            own,
        })
    }

    /// The records of each step, one for each problem of `stages`; or the problem that comes to its end first, and why.
    fn follow_all(
        &self,
        stages: &Stages<'_>,
        solver: &dyn InterfaceSolver,
        mut observe: impl FnMut(&[StepRecord]),
    ) -> Result<Vec<Vec<StepRecord>>, Ended> {
        let mut scales = Vec::new();
        let mut steps: Vec<Vec<StepRecord>> = Vec::with_capacity(self.steps.len());
        for (index, target) in self.steps.iter().enumerate() {
            let starts = stages.starts(index, steps.last().map(Vec::as_slice));
            let walked = each(stages.courses(index), |part, course| {
                self.walk(course, solver, &starts[part], index, target)
            });
            let mut records = all_or_first_end(walked).map_err(|(part, error)| Ended {
                step: index,
                part,
                error,
            })?;
            scales.resize_with(records.len(), LargestScales::default);
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
        let bounds = parallel::map_range(0..scales.len(), |part| {
            estimate_uniqueness(stages, part, steps.iter().map(|records| &records[part]))
        });
        for (part, bound) in bounds.into_iter().enumerate() {
            if let Some((step, bound)) = bound {
                steps[step][part].uniqueness = bound;
            }
        }
        Ok(steps)
    }

    /// Fraction of the increment of the step `index` from `start` that is applied after the part `part` of it.
    fn fraction(&self, index: usize, start: &ContactState, part: f64) -> f64 {
        if self.is_quadratic(index, start) {
            part * part
        } else {
            part
        }
    }

    /// The part of the step after which `fraction` is applied.
    fn part(&self, index: usize, start: &ContactState, fraction: f64) -> f64 {
        if self.is_quadratic(index, start) {
            fraction.sqrt()
        } else {
            fraction
        }
    }

    fn is_quadratic(&self, index: usize, start: &ContactState) -> bool {
        let bears = || start.status.iter().any(|status| status.touches());
        self.ramp != Ramp::Linear && (index == 0 || !bears())
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
            self.fraction(index, start, part)
        };
        // Exact at both ends, unlike from + fraction (to − from).
        let ends = start.multipliers.iter().zip(target);
        ends.map(|(from, to)| (1.0 - fraction) * from + fraction * to)
            .collect()
    }

    fn walk(
        &self,
        course: &Course<'_>,
        solver: &dyn InterfaceSolver,
        start: &StepRecord,
        index: usize,
        target: &[f64],
    ) -> Result<StepRecord, ContactError> {
        if target.len() != course.problem.load_cases() {
            let (given, cases) = (target.len(), course.problem.load_cases());
            let what = format!("{given} multipliers for {cases} load cases");
            return Err(ContactError::InvalidLoad { step: index, what });
        }
        let mut path = StepPath {
            history: self,
            course,
            solver,
            start: &start.state,
            index,
            target,
            record: start.at_its_end(),
            before: None,
            shortest: 0.0,
            is_short: false,
            nearly: false,
            spent: 0,
            sound: 0.0,
        };
        let whole = 1.0 / self.substeps[index] as f64;
        for substep in 0..self.substeps[index] {
            let [mut from, to] = [substep, substep + 1].map(|k| k as f64 * whole);
            path.shortest = SHORTEST * whole;
            while from < to {
                let end = path.end([from, to]);
                path.is_short = end < to;
                let walker = Walker {
                    whole: end - from,
                    smallest_part: if path.is_short { 1.0 } else { SMALLEST_PART },
                    effort: Some(CUTBACK_EFFORT),
                };
                match walker.walk([from, end], &mut path) {
                    Ok(_) => {
                        from = end;
                        path.shortest = (path.shortest / LONGER).max(SHORTEST * whole);
                    }
                    // So short an increment may be lost in rounding where a longer one is not.
                    Err(blocked) if path.is_short && !StepPath::is_final(&blocked.refusal) => {
                        path.cut_back(blocked.refusal);
                        path.shortest = LONGER * (end - from);
                    }
                    Err(blocked) => {
                        let reached = path.sound;
                        return Err(failed(index, Blocked { reached, ..blocked }));
                    }
                }
            }
        }
        Ok(path.record)
    }
}

/// A load step on its way.
struct StepPath<'a> {
    history: &'a LoadHistory,
    course: &'a Course<'a>,
    solver: &'a dyn InterfaceSolver,
    start: &'a ContactState,
    index: usize,
    target: &'a [f64],
    record: StepRecord,
    /// Where the last increment began.
    before: Option<Before>,
    /// Shortest increment that may end as a point closes or opens, as a part of the load step.
    shortest: f64,
    /// Whether the increment ends for that before its sub-step does.
    is_short: bool,
    /// Whether the last increment ended in a state that only nearly meets the conditions.
    nearly: bool,
    /// Floating-point operations that such states cost.
    spent: u64,
    /// Part of the load step that the last state reached that meets the conditions: which states nearly do is a matter of rounding.
    sound: f64,
}

impl StepPath<'_> {
    /// Where an increment from the first of `ends`, parts of the load step, is to end: at the second, or where a point is about to close or to open before that.
    fn end(&self, [from, to]: [f64; 2]) -> f64 {
        if self.history.ramp != Ramp::Contact || self.is_smooth() {
            return to;
        }
        let first = self.before.as_ref().map_or(Some(from), |before| {
            let next = before.next(&self.record.state, self.fraction(from))?;
            Some(self.history.part(self.index, self.start, next))
        });
        // The last increment says little of what is far beyond it.
        let most = (2.0 * from).min(to);
        let end = first
            .map_or(most, |first| first.min(most))
            .max(from + self.shortest);
        if end + self.shortest < to { end } else { to }
    }

    /// Whether points that bear could rub, and no law holds them.
    fn is_smooth(&self) -> bool {
        let (problem, state) = (self.course.problem, &self.record.state);
        let step = Step::new(problem, state, &state.multipliers);
        let bearing = (0..state.status.len())
            .filter(|&k| problem.points()[k].slides && state.normal_force(k) > 0.0);
        let mut bounds = bearing
            .map(|k| step.bound(k, state.normal_force(k), 0.0))
            .peekable();
        bounds.peek().is_some()
            && bounds.all(|bound| [bound.stick, bound.slip, bound.slip_ds] == [0.0; 3])
    }

    fn fraction(&self, part: f64) -> f64 {
        self.history.fraction(self.index, self.start, part)
    }
}

impl LoadPath for StepPath<'_> {
    type End = Infallible;
    type Refusal = StepFailure;

    /// Grows again where two increments of one size are accepted at once: after a cut-back, the first may only have come close to what
    /// was refused.
    fn attempt(&mut self, increment: &LoadIncrement) -> Result<Progress<Infallible>, StepFailure> {
        let to = (self.history).multipliers(self.index, self.start, self.target, increment.to);
        // Where shorter increments led nowhere, those are not tried right after.
        let means = if self.nearly {
            Means::Last
        } else {
            Means::of(increment)
        };
        let means = means.within(self.spent <= CUTBACK_EFFORT && !self.is_short);
        let before = self.record.work.operations;
        let follows_contact = self.history.ramp == Ramp::Contact;
        let start =
            follows_contact.then(|| Before::of(&self.record.state, self.fraction(increment.from)));
        let verified = (self.course).advance(&mut self.record, self.solver, means, &to)?;
        self.before = start;
        self.record.ends.push(increment.to);
        self.nearly = means == Means::Last && !verified;
        if self.nearly {
            self.spent += self.record.work.operations - before;
        } else {
            self.sound = increment.to;
        }
        let easily = increment.refusals == 0 && increment.steady > 0;
        Ok(if easily {
            Progress::Grow
        } else {
            Progress::Keep
        })
    }

    fn cost(refusal: &StepFailure) -> u64 {
        refusal.work.operations
    }

    fn is_final(refusal: &StepFailure) -> bool {
        refusal.is_stopped()
    }

    fn was_close(refusal: &StepFailure) -> bool {
        is_near(refusal)
    }

    /// Also where a balance is proved impossible: the history then ends at the largest load that has one.
    fn cut_back(&mut self, refusal: StepFailure) {
        self.record.cut_back(&refusal);
    }
}

/// The end of a history in load step `step`.
fn failed(step: usize, blocked: Blocked<StepFailure>) -> ContactError {
    let mut cause = blocked.refusal;
    let given_up = blocked.effort.map(|Effort { operations, limit }| {
        ("cut-back", FailureCause::Effort { operations, limit })
    });
    cause.attempts.extend(given_up);
    ContactError::StepFailed {
        step,
        reached: blocked.reached,
        bodies: Vec::new(),
        cause: Box::new(cause),
    }
}

/// `of` each of `courses` with its number, side by side where there are several.
fn each<T: Send>(
    courses: &[Course<'_>],
    of: impl Fn(usize, &Course<'_>) -> T + Sync + Send,
) -> Vec<T> {
    parallel::map_range(0..courses.len(), |part| of(part, &courses[part]))
}

/// Where a history ends before its last step.
struct Ended {
    step: usize,
    /// Number of the problem.
    part: usize,
    error: Box<ContactError>,
}

/// All records, or the part that reached least of the step and why, one with a proof before others.
fn all_or_first_end(
    walked: Vec<Result<StepRecord, ContactError>>,
) -> Result<Vec<StepRecord>, (usize, Box<ContactError>)> {
    let key = |error: &ContactError| match error {
        ContactError::StepFailed { reached, cause, .. } => (*reached, cause.is_unresolved()),
        _ => (-1.0, false),
    };
    let mut records = Vec::with_capacity(walked.len());
    let mut end: Option<(usize, Box<ContactError>)> = None;
    for (part, outcome) in walked.into_iter().enumerate() {
        match outcome {
            Ok(record) => records.push(record),
            Err(error) => {
                let first = |(_, other): &(usize, Box<ContactError>)| key(&error) < key(other);
                if end.as_ref().is_none_or(first) {
                    end = Some((part, Box::new(error)));
                }
            }
        }
    }
    end.map_or(Ok(records), Err)
}

/// The step in which most points touch, the last of equal ones, and its estimated bound of uniqueness: it costs more than an
/// interface solve, and says nothing new about fewer points under the same law.
fn estimate_uniqueness<'a>(
    stages: &Stages<'_>,
    part: usize,
    records: impl Iterator<Item = &'a StepRecord>,
) -> Option<(usize, Option<f64>)> {
    let touching = |(_, record): &(usize, &StepRecord)| {
        let status = record.state.status.iter();
        status.filter(|status| status.touches()).count()
    };
    let (step, record) = records.enumerate().max_by_key(touching)?;
    let problem = stages.courses(step)[part].problem;
    Some((step, uniqueness_bound(problem, &record.state.status)))
}
