//! Tsai–Hill in three dimensions, as Post & Reddy (1988), part II, 4.4, use it.
//!
//! ```text
//! (σ₁/X)² + (σ₂/Y)² + (σ₃/Z)² − (1/X² + 1/Y² − 1/Z²) σ₁σ₂ − (1/Y² + 1/Z² − 1/X²) σ₂σ₃ − (1/Z² + 1/X² − 1/Y²) σ₁σ₃
//!     + (τ₂₃/R)² + (τ₁₃/S)² + (τ₁₂/T)²,     X, Y, Z by the signs of σ₁, σ₂, σ₃;  R = S₂₃, S = S₁₃, T = S₁₂
//! ```
//!
//! In plane stress Z still acts, through the coefficient of σ₁σ₂:
//!
//! ```text
//! (σ₁/X)² + (σ₂/Y)² − (1/X² + 1/Y² − 1/Z²) σ₁σ₂ + (τ₁₂/T)²,     Z_t or Z_c by the sign of σ₂
//! ```
//!
//! The report leaves open which Z belongs to σ₃ = 0. By the sign of σ₂, a ply that is alike in 2 and 3 (Z = Y) has the plane form in
//! every quadrant, and the surface is closed. It is closed for other strengths as long as |1/X − 1/Y| < 1/Z < 1/X + 1/Y, and
//! refused otherwise. With σ₃ the condition fails wherever σ₂ and σ₃ differ in sign and Y and Z in size, as they do for usual plies:
//! there the form has no bound along some rays, the reserve factor is infinite, and no error says so, because the report's form is
//! what is asked for. Its coefficients jump where a stress changes sign, and so does its index unless the other two vanish.

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::FailureError;
use super::needed::{in_plane, needed_strength};
use super::quadratic::{self, Polynomial};
use super::ray::{Branch, Surface};
use super::registry::CriterionInfo;
use crate::failure_mode::{FailureMode, largest};
use crate::ply::Ply;
use crate::strengths::Strength;

/// Tsai–Hill in three dimensions (Post & Reddy 1988, part II, 4.4). As a [`FailureCriterion`] it sees plane stress and asks for Z_t and Z_c, not for S₁₃ and S₂₃.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TsaiHillSolid;

const PLANE: [Strength; 7] = [
    Strength::Xt,
    Strength::Xc,
    Strength::Yt,
    Strength::Yc,
    Strength::S12,
    Strength::Zt,
    Strength::Zc,
];

impl FailureCriterion for TsaiHillSolid {
    fn name(&self) -> &'static str {
        "tsai_hill_3d"
    }

    fn title(&self) -> String {
        "Tsai–Hill (3-D)".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &PLANE
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let zt = needed_strength(self.name(), ply, Strength::Zt)?;
        let zc = needed_strength(self.name(), ply, Strength::Zc)?;
        let polynomial = |[along, across]: [bool; 2]| {
            let x = if along { strengths.xt } else { strengths.xc };
            let [y, z] = if across {
                [strengths.yt, zt]
            } else {
                [strengths.yc, zc]
            };
            let [x, y, z] = [x, y, z].map(|strength| 1.0 / (strength * strength));
            Polynomial {
                linear: [0.0; 2],
                direct: [x, y],
                interaction: -0.5 * (x + y - z),
            }
        };
        quadratic::assess(self.name(), ply, strengths, loading, polynomial)
    }
}

impl TsaiHillSolid {
    /// Computes index, reserve factor and mode of `ply` under a stress (σ₁, σ₂, σ₃, τ₂₃, τ₁₃, τ₁₂) `[stress]` in material axes, of which
    /// `held` stays and `applied` grows with the load.
    ///
    /// # Errors
    /// [`FailureError::MissingStrength`] unless the ply has all nine strengths, [`FailureError::NotFinite`] if a stress is not finite.
    pub fn assess_solid(
        &self,
        ply: &Ply,
        held: &[f64; 6],
        applied: &[f64; 6],
    ) -> Result<Assessment, FailureError> {
        let strength = |name| needed_strength(self.name(), ply, name);
        let strengths = Strengths3 {
            tension: [
                strength(Strength::Xt)?,
                strength(Strength::Yt)?,
                strength(Strength::Zt)?,
            ],
            compression: [
                strength(Strength::Xc)?,
                strength(Strength::Yc)?,
                strength(Strength::Zc)?,
            ],
            shear: [
                strength(Strength::S23)?,
                strength(Strength::S13)?,
                strength(Strength::S12)?,
            ],
        };
        strengths.assess(self.name(), held, applied)
    }
}

struct Strengths3 {
    tension: [f64; 3],
    compression: [f64; 3],
    /// Of τ₂₃, τ₁₃, τ₁₂.
    shear: [f64; 3],
}

impl Strengths3 {
    fn assess(
        &self,
        criterion: &'static str,
        held: &[f64; 6],
        applied: &[f64; 6],
    ) -> Result<Assessment, FailureError> {
        let surface = Surface {
            criterion,
            branches: |signs| [Some(self.branch(signs)), None, None],
            dominant: |stress: &[f64; 6]| self.dominant(stress),
        };
        surface.assess(held, applied)
    }

    fn branch(&self, signs: [bool; 6]) -> Branch<6> {
        let [x, y, z] = [0, 1, 2].map(|i| {
            let strength = if signs[i] {
                self.tension[i]
            } else {
                self.compression[i]
            };
            1.0 / (strength * strength)
        });
        let mut quadratic = [[0.0; 6]; 6];
        let direct = [x, y, z];
        let interaction = [(0, 1, x + y - z), (1, 2, y + z - x), (0, 2, z + x - y)];
        for i in 0..3 {
            quadratic[i][i] = direct[i];
            quadratic[3 + i][3 + i] = 1.0 / (self.shear[i] * self.shear[i]);
        }
        for (i, j, coefficient) in interaction {
            quadratic[i][j] = -0.5 * coefficient;
            quadratic[j][i] = -0.5 * coefficient;
        }
        Branch {
            mode: None,
            linear: [0.0; 6],
            quadratic,
        }
    }

    fn dominant(&self, stress: &[f64; 6]) -> FailureMode {
        largest(&[
            (stress[0] / self.tension[0], FailureMode::FibreTension),
            (
                -stress[0] / self.compression[0],
                FailureMode::FibreCompression,
            ),
            (stress[1] / self.tension[1], FailureMode::MatrixTension),
            (
                -stress[1] / self.compression[1],
                FailureMode::MatrixCompression,
            ),
            (stress[5].abs() / self.shear[2], FailureMode::Shear),
            (stress[2] / self.tension[2], FailureMode::ThicknessTension),
            (
                -stress[2] / self.compression[2],
                FailureMode::ThicknessCompression,
            ),
            (stress[3].abs() / self.shear[0], FailureMode::ThicknessShear),
            (stress[4].abs() / self.shear[1], FailureMode::ThicknessShear),
        ])
    }
}

inventory::submit! {
    CriterionInfo {
        name: "tsai_hill_3d",
        summary: "one quadratic form in three dimensions; Post & Reddy (1988), part II, 4.4",
        make: || Box::new(TsaiHillSolid),
    }
}
