//! A finite-element solution with prescribed displacements: the data that recovery sees in practice.

use faer::prelude::*;
use faer::sparse::{SparseColMat, Triplet};
use faer::{Mat, Side};
use stickslip_fem_core::element::{Element, KindVisitor, gather, stiffness, with_element};
use stickslip_fem_core::material::PlaneStiffness;
use stickslip_fem_core::mesh::{Mesh, Point};

/// Displacement (interleaved) of a body of one block without load, with `prescribed(place)` giving the imposed components.
pub(crate) fn solved(
    mesh: &Mesh,
    d: &PlaneStiffness,
    prescribed: impl Fn(Point) -> [Option<f64>; 2],
) -> Vec<f64> {
    let given: Vec<Option<f64>> = mesh.nodes().iter().flat_map(|&p| prescribed(p)).collect();
    let entries = with_element(mesh.blocks()[0].kind, Entries { mesh, d });
    let mut load = Mat::zeros(given.len(), 1);
    let mut free = Vec::new();
    for Triplet { row, col, val } in entries {
        match (given[row], given[col]) {
            (None, None) => free.push(Triplet::new(row, col, val)),
            (None, Some(u)) => load[(row, 0)] -= val * u,
            _ => {}
        }
    }
    for (dof, given) in given.iter().enumerate() {
        if let Some(u) = given {
            free.push(Triplet::new(dof, dof, d[0][0]));
            load[(dof, 0)] = u * d[0][0];
        }
    }
    let matrix = SparseColMat::try_new_from_triplets(given.len(), given.len(), &free).unwrap();
    let solution = matrix.sp_cholesky(Side::Lower).unwrap().solve(&load);
    (0..given.len()).map(|dof| solution[(dof, 0)]).collect()
}

struct Entries<'a> {
    mesh: &'a Mesh,
    d: &'a PlaneStiffness,
}

impl KindVisitor for Entries<'_> {
    type Output = Vec<Triplet<usize, usize, f64>>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        let mut entries = Vec::new();
        let mut k = vec![0.0; 4 * N * N];
        for nodes in self.mesh.blocks()[0].connectivity.chunks_exact(N) {
            stiffness::<N, E>(&gather(self.mesh.nodes(), nodes), self.d, 1.0, &mut k);
            let dofs: Vec<usize> = nodes.iter().flat_map(|n| [2 * n, 2 * n + 1]).collect();
            for (i, &row) in dofs.iter().enumerate() {
                for (j, &col) in dofs.iter().enumerate() {
                    entries.push(Triplet::new(row, col, k[i * 2 * N + j]));
                }
            }
        }
        entries
    }
}
