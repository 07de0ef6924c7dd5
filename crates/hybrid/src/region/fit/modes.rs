//! The basis in which the normal matrix of data and that of smoothing are both diagonal.
//!
//! ```text
//! G + μR = L Lᵀ,   L⁻¹ μR L⁻ᵀ = Q diag(s) Qᵀ,   G = L Q diag(1 − s) Qᵀ Lᵀ
//! ```

use faer::Mat;

use super::penalty::penalty;
use super::place_of;
use crate::region::dense::{cholesky, eigen, multiply, solve_lower, solve_lower_transposed};
use crate::region::{Region, RegionError};

/// The basis.
#[derive(Clone, Debug)]
pub(super) struct Modes {
    /// Share s of the smoothing in each mode, from 0 to 1; that of the data is one less it.
    pub(super) smoothing: Vec<f64>,
    /// Modes, one per column: L⁻ᵀ Q.
    pub(super) basis: Mat<f64>,
    /// Their inverse, transposed: L Q.
    pub(super) dual: Mat<f64>,
}

impl Modes {
    /// Modes from the weighted rows of the data.
    pub(super) fn new(region: &Region, rows: &Mat<f64>, order: usize) -> Result<Self, RegionError> {
        let size = rows.ncols();
        let gram = multiply(rows.transpose(), rows.as_ref());
        let roughness = penalty(region, order);
        let trace = |matrix: &Mat<f64>| (0..size).map(|k| matrix[(k, k)]).sum::<f64>();
        let scale = match trace(&roughness) {
            0.0 => 0.0,
            rough => trace(&gram) / rough,
        };
        let both = Mat::from_fn(size, size, |i, j| gram[(i, j)] + scale * roughness[(i, j)]);
        let lower = cholesky(both).map_err(|row| RegionError::NotDetermined {
            place: place_of(region, row),
        })?;
        let mut half = Mat::from_fn(size, size, |i, j| scale * roughness[(i, j)]);
        solve_lower(&lower, &mut half);
        let mut share = half.transpose().to_owned();
        solve_lower(&lower, &mut share);
        let symmetric = Mat::from_fn(size, size, |i, j| {
            f64::midpoint(share[(i, j)], share[(j, i)])
        });
        let (shares, mut basis) =
            eigen(&symmetric).ok_or(RegionError::Eigenvalues { order: size })?;
        let dual = multiply(lower.as_ref(), basis.as_ref());
        solve_lower_transposed(&lower, &mut basis);
        Ok(Self {
            smoothing: shares.into_iter().map(|s| s.clamp(0.0, 1.0)).collect(),
            basis,
            dual,
        })
    }
}
