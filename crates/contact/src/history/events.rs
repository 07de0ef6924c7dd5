//! Increments that end where points close or open.
//!
//! What a point slips counts from where it was when its increment began. One that closes within an increment is held back from a place that it had left when it closed, and friction is wrong by
//! what it moved until then: an error that falls no faster than increments are halved. There is none of it where each increment ends as a point closes, and between two changes of contact gaps and
//! forces are almost linear in the load, so the last increment predicts where the next point closes or opens.

use nalgebra::DVector;

use crate::state::ContactState;

/// Part of the way to an event at which an increment ends: rounding then never decides on which side of it.
const SHORT: f64 = 1.0 - 1e-6;

/// Changes up to this part of the largest force or motion are rounding.
const ROUNDING: f64 = 1e-9;

/// Gaps and forces where the last increment began.
#[derive(Clone, Debug)]
pub(super) struct Before {
    motion: DVector<f64>,
    forces: DVector<f64>,
    /// Fraction of the load step there `[1]`.
    at: f64,
}

impl Before {
    /// Those of `state` at the fraction `at` of the load step.
    pub(super) fn of(state: &ContactState, at: f64) -> Self {
        Self {
            motion: state.motion.clone(),
            forces: state.forces.clone(),
            at,
        }
    }

    /// The fraction of the load step at which the first point closes or opens if gaps and normal forces go on to fall as they did from here to `state` at `at`; `None` if none falls.
    pub(super) fn next(&self, state: &ContactState, at: f64) -> Option<f64> {
        let [least_force, least_gap] =
            [&state.forces, &state.motion].map(|of| ROUNDING * of.amax());
        let falling = state.status.iter().enumerate().filter_map(|(k, status)| {
            let ([before, now], least) = if status.touches() {
                let forces = [&self.forces, &state.forces];
                (forces.map(|forces| forces[2 * k]), least_force)
            } else {
                let motions = [&self.motion, &state.motion];
                (motions.map(|motion| motion[2 * k]), least_gap)
            };
            (before - now > least).then(|| at + SHORT * (at - self.at) * now / (before - now))
        });
        falling.reduce(f64::min)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::state::Status;

    fn state(gap: f64, force: f64) -> ContactState {
        ContactState {
            forces: DVector::from_vec(vec![0.0, 0.0, force, 0.0]),
            motion: DVector::from_vec(vec![gap, 0.0, 0.0, 0.0]),
            rigid: DVector::zeros(0),
            status: vec![Status::Open, Status::Stick],
            history: Vec::new(),
            multipliers: Vec::new(),
        }
    }

    /// The first point closes at 0.5, the second opens at 0.4.
    #[test]
    fn the_first_point_to_close_or_open_ends_an_increment() {
        let before = Before::of(&state(5.0, 4.0), 0.0);
        let next = |gap, force| before.next(&state(gap, force), 0.1).unwrap();
        assert!((next(4.0, 3.0) - 0.4).abs() < 1e-6);
        assert!((next(4.0, 4.0) - 0.5).abs() < 1e-6);
        assert_eq!(before.next(&state(5.0, 4.0), 0.1), None);
    }
}
