//! One increment of load on the undeformed geometry.

use std::sync::{Mutex, PoisonError};

use super::StepRecord;
use super::passes::{Passes, Taken};
use super::travel::{parts, travelled};
use crate::deformed::{DeformedGaps, Kinematics};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::{InterfaceSolver, Step, StepFailure, StepSolution};
use crate::state::TrialState;

/// A problem, and the edges of its pairs where contact is found on the deformed geometry.
#[derive(Debug)]
pub(super) struct Course<'a> {
    pub(super) problem: &'a InterfaceProblem,
    deformed: Option<Deformed<'a>>,
}

#[derive(Debug)]
struct Deformed<'a> {
    gaps: DeformedGaps<'a>,
    /// The problem on the geometry of the increment that was accepted last.
    last: Mutex<Option<Taken>>,
}

impl<'a> Course<'a> {
    /// On the undeformed geometry.
    pub(super) fn small(problem: &'a InterfaceProblem) -> Self {
        Self {
            problem,
            deformed: None,
        }
    }

    /// Of every part of `interface`.
    pub(super) fn of_parts(interface: &'a Interface, kinematics: &Kinematics<'a>) -> Vec<Self> {
        let course = |part: &'a Part| Self {
            problem: part.problem(),
            deformed: match kinematics {
                Kinematics::Small => None,
                Kinematics::DeformedGaps(gaps) => Some(Deformed {
                    gaps: gaps.of_group(part.group()),
                    last: Mutex::new(None),
                }),
            },
        };
        interface.parts().iter().map(course).collect()
    }

    /// The increment from the end of `from` to the load multipliers `multipliers` by `solver`, by its cheapest means only if `quickly`.
    pub(super) fn increment(
        &self,
        from: &StepRecord,
        solver: &dyn InterfaceSolver,
        quickly: bool,
        multipliers: &[f64],
    ) -> Result<StepRecord, StepFailure> {
        let by = |step: &Step<'_>| {
            if quickly {
                solver.try_quickly(step)
            } else {
                solver.solve(step)
            }
        };
        let Some(Deformed { gaps, last }) = &self.deformed else {
            let ends = [&*from.state.multipliers, multipliers];
            let travelled = travelled(self.problem, &from.state, ends);
            let start = travelled.as_ref().unwrap_or(&from.state);
            return one(&Step::new(self.problem, start, multipliers), by).map(|(record, _)| record);
        };
        let known = last.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut passes = Passes::new(self.problem, gaps, from, known)?;
        passes.travel(multipliers)?;
        let record = passes.settle(multipliers, by)?;
        *last.lock().unwrap_or_else(PoisonError::into_inner) = passes.taken(&record);
        Ok(record)
    }
}

/// The increment `step`, with what was solved.
pub(super) fn one(
    step: &Step<'_>,
    by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
) -> Result<(StepRecord, TrialState), StepFailure> {
    let solution = by(step)?;
    let trial = solution.trial.clone();
    let record = StepRecord {
        parted: parts(&step.committed.forces, &trial.forces),
        ..StepRecord::of(step, solution)
    };
    Ok((record, trial))
}
