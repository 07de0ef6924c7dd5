//! Sparse Cholesky factorisation in a given order.

use std::sync::Arc;

use super::FactorError;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::linalg::cholesky::llt::factor::LltError;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::supernodal::SupernodalLltRef;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par, Side};

/// The lower triangle of a sparse symmetric matrix by columns; row indices ascend in each column and the diagonal is there.
#[derive(Clone, Debug, Default)]
pub struct LowerMatrix {
    /// Where each column starts in `rows` and `values`; one entry more than columns.
    pub column_start: Vec<usize>,
    /// Row index of each entry.
    pub rows: Vec<usize>,
    /// Value of each entry, in any unit.
    pub values: Vec<f64>,
}

impl LowerMatrix {
    /// Number of unknowns.
    pub fn order(&self) -> usize {
        self.column_start.len().saturating_sub(1)
    }

    pub(super) fn pattern(&self) -> SymbolicSparseColMatRef<'_, usize> {
        let n = self.order();
        SymbolicSparseColMatRef::new_checked(n, n, &self.column_start, None, &self.rows)
    }

    /// The pattern of the transpose (upper triangle by columns).
    fn transposed_pattern(&self) -> (Vec<usize>, Vec<usize>) {
        let n = self.order();
        let mut start = vec![0; n + 1];
        for &row in &self.rows {
            start[row + 1] += 1;
        }
        for k in 0..n {
            start[k + 1] += start[k];
        }
        let mut next = start.clone();
        let mut rows = vec![0; self.rows.len()];
        for column in 0..n {
            for &row in &self.rows[self.column_start[column]..self.column_start[column + 1]] {
                rows[next[row]] = column;
                next[row] += 1;
            }
        }
        (start, rows)
    }

    /// Computes y = K x with the full symmetric matrix, in the unit of K times that of `x`; `x` and y have one entry per unknown.
    pub fn multiply(&self, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for column in 0..self.order() {
            for k in self.column_start[column]..self.column_start[column + 1] {
                let (row, value) = (self.rows[k], self.values[k]);
                y[row] += value * x[column];
                if row != column {
                    y[column] += value * x[row];
                }
            }
        }
        y
    }
}

/// The symbolic factorisation of a pattern: reused by every matrix with that pattern.
#[derive(Clone, Debug)]
pub struct SparseStructure(pub(super) Arc<SymbolicCholesky<usize>>);

impl SparseStructure {
    /// Analyses the pattern of `matrix` in the order it has.
    ///
    /// # Errors
    /// [`FactorError::TooLarge`] if the factor's structure does not fit.
    pub fn analyse(matrix: &LowerMatrix) -> Result<Self, FactorError> {
        let (start, rows) = matrix.transposed_pattern();
        let n = matrix.order();
        let upper = SymbolicSparseColMatRef::new_checked(n, n, &start, None, &rows);
        let parameters = CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        };
        // `Identity` reads the pattern as it stands, which must be the upper triangle.
        factorize_symbolic_cholesky(upper, Side::Upper, SymmetricOrdering::Identity, parameters)
            .map(|symbolic| Self(Arc::new(symbolic)))
            .map_err(|_| FactorError::TooLarge { unknowns: n })
    }

    /// Number of stored entries of the factor, explicit zeros of supernodes included.
    pub fn factor_entries(&self) -> usize {
        self.0.len_val()
    }

    /// Floating-point operations of a factorisation, Σ c² over the columns with c entries of the factor.
    pub fn operations(&self) -> u64 {
        let SymbolicCholeskyRaw::Supernodal(symbolic) = self.0.raw() else {
            return 0;
        };
        let below = symbolic.col_ptr_for_row_idx();
        symbolic
            .supernode_begin()
            .iter()
            .zip(symbolic.supernode_end())
            .zip(below.windows(2))
            .flat_map(|((begin, end), below)| {
                let rows = end - begin + below[1] - below[0];
                (0..end - begin).map(move |column| (rows - column) as u64)
            })
            .map(|count| count * count)
            .sum()
    }
}

/// `K = L Lᵀ` of a sparse symmetric positive definite matrix in its own order.
#[derive(Clone, Debug)]
pub struct SparseCholesky {
    pub(super) structure: SparseStructure,
    values: Vec<f64>,
}

impl SparseCholesky {
    /// Factorises `matrix`, whose pattern is that of `structure`. Sequential, so the same input gives the same bits.
    ///
    /// # Errors
    /// [`FactorError::NotPositiveDefinite`] names the unknown at which a pivot was not positive.
    pub fn factorise(
        structure: &SparseStructure,
        matrix: &LowerMatrix,
    ) -> Result<Self, FactorError> {
        let n = matrix.order();
        let too_large = || FactorError::TooLarge { unknowns: n };
        let symbolic = &structure.0;
        let mut values = vec![0.0; symbolic.len_val()];
        let request =
            symbolic.factorize_numeric_llt_scratch::<f64>(Par::Seq, faer::Spec::default());
        let mut memory = MemBuffer::try_new(request).map_err(|_| too_large())?;
        let lower = SparseColMatRef::new(matrix.pattern(), &matrix.values);
        symbolic
            .factorize_numeric_llt(
                &mut values,
                lower,
                Side::Lower,
                LltRegularization::default(),
                Par::Seq,
                MemStack::new(&mut memory),
                faer::Spec::default(),
            )
            .map_err(
                |LltError::NonPositivePivot { index }| FactorError::NotPositiveDefinite {
                    unknown: index,
                },
            )?;
        Ok(Self {
            structure: structure.clone(),
            values,
        })
    }

    /// Number of unknowns.
    pub fn unknowns(&self) -> usize {
        self.structure.0.nrows()
    }

    /// The structure that this factor shares with others of its pattern.
    pub fn structure(&self) -> &SparseStructure {
        &self.structure
    }

    pub(super) fn supernodal(&self) -> Option<SupernodalLltRef<'_, usize, f64>> {
        match self.structure.0.raw() {
            SymbolicCholeskyRaw::Supernodal(symbolic) => {
                Some(SupernodalLltRef::new(symbolic, &self.values))
            }
            // `analyse` forces the supernodal kind wherever the factorisation takes at least one operation, and a division per
            // pivot is one: only a matrix without unknowns stays simplicial.
            SymbolicCholeskyRaw::Simplicial(_) => None,
        }
    }

    /// Overwrites `x`, one or more columns of one entry per unknown, one after the other, with L⁻¹ x, in any units.
    pub fn solve_lower(&self, x: &mut [f64]) {
        self.with_factor(x, |factor, x, stack| {
            factor.l_solve_with_conj(Conj::No, x, Par::Seq, stack);
        });
    }

    /// Overwrites `x`, columns as for [`solve_lower`](Self::solve_lower), with L⁻ᵀ x, in any units.
    pub fn solve_lower_transposed(&self, x: &mut [f64]) {
        self.with_factor(x, |factor, x, stack| {
            factor.l_transpose_solve_with_conj(Conj::No, x, Par::Seq, stack);
        });
    }

    /// Overwrites `x`, columns as for [`solve_lower`](Self::solve_lower), with K⁻¹ x, in any units.
    pub fn solve(&self, x: &mut [f64]) {
        self.solve_lower(x);
        self.solve_lower_transposed(x);
    }

    fn with_factor(
        &self,
        x: &mut [f64],
        work: impl FnOnce(SupernodalLltRef<'_, usize, f64>, MatMut<'_, f64>, &mut MemStack),
    ) {
        let Some(factor) = self.supernodal() else {
            return;
        };
        let rows = self.unknowns();
        if rows == 0 {
            return;
        }
        let columns = x.len() / rows;
        let scratch = factor
            .symbolic()
            .solve_in_place_scratch::<f64>(columns, Par::Seq);
        let mut memory = MemBuffer::new(scratch);
        let x = MatMut::from_column_major_slice_mut(x, rows, columns);
        work(factor, x, MemStack::new(&mut memory));
    }
}

#[cfg(test)]
mod tests {
    use nalgebra::DMatrix;

    use super::*;

    /// Laplacian of an m × m grid plus a small shift, in natural order.
    fn grid(m: usize) -> LowerMatrix {
        let n = m * m;
        let mut matrix = LowerMatrix {
            column_start: vec![0],
            ..LowerMatrix::default()
        };
        for k in 0..n {
            matrix.rows.push(k);
            matrix.values.push(4.01);
            if k % m + 1 < m {
                matrix.rows.push(k + 1);
                matrix.values.push(-1.0);
            }
            if k + m < n {
                matrix.rows.push(k + m);
                matrix.values.push(-1.0);
            }
            matrix.column_start.push(matrix.rows.len());
        }
        matrix
    }

    fn dense(matrix: &LowerMatrix) -> DMatrix<f64> {
        let n = matrix.order();
        let mut full = DMatrix::zeros(n, n);
        for column in 0..n {
            for k in matrix.column_start[column]..matrix.column_start[column + 1] {
                full[(matrix.rows[k], column)] = matrix.values[k];
                full[(column, matrix.rows[k])] = matrix.values[k];
            }
        }
        full
    }

    #[test]
    fn solves_and_hands_out_the_trailing_block() {
        let matrix = grid(9);
        let structure = SparseStructure::analyse(&matrix).unwrap();
        let factor = SparseCholesky::factorise(&structure, &matrix).unwrap();
        let full = dense(&matrix);
        // Between the square of a banded factor's columns and those of a dense one.
        assert!((81 * 9..81 * 81 * 81 / 3 + 81 * 81).contains(&structure.operations()));
        let x: Vec<f64> = (0..81).map(|k| f64::from(k % 7) - 2.5).collect();
        let mut y = matrix.multiply(&x);
        factor.solve(&mut y);
        assert!(x.iter().zip(&y).all(|(a, b)| (a - b).abs() < 1e-13));
        for count in [1, 5, 9, 14, 30] {
            let lower = factor.trailing_block(count);
            let first = 81 - count;
            let inverse = full
                .view((0, 0), (first, first))
                .into_owned()
                .try_inverse()
                .unwrap();
            let schur = full.view((first, first), (count, count))
                - full.view((first, 0), (count, first))
                    * inverse
                    * full.view((0, first), (first, count));
            assert!(
                (&lower * lower.transpose() - schur).amax() < 1e-13,
                "{count}"
            );
        }
    }

    #[test]
    fn an_indefinite_matrix_is_refused() {
        let mut matrix = grid(4);
        matrix.values[matrix.column_start[6]] = -1.0;
        let structure = SparseStructure::analyse(&matrix).unwrap();
        let refused = SparseCholesky::factorise(&structure, &matrix);
        assert!(matches!(
            refused,
            Err(FactorError::NotPositiveDefinite { .. })
        ));
    }

    fn diagonal(entries: &[f64]) -> LowerMatrix {
        LowerMatrix {
            column_start: (0..=entries.len()).collect(),
            rows: (0..entries.len()).collect(),
            values: entries.to_vec(),
        }
    }

    /// Where no entry lies off the diagonal, faer's simplicial kind would be enough; the factor must be there all the same.
    #[test]
    fn a_diagonal_matrix_is_factorised() {
        for entries in [&[4.0][..], &[4.0, 9.0, 0.25, 16.0]] {
            let n = entries.len();
            let matrix = diagonal(entries);
            let structure = SparseStructure::analyse(&matrix).unwrap();
            let factor = SparseCholesky::factorise(&structure, &matrix).unwrap();
            assert_eq!(structure.operations(), n as u64);
            let mut x = entries.to_vec();
            factor.solve(&mut x);
            assert_eq!(x, vec![1.0; n]);
            let roots = entries.iter().map(|entry| entry.sqrt());
            let block = DMatrix::from_diagonal(&nalgebra::DVector::from_iterator(n, roots));
            for count in 0..=n {
                let own = block.view((n - count, n - count), (count, count));
                assert_eq!(factor.trailing_block(count), own);
            }
            let refused = SparseCholesky::factorise(&structure, &diagonal(&vec![-1.0; n]));
            assert!(matches!(
                refused,
                Err(FactorError::NotPositiveDefinite { unknown: 0 })
            ));
        }
    }

    #[test]
    fn a_matrix_without_unknowns_is_factorised() {
        let matrix = diagonal(&[]);
        let structure = SparseStructure::analyse(&matrix).unwrap();
        let factor = SparseCholesky::factorise(&structure, &matrix).unwrap();
        assert_eq!((structure.operations(), factor.values.len()), (0, 0));
        factor.solve(&mut []);
        assert_eq!(factor.trailing_block(0).shape(), (0, 0));
    }
}
