//! Errors of forces, displacements and stiffness of loaded and held sets.
//!
//! ```text
//! size = max(|v_h − v_2h|, |v_2h − v_4h| r),     error = max(size, WIDE · |v| · the largest size of all steps as a part of v)
//! ```
//!
//! r is the part that a change should be of the one before, as in [`division`](super::division). What load path and geometry leave is added.

use super::division::Spaced;
use super::numbers::Numbers;
use super::path;
use stickslip_engine::results::{Results, SetMotion, SetNumbers, SetStated};

/// A change may vanish by chance; this part of the largest one of all steps does not.
const WIDE: f64 = 0.4;
/// Part of the largest value of a history by which smaller ones are measured.
const SMALL: f64 = 0.1;

/// Numbers of sets, or their errors, per step and set.
#[derive(Clone, Default)]
pub(super) struct Motions(Vec<Vec<SetNumbers>>);

impl Motions {
    /// Those of `sets`, per step and set.
    pub(super) fn of(sets: &[Vec<Option<SetMotion>>]) -> Self {
        let steps = sets.len();
        let numbers = |step: usize| {
            let own = 0..sets[step].len();
            own.map(|set| SetNumbers::at(|step| sets[step][set], steps, step))
                .collect()
        };
        Self((0..steps).map(numbers).collect())
    }

    fn get(&self, step: usize, set: usize, stated: SetStated) -> Option<f64> {
        self.0.get(step)?.get(set)?.get(stated)
    }

    /// What `number` makes of every one of these, of its step, set and name.
    fn map(&self, number: impl Fn(usize, usize, SetStated) -> Option<f64>) -> Self {
        let of_set = |step, set| SetNumbers::of(|stated| number(step, set, stated));
        let steps = self.0.iter().enumerate();
        let steps =
            steps.map(|(step, sets)| (0..sets.len()).map(|set| of_set(step, set)).collect());
        Self(steps.collect())
    }

    /// How far these are from `other`.
    fn beside(&self, other: &Self) -> Self {
        self.map(|step, set, stated| {
            let both = [self, other].map(|own| own.get(step, set, stated));
            Some((both[0]? - both[1]?).abs())
        })
    }

    /// These errors and `other` ones, which may be empty.
    pub(super) fn and(&self, other: &Self) -> Self {
        self.map(|step, set, stated| {
            let other = other.get(step, set, stated).unwrap_or(0.0);
            Some(self.get(step, set, stated)? + other)
        })
    }

    pub(super) fn times(&self, factor: f64) -> Self {
        self.map(|step, set, stated| Some(factor * self.get(step, set, stated)?))
    }

    /// How far those of `one` are from those of `other`.
    pub(super) fn between(one: &Numbers, other: &Numbers) -> Self {
        one.sets.beside(&other.sets)
    }

    /// What the division of the last of `levels` leaves; empty where there is one only.
    pub(super) fn of_division(levels: &[&Numbers], nodes: Spaced) -> Self {
        let [.., coarse, fine] = levels else {
            return Self::default();
        };
        let last = Self::between(fine, coarse);
        let before = match levels {
            [.., coarser, coarse, _] => Self::between(coarse, coarser),
            _ => Self::default(),
        };
        let rate = if nodes.are_graded() { 0.25 } else { 0.5 };
        let size = last.map(|step, set, stated| {
            let before = before.get(step, set, stated).unwrap_or(0.0);
            Some(last.get(step, set, stated)?.max(rate * before))
        });
        let steps = 0..fine.sets.0.len();
        last.map(|step, set, stated| {
            let value = |step: usize| fine.sets.get(step, set, stated).map_or(0.0, f64::abs);
            let largest = steps.clone().map(value).fold(0.0, f64::max);
            let parts = steps.clone().filter_map(|step| {
                Some(size.get(step, set, stated)? / value(step).max(SMALL * largest))
            });
            let wide =
                WIDE * value(step) * parts.filter(|part| part.is_finite()).fold(0.0, f64::max);
            Some(size.get(step, set, stated)?.max(wide))
        })
    }

    /// Puts these errors into `found`, those of displacements and stiffness where they have a limit.
    pub(super) fn put(&self, found: &mut Results, has_limit: &[bool]) {
        for (step, own) in found.steps.iter_mut().zip(&self.0) {
            let errors = own.iter().zip(has_limit).map(|(errors, &has_limit)| {
                SetNumbers::of(|stated| {
                    let is_known = has_limit || stated == SetStated::Force;
                    errors.get(stated).filter(|_| is_known)
                })
            });
            step.set_errors = errors.collect();
        }
    }
}

/// The changes of these numbers while increments are halved.
#[derive(Default)]
pub(super) struct Halving {
    last: Motions,
    left: Motions,
}

impl Halving {
    /// What the increments of `finer` leave, of which those of the steps `halved` are half as long as in `base`.
    pub(super) fn halved(&mut self, finer: &Numbers, base: &Numbers, halved: &[bool]) -> Motions {
        let change = Motions::between(finer, base);
        let shows = |step: usize| halved[..=step].contains(&true);
        let left = change.map(|step, set, stated| {
            let left = self.left.get(step, set, stated);
            if !shows(step) {
                return left;
            }
            let last = self.last.get(step, set, stated);
            let own = path::error(change.get(step, set, stated), last)?;
            // What a step that is not halved leaves in those after it is as large as before.
            let part = if halved[..=step].contains(&false) {
                1.0
            } else {
                0.5
            };
            Some(own.max(part * left.unwrap_or(0.0)))
        });
        self.last = change.map(|step, set, stated| {
            let known = if shows(step) { &change } else { &self.last };
            known.get(step, set, stated)
        });
        self.left = left;
        self.left.clone()
    }
}

/// What given increments leave, by what [`path::PINNED`] times as many change, those of `finer`.
pub(super) fn of_pinned(finer: &Numbers, base: &Numbers) -> Motions {
    Motions::between(finer, base).times(path::of_four())
}
