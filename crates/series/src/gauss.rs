//! Gauss–Legendre rules on [0, 1].

use std::f64::consts::PI;

/// Points and weights of the rule with `count` points on [0, 1], exact for polynomials of degree 2 `count` − 1; by Newton's method on the
/// Legendre polynomial from Tricomi's starting values.
pub(crate) fn rule(count: usize) -> Vec<[f64; 2]> {
    const STEPS: usize = 6;
    let n = count as f64;
    (0..count)
        .map(|k| {
            let mut x = (PI * (k as f64 + 0.75) / (n + 0.5)).cos();
            let mut slope = 1.0;
            for _ in 0..STEPS {
                let (value, derivative) = legendre(count, x);
                slope = derivative;
                x -= value / derivative;
            }
            [0.5 * (1.0 - x), 1.0 / ((1.0 - x * x) * slope * slope)]
        })
        .collect()
}

/// P_n(x) and P_n′(x) for |x| < 1.
fn legendre(count: usize, x: f64) -> (f64, f64) {
    let (mut before, mut value) = (1.0, x);
    for k in 2..=count {
        let k = k as f64;
        (before, value) = (
            value,
            ((2.0 * k - 1.0) * x * value - (k - 1.0) * before) / k,
        );
    }
    (value, count as f64 * (before - x * value) / (1.0 - x * x))
}

/// Rules for a kernel whose singularity lies outside of the interval, by its distance in lengths of the interval.
#[derive(Clone, Debug)]
pub(crate) struct Rules {
    /// Distance from which on a rule leaves 1e-13 of the kernel, and the rule; falling.
    rules: Vec<(f64, Vec<[f64; 2]>)>,
}

impl Rules {
    /// A rule of n points errs by ϱ^−2n, ϱ = c + √(c² − 1), c = 1 + 2 distance/length (Davis & Rabinowitz 1984, 4.6.1).
    pub(crate) fn new() -> Self {
        const DIGITS: f64 = 30.0;
        let rules = (3..=9).map(|count| {
            let reach = DIGITS / (2.0 * count as f64);
            let centre = 0.5 * (reach.exp() + (-reach).exp());
            (0.5 * (centre - 1.0), rule(count))
        });
        Self {
            rules: rules.collect(),
        }
    }

    /// The shortest rule for a singularity at `distance` in lengths of the interval, the longest one for distances below 1.
    pub(crate) fn at(&self, distance: f64) -> &[[f64; 2]] {
        let found = self.rules.iter().find(|(from, _)| distance >= *from);
        &found.unwrap_or(&self.rules[self.rules.len() - 1]).1
    }

    /// The longest rule.
    pub(crate) fn longest(&self) -> &[[f64; 2]] {
        &self.rules[self.rules.len() - 1].1
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rules_are_exact_for_polynomials() {
        for count in 1..=40 {
            let points = rule(count);
            for degree in [0, 1, 2 * count - 1] {
                let sum: f64 = points.iter().map(|[x, w]| w * x.powi(degree as i32)).sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!(
                    (sum / exact - 1.0).abs() < 1e-13,
                    "{count} points, degree {degree}"
                );
            }
        }
    }

    #[test]
    fn a_logarithm_is_integrated_to_its_digits() {
        let rules = Rules::new();
        for distance in [1.0, 1.7, 3.0, 10.0, 60.0] {
            let sum: f64 = (rules.at(distance).iter())
                .map(|[x, w]| w * (distance + x).ln())
                .sum();
            let end: f64 = distance + 1.0;
            let exact = end * end.ln() - distance * distance.ln() - 1.0;
            assert!((sum - exact).abs() < 2e-13, "{distance}: {:e}", sum - exact);
        }
    }
}
