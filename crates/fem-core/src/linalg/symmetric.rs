//! Factorisations of dense symmetric matrices.
//!
//! ```text
//! A = L Lᵀ  (positive definite),     A = Q diag(λ) Qᵀ
//! ```
//!
//! Both read the lower triangle of A only, and are sequential, so the same input gives the same bits.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::{Par, Spec};
use thiserror::Error;

use super::Matrix;

/// A dense symmetric matrix is not positive definite within rounding.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("a dense symmetric matrix is not positive definite (pivot of row {row})")]
pub struct NotPositiveDefinite {
    /// First row whose pivot is not positive.
    pub row: usize,
}

/// The eigenvalues of a matrix were not found.
#[derive(Clone, Copy, Debug, Error, PartialEq, Eq)]
#[error("the eigenvalues of a {order} × {order} matrix were not found")]
pub struct NoEigenvalues {
    /// Number of rows.
    pub order: usize,
}

/// `A = L Lᵀ` of a dense symmetric positive definite matrix.
///
/// ```
/// use stickslip_fem_core::linalg::{DenseCholesky, Matrix, NotPositiveDefinite};
///
/// let a = Matrix::from_fn(2, 2, |i, j| if i == j { 5.0 } else { 4.0 });
/// let mut x = Matrix::column(&[1.0, -1.0]);
/// let factor = DenseCholesky::new(a)?;
/// factor.solve_lower(&mut x);
/// factor.solve_lower_transposed(&mut x);
/// assert!((x[(0, 0)] - 1.0).abs() < 1e-15 && (x[(1, 0)] + 1.0).abs() < 1e-15);
/// # Ok::<(), NotPositiveDefinite>(())
/// ```
#[derive(Clone, Debug)]
pub struct DenseCholesky {
    lower: Matrix,
}

impl DenseCholesky {
    /// Factorises the square matrix `matrix`, in any unit, whose upper triangle is ignored.
    ///
    /// # Errors
    /// [`NotPositiveDefinite`] with the first row whose pivot is not positive.
    pub fn new(matrix: Matrix) -> Result<Self, NotPositiveDefinite> {
        let mut matrix = matrix.0;
        let n = matrix.nrows();
        let scratch = cholesky_in_place_scratch::<f64>(n, Par::Seq, Spec::default());
        let mut memory = MemBuffer::new(scratch);
        cholesky_in_place(
            matrix.as_mut(),
            LltRegularization::default(),
            Par::Seq,
            MemStack::new(&mut memory),
            Spec::default(),
        )
        .map_err(|LltError::NonPositivePivot { index }| NotPositiveDefinite { row: index })?;
        let lower = Matrix::from_fn(n, n, |i, j| if i >= j { matrix[(i, j)] } else { 0.0 });
        Ok(Self { lower })
    }

    /// The factor L, with zeros above its diagonal, in the root of the unit of A.
    pub fn lower(&self) -> &Matrix {
        &self.lower
    }

    /// Overwrites each column x of `columns` with L⁻¹ x, in any units.
    pub fn solve_lower(&self, columns: &mut Matrix) {
        solve_lower_triangular_in_place(self.lower.0.as_ref(), columns.0.as_mut(), Par::Seq);
    }

    /// Overwrites each column x of `columns` with L⁻ᵀ x, in any units.
    pub fn solve_lower_transposed(&self, columns: &mut Matrix) {
        solve_upper_triangular_in_place(self.lower.0.transpose(), columns.0.as_mut(), Par::Seq);
    }

    /// Computes L⁻¹ x, in the unit of x over that of L, for a vector `x` with as many entries as A has rows.
    pub fn whiten(&self, x: &[f64]) -> Vec<f64> {
        let mut column = Matrix::column(x);
        self.solve_lower(&mut column);
        column.to_row_major()
    }

    /// Computes the inverse A⁻¹ = L⁻ᵀ L⁻¹, both triangles, in the inverse of the unit of A.
    pub fn inverse(&self) -> Matrix {
        let mut half = Matrix::identity(self.lower.rows());
        self.solve_lower(&mut half);
        half.transpose_multiply(&half)
    }
}

/// `A = Q diag(λ) Qᵀ` of a dense symmetric matrix.
#[derive(Clone, Debug)]
pub struct SymmetricEigen {
    /// Eigenvalues λ, ascending, in the unit of A.
    pub values: Vec<f64>,
    /// Orthonormal eigenvectors `[1]`, the columns of Q, in the order of the values.
    pub vectors: Matrix,
}

impl SymmetricEigen {
    /// Decomposes the square matrix `matrix`, in any unit, whose upper triangle is ignored.
    ///
    /// # Errors
    /// [`NoEigenvalues`] if the iteration does not converge, as for entries that are not finite.
    pub fn new(matrix: &Matrix) -> Result<Self, NoEigenvalues> {
        let n = matrix.rows();
        let mut values = Diag::zeros(n);
        let mut vectors = Matrix::zeros(n, n);
        let with_vectors = ComputeEigenvectors::Yes;
        let scratch = self_adjoint_evd_scratch::<f64>(n, with_vectors, Par::Seq, Spec::default());
        let mut memory = MemBuffer::new(scratch);
        self_adjoint_evd(
            matrix.0.as_ref(),
            values.as_mut(),
            Some(vectors.0.as_mut()),
            Par::Seq,
            MemStack::new(&mut memory),
            Spec::default(),
        )
        .map_err(|_| NoEigenvalues { order: n })?;
        let values: Vec<f64> = values.column_vector().iter().copied().collect();
        if values.iter().all(|value| value.is_finite()) {
            Ok(Self { values, vectors })
        } else {
            Err(NoEigenvalues { order: n })
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(n: usize) -> Matrix {
        let half = Matrix::from_fn(n, n, |i, j| {
            f64::from(u8::try_from((5 * i + 3 * j) % 7).unwrap()) - 2.0
        });
        let gram = half.transpose_multiply(&half);
        Matrix::from_fn(n, n, |i, j| gram[(i, j)] + if i == j { 1.0 } else { 0.0 })
    }

    fn difference(a: &Matrix, b: &Matrix) -> f64 {
        let pairs = a.to_row_major().into_iter().zip(b.to_row_major());
        pairs.fold(0.0, |largest: f64, (a, b)| largest.max((a - b).abs()))
    }

    #[test]
    fn a_factor_multiplies_out_and_inverts() {
        for n in [0, 1, 2, 17, 60] {
            let a = sample(n);
            let factor = DenseCholesky::new(a.clone()).unwrap();
            let product = factor.lower().multiply(&factor.lower().transposed());
            // Entries reach 10 n; rounding of n products each.
            assert!(difference(&product, &a) < 1e-13 * (1 + n * n) as f64);
            let one = a.multiply(&factor.inverse());
            assert!(difference(&one, &Matrix::identity(n)) < 1e-10);
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused_with_its_row() {
        let mut a = sample(4);
        a[(2, 2)] = -1.0;
        assert_eq!(
            DenseCholesky::new(a).unwrap_err(),
            NotPositiveDefinite { row: 2 }
        );
    }

    #[test]
    fn eigenvectors_turn_the_matrix_into_its_values() {
        let a = sample(12);
        let SymmetricEigen { values, vectors } = SymmetricEigen::new(&a).unwrap();
        assert!(values.is_sorted());
        let turned = vectors.transpose_multiply(&a.multiply(&vectors));
        let diagonal = Matrix::from_fn(12, 12, |i, j| if i == j { values[i] } else { 0.0 });
        assert!(difference(&turned, &diagonal) < 1e-11);
    }

    #[test]
    fn a_matrix_of_no_numbers_has_no_eigenvalues() {
        let refused = SymmetricEigen::new(&Matrix::from_fn(3, 3, |_, _| f64::NAN));
        assert_eq!(refused.unwrap_err(), NoEigenvalues { order: 3 });
    }
}
