//! One increment of load on the undeformed or on the deformed geometry.

use std::sync::{Mutex, PoisonError};

use super::StepRecord;
use super::passes::{Passes, Taken};
use super::travel::travelled;
use crate::deformed::{DeformedGaps, Kinematics};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::{InterfaceSolver, Step, StepFailure};

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

    /// Takes `record` from its end to the load multipliers `multipliers` by `solver`, by its cheapest means only if `quickly`.
    pub(super) fn advance(
        &self,
        record: &mut StepRecord,
        solver: &dyn InterfaceSolver,
        quickly: bool,
        multipliers: &[f64],
    ) -> Result<(), StepFailure> {
        let increment = self.increment(record, solver, quickly, multipliers)?;
        record.append(increment);
        Ok(())
    }

    fn increment(
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
            let step = Step::new(self.problem, start, multipliers);
            return StepRecord::solved(&step, by).map(|(record, _)| record);
        };
        let known = last.lock().unwrap_or_else(PoisonError::into_inner).take();
        let mut passes = Passes::new(self.problem, gaps, from, known)?;
        passes.travel(multipliers)?;
        let record = passes.settle(multipliers, by)?;
        *last.lock().unwrap_or_else(PoisonError::into_inner) = passes.taken(&record);
        Ok(record)
    }
}
