//! Names of the ways a ply fails.

use std::fmt;

/// How a ply fails.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum FailureMode {
    /// Fibres break in tension.
    FibreTension,
    /// Fibres kink or break in compression.
    FibreCompression,
    /// The matrix or its bond cracks along the fibres, under tension across them.
    MatrixTension,
    /// The matrix fails under compression across the fibres.
    MatrixCompression,
    /// The matrix fails in shear in the plane of the ply.
    Shear,
    /// Plies part under tension along the normal. Only of a stress that is not plane.
    ThicknessTension,
    /// The matrix fails under compression along the normal. Only of a stress that is not plane.
    ThicknessCompression,
    /// The matrix fails in the shear τ₁₃ or τ₂₃. Only of a stress that is not plane.
    ThicknessShear,
}

impl FailureMode {
    /// Checks whether fibres fail; in all other modes the matrix does.
    pub fn is_fibre(self) -> bool {
        matches!(self, Self::FibreTension | Self::FibreCompression)
    }

    /// Names the mode, for a table.
    pub fn name(self) -> &'static str {
        match self {
            Self::FibreTension => "fibre tension",
            Self::FibreCompression => "fibre compression",
            Self::MatrixTension => "matrix tension",
            Self::MatrixCompression => "matrix compression",
            Self::Shear => "matrix shear",
            Self::ThicknessTension => "through-thickness tension",
            Self::ThicknessCompression => "through-thickness compression",
            Self::ThicknessShear => "through-thickness shear",
        }
    }
}

impl fmt::Display for FailureMode {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// The mode with the largest ratio of stress to strength, the first of equals.
pub(crate) fn largest(ratios: &[(f64, FailureMode)]) -> FailureMode {
    let mut best = (f64::NEG_INFINITY, FailureMode::FibreTension);
    for &(ratio, mode) in ratios {
        if ratio > best.0 {
            best = (ratio, mode);
        }
    }
    best.1
}
