//! Polylogarithms Li_s(x) = Σ x^k / k^s on the unit disk, at x = e^μ.
//!
//! ```text
//! Li_1 = −ln(−μ) − μ/2 − A_1,     Li_2 = π²/6 + μ (1 − ln(−μ) − A_2) − μ²/4,
//! Li_3 = ζ(3) + π² μ/6 + μ² (3/4 − ln(−μ)/2 − A_3) − μ³/12,                     |μ| < 2π
//! A_s = Σ_m b_m/2m μ^2m × (1, 1/(2m + 1), 1/((2m + 1)(2m + 2))),     b_m = B_2m/(2m)! = (−1)^{m+1} 2 ζ(2m)/(2π)^2m
//! ```
//!
//! On the circle, at μ = iα, Li_1 is elementary and Li_2 has one series of real terms, Clausen's function. Source: Lewin, *Polylogarithms and
//! Associated Functions* (1981), 4.1 and 7.6.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use nalgebra::Complex;

type C64 = Complex<f64>;

const TERMS: usize = 30;
const ZETA_3: f64 = 1.202_056_903_159_594_3;
/// Terms of Clausen's function, (½)^2m/(2m (2m + 1)) at a half turn.
const CIRCLE_TERMS: usize = 22;
/// |μ|² by which the numbers of terms are kept.
const BIN: f64 = 0.25;
const BINS: usize = 56;

/// Li_1, Li_2 and Li_3.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Polylogarithms {
    /// Coefficients of μ^2m in A_1, A_2 and A_3, m ≥ 1.
    terms: [[f64; 3]; TERMS],
    /// Terms that |μ|² needs, in steps of [`BIN`].
    counts: [usize; BINS],
    /// Coefficients of α^2m in −A_2 at μ = iα, m ≥ 1.
    circle: [f64; CIRCLE_TERMS],
}

impl Polylogarithms {
    pub(crate) fn new() -> Self {
        let terms: [[f64; 3]; TERMS] = std::array::from_fn(|index| {
            let order = 2 * (index as i32 + 1);
            let zeta: f64 = match order {
                2 => PI * PI / 6.0,
                4 => PI.powi(4) / 90.0,
                6 => PI.powi(6) / 945.0,
                // 60^−8 is below rounding.
                _ => (1..60).rev().map(|k| f64::from(k).powi(-order)).sum(),
            };
            let sign = if index % 2 == 0 { 2.0 } else { -2.0 };
            let n = f64::from(order);
            let first = sign * zeta / TAU.powi(order) / n;
            [first, first / (n + 1.0), first / ((n + 1.0) * (n + 2.0))]
        });
        let counts = std::array::from_fn(|bin| {
            let most = (bin as f64 + 1.0) * BIN;
            let left = |count: usize| terms[count - 1][0].abs() * most.powi(count as i32);
            let found = (1..TERMS).find(|&count| left(count) < 1e-17);
            found.unwrap_or(TERMS)
        });
        Self {
            circle: std::array::from_fn(|index| terms[index][1].abs()),
            terms,
            counts,
        }
    }

    /// Li_1, Li_2 and Li_3 at e^μ for Re μ ≤ 0, |Im μ| ≤ π and |μ|² < 14; Li_1 is infinite at μ = 0.
    pub(crate) fn at(&self, mu: C64) -> [C64; 3] {
        let square = mu * mu;
        let size = mu.norm_sqr();
        if size < 1e-300 {
            let first = C64::new(f64::INFINITY, 0.0);
            return [first, (PI * PI / 6.0).into(), ZETA_3.into()];
        }
        let log = C64::new(0.5 * size.ln(), (-mu.im).atan2(-mu.re));
        let count = self.counts[((size / BIN) as usize).min(BINS - 1)];
        let mut power = square;
        let mut sums = [C64::new(0.0, 0.0); 3];
        for [first, second, third] in &self.terms[..count] {
            sums[0] += power * *first;
            sums[1] += power * *second;
            sums[2] += power * *third;
            power *= square;
        }
        let first = -log - 0.5 * mu - sums[0];
        let second = PI * PI / 6.0 + mu * (1.0 - log - sums[1]) - 0.25 * square;
        let third = ZETA_3 + PI * PI / 6.0 * mu + square * (0.75 - 0.5 * log - sums[2])
            - mu * square / 12.0;
        [first, second, third]
    }

    /// Li_2(e^{iα}) for |α| ≤ π.
    pub(crate) fn second_on_circle(&self, alpha: f64) -> C64 {
        let size = alpha.abs();
        let real = PI * PI / 6.0 - 0.25 * size * (TAU - size);
        if size < f64::MIN_POSITIVE {
            return real.into();
        }
        let square = alpha * alpha;
        // Two sums that do not wait for each other.
        let fourth = square * square;
        let [mut even, mut odd] = [0.0; 2];
        for pair in self.circle.chunks_exact(2).rev() {
            odd = odd * fourth + pair[0];
            even = even * fourth + pair[1];
        }
        let sum = square * (odd + square * even);
        C64::new(real, alpha * (1.0 - size.ln() + sum))
    }
}

/// Li_1(e^{iα}) for |α| ≤ π; infinite at 0.
pub(crate) fn first_on_circle(alpha: f64) -> C64 {
    let turn = if alpha == 0.0 {
        0.0
    } else {
        FRAC_PI_2.copysign(alpha) - 0.5 * alpha
    };
    C64::new(-(2.0 * (0.5 * alpha).sin().abs()).ln(), turn)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn known_values_are_met() {
        let polylogarithms = Polylogarithms::new();
        let at = |x: C64| polylogarithms.at(x.ln());
        let [first, second, third] = at(C64::new(0.5, 0.0));
        let ln2 = 2.0_f64.ln();
        assert!((first - ln2).norm() < 1e-15);
        assert!((second - (PI * PI / 12.0 - 0.5 * ln2 * ln2)).norm() < 1e-15);
        let expected = ln2.powi(3) / 6.0 - PI * PI * ln2 / 12.0 + 0.875 * ZETA_3;
        assert!((third - expected).norm() < 1e-15);
        let [_, second, third] = at(C64::new(-1.0, 0.0));
        assert!((second + PI * PI / 12.0).norm() < 2e-15);
        assert!((third + 0.75 * ZETA_3).norm() < 2e-15);
        let [_, second, third] = at(C64::new(1.0, 0.0));
        assert_eq!((second.re, third.re), (PI * PI / 6.0, ZETA_3));
        // Li_2(i) = −π²/48 + iG, G Catalan's constant.
        let catalan = C64::new(-PI * PI / 48.0, 0.915_965_594_177_219);
        let [_, second, _] = at(C64::new(0.0, 1.0));
        assert!((second - catalan).norm() < 1e-15);
        assert!((polylogarithms.second_on_circle(FRAC_PI_2) - catalan).norm() < 1e-15);
    }

    #[test]
    fn both_series_agree() {
        let polylogarithms = Polylogarithms::new();
        for k in 0..24 {
            for radius in [0.25, 0.6, 0.9] {
                let x = C64::from_polar(radius, 0.26 * f64::from(k));
                let (mut power, mut sums) = (C64::new(1.0, 0.0), [C64::new(0.0, 0.0); 3]);
                for n in 1..400 {
                    power *= x;
                    for (s, sum) in sums.iter_mut().enumerate() {
                        *sum += power / f64::from(n).powi(s as i32 + 1);
                    }
                }
                for (found, sum) in polylogarithms.at(x.ln()).iter().zip(sums) {
                    assert!((found - sum).norm() < 4e-15, "{x}");
                }
            }
        }
    }

    #[test]
    fn values_on_the_circle_are_those_of_the_disk() {
        let polylogarithms = Polylogarithms::new();
        for k in -40..=40 {
            let alpha = PI * f64::from(k) / 40.0;
            let [first, second, _] = polylogarithms.at(C64::new(0.0, alpha));
            assert!((second - polylogarithms.second_on_circle(alpha)).norm() < 2e-15);
            assert!(k == 0 || (first - first_on_circle(alpha)).norm() < 2e-15);
        }
    }
}
