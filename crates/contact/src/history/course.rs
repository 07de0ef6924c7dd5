//! One increment of load on the undeformed geometry.

use std::sync::{Mutex, PoisonError};

use super::StepRecord;
use super::passes::{Passes, Taken};
use super::travel::{parts, travelled};
use crate::deformed::{DeformedGaps, Kinematics};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::{InterfaceSolver, Step, StepFailure, StepSolution};
use crate::state::{ContactState, TrialState};

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
            let solved = one(self.problem, &from.state, multipliers, None, by);
            return solved.map(|(record, _)| record);
        };
        let known = last.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut passes = Passes::new(self.problem, gaps, from, known)?;
        let record = passes.settle(multipliers, by)?;
        *last.lock().unwrap_or_else(PoisonError::into_inner) = passes.taken(&record);
        Ok(record)
    }
}

/// The increment on the geometry of `problem`, started near `last`; with what was solved.
pub(super) fn one(
    problem: &InterfaceProblem,
    from: &ContactState,
    multipliers: &[f64],
    last: Option<&TrialState>,
    by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
) -> Result<(StepRecord, TrialState), StepFailure> {
    let travelled = travelled(problem, from, [&from.multipliers, multipliers]);
    let start = travelled.as_ref().unwrap_or(from);
    let mut step = Step::new(problem, start, multipliers);
    if let Some(last) = last {
        step = step.near(last);
    }
    let solution = by(&step)?;
    let trial = solution.trial.clone();
    let record = StepRecord {
        parted: parts(&start.forces, &solution.trial.forces),
        ..StepRecord::of(&step, solution)
    };
    Ok((record, trial))
}
