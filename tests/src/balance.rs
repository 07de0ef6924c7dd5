//! Internal forces of a displaced body, by a quadrature loop that shares nothing with assembly but shape functions.
//!
//! ```text
//! f_a = t ∫ Bₐᵀ D B u dA          virtual work of the stresses on v:  v · f
//! ```

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::element::{Element, KindVisitor, gather, physical_gradients, with_element};
use stickslip_fem_core::material::PlaneStiffness;

/// Nodal forces `[force]` that hold the displacements `u` `[length]`, both interleaved.
pub fn internal_forces(body: &ElasticBody, u: &[f64]) -> Vec<f64> {
    let mut forces = vec![0.0; u.len()];
    for (block, material) in body.mesh().blocks().iter().zip(body.materials()) {
        let cells = Cells {
            body,
            connectivity: &block.connectivity,
            stiffness: material.stiffness(),
            u,
            forces: &mut forces,
        };
        with_element(block.kind, cells);
    }
    forces
}

struct Cells<'a> {
    body: &'a ElasticBody,
    connectivity: &'a [usize],
    stiffness: PlaneStiffness,
    u: &'a [f64],
    forces: &'a mut [f64],
}

impl KindVisitor for Cells<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        let thickness = self.body.thickness();
        for cell in self.connectivity.chunks_exact(N) {
            let x = gather::<N>(self.body.mesh().nodes(), cell);
            let moved = std::array::from_fn(|a| [self.u[2 * cell[a]], self.u[2 * cell[a] + 1]]);
            for point in E::QUADRATURE {
                let here = physical_gradients::<N, E>(&x, point.at);
                let strain = here.strain(&moved);
                let [xx, yy, xy] = self.stiffness.map(|row| {
                    row.iter().zip(&strain).map(|(d, e)| d * e).sum::<f64>()
                        * (point.weight * here.det * thickness)
                });
                for (&node, [gx, gy]) in cell.iter().zip(here.gradients) {
                    self.forces[2 * node] += gx * xx + gy * xy;
                    self.forces[2 * node + 1] += gy * yy + gx * xy;
                }
            }
        }
    }
}

/// Nodal forces `[force]` of all load cases of a body times their multipliers, interleaved.
pub fn load_forces(body: &ElasticBody, multipliers: &[f64]) -> Vec<f64> {
    let mut forces = vec![0.0; 2 * body.mesh().nodes().len()];
    for (case, factor) in body.load_cases().iter().zip(multipliers) {
        for (sum, force) in forces.iter_mut().zip(&case.forces) {
            *sum += factor * force;
        }
    }
    forces
}

/// Resultant `[force]` of interleaved forces at `places`, and their moment `[force·length]` about the origin.
pub fn resultant<'a>(
    forces: &[f64],
    places: impl IntoIterator<Item = &'a [f64; 2]>,
) -> ([f64; 2], f64) {
    let (mut sum, mut moment) = ([0.0; 2], 0.0);
    for (force, [x, y]) in forces.chunks_exact(2).zip(places) {
        sum[0] += force[0];
        sum[1] += force[1];
        moment += x * force[1] - y * force[0];
    }
    (sum, moment)
}
