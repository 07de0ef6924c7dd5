//! Solves load steps again from their initial state, by another solver or in smaller increments, to show how far the answer depends on
//! either.
//!
//! Neither solution is cut back, so a step that the other solver or the smaller increments do not solve has no comparison.

mod again;
mod finer;
mod found;

use stickslip_fem_core::parallel;

use self::again::Again;
use self::finer::FinerWalk;
pub use self::found::{Difference, Missing, Otherwise};
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

/// Number of touching points up to which the bound of uniqueness is estimated for each step.
const FEW: usize = 12;

impl LoadHistory {
    /// Compares each of `records`, which `solver` found of this history, with other ways to the end of its step: with another
    /// solver where friction falls with slip or is not below the estimated bound of uniqueness, contact left gaps undetermined or the
    /// step was cut back, with smaller increments where it was cut back; and from where the load path begins or turns in fewer than eight increments with a second walk
    /// through the history. It costs nothing where none is so, as much as the
    /// step or its increments elsewhere, and the second walk at most twice the history or what 3·10⁹ operations are.
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
        wholes: &[Whole<'_>],
        thinned: &[Thinned],
        solver: &dyn InterfaceSolver,
        records: &[StepRecord],
    ) -> Result<Vec<Otherwise>, ContactError> {
        let stages = Stages::thinned(wholes, thinned, self.steps.len())?;
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
                found.finer = again.by(solver, solver.name(), &again.ends(2, record.increments));
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
