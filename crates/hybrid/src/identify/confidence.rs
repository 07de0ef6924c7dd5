//! Quantiles that intervals need.
//!
//! ```text
//! Φ(z) = ½ + φ(z) (z + z³/3 + z⁵/(3·5) + …),     Φ(z_p) = p,     χ²₁(c) = z_{(1+c)/2}²
//! ```
//!
//! Source: Marsaglia, *Evaluating the normal distribution* (2004), for the series.

/// Increase of χ² at the ends of an interval of 95 %, one degree of freedom.
pub(super) const CHI_SQUARED_95: f64 = 3.841_458_820_694_124;

/// Beyond this many standard deviations a double has no digits left for the probability.
const FARTHEST: f64 = 8.0;

/// Computes the z `[1]` with the probability `p` below it in a standard normal distribution; ±8 where p is nearer to 0 or 1 than double
/// precision resolves.
pub fn normal_quantile(p: f64) -> f64 {
    let [mut low, mut high] = [-FARTHEST, FARTHEST];
    for _ in 0..80 {
        let middle = f64::midpoint(low, high);
        if distribution(middle) < p {
            low = middle;
        } else {
            high = middle;
        }
    }
    f64::midpoint(low, high)
}

/// Computes the value `[1]` that χ² of one degree of freedom stays below with the probability `confidence`, between 0 and 1.
pub fn chi_squared_of_one(confidence: f64) -> f64 {
    normal_quantile(f64::midpoint(1.0, confidence)).powi(2)
}

/// By how many standard deviations χ² with `degrees` degrees of freedom, `reduced` for each, lies above what it should be, by the cube
/// root that makes it nearly normal (Wilson & Hilferty 1931).
pub(crate) fn excess(reduced: f64, degrees: f64) -> f64 {
    let spread = 2.0 / (9.0 * degrees);
    (reduced.cbrt() - (1.0 - spread)) / spread.sqrt()
}

fn distribution(z: f64) -> f64 {
    let (mut term, mut sum, mut odd) = (z, z, 1.0);
    while term.abs() > 1e-18 * sum.abs() {
        odd += 2.0;
        term *= z * z / odd;
        sum += term;
    }
    0.5 + sum * (-0.5 * z * z).exp() / std::f64::consts::TAU.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quantiles_are_those_of_tables() {
        assert!((chi_squared_of_one(0.95) - CHI_SQUARED_95).abs() < 1e-9);
        // Abramowitz & Stegun (1964), tables 26.2 and 26.6.
        assert!((normal_quantile(0.975) - 1.959_963_985).abs() < 1e-8);
        assert!((normal_quantile(0.000_5) + 3.290_526_731).abs() < 1e-8);
        assert!((chi_squared_of_one(0.99) - 6.634_897).abs() < 1e-5);
        assert!(normal_quantile(0.5).abs() < 1e-9);
    }
}
