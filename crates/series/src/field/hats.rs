//! Sums over the modes of a piecewise linear traction, in closed form or mode by mode.
//!
//! ```text
//! t_K = (1/2π) Σ_J (−D_J/K² − i j_J/K) e^{−iKθ_J}        D_J: jump of dt/dθ, j_J: of t, at knot J
//! Σ_{k ≥ 1} t_k x^k = −(1/2π) Σ_J [D_J Li_2(x e^{−iθ_J}) + i j_J Li_1(x e^{−iθ_J})],   t_−k with conj x, e^{iθ_J} and −i
//! ```
//!
//! The polylogarithms of both signs are conjugates of each other. Away from the circle, where modes decay, they are cheaper than polylogarithms.

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::kink::Kink;
use super::modes::Modes;
use super::polylog::{Polylogarithms, first_on_circle};
use crate::nodes::Nodes;

type C64 = Complex<f64>;

/// A traction t `[stress]` of hats.
#[derive(Clone, Debug)]
pub(crate) struct Hats {
    pub(super) kinks: Vec<Kink>,
    polylogarithms: Polylogarithms,
    modes: Modes,
    parts: Parts,
    /// The traction of each knot.
    values: Vec<C64>,
    /// t_0.
    pub(super) mean: C64,
}

/// Elements, start `[rad]`, length `[rad]` and knots, in the order of their starts.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Parts(Vec<(f64, f64, [usize; 2])>);

/// Σ k t_k x^k, Σ t_k x^k, Σ t_k x^k/k over k ≥ 1.
pub(crate) type Sums = [C64; 3];

impl Parts {
    pub(super) fn of(nodes: &Nodes) -> Self {
        let elements = nodes.elements().iter();
        let mut parts: Vec<_> = elements
            .map(|element| (element.start, element.length, element.knots))
            .collect();
        parts.sort_by(|a, b| a.0.total_cmp(&b.0));
        Self(parts)
    }

    /// Tractions `values` of the knots at `angle` `[rad]`, 0 between hats.
    pub(super) fn interpolated(&self, values: &[C64], angle: f64) -> C64 {
        let first = self.0[0].0;
        let turned = first + (angle - first).rem_euclid(TAU);
        let after = self.0.partition_point(|(start, ..)| *start <= turned);
        let (start, length, [a, b]) = self.0[after.max(1) - 1];
        let along = (turned - start) / length;
        if along <= 1.0 + 1e-12 {
            values[a] + (values[b] - values[a]) * along
        } else {
            C64::new(0.0, 0.0)
        }
    }
}

/// t_0 under the tractions `values` of the knots.
pub(super) fn mean(nodes: &Nodes, values: &[C64]) -> C64 {
    let both = nodes.knots().iter().zip(values);
    both.map(|(knot, value)| value * knot.weight).sum::<C64>() / TAU
}

/// The angle `alpha` `[rad]` on −π to π.
pub(super) fn wrapped(alpha: f64) -> f64 {
    alpha - TAU * (alpha / TAU).round()
}

impl Hats {
    /// The hats on `nodes` with the tractions `values` of its knots.
    pub(super) fn new(nodes: &Nodes, values: &[C64]) -> Self {
        let zero = C64::new(0.0, 0.0);
        let mut kinks = Kink::all(nodes, values);
        kinks.retain(|kink| kink.slope != zero || kink.jump != zero);
        Self {
            kinks,
            polylogarithms: Polylogarithms::new(),
            modes: Modes::default(),
            parts: Parts::of(nodes),
            mean: mean(nodes, values),
            values: values.to_vec(),
        }
    }

    /// The traction at `angle` `[rad]`, 0 between hats.
    pub(crate) fn at(&self, angle: f64) -> C64 {
        self.parts.interpolated(&self.values, angle)
    }

    /// Number of modes that are enough for the sums at `x`, |x| ≤ 1, if they are cheaper than [`sums`](Self::sums).
    pub(super) fn enough(&self, x: C64) -> Option<usize> {
        Modes::enough(self.kinks.len(), -0.5 * x.norm_sqr().ln())
    }

    /// The first `count` pairs t_K, t_−K, K ≥ 1.
    pub(super) fn modes(&self, count: usize) -> impl Iterator<Item = [C64; 2]> {
        self.modes.first(&self.kinks, count)
    }

    /// The sums over t_k for `x` and over t_−k for conj `x`, |x| ≤ 1.
    pub(super) fn sums(&self, x: C64) -> [Sums; 2] {
        let i = C64::new(0.0, 1.0);
        let (log, angle) = (0.5 * x.norm_sqr().ln(), x.arg());
        let [mut positive, mut negative] = [Sums::default(); 2];
        for kink in &self.kinks {
            let mu = C64::new(log, wrapped(angle - kink.angle));
            let orders = self.polylogarithms.at(mu);
            for (s, li) in orders.iter().enumerate() {
                positive[s] -= kink.slope * li;
                negative[s] -= kink.slope * li.conj();
            }
            if kink.jump != C64::new(0.0, 0.0) {
                let turned = mu.exp();
                // On the edge itself only the lower sums are asked for; the first one is infinite at a kink.
                let below = [turned / (1.0 - turned), orders[0], orders[1]];
                for (s, li) in below.iter().enumerate() {
                    positive[s] -= i * kink.jump * li;
                    negative[s] += i * kink.jump * li.conj();
                }
            }
        }
        [positive, negative]
    }

    /// `factor` times the sums Σ t_k e^{ikθ} and Σ t_−k e^{−ikθ} on the circle.
    pub(crate) fn on_edge(&self, theta: f64, factor: C64) -> [C64; 2] {
        let [mut positive, mut negative] = [C64::new(0.0, 0.0); 2];
        for kink in &self.kinks {
            let alpha = wrapped(theta - kink.angle);
            let li = self.polylogarithms.second_on_circle(alpha);
            positive -= kink.slope * li;
            negative -= kink.slope * li.conj();
        }
        let [above, below] = on_edge_of_jumps(&self.kinks, theta, factor);
        [factor * positive + above, factor * negative + below]
    }
}

/// `factor` times the parts of the jumps in the sums on the circle. At a jump the real part is infinite unless the traction along the normal alone jumps there.
pub(super) fn on_edge_of_jumps(kinks: &[Kink], theta: f64, factor: C64) -> [C64; 2] {
    const NOTHING: f64 = 1e-12;
    let [mut positive, mut negative] = [C64::new(0.0, 0.0); 2];
    for kink in kinks {
        let amount = C64::new(0.0, 1.0) * kink.jump * factor;
        if amount == C64::new(0.0, 0.0) {
            continue;
        }
        let li = first_on_circle(wrapped(theta - kink.angle));
        let times = |part: f64, li: f64| {
            if part.abs() <= NOTHING * amount.norm() {
                0.0
            } else {
                part * li
            }
        };
        let own = C64::new(times(amount.re, li.re), times(amount.im, li.re));
        let turned = C64::new(-amount.im, amount.re) * li.im;
        positive -= own + turned;
        negative += own - turned;
    }
    [positive, negative]
}

#[cfg(test)]
mod tests {
    use super::super::kink::mode;
    use super::*;

    fn all() -> Vec<Hats> {
        let graded = vec![0.0, 0.001, 0.01, 0.1, 0.4, 0.9, 1.5, 2.1, 2.5, 2.9];
        let sets = [
            Nodes::uniform_circle(16),
            Nodes::arc(graded.clone()),
            Nodes::mirrored(graded[1..].to_vec()),
        ];
        let hats = |nodes: Result<Nodes, crate::SeriesError>| {
            let nodes = nodes.unwrap();
            let value = |k: usize| C64::new((k * k % 7) as f64 - 2.5, (k * k % 5) as f64);
            let values: Vec<C64> = (0..nodes.knots().len()).map(value).collect();
            Hats::new(&nodes, &values)
        };
        sets.map(hats).into()
    }

    #[test]
    fn closed_forms_are_sums_of_modes() {
        for hats in all() {
            for (k, radius) in [0.6, 0.8, 0.95, 0.99].into_iter().enumerate() {
                let x = C64::from_polar(radius, 0.3 + 1.1 * k as f64);
                let found = hats.sums(x);
                let mut expected = [Sums::default(); 2];
                // 0.99^3600 is below rounding.
                for order in 1..3600 {
                    let k = f64::from(order);
                    let power = C64::from_polar(radius.powi(order), k * x.arg());
                    let pair = [1.0, -1.0].map(|sign| {
                        let of_kink = |kink: &Kink| {
                            let amount =
                                -kink.slope / (k * k) - C64::new(0.0, sign / k) * kink.jump;
                            amount * C64::from_polar(1.0, -sign * k * kink.angle)
                        };
                        hats.kinks.iter().map(of_kink).sum::<C64>()
                    });
                    let terms = [pair[0] * power, pair[1] * power.conj()];
                    for (sums, term) in expected.iter_mut().zip(terms) {
                        sums[0] += term * k;
                        sums[1] += term;
                        sums[2] += term / k;
                    }
                }
                // Slopes are as large as the inverse of the shortest element.
                let size: f64 = hats.kinks.iter().map(|kink| kink.slope.norm()).sum();
                for (a, b) in found.as_flattened().iter().zip(expected.as_flattened()) {
                    assert!((a - b).norm() < 1e-13 * size, "{radius} {a} {b}");
                }
            }
        }
    }

    #[test]
    fn modes_are_those_of_the_kinks() {
        for hats in all() {
            let size: f64 = hats.kinks.iter().map(|kink| kink.slope.norm()).sum();
            for (index, [positive, negative]) in hats.modes(200).enumerate() {
                let order = index as u32 + 1;
                assert!((positive - mode(&hats.kinks, order)).norm() < 1e-14 * size);
                let turned: Vec<Kink> = (hats.kinks.iter())
                    .map(|kink| Kink {
                        angle: -kink.angle,
                        jump: -kink.jump,
                        ..*kink
                    })
                    .collect();
                assert!((negative - mode(&turned, order)).norm() < 1e-14 * size);
            }
        }
    }

    #[test]
    fn the_edge_is_the_limit_of_the_inside() {
        for hats in all() {
            let size: f64 = hats.kinks.iter().map(|kink| kink.slope.norm()).sum();
            for theta in [-2.0, 0.05, 1.0, 2.3, 4.4] {
                let direction = C64::from_polar(1.0, theta);
                let [positive, negative] = hats.sums(direction);
                let found = hats.on_edge(theta, direction);
                for (found, sums) in found.into_iter().zip([positive, negative]) {
                    assert!((found - direction * sums[1]).norm() < 1e-14 * size);
                }
            }
        }
    }
}
