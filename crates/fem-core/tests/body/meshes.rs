//! Rectangles with displaced nodes.

use stickslip_fem_core::element::reference_nodes;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{EdgeRef, ElementKind, Mesh, MeshParts, Point};

/// The four sides of every mesh here, names of its edge and node sets.
pub(crate) const SIDES: [&str; 4] = ["bottom", "right", "top", "left"];

/// `cells[0]` × `cells[1]` equal quadrilaterals (or twice as many triangles) on the rectangle `x` × `y`.
pub(crate) fn rectangle(kind: ElementKind, x: [f64; 2], y: [f64; 2], cells: [usize; 2]) -> Mesh {
    let description = Rectangle::uniform(x, y, cells, kind).unwrap();
    description.generate().unwrap()
}

/// The same cells with every node moved to its image under `map`.
pub(crate) fn mapped(mesh: Mesh, map: impl Fn(Point) -> Point) -> Mesh {
    let mut parts = mesh.into_parts();
    parts.nodes.iter_mut().for_each(|node| *node = map(*node));
    Mesh::new(parts).unwrap()
}

/// Repeatable noise in [−1, 1]: linear congruential numbers (constants of Knuth, *The Art of Computer Programming* 2, 3.3.4).
pub(crate) struct Noise(u64);

impl Noise {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    pub(crate) fn vector(&mut self, length: usize) -> Vec<f64> {
        (0..length).map(|_| self.next()).collect()
    }
}

/// Which way a mesh is disturbed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Distortion {
    /// Corners inside the body are moved; mid-side nodes stay in the middle of straight sides.
    Straight,
    /// Mid-side and centre nodes are moved off the middle as well, those of the rim too.
    Curved,
}

/// A parallelogram of 4 × 3 cells, no draw of which is inverted.
///
/// Corners move by up to `shift` of a cell's side and the other nodes by up to `bulge` of it, in each direction. Both
/// columns of the Jacobian, scaled to a cell of unit sides, then lie within `d = 2·shift + 9·bulge` of the unit
/// vectors (9 bounds the derivatives of the quadratic shape functions of Q9 and T6), so that its determinant is
/// at least `(1 − d)² − d² = 1 − 2d > 0`.
pub(crate) fn scattered(kind: ElementKind, distortion: Distortion, seed: u64) -> Mesh {
    let (shift, bulge) = match distortion {
        Distortion::Straight => (0.2, 0.0),
        Distortion::Curved => (0.1, 0.03),
    };
    let cells = [4, 3];
    let step = [0, 1].map(|i| 1.0 / cells[i] as f64);
    let mut parts = rectangle(kind, [0.0, 1.0], [0.0, 1.0], cells).into_parts();
    let mut noise = Noise::new(seed);
    let connectivity = parts.blocks[0].connectivity.clone();
    let corners = |cell: &[usize]| cell[..kind.corners()].to_vec();
    let mut moved = vec![false; parts.nodes.len()];
    for node in connectivity.chunks_exact(kind.nodes()).flat_map(corners) {
        let inside = parts.nodes[node].iter().all(|c| (0.01..0.99).contains(c));
        if inside && !std::mem::replace(&mut moved[node], true) {
            (0..2).for_each(|i| parts.nodes[node][i] += shift * step[i] * noise.next());
        }
    }
    // A polynomial of order p has derivatives of up to p² times its largest value (Markov), so higher orders bear less.
    let bulge = bulge * (2.0 / kind.order() as f64).powi(3).min(1.0);
    let places = reference_nodes(kind);
    for cell in connectivity.chunks_exact(kind.nodes()) {
        for (&node, &at) in cell.iter().zip(&places).skip(kind.corners()) {
            if std::mem::replace(&mut moved[node], true) {
                continue;
            }
            let corners = cell.iter().zip(corner_weights(kind, at));
            let mut straight = [0.0; 2];
            for (&corner, weight) in corners {
                (0..2).for_each(|i| straight[i] += weight * parts.nodes[corner][i]);
            }
            parts.nodes[node] = [0, 1].map(|i| straight[i] + bulge * step[i] * noise.next());
        }
    }
    mapped(Mesh::new(parts).unwrap(), |[x, y]| {
        [1.3 * x + 0.4 * y - 0.2, 0.9 * y - 0.2 * x]
    })
}

/// Linear or bilinear shape functions of the corners at a place of the reference cell.
fn corner_weights(kind: ElementKind, [xi, eta]: Point) -> Vec<f64> {
    match kind.corners() {
        3 => vec![1.0 - xi - eta, xi, eta],
        _ => [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]]
            .map(|[a, b]| (1.0 + a * xi) * (1.0 + b * eta) / 4.0)
            .to_vec(),
    }
}

/// The edges of several sides.
pub(crate) fn edges(mesh: &Mesh, sides: &[&str]) -> Vec<EdgeRef> {
    let of = |side: &&str| mesh.edge_set(side).unwrap().edges.clone();
    sides.iter().flat_map(of).collect()
}

/// The nodes of several sides, each once.
pub(crate) fn side_nodes(mesh: &Mesh, sides: &[&str]) -> Vec<usize> {
    let of = |side: &&str| mesh.node_set(side).unwrap().to_vec();
    let mut nodes: Vec<usize> = sides.iter().flat_map(of).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

/// The node closest to `place`.
pub(crate) fn nearest(mesh: &Mesh, place: Point) -> usize {
    let distance = |&node: &usize| {
        let [x, y] = mesh.nodes()[node];
        (x - place[0]).hypot(y - place[1])
    };
    let nodes = 0..mesh.nodes().len();
    nodes
        .min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap()
}

/// Two squares side by side: Q8 on the left, T6 on the right, a block each.
pub(crate) fn joined() -> Mesh {
    let left = rectangle(ElementKind::Q8, [0.0, 1.0], [0.0, 1.0], [2, 3]).into_parts();
    let right = rectangle(ElementKind::T6, [1.0, 2.0], [0.0, 1.0], [2, 3]).into_parts();
    let mut parts = MeshParts {
        nodes: left.nodes,
        blocks: left.blocks,
        ..MeshParts::default()
    };
    let numbers: Vec<usize> = right
        .nodes
        .iter()
        .map(|p| {
            let close = |q: &Point| (p[0] - q[0]).hypot(p[1] - q[1]) < 1e-12;
            parts.nodes.iter().position(close).unwrap_or_else(|| {
                parts.nodes.push(*p);
                parts.nodes.len() - 1
            })
        })
        .collect();
    let mut block = right.blocks[0].clone();
    block
        .connectivity
        .iter_mut()
        .for_each(|node| *node = numbers[*node]);
    parts.blocks.push(block);
    let end = right.node_sets["right"]
        .iter()
        .map(|&node| numbers[node])
        .collect();
    parts
        .node_sets
        .insert("left".to_owned(), left.node_sets["left"].clone());
    parts.node_sets.insert("right".to_owned(), end);
    Mesh::new(parts).unwrap()
}
