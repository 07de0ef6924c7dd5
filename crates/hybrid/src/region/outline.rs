//! Which nodes and chains of edges bound a mesh: an edge that belongs to one cell only is on the boundary.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::Mesh;

/// Turn of the boundary `[rad]` that makes a corner: between the 15° by which the edges of a coarse circle may turn and the
/// right angles of a sector.
const CORNER: f64 = 0.6;

/// The nodes on the boundary, ascending, inner nodes of edges included.
pub fn boundary_nodes(mesh: &Mesh) -> Vec<usize> {
    let edges = mesh.boundary_edges().into_iter();
    let mut nodes: Vec<usize> = edges.flat_map(|edge| mesh.edge_nodes(edge).all()).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// A smooth piece of boundary.
#[derive(Clone, Debug, PartialEq)]
pub struct Chain {
    /// Nodes in walk order, the region on the left; a closed chain does not repeat the first.
    pub nodes: Vec<usize>,
    /// Whether the chain comes back to its first node.
    pub closed: bool,
}

/// The boundary cut at its corners, where it turns by more than 0.6 rad.
pub fn smooth_chains(mesh: &Mesh) -> Vec<Chain> {
    let edges: Vec<Vec<usize>> = (mesh.boundary_edges().into_iter())
        .map(|edge| mesh.edge_nodes(edge).walk().collect())
        .collect();
    let end = |k: usize| edges[k][edges[k].len() - 1];
    let leaving: BTreeMap<usize, usize> = (edges.iter().enumerate())
        .map(|(k, nodes)| (nodes[0], k))
        .collect();
    let next = |k: usize| leaving.get(&end(k)).copied();
    // Two loops that touch at a node hide one of the edges that leave it; a chain then ends there.
    let mut follows = vec![false; edges.len()];
    for k in 0..edges.len() {
        if let Some(after) = next(k).filter(|&after| turn(mesh, &edges[k], &edges[after]) < CORNER)
        {
            follows[after] = true;
        }
    }
    let goes_on = |k: usize| next(k).filter(|&after| follows[after]);
    let mut seen = vec![false; edges.len()];
    let mut chains = Vec::new();
    let starts = (0..edges.len()).filter(|&k| !follows[k]);
    for first in starts.chain(0..edges.len()) {
        let mut nodes = Vec::new();
        let mut at = Some(first);
        let mut last = edges[first][0];
        while let Some(k) = at.filter(|&k| !seen[k]) {
            seen[k] = true;
            last = end(k);
            nodes.extend(&edges[k][..edges[k].len() - 1]);
            at = goes_on(k);
        }
        if let Some(&start) = nodes.first() {
            let closed = start == last && follows[first];
            nodes.extend((!closed).then_some(last));
            chains.push(Chain { nodes, closed });
        }
    }
    chains
}

/// Turn from the end of one edge to the start of the next `[rad]`, without sign; of their chords from the corner to the nearest node.
fn turn(mesh: &Mesh, before: &[usize], after: &[usize]) -> f64 {
    let along = |from: usize, to: usize| {
        let ([x, y], [u, v]) = (mesh.nodes()[from], mesh.nodes()[to]);
        [u - x, v - y]
    };
    let last = before.len() - 1;
    let a = along(before[last - 1], before[last]);
    let b = along(after[0], after[1]);
    (a[0] * b[1] - a[1] * b[0])
        .atan2(a[0] * b[0] + a[1] * b[1])
        .abs()
}
