//! Ply discount: what a failed ply still carries.
//!
//! ```text
//! S = [1/(f E₁) −ν₁₂/E₁ 0; −ν₁₂/E₁ 1/(m E₂) 0; 0 0 1/(m G₁₂)],   Q = S⁻¹
//!
//! sound            f = 1     m = 1
//! matrix failed    f = 1     m = d_m
//! fibres failed    f = d_f   m = min(d_m, d_f)
//! ```
//!
//! Damage acts on the diagonal of the compliance only (Matzenmiller, Lubliner & Taylor 1995), so S grows and Q falls in the sense
//! of quadratic forms: failing at a fixed strain never creates energy, whatever the strain. Factors are kept above zero, so that
//! the stiffness of a laminate whose plies have all failed can still be inverted.

use stickslip_fem_core::material::{PlaneStiffness, inverse};
use thiserror::Error;

use crate::failure_mode::FailureMode;
use crate::ply::Ply;

/// A degradation factor that does not degrade.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error(
    "degradation factor {name} = {value} must be at least {}, at most 1",
    Degradation::SMALLEST
)]
pub struct DegradationError {
    /// `fibre` or `matrix`.
    pub name: &'static str,
    /// The value given, dimensionless.
    pub value: f64,
}

/// Factors on the moduli of a failed ply, dimensionless, in [[`Degradation::SMALLEST`], 1].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Degradation {
    fibre: f64,
    matrix: f64,
}

/// Which parts of a ply have failed. Damage does not heal.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub struct Damage {
    /// The fibres have failed, and the matrix with them.
    pub fibre: bool,
    /// The matrix has failed.
    pub matrix: bool,
}

impl Damage {
    /// Adds the failure in `mode` to this damage: fibre modes take fibres and matrix, the others the matrix.
    #[must_use]
    pub fn with(self, mode: FailureMode) -> Self {
        Self {
            fibre: self.fibre || mode.is_fibre(),
            matrix: true,
        }
    }
}

impl Degradation {
    /// Smallest factor accepted, dimensionless.
    pub const SMALLEST: f64 = 1e-9;

    /// Checks the factors `fibre` on E₁ after fibre failure and `matrix` on E₂ and G₁₂ after matrix failure, both dimensionless.
    ///
    /// # Errors
    /// [`DegradationError`] unless both are in [[`Degradation::SMALLEST`], 1].
    pub fn new(fibre: f64, matrix: f64) -> Result<Self, DegradationError> {
        for (name, value) in [("fibre", fibre), ("matrix", matrix)] {
            if !(Self::SMALLEST..=1.0).contains(&value) {
                return Err(DegradationError { name, value });
            }
        }
        Ok(Self { fibre, matrix })
    }

    /// The factor on E₁ after fibre failure, dimensionless.
    pub fn fibre(&self) -> f64 {
        self.fibre
    }

    /// The factor on E₂ and G₁₂ after matrix failure, dimensionless.
    pub fn matrix(&self) -> f64 {
        self.matrix
    }

    /// Multiplies the factors by `part` in [0, 1], dimensionless, as far as [`SMALLEST`](Self::SMALLEST): what is left where failed plies keep next to
    /// nothing. A factor of 1 stays, because such a failure loses nothing.
    #[must_use]
    pub fn weakened(&self, part: f64) -> Self {
        let weaken = |factor: f64| {
            if factor < 1.0 {
                factor.min((part * factor).max(Self::SMALLEST))
            } else {
                factor
            }
        };
        Self {
            fibre: weaken(self.fibre),
            matrix: weaken(self.matrix),
        }
    }

    /// Computes the stiffness Q = S⁻¹ (3×3, `[stress]`) in material axes of `ply` with `damage`, after Matzenmiller, Lubliner & Taylor
    /// (1995).
    pub fn stiffness(&self, ply: &Ply, damage: Damage) -> PlaneStiffness {
        let (along, across) = match damage {
            Damage { fibre: true, .. } => (self.fibre, self.matrix.min(self.fibre)),
            Damage { matrix: true, .. } => (1.0, self.matrix),
            Damage { .. } => return *ply.stiffness(),
        };
        let mut compliance = *ply.compliance();
        compliance[0][0] /= along;
        compliance[1][1] /= across;
        compliance[2][2] /= across;
        inverse(&compliance)
    }
}
