//! Polylogarithms Li_s(x) = Σ x^k / k^s on the unit disk.
//!
//! ```text
//! Li_s(e^μ) = Σ_{k ≠ s−1} ζ(s − k) μ^k/k! + μ^{s−1}/(s − 1)! (H_{s−1} − ln(−μ)),    |μ| < 2π
//! ```
//!
//! away from 0, the defining series near it. ζ(1 − 2m)/(2m)! = −b_m/2m with b_m = B_2m/(2m)! = (−1)^{m+1} 2 ζ(2m)/(2π)^{2m}. Source: Lewin,
//! *Polylogarithms and Associated Functions* (1981), 7.6.

use std::f64::consts::{PI, TAU};

use nalgebra::Complex;

type C64 = Complex<f64>;

const TERMS: usize = 29;
const ZETA_3: f64 = 1.202_056_903_159_594_3;

/// Li_1, Li_2 and Li_3.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polylogarithms {
    /// b_m, m ≥ 1.
    bernoulli: [f64; TERMS],
}

impl Polylogarithms {
    pub(crate) fn new() -> Self {
        let mut sign = 2.0;
        let bernoulli = std::array::from_fn(|index| {
            let order = 2 * (index as i32 + 1);
            let zeta: f64 = match order {
                2 => PI * PI / 6.0,
                4 => PI.powi(4) / 90.0,
                6 => PI.powi(6) / 945.0,
                // 60^−8 is below rounding.
                _ => (1..60).rev().map(|k| f64::from(k).powi(-order)).sum(),
            };
            let value = sign * zeta / TAU.powi(order);
            sign = -sign;
            value
        });
        Self { bernoulli }
    }

    /// Li_1(x), Li_2(x), Li_3(x) for |x| ≤ 1; Li_1(1) is infinite.
    pub(crate) fn at(&self, x: C64) -> [C64; 3] {
        const NEAR: f64 = 0.25;
        let first = -(1.0 - x).ln();
        if x.norm_sqr() < NEAR * NEAR {
            let (mut power, mut second, mut third) = (x, x, x);
            for k in 2..28 {
                power *= x;
                let k = f64::from(k);
                second += power / (k * k);
                third += power / (k * k * k);
            }
            return [first, second, third];
        }
        let mu = x.ln();
        if mu.norm() < 1e-300 {
            return [first, (PI * PI / 6.0).into(), ZETA_3.into()];
        }
        let square = mu * mu;
        let log = (-mu).ln();
        let mut second = PI * PI / 6.0 + mu * (1.0 - log) - 0.25 * square;
        let mut third =
            ZETA_3 + PI * PI / 6.0 * mu + 0.5 * square * (1.5 - log) - mu * square / 12.0;
        let mut power = mu;
        for (index, b) in self.bernoulli.iter().enumerate() {
            let n = 2.0 * (index as f64 + 1.0);
            power *= square;
            let term = power * (b / (n * (n + 1.0)));
            second -= term;
            third -= term * mu / (n + 2.0);
        }
        [first, second, third]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_are_met() {
        let polylogarithms = Polylogarithms::new();
        let [first, second, third] = polylogarithms.at(C64::new(0.5, 0.0));
        let ln2 = 2.0_f64.ln();
        assert!((first - ln2).norm() < 1e-15);
        assert!((second - (PI * PI / 12.0 - 0.5 * ln2 * ln2)).norm() < 1e-15);
        let expected = ln2.powi(3) / 6.0 - PI * PI * ln2 / 12.0 + 0.875 * ZETA_3;
        assert!((third - expected).norm() < 1e-15);
        let [_, second, third] = polylogarithms.at(C64::new(-1.0, 0.0));
        assert!((second + PI * PI / 12.0).norm() < 2e-15);
        assert!((third + 0.75 * ZETA_3).norm() < 2e-15);
        let [_, second, third] = polylogarithms.at(C64::new(1.0, 0.0));
        assert_eq!((second.re, third.re), (PI * PI / 6.0, ZETA_3));
        // Li_2(i) = −π²/48 + iG, G Catalan's constant.
        let [_, second, _] = polylogarithms.at(C64::new(0.0, 1.0));
        assert!((second - C64::new(-PI * PI / 48.0, 0.915_965_594_177_219)).norm() < 1e-15);
    }

    #[test]
    fn both_series_agree() {
        let polylogarithms = Polylogarithms::new();
        for k in 0..24 {
            for radius in [0.2499999999, 0.25000001, 0.6, 0.9] {
                let x = C64::from_polar(radius, 0.26 * f64::from(k));
                let (mut power, mut sums) = (C64::new(1.0, 0.0), [C64::new(0.0, 0.0); 3]);
                for n in 1..400 {
                    power *= x;
                    for (s, sum) in sums.iter_mut().enumerate() {
                        *sum += power / f64::from(n).powi(s as i32 + 1);
                    }
                }
                for (found, sum) in polylogarithms.at(x).iter().zip(sums) {
                    assert!((found - sum).norm() < 4e-15, "{x}");
                }
            }
        }
    }
}
