//! Infinite plate with a hole of radius a under uniaxial tension S along x (Kirsch, 1898), plane stress. With
//! κ = (3 − ν)/(1 + ν) and ρ = a/r
//!
//! ```text
//! u_r = S/8G { r [κ − 1 + 2 cos 2θ] + 2 a ρ [1 + (κ + 1 − ρ²) cos 2θ] }
//! u_θ = −S/8G { 2 r + 2 a ρ [κ − 1 + ρ²] } sin 2θ
//! σ_rr = ½S { 1 − ρ² + (1 − 4ρ² + 3ρ⁴) cos 2θ }
//! σ_θθ = ½S { 1 + ρ² − (1 + 3ρ⁴) cos 2θ }
//! τ_rθ = −½S (1 + 2ρ² − 3ρ⁴) sin 2θ
//! ```
//!
//! Source: Timoshenko and Goodier, *Theory of Elasticity* (1970), section 35; Muskhelishvili (1954) for displacements.

use std::f64::consts::FRAC_PI_2;

use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_fem_core::stress::cartesian;

use crate::meshes::mapped;
use crate::solve::solved;

/// Remote stress, hole radius, elastic constants.
pub(crate) const TENSION: f64 = 100.0;
pub(crate) const RADIUS: f64 = 0.5;
const YOUNG: f64 = 70e3;
const POISSON: f64 = 0.33;

pub(crate) fn material() -> Isotropic {
    Isotropic::new(YOUNG, POISSON, PlaneState::Stress).unwrap()
}

pub(crate) fn displacement([x, y]: Point) -> [f64; 2] {
    let (r, theta) = (x.hypot(y), y.atan2(x));
    let kappa = (3.0 - POISSON) / (1.0 + POISSON);
    let rho = RADIUS / r;
    let scale = TENSION / (8.0 * material().shear());
    let (sin2, cos2) = (2.0 * theta).sin_cos();
    let far = r * (kappa - 1.0 + 2.0 * cos2);
    let near = 2.0 * RADIUS * rho * (1.0 + (kappa + 1.0 - rho * rho) * cos2);
    let radial = scale * (far + near);
    let around = -scale * (2.0 * r + 2.0 * RADIUS * rho * (kappa - 1.0 + rho * rho)) * sin2;
    let (s, c) = theta.sin_cos();
    [radial * c - around * s, radial * s + around * c]
}

pub(crate) fn stress([x, y]: Point) -> [f64; 3] {
    let (theta, q) = (y.atan2(x), RADIUS * RADIUS / (x * x + y * y));
    let (sin2, cos2) = (2.0 * theta).sin_cos();
    let half = 0.5 * TENSION;
    let rr = half * (1.0 - q + (1.0 - 4.0 * q + 3.0 * q * q) * cos2);
    let tt = half * (1.0 + q - (1.0 + 3.0 * q * q) * cos2);
    let rt = -half * (1.0 + 2.0 * q - 3.0 * q * q) * sin2;
    cartesian([rr, tt, rt], theta)
}

/// Quarter of the plate between r = a and r = 4a with `cells`² cells (twice as many triangles), and its finite-element
/// solution: free on the hole, symmetric on the axes, the exact displacement on the outer arc.
pub(crate) fn solved_quarter(kind: ElementKind, cells: usize) -> (Mesh, Vec<f64>) {
    let mesh = mapped(kind, [cells, cells], |[x, y]| {
        let (s, c) = (FRAC_PI_2 * y).sin_cos();
        [c, s].map(|v| RADIUS * 4.0_f64.powf(x) * v)
    });
    let prescribed = |p: Point| {
        if p[0].hypot(p[1]) > 3.999 * RADIUS {
            return displacement(p).map(Some);
        }
        p.map(|v| (v.abs() < 1e-9 * RADIUS).then_some(0.0))
    };
    let u = solved(&mesh, &material().stiffness(), prescribed);
    (mesh, u)
}
