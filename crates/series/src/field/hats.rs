//! Sums over the modes of a piecewise linear traction, in closed form.
//!
//! ```text
//! t_K = (1/2π) Σ_J (−D_J/K² − i j_J/K) e^{−iKθ_J}        D_J: jump of dt/dθ, j_J: of t, at knot J
//! Σ_{k ≥ 1} t_k x^k = −(1/2π) Σ_J [D_J Li_2(x e^{−iθ_J}) + i j_J Li_1(x e^{−iθ_J})],   t_−k with e^{iθ_J} and −i
//! ```

use std::f64::consts::TAU;

use nalgebra::Complex;

use super::polylog::Polylogarithms;
use crate::nodes::Nodes;

type C64 = Complex<f64>;

/// A traction t `[stress]` of hats.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Hats {
    kinks: Vec<Kink>,
    polylogarithms: Polylogarithms,
    /// Elements: start and length `[rad]`, and the traction at both ends.
    parts: Vec<(f64, f64, [C64; 2])>,
    /// t_0.
    pub(super) mean: C64,
}

#[derive(Clone, Copy, Debug, PartialEq)]
struct Kink {
    /// e^{iθ}.
    direction: C64,
    /// D and j over 2π.
    slope: C64,
    jump: C64,
}

/// Σ k t_k x^k, Σ t_k x^k, Σ t_k x^k/k over k ≥ 1.
pub(crate) type Sums = [C64; 3];

impl Hats {
    /// The hats on `nodes` with the tractions `values` of its knots.
    pub(super) fn new(nodes: &Nodes, values: &[C64]) -> Self {
        let zero = C64::new(0.0, 0.0);
        let knots = nodes.knots();
        let mut slopes = vec![zero; knots.len()];
        // At each knot: whether an element starts and whether one ends there.
        let mut sides = vec![[false; 2]; knots.len()];
        let mut parts = Vec::with_capacity(knots.len());
        for element in nodes.elements() {
            let [a, b] = element.knots;
            let slope = (values[b] - values[a]) / element.length;
            slopes[a] += slope;
            slopes[b] -= slope;
            sides[a][0] = true;
            sides[b][1] = true;
            parts.push((element.start, element.length, [values[a], values[b]]));
        }
        let kinks = knots.iter().enumerate().map(|(k, knot)| {
            let jump = match sides[k] {
                [true, false] => values[k],
                [false, true] => -values[k],
                _ => zero,
            };
            Kink {
                direction: C64::from_polar(1.0, knot.angle),
                slope: slopes[k] / TAU,
                jump: jump / TAU,
            }
        });
        let both = knots.iter().zip(values);
        Self {
            kinks: kinks
                .filter(|kink| kink.slope != zero || kink.jump != zero)
                .collect(),
            polylogarithms: Polylogarithms::new(),
            parts,
            mean: both.map(|(knot, value)| value * knot.weight).sum::<C64>() / TAU,
        }
    }

    /// The traction at `angle` `[rad]`, 0 between hats.
    pub(crate) fn at(&self, angle: f64) -> C64 {
        let found = self.parts.iter().find_map(|&(start, length, [a, b])| {
            let along = (angle - start).rem_euclid(TAU) / length;
            (along <= 1.0 + 1e-12).then(|| a + (b - a) * along)
        });
        found.unwrap_or_default()
    }

    /// The sums over t_k for `x` with |x| ≤ 1.
    pub(crate) fn positive(&self, x: C64) -> Sums {
        self.sums(|kink| (x * kink.direction.conj(), kink.jump))
    }

    /// The sums over t_−k.
    pub(crate) fn negative(&self, x: C64) -> Sums {
        self.sums(|kink| (x * kink.direction, -kink.jump))
    }

    fn sums(&self, of: impl Fn(&Kink) -> (C64, C64)) -> Sums {
        let i = C64::new(0.0, 1.0);
        let mut sums = Sums::default();
        for kink in &self.kinks {
            let (x, jump) = of(kink);
            let [first, second, third] = self.polylogarithms.at(x);
            // On the edge itself only the lower sums are asked for; the first one is infinite at a kink.
            sums[0] -= kink.slope * first;
            sums[1] -= kink.slope * second;
            sums[2] -= kink.slope * third;
            if jump != C64::new(0.0, 0.0) {
                let [zeroth, first, second] = [x / (1.0 - x), first, second];
                sums[0] -= i * jump * zeroth;
                sums[1] -= i * jump * first;
                sums[2] -= i * jump * second;
            }
        }
        sums
    }

    /// t_K.
    pub(super) fn mode(&self, order: i64) -> C64 {
        if order == 0 {
            return self.mean;
        }
        let (k, i) = (order as f64, C64::new(0.0, 1.0));
        let term = |kink: &Kink| {
            let phase = kink.direction.powi(-(order as i32));
            (-kink.slope / (k * k) - i * kink.jump / k) * phase
        };
        self.kinks.iter().map(term).sum()
    }
}
