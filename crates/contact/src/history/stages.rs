//! The problems of every load step, and where steps start.

use super::carry::Carry;
use super::course::Course;
use super::record::StepRecord;
use crate::deformed::Kinematics;
use crate::error::ContactError;
use crate::state::ContactState;
use crate::thinned::{Thinned, Whole};

/// The records of a history whose steps have nodes of their own.
#[derive(Clone, Debug)]
pub struct Thin {
    /// Those of all points.
    pub all: Vec<StepRecord>,
    /// Those of the points that each step has.
    pub own: Vec<StepRecord>,
}

/// The problems of every step, one for each part of the interface.
#[derive(Debug)]
pub(super) struct Stages<'a> {
    /// Of all steps, or of each.
    courses: Vec<Vec<Course<'a>>>,
    thinned: Option<(&'a [Whole<'a>], &'a [Thinned])>,
}

impl<'a> Stages<'a> {
    /// The same problems in all steps.
    pub(super) fn unchanging(courses: Vec<Course<'a>>) -> Self {
        Self {
            courses: vec![courses],
            thinned: None,
        }
    }

    /// Those of `thinned`, one for each of `steps` load steps, chosen among the nodes of `wholes`.
    pub(super) fn thinned(
        wholes: &'a [Whole<'a>],
        thinned: &'a [Thinned],
        steps: usize,
    ) -> Result<Self, ContactError> {
        for count in [wholes.len(), thinned.len()] {
            if count != steps {
                let what = format!("{count} sets of bodies or of chosen nodes for {steps} steps");
                return Err(ContactError::InvalidLoad {
                    step: steps.min(count),
                    what,
                });
            }
        }
        let courses = |own: &'a Thinned| -> Result<Vec<Course<'a>>, ContactError> {
            let kinematics: Kinematics<'a> = own.kinematics()?;
            Ok(Course::of_parts(own.interface(), &kinematics))
        };
        Ok(Self {
            courses: thinned.iter().map(courses).collect::<Result<_, _>>()?,
            thinned: Some((wholes, thinned)),
        })
    }

    /// Whether all steps have the same problems.
    pub(super) fn are_unchanging(&self) -> bool {
        self.thinned.is_none()
    }

    /// The problems of step `step`.
    pub(super) fn courses(&self, step: usize) -> &[Course<'a>] {
        &self.courses[step.min(self.courses.len() - 1)]
    }

    /// Where the problem of `part` starts in the step after `before`, records of all parts.
    pub(super) fn start(&self, step: usize, part: usize, before: &[StepRecord]) -> StepRecord {
        if let (None, Some(last)) = (self.thinned, before.last()) {
            return last.part(part).at_its_end();
        }
        let count = self.courses(step).len();
        let last = before.last().map(|record| -> Vec<StepRecord> {
            (0..count).map(|part| record.part(part).clone()).collect()
        });
        self.starts(step, last.as_deref()).swap_remove(part)
    }

    /// Where the problems of step `step` start after `last`, their records of the step before.
    pub(super) fn starts(&self, step: usize, last: Option<&[StepRecord]>) -> Vec<StepRecord> {
        match (self.thinned, last) {
            (_, None) => {
                let unloaded =
                    |course: &Course<'_>| StepRecord::at(ContactState::unloaded(course.problem));
                self.courses(step).iter().map(unloaded).collect()
            }
            (None, Some(last)) => last.iter().map(StepRecord::at_its_end).collect(),
            (Some((wholes, thinned)), Some(last)) => {
                let [before, own] = [step - 1, step].map(|step| Carry {
                    whole: &wholes[step],
                    thinned: &thinned[step],
                });
                let merged = before.thinned.interface().merged(last.to_vec());
                let (record, mut moved) = before.expand(&merged);
                own.move_to_nodes(before.whole, &mut moved);
                own.start(&record, &moved)
            }
        }
    }
}
