//! Edges and sets as a file names them.

use std::collections::BTreeMap;

use crate::place::Spot;

/// An edge as files name it; elements by position.
#[derive(Clone, Copy, Debug)]
pub(crate) enum RawEdge {
    /// A local edge of a cell, in the file's numbering of its nodes.
    Face {
        element: usize,
        local: usize,
        spot: Spot,
    },
    /// The edge that a line element coincides with.
    Line { element: usize },
    /// All edges of a cell that no other cell has.
    Free { element: usize },
}

/// Sets by their names; members by position in the file's sorted nodes or elements.
#[derive(Debug, Default)]
pub(crate) struct Sets {
    pub(crate) nodes: BTreeMap<String, Vec<usize>>,
    pub(crate) edges: BTreeMap<String, Vec<RawEdge>>,
    pub(crate) elements: BTreeMap<String, Vec<usize>>,
}
