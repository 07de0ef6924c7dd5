//! The history walked a second time, to see what more increments change.

use super::again::Again;
use super::found::{Difference, Missing, Otherwise};
use crate::history::StepRecord;
use crate::solver::InterfaceSolver;

/// Floating-point operations that the walk may take, or twice those of the whole history where these are more.
const EFFORT: f64 = 3e9;

/// The history walked a second time, in more increments where few divide it.
pub(super) struct FinerWalk {
    now: Place,
    /// Floating-point operations that are left.
    effort: f64,
    goes_on: bool,
}

/// Where the second walk stands between two load steps.
enum Place {
    /// At the end of the record: no step before was walked in more increments.
    AtRecords,
    /// At an end of its own.
    At(Box<StepRecord>),
    /// It ended before, and says nothing of steps that go on from there.
    Lost(Missing),
}

impl FinerWalk {
    /// At the beginning of a history that took `operations`; `goes_on` says whether a step can begin where this walk ended the one before, or begins where the
    /// record did.
    pub(super) fn new(operations: f64, goes_on: bool) -> Self {
        Self {
            now: Place::AtRecords,
            effort: (2.0 * operations).max(EFFORT),
            goes_on,
        }
    }

    /// Walks the step `again`, in more increments where it is coarse; returns how its end differs, if the walk has left the record. Where it was lost, the next
    /// coarse step begins at the record.
    pub(super) fn step(
        &mut self,
        again: &Again<'_>,
        solver: &dyn InterfaceSolver,
    ) -> Result<Option<Difference>, Missing> {
        let times = if again.is_coarse() {
            Otherwise::FINER
        } else if again.was_cut_back() && matches!(self.now, Place::At(_)) {
            2
        } else {
            1
        };
        let start = match std::mem::replace(&mut self.now, Place::AtRecords) {
            Place::At(end) => end.at_its_end(),
            Place::Lost(missing) if times == 1 => {
                self.now = Place::Lost(missing);
                return Err(missing);
            }
            Place::AtRecords if times == 1 => return Ok(None),
            Place::AtRecords | Place::Lost(_) => again.start().at_its_end(),
        };
        let walk = self.walked(again, solver, start, times);
        let difference = match &walk {
            Ok(walk) => Ok(Some(again.difference(walk, solver.name(), walk.increments))),
            Err(missing) => Err(*missing),
        };
        if self.goes_on {
            self.now = walk.map_or_else(Place::Lost, |walk| Place::At(Box::new(walk)));
        }
        difference
    }

    fn walked(
        &mut self,
        again: &Again<'_>,
        solver: &dyn InterfaceSolver,
        start: StepRecord,
        times: usize,
    ) -> Result<StepRecord, Missing> {
        let record = again.record();
        let expected = times as f64 * record.work.operations as f64;
        if expected > self.effort {
            return Err(Missing::Effort);
        }
        let walk = again.walked(solver, start, &again.ends(times, record.increments));
        // Shorter increments take less each.
        self.effort -= (walk.as_ref()).map_or(expected, |walk| walk.work.operations as f64);
        walk.ok_or(Missing::Answer)
    }
}
