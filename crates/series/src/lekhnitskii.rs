//! How the edge of a hole in an anisotropic plate gives.
//!
//! ```text
//! σ_xx = 2 Re Σ μ_k² Φ_k′(z_k),  σ_yy = 2 Re Σ Φ_k′,  σ_xy = −2 Re Σ μ_k Φ_k′,  u = 2 Re Σ (p_k, q_k) Φ_k,   z_k = x + μ_k y
//! a11 μ⁴ − 2 a16 μ³ + (2 a12 + a66) μ² − 2 a26 μ + a22 = 0,   Im μ_k > 0
//! p_k = a11 μ_k² + a12 − a16 μ_k,   q_k = a12 μ_k + a22/μ_k − a26
//! ```
//!
//! On the circle z_1 and z_2 have one parameter e^{iθ}, so that modes e^{−inθ} of u and of the resultants of tractions are related by one matrix,
//!
//! ```text
//! u_−n = −iMR q_−n/n,   M = [p; q] [μ; −1]⁻¹ = [a11 s − a16, a11 p − a12;  a12 − a22/p, a26 − a22 s/p],   s = μ_1 + μ_2,  p = μ_1 μ_2
//! u(θ) = (R/π) ∫ [Im M L(θ − φ) − Re M S(θ − φ)] q(φ) dφ
//! ```
//!
//! In terms of s and p nothing is divided by μ_1 − μ_2: the isotropic plate, s = 2i, p = −1, is no special case.
//!
//! Source: Lekhnitskii, *Anisotropic Plates* (1968), §§ 8, 31.

mod planes;

use nalgebra::{Complex, Matrix3, Vector3};
use stickslip_fem_core::material::PlaneStiffness;

use crate::circle::Surface;
pub(crate) use planes::Planes;

type C64 = Complex<f64>;

/// The matrix M of a plate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Lekhnitskii {
    matrix: [[C64; 2]; 2],
}

impl Lekhnitskii {
    /// M of the compliance `compliance` `[1/stress]`, Voigt order (xx, yy, xy); `None` if it is that of no stable material.
    pub(crate) fn new(compliance: &PlaneStiffness) -> Option<Self> {
        let [[a11, a12, a16], [_, a22, a26], _] = *compliance;
        let (s, p) = roots(compliance)?;
        let one = C64::new(1.0, 0.0);
        Some(Self {
            matrix: [
                [a11 * s - a16, a11 * p - a12],
                [a12 - a22 * one / p, a26 - a22 * s / p],
            ],
        })
    }

    /// M v.
    pub(crate) fn apply(&self, [x, y]: [C64; 2]) -> [C64; 2] {
        self.matrix.map(|[a, b]| a * x + b * y)
    }

    /// Im M.
    fn imaginary(&self) -> [[f64; 2]; 2] {
        self.matrix.map(|row| row.map(|entry| entry.im))
    }

    /// Im M and −Re M.
    pub(crate) fn surface(&self) -> Surface {
        let [[a, b], [c, d]] = self.matrix;
        let coupling = 0.5 * (b.im + c.im);
        Surface {
            // A symmetric and an antisymmetric matrix, by reciprocity.
            log: [[a.im, coupling], [coupling, d.im]],
            odd: 0.5 * (b.re - c.re),
        }
    }
}

/// Sum and product of the two roots μ with positive imaginary part: Newton's method on
/// (μ² − sμ + p)(μ² − s̄μ + p̄), from the roots without a16 and a26, which are then added in steps.
fn roots(compliance: &PlaneStiffness) -> Option<(C64, C64)> {
    const STEPS: usize = 16;
    const ITERATIONS: usize = 50;
    let [[a11, a12, a16], [_, a22, a26], [_, _, a66]] = *compliance;
    let (square, last) = ((2.0 * a12 + a66) / a11, a22 / a11);
    let product = last.sqrt();
    let sum = (square + 2.0 * product).sqrt();
    // s_i, p_r, p_i.
    let mut unknowns = Vector3::new(sum, -product, 0.0);
    let steps = if a16 == 0.0 && a26 == 0.0 { 1 } else { STEPS };
    for step in 1..=steps {
        let part = step as f64 / steps as f64;
        let (real, linear) = (part * a16 / a11, part * 2.0 * a26 / a11);
        for _ in 0..ITERATIONS {
            let [imaginary, pr, pi] = unknowns.into();
            let residual = Vector3::new(
                2.0 * pr + real * real + imaginary * imaginary - square,
                2.0 * (real * pr + imaginary * pi) - linear,
                pr * pr + pi * pi - last,
            );
            #[rustfmt::skip]
            let slope = Matrix3::new(
                2.0 * imaginary, 2.0, 0.0,
                2.0 * pi, 2.0 * real, 2.0 * imaginary,
                0.0, 2.0 * pr, 2.0 * pi,
            );
            let change = slope.lu().solve(&residual)?;
            unknowns -= change;
            if change.norm() <= 1e-15 * unknowns.norm() {
                break;
            }
        }
    }
    let [imaginary, pr, pi] = unknowns.into();
    let found = (C64::new(a16 / a11, imaginary), C64::new(pr, pi));
    let root = (found.0 * found.0 - 4.0 * found.1).sqrt();
    let both = [found.0 + root, found.0 - root];
    both.iter()
        .all(|mu| mu.im > 0.0 && mu.norm().is_finite())
        .then_some(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_fem_core::material::{
        Isotropic, Material, Orthotropic, OrthotropicConstants, PlaneState,
    };

    #[test]
    fn the_isotropic_plate_is_no_special_case() {
        let material = Isotropic::new(2.0, 0.3, PlaneState::Stress).unwrap();
        let surface = Lekhnitskii::new(&material.compliance()).unwrap().surface();
        // (1 + κ)/4G = 2/E and (1 − κ)/4G = −(1 − ν)/E in plane stress.
        let expected = [[1.0, 0.0], [0.0, 1.0]];
        for (row, expected) in surface.log.iter().zip(expected) {
            for (found, expected) in row.iter().zip(expected) {
                assert!((found - expected).abs() < 1e-15);
            }
        }
        assert!((surface.odd + 0.35).abs() < 1e-15);
    }

    #[test]
    fn a_turned_material_has_the_turned_matrix() {
        let constants = OrthotropicConstants {
            e1: 140.0,
            e2: 9.0,
            g12: 5.0,
            nu12: 0.3,
        };
        let own = Orthotropic::new(constants, 0.0).unwrap();
        let own = Lekhnitskii::new(&own.compliance()).unwrap().surface();
        for angle in [0.2, 0.8, 1.3, -0.9] {
            let turned = Orthotropic::new(constants, angle).unwrap();
            let found = Lekhnitskii::new(&turned.compliance()).unwrap().surface();
            let (sin, cos) = f64::sin_cos(angle);
            let [[a, b], [_, d]] = own.log;
            let expected = [
                a * cos * cos - 2.0 * b * sin * cos + d * sin * sin,
                (a - d) * sin * cos + b * (cos * cos - sin * sin),
                a * sin * sin + 2.0 * b * sin * cos + d * cos * cos,
            ];
            let [[a, b], [_, d]] = found.log;
            for (found, expected) in [a, b, d].iter().zip(expected) {
                assert!((found - expected).abs() < 1e-13, "{angle}");
            }
            assert!((found.odd - own.odd).abs() < 1e-13);
        }
    }
}
