//! The contact as it is reported: without what is rounding beside the rest of the history.
//!
//! A contact that opens keeps forces of some 10⁻¹⁶ of those it had, and a point at rest moves by as little of the largest motion.
//! Shown, such numbers look like results, and ratios of them like large ones.

use nalgebra::DVector;
use stickslip_contact::audit::Audit;
use stickslip_contact::{ContactState, InterfaceProblem, Status, StepRecord};

use crate::results::EdgeRow;

/// Forces and lengths up to this part of the history's largest are rounding.
const ROUNDING: f64 = 1e-12;
/// The same for stresses along an edge: derivatives of displacements lose as many digits as the body is longer than a cell.
const STRESS_ROUNDING: f64 = 1e-10;

/// One load step without rounding.
#[derive(Debug)]
pub(super) struct Reported {
    /// Contact at its end; a point without force is open.
    pub(super) state: ContactState,
    /// Slip of each point since the start `[length]`.
    pub(super) slip: DVector<f64>,
    /// Sums of the forces that are left.
    pub(super) audit: Audit,
}

/// All load steps of `records` without rounding.
pub(super) fn reported(problem: &InterfaceProblem, records: &[StepRecord]) -> Vec<Reported> {
    let largest = |of: fn(&ContactState) -> f64| {
        let sizes = records.iter().map(|record| of(&record.state));
        ROUNDING * sizes.fold(0.0, f64::max)
    };
    let force = largest(|state| state.forces.amax());
    let length = largest(|state| state.motion.amax());
    let mut slip = DVector::zeros(problem.points().len());
    records
        .iter()
        .map(|record| {
            slip += &record.slip;
            let mut state = record.state.clone();
            clean(&mut state, force, length);
            Reported {
                audit: Audit::of(problem, &state),
                slip: slip.map(|slip| beyond(slip, length)),
                state,
            }
        })
        .collect()
}

fn clean(state: &mut ContactState, force: f64, length: f64) {
    for k in 0..state.status.len() {
        state.motion[2 * k] = beyond(state.motion[2 * k], length);
        state.forces[2 * k] = beyond(state.forces[2 * k], force);
        if state.forces[2 * k] == 0.0 {
            state.forces[2 * k + 1] = 0.0;
            state.status[k] = Status::Open;
        }
        state.forces[2 * k + 1] = beyond(state.forces[2 * k + 1], force);
    }
}

/// `value`, or zero where it is not beyond `rounding`.
fn beyond(value: f64, rounding: f64) -> f64 {
    if value.abs() > rounding { value } else { 0.0 }
}

/// Clears the rounding from the stresses along an edge, given for all steps.
pub(super) fn clear_stresses(steps: &mut [Vec<EdgeRow>]) {
    let largest = steps.iter().flatten().fold(0.0_f64, |largest, row| {
        largest
            .max(row.sigma_tangential.abs())
            .max(row.pressure.abs())
    });
    for row in steps.iter_mut().flatten() {
        row.sigma_tangential = beyond(row.sigma_tangential, STRESS_ROUNDING * largest);
    }
}

#[cfg(test)]
mod tests {
    use super::{DVector, Status, beyond, clean};
    use stickslip_contact::ContactState;

    #[test]
    fn a_point_without_force_is_open_and_rests() {
        let mut state = ContactState {
            forces: DVector::from_vec(vec![2e-13, 1e-5, 1.0, 3e-14]),
            motion: DVector::from_vec(vec![-4e-17, 0.1, 0.0, 0.2]),
            rigid: DVector::zeros(0),
            status: vec![Status::Stick, Status::SlipNegative],
            history: Vec::new(),
            multipliers: Vec::new(),
        };
        clean(&mut state, 1e-12, 1e-15);
        assert_eq!(state.forces.as_slice(), [0.0, 0.0, 1.0, 0.0]);
        assert_eq!(state.motion.as_slice(), [0.0, 0.1, 0.0, 0.2]);
        assert_eq!(state.status, [Status::Open, Status::SlipNegative]);
    }

    #[test]
    fn without_any_size_only_zero_is_zero() {
        assert_eq!(beyond(1e-300, 0.0), 1e-300);
        assert_eq!(beyond(0.0, 0.0), 0.0);
    }
}
