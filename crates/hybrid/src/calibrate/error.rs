//! Why nothing can be fitted.

use thiserror::Error;

use super::parameter::MOST_PARAMETERS;

/// Why nothing can be fitted.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum CalibrateError {
    /// Too few or too many parameters.
    #[error("{0} parameters cannot be fitted; from 1 to {MOST_PARAMETERS} can")]
    Parameters(usize),
    /// An empty or invalid range.
    #[error("the range of '{name}' from {} to {} is not valid{}", range[0], range[1], if *logarithmic { ": it must increase and be positive, being logarithmic" } else { ": it must increase" })]
    Range {
        /// Name of the parameter.
        name: String,
        /// The range, in the unit of the parameter.
        range: [f64; 2],
        /// Whether it is divided evenly in the logarithm.
        logarithmic: bool,
    },
    /// A confidence `[1]` that does not lie between 0 and 1.
    #[error("the confidence {0} is not between 0 and 1")]
    Confidence(f64),
    /// Blocks of data that do not fit their noise or nuisances.
    #[error("{what} of block {block} has {found} entries, expected {expected}")]
    Length {
        /// Which array.
        what: &'static str,
        /// Index of the block.
        block: usize,
        /// Entries needed.
        expected: usize,
        /// Entries given.
        found: usize,
    },
    /// A number that is infinite or not a number, or a standard deviation that is not positive.
    #[error("{what} {index} of block {block} is {value}")]
    Value {
        /// What it is.
        what: &'static str,
        /// Index of the block.
        block: usize,
        /// Index in it.
        index: usize,
        /// The number, in its own unit.
        value: f64,
    },
    /// Not a valid covariance matrix.
    #[error("the covariance of block {block} is not positive definite, at row {row}")]
    Covariance {
        /// Index of the block.
        block: usize,
        /// Row in which this shows.
        row: usize,
    },
    /// Not more data than unknowns.
    #[error(
        "{data} data cannot determine {parameters} parameters and {nuisances} nuisances: more data than unknowns are needed"
    )]
    TooFew {
        /// Number of data.
        data: usize,
        /// Number of parameters.
        parameters: usize,
        /// Number of independent nuisances.
        nuisances: usize,
    },
    /// A prediction of another length than the data.
    #[error("the model predicts {found} numbers for {expected} data")]
    Prediction {
        /// Number of data.
        expected: usize,
        /// Numbers predicted.
        found: usize,
    },
    /// The model predicts nothing wherever it is asked.
    #[error(
        "the model predicts nothing at any of {tried} places in the ranges; the first reason: {first}"
    )]
    NoPrediction {
        /// Places tried.
        tried: usize,
        /// What the model said at the first.
        first: String,
    },
}
