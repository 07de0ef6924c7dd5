//! The plain data a mesh is made of, not yet checked.

use std::collections::BTreeMap;

use crate::kind::{ElementKind, Point};

/// Cells of one kind; a block has one material.
#[derive(Clone, Debug, PartialEq)]
pub struct ElementBlock {
    /// Name for messages and files.
    pub name: String,
    /// Kind of all its cells.
    pub kind: ElementKind,
    /// Global nodes, `kind.nodes()` per cell, one cell after the other.
    pub connectivity: Vec<usize>,
}

/// One edge of one cell.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct EdgeRef {
    /// Global cell index, counted over the blocks in order.
    pub element: usize,
    /// Local edge of that cell.
    pub edge: usize,
}

/// Global nodes of an edge.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct EdgeNodes<'a> {
    /// First and last node, walking with the cell's interior on the left.
    pub ends: [usize; 2],
    /// Nodes between them, in walk order: one less than the edge's order.
    pub inner: &'a [usize],
}

impl<'a> EdgeNodes<'a> {
    /// Polynomial order of the edge.
    pub fn order(&self) -> usize {
        self.inner.len() + 1
    }

    /// All nodes in walk order.
    pub fn walk(&self) -> impl DoubleEndedIterator<Item = usize> + Clone + use<'a> {
        let [first, last] = self.ends;
        let inner = self.inner.iter().copied();
        std::iter::once(first).chain(inner).chain([last])
    }

    /// All nodes, the ends first.
    pub fn all(&self) -> impl Iterator<Item = usize> + Clone + use<'a> {
        self.ends.into_iter().chain(self.inner.iter().copied())
    }
}

/// The exact geometry that an edge set approximates.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Curve {
    /// Part of a circle.
    Arc {
        /// Centre of the circle `[length]`.
        centre: Point,
        /// Radius of the circle `[length]`.
        radius: f64,
    },
    /// A straight line: the edges are exact.
    Line,
}

/// A named piece of boundary.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct EdgeSet {
    /// The edges, in any order, each once.
    pub edges: Vec<EdgeRef>,
    /// Exact geometry, where known.
    pub curve: Option<Curve>,
}

/// Everything a mesh is made of, open to change; [`super::Mesh::new`] checks it.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MeshParts {
    /// Node coordinates `[length]`.
    pub nodes: Vec<Point>,
    /// Blocks of cells.
    pub blocks: Vec<ElementBlock>,
    /// Named nodes.
    pub node_sets: BTreeMap<String, Vec<usize>>,
    /// Named boundaries.
    pub edge_sets: BTreeMap<String, EdgeSet>,
    /// Named cells, by global index.
    pub element_sets: BTreeMap<String, Vec<usize>>,
}
