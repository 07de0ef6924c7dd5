//! How far the tractions of a zone are from slip with one coefficient.

use std::ops::Range;

use stickslip_fem_core::linalg::{DenseCholesky, Matrix};

use super::error::IdentifyError;

/// Part of the mean variance below which one is rounding: places closer than the data resolve move together.
const ROUNDING: f64 = 1e-10;

/// Cholesky factor of a covariance whose eigenvalues may be rounding.
pub(super) fn factored(mut covariance: Matrix) -> Result<DenseCholesky, usize> {
    let n = covariance.rows();
    let mean = (0..n).map(|i| covariance[(i, i)]).sum::<f64>() / n as f64;
    (0..n).for_each(|i| covariance[(i, i)] += ROUNDING * mean);
    DenseCholesky::new(covariance).map_err(|cause| cause.row)
}

/// χ² of the residual τ − μ p, whitened by the factor of its covariance.
pub(super) fn chi_squared(factor: &DenseCholesky, pressure: &[f64], shear: &[f64], mu: f64) -> f64 {
    let residual = shear.iter().zip(pressure).map(|(tau, p)| tau - mu * p);
    let whitened = factor.whiten(&residual.collect::<Vec<f64>>());
    whitened.iter().map(|r| r * r).sum()
}

/// χ² of a zone.
pub(super) struct Misfit {
    pub(super) pressure: Vec<f64>,
    pub(super) shear: Vec<f64>,
    /// Σ_pp, s (Σ_pτ + Σ_τp) and Σ_ττ.
    pub(super) blocks: [Matrix; 3],
}

impl Misfit {
    /// That of pressures and shears, turned so that friction is positive, with the covariance of all pressures, then all shears.
    pub(super) fn new(pressure: Vec<f64>, shear: Vec<f64>, covariance: &[f64]) -> Self {
        let count = pressure.len();
        let entry = |i: usize, j: usize| covariance[i * 2 * count + j];
        let blocks = [
            Matrix::from_fn(count, count, entry),
            Matrix::from_fn(count, count, |i, j| {
                entry(i, count + j) + entry(count + i, j)
            }),
            Matrix::from_fn(count, count, |i, j| entry(count + i, count + j)),
        ];
        Self {
            pressure,
            shear,
            blocks,
        }
    }

    pub(super) fn places(&self) -> usize {
        self.pressure.len()
    }

    /// Cholesky factor of C(μ).
    pub(super) fn factor(&self, mu: f64) -> Result<DenseCholesky, IdentifyError> {
        let n = self.places();
        let [pp, both, tt] = &self.blocks;
        let spread = Matrix::from_fn(n, n, |i, j| {
            mu * mu * pp[(i, j)] - mu * both[(i, j)] + tt[(i, j)]
        });
        factored(spread).map_err(|place| IdentifyError::Covariance { place })
    }

    /// By how much χ² falls when the places `inner` have a coefficient of their own, less than that of the others; 0 where it would not
    /// be less. `factor` is that of C.
    pub(super) fn fall(&self, factor: &DenseCholesky, inner: &Range<usize>) -> f64 {
        let n = self.places();
        let mut whitened = Matrix::from_fn(n, 3, |i, column| match (column, inner.contains(&i)) {
            (0, _) => self.shear[i],
            (1, false) | (2, true) => self.pressure[i],
            _ => 0.0,
        });
        factor.solve_lower(&mut whitened);
        let dot = |i: usize, j: usize| -> f64 {
            (0..n).map(|k| whitened[(k, i)] * whitened[(k, j)]).sum()
        };
        let (outer, own, both) = (dot(1, 1), dot(2, 2), dot(1, 2));
        let (of_outer, of_own) = (dot(1, 0), dot(2, 0));
        let determinant = outer * own - both * both;
        if determinant <= ROUNDING * outer * own {
            return 0.0;
        }
        let mu_outer = (own * of_outer - both * of_own) / determinant;
        let mu_own = (outer * of_own - both * of_outer) / determinant;
        if mu_own >= mu_outer {
            return 0.0;
        }
        let together = (of_outer + of_own).powi(2) / (outer + 2.0 * both + own);
        mu_outer * of_outer + mu_own * of_own - together
    }

    pub(super) fn at(&self, mu: f64) -> Result<f64, IdentifyError> {
        let factor = self.factor(mu)?;
        Ok(chi_squared(&factor, &self.pressure, &self.shear, mu))
    }

    /// Where χ² is least between `low` and `high`, by golden sections.
    pub(super) fn least(&self, mut low: f64, mut high: f64) -> Result<f64, IdentifyError> {
        const GOLDEN: f64 = 0.618_033_988_749_894_9;
        let inner =
            |low: f64, high: f64| [high - GOLDEN * (high - low), low + GOLDEN * (high - low)];
        for _ in 0..60 {
            let [left, right] = inner(low, high);
            if self.at(left)? <= self.at(right)? {
                high = right;
            } else {
                low = left;
            }
        }
        Ok(f64::midpoint(low, high))
    }

    /// Where χ² passes `limit` between `outside`, where it is above, and `inside`, where it is not.
    pub(super) fn crossing(
        &self,
        mut outside: f64,
        mut inside: f64,
        limit: &dyn Fn(f64) -> f64,
    ) -> Result<f64, IdentifyError> {
        for _ in 0..60 {
            let middle = f64::midpoint(outside, inside);
            if self.at(middle)? > limit(middle) {
                outside = middle;
            } else {
                inside = middle;
            }
        }
        Ok(f64::midpoint(outside, inside))
    }
}
