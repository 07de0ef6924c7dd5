//! Measured displacements: places, values, what failed, and their deviation.

use stickslip_fem_core::mesh::Point;

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
