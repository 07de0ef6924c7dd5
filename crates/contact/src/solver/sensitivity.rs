//! How contact forces answer to a small change of motion, with the statuses held.

use nalgebra::DVector;
use stickslip_fem_core::linalg::DenseLu;

use super::active_set::slip_line;
use super::frozen::{SlipLine, matrix_of};
use super::step::Step;
use crate::interface::Interface;
use crate::problem::InterfaceProblem;
use crate::state::ContactState;

impl Interface {
    /// The largest change of a pressure or tangential traction `[stress]` in the state `state`, on the undeformed geometry,
    /// where the points' motion by the bodies changes by `motion` `[length]`, 2n, and no status does. `None` where the statuses leave forces
    /// undetermined.
    pub fn traction_change(&self, state: &ContactState, motion: &DVector<f64>) -> Option<f64> {
        let mut largest = 0.0_f64;
        for part in self.parts() {
            let state = part.own_state(state);
            let change = force_change(part.problem(), &state, &part.own_components(motion))?;
            for (point, forces) in part
                .problem()
                .points()
                .iter()
                .zip(change.as_slice().chunks(2))
            {
                largest = largest.max(forces[0].abs().max(forces[1].abs()) / point.area);
            }
        }
        Some(largest)
    }
}

/// Change of the contact forces `[force]` of `state`, 2n.
fn force_change(
    problem: &InterfaceProblem,
    state: &ContactState,
    motion: &DVector<f64>,
) -> Option<DVector<f64>> {
    let step = Step::new(problem, state, &state.multipliers);
    let lines: Vec<SlipLine> = (0..step.count())
        .map(|k| slip_line(&step, k, state.normal_force(k).max(0.0), 0.0))
        .collect();
    let (matrix, layout) = matrix_of(&step, &state.status, &lines);
    let unit = problem.compliance_unit();
    let mut solution = DVector::zeros(matrix.nrows());
    for (side, row) in solution.iter_mut().zip(layout.rows()) {
        *side = -motion[row];
    }
    DenseLu::new(matrix).ok()?.solve(&mut solution);
    let mut forces = DVector::zeros(motion.len());
    for (value, &k) in solution.iter().zip(&layout.normal) {
        forces[2 * k] = *value / unit;
        if problem.points()[k].slides {
            forces[2 * k + 1] = -state.status[k].slip_sign() * lines[k].normal * forces[2 * k];
        }
    }
    let tangential = solution.iter().skip(layout.normal.len());
    for (value, &k) in tangential.zip(&layout.tangential) {
        forces[2 * k + 1] = *value / unit;
    }
    Some(forces)
}
