//! The contact as it is reported: values within rounding of the rest of the history are zero.
//!
//! A contact that opens keeps forces of some 10⁻¹⁶ of those it had, and a point at rest moves by as little of the largest motion.
//! In a table such numbers, and above all their ratios, would look like results.

use std::ops::Range;

use nalgebra::DVector;
use stickslip_contact::audit::PairSums;
use stickslip_contact::interface::Part;
use stickslip_contact::{ContactState, Contacts, Interface, Status, StepRecord};

use crate::results::{EdgeResults, EdgeRow};

/// Forces and lengths up to this part of the largest of their pair in the history are rounding.
const ROUNDING: f64 = 1e-12;
/// Up to these parts of the largest of all pairs that bodies link with it they are rounding too: a pair at rest beside others. Forces are verified to 1e-10 of their scale.
const REST_OF_FORCES: f64 = 1e-10;
const REST_OF_LENGTHS: f64 = 1e-16;
/// The same for stresses along an edge: derivatives of displacements lose as many digits as the body is longer than a cell.
const STRESS_ROUNDING: f64 = 1e-10;

/// The same for sums over an edge, of some hundred forces each.
const SUM_ROUNDING: f64 = 1e-11;

/// One load step without rounding.
#[derive(Debug)]
pub(super) struct Reported {
    /// Contact at its end; a point without force is open.
    pub(super) state: ContactState,
    /// Slip of each point since the start `[length]`.
    pub(super) slip: DVector<f64>,
    /// Sums of the forces that are left, for each pair.
    pub(super) sums: Vec<PairSums>,
    /// Work lost to friction in the step, by pair `[force·length]`.
    pub(super) friction_work: Vec<f64>,
}

/// All load steps of `records` without rounding.
pub(super) fn reported(interface: &Interface, records: &[StepRecord]) -> Vec<Reported> {
    let contacts = interface.contacts();
    let sizes: Vec<Sizes> = (0..contacts.pairs().len())
        .map(|pair| Sizes::of(contacts, records, pair))
        .collect();
    let mut cuts: Vec<Cut> = (0..sizes.len())
        .map(|pair| sizes[pair].cut(contacts.pair_points(pair)))
        .collect();
    for group in interface.parts().iter().map(Part::group) {
        let all = group.pairs.iter().map(|&pair| sizes[pair]);
        let largest = all.fold(Sizes::default(), Sizes::larger);
        for &pair in &group.pairs {
            cuts[pair].force = cuts[pair].force.max(REST_OF_FORCES * largest.force);
            cuts[pair].length = cuts[pair].length.max(REST_OF_LENGTHS * largest.length);
        }
    }
    let mut slip = DVector::zeros(contacts.points().len());
    records
        .iter()
        .map(|record| {
            slip += &record.slip;
            let mut state = record.state.clone();
            let mut seen = slip.clone();
            for cut in &cuts {
                cut.clean(&mut state);
                for k in cut.points.clone() {
                    seen[k] = beyond(seen[k], cut.length);
                }
            }
            Reported {
                friction_work: (cuts.iter())
                    .map(|cut| cut.points.clone().map(|k| record.friction_work[k]).sum())
                    .collect(),
                sums: PairSums::of(record.contacts_of(contacts), &state),
                slip: seen,
                state,
            }
        })
        .collect()
}

/// The largest force and motion of a pair in the history.
#[derive(Clone, Copy, Debug, Default)]
struct Sizes {
    force: f64,
    length: f64,
}

impl Sizes {
    fn of(contacts: &Contacts, records: &[StepRecord], pair: usize) -> Self {
        let points = contacts.pair_points(pair);
        let size = |all: &DVector<f64>| all.rows(2 * points.start, 2 * points.len()).amax();
        let all = records.iter().map(|record| Self {
            force: size(&record.state.forces),
            length: size(&record.state.motion),
        });
        all.fold(Self::default(), Self::larger)
    }

    fn larger(self, other: Self) -> Self {
        Self {
            force: self.force.max(other.force),
            length: self.length.max(other.length),
        }
    }

    fn cut(self, points: Range<usize>) -> Cut {
        Cut {
            points,
            force: ROUNDING * self.force,
            length: ROUNDING * self.length,
        }
    }
}

/// What is rounding at the points of a pair.
#[derive(Debug)]
struct Cut {
    points: Range<usize>,
    force: f64,
    length: f64,
}

impl Cut {
    fn clean(&self, state: &mut ContactState) {
        let Self {
            points,
            force,
            length,
        } = self;
        for k in points.clone() {
            state.motion[2 * k] = beyond(state.motion[2 * k], *length);
            state.forces[2 * k] = beyond(state.forces[2 * k], *force);
            if state.forces[2 * k] == 0.0 {
                state.forces[2 * k + 1] = 0.0;
                state.status[k] = Status::Open;
            }
            state.forces[2 * k + 1] = beyond(state.forces[2 * k + 1], *force);
        }
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

/// Up to where sums of forces on an edge, given for all steps, are rounding.
fn rounding_of_sums(steps: &[EdgeResults]) -> f64 {
    let largest = steps.iter().fold(0.0_f64, |largest, edge| {
        let [x, y] = edge.resultant;
        largest.max(x.abs()).max(y.abs()).max(edge.normal_force)
    });
    SUM_ROUNDING * largest
}

/// Clears the rounding from the contact force and the normal force of an edge, given for all steps.
pub(super) fn clear_sums(steps: &mut [EdgeResults]) {
    let rounding = rounding_of_sums(steps);
    let cut = |force: &mut f64| *force = beyond(*force, rounding);
    for edge in steps {
        edge.resultant.iter_mut().for_each(cut);
        cut(&mut edge.normal_force);
    }
}

/// Clears the rounding from the friction forces of an edge, given for all steps.
pub(super) fn clear_friction(steps: &mut [EdgeResults]) {
    let rounding = rounding_of_sums(steps);
    for edge in steps {
        edge.friction_force = beyond(edge.friction_force, rounding);
    }
}

#[cfg(test)]
mod tests {
    use super::{Cut, DVector, Status, beyond};
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
        let cut = |points, force, length| Cut {
            points,
            force,
            length,
        };
        cut(0..1, 1e-12, 1e-15).clean(&mut state);
        cut(1..2, 1e-12, 1e-15).clean(&mut state);
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
