//! Why a failure question has no answer.

use thiserror::Error;

use crate::laminate::LaminateError;
use crate::strengths::Strength;

/// A failure question that cannot be answered.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FailureError {
    /// A strength that the criterion needs and the ply lacks.
    #[error(
        "criterion '{criterion}' needs {strength} ({}), which ply '{ply}' does not give",
        .strength.meaning()
    )]
    MissingStrength {
        /// Name of the criterion.
        criterion: &'static str,
        /// The strength.
        strength: Strength,
        /// Name of the ply.
        ply: String,
    },
    /// A ply without any strength.
    #[error("cannot evaluate criterion '{criterion}': ply '{ply}' has no strengths at all")]
    NoStrengths {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the ply.
        ply: String,
    },
    /// A name that no criterion has.
    #[error("there is no failure criterion '{name}'; there are: {}", .known.join(", "))]
    UnknownCriterion {
        /// The name given.
        name: String,
        /// Names of the criteria.
        known: Vec<&'static str>,
    },
    /// A load or stress that is not finite.
    #[error("{quantity} = {values:?} is not finite")]
    NotFinite {
        /// What it is.
        quantity: &'static str,
        /// Its components, in the unit of the quantity.
        values: Vec<f64>,
    },
    /// A quadratic criterion whose interaction leaves its surface open.
    #[error(
        "criterion '{criterion}', ply '{ply}': the interaction F12 = {interaction:e} must be less than sqrt(F11 F22) = {limit:e} in \
         magnitude, or loads exist under which the ply never fails; change {}",
        if *.criterion == "tsai_wu" { "F12, usually -0.5 times that" } else { "the strengths that F12 comes from" }
    )]
    OpenSurface {
        /// Name of the criterion.
        criterion: &'static str,
        /// Name of the ply.
        ply: String,
        /// F₁₂, half the coefficient of σ₁σ₂ `[1/stress²]`.
        interaction: f64,
        /// √(F₁₁ F₂₂) `[1/stress²]`.
        limit: f64,
    },
    /// Hashin's weight of shear in fibre tension outside [0, 1].
    #[error("hashin: the weight of shear in fibre tension = {weight} must be in [0, 1]")]
    ShearWeight {
        /// The value given, dimensionless.
        weight: f64,
    },
    /// An envelope with too few or too many directions.
    #[error("a failure envelope needs 3 to 1000000 directions, not {directions}")]
    Directions {
        /// The number given.
        directions: usize,
    },
    /// A direction of load along which nothing fails.
    #[error(
        "no multiple of the load (Nx, Ny, Nxy) = {force:?} fails the laminate: the envelope is open"
    )]
    OpenEnvelope {
        /// The load's direction (N_x, N_y, N_xy) `[force/length]`.
        force: [f64; 3],
    },
    /// The laminate with its damaged plies is no laminate.
    #[error(transparent)]
    Laminate(#[from] LaminateError),
}

pub(super) fn finite(quantity: &'static str, values: &[f64]) -> Result<(), FailureError> {
    if values.iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(FailureError::NotFinite {
            quantity,
            values: values.to_vec(),
        })
    }
}
