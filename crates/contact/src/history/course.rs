//! One increment of load on the undeformed or on the deformed geometry.

use std::sync::Arc;

use nalgebra::DVector;

use super::StepRecord;
use super::travel::{parts, travelled};
use crate::deformed::{
    DeformedGaps, Geometry, Kinematics, LARGEST_ERROR, PASSES, TOLERANCE, Unfaced,
};
use crate::interface::{Interface, Part};
use crate::problem::InterfaceProblem;
use crate::solver::{FailureCause, InterfaceSolver, Step, StepFailure, StepSolution, Work};
use crate::state::{ContactState, TrialState};

/// A problem, and the edges of its pairs where contact is found on the deformed geometry.
#[derive(Clone, Debug)]
pub(super) struct Course<'a> {
    pub(super) problem: &'a InterfaceProblem,
    gaps: Option<DeformedGaps<'a>>,
}

/// Name under which failures of the passes are reported.
const NAME: &str = "deformed gaps";

impl<'a> Course<'a> {
    /// On the undeformed geometry.
    pub(super) fn small(problem: &'a InterfaceProblem) -> Self {
        Self {
            problem,
            gaps: None,
        }
    }

    /// Of every part of `interface`.
    pub(super) fn of_parts(interface: &'a Interface, kinematics: &Kinematics<'a>) -> Vec<Self> {
        let course = |part: &'a Part| Self {
            problem: part.problem(),
            gaps: match kinematics {
                Kinematics::Small => None,
                Kinematics::DeformedGaps(gaps) => Some(gaps.of_group(part.group())),
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
        match &self.gaps {
            None => one(self.problem, &from.state, multipliers, None, by).map(|(record, _)| record),
            Some(gaps) => self.on_deformed(gaps, from, multipliers, by),
        }
    }

    fn on_deformed(
        &self,
        gaps: &DeformedGaps<'_>,
        from: &StepRecord,
        multipliers: &[f64],
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
    ) -> Result<StepRecord, StepFailure> {
        let before = from.contacts_of(self.problem.contacts());
        let committed = gaps.displacements(self.problem, before, &from.state);
        let mut passes = Passes::new(self.problem, gaps, committed)?;
        for _ in 0..PASSES {
            let (record, settled) = passes.pass(&from.state, multipliers, &by)?;
            if settled {
                return Ok(record);
            }
        }
        let cause = FailureCause::Geometry {
            passes: PASSES,
            change: passes.change,
        };
        Err(StepFailure::new(NAME, cause, passes.work))
    }
}

/// The passes of one increment over the deformed geometry.
struct Passes<'a> {
    problem: &'a InterfaceProblem,
    gaps: &'a DeformedGaps<'a>,
    /// Displacements of the bodies at its start.
    committed: Vec<DVector<f64>>,
    geometry: Geometry,
    /// Change of the geometry in the last pass.
    change: f64,
    work: Work,
    last: Option<TrialState>,
}

impl<'a> Passes<'a> {
    fn new(
        problem: &'a InterfaceProblem,
        gaps: &'a DeformedGaps<'a>,
        committed: Vec<DVector<f64>>,
    ) -> Result<Self, StepFailure> {
        let geometry = Geometry::at(gaps, problem.pairs(), &committed);
        Ok(Self {
            geometry: geometry.map_err(|unfaced| refused(unfaced, Work::default()))?,
            problem,
            gaps,
            committed,
            change: f64::INFINITY,
            work: Work::default(),
            last: None,
        })
    }

    /// Solves the increment on the present geometry, and takes that of its end; with whether the two are the same.
    fn pass(
        &mut self,
        from: &ContactState,
        multipliers: &[f64],
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
    ) -> Result<(StepRecord, bool), StepFailure> {
        let pairs = self.geometry.pairs().to_vec();
        let problem = self.problem.with_points(self.gaps.bodies(), pairs);
        let start = ContactState {
            motion: self.geometry.motion(&self.committed),
            ..from.clone()
        };
        let solved = one(&problem, &start, multipliers, self.last.as_ref(), by);
        let (mut record, trial) = solved.map_err(|mut failure| {
            failure.work += self.work;
            failure
        })?;
        self.work += record.work;
        self.work.updates += 1;
        record.work = self.work;
        let contacts = problem.contacts();
        let moved = (self.gaps).displacements(self.problem, contacts, &record.state);
        let next = Geometry::at(self.gaps, self.problem.pairs(), &moved);
        let next = next.map_err(|unfaced| refused(unfaced, self.work))?;
        self.change = self.geometry.change(&next, &moved);
        self.geometry = next;
        self.last = Some(trial);
        let settled = self.change <= TOLERANCE;
        if settled {
            self.check(&moved)?;
            record.contacts = Some(Arc::new(contacts.clone()));
        }
        Ok((record, settled))
    }
}

impl Passes<'_> {
    /// Refuses displacements at which closest points are not known well.
    fn check(&self, moved: &[DVector<f64>]) -> Result<(), StepFailure> {
        let error = self.geometry.error(moved);
        if error <= LARGEST_ERROR {
            return Ok(());
        }
        let cause = FailureCause::Apart {
            error,
            limit: LARGEST_ERROR,
        };
        Err(StepFailure::new(NAME, cause, self.work))
    }
}

fn refused(Unfaced { point }: Unfaced, work: Work) -> StepFailure {
    StepFailure::new(NAME, FailureCause::Unfaced { point }, work)
}

/// The increment on the geometry of `problem`, started near `last`; with what was solved.
fn one(
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
