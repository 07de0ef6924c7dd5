//! Compares the force through an edge, as the sum of its nodal forces, with the known one.
//!
//! ```text
//! F = Σ_k f_k,     f = (K₁₁ − K₁₂ K₂₂⁻¹ K₂₁) Δ¹ at the nodes of the edge
//! ```
//!
//! Stresses where an edge ends are doubtful, and a contact that the region cuts bears most there. The forces that hold the nodes need no
//! stress: they are those of the strain energy, linear in the data, and their sum has the exact covariance. The region itself shows the
//! possible errors of the sum: its difference from the integral of the stresses is the error of the mesh, forces of the neighbouring edges
//! act on the two end nodes, and smoothing has an estimated bias. Where these are as large as the effect of a wrong modulus, the check is
//! no evidence.

use stickslip_hybrid::region::RegionError;

use super::Analysed;
use super::boundary::Boundary;
use super::workbench::Workbench;

/// Standard deviations, and part of the known force, by which the force may miss it beside what shows in the region.
const ALLOWED: [f64; 2] = [3.0, 0.02];
/// Part of the forces on the nodes at the ends that may be of neighbouring edges.
const ENDS: f64 = 0.5;
/// Part of the known force that the check must see to be evidence of scale, thickness and material.
const EVIDENCE: f64 = 0.1;

/// The force on a region against the known one, along one axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ForceCheck {
    /// Force by the nodes of the edge less the known one `[N]`.
    pub excess: f64,
    /// Its standard deviation by noise `[N]`.
    pub deviation: f64,
    /// Excess that noise, smoothing, mesh and ends explain together `[N]`.
    pub explained: f64,
    /// Size of the known force, of both components `[N]`.
    pub size: f64,
}

impl ForceCheck {
    /// Whether an error of a tenth of the known force would be seen, so that the check says something of scale, thickness and material.
    pub fn is_evidence(&self) -> bool {
        self.explained < EVIDENCE * self.size
    }

    /// Whether the excess is more than noise, smoothing, mesh and ends explain.
    pub fn fails(&self) -> bool {
        self.excess.abs() > self.explained
    }
}

impl Workbench<'_> {
    /// Checks the components of the force on the edge that the experiment states.
    pub(super) fn known_force(
        &self,
        found: &Analysed,
        boundary: &Boundary,
    ) -> Result<[Option<ForceCheck>; 2], RegionError> {
        let known = self.experiment.states[found.state].edge_force;
        if known == [None; 2] {
            return Ok([None; 2]);
        }
        let size = known[0].unwrap_or(0.0).hypot(known[1].unwrap_or(0.0));
        let rows = self.region.reaction_resultant(&self.edge.nodes);
        let bias = if boundary.bias.is_empty() {
            vec![0.0; 2]
        } else {
            self.region.outputs_of(&rows, &boundary.bias)?
        };
        let ends = self.forces_at_ends(boundary)?;
        let forces = &found.forces.values;
        let deviations = found.forces.deviations();
        Ok([0, 1].map(|axis| {
            // Forces by stresses are those that the region exerts.
            let by_mesh = (forces[axis] + forces[2 + axis]).abs();
            known[axis].map(|known| ForceCheck {
                excess: forces[2 + axis] - known,
                deviation: deviations[2 + axis],
                explained: ALLOWED[0] * deviations[2 + axis]
                    + ALLOWED[1] * size
                    + by_mesh
                    + bias[axis].abs()
                    + ENDS * ends[axis],
                size,
            })
        }))
    }

    /// Sizes of the forces on the first and the last node of an edge along either axis, together `[N]`; nothing of a ring.
    fn forces_at_ends(&self, boundary: &Boundary) -> Result<[f64; 2], RegionError> {
        let mut sizes = [0.0; 2];
        let ends = [self.edge.nodes.first(), self.edge.nodes.last()];
        if self.edge.closed {
            return Ok(sizes);
        }
        let values = self.region.values(&boundary.displacements)?;
        for &node in ends.into_iter().flatten() {
            let rows = self.region.reaction_resultant(&[node]);
            let forces = self.region.outputs_of(&rows, &values)?;
            for (size, force) in sizes.iter_mut().zip(forces) {
                *size += force.abs();
            }
        }
        Ok(sizes)
    }
}
