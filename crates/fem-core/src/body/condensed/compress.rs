//! The compliance of many edges as blocks.
//!
//! With the unknowns ordered by regions, edge k has the columns L_kk and L_sk of the factor, and T is that of the separators:
//!
//! ```text
//! C_kl = δ_kl L_kk⁻ᵀ L_kk⁻¹ + X_kᵀ (T Tᵀ)⁻¹ X_l,     X_k = L_sk L_kk⁻¹ ≈ Q_k U_kᵀ,     Q_kᵀ Q_k = I
//! M_kl = (T⁻¹ Q_k)ᵀ (T⁻¹ Q_l)
//! ```
//!
//! Columns of Q_k are taken from X_k, the largest first, until no column of X_k − Q_k U_kᵀ has more than [`NEGLIGIBLE`] of the size of the
//! largest of X_k. X_k takes forces on the edge to forces on the separators around its region, which fade with the harmonic of the forces, so that few are left.

use nalgebra::{DMatrix, DVector};

use crate::body::regions::Regions;
use crate::interface::{Block, BlockCompliance};
use crate::linalg::{SparseCholesky, invert_from_cholesky};
use crate::parallel;

/// Part of the largest force that a unit force on an edge makes on the separators, below which it is left out.
pub(super) const NEGLIGIBLE: f64 = 1e-12;

impl Regions {
    /// The compliance of the edges by `factor`.
    pub(super) fn compliance(&self, factor: &SparseCholesky) -> BlockCompliance {
        let edges: Vec<Edge> = parallel::map(&self.edges, |rows| self.edge(factor, rows.clone()));
        let mut first = vec![0];
        for edge in &edges {
            first.push(first[first.len() - 1] + edge.shapes.ncols());
        }
        let total = first[edges.len()];
        let mut core = DMatrix::zeros(total, total);
        let mut blocks = Vec::with_capacity(edges.len());
        let between = parallel::map_range(0..edges.len(), |k| {
            let reach = edges[k].reach.transpose();
            let of = |other: &Edge| &reach * &other.reach;
            edges[..=k].iter().map(of).collect::<Vec<_>>()
        });
        let mut start = 0;
        for (k, (edge, mut row)) in edges.into_iter().zip(between).enumerate() {
            if let Some(own) = row.pop() {
                let mut added = &edge.shapes * (own * edge.shapes.transpose());
                added += &edge.own;
                added.fill_upper_triangle_with_lower_triangle();
                let rows = start..start + added.nrows();
                start = rows.end;
                blocks.push(Block {
                    rows: rows.collect(),
                    own: added,
                    shapes: edge.shapes,
                });
            }
            for (l, own) in row.into_iter().enumerate() {
                core.view_mut((first[l], first[k]), (own.ncols(), own.nrows()))
                    .copy_from(&own.transpose());
                core.view_mut((first[k], first[l]), own.shape())
                    .copy_from(&own);
            }
        }
        BlockCompliance::new(blocks, core)
    }

    fn edge(&self, factor: &SparseCholesky, rows: std::ops::Range<usize>) -> Edge {
        let separators = self.separators..factor.unknowns();
        let lower = factor.block(rows.clone(), rows.clone());
        let coupling = factor.block(separators.clone(), rows);
        let touched: Vec<usize> = (0..coupling.nrows())
            .filter(|&row| coupling.row(row).amax() > 0.0)
            .collect();
        // Of each row x of X, L_kkᵀ xᵀ is that of L_sk.
        let mut passed = coupling.select_rows(&touched).transpose();
        lower.tr_solve_lower_triangular_mut(&mut passed);
        let (basis, shapes) = main_directions(passed.transpose());
        let mut reach = DMatrix::zeros(separators.len(), basis.ncols());
        for (k, &row) in touched.iter().enumerate() {
            reach.row_mut(row).copy_from(&basis.row(k));
        }
        factor.solve_trailing(self.separators, &mut reach);
        Edge {
            own: invert_from_cholesky(&lower),
            shapes,
            reach,
        }
    }
}

/// An edge with its separators held, and what its forces do to these.
struct Edge {
    own: DMatrix<f64>,
    shapes: DMatrix<f64>,
    /// T⁻¹ Q.
    reach: DMatrix<f64>,
}

/// Q and U with X ≈ Q Uᵀ: orthonormal columns from the largest remaining columns of X, and what of X they hold.
fn main_directions(matrix: DMatrix<f64>) -> (DMatrix<f64>, DMatrix<f64>) {
    let mut left = matrix;
    let mut basis: Vec<DVector<f64>> = Vec::new();
    let mut shapes: Vec<DVector<f64>> = Vec::new();
    let mut scale = None;
    for _ in 0..left.nrows().min(left.ncols()) {
        let largest = (left.column_iter().enumerate())
            .map(|(index, column)| (index, column.norm()))
            .max_by(|a, b| a.1.total_cmp(&b.1));
        let Some((index, size)) = largest else { break };
        if size <= NEGLIGIBLE * *scale.get_or_insert(size) {
            break;
        }
        let mut direction = left.column(index).into_owned();
        for known in &basis {
            let along = known.dot(&direction);
            direction.axpy(-along, known, 1.0);
        }
        direction.normalize_mut();
        let shape = left.tr_mul(&direction);
        left.ger(-1.0, &direction, &shape, 1.0);
        basis.push(direction);
        shapes.push(shape);
    }
    let columns = |own: &[DVector<f64>], rows: usize| {
        if own.is_empty() {
            DMatrix::zeros(rows, 0)
        } else {
            DMatrix::from_columns(own)
        }
    };
    (
        columns(&basis, left.nrows()),
        columns(&shapes, left.ncols()),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn main_directions_hold_a_matrix_of_low_rank() {
        // Σ 10⁻³ᵏ a_k b_kᵀ: what is left after six terms is below the part that is left out.
        let matrix = DMatrix::from_fn(9, 14, |i, j| {
            (0..8)
                .map(|k| {
                    let wave = f64::from(k);
                    1e-3_f64.powi(k)
                        * ((i + 1) as f64 * (wave + 1.0)).sin()
                        * (j as f64 * (wave + 2.0)).cos()
                })
                .sum()
        });
        let (basis, shapes) = main_directions(matrix.clone());
        assert!((3..=6).contains(&basis.ncols()), "{}", basis.ncols());
        let left = &matrix - &basis * shapes.transpose();
        assert!(left.amax() <= 2.0 * NEGLIGIBLE * matrix.amax() * 3.0);
        let gram = basis.transpose() * &basis;
        assert!((gram - DMatrix::identity(basis.ncols(), basis.ncols())).amax() < 1e-12);
    }
}
