//! All edges of a mesh with their cells.

use stickslip_fem_core::mesh::{EdgeRef, Mesh};

/// An edge of a cell, filed under the lower of its two ends.
#[derive(Clone, Copy, Debug)]
pub(super) struct Owner {
    /// The higher of the two ends.
    other: usize,
    /// Whether the cell walks from the lower to the higher end.
    ascending: bool,
    /// The edge.
    pub(super) edge: EdgeRef,
}

/// The edges of all cells, by their ends.
#[derive(Debug)]
pub(super) struct EdgeTable {
    /// Where the edges of each lower end begin, and the end of all.
    starts: Vec<usize>,
    owners: Vec<Owner>,
}

/// Every edge of every cell with its first and last node.
fn all_edges(mesh: &Mesh) -> impl Iterator<Item = (EdgeRef, [usize; 2])> + '_ {
    let cells = 0..mesh.element_count();
    cells.flat_map(move |element| {
        let (kind, nodes, _) = mesh.element(element);
        // Local ends are less than the number of nodes of the kind.
        (0..kind.edges()).map(move |edge| {
            let ends = kind.edge_nodes(edge).ends.map(|k| nodes[k]);
            (EdgeRef { element, edge }, ends)
        })
    })
}

impl EdgeTable {
    pub(super) fn new(mesh: &Mesh) -> Self {
        let nodes = mesh.nodes().len();
        let mut starts = vec![0; nodes + 1];
        // Nodes of cells are less than the number of nodes, here and below.
        for (_, [a, b]) in all_edges(mesh) {
            starts[a.min(b) + 1] += 1;
        }
        for node in 0..nodes {
            starts[node + 1] += starts[node];
        }
        let empty = Owner {
            other: 0,
            ascending: true,
            edge: EdgeRef {
                element: 0,
                edge: 0,
            },
        };
        let mut owners = vec![empty; starts[nodes]];
        let mut next = starts.clone();
        for (edge, [a, b]) in all_edges(mesh) {
            let low = a.min(b);
            owners[next[low]] = Owner {
                other: a.max(b),
                ascending: a < b,
                edge,
            };
            next[low] += 1;
        }
        for node in 0..nodes {
            let bucket = &mut owners[starts[node]..starts[node + 1]];
            bucket.sort_unstable_by_key(|owner| (owner.other, owner.ascending, owner.edge));
        }
        Self { starts, owners }
    }

    /// Two cells on the same side of an edge.
    pub(super) fn overlap(&self) -> Option<[usize; 2]> {
        let buckets = self.starts.windows(2).map(|at| &self.owners[at[0]..at[1]]);
        buckets
            .flat_map(|bucket| bucket.windows(2))
            .find_map(|pair| {
                let (a, b) = (&pair[0], &pair[1]);
                let same = (a.other, a.ascending) == (b.other, b.ascending);
                same.then_some([a.edge.element, b.edge.element])
            })
    }

    /// The cells' edges between two nodes: none, one on the boundary, two inside.
    fn owners(&self, [a, b]: [usize; 2]) -> &[Owner] {
        let (low, high) = (a.min(b), a.max(b));
        let [Some(&start), Some(&end)] = [self.starts.get(low), self.starts.get(low + 1)] else {
            return &[];
        };
        let bucket = &self.owners[start..end];
        let first = bucket.partition_point(|owner| owner.other < high);
        let last = bucket.partition_point(|owner| owner.other <= high);
        &bucket[first..last]
    }

    /// The edge from the first to the second node, of the cell on its left if both sides have one.
    pub(super) fn find(&self, [a, b]: [usize; 2]) -> Option<EdgeRef> {
        let owners = self.owners([a, b]);
        let left = owners.iter().find(|owner| owner.ascending == (a < b));
        left.or(owners.first()).map(|owner| owner.edge)
    }

    /// Whether no other cell has the edge between two nodes.
    pub(super) fn is_boundary(&self, ends: [usize; 2]) -> bool {
        self.owners(ends).len() == 1
    }

    /// The edges that only one cell has.
    pub(super) fn boundary(&self) -> impl Iterator<Item = EdgeRef> + '_ {
        let buckets = self.starts.windows(2).map(|at| &self.owners[at[0]..at[1]]);
        let runs = buckets.flat_map(|bucket| bucket.chunk_by(|a, b| a.other == b.other));
        runs.filter(|run| run.len() == 1)
            .flat_map(|run| run.iter().map(|owner| owner.edge))
    }
}
