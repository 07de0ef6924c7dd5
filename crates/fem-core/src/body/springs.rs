//! Springs between a body and the ground,
//!
//! ```text
//! K_s = t ∫ k N_a N_b d dᵀ ds   on edges,      k d dᵀ   at a node
//! ```
//!
//! with the unit vector d along which they act.

use super::elastic::ElasticBody;
use super::error::BodyError;
use crate::element::{edge_rule, edge_shape, edge_slope};
use crate::mesh::{EdgeRef, Mesh};
use crate::support::{Spring, SpringSite};

/// The springs of one edge or node: its nodes and their stiffness `[force/length]`, rows and columns x and y of each node in turn.
pub(super) struct SpringCell {
    pub(super) nodes: Vec<usize>,
    pub(super) matrix: Vec<f64>,
}

impl ElasticBody {
    /// The springs, cell by cell.
    pub(super) fn spring_cells(&self) -> Vec<SpringCell> {
        let cells = |spring: &Spring| -> Vec<SpringCell> {
            let cell = |nodes: Vec<usize>, shares: Vec<f64>| SpringCell {
                matrix: along(&shares, spring.direction.unit()),
                nodes,
            };
            match &spring.site {
                SpringSite::Node(node) => vec![cell(vec![*node], vec![spring.stiffness])],
                SpringSite::Edges(edges) => edges
                    .iter()
                    .map(|&edge| {
                        let (nodes, mut shares) = mass(&self.mesh, edge);
                        let factor = spring.stiffness * self.thickness;
                        for share in &mut shares {
                            *share *= factor;
                        }
                        cell(nodes, shares)
                    })
                    .collect(),
            }
        };
        self.springs.iter().flat_map(cells).collect()
    }

    /// Nodal forces −K_s u `[force]`, interleaved, of the springs on the body in the displacements `u` `[length]`; empty without springs.
    pub fn spring_forces(&self, u: &[f64]) -> Vec<f64> {
        if self.springs.is_empty() {
            return Vec::new();
        }
        let mut forces = vec![0.0; u.len()];
        for SpringCell { nodes, matrix } in self.spring_cells() {
            let unknowns: Vec<usize> = nodes
                .iter()
                .flat_map(|node| [2 * node, 2 * node + 1])
                .collect();
            for (row, &own) in matrix.chunks_exact(unknowns.len()).zip(&unknowns) {
                let terms = row.iter().zip(&unknowns);
                forces[own] -= terms.map(|(k, &other)| k * u[other]).sum::<f64>();
            }
        }
        forces
    }

    /// Nodes on springs with the unit vectors along which they act.
    pub(super) fn sprung(&self) -> impl Iterator<Item = (usize, [f64; 2])> {
        self.springs.iter().flat_map(|spring| {
            let nodes = match &spring.site {
                SpringSite::Node(node) => vec![*node],
                SpringSite::Edges(edges) => {
                    let all = edges.iter();
                    all.flat_map(|&edge| self.mesh.edge_nodes(edge).all())
                        .collect()
                }
            };
            nodes
                .into_iter()
                .map(|node| (node, spring.direction.unit()))
        })
    }
}

/// Refuses springs of a stiffness that is not positive, and of nodes that do not exist.
pub(super) fn check(mesh: &Mesh, springs: &[Spring]) -> Result<(), BodyError> {
    for (index, spring) in springs.iter().enumerate() {
        let [x, y] = spring.direction.unit();
        let is_good = spring.stiffness > 0.0 && spring.stiffness.is_finite();
        if !(is_good && x.is_finite() && y.is_finite()) {
            return Err(BodyError::Spring {
                spring: index,
                stiffness: spring.stiffness,
            });
        }
        if let SpringSite::Node(node) = spring.site
            && node >= mesh.nodes().len()
        {
            return Err(BodyError::NoSuchNode { node });
        }
    }
    Ok(())
}

/// The nodes of an edge, and ∫ N_a N_b ds `[length]` for each pair of them.
fn mass(mesh: &Mesh, edge: EdgeRef) -> (Vec<usize>, Vec<f64>) {
    let own = mesh.edge_nodes(edge);
    let order = own.order();
    let nodes: Vec<usize> = own.walk().collect();
    let count = nodes.len();
    let mut shares = vec![0.0; count * count];
    for &(xi, weight) in edge_rule(order) {
        let (shape, slope) = (edge_shape(order, xi), edge_slope(order, xi));
        let tangent = [0, 1].map(|axis| {
            let terms = nodes.iter().zip(slope);
            terms
                .map(|(&node, slope)| slope * mesh.nodes()[node][axis])
                .sum::<f64>()
        });
        let length = weight * tangent[0].hypot(tangent[1]);
        for a in 0..count {
            for b in 0..count {
                shares[a * count + b] += length * shape[a] * shape[b];
            }
        }
    }
    (nodes, shares)
}

/// `shares` between pairs of nodes as a matrix on x and y of them, along `direction`.
fn along(shares: &[f64], direction: [f64; 2]) -> Vec<f64> {
    let count = shares.len().isqrt();
    let width = 2 * count;
    let mut matrix = vec![0.0; width * width];
    for (at, share) in shares.iter().enumerate() {
        let (a, b) = (at / count, at % count);
        for i in 0..2 {
            for j in 0..2 {
                matrix[(2 * a + i) * width + 2 * b + j] = share * direction[i] * direction[j];
            }
        }
    }
    matrix
}
