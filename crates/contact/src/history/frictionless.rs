//! Where friction can carry nothing, there is no stick: F_stick = F_slip = 0 at λ_n > 0 means slip along Δs, whatever the sign
//! of a rounded λ_t says.

use crate::solver::Step;
use crate::state::{Status, TrialState};

/// Slip increment relative to the largest motion of a point that is rounding, so that its sign says nothing.
const ROUNDING: f64 = 1e-12;

/// Lets every frictionless touching point of `trial` slip along its motion in `step`, and those that only seem to move along
/// the slip of the point before them.
pub(super) fn slide(step: &Step<'_>, trial: &mut TrialState) {
    let negligible = ROUNDING * trial.motion.amax();
    let points = step.problem.points();
    for k in 0..points.len() {
        if !trial.status[k].touches() || !points[k].slides {
            continue;
        }
        let slip = trial.motion[2 * k + 1] - step.committed.tangential_displacement(k);
        let bound = step.bound(k, trial.forces[2 * k], slip);
        if trial.forces[2 * k] <= 0.0 || bound.stick > 0.0 || bound.slip > 0.0 {
            continue;
        }
        let before = (k > 0 && points[k - 1].pair == points[k].pair)
            .then(|| trial.status[k - 1])
            .filter(|status| status.slip_sign() != 0.0);
        trial.status[k] = match before {
            Some(status) if slip.abs() <= negligible => status,
            _ => Status::slip_along(slip),
        };
    }
}
