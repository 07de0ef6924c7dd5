//! Potentials of a plate around a hole.
//!
//! ```text
//! φ′ = [Σ_{k ≥ 1} t_−k ζ^−k + a]/ζ + φ_0′,   a = t_0/(1 + κ)
//! ψ′ = (φ_h′ − ζ φ_h″)/ζ² − conj[Σ_{k ≥ 1} t_k ζ̄^−k]/ζ − κ conj a/ζ + ψ_0′         φ_h′: the first part of φ′
//! ```
//!
//! φ_0′ and ψ_0′ are polynomials and terms of corners, whose own tractions on the hole are among the modes t_K.

use nalgebra::Complex;

use super::Local;
use super::hats::Hats;
use crate::arnoldi::Basis;
use crate::gauss::rule;
use crate::outline::{Surrounding, corner};

type C64 = Complex<f64>;

/// A plate's potentials beside its hats.
#[derive(Clone, Debug, Default)]
pub(crate) struct Outside {
    /// Modes t_K that keep the hole free of the tractions of φ_0′ and ψ_0′.
    pub(crate) modes: Vec<(i64, C64)>,
    /// φ_0′ and ψ_0′ of a stress far away.
    pub(crate) even: [C64; 2],
    /// Parts that an outer edge adds.
    pub(crate) outer: Vec<Outer>,
    /// The outer edge.
    pub(crate) outline: Option<Surrounding>,
}

/// What an outer edge adds: coefficients of φ_0′ and ψ_0′, and amounts of the terms of corners.
#[derive(Clone, Debug)]
pub(crate) struct Outer {
    pub(crate) basis: Basis,
    pub(crate) phi: Vec<C64>,
    pub(crate) psi: Vec<C64>,
    pub(crate) corners: Vec<(C64, f64)>,
}

impl Outside {
    pub(crate) fn contains(&self, zeta: C64) -> bool {
        self.outline
            .as_ref()
            .is_none_or(|outline| outline.contains(zeta))
    }

    pub(super) fn at(&self, hats: &Hats, zeta: C64, kappa: f64) -> Local {
        let inverse = zeta.inv();
        let [mut rising, mut negative, mut falling] = hats.negative(inverse);
        let [_, mut positive, mut positive_falling] = hats.positive(inverse.conj());
        for &(order, t) in &self.modes {
            let k = order.unsigned_abs() as f64;
            if order < 0 {
                let term = t * inverse.powi(-order as i32);
                rising += k * term;
                negative += term;
                falling += term / k;
            } else if order > 0 {
                let term = t * inverse.conj().powi(order as i32);
                positive += term;
                positive_falling += term / k;
            }
        }
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
}

impl Outer {
    fn add(&self, local: &mut Local, zeta: C64, kappa: f64) {
        let here = self.basis.at(&[zeta]);
        for n in 0..self.phi.len() {
            local.phi += self.phi[n] * here.values[n][0];
            local.slope += self.phi[n] * here.slopes[n][0];
            local.psi += self.psi[n] * here.values[n][0];
        }
        // Gauss's rule on the way from the centre is exact for these polynomials.
        let points = rule(self.phi.len() / 2 + 1);
        let places: Vec<C64> = points.iter().map(|[x, _]| zeta * *x).collect();
        let along = self.basis.at(&places);
        let [mut phi, mut psi] = [C64::new(0.0, 0.0); 2];
        for (k, [_, weight]) in points.iter().enumerate() {
            for n in 0..self.phi.len() {
                phi += self.phi[n] * along.values[n][k] * zeta * *weight;
                psi += self.psi[n] * along.values[n][k] * zeta * *weight;
            }
        }
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
