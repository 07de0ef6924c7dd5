//! Why a text is not a lay-up: each with the place, counted in characters from 1, and the way out.

use thiserror::Error;

/// A text that does not read as a lay-up.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum LayupError {
    /// A bracket without a ply in it.
    #[error(
        "lay-up '{layup}', character {position}: no ply here; write angles in degrees, for example [0/90]s"
    )]
    Empty {
        /// The text.
        layup: String,
        /// Where the missing ply was expected.
        position: usize,
    },
    /// A character that cannot stand there.
    #[error("lay-up '{layup}', character {position}: found {found}, expected {expected}")]
    Unexpected {
        /// The text.
        layup: String,
        /// Where.
        position: usize,
        /// What stands there.
        found: String,
        /// What could.
        expected: &'static str,
    },
    /// An angle that is not a number from −180 to 180.
    #[error(
        "lay-up '{layup}', character {position}: '{found}' is not an angle; write a number of degrees from -180 to 180, such as 45, -60 or 22.5"
    )]
    Angle {
        /// The text.
        layup: String,
        /// Where the angle begins.
        position: usize,
        /// What stands there.
        found: String,
    },
    /// A number of plies or repeats that is zero or too large to be a number of plies.
    #[error(
        "lay-up '{layup}', character {position}: '{found}' is not a number of plies; write 1 or more, or leave it out"
    )]
    Count {
        /// The text.
        layup: String,
        /// Where the number begins.
        position: usize,
        /// The digits.
        found: String,
    },
    /// `±45_2`, which some read as 45/-45/45/-45 and others as 45/45/-45/-45.
    #[error(
        "lay-up '{layup}', character {position}: ±{angle}_{count} has two readings; \
         write (±{angle})_{count} for pairs, or {angle}_{count}/-{angle}_{count} for blocks"
    )]
    AmbiguousCount {
        /// The text.
        layup: String,
        /// Where the count begins.
        position: usize,
        /// The angle `[degree]`.
        angle: f64,
        /// The count given.
        count: usize,
    },
    /// A mid-plane mark anywhere but at the mid-plane.
    #[error(
        "lay-up '{layup}', character {position}: the mid-plane mark ~ belongs to one single ply, the last in a bracket \
         that ends in s without repeats, as in [0/45/90~]s"
    )]
    Midplane {
        /// The text.
        layup: String,
        /// Where the mark stands.
        position: usize,
    },
    /// More plies than any laminate has.
    #[error("lay-up '{layup}' has more than {limit} plies; check its repeats")]
    TooManyPlies {
        /// The text.
        layup: String,
        /// The largest number accepted.
        limit: usize,
    },
    /// Brackets in brackets beyond reason.
    #[error("lay-up '{layup}', character {position}: brackets are nested more than {limit} deep")]
    TooDeep {
        /// The text.
        layup: String,
        /// Where the innermost bracket opens.
        position: usize,
        /// The deepest nesting accepted.
        limit: usize,
    },
}
