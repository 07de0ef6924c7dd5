//! From the unknowns of a structure to displacements and forces of its nodes, and back.

use nalgebra::{DMatrix, DVector};

use crate::body::assembly::assemble;
use crate::body::elastic::ElasticBody;
use crate::body::equations::{BodyStructure, HELD};

impl BodyStructure {
    /// The stiffness matrix `[force/length]` of `body`, ordered as it is factorised; `body` must have the mesh and supports of this structure.
    pub fn stiffness(&self, body: &ElasticBody) -> crate::linalg::LowerMatrix {
        assemble(body, self).matrix
    }

    /// For each interface unknown: contact point, and the xy direction of the unknown's axis.
    pub(in crate::body) fn interface_axes(&self) -> Vec<(usize, [f64; 2])> {
        let mut axes = Vec::with_capacity(self.interface_unknowns);
        for (point, &node) in self.interface.iter().enumerate() {
            for axis in 0..2 {
                if self.equations[node][axis] != HELD {
                    axes.push((point, self.constraints[node].axes()[axis]));
                }
            }
        }
        axes
    }

    /// Spreads a matrix on the interface unknowns to the xy components of all contact points.
    pub(super) fn spread(&self, reduced: DMatrix<f64>) -> DMatrix<f64> {
        let axes = self.interface_axes();
        let size = 2 * self.interface.len();
        if axes.len() == size
            && !self
                .interface
                .iter()
                .any(|&node| self.constraints[node].is_turned())
        {
            return reduced;
        }
        let mut full = DMatrix::zeros(size, size);
        for (q, &(column_point, column_axis)) in axes.iter().enumerate() {
            for (p, &(row_point, row_axis)) in axes.iter().enumerate() {
                for j in 0..2 {
                    for i in 0..2 {
                        full[(2 * row_point + i, 2 * column_point + j)] +=
                            row_axis[i] * reduced[(p, q)] * column_axis[j];
                    }
                }
            }
        }
        full
    }

    /// The interface unknowns, in the order of their points.
    pub(in crate::body) fn interface_equations(&self) -> impl Iterator<Item = usize> {
        let equations = self.interface.iter().flat_map(|&node| self.equations[node]);
        equations
            .filter(|&equation| equation != HELD)
            .map(|equation| equation as usize)
    }

    pub(super) fn spread_response(
        &self,
        reduced: &DVector<f64>,
        moves_supports: bool,
    ) -> DVector<f64> {
        let mut full = DVector::zeros(2 * self.interface.len());
        for (&(point, axis), value) in self.interface_axes().iter().zip(reduced.iter()) {
            full[2 * point] += axis[0] * value;
            full[2 * point + 1] += axis[1] * value;
        }
        if moves_supports {
            for (point, &node) in self.interface.iter().enumerate() {
                let held = self.constraints[node].to_global(self.constraints[node].displacement);
                full[2 * point] += held[0];
                full[2 * point + 1] += held[1];
            }
        }
        full
    }

    pub(super) fn interface_modes(&self, body: &ElasticBody) -> DMatrix<f64> {
        let mut modes = DMatrix::zeros(2 * self.interface.len(), self.motions.count());
        for (point, &node) in self.interface.iter().enumerate() {
            modes
                .rows_mut(2 * point, 2)
                .copy_from(&self.motions.at(&body.mesh, node));
        }
        modes
    }

    /// Resultants of nodal forces in the free motions. What is rounding beside the forces' own sizes is zero: a load that
    /// balances itself leaves nothing for contact to balance. The sizes are those of whole forces, not of their components along a
    /// motion: across a pull these are rounding themselves.
    pub(super) fn mode_load(&self, body: &ElasticBody, nodal: &[f64]) -> DVector<f64> {
        const ROUNDING: f64 = 1e-12;
        let mut load = DVector::zeros(self.motions.count());
        let mut size = load.clone();
        for (node, force) in nodal.chunks_exact(2).enumerate() {
            if !load.is_empty() && force != [0.0, 0.0] {
                let motions = self.motions.at(&body.mesh, node).transpose();
                let force = DVector::from_column_slice(force);
                let reach = motions.row_iter().map(|motion| motion.norm());
                size += DVector::from_iterator(size.len(), reach) * force.norm();
                load += motions * force;
            }
        }
        load.zip_apply(&size, |sum, size| {
            if sum.abs() <= ROUNDING * size {
                *sum = 0.0;
            }
        });
        load
    }

    pub(in crate::body) fn to_unknowns(&self, nodal: &[f64]) -> Vec<f64> {
        let mut unknowns = vec![0.0; self.unknowns];
        for (node, force) in nodal.chunks_exact(2).enumerate() {
            let local = self.constraints[node].to_local([force[0], force[1]]);
            for axis in 0..2 {
                if self.equations[node][axis] != HELD {
                    unknowns[self.equations[node][axis] as usize] += local[axis];
                }
            }
        }
        unknowns
    }
}
