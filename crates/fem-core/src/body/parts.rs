//! Parts of a mesh that share no node with each other.
//!
//! Rounding hides a part that floats: the pivot that should vanish comes out as ±10⁻¹¹ of the others, so the factorisation
//! cannot be trusted to find it. Three rigid motions per part can.

use nalgebra::{Matrix3, Vector3};

use super::constraints::NodeConstraint;
use super::elastic::ElasticBody;
use super::error::BodyError;
use crate::mesh::Mesh;

/// Refuses a part of `body` with a rigid motion that neither `constraints` nor springs prevent.
pub(super) fn check_parts(
    body: &ElasticBody,
    adjacency: &[Vec<u32>],
    constraints: &[NodeConstraint],
) -> Result<(), BodyError> {
    let mut resisted: Vec<Vec<[f64; 2]>> = constraints.iter().map(NodeConstraint::holds).collect();
    for (node, direction) in body.sprung() {
        resisted[node].push(direction);
    }
    let mut seen = vec![false; adjacency.len()];
    let (mut parts, mut loose) = (0, None);
    for first in 0..adjacency.len() {
        if std::mem::replace(&mut seen[first], true) {
            continue;
        }
        let mut part = vec![first];
        let mut next = 0;
        while next < part.len() {
            for &neighbour in &adjacency[part[next]] {
                if !std::mem::replace(&mut seen[neighbour as usize], true) {
                    part.push(neighbour as usize);
                }
            }
            next += 1;
        }
        parts += 1;
        if loose.is_none() {
            let motions = free_motions(&body.mesh, &part, &resisted);
            loose = (motions > 0).then_some((first, motions));
        }
    }
    match loose {
        None => Ok(()),
        Some((node, motions)) => Err(BodyError::LoosePart {
            node,
            at: body.mesh.nodes()[node],
            parts,
            motions,
        }),
    }
}

/// Number of rigid motions of the nodes `part` that are left free by the unit vectors along which the motion of each node is resisted.
fn free_motions(mesh: &Mesh, part: &[usize], resisted: &[Vec<[f64; 2]>]) -> usize {
    let centre = mesh.nodes()[part[0]];
    let arm = |node: usize| [0, 1].map(|i| mesh.nodes()[node][i] - centre[i]);
    let length = part.iter().fold(f64::MIN_POSITIVE, |length, &node| {
        let [x, y] = arm(node);
        length.max(x.hypot(y))
    });
    let mut gram = Matrix3::zeros();
    for &node in part {
        let [x, y] = arm(node);
        for [dx, dy] in &resisted[node] {
            let row = Vector3::new(*dx, *dy, (x * dy - y * dx) / length);
            gram += row * row.transpose();
        }
    }
    let eigenvalues = gram.symmetric_eigenvalues();
    let scale = gram.trace();
    eigenvalues
        .iter()
        .filter(|&&value| value <= 1e-12 * scale)
        .count()
}
