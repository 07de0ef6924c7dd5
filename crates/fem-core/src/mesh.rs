//! Plane meshes that are valid by construction.
//!
//! A cell maps its reference cell to the plane by its shape functions,
//!
//! ```text
//! x(ξ) = Σₐ Nₐ(ξ) xₐ,   J(ξ) = ∂x/∂ξ,   det J > 0,
//! ```
//!
//! and a [`Mesh`] exists only if det J is positive at every quadrature point and every corner of every cell, all indices
//! are in range, and every node is used. Code that receives a `Mesh` checks none of this again.
//!
//! Local numbering (VTK and Abaqus agree up to order 2): corners counter-clockwise, then the inner nodes of each edge in walk
//! order, then the nodes inside, in rows of η.
//!
//! ```text
//!  3───6───2        2
//!  │       │        │╲
//!  7   8   5        5  4
//!  │       │        │    ╲
//!  0───4───1        0──3──1
//! ```
//!
//! Local edge `k` runs from corner `k` to corner `k + 1`, so the cell's interior is on its left.

mod boundary;
mod check;
mod error;
mod parts;
mod path;

use std::collections::BTreeMap;

pub use crate::kind::{EdgeLocal, ElementKind, MAX_ORDER, Point};
pub use error::MeshError;
pub use parts::{Curve, EdgeNodes, EdgeRef, EdgeSet, ElementBlock, MeshParts};
pub use path::EdgePath;

/// A checked plane mesh: nodes, blocks of cells, and named sets.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    parts: MeshParts,
    /// Global index of the first cell of each block, and the cell count at the end.
    first_element: Vec<usize>,
}

impl Mesh {
    /// Checks `parts` and seals them.
    ///
    /// # Errors
    /// The first defect found, with the node, cell or set that has it: a coordinate that is not finite, an index out of
    /// range, a cell that is inverted or has no area, a node that no cell uses, a set that names something twice or
    /// something that does not exist.
    pub fn new(parts: MeshParts) -> Result<Self, MeshError> {
        let first_element = check::offsets(&parts)?;
        let mesh = Self {
            parts,
            first_element,
        };
        check::nodes(&mesh)?;
        check::cells(&mesh)?;
        check::sets(&mesh)?;
        Ok(mesh)
    }

    /// Gives the parts back, for example to add a set and seal them again.
    pub fn into_parts(self) -> MeshParts {
        self.parts
    }

    /// The same mesh moved by `by` `[length]`, with the centres of its arcs.
    ///
    /// # Errors
    /// As [`Mesh::new`]: a motion that is not finite, or so large that rounding destroys a cell.
    pub fn translated(self, by: Point) -> Result<Self, MeshError> {
        let mut parts = self.parts;
        let shift = |point: &mut Point| *point = [point[0] + by[0], point[1] + by[1]];
        parts.nodes.iter_mut().for_each(shift);
        for set in parts.edge_sets.values_mut() {
            if let Some(Curve::Arc { centre, .. }) = &mut set.curve {
                shift(centre);
            }
        }
        Self::new(parts)
    }

    /// The same mesh turned about the origin, so that what lay along x lies along the unit vector `direction` `[1]`.
    ///
    /// # Errors
    /// As [`Mesh::new`], for coordinates that become infinite.
    pub fn turned(self, direction: Point) -> Result<Self, MeshError> {
        let mut parts = self.parts;
        let [cos, sin] = direction;
        let turn = |point: &mut Point| {
            let [x, y] = *point;
            *point = [cos * x - sin * y, sin * x + cos * y];
        };
        parts.nodes.iter_mut().for_each(turn);
        for set in parts.edge_sets.values_mut() {
            if let Some(Curve::Arc { centre, .. }) = &mut set.curve {
                turn(centre);
            }
        }
        Self::new(parts)
    }

    /// Node coordinates `[length]`.
    pub fn nodes(&self) -> &[Point] {
        &self.parts.nodes
    }

    /// Blocks of cells of one kind each, in the order of the global cell index.
    pub fn blocks(&self) -> &[ElementBlock] {
        &self.parts.blocks
    }

    /// Number of cells in all blocks.
    pub fn element_count(&self) -> usize {
        self.first_element.last().copied().unwrap_or(0)
    }

    /// Global index of the first cell of `block`; `block` is less than the number of blocks.
    pub fn first_element(&self, block: usize) -> usize {
        self.first_element[block]
    }

    /// Kind, nodes and block of cell `global`, which is less than [`Mesh::element_count`].
    pub fn element(&self, global: usize) -> (ElementKind, &[usize], usize) {
        // Offsets are sorted and start at 0, so at least one is not greater than `global`.
        let block = self.first_element.partition_point(|&first| first <= global) - 1;
        let cells = &self.parts.blocks[block];
        let size = cells.kind.nodes();
        let start = (global - self.first_element[block]) * size;
        (cells.kind, &cells.connectivity[start..start + size], block)
    }

    /// Global nodes of a cell's edge, in the cell's orientation: the interior is on the left.
    pub fn edge_nodes(&self, edge: EdgeRef) -> EdgeNodes<'_> {
        let (kind, nodes, _) = self.element(edge.element);
        let local = kind.edge_nodes(edge.edge);
        EdgeNodes {
            ends: local.ends.map(|k| nodes[k]),
            inner: &nodes[local.inner],
        }
    }

    /// The nodes of the set `name`.
    ///
    /// # Errors
    /// [`MeshError::MissingSet`] with the names that exist.
    pub fn node_set(&self, name: &str) -> Result<&[usize], MeshError> {
        find(&self.parts.node_sets, "node", name).map(Vec::as_slice)
    }

    /// The edges of the set `name`.
    ///
    /// # Errors
    /// [`MeshError::MissingSet`] with the names that exist.
    pub fn edge_set(&self, name: &str) -> Result<&EdgeSet, MeshError> {
        find(&self.parts.edge_sets, "edge", name)
    }

    /// The cells (global indices) of the set `name`.
    ///
    /// # Errors
    /// [`MeshError::MissingSet`] with the names that exist.
    pub fn element_set(&self, name: &str) -> Result<&[usize], MeshError> {
        find(&self.parts.element_sets, "element", name).map(Vec::as_slice)
    }

    /// Names of all node sets, sorted.
    pub fn node_set_names(&self) -> impl Iterator<Item = &str> {
        self.parts.node_sets.keys().map(String::as_str)
    }

    /// Names of all edge sets, sorted.
    pub fn edge_set_names(&self) -> impl Iterator<Item = &str> {
        self.parts.edge_sets.keys().map(String::as_str)
    }

    /// Names of all cell sets, sorted.
    pub fn element_set_names(&self) -> impl Iterator<Item = &str> {
        self.parts.element_sets.keys().map(String::as_str)
    }

    /// Smallest and largest corner of the box around all nodes `[length]`.
    pub fn bounding_box(&self) -> [Point; 2] {
        let empty = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
        self.parts.nodes.iter().fold(empty, |[low, high], p| {
            [
                [low[0].min(p[0]), low[1].min(p[1])],
                [high[0].max(p[0]), high[1].max(p[1])],
            ]
        })
    }
}

fn find<'a, T>(
    sets: &'a BTreeMap<String, T>,
    family: &'static str,
    name: &str,
) -> Result<&'a T, MeshError> {
    sets.get(name).ok_or_else(|| MeshError::MissingSet {
        family,
        name: name.to_owned(),
        available: sets.keys().cloned().collect(),
    })
}
