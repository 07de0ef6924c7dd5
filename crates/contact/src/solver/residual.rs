//! How well a candidate meets the contact conditions: the stopping measure that all solvers share.

use nalgebra::DVector;

use super::Residuals;
use super::step::Step;
use crate::state::{Status, TrialState};

impl Residuals {
    /// Measures `trial` against the conditions of `step`.
    pub fn of(step: &Step<'_>, trial: &TrialState) -> Self {
        let scales = Scales::of(step, &trial.forces, &trial.motion);
        let mut residuals = Self::default();
        for (k, point) in step.problem.points().iter().enumerate() {
            let (normal, tangential) = (trial.forces[2 * k], trial.forces[2 * k + 1]);
            let gap = trial.motion[2 * k] / scales.length;
            let force = normal / scales.force;
            let closed = trial.status[k].touches();
            residuals.complementarity = worst(
                residuals.complementarity,
                [-gap, -force, if closed { gap.abs() } else { force.abs() }],
            );
            if !point.slides {
                continue;
            }
            let slip = trial.motion[2 * k + 1] - step.committed.tangential_displacement(k);
            let violation =
                scales.cone_violation(step, k, trial.status[k], [normal, tangential], slip);
            residuals.cone = worst(residuals.cone, [violation]);
        }
        let unbalanced = step.imbalance(&trial.forces);
        residuals.balance = worst(
            0.0,
            unbalanced.iter().map(|force| force.abs() / scales.force),
        );
        residuals
    }
}

/// `f64::max` over values that keeps a NaN.
fn worst(start: f64, values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(start, |largest, value| {
        if value > largest || value.is_nan() {
            value
        } else {
            largest
        }
    })
}

/// Part of the local give of points that gaps and slips are at least measured by: rounding is far below.
const GIVE: f64 = 0.1;

/// Scales of force and length of a step.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scales {
    pub(crate) force: f64,
    pub(crate) length: f64,
}

impl Scales {
    pub(crate) fn of(step: &Step<'_>, forces: &DVector<f64>, motion: &DVector<f64>) -> Self {
        let committed = step.committed.forces.amax();
        let force = forces
            .amax()
            .max(step.mode_load.amax())
            .max(1e-3 * committed);
        let gap = step
            .problem
            .points()
            .iter()
            .fold(0.0, |largest: f64, point| largest.max(point.gap.abs()));
        // Where all points stick, what moves is rounding, and no scale.
        let give = GIVE * step.problem.local_give() * forces.amax();
        let length = motion
            .amax()
            .max(give)
            .max(step.committed.motion.amax())
            .max(gap)
            .max(step.free_motion.amax());
        let positive = |value: f64| if value > 0.0 { value } else { 1.0 };
        Self {
            force: positive(force),
            length: positive(length),
        }
    }

    /// Relative violation of the friction conditions at `point` with `status` under the force (normal, tangential) and the
    /// slip increment `slip`.
    pub(crate) fn cone_violation(
        &self,
        step: &Step<'_>,
        point: usize,
        status: Status,
        [normal, tangential]: [f64; 2],
        slip: f64,
    ) -> f64 {
        let bound = step.bound(point, normal, slip);
        match status {
            Status::Open => tangential.abs() / self.force,
            Status::Stick => {
                ((tangential.abs() - bound.stick) / self.force).max(slip.abs() / self.length)
            }
            status => {
                let sign = status.slip_sign();
                ((tangential + sign * bound.slip).abs() / self.force)
                    .max(-sign * slip / self.length)
            }
        }
    }
}

/// The statuses that forces and motions (slip increments from the last accepted state) come closest to.
pub(super) fn read_statuses(
    step: &Step<'_>,
    forces: &DVector<f64>,
    motion: &DVector<f64>,
) -> Vec<Status> {
    let scales = Scales::of(step, forces, motion);
    (0..step.count())
        .map(|k| {
            let (gap, slip) = (motion[2 * k], motion[2 * k + 1]);
            let (normal, tangential) = (forces[2 * k], forces[2 * k + 1]);
            if normal / scales.force <= gap / scales.length {
                return Status::Open;
            }
            if !step.problem.points()[k].slides {
                return Status::Stick;
            }
            let slipping = if tangential == 0.0 {
                Status::slip_along(slip)
            } else {
                Status::slip_along(-tangential)
            };
            let violation =
                |status| scales.cone_violation(step, k, status, [normal, tangential], slip);
            if violation(slipping) < violation(Status::Stick) {
                slipping
            } else {
                Status::Stick
            }
        })
        .collect()
}
