//! Equilibrium of a condensed body by its recovered displacements,
//!
//! ```text
//! reactions + loads + contact forces = 0,   as resultants and at every node that nothing holds
//! ```
//!
//! with all that is left relative to the body's own load in a state, or to a thousandth of its largest in the history where that is
//! more: in an unloaded state rounding is all there is.

use super::{BodyLoad, CondensedBody};
use crate::mesh::Point;

/// Part of the largest load of a history by which a state is at least measured.
const FLOOR: f64 = 1e-3;

/// Balance of a body by its recovered displacements.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct BodyBalance {
    /// Resultant of the support reactions `[force]`.
    pub reaction: [f64; 2],
    /// Their moment about the origin `[force·length]`.
    pub reaction_moment: f64,
    /// Unbalanced resultant of reactions, loads and contact `[1]`, relative to half the sum of all applied nodal forces, or to a
    /// thousandth of the largest such sum in the history where that is more.
    pub force: f64,
    /// Unbalanced moment, relative to that sum times the body's size `[1]`.
    pub moment: f64,
    /// Largest unbalanced force on a node that nothing holds, relative to that sum `[1]`.
    pub nodal: f64,
}

impl CondensedBody {
    /// Balance of the whole body in each of `states`: reactions (the part of the residual at held nodes), loads and contact
    /// forces, as resultants. `residuals` are those of [`Self::residual_forces_of`] in the displacements `u` `[length]`; reactions are also the forces of
    /// springs.
    pub fn balances_of(
        &self,
        residuals: &[Vec<f64>],
        u: &[Vec<f64>],
        states: &[BodyLoad<'_>],
    ) -> Vec<BodyBalance> {
        let scales = |of: &dyn Fn(&BodyLoad<'_>) -> f64| -> Vec<f64> {
            let own: Vec<f64> = states.iter().map(of).collect();
            let floor = FLOOR * own.iter().copied().fold(0.0, f64::max);
            own.into_iter().map(|scale| scale.max(floor)).collect()
        };
        let applied = scales(&|state| half_sum(&self.applied_forces(state)));
        let load = scales(&|state| self.load_scale(state.forces, state.multipliers));
        let [low, high] = self.body.mesh.bounding_box();
        let size = (high[0] - low[0]).hypot(high[1] - low[1]);
        let recovered = residuals.iter().zip(u);
        recovered
            .zip(states)
            .enumerate()
            .map(|(k, ((residual, u), state))| {
                let [reaction, rest] = self.resultants(residual, u, state);
                BodyBalance {
                    reaction: [reaction[0], reaction[1]],
                    reaction_moment: reaction[2],
                    force: relative(rest[0].hypot(rest[1]), applied[k]),
                    moment: relative(rest[2].abs(), applied[k] * size),
                    nodal: relative(self.largest_free(residual), load[k]),
                }
            })
            .collect()
    }

    /// Resultants of the reactions, and of these with all that is applied.
    fn resultants(&self, residual: &[f64], u: &[f64], state: &BodyLoad<'_>) -> [[f64; 3]; 2] {
        let nodes = self.body.mesh.nodes();
        let mut reactions = vec![0.0; residual.len()];
        for (node, constraint) in self.structure.constraints.iter().enumerate() {
            let local = constraint.to_local([residual[2 * node], residual[2 * node + 1]]);
            let held = std::array::from_fn(|axis| {
                if constraint.held[axis] {
                    local[axis]
                } else {
                    0.0
                }
            });
            reactions[2 * node..2 * node + 2].copy_from_slice(&constraint.to_global(held));
        }
        let held = self.section_forces(state);
        let sprung = self.body.spring_forces(u);
        for further in [held, sprung] {
            let both = reactions.iter_mut().zip(&further);
            both.for_each(|(sum, force)| *sum += force);
        }
        let reaction = resultant(nodes, &reactions);
        let load = resultant(nodes, &self.applied_forces(state));
        [reaction, [0, 1, 2].map(|k| reaction[k] + load[k])]
    }

    /// Largest of the `residual` forces on unknowns that nothing holds, relative to the load: half the sum of all nodal
    /// forces, those of a temperature on held nodes included, of `forces`, or of the load cases times `multipliers` if that is more `[1]`. 0 where nothing is loaded.
    /// `residual` and `forces` have two components for each node `[force]`, `multipliers` one for each load case `[1]`.
    pub fn relative_imbalance(&self, residual: &[f64], forces: &[f64], multipliers: &[f64]) -> f64 {
        relative(
            self.largest_free(residual),
            self.load_scale(forces, multipliers),
        )
    }

    fn load_scale(&self, forces: &[f64], multipliers: &[f64]) -> f64 {
        let cases = self.case_forces.iter().zip(&self.case_sums);
        let sums = cases.map(|(case, sum)| sum.max(case.as_deref().map_or(0.0, half_sum)));
        let load: f64 = (sums.zip(multipliers))
            .map(|(sum, factor)| factor.abs() * sum)
            .sum();
        load.max(half_sum(forces))
    }

    fn largest_free(&self, residual: &[f64]) -> f64 {
        let free = self.structure.to_unknowns(residual);
        free.iter()
            .fold(0.0, |worst: f64, force| worst.max(force.abs()))
    }
}

fn half_sum(forces: &[f64]) -> f64 {
    forces.iter().map(|force| force.abs()).sum::<f64>() / 2.0
}

fn relative(value: f64, scale: f64) -> f64 {
    if scale > 0.0 { value / scale } else { 0.0 }
}

/// Resultant (F_x, F_y, M about the origin) of nodal forces.
fn resultant(nodes: &[Point], forces: &[f64]) -> [f64; 3] {
    let mut sum = [0.0; 3];
    for ([x, y], force) in nodes.iter().zip(forces.chunks_exact(2)) {
        sum[0] += force[0];
        sum[1] += force[1];
        sum[2] += x * force[1] - y * force[0];
    }
    sum
}
