//! Structured meshes of any kind on the image of a rectangle.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::{ElementBlock, ElementKind, Mesh, MeshParts, Point};

/// `cells[0] × cells[1]` quadrilaterals (or twice as many triangles) on `[0, 1]²`, mapped to the plane by `map`.
/// Mid-side nodes are mapped like all others, so they lie on the true curve.
pub(crate) fn mapped(kind: ElementKind, cells: [usize; 2], map: impl Fn(Point) -> Point) -> Mesh {
    let columns = 2 * cells[0] + 1;
    let rows = 2 * cells[1] + 1;
    let lattice = |[i, j]: [usize; 2]| j * columns + i;
    let mut connectivity = Vec::new();
    for j in (0..rows - 1).step_by(2) {
        for i in (0..columns - 1).step_by(2) {
            for offsets in local_lattice(kind) {
                connectivity.extend(offsets.iter().map(|[a, b]| lattice([i + a, j + b])));
            }
        }
    }
    let mut used = connectivity.clone();
    used.sort_unstable();
    used.dedup();
    for node in &mut connectivity {
        *node = used.binary_search(node).unwrap();
    }
    let place = |k: &usize| {
        let (i, j) = (k % columns, k / columns);
        map([
            i as f64 / (columns - 1) as f64,
            j as f64 / (rows - 1) as f64,
        ])
    };
    let parts = MeshParts {
        nodes: used.iter().map(place).collect(),
        blocks: vec![ElementBlock {
            name: "all".to_owned(),
            kind,
            connectivity,
        }],
        node_sets: BTreeMap::new(),
        edge_sets: BTreeMap::new(),
        element_sets: BTreeMap::new(),
    };
    Mesh::new(parts).unwrap()
}

/// Nodes of the cells in one 3×3 lattice.
fn local_lattice(kind: ElementKind) -> Vec<Vec<[usize; 2]>> {
    let quad = [
        [0, 0],
        [2, 0],
        [2, 2],
        [0, 2],
        [1, 0],
        [2, 1],
        [1, 2],
        [0, 1],
        [1, 1],
    ];
    let lower = [[0, 0], [2, 0], [2, 2], [1, 0], [2, 1], [1, 1]];
    let upper = [[0, 0], [2, 2], [0, 2], [1, 1], [1, 2], [0, 1]];
    let take = |all: &[[usize; 2]]| all[..kind.nodes()].to_vec();
    if kind.corners() == 3 {
        vec![take(&lower), take(&upper)]
    } else {
        vec![take(&quad)]
    }
}

/// Displacement at the nodes, interleaved.
pub(crate) fn sampled(mesh: &Mesh, field: impl Fn(Point) -> [f64; 2]) -> Vec<f64> {
    mesh.nodes().iter().flat_map(|&p| field(p)).collect()
}
