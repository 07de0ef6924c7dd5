//! Errors of the contact crate.

use thiserror::Error;

use crate::failure::StepFailure;

/// Why a contact problem cannot be made or a history cannot be followed.
#[derive(Clone, Debug, Error)]
#[non_exhaustive]
pub enum ContactError {
    /// A contact pair is malformed.
    #[error("contact '{pair}', point {point}: {what}")]
    InvalidPair {
        /// Name of the pair.
        pair: String,
        /// Index of the point in the pair.
        point: usize,
        /// What is wrong, with the numbers.
        what: String,
    },
    /// A link does not fit its bodies.
    #[error("link {link}: {what}")]
    InvalidLink {
        /// Index of the link.
        link: usize,
        /// What does not fit.
        what: String,
    },
    /// A pair is named by an index that no pair has.
    #[error("pair {pair} does not exist: the problem has {pairs}")]
    UnknownPair {
        /// The index given, from 0.
        pair: usize,
        /// Number of pairs.
        pairs: usize,
    },
    /// Bodies have different numbers of load cases.
    #[error("bodies with {first} and {other} load cases cannot share one load history")]
    LoadCases {
        /// Cases of the first body.
        first: usize,
        /// Cases of another body.
        other: usize,
    },
    /// A load step has the wrong number of multipliers, or one that is not finite.
    #[error("load step {}: {what}", .step + 1)]
    InvalidLoad {
        /// Index of the step, from 0; messages count from 1.
        step: usize,
        /// What is wrong, with the numbers.
        what: String,
    },
    /// A load step was not solved, with every solver tried and the increment cut as far as allowed.
    #[error(
        "load step {} was not solved beyond {reached:.4} of its increment{}: {cause}",
        .step + 1,
        if .cause.is_unresolved() { " and is unresolved" } else { "" }
    )]
    StepFailed {
        /// Index of the step, from 0; messages count from 1.
        step: usize,
        /// Fraction of the increment of the step that was reached by states that meet the conditions `[1]`.
        reached: f64,
        /// Indices of the bodies whose contact was not solved, where others do not depend on them; empty for all. The points and rigid
        /// motions in `cause` are those of these bodies alone.
        bodies: Vec<usize>,
        /// What the last attempt said.
        #[source]
        cause: Box<StepFailure>,
    },
}
