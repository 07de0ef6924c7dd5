//! What a point model did wrong.

use thiserror::Error;

use crate::progressive::ProgressiveError;

/// A point model, or its parameters, that does not keep the contract.
#[derive(Clone, Debug, Error, PartialEq)]
#[error("point model breaks the contract: {breach}")]
pub struct PointViolation {
    /// The property that it breaks, and the numbers.
    pub breach: Box<PointBreach>,
}

/// The property that is broken. Numbers are in the units of the model's laminate.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum PointBreach {
    /// The sample tests nothing, which is no fault of the model.
    #[error("it cannot be tested, because {fault}")]
    UselessSample {
        /// What is wrong with the sample.
        fault: &'static str,
    },
    /// A step of the sample is refused.
    #[error("it refuses the strain {strain:?} at the temperature rise {temperature}: {cause}")]
    Refused {
        /// Requested strain, dimensionless.
        strain: [f64; 3],
        /// Requested temperature rise `[temperature]`.
        temperature: f64,
        /// The error.
        cause: ProgressiveError,
    },
    /// A stress, a tangent or a number of the state is infinite or NaN.
    #[error("{quantity} is not finite at the strain {strain:?}")]
    NotFinite {
        /// Which one.
        quantity: &'static str,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// The trial state is not that of the strain and temperature asked for.
    #[error(
        "the trial state has another {quantity} than the step asked for, at the strain {strain:?}"
    )]
    OtherState {
        /// Strain, temperature rise or number of layers.
        quantity: &'static str,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// The same step from the same state has two answers.
    #[error(
        "evaluated again after a rejected step, it gives another answer at the strain {strain:?}"
    )]
    NotPure {
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// A step without change of strain and temperature changes stress or state.
    #[error(
        "a step without change turns {quantity} from {before} into {after} at the strain {strain:?}"
    )]
    ZeroStep {
        /// What changes.
        quantity: &'static str,
        /// Its value before, in the unit of the quantity.
        before: f64,
        /// Its value after, in the unit of the quantity.
        after: f64,
        /// The strain, dimensionless.
        strain: [f64; 3],
    },
    /// The tangent is not symmetric.
    #[error(
        "the tangent has {upper} at ({row}, {column}) and {lower} at ({column}, {row}), at the strain {strain:?}"
    )]
    NotSymmetric {
        /// Row.
        row: usize,
        /// Column.
        column: usize,
        /// Entry at (row, column) `[stress]`.
        upper: f64,
        /// Entry at (column, row) `[stress]`.
        lower: f64,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// The tangent is not the derivative of the stress.
    #[error(
        "the tangent has {stated} at ({row}, {column}), but differences give {difference} (± {tolerance:e}) at the strain {strain:?}"
    )]
    WrongTangent {
        /// Row.
        row: usize,
        /// Column.
        column: usize,
        /// Entry of the tangent `[stress]`.
        stated: f64,
        /// Central difference of the stress `[stress]`.
        difference: f64,
        /// Largest accepted distance between both `[stress]`.
        tolerance: f64,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// Energy comes back that was dissipated.
    #[error("the energy dissipated falls from {before} to {after} at the strain {strain:?}")]
    NegativeDissipation {
        /// Energy dissipated before the step, per volume `[stress]`.
        before: f64,
        /// Energy dissipated after it `[stress]`.
        after: f64,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// The stored energy is negative.
    #[error("the stored energy is {stored} at the strain {strain:?}")]
    NegativeStored {
        /// Energy stored per volume `[stress]`.
        stored: f64,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// Damage heals.
    #[error("layer {layer} heals at the strain {strain:?}")]
    Healed {
        /// Index of the layer, from the bottom, from 0.
        layer: usize,
        /// Requested strain, dimensionless.
        strain: [f64; 3],
    },
    /// A step that makes no sense gets an answer, or another error than the one for it.
    #[error("it does not refuse {what} with its error")]
    NonsenseAccepted {
        /// What the step asked for.
        what: &'static str,
    },
    /// The parameters of the model break their part of the contract.
    #[error(transparent)]
    Parameters(#[from] ParametersBreach),
}

/// What is wrong with parameters that files can name.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ParametersBreach {
    /// No entry of the registry has the name of the parameters.
    #[error("no registered point model has the name '{name}'")]
    NotRegistered {
        /// Name by `typetag`.
        name: &'static str,
    },
    /// A parameter is written that the registry does not describe.
    #[error("the parameter '{parameter}' is missing in the registered entry")]
    NotDescribed {
        /// Its key.
        parameter: String,
    },
    /// The parameters cannot be written, or what was written cannot be read.
    #[error("they cannot be written and read again: {message}")]
    NotSerialisable {
        /// The error of serde.
        message: String,
    },
    /// What is read again is written differently.
    #[error("they are written as {first} and, read again, as {second}")]
    CopyDiffers {
        /// As written first.
        first: String,
        /// As written after reading.
        second: String,
    },
    /// An unknown parameter is not refused.
    #[error("they read {written} without complaint (deny_unknown_fields is missing)")]
    UnknownParameterAccepted {
        /// What was read.
        written: String,
    },
    /// The parameters make no model of the laminate.
    #[error("they make no model: {cause}")]
    NoModel {
        /// The error.
        cause: ProgressiveError,
    },
}
