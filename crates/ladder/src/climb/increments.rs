//! Increments of load steps: as many as the accuracy needs, or what those that a scene gives leave.

use stickslip_engine::results::LadderEnd;
use stickslip_engine::run::{Progress, RunError};
use stickslip_scene::schema::Ramp;

use super::Climb;
use crate::geometry::Geometry;
use crate::level::Level;
use crate::motions::Motions;
use crate::numbers::{Estimates, Table};
use crate::path::{self, Changes, Halved, Left};
use crate::worst::{Worst, bounds_sets, worst_of_edges, worst_of_sets};

/// Fewest increments of a load step with friction: two and four may agree where few nodes slip.
const LEAST: usize = 8;
/// The same of a first step that presses bodies that overlap, where all points slip at once and up to eight increments change nothing, and of all steps where the scene asks for equal increments.
const MANY: usize = 32;
/// Most increments of a load step that are tried, but for those that end where points close or open.
const MOST: usize = 64;
/// The increments may take this part of what is asked.
const PATH_SHARE: f64 = 0.5;

impl Climb<'_> {
    /// A model whose increments are fine enough, with the error that they leave; `base` is the first one.
    pub(super) fn increments(
        &mut self,
        mut base: Level,
        progress: &mut dyn FnMut(Progress),
    ) -> Result<(Level, Left), RunError> {
        if !base.rubs() {
            return Ok((base, Left::default()));
        }
        let pinned = self.scene.analysis.substeps.is_some();
        if pinned {
            let substeps = times(path::PINNED, &base.substeps);
            let finer = self.models.level(1, &substeps, progress)?;
            let left = path::of_pinned(&finer.numbers, &base.numbers, &base.substeps);
            return Ok((base, left));
        }
        let mut changes = Changes::default();
        let mut left = None;
        let mut halved = vec![true; base.substeps.len()];
        loop {
            let both = base.substeps.iter().zip(&halved);
            let substeps: Vec<usize> = both
                .map(|(count, half)| count << usize::from(*half))
                .collect();
            let finer = match left.take() {
                None => self.models.level(1, &substeps, progress)?,
                Some(left) => match self.level_in_time(1, &substeps, progress)? {
                    Some(finer) => finer,
                    None => return Ok((base, left)),
                },
            };
            let found = changes.halved((&finer.numbers, &base.numbers), &halved, &substeps);
            self.record(&finer, None);
            halved = self.to_halve(&finer, &found);
            let is_fine = !halved.contains(&true);
            // Of fewer increments too little is known to answer with them: all may slip alike.
            let least = LEAST * self.scene.analysis.substeps();
            let is_enough = substeps.iter().all(|&count| count >= least);
            if is_fine || is_enough && self.is_spent(&finer) {
                self.ran_out = !is_fine;
                return Ok((finer, found.left));
            }
            left = is_enough.then_some(found.left);
            base = finer;
        }
    }

    /// The `errors` and the `end` of a climb after what increments leave of the last of `levels` is compared on its own nodes, where the scene gives them; `None` where
    /// the climb goes on.
    pub(super) fn checked(
        &mut self,
        (levels, path, geometry): (&mut [Level], &mut Left, &Geometry),
        (errors, end): (Estimates, LadderEnd),
        progress: &mut dyn FnMut(Progress),
    ) -> Option<(Estimates, LadderEnd)> {
        let (finer, last) = match (self.in_more_increments(levels, progress), levels.last()) {
            (Some(Ok(finer)), Some(last)) => (finer, last),
            // Of the load path too little is known.
            (Some(Err(_)), _) => return Some((errors, LadderEnd::LoadPath)),
            _ => return Some((errors, end)),
        };
        *path = std::mem::take(path).at_least(&finer.numbers, &last.numbers);
        let errors = self.errors(levels, path, geometry);
        match (end, self.end(levels, &errors, path)) {
            (LadderEnd::Reached, None) => None,
            (LadderEnd::Reached, Some(other)) | (_, Some(other @ LadderEnd::LoadPath)) => {
                Some((errors, other))
            }
            _ => Some((errors, end)),
        }
    }

    /// The last of `levels` with twice as many increments, whatever that takes, where the scene gives them, friction acts, and more of them were not compared on the same nodes.
    fn in_more_increments(
        &mut self,
        levels: &[Level],
        progress: &mut dyn FnMut(Progress),
    ) -> Option<Result<Level, RunError>> {
        let last = levels.last().filter(|last| last.rubs() && last.rung > 1)?;
        self.scene.analysis.substeps?;
        Some(
            self.models
                .level(last.rung, &times(2, &last.substeps), progress),
        )
    }

    /// The steps of `level` that more increments have to divide after those that left `found`: those with too large an error, and those before them that may have left it, where it is
    /// not their own or they have as many as are tried.
    fn to_halve(&self, level: &Level, found: &Halved) -> Vec<bool> {
        let is_too_much = |worst: Option<Worst>| {
            self.asked.is_some() && worst.is_some_and(|worst| worst.part > PATH_SHARE)
        };
        let is_large = |errors: &Table, step: usize| {
            is_too_much(worst_of_edges(&level.numbers, errors, self.bounds(), step))
        };
        let substeps = &level.substeps;
        let mut halved = vec![false; substeps.len()];
        let sets = if bounds_sets(&level.numbers, self.bounds()) {
            found.left.sets.only(&self.sets_with_errors(level))
        } else {
            Motions::default()
        };
        for step in 0..substeps.len() {
            if is_too_much(worst_of_sets(&level.numbers, &sets, self.bounds(), step)) {
                // Of sets it is not known which of the steps before leaves it.
                halved[..=step].fill(true);
            }
            halved[step] |= is_large(&found.own, step);
            let is_spent = halved[step] && substeps[step] >= MOST;
            if is_spent || is_large(&found.before, step) {
                for other in 0..step {
                    halved[other] |= is_large(&found.shared(step, other), step);
                }
            }
        }
        let ramp = self.scene.analysis.ramp;
        let are_equal = ramp.is_some_and(|ramp| ramp != Ramp::Contact);
        for (step, (half, &count)) in halved.iter_mut().zip(substeps).enumerate() {
            let least = if are_equal || step == 0 && level.overlaps() {
                MANY
            } else {
                LEAST
            };
            let is_coarse = count < least * self.scene.analysis.substeps();
            *half = (*half || is_coarse) && count < MOST;
        }
        halved
    }
}

/// `count` times the increments of each step.
fn times(count: usize, substeps: &[usize]) -> Vec<usize> {
    substeps.iter().map(|own| count * own).collect()
}
