//! What is reported of a load step: its increments, merged.

use std::sync::Arc;

use nalgebra::DVector;

use super::travel::parts;
use super::{Increment, Recovery};
use crate::audit::Audit;
use crate::freedom::{loose_pairs, sliding_pairs};
use crate::problem::Contacts;
use crate::solver::{Residuals, Step, StepFailure, StepSolution, Stop, Work};
use crate::state::{ContactState, TrialState};

/// One accepted load step, of one problem or of all parts of an [`Interface`](crate::interface::Interface).
#[derive(Clone, Debug)]
pub struct StepRecord {
    /// Contact at its end.
    pub state: ContactState,
    /// The contact points on the deformed geometry of its end; `None` where contact is found on the undeformed one.
    pub contacts: Option<Arc<Contacts>>,
    /// Forces `[force]` on the contact points of each body, x and y of each in turn, where they are not those that [`contacts`](Self::contacts) make of the state: of a
    /// step on [chosen nodes](crate::thinned).
    pub on_bodies: Option<Arc<Vec<Vec<f64>>>>,
    /// Displacements `[length]` of the contact points of each body, where they are not those of the forces: of a step that goes on from other nodes.
    pub moved: Option<Arc<Vec<DVector<f64>>>>,
    /// Work of all its increments, failed attempts included.
    pub work: Work,
    /// Largest residuals of its increments.
    pub residuals: Residuals,
    /// Whether the conditions of contact were verified in all its increments; experimental solvers return others, and so does the end of cut-back where the
    /// best state nearly meets them.
    pub verified: bool,
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
    /// Estimate of the coefficient `[1]` up to which its end has one solution, as by [`uniqueness_bound`](crate::uniqueness::uniqueness_bound); made once in a history,
    /// when all steps are done, for the step in which most points touch.
    pub uniqueness: Option<f64>,
    /// Increments accepted.
    pub increments: usize,
    /// Where increments ended, in parts of the load step `[1]`; empty of a record that is no walk through a step.
    pub ends: Vec<f64>,
    /// Increments that failed and were halved.
    pub cutbacks: usize,
    /// Work lost to friction at each point in the step `[force·length]`: slip times the mean of the slip forces at both ends of each increment.
    pub friction_work: DVector<f64>,
    /// Slip of each point in the step `[length]`, first body against the second along e_t; zero where it did not slip.
    pub slip: DVector<f64>,
    /// Equilibrium at its end.
    pub audit: Audit,
    /// The records of the parts of an [`Interface`](crate::interface::Interface) of several, of which this one holds sums and largest values; empty for one problem.
    pub parts: Vec<StepRecord>,
}

impl StepRecord {
    /// The record of a step that has not left `state` yet.
    pub(crate) fn at(state: ContactState) -> Self {
        Self {
            slip: DVector::zeros(state.status.len()),
            friction_work: DVector::zeros(state.status.len()),
            state,
            contacts: None,
            on_bodies: None,
            moved: None,
            work: Work::default(),
            residuals: Residuals::default(),
            verified: true,
            doubtful: 0,
            solvers: Vec::new(),
            recovery: Recovery::default(),
            solutions: None,
            loose: Vec::new(),
            sliding: Vec::new(),
            parted: false,
            coefficient: 0.0,
            uniqueness: None,
            increments: 0,
            ends: Vec::new(),
            cutbacks: 0,
            audit: Audit::default(),
            parts: Vec::new(),
        }
    }

    /// The record of a step that begins where this one ends.
    pub(super) fn at_its_end(&self) -> Self {
        Self {
            contacts: self.contacts.clone(),
            moved: self.moved.clone(),
            ..Self::at(self.state.clone())
        }
    }

    /// The record of the one increment that `solution` solves: `step` with that end. Whether contact parted is left open.
    pub fn of(step: &Step<'_>, solution: StepSolution) -> Self {
        let (problem, start) = (step.problem, step.committed);
        let coefficient = step.largest_coefficient(&solution.trial);
        let Increment {
            state,
            residuals,
            friction_work,
            slip,
        } = Increment::accept(step, solution.trial);
        Self {
            audit: Audit::of(problem, &state),
            contacts: None,
            on_bodies: None,
            moved: None,
            work: solution.work,
            residuals,
            verified: solution.stop == Stop::Verified,
            doubtful: solution.doubtful,
            solvers: vec![solution.solver],
            recovery: Recovery::of(&solution.attempts),
            solutions: solution.solutions,
            loose: loose_pairs(problem, &state),
            sliding: sliding_pairs(problem, start, &state, &slip),
            parted: false,
            coefficient,
            uniqueness: None,
            increments: 1,
            ends: Vec::new(),
            cutbacks: 0,
            friction_work,
            slip,
            state,
            parts: Vec::new(),
        }
    }

    /// The record of the one increment `step`, solved by `by`; with what was solved.
    pub(super) fn solved(
        step: &Step<'_>,
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
    ) -> Result<(Self, TrialState), StepFailure> {
        let solution = by(step)?;
        let trial = solution.trial.clone();
        let record = Self {
            parted: parts(&step.committed.forces, &trial.forces),
            ..Self::of(step, solution)
        };
        Ok((record, trial))
    }

    /// Takes over a refused attempt at an increment.
    pub(super) fn cut_back(&mut self, failure: &StepFailure) {
        self.work += failure.work;
        self.recovery.add(&failure.attempts);
        self.cutbacks += 1;
    }

    /// Adds `next`, which begins where this record ends: sums of work, of slip and of what was tried, the worst of residuals and doubts,
    /// and the state at its end.
    pub(super) fn append(&mut self, next: Self) {
        self.work += next.work;
        self.residuals = self.residuals.worse(next.residuals);
        self.verified &= next.verified;
        self.doubtful = self.doubtful.max(next.doubtful);
        for solver in next.solvers {
            if !self.solvers.contains(&solver) {
                self.solvers.push(solver);
            }
        }
        self.recovery.append(next.recovery);
        self.solutions = self.solutions.max(next.solutions);
        for (pairs, more) in [
            (&mut self.loose, next.loose),
            (&mut self.sliding, next.sliding),
        ] {
            pairs.extend(more);
            pairs.sort_unstable();
            pairs.dedup();
        }
        self.parted |= next.parted;
        self.coefficient = next.coefficient;
        self.increments += next.increments;
        self.cutbacks += next.cutbacks;
        self.friction_work += next.friction_work;
        self.slip += next.slip;
        self.state = next.state;
        self.contacts = next.contacts;
        self.moved = next.moved;
        self.audit = next.audit;
    }

    /// Work lost to friction at all points in the step `[force·length]`.
    pub fn dissipation(&self) -> f64 {
        self.friction_work.sum()
    }

    /// The contact points of its end, those of the undeformed geometry being `undeformed`.
    pub fn contacts_of<'a>(&'a self, undeformed: &'a Contacts) -> &'a Contacts {
        self.contacts.as_deref().unwrap_or(undeformed)
    }

    /// The record of part `part`.
    pub(super) fn part(&self, part: usize) -> &Self {
        self.parts.get(part).unwrap_or(self)
    }
}
