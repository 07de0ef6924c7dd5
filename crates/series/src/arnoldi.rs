//! Polynomials that are orthonormal on points of an outline.
//!
//! ```text
//! h_{n+1,n} q_{n+1}(ζ) = ζ/s q_n(ζ) − Σ_{j ≤ n} h_jn q_j(ζ),     ⟨q_i, q_j⟩ = (1/m) Σ conj q_i q_j = δ_ij
//! ```
//!
//! Derivatives and Taylor coefficients at 0 follow by the same recurrence, and so do the derivatives in terms of the polynomials themselves, q_n′ = Σ_k D_kn q_k.
//! D is upper triangular, so antiderivatives are found by back substitution. On an outline that is symmetric about x the points of its half are enough:
//! the real part of the product is that of the whole, and coefficients are real.
//!
//! Source: Brubeck, Nakatsukasa & Trefethen, SIAM Rev. 63 (2021) 405–415.

use std::sync::OnceLock;

use nalgebra::Complex;

type C64 = Complex<f64>;

/// The recurrence.
#[derive(Clone, Debug)]
pub(crate) struct Basis {
    scale: f64,
    first: f64,
    /// h_jn, j ≤ n + 1, of each n.
    recurrence: Vec<Vec<C64>>,
    /// D_kn, k < n, of each n.
    derivatives: OnceLock<Vec<Vec<C64>>>,
}

/// Values q_n and derivatives dq_n/dζ at some points, by n.
#[derive(Clone, Debug)]
pub(crate) struct Values {
    pub(crate) values: Vec<Vec<C64>>,
    pub(crate) slopes: Vec<Vec<C64>>,
}

impl Basis {
    /// The polynomials up to `degree` that are orthonormal on `points`, and their values there.
    pub(crate) fn new(points: &[C64], degree: usize, symmetric: bool) -> (Self, Values) {
        let count = points.len() as f64;
        let product = |a: &[C64], b: &[C64]| {
            let sum: C64 = if symmetric {
                real_product(a, b).into()
            } else {
                a.iter().zip(b).map(|(a, b)| a.conj() * b).sum()
            };
            sum / count
        };
        let scale = points.iter().map(|point| point.norm()).fold(0.0, f64::max);
        let mut basis = Self {
            scale,
            first: 1.0,
            recurrence: Vec::with_capacity(degree),
            derivatives: OnceLock::new(),
        };
        let mut found = basis.start(points);
        for n in 0..degree {
            let [mut next, mut slope] = basis.raise(&found, n, points);
            let mut column = Vec::with_capacity(n + 2);
            for j in 0..=n {
                let part = product(&found.values[j], &next);
                subtract(&mut next, part, &found.values[j]);
                subtract(&mut slope, part, &found.slopes[j]);
                column.push(part);
            }
            let norm = product(&next, &next).re.sqrt();
            column.push(norm.into());
            divide(&mut next, norm);
            divide(&mut slope, norm);
            found.values.push(next);
            found.slopes.push(slope);
            basis.recurrence.push(column);
        }
        (basis, found)
    }

    /// Degree of the last polynomial.
    pub(crate) fn degree(&self) -> usize {
        self.recurrence.len()
    }

    /// Values at other points.
    pub(crate) fn at(&self, points: &[C64]) -> Values {
        let mut found = self.start(points);
        for (n, column) in self.recurrence.iter().enumerate() {
            let [mut next, mut slope] = self.raise(&found, n, points);
            for (j, part) in column[..=n].iter().enumerate() {
                subtract(&mut next, *part, &found.values[j]);
                subtract(&mut slope, *part, &found.slopes[j]);
            }
            divide(&mut next, column[n + 1].re);
            divide(&mut slope, column[n + 1].re);
            found.values.push(next);
            found.slopes.push(slope);
        }
        found
    }

    /// Values q_n at one point, by n.
    pub(crate) fn values(&self, point: C64) -> Vec<C64> {
        let mut found = Vec::with_capacity(self.recurrence.len() + 1);
        found.push(C64::from(self.first));
        let scaled = point / self.scale;
        for (n, column) in self.recurrence.iter().enumerate() {
            let next = scaled * found[n] - product(&column[..=n], &found);
            found.push(next / column[n + 1].re);
        }
        found
    }

    /// D of the module's equation.
    fn derivatives(&self) -> &[Vec<C64>] {
        self.derivatives.get_or_init(|| {
            let mut found: Vec<Vec<C64>> = vec![Vec::new()];
            for (n, column) in self.recurrence.iter().enumerate() {
                // h_{n+1,n} q_{n+1}′ = q_n/s + ζ/s q_n′ − Σ h_jn q_j′
                let mut next = vec![C64::new(0.0, 0.0); n + 1];
                next[n] = (1.0 / self.scale).into();
                for (k, part) in found[n].iter().enumerate() {
                    subtract(&mut next, -part, &self.recurrence[k]);
                }
                for (part, slope) in column[..=n].iter().zip(&found) {
                    subtract(&mut next, *part, slope);
                }
                divide(&mut next, column[n + 1].re);
                found.push(next);
            }
            found
        })
    }

    /// Coefficients of the derivative of Σ `coefficients[n]` q_n.
    pub(crate) fn derivative(&self, coefficients: &[C64]) -> Vec<C64> {
        let mut found = vec![C64::new(0.0, 0.0); coefficients.len()];
        for (amount, column) in coefficients.iter().zip(self.derivatives()) {
            subtract(&mut found, -amount, column);
        }
        found
    }

    /// Coefficients of the antiderivative of Σ `coefficients[n]` q_n that is 0 at 0. The last coefficient, as many as there are polynomials, is ignored.
    pub(crate) fn antiderivative(&self, coefficients: &[C64]) -> Vec<C64> {
        let mut rest = coefficients.to_vec();
        let mut found = vec![C64::new(0.0, 0.0); coefficients.len()];
        for (n, column) in self.derivatives().iter().enumerate().skip(1).rev() {
            found[n] = rest[n - 1] / column[n - 1];
            subtract(&mut rest, found[n], column);
        }
        let at_centre = self.values(C64::new(0.0, 0.0));
        let sum: C64 = found.iter().zip(&at_centre).map(|(c, q)| c * q).sum();
        found[0] = -sum / self.first;
        found
    }

    /// Coefficients of ζ^j in q_n, j up to `order`, by n.
    pub(crate) fn taylor(&self, order: usize) -> Vec<Vec<C64>> {
        let zero = C64::new(0.0, 0.0);
        let mut first = vec![zero; order + 1];
        first[0] = self.first.into();
        let mut found = vec![first];
        for (n, column) in self.recurrence.iter().enumerate() {
            let mut next = vec![zero; order + 1];
            for j in 0..order {
                next[j + 1] = found[n][j] / self.scale;
            }
            for (j, part) in column[..=n].iter().enumerate() {
                subtract(&mut next, *part, &found[j]);
            }
            divide(&mut next, column[n + 1].re);
            found.push(next);
        }
        found
    }

    fn start(&self, points: &[C64]) -> Values {
        Values {
            values: vec![vec![self.first.into(); points.len()]],
            slopes: vec![vec![C64::new(0.0, 0.0); points.len()]],
        }
    }

    /// ζ/s q_n and its derivative.
    fn raise(&self, found: &Values, n: usize, points: &[C64]) -> [Vec<C64>; 2] {
        let (values, slopes) = (&found.values[n], &found.slopes[n]);
        let next = points.iter().zip(values).map(|(z, q)| z * q / self.scale);
        let both = points.iter().zip(values).zip(slopes);
        let slope = both.map(|((z, q), dq)| (q + z * dq) / self.scale);
        [next.collect(), slope.collect()]
    }
}

/// Σ c_n q_n of `coefficients` and `values`.
pub(crate) fn sum(coefficients: &[C64], values: &[C64]) -> C64 {
    let pairs = coefficients.iter().zip(values);
    pairs.map(|(a, q)| a * q).sum()
}

/// Re Σ conj a b, in four sums that do not wait for each other.
fn real_product(a: &[C64], b: &[C64]) -> f64 {
    let mut sums = [0.0; 4];
    for (a, b) in a.chunks(4).zip(b.chunks(4)) {
        for ((sum, a), b) in sums.iter_mut().zip(a).zip(b) {
            *sum += a.re * b.re + a.im * b.im;
        }
    }
    sums[0] + sums[1] + (sums[2] + sums[3])
}

/// Σ parts_j values_j, in four sums that do not wait for each other.
fn product(parts: &[C64], values: &[C64]) -> C64 {
    let mut sums = [C64::new(0.0, 0.0); 4];
    for (parts, values) in parts.chunks(4).zip(values.chunks(4)) {
        for ((sum, part), value) in sums.iter_mut().zip(parts).zip(values) {
            *sum += part * value;
        }
    }
    sums[0] + sums[1] + (sums[2] + sums[3])
}

fn subtract(from: &mut [C64], part: C64, other: &[C64]) {
    let pairs = from.iter_mut().zip(other);
    if part.im == 0.0 {
        for (value, other) in pairs {
            *value -= other * part.re;
        }
    } else {
        for (value, other) in pairs {
            *value -= part * other;
        }
    }
}

fn divide(values: &mut [C64], by: f64) {
    let factor = 1.0 / by;
    for value in values {
        *value *= factor;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn values_slopes_and_coefficients_are_of_one_polynomial() {
        let points: Vec<C64> = (0..200)
            .map(|k| C64::from_polar(1.0, 0.0314 * f64::from(k)))
            .map(|z| C64::new(14.0 * z.re + 4.0, 4.0 * z.im))
            .collect();
        for symmetric in [false, true] {
            let (basis, found) = Basis::new(&points, 40, symmetric);
            let again = basis.at(&points);
            let near = C64::new(0.6, 0.7);
            let step = C64::new(1e-6, 0.0);
            let Values { values, slopes } = basis.at(&[near, near - step, near + step]);
            let taylor = basis.taylor(40);
            for n in 0..=40 {
                let same = found.values[n].iter().zip(&again.values[n]);
                assert!(same.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) < 1e-12);
                let difference = (values[n][2] - values[n][1]) / (2.0 * step);
                assert!((difference - slopes[n][0]).norm() < 1e-8);
                let sum =
                    (taylor[n].iter().rev()).fold(C64::new(0.0, 0.0), |sum, a| sum * near + a);
                assert!((sum - values[n][0]).norm() < 1e-11, "{n}");
            }
        }
    }
}
