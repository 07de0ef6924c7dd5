//! Solves load steps again from their initial state, by another solver or in smaller increments, to show how far the answer depends on
//! either.
//!
//! Neither solution is cut back, so a step that the other solver or the smaller increments do not solve has no comparison.

mod again;
mod finer;

use stickslip_fem_core::parallel;

use self::again::Again;
use self::finer::FinerWalk;
use super::course::Course;
use super::stages::Stages;
use super::{LoadHistory, StepRecord};
use crate::deformed::Kinematics;
use crate::error::ContactError;
use crate::interface::Interface;
use crate::problem::InterfaceProblem;
use crate::solver::InterfaceSolver;
use crate::thinned::{Thinned, Whole};
use crate::uniqueness::{NEAR_BOUND, bound_with_turns_held};

/// Part of the largest motion up to which a difference of slips is rounding.
const ROUNDING: f64 = 1e-9;
/// Number of touching points up to which the bound of uniqueness is estimated for each step.
const FEW: usize = 12;

/// How the end of a load step differs where it is reached another way.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Difference {
    /// Solver of the other way.
    pub solver: &'static str,
    /// Equal increments of the other way.
    pub increments: usize,
    /// Change of the largest pressure, relative to the largest pressure of the answer.
    pub peak_pressure: f64,
    /// Largest change of a pressure or tangential traction, relative to the largest pressure of the answer.
    pub traction: f64,
    /// Largest change of the slip of a point in the step, relative to the largest slip in it either way; 0 if it is rounding of motions.
    pub slip: f64,
    /// Change of the work of friction in the step, relative to the larger one; 0 if it is rounding.
    pub dissipation: f64,
}

impl Difference {
    /// Differences beyond this part are more than rounding; of tractions, another answer.
    pub const DISTINCT: f64 = 1e-6;

    /// Whether the other way ends at another answer.
    pub fn is_distinct(&self) -> bool {
        self.traction > Self::DISTINCT
    }

    /// Whether slip or its work differ, as they do where points close and slip from then on.
    pub fn differs_in_slip(&self) -> bool {
        self.slip.max(self.dissipation.abs()) > Self::DISTINCT
    }

    /// The largest of each number; the other way is that whose tractions differ more.
    fn or_worse(self, other: Self) -> Self {
        let larger = |one: f64, other: f64| if other.abs() > one.abs() { other } else { one };
        let way = if other.traction > self.traction {
            other
        } else {
            self
        };
        Self {
            peak_pressure: larger(self.peak_pressure, other.peak_pressure),
            traction: larger(self.traction, other.traction),
            slip: larger(self.slip, other.slip),
            dissipation: larger(self.dissipation, other.dissipation),
            ..way
        }
    }
}

/// Why a step that may have several solutions was not compared with another solver's answer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Missing {
    /// The comparisons of the history would take more work than they may.
    Effort,
    /// The other solver found no answer.
    Answer,
}

/// A load step's answer beside those of other ways to it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Otherwise {
    /// By another solver in the increments that the history asks for: where the step may have several solutions, or was cut back.
    pub other_solver: Option<Difference>,
    /// Why that is missing where it was called for.
    pub missing: Option<Missing>,
    /// By the same solver in twice as many increments: where the step was cut back under friction into few of them.
    pub finer: Option<Difference>,
    /// By the same solver where the history is walked in [`FINER`](Self::FINER) times as many increments: in steps of few increments with friction in which the load path
    /// begins or turns or contact bears anew, and in as many in those that follow. `None` before the first of them.
    pub path: Option<Difference>,
    /// Why that is missing where friction acts.
    pub path_missing: Option<Missing>,
}

impl Otherwise {
    /// Floating-point operations of pivoting that all comparisons of one problem's history may take.
    pub const EFFORT: f64 = 1e9;
    /// How many times as many increments steps are compared with that have few.
    pub const FINER: usize = 4;

    /// Of both, what differs more.
    fn or_worse(self, other: Self) -> Self {
        let more = |one: Option<Difference>, other: Option<Difference>| {
            one.into_iter().chain(other).reduce(Difference::or_worse)
        };
        Self {
            other_solver: more(self.other_solver, other.other_solver),
            missing: self.missing.or(other.missing),
            finer: more(self.finer, other.finer),
            path: more(self.path, other.path),
            path_missing: self.path_missing.or(other.path_missing),
        }
    }
}

impl LoadHistory {
    /// Compares each of `records`, which `solver` found of this history, with other ways to the end of its step: with another
    /// solver where friction falls with slip or is not below the estimated bound of uniqueness, contact left gaps undetermined or the
    /// step was cut back, with smaller increments where it was cut back; and from where the load path begins or turns in fewer than eight increments with a second walk
    /// through the history. It costs nothing where none is so, as much as the step or its increments elsewhere.
    /// Parts of `interface` are compared each for itself, relative to its own largest pressure, and that which differs most is returned.
    pub fn walked_otherwise(
        &self,
        interface: &Interface,
        kinematics: &Kinematics<'_>,
        solver: &dyn InterfaceSolver,
        records: &[StepRecord],
    ) -> Vec<Otherwise> {
        let stages = Stages::unchanging(Course::of_parts(interface, kinematics));
        self.all_otherwise(&stages, solver, records)
    }

    /// The same of `records` on the chosen nodes of a history that [`follow_thinned`](Self::follow_thinned) walked.
    ///
    /// # Errors
    /// As [`follow_thinned`](Self::follow_thinned), of nodes that do not fit.
    pub fn thinned_otherwise(
        &self,
        whole: &Whole<'_>,
        thinned: &[Thinned],
        solver: &dyn InterfaceSolver,
        records: &[StepRecord],
    ) -> Result<Vec<Otherwise>, ContactError> {
        let stages = Stages::thinned(whole, thinned, self.steps.len())?;
        Ok(self.all_otherwise(&stages, solver, records))
    }

    fn all_otherwise(
        &self,
        stages: &Stages<'_>,
        solver: &dyn InterfaceSolver,
        records: &[StepRecord],
    ) -> Vec<Otherwise> {
        let count = stages.courses(0).len();
        let parts = parallel::map_range(0..count, |part| {
            self.problem_otherwise(stages, part, solver, records)
        });
        let mut all = vec![Otherwise::default(); records.len()];
        for part in parts {
            for (known, found) in all.iter_mut().zip(part) {
                *known = known.or_worse(found);
            }
        }
        all
    }

    fn problem_otherwise(
        &self,
        stages: &Stages<'_>,
        part: usize,
        solver: &dyn InterfaceSolver,
        records: &[StepRecord],
    ) -> Vec<Otherwise> {
        let own: Vec<&StepRecord> = records.iter().map(|record| record.part(part)).collect();
        let touching = |(_, record): &(usize, &StepRecord)| {
            let status = record.state.status.iter();
            status.filter(|status| status.touches()).count()
        };
        let rubbing = own.iter().copied().enumerate();
        let rubbing = rubbing.filter(|(_, record)| record.coefficient > 0.0);
        let estimate = rubbing.max_by_key(touching).and_then(|(step, record)| {
            let problem = stages.courses(step)[part].problem;
            let held = || bound_with_turns_held(problem, &record.state.status);
            record.uniqueness.or_else(held)
        });
        let operations = own.iter().map(|record| record.work.operations as f64);
        let mut finer = FinerWalk::new(operations.sum(), stages.are_unchanging());
        let mut effort = Otherwise::EFFORT;
        let step = |index: usize| {
            let again = Again::new(self, stages, part, index, records);
            let mut found = Otherwise::default();
            match finer.step(&again, solver) {
                Ok(difference) => found.path = difference.filter(|_| again.rubs()),
                Err(missing) => found.path_missing = again.rubs().then_some(missing),
            }
            let record = again.record();
            if again.was_cut_back() {
                found.finer = again.by(solver, solver.name(), 2 * record.increments);
            }
            let problem = again.problem();
            let several = || record.cutbacks > 0 || may_have_several(problem, record, estimate);
            if again.rubs() && several() {
                match again.by_another(&mut effort) {
                    Ok(difference) => found.other_solver = Some(difference),
                    Err(missing) => found.missing = Some(missing),
                }
            }
            found
        };
        (0..records.len()).map(step).collect()
    }
}

/// Whether contact left gaps undetermined on the way, or friction of `record` falls with slip or is not below the bound of uniqueness:
/// that of its own points where these are few, else `estimate`, that of the most points of its history.
fn may_have_several(
    problem: &InterfaceProblem,
    record: &StepRecord,
    estimate: Option<f64>,
) -> bool {
    if !record.loose.is_empty() || falls_with_slip(problem, record) {
        return true;
    }
    let status = &record.state.status;
    let few = status.iter().filter(|status| status.touches()).count() <= FEW;
    let bound = if few {
        bound_with_turns_held(problem, status)
    } else {
        estimate
    };
    bound.is_none_or(|bound| record.coefficient >= NEAR_BOUND * bound)
}

/// Whether a point that touches could stick with more than it slips with, so that the bound of uniqueness says nothing.
fn falls_with_slip(problem: &InterfaceProblem, record: &StepRecord) -> bool {
    /// Part of a bound that is rounding.
    const ROUNDING: f64 = 1e-12;
    let state = &record.state;
    let falls = |k: usize| {
        let point = &problem.points()[k];
        let (pressure, slip) = (state.normal_force(k) / point.area, record.slip[k].abs());
        let law = problem.law(k);
        let bound = law.bound(pressure, slip, &point.place, &state.history[k]);
        let rounding = ROUNDING * bound.slip;
        bound.stick > bound.slip + rounding || bound.slip_ds * slip < -rounding
    };
    let slides = |k: usize| state.status[k].touches() && problem.points()[k].slides;
    (0..state.status.len()).any(|k| slides(k) && falls(k))
}
