//! Dense least squares with many right-hand sides.
//!
//! ```text
//! min ‖A x − b‖,     A = Q T,  QᵀQ = 1,  T upper triangular,     x = T⁻¹ Qᵀ b
//! ```
//!
//! by block Gram–Schmidt, each block orthogonalised twice, which leaves Q orthonormal to rounding (Giraud, Langou & Rozložník 2005). Products
//! of blocks do nearly all of the work.

use nalgebra::DMatrix;

/// Columns that are orthogonalised together.
const BLOCK: usize = 16;
/// Part of a column's size below which what is left of it is rounding.
const DEPENDENT: f64 = 1e-13;

/// Solves min ‖A x − b‖ for each column b of `sides`. A column of A that depends on those before it gets no part.
pub(crate) fn least_squares(mut matrix: DMatrix<f64>, sides: &DMatrix<f64>) -> DMatrix<f64> {
    let (rows, columns) = matrix.shape();
    let mut triangle = DMatrix::zeros(columns, columns);
    let mut first = 0;
    while first < columns {
        let width = BLOCK.min(columns - first);
        let sizes: Vec<f64> = (0..width)
            .map(|k| matrix.column(first + k).norm())
            .collect();
        let mut own = DMatrix::identity(width, width);
        for _ in 0..2 {
            if first > 0 {
                let (before, mut block) =
                    matrix.columns_range_pair_mut(0..first, first..first + width);
                let parts = before.transpose() * &block;
                block.gemm(-1.0, &before, &parts, 1.0);
                let mut above = triangle.view_mut((0, first), (first, width));
                above.gemm(1.0, &parts, &own, 1.0);
            }
            own = orthonormalise(&mut matrix, first, &sizes) * own;
        }
        (triangle.view_mut((first, first), (width, width))).copy_from(&own);
        first += width;
    }
    let mut solution = matrix.rows(0, rows).transpose() * sides;
    for k in 0..columns {
        if triangle[(k, k)] == 0.0 {
            triangle[(k, k)] = 1.0;
            solution.row_mut(k).fill(0.0);
        }
    }
    // No pivot is zero.
    triangle.solve_upper_triangular_mut(&mut solution);
    solution
}

/// Makes the columns from `first` on, of the sizes `sizes` before all else, orthonormal among themselves; the triangle that turns them back.
fn orthonormalise(matrix: &mut DMatrix<f64>, first: usize, sizes: &[f64]) -> DMatrix<f64> {
    let width = sizes.len();
    let mut triangle = DMatrix::zeros(width, width);
    for k in 0..width {
        for j in 0..k {
            let (before, mut column) = matrix.columns_range_pair_mut(first + j, first + k);
            let part = before.dot(&column);
            column.axpy(-part, &before, 1.0);
            triangle[(j, k)] = part;
        }
        let mut column = matrix.column_mut(first + k);
        let norm = column.norm();
        if norm > DEPENDENT * sizes[k] {
            column.scale_mut(1.0 / norm);
            triangle[(k, k)] = norm;
        } else {
            column.fill(0.0);
        }
    }
    triangle
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solutions_leave_a_residual_normal_to_the_columns() {
        // Powers on 0 to 1: condition 1e9 at 13 columns, a dependent column and one of zeros.
        let mut matrix = DMatrix::from_fn(60, 40, |i, j| {
            (i as f64 / 59.0).powi(j as i32 % 13) + if j < 13 { 0.0 } else { (i * j) as f64 % 7.0 }
        });
        let copy = matrix.column(3).into_owned();
        matrix.set_column(20, &copy);
        matrix.column_mut(30).fill(0.0);
        let sides = DMatrix::from_fn(60, 3, |i, j| ((i + 1) * (j + 2)) as f64 % 5.0);
        let found = least_squares(matrix.clone(), &sides);
        assert!(found.row(20).amax() == 0.0 && found.row(30).amax() == 0.0);
        let residual = &sides - &matrix * &found;
        assert!((matrix.transpose() * residual).amax() < 1e-9 * found.amax().max(1.0));
    }

    #[test]
    fn exact_systems_are_solved() {
        let matrix = DMatrix::from_fn(50, 35, |i, j| {
            ((3 * i + 5 * j * j) % 11) as f64 - if i == j { 20.0 } else { 5.0 }
        });
        let exact = DMatrix::from_fn(35, 2, |i, j| i as f64 - 3.0 * j as f64);
        let found = least_squares(matrix.clone(), &(&matrix * &exact));
        assert!((found - exact).amax() < 1e-10);
    }
}
