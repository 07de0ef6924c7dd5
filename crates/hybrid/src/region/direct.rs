//! Direct interpolation: measured displacements at all nodes, differentiated by the elements alone.
//!
//! ```text
//! y = A Δ,     Σ_y = A Σ Aᵀ,     r = K Δ at the nodes inside
//! ```
//!
//! Nothing is assumed of equilibrium, so strains hold also where the material does not stay elastic; how far the forces r stay from
//! zero shows how far data and elements are from balance.
//!
//! Source: Post & Reddy (1988), part I, 4.1.

use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::{SparseRow, internal_forces};
use stickslip_fem_core::linalg::Matrix;

use super::outline::boundary_nodes;
use super::transfer::Propagated;
use super::{RegionError, check_rows, positions, submatrix};
use crate::data::NodalDisplacements;

/// Outputs with rows `outputs` of the measured displacements themselves, which must be there for every node that the rows touch.
///
/// # Errors
/// As [`Region::propagate`](super::Region::propagate).
pub fn interpolate(
    body: &ElasticBody,
    outputs: &[SparseRow],
    measured: &NodalDisplacements,
) -> Result<Propagated, RegionError> {
    check_rows(body.mesh(), outputs)?;
    let mut dofs: Vec<usize> = outputs.iter().flatten().map(|&(dof, _)| dof).collect();
    dofs.sort_unstable();
    dofs.dedup();
    let positions = positions(measured, body.mesh(), &dofs)?;
    let covariance = submatrix(measured, &positions)?;
    let mut rows = Matrix::zeros(outputs.len(), dofs.len());
    let mut values = vec![0.0; outputs.len()];
    for (i, row) in outputs.iter().enumerate() {
        for (dof, weight) in row {
            // Every degree of freedom of a row is in the list.
            let j = dofs.partition_point(|other| other < dof);
            rows[(i, j)] += weight;
            values[i] += weight * measured.values[positions[j]];
        }
    }
    Ok(Propagated {
        values,
        covariance: rows.propagate_covariance(&covariance).to_row_major(),
        solves: 0,
    })
}

/// Nodes inside the body with the forces `[force]` that would hold the measured displacements of all nodes; in balance they vanish.
///
/// # Errors
/// As [`Region::solve`](super::Region::solve), with every node of the mesh needed.
pub fn unbalanced_forces(
    body: &ElasticBody,
    measured: &NodalDisplacements,
) -> Result<Vec<(usize, [f64; 2])>, RegionError> {
    let nodes = body.mesh().nodes().len();
    let dofs: Vec<usize> = (0..2 * nodes).collect();
    let positions = positions(measured, body.mesh(), &dofs)?;
    let u: Vec<f64> = positions.iter().map(|&k| measured.values[k]).collect();
    let forces = internal_forces(body, &u);
    let boundary = boundary_nodes(body.mesh());
    Ok((0..nodes)
        .filter(|node| boundary.binary_search(node).is_err())
        .map(|node| (node, [forces[2 * node], forces[2 * node + 1]]))
        .collect())
}
