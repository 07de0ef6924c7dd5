//! The passes of an increment over the deformed geometry.
//!
//! The problem is kept from pass to pass and from increment to increment. A pass takes over the new frames and stencils of all points, but the new
//! compliance of those only that are in contact: elsewhere it is an older one. That changes no answer, because initial gaps make the gap of every
//! point exact at the displacement of the geometry, whatever compliance it is seen with, and an increment is accepted only when all points that touch have theirs.

use std::sync::Arc;

use nalgebra::DVector;

use super::StepRecord;
use super::travel::travel;
use crate::deformed::{DeformedGaps, Geometry, LARGEST_ERROR, PASSES, TOLERANCE, Unfaced};
use crate::problem::{Contacts, InterfaceProblem};
use crate::solver::{FailureCause, Step, StepFailure, StepSolution, Work};
use crate::state::{ContactState, TrialState};

/// Name under which failures of the passes are reported.
const NAME: &str = "deformed gaps";
/// Changes and errors of the geometry are measured by the largest motion, or by so much of how far points are displaced from the mean of their body.
const LEAST_MOTION: f64 = 1e-2;
/// Points beside those in contact whose compliance is taken over too, because contact may spread to them.
const BESIDE: usize = 3;

/// A problem on the geometry at the end of an increment.
#[derive(Debug)]
pub(super) struct Taken {
    problem: InterfaceProblem,
    /// Points whose compliance is that of the geometry.
    in_play: Vec<bool>,
    /// The points as the record of the increment has them.
    contacts: Arc<Contacts>,
}

/// The passes of one increment.
#[derive(Debug)]
pub(super) struct Passes<'a> {
    undeformed: &'a InterfaceProblem,
    gaps: &'a DeformedGaps<'a>,
    problem: InterfaceProblem,
    in_play: Vec<bool>,
    /// The last accepted state, its displacements counted in the frames of the problem.
    start: ContactState,
    /// Displacements of the bodies there.
    committed: Vec<DVector<f64>>,
    work: Work,
}

/// What a pass found.
struct Found {
    record: StepRecord,
    trial: TrialState,
    /// Displacements of the bodies, and the geometry there.
    moved: Vec<DVector<f64>>,
    geometry: Geometry,
    /// Change of that from the geometry on which it was found.
    change: f64,
    /// By what changes are measured `[length]`.
    size: f64,
}

impl<'a> Passes<'a> {
    /// Those from the end of `from`, on the problem `known` if that is of its geometry.
    pub(super) fn new(
        undeformed: &'a InterfaceProblem,
        gaps: &'a DeformedGaps<'a>,
        from: &StepRecord,
        known: Option<Taken>,
    ) -> Result<Self, StepFailure> {
        let committed = if let Some(moved) = &from.moved {
            moved.to_vec()
        } else {
            let before = from.contacts_of(undeformed.contacts());
            gaps.displacements(undeformed, before, &from.state, &from.state.multipliers)
        };
        let same = |known: &Taken| {
            let own = from.contacts.as_ref();
            own.is_some_and(|own| Arc::ptr_eq(own, &known.contacts))
        };
        let start = from.state.clone();
        let (undeformed, work) = (undeformed, Work::default());
        if let Some(known) = known.filter(same) {
            return Ok(Self {
                undeformed,
                gaps,
                problem: known.problem,
                in_play: known.in_play,
                start,
                committed,
                work,
            });
        }
        let mut passes = Self {
            undeformed,
            gaps,
            problem: undeformed.clone(),
            in_play: vec![false; start.status.len()],
            start,
            committed,
            work,
        };
        let geometry = passes.geometry(&passes.committed)?;
        let state = from.state.clone();
        let moved = passes.committed.clone();
        passes.take(&geometry, &moved, &state);
        for (k, gap) in geometry.gaps().into_iter().enumerate() {
            passes.start.motion[2 * k] = gap;
        }
        Ok(passes)
    }

    /// Moves bodies that bear nowhere to where they begin to bear on the way to the load multipliers `target`. Where that is depends on the
    /// geometry there.
    pub(super) fn travel(&mut self, target: &[f64]) -> Result<(), StepFailure> {
        let from = self.start.multipliers.clone();
        for last in [false, false, true] {
            let Some((state, multipliers)) = travel(&self.problem, &self.start, [&from, target])
            else {
                return Ok(());
            };
            let contacts = self.problem.contacts();
            let moved = (self.gaps).displacements(self.undeformed, contacts, &state, &multipliers);
            if last {
                (self.start, self.committed) = (state, moved);
                break;
            }
            let geometry = self.geometry(&moved)?;
            let there = ContactState {
                multipliers,
                ..state
            };
            self.take(&geometry, &moved, &there);
        }
        Ok(())
    }

    /// The increment to the load multipliers `multipliers`, each pass solved by `by`.
    pub(super) fn settle(
        &mut self,
        multipliers: &[f64],
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
    ) -> Result<StepRecord, StepFailure> {
        let (mut last, mut change) = (None, f64::INFINITY);
        for _ in 0..PASSES {
            let found = self.pass(multipliers, last.as_ref(), &by)?;
            if found.change <= TOLERANCE {
                return self.accept(found);
            }
            self.take(&found.geometry, &found.moved, &found.record.state);
            (last, change) = (Some(found.trial), found.change);
        }
        Err(self.refusal(FailureCause::Geometry {
            passes: PASSES,
            change,
        }))
    }

    /// What later increments need of the problem on which `record` was found.
    pub(super) fn taken(self, record: &StepRecord) -> Option<Taken> {
        let contacts = record.contacts.clone()?;
        Some(Taken {
            problem: self.problem,
            in_play: self.in_play,
            contacts,
        })
    }

    fn pass(
        &mut self,
        multipliers: &[f64],
        last: Option<&TrialState>,
        by: impl Fn(&Step<'_>) -> Result<StepSolution, StepFailure>,
    ) -> Result<Found, StepFailure> {
        let mut step = Step::new(&self.problem, &self.start, multipliers);
        if let Some(last) = last {
            step = step.near(last);
        }
        let solved = StepRecord::solved(&step, by);
        let (record, trial) = solved.map_err(|mut failure| {
            failure.work += self.work;
            failure
        })?;
        self.work += record.work;
        self.work.updates += 1;
        let contacts = self.problem.contacts();
        let moved =
            (self.gaps).displacements(self.undeformed, contacts, &record.state, multipliers);
        let geometry = self.geometry(&moved)?;
        // Where all points stick to each other they move by rounding only.
        let size = record
            .state
            .motion
            .amax()
            .max(LEAST_MOTION * spread(&moved));
        Ok(Found {
            change: self.change((&record.state, size), &geometry),
            size,
            record,
            trial,
            moved,
            geometry,
        })
    }

    fn accept(&self, found: Found) -> Result<StepRecord, StepFailure> {
        let Found {
            mut record,
            geometry,
            size,
            ..
        } = found;
        let error = geometry.error() / size;
        if error > LARGEST_ERROR {
            return Err(self.refusal(FailureCause::Apart {
                error,
                limit: LARGEST_ERROR,
            }));
        }
        record.work = self.work;
        record.contacts = Some(Arc::new(self.problem.contacts().clone()));
        Ok(record)
    }

    /// The geometry where the bodies are displaced by `moved`.
    fn geometry(&self, moved: &[DVector<f64>]) -> Result<Geometry, StepFailure> {
        let geometry = Geometry::at(self.gaps, self.undeformed.pairs(), moved);
        geometry.map_err(|Unfaced { point }| self.refusal(FailureCause::Unfaced { point }))
    }

    fn refusal(&self, cause: FailureCause) -> StepFailure {
        StepFailure::new(NAME, cause, self.work)
    }

    /// The largest change of a gap to `geometry` from what the problem has in `state`, relative to `size`, or of the normal of a
    /// point in contact; infinite where a point touches whose compliance is an older one.
    fn change(&self, (state, size): (&ContactState, f64), geometry: &Geometry) -> f64 {
        let normals = geometry.normals();
        let mut change = 0.0_f64;
        for (k, gap) in geometry.gaps().into_iter().enumerate() {
            let apart = (gap - state.gap(k)).abs();
            change = change.max(if size > 0.0 { apart / size } else { 0.0 });
            if state.status[k].touches() {
                if !self.in_play[k] {
                    return f64::INFINITY;
                }
                let own = self.problem.points()[k].normal;
                let turn = [0, 1].map(|i| normals[k][i] - own[i]);
                change = change.max(turn[0].hypot(turn[1]));
            }
        }
        change
    }

    /// Takes over `geometry`, where the bodies are displaced by `moved` in `state`.
    fn take(&mut self, geometry: &Geometry, moved: &[DVector<f64>], state: &ContactState) {
        self.in_play = self.beside_contact(state);
        let (pairs, couples) = (geometry.pairs().to_vec(), geometry.couples().to_vec());
        (self.problem).move_points(self.gaps.bodies(), pairs, couples, &self.in_play);
        let of_bodies = geometry.relative(moved);
        let slipped = [moved, &self.committed].map(|moved| geometry.relative_to_faced(moved));
        let seen = (self.problem).relative_motion(&state.forces, &state.rigid, &state.multipliers);
        let mut gaps = geometry.gaps();
        for (k, gap) in gaps.iter_mut().enumerate() {
            let [normal, tangential] = if self.in_play[k] {
                of_bodies[k]
            } else {
                [seen[2 * k], seen[2 * k + 1]]
            };
            *gap -= normal;
            self.start.motion[2 * k + 1] = tangential - (slipped[0][k][1] - slipped[1][k][1]);
        }
        self.problem.set_gaps(&gaps);
    }

    /// The points that touch in `state`, and those beside them.
    fn beside_contact(&self, state: &ContactState) -> Vec<bool> {
        let mut chosen = vec![false; state.status.len()];
        for pair in 0..self.problem.pairs().len() {
            let points = self.problem.pair_points(pair);
            for k in points.clone().filter(|&k| state.status[k].touches()) {
                let least = points.start.max(k.saturating_sub(BESIDE));
                let most = points.end.min(k + BESIDE + 1);
                chosen[least..most].fill(true);
            }
        }
        chosen
    }
}

/// How far points of a body are displaced from their mean, by `moved`, at most along an axis `[length]`.
fn spread(moved: &[DVector<f64>]) -> f64 {
    let apart = moved.iter().flat_map(|body| {
        (0..2).map(|axis| {
            let along = || body.iter().skip(axis).step_by(2);
            let mean = along().sum::<f64>() / along().count().max(1) as f64;
            along().fold(0.0, |most: f64, by| most.max((by - mean).abs()))
        })
    });
    apart.fold(0.0, f64::max)
}
