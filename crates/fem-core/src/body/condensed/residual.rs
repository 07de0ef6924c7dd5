//! What is left of the balance of nodes.

use super::{BodyLoad, CondensedBody};
use crate::load::initial_strain_load;

impl CondensedBody {
    /// Unbalanced nodal forces `[force]` of one state, as [`residual_forces_of`](Self::residual_forces_of).
    pub fn residual_forces(&self, u: &[f64], forces: &[f64], multipliers: &[f64]) -> Vec<f64> {
        let state = BodyLoad {
            forces,
            multipliers,
            motions: &[],
        };
        self.residual_forces_of(&[u.to_vec()], &[state])
            .swap_remove(0)
    }

    /// Unbalanced nodal forces `[force]` of the displacements `u` `[length]` of each of `states`: (K + K_s) u − f − λ, interleaved, with K_s of springs; at supported
    /// nodes these are the reactions, elsewhere they vanish within rounding. One pass over the cells for all states.
    pub fn residual_forces_of(&self, u: &[Vec<f64>], states: &[BodyLoad<'_>]) -> Vec<Vec<f64>> {
        let mut residuals = crate::body::assembly::internal_forces_of(&self.body, u);
        for (residual, u) in residuals.iter_mut().zip(u) {
            for (force, sum) in self.body.spring_forces(u).iter().zip(residual) {
                *sum -= force;
            }
        }
        for (residual, state) in residuals.iter_mut().zip(states) {
            let strain = self.body.initial_strain(state.multipliers);
            if !strain.is_empty() {
                let thermal = initial_strain_load(
                    &self.body.mesh,
                    &self.body.stiffnesses(),
                    &strain,
                    self.body.thickness,
                );
                residual
                    .iter_mut()
                    .zip(thermal)
                    .for_each(|(sum, part)| *sum -= part);
            }
            for (force, sum) in self.applied_forces(state).iter().zip(residual.iter_mut()) {
                *sum -= force;
            }
            for (force, sum) in self.section_forces(state).iter().zip(residual) {
                *sum -= force;
            }
        }
        residuals
    }

    /// Nodal forces `[force]`, interleaved, by which the section is held; empty where it is not.
    pub(super) fn section_forces(&self, state: &BodyLoad<'_>) -> Vec<f64> {
        let Some(section) = &self.section else {
            return Vec::new();
        };
        let mut held = vec![0.0; 2 * self.structure.equations.len()];
        let reactions = section.reactions(state.forces, state.multipliers);
        for (forces, reaction) in section.nodal.iter().zip(reactions.iter()) {
            let both = held.iter_mut().zip(forces);
            both.for_each(|(sum, force)| *sum += reaction * force);
        }
        held
    }

    /// Resultant reaction `[force]` of the section that is held, in `state`; zero without one.
    pub fn section_reaction(&self, state: &BodyLoad<'_>) -> [f64; 2] {
        let forces = self.section_forces(state);
        [0, 1].map(|axis| forces.iter().skip(axis).step_by(2).sum())
    }

    /// Nodal forces `[force]`, interleaved, of load cases and interface; without those of initial strains, which balance
    /// themselves.
    pub(super) fn applied_forces(&self, state: &BodyLoad<'_>) -> Vec<f64> {
        let mut applied = vec![0.0; 2 * self.structure.equations.len()];
        for (case, factor) in self.body.cases.iter().zip(state.multipliers) {
            applied
                .iter_mut()
                .zip(&case.forces)
                .for_each(|(sum, part)| *sum += factor * part);
        }
        for (force, &node) in state.forces.chunks_exact(2).zip(&self.structure.interface) {
            applied[2 * node] += force[0];
            applied[2 * node + 1] += force[1];
        }
        applied
    }
}
