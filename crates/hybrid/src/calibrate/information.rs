//! The information about the parameters in the curvature of χ² at its minimum.
//!
//! ```text
//! Σ = (JᵀJ)⁻¹,   J = ∂r/∂z
//! ```

use stickslip_fem_core::linalg::{DenseCholesky, Matrix};

use super::parameter::Parameter;

/// Inverse of half the curvature of χ² in the parts of the ranges.
pub(super) struct Information {
    /// Parameters that have an influence; others are left out.
    active: Vec<usize>,
    /// The inverse over these; `None` where they cannot be distinguished.
    inverse: Option<Matrix>,
    /// Standard deviation of each parameter if it alone were unknown; infinite without influence.
    alone: Vec<f64>,
}

impl Information {
    pub(super) fn of(jacobian: &Matrix) -> Self {
        /// A standard deviation of so many ranges comes from rounding.
        const BEYOND: f64 = 1e3;
        let gram = jacobian.transpose_multiply(jacobian);
        let alone: Vec<f64> = (0..jacobian.columns())
            .map(|k| gram[(k, k)].sqrt().recip())
            .collect();
        let active: Vec<usize> = (0..alone.len()).filter(|&k| alone[k] < BEYOND).collect();
        let size = active.len();
        // Scaled to a diagonal of ones, so that the factorisation breaks down where parameters cannot be distinguished.
        let scaled = Matrix::from_fn(size, size, |i, j| {
            gram[(active[i], active[j])] * alone[active[i]] * alone[active[j]]
        });
        let inverse = DenseCholesky::new(scaled).ok().map(|factor| {
            let full = factor.inverse();
            Matrix::from_fn(size, size, |i, j| {
                full[(i, j)] * alone[active[i]] * alone[active[j]]
            })
        });
        Self {
            active,
            inverse,
            alone,
        }
    }

    /// Standard deviation in parts of the range; `None` without influence, or where other parameters cannot be distinguished from it.
    pub(super) fn deviation(&self, axis: usize) -> Option<f64> {
        let inverse = self.inverse.as_ref()?;
        let own = self.active.iter().position(|&active| active == axis)?;
        Some(inverse[(own, own)].sqrt())
    }

    /// A step in parts of the range over which χ² changes; `None` without influence.
    pub(super) fn scale(&self, axis: usize) -> Option<f64> {
        let alone = Some(self.alone[axis]).filter(|own| own.is_finite());
        self.deviation(axis).or(alone)
    }

    pub(super) fn covariance(&self, parameters: &[Parameter], parts: &[f64]) -> Vec<f64> {
        let slope = |k: usize| parameters[k].slope(parts[k]);
        let whole = self
            .inverse
            .as_ref()
            .filter(|_| self.active.len() == parts.len());
        whole.map_or_else(Vec::new, |inverse| {
            Matrix::from_fn(parts.len(), parts.len(), |i, j| {
                inverse[(i, j)] * slope(i) * slope(j)
            })
            .to_row_major()
        })
    }
}
