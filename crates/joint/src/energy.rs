//! The energy balance of an increment, pass by pass: a pass goes from one equilibrium to the next, or to the next failure of plies.
//!
//! ```text
//! external   Σ ½ (F_a + F_b) · (u_b − u_a)                                        loads and driven supports
//! released   Σ_q V_q [½ (σ_a + σ_lin) · (ε_b − ε_a) − Δw_b]                      plies that fail at b, before their loss
//!          + Σ_q V_q  ½ (σ_lin − σ_b) · (ε_c − ε_b)                              and after it, in the next pass b → c
//! ```
//!
//! σ_lin is the stress that balances the loads at b, σ_b what is left of it after the loss, and Δw_b what the model stored and
//! dissipated between a and b.

use nalgebra::DVector;
use stickslip_contact::InterfaceProblem;

use crate::body::{JointBody, ProgressiveBody, Response};
use crate::joint::Joint;
use crate::state::{BodyState, JointState};

/// Loads and displacements of a joint in equilibrium.
#[derive(Clone, Debug)]
pub(crate) struct Equilibrium {
    pub(crate) multipliers: Vec<f64>,
    pub(crate) rigid: DVector<f64>,
    pub(crate) bodies: Vec<BodyState>,
}

impl Equilibrium {
    pub(crate) fn of(state: &JointState) -> Self {
        let bodies = state.bodies.iter().map(|body| BodyState {
            displacements: body.displacements.clone(),
            support_work: body.support_work,
            ..BodyState::default()
        });
        Self {
            multipliers: state.multipliers.clone(),
            rigid: state.contact.rigid.clone(),
            bodies: bodies.collect(),
        }
    }

    /// Work of loads and driven supports from here to `end`, by the trapezoidal rule.
    pub(crate) fn work(&self, joint: &Joint, problem: &InterfaceProblem, end: &Self) -> f64 {
        let mean: Vec<f64> = (self.multipliers.iter().zip(&end.multipliers))
            .map(|(from, to)| f64::midpoint(*from, *to))
            .collect();
        let rigid_loads = problem.mode_load(&mean);
        let turn = &end.rigid - &self.rigid;
        let mut work = 0.0;
        for (index, body) in joint.bodies.iter().enumerate() {
            if let JointBody::Rigid(_) = body {
                for mode in problem.body_modes(index) {
                    work += rigid_loads[mode] * turn[mode];
                }
                continue;
            }
            let (from, to) = (&self.bodies[index], &end.bodies[index]);
            let moved = to.displacements.iter().zip(&from.displacements);
            let loads = joint.nodal_loads(index, &mean);
            work += (loads.iter().zip(moved))
                .map(|(force, (to, from))| force * (to - from))
                .sum::<f64>();
            let driven =
                joint.drive(index, &end.multipliers) - joint.drive(index, &self.multipliers);
            work += f64::midpoint(from.support_work, to.support_work) * driven;
        }
        work
    }
}

/// State of a body's points at the start of a pass.
#[derive(Clone, Debug)]
pub(crate) struct PassStart {
    strain: Vec<[f64; 3]>,
    stress: Vec<[f64; 3]>,
    /// Stress lost at the start of the pass; empty where none was.
    jump: Vec<[f64; 3]>,
    /// Stored and dissipated.
    energy: f64,
}

impl PassStart {
    pub(crate) fn new(start: &Response, [stored, dissipated]: [f64; 2]) -> Self {
        Self {
            strain: start.strain.clone(),
            stress: start.stress.clone(),
            jump: Vec::new(),
            energy: stored + dissipated,
        }
    }

    /// Released by the loss at the start of the pass.
    pub(crate) fn released_by_jump(&self, body: &ProgressiveBody, end: &Response) -> f64 {
        let jump = self.jump.iter().enumerate();
        jump.map(|(q, jump)| 0.5 * body.volume(q) * dot(jump, &self.change(q, end)))
            .sum()
    }

    /// Ends the pass where plies fail, at stresses `predicted` before their loss: what is released in it.
    pub(crate) fn fail(
        &mut self,
        body: &ProgressiveBody,
        end: &Response,
        predicted: &[[f64; 3]],
    ) -> f64 {
        let work: f64 = (0..predicted.len())
            .map(|q| {
                let mean = [0, 1, 2].map(|i| f64::midpoint(self.stress[q][i], predicted[q][i]));
                body.volume(q) * dot(&mean, &self.change(q, end))
            })
            .sum();
        let [stored, dissipated] = body.energies(&end.trial);
        let released =
            self.released_by_jump(body, end) + work - (stored + dissipated - self.energy);
        let lost = predicted.iter().zip(&end.stress);
        *self = Self {
            jump: lost
                .map(|(before, after)| [0, 1, 2].map(|i| before[i] - after[i]))
                .collect(),
            ..Self::new(end, [stored, dissipated])
        };
        released
    }

    fn change(&self, point: usize, end: &Response) -> [f64; 3] {
        [0, 1, 2].map(|i| end.strain[point][i] - self.strain[point][i])
    }
}

fn dot(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
