//! A finite-element solution with prescribed displacements: the data that recovery sees in practice.

use std::collections::BTreeMap;

use stickslip_fem_core::element::{Element, KindVisitor, gather, stiffness, with_element};
use stickslip_fem_core::linalg::{LuStructure, SparseLu, SparseMatrix};
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
    let mut load = vec![0.0; given.len()];
    let mut columns = vec![BTreeMap::new(); given.len()];
    for (row, column, value) in entries {
        match (given[row], given[column]) {
            (None, None) => *columns[column].entry(row).or_insert(0.0) += value,
            (None, Some(u)) => load[row] -= value * u,
            _ => {}
        }
    }
    for (dof, given) in given.iter().enumerate() {
        if let Some(u) = given {
            columns[dof].insert(dof, d[0][0]);
            load[dof] = u * d[0][0];
        }
    }
    let mut matrix = SparseMatrix {
        column_start: vec![0],
        ..SparseMatrix::default()
    };
    for column in columns {
        matrix.rows.extend(column.keys());
        matrix.values.extend(column.values());
        matrix.column_start.push(matrix.rows.len());
    }
    let structure = LuStructure::analyse(&matrix).unwrap();
    SparseLu::factorise(&structure, &matrix)
        .unwrap()
        .solve(&mut load);
    load
}

struct Entries<'a> {
    mesh: &'a Mesh,
    d: &'a PlaneStiffness,
}

impl KindVisitor for Entries<'_> {
    type Output = Vec<(usize, usize, f64)>;

    fn visit<const N: usize, E: Element<N>>(self) -> Self::Output {
        let mut entries = Vec::new();
        let mut k = vec![0.0; 4 * N * N];
        for nodes in self.mesh.blocks()[0].connectivity.chunks_exact(N) {
            stiffness::<N, E>(&gather(self.mesh.nodes(), nodes), self.d, 1.0, &mut k);
            let dofs: Vec<usize> = nodes.iter().flat_map(|n| [2 * n, 2 * n + 1]).collect();
            for (i, &row) in dofs.iter().enumerate() {
                for (j, &col) in dofs.iter().enumerate() {
                    entries.push((row, col, k[i * 2 * N + j]));
                }
            }
        }
        entries
    }
}
