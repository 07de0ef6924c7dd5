//! Dense algebra on whole bodies, entry by entry: what condensation must equal.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::element::{Element, KindVisitor, gather, stiffness, with_element};
use stickslip_fem_core::material::PlaneStiffness;
use stickslip_fem_core::mesh::Point;

/// Stiffness matrix of a body without supports, 2 × nodes.
pub(crate) fn stiffness_matrix(body: &ElasticBody) -> DMatrix<f64> {
    let size = 2 * body.mesh().nodes().len();
    let mut matrix = DMatrix::zeros(size, size);
    for (block, material) in body.materials().iter().enumerate() {
        let stiffness = material.stiffness();
        let add = Add {
            body,
            block,
            stiffness,
            matrix: &mut matrix,
        };
        with_element(body.mesh().blocks()[block].kind, add);
    }
    matrix
}

struct Add<'a> {
    body: &'a ElasticBody,
    block: usize,
    stiffness: PlaneStiffness,
    matrix: &'a mut DMatrix<f64>,
}

impl KindVisitor for Add<'_> {
    type Output = ();

    fn visit<const N: usize, E: Element<N>>(self) {
        let mut local = vec![0.0; 4 * N * N];
        let mesh = self.body.mesh();
        for cell in mesh.blocks()[self.block].connectivity.chunks_exact(N) {
            let x = gather::<N>(mesh.nodes(), cell);
            stiffness::<N, E>(&x, &self.stiffness, self.body.thickness(), &mut local);
            let unknown = |row: usize| 2 * cell[row / 2] + row % 2;
            for row in 0..2 * N {
                for column in 0..2 * N {
                    self.matrix[(unknown(row), unknown(column))] += local[row * 2 * N + column];
                }
            }
        }
    }
}

/// Both unknowns of each node.
pub(crate) fn unknowns(nodes: &[usize]) -> Vec<usize> {
    nodes
        .iter()
        .flat_map(|&node| [2 * node, 2 * node + 1])
        .collect()
}

/// The matrix's rows `rows` and columns `columns`.
pub(crate) fn part(matrix: &DMatrix<f64>, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
    DMatrix::from_fn(rows.len(), columns.len(), |i, j| {
        matrix[(rows[i], columns[j])]
    })
}

/// S = K_cc − K_ci K_ii⁻¹ K_ic for the unknowns `kept`, when `held` are held at zero.
pub(crate) fn schur_complement(
    matrix: &DMatrix<f64>,
    kept: &[usize],
    held: &[usize],
) -> DMatrix<f64> {
    let rest: Vec<usize> = (0..matrix.nrows())
        .filter(|unknown| !kept.contains(unknown) && !held.contains(unknown))
        .collect();
    let inner = part(matrix, &rest, &rest)
        .lu()
        .solve(&part(matrix, &rest, kept))
        .unwrap();
    part(matrix, kept, kept) - part(matrix, kept, &rest) * inner
}

/// Displacements of all unknowns under `forces` with the unknowns in `held` at the given values.
pub(crate) fn solve(
    matrix: &DMatrix<f64>,
    forces: &DVector<f64>,
    held: &[(usize, f64)],
) -> DVector<f64> {
    let mut solution = DVector::zeros(matrix.nrows());
    for &(unknown, value) in held {
        solution[unknown] = value;
    }
    let free: Vec<usize> = (0..matrix.nrows())
        .filter(|unknown| held.iter().all(|(other, _)| other != unknown))
        .collect();
    let side = forces - matrix * &solution;
    let side = DVector::from_iterator(free.len(), free.iter().map(|&k| side[k]));
    let inner = part(matrix, &free, &free).lu().solve(&side).unwrap();
    for (&k, &value) in free.iter().zip(inner.iter()) {
        solution[k] = value;
    }
    solution
}

/// Translations and the turn about the origin at each point, 2n × 3.
pub(crate) fn rigid_motions(points: &[Point]) -> DMatrix<f64> {
    DMatrix::from_fn(2 * points.len(), 3, |row, motion| {
        let [x, y] = points[row / 2];
        match (motion, row % 2) {
            (0, 0) | (1, 1) => 1.0,
            (2, 0) => -y,
            (2, 1) => x,
            _ => 0.0,
        }
    })
}

/// The part of `u` orthogonal to the columns of `motions`.
pub(crate) fn without(motions: &DMatrix<f64>, u: &DVector<f64>) -> DVector<f64> {
    let basis = motions.clone().qr().q();
    u - &basis * (basis.transpose() * u)
}

/// Force along x, force along y and moment about the origin of nodal forces at `points`.
pub(crate) fn resultants(points: &[Point], forces: &[f64]) -> [f64; 3] {
    let mut sums = [0.0; 3];
    for ([x, y], force) in points.iter().zip(forces.chunks_exact(2)) {
        sums[0] += force[0];
        sums[1] += force[1];
        sums[2] += x * force[1] - y * force[0];
    }
    sums
}

/// Largest magnitude.
pub(crate) fn largest<'a>(values: impl IntoIterator<Item = &'a f64>) -> f64 {
    values.into_iter().fold(0.0, |m, v| m.max(v.abs()))
}
