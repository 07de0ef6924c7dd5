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

use super::along::Along;
use super::numbers::{Numbers, Table, difference, sum, zipped};
use stickslip_engine::results::{EdgeResults, Errors, Stated};

/// The error that increments leave is at most so many times the change that halving them last made.
const SLOWEST: f64 = 4.0;
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
}

/// The same after some steps were halved.
pub(super) struct Halved {
    pub(super) left: Left,
    /// The errors of numbers that halving the step itself makes smaller.
    pub(super) own: Table,
}

/// The changes of numbers while increments are halved.
#[derive(Default)]
pub(super) struct Changes {
    last: Table,
    /// What the changes before leave of the error.
    left: Table,
    /// The errors of steps when they were last halved.
    settled: Table,
    /// What steps leave in those after them since they are not halved any more.
    kept: Table,
    /// Errors along edges.
    along: Along,
    along_kept: Along,
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
        self.keep(halved);
        let changed = Along::between(finer, base).spread(finer, substeps);
        self.along_kept = self.along.kept(&self.along_kept, halved);
        self.along = changed.times(PATH).beside(&self.along, halved);
        let all = self.of_numbers(difference(finer, base), halved);
        let [mut numbers, mut own] = [sum(&all, &self.kept), all];
        adjust(&mut numbers, &finer.steps);
        adjust(&mut own, &finer.steps);
        let along = self.along.and(&self.along_kept);
        Halved {
            left: Left { numbers, along },
            own,
        }
    }

    /// The errors of numbers that `change`, without what is kept.
    fn of_numbers(&mut self, change: Table, halved: &[bool]) -> Table {
        let geometric = zipped(&change, &self.last, error);
        let own = zipped(&geometric, &self.left, |error, left| {
            Some(error?.max(left.unwrap_or(0.0)))
        });
        let mut errors = sum(&geometric, &self.settled);
        self.settled.resize(own.len(), Vec::new());
        for (step, own) in own
            .into_iter()
            .enumerate()
            .filter(|(step, _)| halved[*step])
        {
            errors[step].clone_from(&own);
            self.settled[step] = own;
        }
        self.left = zipped(&change, &self.left, |change, left| {
            Some(0.5 * change?.max(left.unwrap_or(0.0)))
        });
        self.last = change;
        errors
    }

    /// Keeps what steps that are not `halved` leave in those after them, which halving these does not show.
    fn keep(&mut self, halved: &[bool]) {
        self.kept.resize(self.settled.len(), Vec::new());
        for step in 0..self.settled.len() {
            let before = (0..step).filter(|&other| !halved[other]);
            let left = before.map(|other| {
                let both = self.settled[step].iter().zip(&self.settled[other]);
                both.map(|(own, other)| {
                    Errors::of(|stated| Some(own.get(stated)?.min(other.get(stated)?)))
                })
                .collect::<Vec<Errors>>()
            });
            self.kept[step] = match left.reduce(larger) {
                None => Vec::new(),
                Some(left) if halved[step] => larger(left, self.kept[step].clone()),
                Some(_) => continue,
            };
        }
    }
}

/// The larger ones of the errors of edges, of which the second may be empty.
fn larger(one: Vec<Errors>, other: Vec<Errors>) -> Vec<Errors> {
    let joined = zipped(&vec![one], &vec![other], |one, other| {
        Some(one?.max(other.unwrap_or(0.0)))
    });
    joined.into_iter().flatten().collect()
}

/// What given increments leave, by what [`PINNED`] times as many change, those of `finer`.
pub(super) fn of_pinned(finer: &Numbers, base: &Numbers, substeps: &[usize]) -> Left {
    let change = difference(finer, base);
    let mut numbers = zipped(&change, &Table::new(), |change, _| {
        Some(of_four() * change?)
    });
    adjust(&mut numbers, &base.steps);
    let along = Along::between(base, finer).spread(base, substeps);
    Left {
        numbers,
        along: along.times(of_four()),
    }
}

/// The error that given increments leave is at most so many times what [`PINNED`] times as many change.
fn of_four() -> f64 {
    let rate = SLOWEST / (1.0 + SLOWEST);
    1.0 / (1.0 - rate * rate)
}

/// The sum of the geometric series that goes on at the rate of the last two changes, between that of first order and that of [`SLOWEST`].
fn error(change: Option<f64>, before: Option<f64>) -> Option<f64> {
    let change = change?;
    let slowest = SLOWEST / (1.0 + SLOWEST);
    let rate = before.map_or(slowest, |before| (change / before).clamp(0.5, slowest));
    // Equal numbers have no rate.
    let rate = if rate.is_finite() { rate } else { slowest };
    Some(change * rate / (1.0 - rate))
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
/// which friction is off.
fn adjust(errors: &mut Table, steps: &[Vec<EdgeResults>]) {
    keep_forces(errors);
    for (errors, step) in errors.iter_mut().zip(steps) {
        for (errors, edge) in errors.iter_mut().zip(step) {
            let force = errors.get(Stated::FrictionForce);
            // A friction force that balances itself along a line says nothing of stick.
            let rubs = edge.friction_force.abs() > BALANCED * edge.normal_force.abs();
            let force_of_stick = force.filter(|_| rubs);
            let part =
                force_of_stick.map_or(0.0, |error| (error / edge.friction_force.abs()).min(1.0));
            *errors = Errors::of(|stated| match stated {
                Stated::StickExtent | Stated::SlipAway | Stated::SlipTowards => {
                    let extent = Stated::StickExtent.value(edge).unwrap_or(0.0);
                    // Slip has two ends of stick.
                    let ends = if stated == Stated::StickExtent {
                        1.0
                    } else {
                        2.0
                    };
                    let stick = errors.get(Stated::StickExtent).unwrap_or(0.0);
                    Some(errors.get(stated)?.max(ends * stick.max(part * extent)))
                }
                Stated::FrictionForce => Some(FRICTION * force?),
                _ => errors.get(stated),
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// While the first of two steps is not halved, halving the second does not show what the first leaves in it.
    #[test]
    fn steps_that_are_not_halved_leave_something_in_those_after_them() {
        let change = |first: f64, second: f64| {
            [first, second]
                .map(|size| vec![Errors::of(|_| Some(size))])
                .to_vec()
        };
        let peak = |of: &[Vec<Errors>]| {
            let edge = of.get(1).and_then(|edges| edges.first());
            edge.and_then(|errors| errors.get(Stated::PeakPressure))
        };
        let mut changes = Changes::default();
        changes.keep(&[true, true]);
        changes.of_numbers(change(4.0, 6.0), &[true, true]);
        assert_eq!(peak(&changes.kept), None);
        let first = changes.settled[0][0].get(Stated::PeakPressure);
        for _ in 0..2 {
            changes.keep(&[false, true]);
            let own = changes.of_numbers(change(0.0, 0.0), &[false, true]);
            assert_eq!(peak(&changes.kept), first);
            assert!(peak(&own) < first);
        }
        changes.keep(&[true, true]);
        assert_eq!(peak(&changes.kept), None);
    }
}
