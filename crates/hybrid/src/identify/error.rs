//! Why friction is not determined.

use std::ops::Range;

use thiserror::Error;

/// Why tractions do not determine friction.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum IdentifyError {
    /// Lists that do not belong together.
    #[error(
        "{pressures} pressures, {shears} shears and {entries} entries of covariance: as many pressures as shears are wanted, and the square of twice as many"
    )]
    Lengths {
        /// Pressures given.
        pressures: usize,
        /// Shears given.
        shears: usize,
        /// Entries of the covariance given.
        entries: usize,
    },
    /// A zone with no place, or beyond the last.
    #[error("the zone {}..{} is not among {places} places", .zone.start, .zone.end)]
    Zone {
        /// The requested zone.
        zone: Range<usize>,
        /// Places given.
        places: usize,
    },
    /// A value that is not finite.
    #[error("the traction at place {place} is not finite")]
    NotFinite {
        /// Index of the place.
        place: usize,
    },
    /// Not a valid covariance matrix.
    #[error("the covariance of the zone is not positive definite, at place {place} of it")]
    Covariance {
        /// Index in the zone.
        place: usize,
    },
}
