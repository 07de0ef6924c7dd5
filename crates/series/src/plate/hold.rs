//! What holds a floating body while its operator is made.

use nalgebra::{DMatrix, DVector};

use crate::nodes::Nodes;

/// Rows and columns that are made symmetric together, so that both triangles stay in the processor's cache.
const TILE: usize = 32;

/// Forces S that hold a floating body, and the motion that is counted as its rigid one: even tractions, and the mean motion of the hole.
#[derive(Clone, Debug)]
pub(super) struct Hold {
    pub(super) motions: DMatrix<f64>,
    pub(super) forces: DMatrix<f64>,
}

impl Hold {
    pub(super) fn new(nodes: &Nodes, motions: DMatrix<f64>) -> Self {
        let mut weighted = motions.clone();
        for (node, weight) in nodes.weights().into_iter().enumerate() {
            weighted.rows_mut(2 * node, 2).scale_mut(weight);
        }
        let gram = weighted.tr_mul(&motions);
        // Motions of two or more places are independent, so the matrix has an inverse; places of a hole are not one.
        let inverse = gram
            .try_inverse()
            .unwrap_or_else(|| DMatrix::zeros(motions.ncols(), motions.ncols()));
        Self {
            forces: weighted * inverse,
            motions,
        }
    }

    /// Nodal forces that balance each of the resultants, 2n × cases.
    pub(super) fn balance(&self, resultants: &[DVector<f64>]) -> DMatrix<f64> {
        let free = self.motions.ncols();
        let given = DMatrix::from_fn(free, resultants.len(), |i, case| resultants[case][i]);
        -&self.forces * given
    }

    /// Takes its rigid motion off the displacements in each column, and returns it.
    pub(super) fn measure(&self, displacements: &mut DMatrix<f64>) -> DMatrix<f64> {
        let rigid = self.forces.tr_mul(displacements);
        displacements.gemm(-1.0, &self.motions, &rigid, 1.0);
        rigid
    }

    /// P C Pᵀ from P C, without its asymmetry, an error of the fit.
    pub(super) fn symmetric(&self, mut compliance: DMatrix<f64>) -> DMatrix<f64> {
        let held = &compliance * &self.forces;
        compliance.gemm(-1.0, &held, &self.motions.transpose(), 1.0);
        let count = compliance.ncols();
        let blocks = || (0..count).step_by(TILE);
        for (left, top) in blocks().flat_map(|left| blocks().map(move |top| (left, top))) {
            for column in left..count.min(left + TILE) {
                for row in top..column.min(top + TILE) {
                    let mean = 0.5 * (compliance[(row, column)] + compliance[(column, row)]);
                    compliance[(row, column)] = mean;
                    compliance[(column, row)] = mean;
                }
            }
        }
        compliance
    }
}
