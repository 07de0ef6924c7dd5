//! Bodies that travel freely before they touch.
//!
//! An increment treats the motion of each point as one step: the travel of a pin through its clearance would count as slip under the
//! forces at the end. So bodies that do not bear where the load presses them are brought there first, without force and without slip.
//!
//! ```text
//! loads on floating bodies     where they come to rest, without friction and deformation
//! driven bodies                the largest part of the increment in which nothing needs to be pressed
//! ```

use nalgebra::DVector;

use crate::problem::InterfaceProblem;
use crate::solver::{Step, balanced_by, released, settled};
use crate::state::{ContactState, Status};

/// Part of an increment in which driven bodies travel nowhere.
const NOWHERE: f64 = 1e-6;
/// Gaps up to this part of the largest are closed, forces up to this part of the largest are zero.
const CLOSED: f64 = 1e-9;
/// Halvings in search of the part at which driven bodies touch.
const HALVINGS: usize = 30;

/// The state from which friction counts in the increment from `committed`, at the load multipliers `ends[0]` `[1]`, to `ends[1]`: `committed` with its
/// bodies moved to where they begin to bear. `None` where there are contact forces, or nothing travels.
pub fn travelled(
    problem: &InterfaceProblem,
    committed: &ContactState,
    ends: [&[f64]; 2],
) -> Option<ContactState> {
    travel(problem, committed, ends).map(|(state, _)| state)
}

/// The state of [`travelled`], and the load multipliers at which bodies begin to bear.
pub(super) fn travel(
    problem: &InterfaceProblem,
    committed: &ContactState,
    [from, target]: [&[f64]; 2],
) -> Option<(ContactState, Vec<f64>)> {
    if committed.forces.amax() > 0.0 {
        return None;
    }
    let at = |part: f64| between(from, target, part);
    let whole = Step::new(problem, committed, target);
    if whole.mode_load().amax() > 0.0 {
        if balanced_by(&whole, &closed(committed)) {
            return None;
        }
        let still = Step::new(problem, committed, from);
        let rest = settled(&still, whole.mode_load())?;
        return Some((moved(&still, committed, rest), from.to_vec()));
    }
    let without_force = |part: f64| {
        let multipliers = at(part);
        let step = Step::new(problem, committed, &multipliers);
        let solution = released(&step)?;
        let state = moved(&step, committed, solution.trial.rigid);
        Some((state, multipliers))
    };
    if without_force(1.0).is_some() {
        return None;
    }
    let (mut free, mut pressed, mut last) = (0.0, 1.0, None);
    for _ in 0..HALVINGS {
        let middle = f64::midpoint(free, pressed);
        match without_force(middle) {
            Some(found) => (free, last) = (middle, Some(found)),
            None => pressed = middle,
        }
    }
    last.filter(|_| free > NOWHERE)
}

/// Whether contact parts and bears elsewhere between the forces `before` and `after`: no point that was pressed still is. What bodies travel
/// in between then counts as slip.
pub(super) fn parts(before: &DVector<f64>, after: &DVector<f64>) -> bool {
    let pressed = |forces: &DVector<f64>, k: usize| forces[2 * k] > CLOSED * forces.amax();
    let stays = |k: usize| pressed(before, k) && pressed(after, k);
    before.amax() > 0.0 && after.amax() > 0.0 && !(0..before.len() / 2).any(stays)
}

fn between(from: &[f64], target: &[f64], part: f64) -> Vec<f64> {
    let ends = from.iter().zip(target);
    ends.map(|(from, to)| (1.0 - part) * from + part * to)
        .collect()
}

/// The points that are closed.
fn closed(state: &ContactState) -> Vec<usize> {
    let count = state.status.len();
    let largest = (0..count).fold(0.0, |most: f64, k| most.max(state.gap(k).abs()));
    (0..count)
        .filter(|&k| state.gap(k) <= CLOSED * largest)
        .collect()
}

fn moved(step: &Step<'_>, committed: &ContactState, rigid: DVector<f64>) -> ContactState {
    let forces = DVector::zeros(2 * step.count());
    ContactState {
        motion: step.total_motion(step.motion(&forces, &rigid)),
        forces,
        rigid,
        status: vec![Status::Open; step.count()],
        ..committed.clone()
    }
}
