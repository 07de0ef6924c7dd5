//! Errors of forces, displacements and stiffness of loaded and held sets.
//!
//! ```text
//! size = k max(|v_h − v_2h|, |v_2h − v_4h| r),     error = max(size, WIDE · s · the largest size of all steps as a part of s)
//! ```
//!
//! k is 1, and more of general outlines: where a clamp ends at a re-entrant corner, energies converge like h^0.5 to h^0.7 and changes fall by a third from model to model. s is |v|, or a tenth of the largest of the history. r is the part that a change should be of the one before, as in [`division`](super::division). What load path and geometry leave is added.

use super::rates;
use stickslip_engine::results::{Results, SetMotion, SetNumbers, SetStated};

/// A change may vanish by chance; this part of the largest one of all steps does not.
const WIDE: f64 = 0.4;
/// Part of the largest value of a history by which smaller ones are measured.
const SMALL: f64 = 0.1;
/// Part of the largest value that rounding may leave.
const ROUNDING: f64 = 1e-9;

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

    pub(super) fn get(&self, step: usize, set: usize, stated: SetStated) -> Option<f64> {
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

    /// These errors and `other` ones, which may be empty.
    pub(super) fn and(&self, other: &Self) -> Self {
        self.map(|step, set, stated| {
            let other = other.get(step, set, stated).unwrap_or(0.0);
            Some(self.get(step, set, stated)? + other)
        })
    }

    /// The larger ones of these errors and `other` ones.
    pub(super) fn or_larger(&self, other: &Self) -> Self {
        self.map(|step, set, stated| {
            let other = other.get(step, set, stated).unwrap_or(0.0);
            Some(self.get(step, set, stated)?.max(other))
        })
    }

    /// Number of sets.
    pub(super) fn count(&self) -> usize {
        self.0.first().map_or(0, Vec::len)
    }

    /// Whether any set has a `stated` number in any step.
    pub(super) fn have(&self, stated: SetStated) -> bool {
        let mut all = self.0.iter().flatten();
        all.any(|own| own.get(stated).is_some())
    }

    /// The largest `stated` number of the set with this index in any step.
    pub(super) fn largest(&self, set: usize, stated: SetStated) -> f64 {
        let values = (0..self.0.len()).filter_map(|step| self.get(step, set, stated));
        values.fold(0.0, |most: f64, value| most.max(value.abs()))
    }

    /// The largest force on each set in any step.
    pub(super) fn forces(&self) -> Vec<f64> {
        let sets = 0..self.count();
        sets.map(|set| self.largest(set, SetStated::Force))
            .collect()
    }

    /// The part of these errors that are `left`, and the others.
    pub(super) fn split(&self, left: &Self) -> (Self, Self) {
        let part = self.map(|step, set, stated| {
            left.get(step, set, stated)
                .filter(|_| self.get(step, set, stated).is_some())
        });
        let others = self.map(|step, set, stated| {
            Some(self.get(step, set, stated)? - part.get(step, set, stated).unwrap_or(0.0))
        });
        (part, others)
    }

    /// Those that `with_errors` says of every set, and no others.
    pub(super) fn only(&self, with_errors: &[[bool; 4]]) -> Self {
        self.map(|step, set, stated| {
            let has_error = with_errors.get(set)?[stated as usize];
            self.get(step, set, stated).filter(|_| has_error)
        })
    }

    pub(super) fn times(&self, factor: f64) -> Self {
        self.map(|step, set, stated| Some(factor * self.get(step, set, stated)?))
    }

    /// How far those of `one` are from those of `other`.
    pub(super) fn between(one: &Self, other: &Self) -> Self {
        one.map(|step, set, stated| {
            let both = [one, other].map(|own| own.get(step, set, stated));
            Some((both[0]? - both[1]?).abs())
        })
    }

    /// What the division of the last of `levels` leaves; empty where there is one only. A change should be the part `rate` of the one before.
    pub(super) fn of_division(levels: &[&Self], rate: f64) -> Self {
        let [.., coarse, fine] = levels else {
            return Self::default();
        };
        let last = Self::between(fine, coarse);
        let before = match levels {
            [.., coarser, coarse, _] => Self::between(coarse, coarser),
            _ => Self::default(),
        };
        let size = last.map(|step, set, stated| {
            let before = before.get(step, set, stated).unwrap_or(0.0);
            Some(last.get(step, set, stated)?.max(rate * before))
        });
        let steps = 0..fine.0.len();
        last.map(|step, set, stated| {
            let value = |step: usize| fine.get(step, set, stated).map_or(0.0, f64::abs);
            let largest = steps.clone().map(value).fold(0.0, f64::max);
            let scale = |step: usize| value(step).max(SMALL * largest);
            let parts = steps
                .clone()
                .filter_map(|step| Some(size.get(step, set, stated)? / scale(step)));
            let wide =
                WIDE * scale(step) * parts.filter(|part| part.is_finite()).fold(0.0, f64::max);
            Some(size.get(step, set, stated)?.max(wide))
        })
    }

    /// These errors, none of them below what rounding leaves of the largest force of all sets, and of the largest number of its own in `numbers`.
    pub(super) fn above_rounding(&self, numbers: &Self) -> Self {
        let force = numbers.forces().into_iter().fold(0.0, f64::max);
        self.map(|step, set, stated| {
            let scale = match stated {
                SetStated::Force => force,
                _ => numbers.largest(set, stated),
            };
            Some(self.get(step, set, stated)?.max(ROUNDING * scale))
        })
    }

    /// Puts these errors into `found`.
    pub(super) fn put(self, found: &mut Results) {
        for (step, errors) in found.steps.iter_mut().zip(self.0) {
            step.set_errors = errors;
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
    pub(super) fn halved(&mut self, finer: &Motions, base: &Motions, halved: &[bool]) -> Motions {
        let change = Motions::between(finer, base);
        let shows = |step: usize| halved[..=step].contains(&true);
        let left = change.map(|step, set, stated| {
            let left = self.left.get(step, set, stated);
            if !shows(step) {
                return left;
            }
            let last = self.last.get(step, set, stated);
            let own = rates::error(change.get(step, set, stated), last)?;
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

/// What given increments leave, by what four times as many change, those of `finer`.
pub(super) fn of_pinned(finer: &Motions, base: &Motions) -> Motions {
    Motions::between(finer, base).times(rates::of_four())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Displacements of one set in two steps.
    fn moved(steps: [f64; 2]) -> Motions {
        let step = |displacement| {
            vec![Some(SetMotion {
                force: 1.0,
                displacement,
            })]
        };
        Motions::of(&steps.map(step))
    }

    fn errors(own: &Motions) -> [f64; 2] {
        [0, 1].map(|step| own.get(step, 0, SetStated::Displacement).unwrap())
    }

    fn close(found: [f64; 2], wanted: [f64; 2]) {
        let mut both = found.iter().zip(wanted);
        assert!(both.all(|(a, b)| (a - b).abs() < 1e-12), "{found:?}");
    }

    #[test]
    fn a_step_that_is_not_halved_keeps_its_error() {
        let mut halving = Halving::default();
        let [first, second, third] = [[1.0, 2.0], [1.1, 2.2], [1.1, 2.3]].map(moved);
        // Of one change the slowest rate is taken, of two of them their own.
        close(
            errors(&halving.halved(&second, &first, &[true, true])),
            [0.4, 0.8],
        );
        // The second step is halved alone: what the first one leaves in it is as large as before.
        close(
            errors(&halving.halved(&third, &second, &[false, true])),
            [0.4, 0.8],
        );
        // Halved together, both errors are at least half of those before.
        close(
            errors(&halving.halved(&third, &third, &[true, true])),
            [0.2, 0.4],
        );
    }

    #[test]
    fn a_change_that_vanishes_by_chance_is_measured_by_other_steps() {
        let [coarse, fine] = [[1.0, 2.0], [1.0, 2.2]].map(moved);
        let found = Motions::of_division(&[&coarse, &fine], 0.5);
        // A part of 0.2/2.2, four tenths of which count in the first step.
        close(errors(&found), [0.4 * 0.2 / 2.2, 0.2]);
        assert!(Motions::of_division(&[&fine], 0.5).0.is_empty());
    }
}
