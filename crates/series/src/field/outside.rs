//! Potentials of a plate around a hole.
//!
//! ```text
//! φ′ = [Σ_{k ≥ 1} t_−k ζ^−k + a]/ζ + φ_0′,   a = t_0/(1 + κ)
//! ψ′ = (φ_h′ − ζ φ_h″)/ζ² − conj[Σ_{k ≥ 1} t_k ζ̄^−k]/ζ − κ conj a/ζ + ψ_0′         φ_h′: the first part of φ′
//! ```
//!
//! φ_0′ and ψ_0′ are polynomials and terms of corners, whose own tractions on the hole are among the modes t_K.

use std::sync::{Arc, OnceLock};

use nalgebra::Complex;

use super::hats::{Hats, Sums};
use super::outer_planes::OuterPlanes;
use super::state::Local;
use crate::arnoldi::{Basis, sum};
use crate::outline::{Surrounding, corner};

type C64 = Complex<f64>;

/// A plate's potentials beside its hats.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outside {
    /// Modes t_K and t_−K, K ≥ 1, that keep the hole free of the tractions of φ_0′ and ψ_0′.
    pub(crate) modes: Vec<[C64; 2]>,
    /// φ_0′ and ψ_0′ of a stress far away.
    pub(crate) even: [C64; 2],
    /// Parts that an outer edge adds.
    pub(crate) outer: Vec<Outer>,
    /// The same in an anisotropic plate.
    pub(crate) outer_planes: Vec<OuterPlanes>,
    /// The outer edge.
    pub(crate) outline: Option<Surrounding>,
}

/// What an outer edge adds: coefficients of φ_0′ and ψ_0′, and amounts of the terms of corners.
#[derive(Clone, Debug)]
pub(crate) struct Outer {
    basis: Arc<Basis>,
    phi: Vec<C64>,
    psi: Vec<C64>,
    corners: Vec<(C64, f64)>,
    /// Coefficients of φ_0″, φ_0 and ψ_0.
    further: OnceLock<[Vec<C64>; 3]>,
}

impl Outside {
    pub(crate) fn contains(&self, zeta: C64) -> bool {
        self.outline
            .as_ref()
            .is_none_or(|outline| outline.contains(zeta))
    }

    /// Adds `t` to t_K, K = `order`; t_0 belongs to the hats.
    pub(crate) fn add_mode(&mut self, order: i64, t: C64) {
        let Some(index) = order.unsigned_abs().checked_sub(1) else {
            return;
        };
        let index = index as usize;
        if self.modes.len() <= index {
            self.modes.resize(index + 1, [C64::new(0.0, 0.0); 2]);
        }
        self.modes[index][usize::from(order < 0)] += t;
    }

    /// σ_rr + σ_θθ on the circle.
    pub(super) fn sum_on_edge(&self, hats: &Hats, theta: f64, kappa: f64) -> f64 {
        let direction = C64::from_polar(1.0, theta);
        let inverse = direction.conj();
        let [_, negative] = hats.on_edge(theta, inverse);
        let mut phi = negative + self.even[0] + inverse * hats.mean / (1.0 + kappa);
        let mut power = inverse;
        for [_, t] in &self.modes {
            power *= inverse;
            phi += t * power;
        }
        let outer = self.outer.iter().map(|outer| outer.phi(direction));
        4.0 * (phi + outer.sum::<C64>()).re
    }

    pub(super) fn at(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let inverse = zeta.inv();
        let [positive, negative] = self.sums(hats, inverse.conj());
        let [_, positive, positive_falling] = positive;
        let [rising, negative, falling] = negative;
        let a = hats.mean / (1.0 + kappa);
        let square = inverse * inverse;
        let phi = inverse * (negative + a);
        let slope = -square * (negative + a + rising);
        let psi = square * (phi - zeta * slope) - inverse * (positive.conj() + kappa * a.conj());
        // conj ψ without the logarithm, which stands with that of κφ.
        let conjugate = -phi.conj() * inverse.conj() + positive_falling;
        let mut local = Local {
            phi,
            slope,
            psi,
            motion: -kappa * falling + 2.0 * kappa * a * zeta.norm().ln() - conjugate,
            spread: (0.0, C64::new(0.0, 0.0)),
        };
        let [even_phi, even_psi] = self.even;
        local.phi += even_phi;
        local.psi += even_psi;
        local.motion += kappa * even_phi * zeta - (even_psi * zeta).conj();
        for outer in &self.outer {
            outer.add(&mut local, zeta, kappa);
        }
        local
    }

    /// The sums over all t_k for `x` and over t_−k for its conjugate.
    pub(super) fn sums(&self, hats: &Hats, x: C64) -> [Sums; 2] {
        let enough = hats.enough(x);
        let mut sums = match enough {
            Some(count) => by_modes(hats.modes(count), x),
            None => hats.sums(x),
        };
        let own = self.modes.iter().copied();
        let own = by_modes(own.take(enough.unwrap_or(self.modes.len())), x);
        for (sums, own) in sums.iter_mut().zip(own) {
            sums.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
        sums
    }
}

/// The sums over pairs t_k, t_−k from k = 1 on.
fn by_modes(pairs: impl Iterator<Item = [C64; 2]>, x: C64) -> [Sums; 2] {
    let [mut positive, mut negative] = [Sums::default(); 2];
    let (mut power, mut k) = (x, 1.0);
    for [above, below] in pairs {
        let inverse = 1.0 / k;
        for (sums, term) in [
            (&mut positive, above * power),
            (&mut negative, below * power.conj()),
        ] {
            sums[0] += term * k;
            sums[1] += term;
            sums[2] += term * inverse;
        }
        power *= x;
        k += 1.0;
    }
    [positive, negative]
}

impl Outer {
    /// The polynomials Σ `phi[n]` q_n and Σ `psi[n]` q_n, of degrees below that of the basis, and the terms of `corners` times their amounts.
    pub(crate) fn new(
        basis: Arc<Basis>,
        phi: Vec<C64>,
        psi: Vec<C64>,
        corners: Vec<(C64, f64)>,
    ) -> Self {
        Self {
            basis,
            phi,
            psi,
            corners,
            further: OnceLock::new(),
        }
    }

    /// φ_0′.
    fn phi(&self, zeta: C64) -> C64 {
        let corners = self.corners.iter();
        let of_corners: C64 = corners
            .map(|&(place, amount)| amount * corner(place, zeta)[0])
            .sum();
        of_corners + sum(&self.phi, &self.basis.values(zeta))
    }

    fn add(&self, local: &mut Local, zeta: C64, kappa: f64) {
        let values = self.basis.values(zeta);
        let [slope, phi, psi] = self.further.get_or_init(|| {
            [
                self.basis.derivative(&self.phi),
                self.basis.antiderivative(&self.phi),
                self.basis.antiderivative(&self.psi),
            ]
        });
        local.phi += sum(&self.phi, &values);
        local.slope += sum(slope, &values);
        local.psi += sum(&self.psi, &values);
        let [mut phi, mut psi] = [phi, psi].map(|own| sum(own, &values));
        let i = C64::new(0.0, 1.0);
        for &(place, amount) in &self.corners {
            let [own, slope, other] = corner(place, zeta);
            local.phi += amount * own;
            local.slope += amount * slope;
            local.psi += amount * other;
            // ∫ ln(1 − ζ/c) = −(c − ζ) ln(1 − ζ/c) − ζ.
            phi += amount * (-(place - zeta) * own - i * zeta);
            psi -= amount * place.conj() * own;
        }
        local.motion += kappa * phi - psi.conj();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gauss::rule;

    /// Points around an ellipse, or around its upper half, and polynomials on them.
    fn basis(length: f64, symmetric: bool) -> (Basis, Vec<C64>) {
        let points: Vec<C64> = (0..400)
            .map(|k| C64::from_polar(1.0, 0.0157 * f64::from(k)))
            .filter(|z| !symmetric || z.im > 0.0)
            .map(|z| C64::new(length * z.re + 0.7 * length - 2.0, 4.0 * z.im))
            .collect();
        (Basis::new(&points, 61, symmetric).0, points)
    }

    #[test]
    fn antiderivatives_are_those_of_gausss_rule() {
        for (length, symmetric) in [(4.0, false), (4.0, true), (14.0, true), (14.0, false)] {
            let (basis, points) = basis(length, symmetric);
            let degree = basis.degree();
            let coefficients = |shift: usize| {
                let own = |n| C64::new(((n * n + shift) % 7) as f64 - 3.0, 1.0);
                let mut found: Vec<C64> = (0..degree).map(own).collect();
                found.push(C64::new(0.0, 0.0));
                found
            };
            let [phi, psi] = [0, 3].map(coefficients);
            let outer = Outer::new(Arc::new(basis), phi.clone(), psi.clone(), Vec::new());
            for zeta in [C64::new(1.0, 0.2), C64::new(-1.5, 0.5), points[40] * 0.9] {
                let mut local = Local::default();
                outer.add(&mut local, zeta, 2.0);
                let (mut expected, mut size) = (C64::new(0.0, 0.0), 0.0);
                for [x, weight] in rule(degree / 2 + 1) {
                    let values = outer.basis.values(zeta * x);
                    let [phi, psi] = [&phi, &psi].map(|own| sum(own, &values) * zeta * weight);
                    expected += 2.0 * phi - psi.conj();
                    size += phi.norm() + psi.norm();
                }
                let error = (local.motion - expected).norm() / size;
                assert!(error < 1e-11, "{length} {symmetric} {zeta} {error:e}");
            }
        }
    }

    #[test]
    fn slopes_are_those_of_the_recurrence() {
        for (length, symmetric) in [(4.0, false), (14.0, true)] {
            let (basis, points) = basis(length, symmetric);
            let phi: Vec<C64> = (0..=basis.degree())
                .map(|n| C64::new((n * n % 7) as f64 - 3.0, 1.0))
                .collect();
            let zeta = points[40];
            let values = basis.at(&[zeta]);
            let expected: C64 = (phi.iter().zip(&values.slopes))
                .map(|(a, q)| a * q[0])
                .sum();
            let found = sum(&basis.derivative(&phi), &basis.values(zeta));
            assert!((found - expected).norm() < 1e-11 * expected.norm());
        }
    }
}
