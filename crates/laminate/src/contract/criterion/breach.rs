//! What a failure criterion did wrong.

use thiserror::Error;

use crate::failure::{Assessment, FailureError, PlyLoading};
use crate::strengths::Strength;

/// A failure criterion that does not keep the contract.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("failure criterion '{criterion}' breaks the contract: {breach}")]
pub struct CriterionViolation {
    /// Name of the criterion.
    pub criterion: &'static str,
    /// The property that it breaks, and the numbers.
    pub breach: Box<CriterionBreach>,
}

/// The property that is broken. Numbers are in the units of the sample's ply.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CriterionBreach {
    /// The sample tests nothing, which is no fault of the criterion.
    #[error("it cannot be tested, because the sample holds no {missing}")]
    UselessSample {
        /// What the sample lacks.
        missing: &'static str,
    },
    /// A loading of the sample is refused.
    #[error("it refuses {loading:?}: {cause}")]
    Refused {
        /// The loading.
        loading: PlyLoading,
        /// The error.
        cause: FailureError,
    },
    /// The index is infinite or NaN, or the reserve factor negative or NaN.
    #[error("index or reserve factor of {found:?} is not a valid number at {loading:?}")]
    NoAnswer {
        /// The answer.
        found: Assessment,
        /// The loading.
        loading: PlyLoading,
    },
    /// An answer under the name of another criterion.
    #[error("its answer bears the name '{name}'")]
    Name {
        /// The name in the answer.
        name: &'static str,
    },
    /// The same question has two answers.
    #[error("evaluated twice, it gives {first:?} and {second:?} at {loading:?}")]
    NotPure {
        /// First answer.
        first: Assessment,
        /// A later one.
        second: Assessment,
        /// The loading.
        loading: PlyLoading,
    },
    /// A ply without stress fails.
    #[error("a ply without stress has the index {index} and the reserve factor {reserve_factor}")]
    FailsUnloaded {
        /// Index, dimensionless, which must be less than 1.
        index: f64,
        /// Reserve factor, dimensionless, which must be infinite.
        reserve_factor: f64,
    },
    /// The answer depends on the sign of the shear stress.
    #[error(
        "it answers {own:?}, and {mirrored:?} where all shear has the other sign, at {loading:?}"
    )]
    ShearSign {
        /// Answer to the loading.
        own: Assessment,
        /// Answer with the other sign of τ₁₂.
        mirrored: Assessment,
        /// The loading.
        loading: PlyLoading,
    },
    /// The reserve factor without residual stress is not inverse to the load.
    #[error(
        "the reserve factor of {factor} times the stress {stress:?} is {found}, and that of the stress itself {single}"
    )]
    NotHomogeneous {
        /// Multiple of the stress, dimensionless.
        factor: f64,
        /// The stress (σ₁, σ₂, τ₁₂) `[stress]`.
        stress: [f64; 3],
        /// Reserve factor of the multiple, dimensionless.
        found: f64,
        /// Reserve factor of the stress, dimensionless.
        single: f64,
    },
    /// The index is 1 or more before the reserve factor is reached.
    #[error(
        "the index is {index} at {factor} times the load, below the reserve factor {reserve_factor}, at {loading:?}"
    )]
    FailsBefore {
        /// The index there, dimensionless.
        index: f64,
        /// Multiple of the load, dimensionless.
        factor: f64,
        /// Reserve factor, dimensionless.
        reserve_factor: f64,
        /// The loading.
        loading: PlyLoading,
    },
    /// The index is less than 1 where the reserve factor says that the ply fails.
    #[error(
        "the index is {index} at the reserve factor {reserve_factor}, where it must reach 1, at {loading:?}"
    )]
    HoldsBeyond {
        /// The index just beyond the reserve factor, dimensionless.
        index: f64,
        /// Reserve factor, dimensionless.
        reserve_factor: f64,
        /// The loading.
        loading: PlyLoading,
    },
    /// A stress that is not finite gets an answer.
    #[error("it answers {found:?} to a stress that is not finite")]
    NotFiniteAccepted {
        /// The answer.
        found: Assessment,
    },
    /// A ply without a strength in `required` is accepted, or refused for another reason.
    #[error("without {strength}, which it says it needs, a ply gets {found:?}")]
    NotRequired {
        /// The strength left out.
        strength: Strength,
        /// What came back.
        found: Result<Assessment, FailureError>,
    },
    /// A ply with no strength but those in `required` is refused.
    #[error("a ply with no strengths but those that it says it needs is refused: {cause}")]
    RequiresMore {
        /// The error.
        cause: FailureError,
    },
}
