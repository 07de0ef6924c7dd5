//! Order of elimination of a body with many edges in contact: each node belongs to the edge nearest to it, and what separates these
//! regions comes last.
//!
//! ```text
//! [ inside of all regions | edge 1 | … | edge N | separators ]
//! ```
//!
//! With K = L Lᵀ in this order, edges are coupled through the separators alone.

use std::collections::VecDeque;
use std::ops::Range;

use crate::linalg::{FactorError, minimum_degree};
use crate::mesh::Mesh;

/// Nodes in the order of their elimination.
pub(super) struct RegionOrder {
    pub(super) nodes: Vec<usize>,
    /// Number of separating nodes, which are the last.
    pub(super) separators: usize,
}

/// Where unknowns stand that are ordered by regions.
#[derive(Clone, Debug)]
pub(super) struct Regions {
    /// Unknowns of each edge.
    pub(super) edges: Vec<Range<usize>>,
    /// First unknown of the separators.
    pub(super) separators: usize,
}

impl Regions {
    /// Those of `nodes` contact nodes, without supports, whose unknowns stand before the separators that begin with unknown `separators`.
    pub(super) fn new(nodes: usize, ends: &[usize], separators: usize) -> Self {
        let first = separators - 2 * nodes;
        let starts = std::iter::once(0).chain(ends.iter().copied());
        let edges = starts
            .zip(ends)
            .map(|(start, end)| first + 2 * start..first + 2 * end);
        Self {
            edges: edges.collect(),
            separators,
        }
    }
}

impl RegionOrder {
    /// The order of the nodes of `mesh`, whose contact nodes are `interface`, edge by edge, with `ends` the end of each edge there;
    /// `None` where a cell has nodes of two edges.
    ///
    /// # Errors
    /// [`FactorError::TooLarge`].
    pub(super) fn new(
        mesh: &Mesh,
        adjacency: &[Vec<u32>],
        interface: &[usize],
        ends: &[usize],
    ) -> Result<Option<Self>, FactorError> {
        let mut edge = vec![None; adjacency.len()];
        let mut start = 0;
        for (index, &end) in ends.iter().enumerate() {
            interface[start..end]
                .iter()
                .for_each(|&node| edge[node] = Some(index));
            start = end;
        }
        let Some(region) = Bounds::of(mesh, &edge, &nearest(adjacency, interface, &edge)) else {
            return Ok(None);
        };
        let separators = region.separators();
        let order = minimum_degree(&region.coupling(&separators), &[])?;
        let last = order.into_iter().map(|k| separators[k]);
        let last: Vec<usize> = interface.iter().copied().chain(last).collect();
        Ok(Some(Self {
            nodes: minimum_degree(adjacency, &last)?,
            separators: separators.len(),
        }))
    }
}

/// The edge nearest to each node, in cells.
fn nearest(adjacency: &[Vec<u32>], interface: &[usize], edge: &[Option<usize>]) -> Vec<usize> {
    let mut nearest: Vec<Option<usize>> = edge.to_vec();
    let mut queue: VecDeque<usize> = interface.iter().copied().collect();
    while let Some(node) = queue.pop_front() {
        for &next in &adjacency[node] {
            let next = next as usize;
            if nearest[next].is_none() {
                nearest[next] = nearest[node];
                queue.push_back(next);
            }
        }
    }
    nearest.into_iter().map(Option::unwrap_or_default).collect()
}

/// The regions whose cells a node belongs to: one, or several of a separating node.
struct Bounds {
    of_node: Vec<Vec<usize>>,
    regions: usize,
}

impl Bounds {
    /// Those of cells in the region of their first node, or of the edge that they stand on.
    fn of(mesh: &Mesh, edge: &[Option<usize>], nearest: &[usize]) -> Option<Self> {
        let mut of_node: Vec<Vec<usize>> = vec![Vec::new(); edge.len()];
        for block in mesh.blocks() {
            for cell in block.connectivity.chunks_exact(block.kind.nodes()) {
                let mut edges = cell.iter().filter_map(|&node| edge[node]);
                let own = edges.next();
                if edges.any(|other| Some(other) != own) {
                    return None;
                }
                let region = own.unwrap_or(nearest[cell[0]]);
                for &node in cell {
                    if !of_node[node].contains(&region) {
                        of_node[node].push(region);
                    }
                }
            }
        }
        let regions = nearest.iter().max().map_or(0, |last| last + 1);
        Some(Self { of_node, regions })
    }

    /// Nodes of several regions.
    fn separators(&self) -> Vec<usize> {
        (0..self.of_node.len())
            .filter(|&node| self.of_node[node].len() > 1)
            .collect()
    }

    /// Neighbours of each of `separators` once the regions are eliminated: all others around the same region.
    fn coupling(&self, separators: &[usize]) -> Vec<Vec<u32>> {
        let mut around: Vec<Vec<u32>> = vec![Vec::new(); self.regions];
        for (k, &node) in separators.iter().enumerate() {
            for &region in &self.of_node[node] {
                around[region].push(k as u32);
            }
        }
        let of_separator = |(k, &node): (usize, &usize)| {
            let all = self.of_node[node]
                .iter()
                .flat_map(|&region| &around[region]);
            let mut all: Vec<u32> = all.copied().filter(|&other| other as usize != k).collect();
            all.sort_unstable();
            all.dedup();
            all
        };
        separators.iter().enumerate().map(of_separator).collect()
    }
}
