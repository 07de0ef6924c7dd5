//! What the increments of a load step leave of every stated number.
//!
//! A number v of increments Δ is compared, on a coarse model, with those of 2Δ and 4Δ:
//!
//! ```text
//! error = max(c r/(1 − r), c′/2, c″/4, …),     r = c/c′ between ½ and ⅘,     c = |v_Δ − v_2Δ|,  c′ = |v_2Δ − v_4Δ|, …
//! ```
//!
//! A change may vanish by chance, so those before count as if every halving took half of them. Only steps whose error is too large are divided further;
//! what a step that is not leaves in those after it is at most its own error, and theirs from when both were last halved.
//!
//! Where the scene gives the increments, nothing is gained by few nodes: the last model itself is walked with twice as many as well.

use super::along::Along;
use super::motions::{self, Halving, Motions};
use super::numbers::{Estimates, Numbers, Table, difference, sum, zipped};
use super::rates::{error, of_four, of_two};
use stickslip_contact::Status;
use stickslip_engine::results::{EdgeResults, Errors, Stated};

/// Given increments are compared with so many times as many: two times as many may change nothing where contact grows in proportion to the load.
pub(super) const PINNED: usize = 4;

/// What increments leave of values at nodes, by the change that halving them made.
const PATH: f64 = 2.0;

/// Part of the error of a force that the next step keeps.
const KEPT: f64 = 0.7;
/// The friction force follows the path more slowly than by any fixed rate where much slips; it takes so many times the error of the others.
const FRICTION: f64 = 1.5;

/// Part of the normal force below which a friction force is rounding.
const BALANCED: f64 = 1e-9;

/// What increments leave.
#[derive(Clone, Default)]
pub(super) struct Left {
    pub(super) numbers: Table,
    pub(super) along: Along,
    pub(super) sets: Motions,
}

impl Left {
    /// What these are of all `errors`, and the others. Numbers without a limit have no error, and do not count.
    pub(super) fn part_of(&self, errors: &Estimates) -> (Estimates, Estimates) {
        let numbers = zipped(&errors.numbers, &self.numbers, |own, left| {
            left.filter(|_| own.is_some())
        });
        let others = zipped(&errors.numbers, &numbers, |own, left| {
            Some(own? - left.unwrap_or(0.0))
        });
        let (sets, other_sets) = errors.sets.split(&self.sets);
        let left = Estimates { numbers, sets };
        let others = Estimates {
            numbers: others,
            sets: other_sets,
        };
        (left, others)
    }
}

/// The same after some steps were halved.
pub(super) struct Halved {
    pub(super) left: Left,
    /// Errors of numbers from when a step was last halved itself.
    pub(super) own: Table,
    /// What steps before it leave beside that.
    pub(super) before: Table,
}

impl Halved {
    /// What the step `other` may leave in the step `step`, which has no errors but these: the smaller ones of both.
    pub(super) fn shared(&self, step: usize, other: usize) -> Table {
        let all = sum(&self.own, &self.before);
        let mut shared = vec![Vec::new(); step];
        shared.push(joined(&all[step], &all[other], smaller));
        shared
    }
}

/// The changes of numbers while increments are halved.
#[derive(Default)]
pub(super) struct Changes {
    last: Table,
    /// What the changes before leave of the error.
    left: Table,
    /// The errors of steps when they were last halved.
    settled: Table,
    /// What halving steps before it changed last in a step that was not halved.
    shown: Table,
    /// What steps that are not halved leave in those after them, which are.
    kept: Table,
    /// Errors along edges.
    along: Along,
    along_kept: Along,
    sets: Halving,
}

impl Changes {
    /// What the `substeps` of `finer` leave, of which those of the steps `halved` are twice as many as in `base`. A step that was not halved keeps its own
    /// error, beside that of the steps before it.
    pub(super) fn halved(
        &mut self,
        (finer, base): (&Numbers, &Numbers),
        halved: &[bool],
        substeps: &[usize],
    ) -> Halved {
        let counts: Vec<f64> = substeps.iter().map(|&count| count as f64).collect();
        let changed = Along::between(finer, base).spread(finer, &counts);
        self.along_kept = self.along.kept(&self.along_kept, halved);
        self.along = changed.times(PATH).beside(&self.along, halved);
        self.add(difference(finer, base), halved);
        let (mut own, before) = (self.settled.clone(), self.before());
        let mut numbers = sum(&own, &before);
        adjust(&mut own, &finer.steps);
        keep_forces(&mut numbers);
        adjust(&mut numbers, &finer.steps);
        let along = self.along.and(&self.along_kept);
        Halved {
            left: Left {
                numbers,
                along,
                sets: self.sets.halved(&finer.sets, &base.sets, halved),
            },
            own,
            before,
        }
    }

    /// What steps before each step leave in it beside what it settled at.
    fn before(&self) -> Table {
        zipped(&self.shown, &self.kept, |shown, kept| {
            shown
                .into_iter()
                .chain(kept)
                .reduce(|one, other| one + other)
        })
    }

    /// Takes note of the `change` of numbers that halving the steps `halved` made.
    fn add(&mut self, change: Table, halved: &[bool]) {
        let geometric = zipped(&change, &self.last, error);
        let own = zipped(&geometric, &self.left, |error, left| {
            Some(error?.max(left.unwrap_or(0.0)))
        });
        if self.settled.is_empty() {
            let none: Table = own
                .iter()
                .map(|edges| edges.iter().map(|_| Errors::default()).collect())
                .collect();
            self.settled.clone_from(&none);
            self.shown.clone_from(&none);
            self.kept = none;
        }
        let all = sum(&self.settled, &self.before());
        for step in 0..halved.len() {
            let (before, is_shown) = (&halved[..step], halved[..step].contains(&true));
            if halved[step] {
                // Halving this step does not show what those leave that are not.
                let unseen = (0..step).filter(|&other| !before[other]);
                let unseen = unseen.map(|other| joined(&all[step], &all[other], smaller));
                self.kept[step] = unseen.fold(self.kept[step].clone(), |most, own| {
                    joined(&most, &own, larger)
                });
                self.settled[step].clone_from(&own[step]);
                self.shown[step].fill(Errors::default());
            } else if is_shown {
                self.shown[step].clone_from(&geometric[step]);
            }
            if is_shown && !before.contains(&false) {
                self.kept[step].fill(Errors::default());
            }
        }
        self.left = zipped(&change, &self.left, |change, left| {
            Some(0.5 * change?.max(left.unwrap_or(0.0)))
        });
        self.last = change;
    }
}

/// The errors of the edges of two steps, joined.
fn joined(
    one: &[Errors],
    other: &[Errors],
    join: fn(Option<f64>, Option<f64>) -> Option<f64>,
) -> Vec<Errors> {
    let both = one.iter().zip(other);
    both.map(|(one, other)| Errors::of(|stated| join(one.get(stated), other.get(stated))))
        .collect()
}

/// The larger one of two errors, or the one that there is.
pub(super) fn larger(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    one.into_iter().chain(other).reduce(f64::max)
}

/// The smaller one of two errors.
fn smaller(one: Option<f64>, other: Option<f64>) -> Option<f64> {
    Some(one?.min(other?))
}

/// What given increments leave, by what [`PINNED`] times as many change, those of `finer`.
pub(super) fn of_pinned(finer: &Numbers, base: &Numbers, substeps: &[usize]) -> Left {
    let change = difference(finer, base);
    let mut numbers = zipped(&change, &Table::new(), |change, _| {
        Some(of_four() * change?)
    });
    keep_forces(&mut numbers);
    adjust(&mut numbers, &base.steps);
    // Of a ramp that may be linear the first increment of contact is √n times that of n equal ones.
    let counts: Vec<f64> = substeps
        .iter()
        .map(|&count| (count as f64).sqrt())
        .collect();
    let along = Along::between(base, finer).spread(base, &counts);
    Left {
        numbers,
        along: along.times(of_four()),
        sets: motions::of_pinned(&finer.sets, &base.sets),
    }
}

impl Left {
    /// At least what twice as many increments of the model itself change, those of `finer`: peaks and ends of stick that a coarse model does not have do not change in it either.
    pub(super) fn at_least(self, finer: &Numbers, base: &Numbers) -> Self {
        let change = difference(finer, base);
        let mut own = zipped(&change, &Table::new(), |change, _| Some(of_two() * change?));
        keep_forces(&mut own);
        adjust(&mut own, &base.steps);
        let along = Along::between(base, finer).times(of_two());
        let sets = Motions::between(&finer.sets, &base.sets).times(of_two());
        Self {
            numbers: zipped(&self.numbers, &own, larger),
            along: along.or_larger(&self.along),
            sets: self.sets.or_larger(&sets),
        }
    }
}

/// What a step leaves of forces stays in the steps that follow it, at least [`KEPT`] of it: their own changes may vanish by chance.
fn keep_forces(errors: &mut Table) {
    for step in 1..errors.len() {
        for edge in 0..errors[step].len() {
            let before = errors[step - 1].get(edge).cloned().unwrap_or_default();
            let own = &errors[step][edge];
            let joined = Errors::of(|stated| match stated {
                Stated::FrictionForce | Stated::NormalForce => Some(
                    own.get(stated)?
                        .max(KEPT * before.get(stated).unwrap_or(0.0)),
                ),
                _ => own.get(stated),
            });
            errors[step][edge] = joined;
        }
    }
}

/// The friction force takes [`FRICTION`] times its error. The extents of stick and slip are those of nodes, which hide small changes: they are off by the part of stick by
/// which friction is off, and where stick and slip in one direction take turns, stick may reach to the end of contact.
fn adjust(errors: &mut Table, steps: &[Vec<EdgeResults>]) {
    for (errors, step) in errors.iter_mut().zip(steps) {
        for (errors, edge) in errors.iter_mut().zip(step) {
            let force = errors.get(Stated::FrictionForce);
            // A friction force that balances itself along a line says nothing of stick.
            let rubs = edge.friction_force.abs() > BALANCED * edge.normal_force.abs();
            let force_of_stick = force.filter(|_| rubs);
            let part =
                force_of_stick.map_or(0.0, |error| (error / edge.friction_force.abs()).min(1.0));
            let extent = Stated::StickExtent.value(edge).unwrap_or(0.0);
            let contact = Stated::ContactExtent
                .value(edge)
                .filter(|_| take_turns(edge.rows.iter().map(|row| row.status)));
            let beyond = contact.map_or(0.0, |contact| contact - extent);
            *errors = Errors::of(|stated| match stated {
                Stated::StickExtent | Stated::SlipAway | Stated::SlipTowards => {
                    // Slip has two ends of stick.
                    let ends = if stated == Stated::StickExtent {
                        1.0
                    } else {
                        2.0
                    };
                    let stick = errors.get(Stated::StickExtent).unwrap_or(0.0);
                    let least = stick.max(part * extent).max(beyond);
                    Some(errors.get(stated)?.max(ends * least))
                }
                Stated::FrictionForce => Some(FRICTION * force?),
                _ => errors.get(stated),
            });
        }
    }
}

/// Whether two zones of stick and two of slip in one direction follow each other in turn: increments leave such a pattern where contact advances, for points that one of them closes slip in it.
fn take_turns(statuses: impl Iterator<Item = Status>) -> bool {
    let mut statuses: Vec<Status> = statuses.collect();
    statuses.dedup();
    let slips = |status| matches!(status, Status::SlipPositive | Status::SlipNegative);
    statuses.windows(4).any(|zones| {
        let [stick, slip] = if slips(zones[0]) {
            [zones[1], zones[0]]
        } else {
            [zones[0], zones[1]]
        };
        zones[..2] == zones[2..] && stick == Status::Stick && slips(slip)
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn stick_and_slip_take_turns_by_increments_alone() {
        use Status::{Open, SlipNegative as Back, SlipPositive as Slip, Stick};
        let advancing = [Stick, Slip, Slip, Stick, Slip, Open];
        let [partial, unloading] = [
            vec![Open, Slip, Stick, Stick, Slip, Open],
            vec![Slip, Stick, Back, Stick, Slip, Stick, Back],
        ];
        assert!(take_turns(advancing.into_iter()));
        assert!(!take_turns(partial.into_iter()));
        assert!(!take_turns(unloading.into_iter()));
    }

    fn change(sizes: [f64; 3]) -> Table {
        sizes.map(|size| vec![Errors::of(|_| Some(size))]).to_vec()
    }

    /// What steps before the one `step` leave in it.
    fn before(changes: &Changes, step: usize) -> f64 {
        changes.before()[step][0]
            .get(Stated::PeakPressure)
            .unwrap_or(0.0)
    }

    fn settled(changes: &Changes, step: usize) -> f64 {
        changes.settled[step][0].get(Stated::PeakPressure).unwrap()
    }

    /// While the first of three steps is not halved, halving the second does not show what the first leaves in it, and while both are not, neither does
    /// halving the third.
    #[test]
    fn steps_that_are_not_halved_leave_something_in_those_after_them() {
        let mut changes = Changes::default();
        changes.add(change([4.0, 6.0, 2.0]), &[true, true, true]);
        assert_eq!([1, 2].map(|step| before(&changes, step)), [0.0, 0.0]);
        let first = settled(&changes, 0);
        for _ in 0..2 {
            changes.add(change([0.0, 0.0, 0.0]), &[false, true, false]);
            assert_eq!(before(&changes, 1), first);
            assert!(settled(&changes, 1) < first);
        }
        let third = settled(&changes, 2);
        changes.add(change([0.0, 0.0, 0.0]), &[false, false, true]);
        assert_eq!(before(&changes, 2), third);
        changes.add(change([1.0, 0.1, 0.1]), &[true, true, true]);
        assert_eq!([1, 2].map(|step| before(&changes, step)), [0.0, 0.0]);
    }

    /// What halving the first step showed in the second stays when only the second is halved after that, as far as the first may still leave it.
    #[test]
    fn what_halving_a_step_showed_stays() {
        let mut changes = Changes::default();
        changes.add(change([4.0, 6.0, 0.0]), &[true, true, false]);
        for size in [0.2, 0.1, 0.05] {
            changes.add(change([0.0, size, 0.0]), &[false, true, false]);
        }
        changes.add(change([1.0, 1.5, 0.0]), &[true, false, false]);
        let shown = before(&changes, 1);
        assert!(shown >= 1.5);
        changes.add(change([0.0, 0.02, 0.0]), &[false, true, false]);
        assert!(before(&changes, 1) >= settled(&changes, 0).min(shown));
        // A step that nothing touched keeps what it had.
        let kept = before(&changes, 1);
        changes.add(change([0.0, 0.0, 0.5]), &[false, false, true]);
        assert_eq!(before(&changes, 1), kept);
    }
}
