//! What stops floating bodies whose load is not balanced.

use super::FailureCause;
use super::accept::ROUNDING;
use super::frozen::Frozen;
use super::step::Step;
use crate::state::Status;

/// What can stop the bodies from moving along `direction`, on which the load does work: the open point that first closes;
/// if none does, sticking of all slipping points on the way, and of open points that are already pressed together.
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
    let mut pressed = Vec::new();
    let mut proved = true;
    for k in 0..status.len() {
        let (normal, tangential) = (rate(2 * k), rate(2 * k + 1));
        let open = status[k] == Status::Open;
        if open && normal < -ROUNDING * speed {
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
        }
    }
    let held = first.map_or(pressed, |(_, k)| vec![k]);
    if held.is_empty() {
        return Err(FailureCause::Unbalanced {
            motion: direction.to_vec(),
            proved,
        });
    }
    Ok(held)
}
