//! Dense matrices and their products.
//!
//! Products are sequential, so the same input gives the same bits.

use std::ops::{Index, IndexMut};

use faer::linalg::matmul::matmul;
use faer::{Accum, Mat, MatRef, Par};

/// A dense real matrix, indexed by `(row, column)`.
///
/// Shapes are the caller's to match: an index out of range or a product of shapes that do not fit panics, as for slices.
///
/// ```
/// use stickslip_fem_core::linalg::Matrix;
///
/// let a = Matrix::from_fn(2, 3, |i, j| (3 * i + j) as f64);
/// assert_eq!(a.multiply_vector(&[1.0, 0.0, -1.0]), [-2.0, -2.0]);
/// assert_eq!(a.transpose_multiply(&a)[(0, 2)], 15.0);
/// ```
#[derive(Clone, Debug)]
pub struct Matrix(pub(super) Mat<f64>);

impl Matrix {
    /// Makes a `rows` × `columns` matrix of zeros.
    pub fn zeros(rows: usize, columns: usize) -> Self {
        Self(Mat::zeros(rows, columns))
    }

    /// Makes the identity matrix with `order` rows.
    pub fn identity(order: usize) -> Self {
        Self(Mat::identity(order, order))
    }

    /// Makes a `rows` × `columns` matrix from `entry(row, column)`, called column by column, in any unit.
    pub fn from_fn(rows: usize, columns: usize, entry: impl FnMut(usize, usize) -> f64) -> Self {
        Self(Mat::from_fn(rows, columns, entry))
    }

    /// Makes the matrix of one column with the entries `values`, in any unit.
    pub fn column(values: &[f64]) -> Self {
        Self::from_fn(values.len(), 1, |i, _| values[i])
    }

    /// Number of rows.
    pub fn rows(&self) -> usize {
        self.0.nrows()
    }

    /// Number of columns.
    pub fn columns(&self) -> usize {
        self.0.ncols()
    }

    /// Computes Aᵀ.
    #[must_use]
    pub fn transposed(&self) -> Self {
        Self(self.0.transpose().to_owned())
    }

    /// Computes the product A B, `other` being B with as many rows as A has columns.
    #[must_use]
    pub fn multiply(&self, other: &Self) -> Self {
        product(self.0.as_ref(), other.0.as_ref())
    }

    /// Computes the product Aᵀ B, `other` being B with as many rows as A.
    #[must_use]
    pub fn transpose_multiply(&self, other: &Self) -> Self {
        product(self.0.transpose(), other.0.as_ref())
    }

    /// Computes A x, in the unit of A times that of `x`, `x` having as many entries as A has columns.
    pub fn multiply_vector(&self, x: &[f64]) -> Vec<f64> {
        let x = MatRef::from_column_major_slice(x, x.len(), 1);
        product(self.0.as_ref(), x).to_row_major()
    }

    /// Computes the covariance A Σ Aᵀ of A x from the covariance Σ of x, symmetric to the last bit: the mean of the product and its
    /// transpose.
    #[must_use]
    pub fn propagate_covariance(&self, covariance: &Self) -> Self {
        let half = self.multiply(covariance);
        let full = product(half.0.as_ref(), self.0.transpose());
        Self::from_fn(full.rows(), full.columns(), |i, j| {
            f64::midpoint(full[(i, j)], full[(j, i)])
        })
    }

    /// Lists the entries row by row, in the unit of the matrix.
    pub fn to_row_major(&self) -> Vec<f64> {
        (0..self.rows())
            .flat_map(|i| (0..self.columns()).map(move |j| self[(i, j)]))
            .collect()
    }
}

impl Index<(usize, usize)> for Matrix {
    type Output = f64;

    fn index(&self, at: (usize, usize)) -> &f64 {
        &self.0[at]
    }
}

impl IndexMut<(usize, usize)> for Matrix {
    fn index_mut(&mut self, at: (usize, usize)) -> &mut f64 {
        &mut self.0[at]
    }
}

fn product(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Matrix {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a, b, 1.0, Par::Seq);
    Matrix(product)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(rows: usize, columns: usize) -> Matrix {
        Matrix::from_fn(rows, columns, |i, j| {
            f64::from(u8::try_from((5 * i + 3 * j) % 7).unwrap()) - 2.0
        })
    }

    #[test]
    fn products_are_sums_of_products() {
        let (a, b) = (sample(5, 9), sample(9, 4));
        let expected = Matrix::from_fn(5, 4, |i, j| (0..9).map(|k| a[(i, k)] * b[(k, j)]).sum())
            .to_row_major();
        // Small integers: every order of summation is exact.
        assert_eq!(a.multiply(&b).to_row_major(), expected);
        assert_eq!(
            a.transposed().transpose_multiply(&b).to_row_major(),
            expected
        );
        let column: Vec<f64> = (0..9).map(|k| b[(k, 1)]).collect();
        let second: Vec<f64> = (0..5).map(|i| expected[4 * i + 1]).collect();
        assert_eq!(a.multiply_vector(&column), second);
        assert_eq!(a.multiply(&Matrix::column(&column)).to_row_major(), second);
    }

    #[test]
    fn a_propagated_covariance_is_symmetric() {
        let (a, s) = (sample(6, 8), sample(8, 8));
        let covariance = s.transpose_multiply(&s);
        let own = a.propagate_covariance(&covariance);
        let direct = a.multiply(&covariance).multiply(&a.transposed());
        assert_eq!(own.to_row_major(), own.transposed().to_row_major());
        assert_eq!(own.to_row_major(), direct.to_row_major());
    }

    #[test]
    fn empty_matrices_multiply() {
        let product = Matrix::zeros(3, 0).multiply(&Matrix::zeros(0, 2));
        assert_eq!((product.rows(), product.columns()), (3, 2));
        assert!(product.to_row_major().iter().all(|&entry| entry == 0.0));
    }
}
