//! The basis in which the normal matrix of data and that of smoothing are both diagonal.
//!
//! ```text
//! G + μR = L Lᵀ,   L⁻¹ μR L⁻ᵀ = Q diag(s) Qᵀ,   G = L Q diag(1 − s) Qᵀ Lᵀ
//! ```

use stickslip_fem_core::linalg::{DenseCholesky, Matrix, NoEigenvalues, SymmetricEigen};
use stickslip_fem_core::mesh::Point;

use super::penalty::penalty;
use crate::region::{Region, RegionError};

/// Where the prescribed degree of freedom at `position` of the list lies `[length]`.
pub(super) fn place_of(region: &Region, position: usize) -> Point {
    region.mesh().nodes()[region.prescribed()[position] / 2]
}

/// The basis.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// Share s of the smoothing in each mode, from 0 to 1; that of the data is one less it.
    pub(super) smoothing: Vec<f64>,
    /// Modes, one per column: L⁻ᵀ Q.
    pub(super) basis: Matrix,
    /// Their inverse, transposed: L Q.
    pub(super) dual: Matrix,
}

impl Modes {
    /// Modes from the weighted rows of the data.
    pub(super) fn new(region: &Region, rows: &Matrix, order: usize) -> Result<Self, RegionError> {
        let size = rows.columns();
        let gram = rows.transpose_multiply(rows);
        let roughness = penalty(region, order);
        let trace = |matrix: &Matrix| (0..size).map(|k| matrix[(k, k)]).sum::<f64>();
        let scale = match trace(&roughness) {
            0.0 => 0.0,
            rough => trace(&gram) / rough,
        };
        let both = Matrix::from_fn(size, size, |i, j| gram[(i, j)] + scale * roughness[(i, j)]);
        let factor = DenseCholesky::new(both).map_err(|cause| RegionError::NotDetermined {
            place: place_of(region, cause.row),
        })?;
        let mut half = Matrix::from_fn(size, size, |i, j| scale * roughness[(i, j)]);
        factor.solve_lower(&mut half);
        let mut share = half.transposed();
        factor.solve_lower(&mut share);
        let symmetric = Matrix::from_fn(size, size, |i, j| {
            f64::midpoint(share[(i, j)], share[(j, i)])
        });
        let SymmetricEigen {
            values: shares,
            vectors: mut basis,
        } = SymmetricEigen::new(&symmetric)
            .map_err(|NoEigenvalues { order }| RegionError::Eigenvalues { order })?;
        let dual = factor.lower().multiply(&basis);
        factor.solve_lower_transposed(&mut basis);
        Ok(Self {
            smoothing: shares.into_iter().map(|s| s.clamp(0.0, 1.0)).collect(),
            basis,
            dual,
        })
    }
}
