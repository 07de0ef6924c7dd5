//! The checks that make a mesh.

use std::collections::BTreeSet;

use super::{EdgeRef, ElementBlock, Mesh, MeshError, MeshParts, Point};
use crate::element::{Element, KindVisitor, with_element};

/// Index of the first cell of each block and, last, the number of cells.
pub(super) fn offsets(parts: &MeshParts) -> Result<Vec<usize>, MeshError> {
    let mut offsets = vec![0];
    let mut count = 0;
    for block in &parts.blocks {
        let (size, length) = (block.kind.nodes(), block.connectivity.len());
        if length % size != 0 {
            let block_name = block.name.clone();
            return Err(MeshError::RaggedConnectivity {
                block: block_name,
                kind: block.kind,
                length,
            });
        }
        count += length / size;
        offsets.push(count);
    }
    if count == 0 {
        Err(MeshError::Empty)
    } else {
        Ok(offsets)
    }
}

/// Coordinates are finite, connectivity is in range, and every node is used.
pub(super) fn nodes(mesh: &Mesh) -> Result<(), MeshError> {
    let nodes = mesh.nodes();
    if let Some(node) = nodes.iter().position(|p| !p.iter().all(|c| c.is_finite())) {
        return Err(MeshError::NonFiniteNode {
            node,
            at: nodes[node],
        });
    }
    let mut used = vec![false; nodes.len()];
    for (k, block) in mesh.blocks().iter().enumerate() {
        for (position, &node) in block.connectivity.iter().enumerate() {
            let Some(flag) = used.get_mut(node) else {
                let element = mesh.first_element(k) + position / block.kind.nodes();
                let block = block.name.clone();
                return Err(MeshError::NodeOutOfRange {
                    element,
                    block,
                    node,
                    count: nodes.len(),
                });
            };
            *flag = true;
        }
    }
    match used.iter().position(|&used| !used) {
        Some(node) => Err(MeshError::UnusedNode {
            node,
            at: nodes[node],
        }),
        None => Ok(()),
    }
}

/// Every cell has a positive Jacobian determinant.
pub(super) fn cells(mesh: &Mesh) -> Result<(), MeshError> {
    for (k, block) in mesh.blocks().iter().enumerate() {
        let first = mesh.first_element(k);
        with_element(
            block.kind,
            JacobianCheck {
                nodes: mesh.nodes(),
                block,
                first,
            },
        )?;
    }
    Ok(())
}

struct JacobianCheck<'a> {
    nodes: &'a [Point],
    block: &'a ElementBlock,
    first: usize,
}

impl KindVisitor for JacobianCheck<'_> {
    type Output = Result<(), MeshError>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        let corners = E::NODES.into_iter().take(E::KIND.corners());
        let points = corners.chain(E::QUADRATURE.iter().map(|point| point.at));
        let gradients: Vec<(Point, [[f64; 2]; N])> =
            points.map(|at| (at, E::gradients(at))).collect();
        for (k, cell) in self.block.connectivity.chunks_exact(N).enumerate() {
            let x: [Point; N] = std::array::from_fn(|a| self.nodes[cell[a]]);
            let rounding = rounding(&x);
            for &(at, ref gradients) in &gradients {
                let determinant = determinant(&x, gradients);
                // Written so that an overflow to NaN is refused too.
                if determinant > rounding {
                    continue;
                }
                let (element, block) = (self.first + k, self.block.name.clone());
                return Err(if determinant < -rounding {
                    MeshError::Inverted {
                        element,
                        block,
                        determinant,
                        at,
                    }
                } else {
                    MeshError::ZeroArea {
                        element,
                        block,
                        determinant,
                        at,
                    }
                });
            }
        }
        Ok(())
    }
}

fn determinant<const N: usize>(x: &[Point; N], gradients: &[[f64; 2]; N]) -> f64 {
    let mut jacobian = [[0.0; 2]; 2];
    for (point, gradient) in x.iter().zip(gradients) {
        for i in 0..2 {
            for j in 0..2 {
                jacobian[i][j] += (point[i] - x[0][i]) * gradient[j];
            }
        }
    }
    jacobian[0][0] * jacobian[1][1] - jacobian[0][1] * jacobian[1][0]
}

/// What the rounding of the coordinates alone can make of a vanishing determinant: each entry of J errs by ε·|x| and
/// multiplies an entry no larger than the cell.
fn rounding<const N: usize>(x: &[Point; N]) -> f64 {
    let (mut size, mut reach) = (0.0_f64, 0.0_f64);
    for i in 0..2 {
        for point in x {
            reach = reach.max(point[i].abs());
            size = size.max((point[i] - x[0][i]).abs());
        }
    }
    4.0 * f64::EPSILON * reach * size
}

/// Sets name only what exists, and nothing twice.
pub(super) fn sets(mesh: &Mesh) -> Result<(), MeshError> {
    let parts = &mesh.parts;
    for (set, members) in &parts.node_sets {
        let count = mesh.nodes().len();
        members_exist(
            "node",
            set,
            members,
            count,
            |&node| node < count,
            |node| format!("node {node}"),
        )?;
    }
    let count = mesh.element_count();
    for (set, members) in &parts.element_sets {
        members_exist(
            "element",
            set,
            members,
            count,
            |&cell| cell < count,
            |cell| format!("cell {cell}"),
        )?;
    }
    for (set, members) in &parts.edge_sets {
        let exists = |edge: &EdgeRef| {
            edge.element < count && edge.edge < mesh.element(edge.element).0.edges()
        };
        let named = |edge: &EdgeRef| format!("edge {} of cell {}", edge.edge, edge.element);
        members_exist("edge", set, &members.edges, count, exists, named)?;
    }
    Ok(())
}

fn members_exist<T: Ord>(
    family: &'static str,
    set: &str,
    members: &[T],
    count: usize,
    exists: impl Fn(&T) -> bool,
    named: impl Fn(&T) -> String,
) -> Result<(), MeshError> {
    let mut seen = BTreeSet::new();
    for member in members {
        let set = || set.to_owned();
        if !exists(member) {
            return Err(MeshError::SetOutOfRange {
                family,
                set: set(),
                what: named(member),
                count,
            });
        }
        if !seen.insert(member) {
            return Err(MeshError::DuplicateInSet {
                family,
                set: set(),
                what: named(member),
            });
        }
    }
    Ok(())
}
