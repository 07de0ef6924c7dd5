//! The strengths that a criterion takes from a ply, and the error where one is missing.

use super::error::FailureError;
use crate::failure_mode::{FailureMode, largest};
use crate::ply::Ply;
use crate::strengths::Strength;

/// Gives the strength `strength` of `ply`, `[stress]` or a strain limit, to the criterion named `criterion`.
///
/// # Errors
/// [`FailureError::MissingStrength`] with both names where the ply lacks it.
pub fn needed_strength(
    criterion: &'static str,
    ply: &Ply,
    strength: Strength,
) -> Result<f64, FailureError> {
    ply.strengths()
        .get(strength)
        .ok_or_else(|| FailureError::MissingStrength {
            criterion,
            strength,
            ply: ply.name().to_owned(),
        })
}

/// The five in-plane strengths X_t, X_c, Y_t, Y_c, S₁₂.
pub(super) const IN_PLANE: [Strength; 5] = [
    Strength::Xt,
    Strength::Xc,
    Strength::Yt,
    Strength::Yc,
    Strength::S12,
];

pub(super) fn in_plane(criterion: &'static str, ply: &Ply) -> Result<InPlane, FailureError> {
    Ok(InPlane {
        xt: needed_strength(criterion, ply, Strength::Xt)?,
        xc: needed_strength(criterion, ply, Strength::Xc)?,
        yt: needed_strength(criterion, ply, Strength::Yt)?,
        yc: needed_strength(criterion, ply, Strength::Yc)?,
        s12: needed_strength(criterion, ply, Strength::S12)?,
    })
}

#[derive(Clone, Copy)]
pub(super) struct InPlane {
    pub(super) xt: f64,
    pub(super) xc: f64,
    pub(super) yt: f64,
    pub(super) yc: f64,
    pub(super) s12: f64,
}

impl InPlane {
    /// The mode of the stress that is nearest to its strength: interactive criteria do not distinguish modes themselves.
    pub(super) fn dominant(&self, [s1, s2, t]: &[f64; 3]) -> FailureMode {
        largest(&[
            (s1 / self.xt, FailureMode::FibreTension),
            (-s1 / self.xc, FailureMode::FibreCompression),
            (s2 / self.yt, FailureMode::MatrixTension),
            (-s2 / self.yc, FailureMode::MatrixCompression),
            (t.abs() / self.s12, FailureMode::Shear),
        ])
    }
}
