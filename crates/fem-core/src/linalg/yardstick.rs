//! The ordinary factorisation that benches compare with; no body is factorised by it.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::{LltError, LltRegularization};
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymmetricOrdering, factorize_symbolic_cholesky,
};
use faer::{Par, Side};

use super::{FactorError, LowerMatrix};

/// One ordinary sparse Cholesky factorisation, symbolic and numeric, with faer's own minimum-degree order and defaults:
/// the yardstick of the benches. Returns the number of stored entries of the factor. Without the feature `parallel` it takes one
/// thread, whatever `threads`.
///
/// # Errors
/// As [`SparseCholesky::factorise`](super::SparseCholesky::factorise).
pub fn reference_factorisation(matrix: &LowerMatrix, threads: usize) -> Result<usize, FactorError> {
    let n = matrix.order();
    let too_large = || FactorError::TooLarge { unknowns: n };
    let par = parallelism(threads);
    let symbolic = factorize_symbolic_cholesky(
        matrix.pattern(),
        Side::Lower,
        SymmetricOrdering::Amd,
        CholeskySymbolicParams::default(),
    )
    .map_err(|_| too_large())?;
    let mut values = vec![0.0; symbolic.len_val()];
    let request = symbolic.factorize_numeric_llt_scratch::<f64>(par, faer::Spec::default());
    let mut memory = MemBuffer::try_new(request).map_err(|_| too_large())?;
    symbolic
        .factorize_numeric_llt(
            &mut values,
            SparseColMatRef::new(matrix.pattern(), &matrix.values),
            Side::Lower,
            LltRegularization::default(),
            par,
            MemStack::new(&mut memory),
            faer::Spec::default(),
        )
        .map_err(
            |LltError::NonPositivePivot { index }| FactorError::NotPositiveDefinite {
                unknown: index,
            },
        )?;
    Ok(values.len())
}

#[cfg(feature = "parallel")]
fn parallelism(threads: usize) -> Par {
    if threads > 1 {
        Par::rayon(threads)
    } else {
        Par::Seq
    }
}

#[cfg(not(feature = "parallel"))]
fn parallelism(_threads: usize) -> Par {
    Par::Seq
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn it_factorises_an_arrow() {
        let n = 40;
        let mut matrix = LowerMatrix {
            column_start: vec![0],
            ..LowerMatrix::default()
        };
        for k in 0..n {
            matrix.rows.extend([k, n]);
            matrix.values.extend([4.0, -1.0]);
            matrix.column_start.push(matrix.rows.len());
        }
        matrix.rows.push(n);
        matrix.values.push(20.0);
        matrix.column_start.push(matrix.rows.len());
        for threads in [1, 2] {
            assert!(reference_factorisation(&matrix, threads).unwrap() > 2 * n);
        }
    }
}
