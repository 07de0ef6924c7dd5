//! Measured displacements: places, values, what failed, and their standard deviation.
//!
//! ```text
//! place = s X,   displacement = ± d u,       y and v change their sign where y points down,
//! ΔU = U − U₀                                the initial load subtracted
//! ```
//!
//! with the scales s and d, the table's numbers X and u, and signs that are all stated and never guessed. Failed places are
//! masked and have the value NaN, so that any use of them shows.
//!
//! | what | where |
//! | --- | --- |
//! | displacements at scattered places from a table | [`Measurement::read`] with a [`Format`] and a [`Reading`] |
//! | outliers: places that do not fit their neighbours | [`Measurement::outliers`] |
//! | digitised fringe centres along lines | [`FringeLines::read`] with a [`LineReading`] |
//! | a finite rotation of the specimen taken off | [`Measurement::rotation`], [`Measurement::turned_back`] |
//! | the initial load taken off | [`Measurement::minus`], [`FringeLines::minus`] |
//! | slopes between neighbouring centres | [`FringeLine::slopes`] |
//! | front against back | [`FringeLine::symmetry`] |

mod centres;
mod error;
mod field;
mod format;
mod lines;
mod null;
mod outliers;
mod read;
mod rotation;
mod slope;
mod table;
mod track;

use stickslip_fem_core::mesh::Point;

pub use crate::triangles::TriangulationError;
pub use error::DataError;
pub use field::Field;
pub(crate) use field::letter;
pub use format::{Format, Places, Reading, YAxis};
pub use lines::{FringeLines, LineReading, OffTrack};
pub use null::{Difference, NullField, Symmetry};
pub use outliers::Outlier;
pub use read::{Rows, Unit};
pub use rotation::Rotation;
pub use slope::Slope;
pub use track::{FringeLine, Located, Step, Track};

/// Displacements measured at scattered places.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Measurement {
    /// Where `[length]`.
    pub places: Vec<Point>,
    /// Components x and y of the displacements `[length]`, one per place; without meaning where not valid.
    pub displacements: [Vec<f64>; 2],
    /// Whether each component was measured at each place.
    pub valid: [Vec<bool>; 2],
    /// Standard deviation of each component `[length]`, the same at all places, independent from place to place.
    pub deviation: [f64; 2],
}

/// Displacements of nodes, as a region takes them.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct NodalDisplacements {
    /// Indices of the nodes.
    pub nodes: Vec<usize>,
    /// Displacements `[length]`, x and y of each node in turn.
    pub values: Vec<f64>,
    /// Covariance of `values` `[length²]`, square, row by row; empty where it is not known.
    pub covariance: Vec<f64>,
}
