//! What stops floating bodies whose load is not balanced.

use nalgebra::DVector;

use super::FailureCause;
use super::accept::{ACCEPTED, ROUNDING};
use super::balance::part_of_load;
use super::frozen::Frozen;
use super::residual::Scales;
use super::step::Step;
use crate::state::Status;

/// Closing speeds below this part of the motion's are rounding: turning a round body about its centre closes nothing.
const CLOSING: f64 = 1e-9;
/// Unbalanced resultants below this part of the contact forces are what is left of a symmetric problem.
const SYMMETRIC: f64 = 1e-8;

/// What can stop the bodies from moving along `direction`, on which the load does work: the open point that first closes;
/// if none does, sticking of slipping points on the way, and of open points that are already pressed together. Of the slipping
/// ones, those that the motion would turn first are enough if their friction, turned against it, outweighs what is unbalanced.
/// Empty if nothing stops them, but what is unbalanced is within the tolerance of a verified state.
pub(super) fn hold(
    step: &Step<'_>,
    status: &[Status],
    frozen: &Frozen,
    direction: &[f64],
) -> Result<Vec<usize>, FailureCause> {
    let modes = step.problem.modes();
    let rate = |row: usize| {
        modes
            .row(row)
            .iter()
            .zip(direction)
            .map(|(mode, amount)| mode * amount)
            .sum::<f64>()
    };
    let speed = direction
        .iter()
        .fold(0.0, |largest: f64, value| largest.max(value.abs()));
    let mut first: Option<(f64, usize)> = None;
    let (mut pressed, mut turning) = (Vec::new(), Vec::new());
    let mut proved = true;
    for k in 0..status.len() {
        let (normal, tangential) = (rate(2 * k), rate(2 * k + 1));
        let open = status[k] == Status::Open;
        if open && normal < -CLOSING * speed {
            let time = frozen.motion[2 * k] / -normal;
            if first.is_none_or(|(earliest, _)| time < earliest) {
                first = Some((time, k));
            }
        }
        let slides = tangential.abs() > ROUNDING * speed;
        let friction = slides && step.bound(k, step.problem.points()[k].area, 0.0).stick > 0.0;
        proved &= !friction;
        if friction && (status[k].slip_sign() != 0.0 || (open && frozen.motion[2 * k] < 0.0)) {
            pressed.push(k);
            let drive = frozen.forces[2 * k + 1] * tangential;
            if drive > 0.0 {
                turning.push((frozen.motion[2 * k + 1].abs() / tangential.abs(), k, drive));
            }
        }
    }
    // To stop a motion that rounding alone drives, any choice among the points would break a symmetry.
    let driven = speed > SYMMETRIC * frozen.forces.amax();
    let unbalanced: f64 = direction.iter().map(|amount| amount * amount).sum();
    let held = match first {
        Some((_, point)) => vec![point],
        None if driven => first_turned(turning, unbalanced).unwrap_or(pressed),
        None => pressed,
    };
    let scale = || Scales::of(step, &frozen.forces, &frozen.motion).force;
    if held.is_empty() && speed > ACCEPTED * scale() {
        return Err(FailureCause::Unbalanced {
            part: part_of_load(step, &DVector::from_column_slice(direction)),
            motion: direction.to_vec(),
            proved,
        });
    }
    Ok(held)
}

/// Of slipping points, each with the amount of motion that turns it and the power of its friction in that motion, the first
/// whose turning stops the motion; `None` if all together do not.
fn first_turned(mut turning: Vec<(f64, usize, f64)>, unbalanced: f64) -> Option<Vec<usize>> {
    turning.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut left = unbalanced;
    let mut held = Vec::new();
    for (_, point, drive) in turning {
        held.push(point);
        left -= 2.0 * drive;
        if left < 0.0 {
            return Some(held);
        }
    }
    None
}
