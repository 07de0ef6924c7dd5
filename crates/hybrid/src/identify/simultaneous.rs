//! Quantile of the largest of several correlated errors.
//!
//! ```text
//! P(max over i of e_i / σ_i ≤ q) = confidence,     e normal about zero with covariance Σ,  σ_i² = Σ_ii
//! ```
//!
//! The largest of n measured values is the largest of n errors too, and exceeds its truth far more often than each of them does alone.
//! Errors of neighbouring places are nearly one error, so that the quantile is found by draws of the joint distribution.

use rand::SeedableRng;
use rand::rngs::StdRng;
use stickslip_fem_core::linalg::Matrix;

use super::error::IdentifyError;
use super::misfit::factored;
use crate::random::normal;

/// Draws of the joint distribution. The quantile of 95 % then has a standard deviation of about 0.03.
const DRAWS: usize = 4000;

/// The q `[1]` that all errors, each over its own standard deviation, stay below together with the probability `confidence`, between 0 and 1.
///
/// `covariances` are those of groups of errors, square, row by row, of any unit; errors of different groups are independent. The same
/// `seed` gives the same draws. Without errors q is 0.
///
/// # Errors
/// [`IdentifyError::Covariance`] for a matrix that is not a valid covariance.
pub fn simultaneous_quantile(
    covariances: &[Vec<f64>],
    confidence: f64,
    seed: u64,
) -> Result<f64, IdentifyError> {
    let factors: Vec<Matrix> = (covariances.iter())
        .map(|own| correlations(own))
        .collect::<Result<_, _>>()?;
    if factors.iter().all(|own| own.rows() == 0) {
        return Ok(0.0);
    }
    let mut random = StdRng::seed_from_u64(seed);
    let mut largest: Vec<f64> = (0..DRAWS)
        .map(|_| {
            let of_group = |lower: &Matrix| -> f64 {
                let noise: Vec<f64> = (0..lower.rows()).map(|_| normal(&mut random)).collect();
                (0..lower.rows())
                    .map(|i| (0..=i).map(|j| lower[(i, j)] * noise[j]).sum())
                    .fold(f64::NEG_INFINITY, f64::max)
            };
            (factors.iter().map(of_group)).fold(f64::NEG_INFINITY, f64::max)
        })
        .collect();
    largest.sort_by(f64::total_cmp);
    let last = DRAWS - 1;
    Ok(largest[((confidence * last as f64).ceil() as usize).min(last)])
}

/// Lower factor of the correlations of a covariance.
fn correlations(covariance: &[f64]) -> Result<Matrix, IdentifyError> {
    let n = (covariance.len() as f64).sqrt().round() as usize;
    let deviations: Vec<f64> = (0..n).map(|i| covariance[i * (n + 1)].sqrt()).collect();
    if let Some(place) = deviations
        .iter()
        .position(|own| own.is_nan() || *own <= 0.0)
    {
        return Err(IdentifyError::Covariance { place });
    }
    let correlation = Matrix::from_fn(n, n, |i, j| {
        covariance[i * n + j] / (deviations[i] * deviations[j])
    });
    factored(correlation)
        .map(|factor| factor.lower().clone())
        .map_err(|place| IdentifyError::Covariance { place })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::identify::normal_quantile;

    fn equal(n: usize, correlation: f64) -> Vec<f64> {
        (0..n * n)
            .map(|at| {
                if at / n == at % n {
                    4.0
                } else {
                    4.0 * correlation
                }
            })
            .collect()
    }

    #[test]
    fn independent_errors_have_the_quantile_of_their_product() {
        for n in [1_usize, 10] {
            let found = simultaneous_quantile(&[equal(n, 0.0)], 0.95, 1).unwrap();
            let exact = normal_quantile(0.95_f64.powf(1.0 / n as f64));
            // To three standard deviations of a quantile of as many draws.
            assert!((found - exact).abs() < 0.1, "{n}: {found} of {exact}");
            let groups = vec![vec![1.0]; n];
            let apart = simultaneous_quantile(&groups, 0.95, 2).unwrap();
            assert!((apart - exact).abs() < 0.1, "{n}: {apart} of {exact}");
        }
    }

    #[test]
    fn errors_that_are_one_have_the_quantile_of_one() {
        let found = simultaneous_quantile(&[equal(20, 1.0)], 0.95, 1).unwrap();
        assert!((found - normal_quantile(0.95)).abs() < 0.1, "{found}");
    }

    #[test]
    fn nothing_has_none_and_what_does_not_scatter_is_refused() {
        assert_eq!(simultaneous_quantile(&[], 0.95, 1), Ok(0.0));
        let flat = simultaneous_quantile(&[vec![1.0, 0.0, 0.0, 0.0]], 0.95, 1);
        assert_eq!(flat, Err(IdentifyError::Covariance { place: 1 }));
    }
}
