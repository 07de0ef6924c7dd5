//! Hashin in plane stress: one polynomial per mode.
//!
//! ```text
//! fibre tension        σ₁ ≥ 0    (σ₁/X_t)² + α (τ₁₂/S₁₂)²
//! fibre compression    σ₁ < 0    (σ₁/X_c)²
//! matrix tension       σ₂ ≥ 0    (σ₂/Y_t)² + (τ₁₂/S₁₂)²
//! matrix compression   σ₂ < 0    (σ₂/2S₂₃)² + [(Y_c/2S₂₃)² − 1] σ₂/Y_c + (τ₁₂/S₁₂)²
//! ```
//!
//! α = 1 is Hashin's; α = 0 leaves shear out of fibre tension, as some codes do. The index is the largest of the polynomials. Both
//! tensile polynomials with σ = 0 are pure shear; the mode is then the matrix's, which is where shear failure of a ply is.
//!
//! Source: Hashin, J. Appl. Mech. 47 (1980) 329.

use super::criterion::{Assessment, FailureCriterion, PlyLoading};
use super::error::FailureError;
use super::needed::{InPlane, in_plane, needed_strength};
use super::ray::{Branch, Branches, Surface};
use super::registry::CriterionInfo;
use crate::failure_mode::FailureMode;
use crate::ply::Ply;
use crate::strengths::Strength;

/// Hashin's criterion in plane stress, one quadratic polynomial per mode (Hashin 1980).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Hashin {
    shear_weight: f64,
}

impl Default for Hashin {
    /// With α = 1, as published.
    fn default() -> Self {
        Self { shear_weight: 1.0 }
    }
}

impl Hashin {
    /// Makes the criterion with the weight α in [0, 1] of shear in fibre tension, dimensionless.
    ///
    /// # Errors
    /// [`FailureError::ShearWeight`] outside of it.
    pub fn with_shear_weight(weight: f64) -> Result<Self, FailureError> {
        if (0.0..=1.0).contains(&weight) {
            Ok(Self {
                shear_weight: weight,
            })
        } else {
            Err(FailureError::ShearWeight { weight })
        }
    }
}

impl FailureCriterion for Hashin {
    fn name(&self) -> &'static str {
        "hashin"
    }

    fn title(&self) -> String {
        "Hashin".to_owned()
    }

    fn required(&self) -> &'static [Strength] {
        &[
            Strength::Xt,
            Strength::Xc,
            Strength::Yt,
            Strength::Yc,
            Strength::S12,
            Strength::S23,
        ]
    }

    fn assess(&self, ply: &Ply, loading: &PlyLoading) -> Result<Assessment, FailureError> {
        let strengths = in_plane(self.name(), ply)?;
        let s23 = needed_strength(self.name(), ply, Strength::S23)?;
        let surface = Surface {
            criterion: self.name(),
            branches: |[along, across, _]: [bool; 3]| {
                self.branches(&strengths, s23, [along, across])
            },
            dominant: |stress: &[f64; 3]| strengths.dominant(stress),
        };
        surface.assess(&loading.held, &loading.applied)
    }
}

impl Hashin {
    fn branches(self, strengths: &InPlane, s23: f64, [along, across]: [bool; 2]) -> Branches<3> {
        let InPlane {
            xt,
            xc,
            yt,
            yc,
            s12,
        } = *strengths;
        let shear = 1.0 / (s12 * s12);
        let diagonal = |mode, [q1, q2, q6]: [f64; 3]| Branch {
            mode: Some(mode),
            linear: [0.0; 3],
            quadratic: [[q1, 0.0, 0.0], [0.0, q2, 0.0], [0.0, 0.0, q6]],
        };
        let fibre = if along {
            diagonal(
                FailureMode::FibreTension,
                [1.0 / (xt * xt), 0.0, self.shear_weight * shear],
            )
        } else {
            diagonal(FailureMode::FibreCompression, [1.0 / (xc * xc), 0.0, 0.0])
        };
        let matrix = if across {
            diagonal(FailureMode::MatrixTension, [0.0, 1.0 / (yt * yt), shear])
        } else {
            let transverse = 1.0 / (4.0 * s23 * s23);
            Branch {
                linear: [0.0, (yc * yc * transverse - 1.0) / yc, 0.0],
                ..diagonal(FailureMode::MatrixCompression, [0.0, transverse, shear])
            }
        };
        // The matrix first: in pure shear both are equal.
        [Some(matrix), Some(fibre), None]
    }
}

inventory::submit! {
    CriterionInfo {
        name: "hashin",
        summary: "fibre and matrix apart, shear by hashin_shear_weight; Hashin (1980)",
        make: || Box::new(Hashin::default()),
    }
}
