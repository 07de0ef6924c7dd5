//! Nodes of the boundary at one place: a mesh that is open where it should be joined.

use stickslip_fem_core::mesh::Mesh;

use super::cells::Cells;
use super::edges::EdgeTable;
use crate::error::ReadError;
use crate::raw::Numbered;

/// Part of the mesh's size below which two nodes stand at one place.
const CLOSE: f64 = 1e-9;

/// # Errors
/// [`ReadError::Coincident`].
pub(super) fn check(
    mesh: &Mesh,
    edges: &EdgeTable,
    file: &Numbered,
    cells: &Cells,
) -> Result<(), ReadError> {
    let mut nodes: Vec<usize> = edges
        .boundary()
        .flat_map(|edge| mesh.edge_nodes(edge).all())
        .collect();
    nodes.sort_unstable();
    nodes.dedup();
    let [low, high] = mesh.bounding_box();
    let tolerance = CLOSE * (high[0] - low[0]).max(high[1] - low[1]);
    let Some([a, b]) = closest(mesh, nodes, tolerance) else {
        return Ok(());
    };
    // `cells.nodes` has an entry for every node of the mesh.
    let [first, second] = [a.min(b), a.max(b)].map(|node| &file.nodes[cells.nodes[node]]);
    Err(ReadError::Coincident {
        at: file.files.place(second.spot),
        node: second.number,
        other_at: file.files.place(first.spot),
        other: first.number,
        point: [first.at[0], first.at[1]],
    })
}

/// Two of `nodes` within `tolerance` of each other in x and y.
fn closest(mesh: &Mesh, mut nodes: Vec<usize>, tolerance: f64) -> Option<[usize; 2]> {
    let at = |node: usize| mesh.nodes()[node];
    nodes.sort_by(|&a, &b| at(a)[0].total_cmp(&at(b)[0]).then(a.cmp(&b)));
    let near = |a: f64, b: f64| (a - b).abs() <= tolerance;
    // Columns of almost equal x, each sorted by y: every node looks at its few successors only.
    for column in nodes.chunk_by_mut(|&a, &b| near(at(a)[0], at(b)[0])) {
        column.sort_by(|&a, &b| at(a)[1].total_cmp(&at(b)[1]).then(a.cmp(&b)));
        for (k, &a) in column.iter().enumerate() {
            let above = column.iter().skip(k + 1);
            let mut above = above.take_while(|&&b| near(at(a)[1], at(b)[1]));
            if let Some(&b) = above.find(|&&b| near(at(a)[0], at(b)[0])) {
                return Some([a, b]);
            }
        }
    }
    None
}
