//! One increment of load on the undeformed or on the deformed geometry.

use std::sync::{Mutex, PoisonError};

use super::StepRecord;
use super::passes::{Passes, Taken};
use super::travel::travelled;
use super::walker::LoadIncrement;
use crate::deformed::{DeformedGaps, Kinematics};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::nearest::nearly;
use crate::solver::{InterfaceSolver, Step, StepFailure, StepSolution};

/// What a solver may spend on an increment, and which answer will do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Means {
    /// Its cheapest means only.
    Cheapest,
    /// All of them.
    All,
    /// All, and the state that comes closest where that nearly meets the conditions: the alternative is no answer at all.
    Last,
}

impl Means {
    /// Those for `increment`.
    pub(super) fn of(increment: &LoadIncrement) -> Self {
        if increment.smallest {
            Self::Last
        } else if increment.is_between() {
            Self::Cheapest
        } else {
            Self::All
        }
    }

    /// These means, without states that only come close unless these `may` be taken.
    pub(super) fn within(self, may: bool) -> Self {
        match self {
            Self::Last if !may => Self::All,
            own => own,
        }
    }

    fn solve(
        self,
        solver: &dyn InterfaceSolver,
        step: &Step<'_>,
    ) -> Result<StepSolution, StepFailure> {
        match self {
            Self::Cheapest => solver.try_quickly(step),
            Self::All => solver.solve(step),
            Self::Last => solver.solve(step).or_else(|failure| nearly(step, failure)),
        }
    }
}

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

    /// Takes `record` from its end to the load multipliers `multipliers` by `solver` and its `means`; whether its end is verified.
    pub(super) fn advance(
        &self,
        record: &mut StepRecord,
        solver: &dyn InterfaceSolver,
        means: Means,
        multipliers: &[f64],
    ) -> Result<bool, StepFailure> {
        let by = |step: &Step<'_>| means.solve(solver, step);
        let increment = self.increment(record, by, multipliers)?;
        let verified = increment.verified;
        record.append(increment);
        Ok(verified)
    }

    fn increment(
        &self,
        from: &StepRecord,
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
        multipliers: &[f64],
    ) -> Result<StepRecord, StepFailure> {
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
