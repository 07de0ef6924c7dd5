//! What the increments of a load step leave of every stated number.
//!
//! A number v of increments Δ is compared, on a coarse model, with those of 2Δ and 4Δ:
//!
//! ```text
//! error = max(c r/(1 − r), c′/2, c″/4, …),     r = c/c′ between ½ and ⅘,     c = |v_Δ − v_2Δ|,  c′ = |v_2Δ − v_4Δ|, …
//! ```
//!
//! A change may vanish by chance, so those before count as if every halving took half of them. Only steps whose error is too large are divided further.

use super::numbers::{Table, sum, zipped};
use stickslip_engine::results::{EdgeResults, Errors, Stated};

/// The error that increments leave is at most so many times the change that halving them last made.
const SLOWEST: f64 = 4.0;
/// Given increments are compared with so many times as many: two times as many may change nothing where contact grows in proportion to the load.
pub(super) const PINNED: usize = 4;

/// Part of the error of a force that the next step keeps.
const KEPT: f64 = 0.7;
/// The friction force follows the path more slowly than by any fixed rate where much slips; it takes so many times the error of the others.
const FRICTION: f64 = 1.5;

/// Part of the normal force below which a friction force is rounding.
const BALANCED: f64 = 1e-9;

/// The changes of numbers while increments are halved.
#[derive(Default)]
pub(super) struct Changes {
    last: Table,
    /// What the changes before leave of the error.
    left: Table,
    /// The errors of steps when they were last halved.
    settled: Table,
}

impl Changes {
    /// The errors that increments leave after those of the steps `halved` were, which changed the numbers of `steps` by `change`. A step that was not
    /// keeps its own error, beside that of the steps before it.
    pub(super) fn halved(
        &mut self,
        change: Table,
        steps: &[Vec<EdgeResults>],
        halved: &[bool],
    ) -> Table {
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
        adjust(&mut errors, steps);
        errors
    }
}

/// The errors that given increments leave, by what [`PINNED`] times as many change.
pub(super) fn of_pinned(change: &Table, steps: &[Vec<EdgeResults>]) -> Table {
    let mut errors = zipped(change, &Table::new(), |change, _| Some(of_four() * change?));
    adjust(&mut errors, steps);
    errors
}

/// The error that given increments leave is at most so many times what [`PINNED`] times as many change.
pub(super) fn of_four() -> f64 {
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
