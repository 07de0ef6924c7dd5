//! Dense matrices of a region's few outputs and boundary unknowns; sequential, so that the same input gives the same bits.

use faer::diag::Diag;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{
    LltError, LltRegularization, cholesky_in_place, cholesky_in_place_scratch,
};
use faer::linalg::evd::{ComputeEigenvectors, self_adjoint_evd, self_adjoint_evd_scratch};
use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::{
    solve_lower_triangular_in_place, solve_upper_triangular_in_place,
};
use faer::{Accum, Mat, MatRef, Par, Spec};

/// A · B.
pub(crate) fn multiply(a: MatRef<'_, f64>, b: MatRef<'_, f64>) -> Mat<f64> {
    let mut product = Mat::zeros(a.nrows(), b.ncols());
    matmul(product.as_mut(), Accum::Replace, a, b, 1.0, Par::Seq);
    product
}

/// T Σ Tᵀ, symmetric to the last bit.
pub(crate) fn sandwich(t: MatRef<'_, f64>, covariance: MatRef<'_, f64>) -> Mat<f64> {
    let half = multiply(t, covariance);
    let full = multiply(half.as_ref(), t.transpose());
    Mat::from_fn(full.nrows(), full.ncols(), |i, j| {
        f64::midpoint(full[(i, j)], full[(j, i)])
    })
}

/// The lower factor of a symmetric matrix; the row whose pivot is not positive if there is none.
pub(crate) fn cholesky(mut matrix: Mat<f64>) -> Result<Mat<f64>, usize> {
    let n = matrix.nrows();
    let mut memory = MemBuffer::new(cholesky_in_place_scratch::<f64>(
        n,
        Par::Seq,
        Spec::default(),
    ));
    cholesky_in_place(
        matrix.as_mut(),
        LltRegularization::default(),
        Par::Seq,
        MemStack::new(&mut memory),
        Spec::default(),
    )
    .map_err(|LltError::NonPositivePivot { index }| index)?;
    Ok(Mat::from_fn(n, n, |i, j| {
        if i >= j { matrix[(i, j)] } else { 0.0 }
    }))
}

/// Overwrites `x` with L⁻¹ x.
pub(crate) fn solve_lower(lower: &Mat<f64>, x: &mut Mat<f64>) {
    solve_lower_triangular_in_place(lower.as_ref(), x.as_mut(), Par::Seq);
}

/// Overwrites `x` with L⁻ᵀ x.
pub(crate) fn solve_lower_transposed(lower: &Mat<f64>, x: &mut Mat<f64>) {
    solve_upper_triangular_in_place(lower.transpose(), x.as_mut(), Par::Seq);
}

/// Eigenvalues, ascending, and eigenvectors of a symmetric matrix.
pub(crate) fn eigen(matrix: &Mat<f64>) -> Option<(Vec<f64>, Mat<f64>)> {
    let n = matrix.nrows();
    let mut values = Diag::zeros(n);
    let mut vectors = Mat::zeros(n, n);
    let mut memory = MemBuffer::new(self_adjoint_evd_scratch::<f64>(
        n,
        ComputeEigenvectors::Yes,
        Par::Seq,
        Spec::default(),
    ));
    self_adjoint_evd(
        matrix.as_ref(),
        values.as_mut(),
        Some(vectors.as_mut()),
        Par::Seq,
        MemStack::new(&mut memory),
        Spec::default(),
    )
    .ok()?;
    Some((values.column_vector().iter().copied().collect(), vectors))
}

/// The matrix row by row.
pub(crate) fn by_rows(matrix: &Mat<f64>) -> Vec<f64> {
    let rows = 0..matrix.nrows();
    rows.flat_map(|i| (0..matrix.ncols()).map(move |j| matrix[(i, j)]))
        .collect()
}
