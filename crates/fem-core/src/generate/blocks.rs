//! Lattices of cells joined to one mesh.
//!
//! A block maps the lattice 0 … nᵢ × 0 … nⱼ to the plane. Fractions of steps are the inner nodes of edges, half steps on quadratic
//! cells; the inside of a cell follows from its sides by blending (x_c = ½ Σ x_mid − ¼ Σ x_corner on quadratic cells), so a map need
//! not be defined there.
//!
//! ```text
//!          North
//!        ┌──┬──┬──┐
//!   West │  │  │  │ East      i →
//!        ├──┼──┼──┤           j ↑
//!        │  │  │  │
//!        └──┴──┴──┘
//!          South
//! ```

mod cell;
mod lattice;
mod merge;
mod side;

pub use side::Side;
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;

use self::lattice::Lattice;
use self::merge::Merger;
use super::GenerateError;
use crate::mesh::{Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshParts, Point};

/// A block of the builder that made it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct BlockId(usize);

/// Builder of a mesh from mapped blocks. Nodes that coincide are merged, cells are oriented counter-clockwise whatever the
/// map, and sides can be named.
///
/// ```
/// use stickslip_fem_core::generate::{Blocks, Side};
/// use stickslip_fem_core::mesh::ElementKind;
///
/// let mut blocks = Blocks::new("bar", ElementKind::Q4);
/// let left = blocks.add([2, 1], |i, j| [i - 2.0, j]);
/// let right = blocks.add([3, 1], |i, j| [i, j]);
/// blocks.name("top", left, Side::North, 0..2);
/// blocks.name("top", right, Side::North, 0..3);
/// let mesh = blocks.build()?;
/// assert_eq!((mesh.nodes().len(), mesh.element_count()), (12, 5));
/// assert_eq!(mesh.edge_path("top")?.nodes.len(), 6);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
#[derive(Debug)]
pub struct Blocks {
    name: String,
    kind: ElementKind,
    centre: Point,
    lattices: Vec<Lattice>,
    sides: Vec<(String, BlockId, Side, Range<usize>)>,
    curves: BTreeMap<String, Curve>,
    points: Vec<(String, BlockId, [usize; 2])>,
}

impl Blocks {
    /// An empty builder for one [`ElementBlock`] called `name` with cells of `kind`.
    pub fn new(name: &str, kind: ElementKind) -> Self {
        Self {
            name: name.to_owned(),
            kind,
            centre: [0.0; 2],
            lattices: Vec::new(),
            sides: Vec::new(),
            curves: BTreeMap::new(),
            points: Vec::new(),
        }
    }

    /// Mirrors the cuts of cells with equal diagonals into triangles about the axes through `centre` `[length]`, instead of those through
    /// the origin; for blocks added from now on.
    pub fn about(&mut self, centre: Point) {
        self.centre = centre;
    }

    /// Adds a block of `cells[0]` × `cells[1]` cells. `map` gives the point `[length]` at lattice position (i, j); linear
    /// kinds ask for whole steps, others also for points where one of the two is a fraction, on an edge's Gauss–Lobatto points.
    pub fn add(&mut self, cells: [usize; 2], map: impl Fn(f64, f64) -> Point) -> BlockId {
        self.lattices
            .push(Lattice::new(cells, self.kind.order(), self.centre, map));
        BlockId(self.lattices.len() - 1)
    }

    /// Adds the edges of the cells `range` along a side to the edge set `set`, and their nodes to the node set of the same
    /// name. Cells outside the block are ignored.
    pub fn name(&mut self, set: &str, block: BlockId, side: Side, range: Range<usize>) {
        self.sides.push((set.to_owned(), block, side, range));
    }

    /// States the exact geometry of an edge set.
    pub fn curve(&mut self, set: &str, curve: Curve) {
        self.curves.insert(set.to_owned(), curve);
    }

    /// Adds the corner node at lattice position `at` to the node set `set`.
    pub fn name_node(&mut self, set: &str, block: BlockId, at: [usize; 2]) {
        self.points.push((set.to_owned(), block, at));
    }

    /// Merges, numbers and checks.
    ///
    /// # Errors
    /// [`GenerateError::Mesh`] if a cell is folded, a point is not finite, or there are no cells;
    /// [`GenerateError::UnknownBlock`] if a [`BlockId`] is another builder's.
    pub fn build(self) -> Result<Mesh, GenerateError> {
        self.check_names()?;
        let mut merger = Merger::new(&self.lattices);
        let mut connectivity = Vec::new();
        let mut first = Vec::new();
        let mut numbers = Vec::new();
        for lattice in &self.lattices {
            first.push(connectivity.len() / self.kind.nodes());
            let number = merger.number(lattice);
            lattice.cells(self.kind, &number, &mut merger.nodes, &mut connectivity);
            numbers.push(number);
        }
        let mut edge_sets = BTreeMap::<String, EdgeSet>::new();
        for (set, BlockId(block), side, range) in &self.sides {
            let edges = self.lattices[*block].side(self.kind, *side, range.clone());
            let edges = edges.map(|(cell, edge)| EdgeRef {
                element: first[*block] + cell,
                edge,
            });
            edge_sets
                .entry(set.clone())
                .or_default()
                .edges
                .extend(edges);
        }
        for (set, &curve) in &self.curves {
            if let Some(edges) = edge_sets.get_mut(set) {
                edges.curve = Some(curve);
            }
        }
        let mut node_sets = edge_nodes(&edge_sets, self.kind, &connectivity);
        for (set, BlockId(block), at) in &self.points {
            let node = numbers[*block][self.lattices[*block].corner(*at)];
            node_sets.entry(set.clone()).or_default().insert(node);
        }
        Ok(Mesh::new(MeshParts {
            nodes: merger.nodes,
            blocks: vec![ElementBlock {
                name: self.name,
                kind: self.kind,
                connectivity,
            }],
            node_sets: node_sets
                .into_iter()
                .map(|(set, nodes)| (set, nodes.into_iter().collect()))
                .collect(),
            edge_sets,
            element_sets: BTreeMap::new(),
        })?)
    }

    fn check_names(&self) -> Result<(), GenerateError> {
        let count = self.lattices.len();
        let sides = self.sides.iter().map(|(set, block, ..)| (set, block.0));
        let mut named = sides.chain(self.points.iter().map(|(set, block, _)| (set, block.0)));
        match named.find(|&(_, block)| block >= count) {
            Some((set, block)) => Err(GenerateError::UnknownBlock {
                set: set.clone(),
                block,
                count,
            }),
            None => Ok(()),
        }
    }
}

/// The nodes of every edge set.
fn edge_nodes(
    edge_sets: &BTreeMap<String, EdgeSet>,
    kind: ElementKind,
    connectivity: &[usize],
) -> BTreeMap<String, BTreeSet<usize>> {
    let nodes_of = |edge: &EdgeRef| {
        let local = kind.edge_nodes(edge.edge);
        let start = edge.element * kind.nodes();
        (local.ends.into_iter().chain(local.inner)).map(move |k| connectivity[start + k])
    };
    let nodes = |set: &EdgeSet| set.edges.iter().flat_map(nodes_of).collect();
    edge_sets
        .iter()
        .map(|(name, set)| (name.clone(), nodes(set)))
        .collect()
}
