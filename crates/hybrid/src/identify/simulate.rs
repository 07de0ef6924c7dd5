//! Monte Carlo simulation of a coefficient, to confirm its interval.
//!
//! ```text
//! (p, s τ) = (p̂, μ̂ p̂) + L z,   L Lᵀ = Σ,   z standard normal,   μ* = argmin χ²
//! ```

use std::ops::Range;

use rand::SeedableRng;
use rand::rngs::StdRng;
use stickslip_fem_core::linalg::{DenseCholesky, Matrix};

use super::misfit::{Misfit, chi_squared, factored};
use super::{Bounds, IdentifyError, SlipFit, Tractions};
use crate::random::normal;

/// Coefficients at which χ² is known while a draw is fitted, on either side of the best one.
const GRID: usize = 24;
/// They reach so many half widths of the interval far.
const REACH: f64 = 3.0;

impl Tractions {
    /// Coefficients `[1]` of `count` random draws of the tractions of `zone`, around tractions that slip with the coefficient of `fit`. The
    /// same `seed` gives the same draws. Coefficients beyond three half widths of the interval are cut there; nothing is drawn where
    /// it has no upper end.
    ///
    /// # Errors
    /// As [`Tractions::slip`].
    pub fn simulate(
        &self,
        zone: Range<usize>,
        positive: bool,
        fit: &SlipFit,
        count: usize,
        seed: u64,
    ) -> Result<Vec<f64>, IdentifyError> {
        let half = match fit.bounds {
            Bounds::Between(low, high) => 0.5 * (high - low),
            Bounds::AtMost(high) => high - fit.mu,
            Bounds::AtLeast(_) | Bounds::Nothing => return Ok(Vec::new()),
        };
        let misfit = self.misfit(zone.clone(), positive)?;
        let grid = Grid::new(&misfit, fit.mu, REACH * half / GRID as f64)?;
        let factor = root(self, &zone, positive)?;
        let root = factor.lower();
        let n = zone.len();
        let mut random = StdRng::seed_from_u64(seed);
        let draws = (0..count).map(|_| {
            let noise: Vec<f64> = (0..2 * n).map(|_| normal(&mut random)).collect();
            let drawn = |row: usize| {
                let own = (0..=row).map(|k| root[(row, k)] * noise[k]);
                own.sum::<f64>()
            };
            let pressure: Vec<f64> = (0..n).map(|k| misfit.pressure[k] + drawn(k)).collect();
            let shear: Vec<f64> = (0..n)
                .map(|k| fit.mu * misfit.pressure[k] + drawn(n + k))
                .collect();
            grid.least(&pressure, &shear)
        });
        Ok(draws.collect())
    }
}

/// Cholesky factor of the covariance of the zone's pressures and shears along friction.
fn root(
    data: &Tractions,
    zone: &Range<usize>,
    positive: bool,
) -> Result<DenseCholesky, IdentifyError> {
    let own = data.of_zones(&[(zone.clone(), positive)])?;
    let n = zone.len();
    let covariance = Matrix::from_fn(2 * n, 2 * n, |i, j| own.covariance[i * 2 * n + j]);
    factored(covariance).map_err(|row| IdentifyError::Covariance { place: row % n })
}

/// Factors of C(μ) at evenly spread coefficients.
struct Grid {
    coefficients: Vec<f64>,
    factors: Vec<DenseCholesky>,
}

impl Grid {
    fn new(misfit: &Misfit, middle: f64, step: f64) -> Result<Self, IdentifyError> {
        let below = GRID.min((middle / step) as usize);
        let first = middle - below as f64 * step;
        let coefficients: Vec<f64> = (0..=below + GRID)
            .map(|k| first + k as f64 * step)
            .collect();
        let factors = coefficients.iter().map(|mu| misfit.factor(*mu));
        Ok(Self {
            factors: factors.collect::<Result<_, _>>()?,
            coefficients,
        })
    }

    /// Where χ² is least, by a parabola through the least value and its neighbours.
    fn least(&self, pressure: &[f64], shear: &[f64]) -> f64 {
        let value = |k: usize| {
            let mu = self.coefficients[k];
            chi_squared(&self.factors[k], pressure, shear, mu)
        };
        let values: Vec<f64> = (0..self.factors.len()).map(value).collect();
        let best =
            (0..values.len()).fold(0, |best, k| if values[k] < values[best] { k } else { best });
        if best == 0 || best + 1 == values.len() {
            return self.coefficients[best];
        }
        let [a, b, c] = [values[best - 1], values[best], values[best + 1]];
        let step = self.coefficients[best + 1] - self.coefficients[best];
        let curvature = a - 2.0 * b + c;
        let shift = if curvature > 0.0 {
            0.5 * (a - c) / curvature
        } else {
            0.0
        };
        self.coefficients[best] + shift * step
    }
}
