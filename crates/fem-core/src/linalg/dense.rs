//! Dense factorisations on column-major matrices.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::{cholesky, lu, triangular_solve};
use faer::{Conj, MatMut, MatRef, Par};
use nalgebra::{DMatrix, DVector};
use thiserror::Error;

/// A dense matrix has no inverse within rounding.
#[derive(Clone, Copy, Debug, Error, PartialEq)]
#[error("a dense {order} × {order} matrix is singular (pivot ratio {pivot_ratio:.1e})")]
pub struct SingularMatrix {
    /// Number of rows.
    pub order: usize,
    /// Smallest over largest magnitude of the pivots `[1]`.
    pub pivot_ratio: f64,
}

fn view(matrix: &DMatrix<f64>) -> MatRef<'_, f64> {
    MatRef::from_column_major_slice(matrix.as_slice(), matrix.nrows(), matrix.ncols())
}

fn view_mut(matrix: &mut DMatrix<f64>) -> MatMut<'_, f64> {
    let (rows, columns) = matrix.shape();
    MatMut::from_column_major_slice_mut(matrix.as_mut_slice(), rows, columns)
}

fn column(x: &mut DVector<f64>) -> MatMut<'_, f64> {
    let n = x.len();
    MatMut::from_column_major_slice_mut(x.as_mut_slice(), n, 1)
}

/// Computes (L Lᵀ)⁻¹, n × n, both triangles, from the lower triangle of L, n × n; what stands above it is ignored. In the inverse of the unit of L Lᵀ.
pub fn invert_from_cholesky(lower: &DMatrix<f64>) -> DMatrix<f64> {
    let n = lower.nrows();
    let mut inverse = DMatrix::zeros(n, n);
    let mut memory = MemBuffer::new(cholesky::llt::inverse::inverse_scratch::<f64>(n, Par::Seq));
    cholesky::llt::inverse::inverse(
        view_mut(&mut inverse),
        view(lower),
        Par::Seq,
        MemStack::new(&mut memory),
    );
    inverse.fill_upper_triangle_with_lower_triangle();
    inverse
}

/// Overwrites `x`, n entries, with L⁻¹ x, in any units; of `lower`, n × n, only the lower triangle is read.
pub fn solve_lower(lower: &DMatrix<f64>, x: &mut DVector<f64>) {
    triangular_solve::solve_lower_triangular_in_place(view(lower), column(x), Par::Seq);
}

/// Overwrites `x`, n entries, with L⁻ᵀ x, in any units; of `lower`, n × n, only the lower triangle is read.
pub fn solve_lower_transposed(lower: &DMatrix<f64>, x: &mut DVector<f64>) {
    triangular_solve::solve_upper_triangular_in_place(view(lower).transpose(), column(x), Par::Seq);
}

/// `P A = L U` of a dense square matrix, with partial pivoting.
#[derive(Clone, Debug)]
pub struct DenseLu {
    factors: DMatrix<f64>,
    forward: Vec<usize>,
    inverse: Vec<usize>,
}

impl DenseLu {
    /// Factorises the square matrix `matrix`, in any unit.
    ///
    /// # Errors
    /// [`SingularMatrix`] if a pivot vanishes beside the largest one (ratio below 1e-15), or is not a number.
    pub fn new(mut matrix: DMatrix<f64>) -> Result<Self, SingularMatrix> {
        let n = matrix.nrows();
        let (mut forward, mut inverse) = (vec![0_usize; n], vec![0_usize; n]);
        if n > 0 {
            let mut memory = MemBuffer::new(lu::partial_pivoting::factor::lu_in_place_scratch::<
                usize,
                f64,
            >(n, n, Par::Seq, faer::Spec::default()));
            lu::partial_pivoting::factor::lu_in_place(
                view_mut(&mut matrix),
                &mut forward,
                &mut inverse,
                Par::Seq,
                MemStack::new(&mut memory),
                faer::Spec::default(),
            );
        }
        let pivots = || (0..n).map(|k| matrix[(k, k)].abs());
        let (low, high) = (
            pivots().fold(f64::INFINITY, f64::min),
            pivots().fold(0.0, f64::max),
        );
        let finite = matrix.iter().all(|value| value.is_finite());
        if n > 0 && !(finite && low > 1e-15 * high) {
            return Err(SingularMatrix {
                order: n,
                pivot_ratio: if finite { low / high } else { f64::NAN },
            });
        }
        Ok(Self {
            factors: matrix,
            forward,
            inverse,
        })
    }

    /// Overwrites `x`, one entry per row of A, with A⁻¹ x, in any units.
    pub fn solve(&self, x: &mut DVector<f64>) {
        let n = self.factors.nrows();
        if n == 0 {
            return;
        }
        // The two arrays come from the factorisation above, so they are inverse permutations of each other.
        let permutation = faer::perm::PermRef::new_checked(&self.forward, &self.inverse, n);
        let mut memory = MemBuffer::new(lu::partial_pivoting::solve::solve_in_place_scratch::<
            usize,
            f64,
        >(n, 1, Par::Seq));
        let factors = view(&self.factors);
        lu::partial_pivoting::solve::solve_in_place_with_conj(
            factors,
            factors,
            permutation,
            Conj::No,
            column(x),
            Par::Seq,
            MemStack::new(&mut memory),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sample(n: usize) -> DMatrix<f64> {
        DMatrix::from_fn(n, n, |i, j| {
            ((i * 7 + j * 13) % 11) as f64 / 3.0 - 1.5 + if i == j { 9.0 } else { 0.0 }
        })
    }

    #[test]
    fn lu_solves() {
        for n in [0, 1, 3, 40, 130] {
            let matrix = sample(n);
            let expected = DVector::from_fn(n, |i, _| i as f64 - 1.0);
            let mut x = &matrix * &expected;
            DenseLu::new(matrix).unwrap().solve(&mut x);
            assert!((x - expected).amax() < 1e-10 || n == 0);
        }
    }

    #[test]
    fn a_singular_matrix_is_refused() {
        let refused = DenseLu::new(DMatrix::from_element(3, 3, 1.0));
        assert!(matches!(refused, Err(SingularMatrix { order: 3, .. })));
    }

    #[test]
    fn inverts_from_the_cholesky_factor() {
        let a = sample(20);
        let spd = &a * a.transpose();
        let lower = nalgebra::Cholesky::new(spd.clone()).unwrap().l();
        assert!((invert_from_cholesky(&lower) * spd - DMatrix::identity(20, 20)).amax() < 1e-9);
    }
}
