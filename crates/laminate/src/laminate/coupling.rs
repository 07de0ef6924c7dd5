//! How much a laminate couples what a homogeneous plate keeps apart.
//!
//! ```text
//! ρ² = largest eigenvalue of A⁻¹ B D⁻¹ B,     0 ≤ ρ < 1
//! ```
//!
//! ρ is the largest correlation of stretching with bending. A laminate that is free to bend is softer than A by at most the
//! fraction ρ²: A − B D⁻¹ B ≥ (1 − ρ²) A.

use nalgebra::{Cholesky, Matrix3};
use stickslip_fem_core::material::PlaneStiffness;

use super::Laminate;

/// Coupling below which a laminate counts as symmetric: rounding over many plies, far below any effect.
const SYMMETRIC: f64 = 1e-10;

/// Sizes of the couplings of a laminate, each dimensionless, 0 where there is none.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Coupling {
    /// ρ of stretching with bending, the same in all axes; 0 for a symmetric lay-up, always less than 1.
    pub bending_extension: f64,
    /// Of stretching with in-plane shear: the larger of |A₁₆|/√(A₁₁A₆₆) and |A₂₆|/√(A₂₂A₆₆); 0 for a balanced lay-up.
    pub extension_shear: f64,
    /// Of bending with twisting: the larger of |D₁₆|/√(D₁₁D₆₆) and |D₂₆|/√(D₂₂D₆₆).
    pub bending_twisting: f64,
}

impl Coupling {
    /// Checks whether a membrane analysis is exact: no coupling of stretching with bending beyond rounding (10⁻¹⁰).
    pub fn is_symmetric(&self) -> bool {
        self.bending_extension <= SYMMETRIC
    }

    /// Computes ρ²: how much softer in its plane the laminate can be when it is free to bend than when it is held flat, as a fraction, dimensionless.
    pub fn stiffness_loss(&self) -> f64 {
        self.bending_extension * self.bending_extension
    }
}

impl Laminate {
    /// Computes the sizes of the laminate's couplings, of which ρ² is the largest eigenvalue of A⁻¹ B D⁻¹ B.
    pub fn coupling(&self) -> Coupling {
        let matrix = &self.stiffness;
        Coupling {
            bending_extension: self.bending_extension(),
            extension_shear: shear_coupling(&matrix.membrane),
            bending_twisting: shear_coupling(&matrix.bending),
        }
    }

    fn bending_extension(&self) -> f64 {
        let square = |m: &PlaneStiffness| Matrix3::from_fn(|i, j| m[i][j]);
        let matrix = &self.stiffness;
        let factors = (
            Cholesky::new(square(&matrix.membrane)),
            Cholesky::new(square(&matrix.bending)),
        );
        let (Some(membrane), Some(bending)) = factors else {
            // A laminate's A and D are positive definite; were they not in floating point, no membrane could be trusted.
            return 1.0;
        };
        let solved = membrane
            .l()
            .solve_lower_triangular(&square(&matrix.coupling));
        let whitened =
            solved.and_then(|left| bending.l().solve_lower_triangular(&left.transpose()));
        whitened.map_or(1.0, |whitened| whitened.singular_values().max())
    }
}

fn shear_coupling(m: &PlaneStiffness) -> f64 {
    let relative = |i: usize| m[i][2].abs() / (m[i][i] * m[2][2]).sqrt();
    relative(0).max(relative(1))
}
