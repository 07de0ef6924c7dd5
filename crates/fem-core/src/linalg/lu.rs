//! Sparse LU factorisation of unsymmetric matrices.

use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::lu::{
    LuRef, LuSymbolicParams, NumericLu, SymbolicLu, factorize_symbolic_lu,
};
use faer::sparse::{SparseColMatRef, SymbolicSparseColMatRef};
use faer::{Conj, MatMut, Par};

use super::FactorError;

/// A sparse square matrix by columns; row indices ascend in each column.
#[derive(Clone, Debug, Default)]
pub struct SparseMatrix {
    /// Where each column starts in `rows` and `values`; one entry more than columns.
    pub column_start: Vec<usize>,
    /// Row index of each entry.
    pub rows: Vec<usize>,
    /// Value of each entry, in any unit; zeros may be stored.
    pub values: Vec<f64>,
}

impl SparseMatrix {
    /// Number of unknowns.
    pub fn order(&self) -> usize {
        self.column_start.len().saturating_sub(1)
    }

    /// Position in `values` of the entry in `row` and `column`, if it is stored.
    pub fn position(&self, row: usize, column: usize) -> Option<usize> {
        let start = self.column_start[column];
        let rows = &self.rows[start..self.column_start[column + 1]];
        rows.binary_search(&row).ok().map(|offset| start + offset)
    }

    fn pattern(&self) -> SymbolicSparseColMatRef<'_, usize> {
        let n = self.order();
        SymbolicSparseColMatRef::new_checked(n, n, &self.column_start, None, &self.rows)
    }
}

/// The column order and symbolic factorisation of a pattern, reused by every matrix with that pattern whatever its pivots.
#[derive(Clone, Debug)]
pub struct LuStructure(SymbolicLu<usize>);

impl LuStructure {
    /// Orders the columns of `matrix` by COLAMD (Davis et al. 2004) and analyses its pattern.
    ///
    /// # Errors
    /// [`FactorError::TooLarge`] if the structure does not fit in memory.
    pub fn analyse(matrix: &SparseMatrix) -> Result<Self, FactorError> {
        factorize_symbolic_lu(matrix.pattern(), LuSymbolicParams::default())
            .map(Self)
            .map_err(|_| FactorError::TooLarge {
                unknowns: matrix.order(),
            })
    }
}

/// `P A Q = L U` of a sparse square matrix, with partial pivoting.
#[derive(Debug)]
pub struct SparseLu<'a> {
    structure: &'a LuStructure,
    factors: NumericLu<usize, f64>,
}

impl<'a> SparseLu<'a> {
    /// Factorises `matrix`, whose pattern is that of `structure`. Sequential, so the same input gives the same bits.
    ///
    /// # Errors
    /// [`FactorError::Singular`] if the pattern has no pivot for a column, [`FactorError::TooLarge`] if memory does not
    /// suffice. A matrix that is singular by its values shows in solutions that are not finite.
    pub fn factorise(
        structure: &'a LuStructure,
        matrix: &SparseMatrix,
    ) -> Result<Self, FactorError> {
        use faer::sparse::linalg::LuError;
        let too_large = || FactorError::TooLarge {
            unknowns: matrix.order(),
        };
        let symbolic = &structure.0;
        let request = symbolic.factorize_numeric_lu_scratch::<f64>(Par::Seq, faer::Spec::default());
        let mut memory = MemBuffer::try_new(request).map_err(|_| too_large())?;
        let mut factors = NumericLu::new();
        symbolic
            .factorize_numeric_lu(
                &mut factors,
                SparseColMatRef::new(matrix.pattern(), &matrix.values),
                Par::Seq,
                MemStack::new(&mut memory),
                faer::Spec::default(),
            )
            .map_err(|cause| match cause {
                LuError::SymbolicSingular { index } => FactorError::Singular { column: index },
                LuError::Generic(_) => too_large(),
            })?;
        Ok(Self { structure, factors })
    }

    /// Overwrites `x`, one entry per unknown, with A⁻¹ x, in any units.
    pub fn solve(&self, x: &mut [f64]) {
        let symbolic = &self.structure.0;
        let rows = symbolic.nrows();
        if rows == 0 {
            return;
        }
        let mut memory = MemBuffer::new(symbolic.solve_in_place_scratch::<f64>(1, Par::Seq));
        // The factors were made with this structure.
        LuRef::new_unchecked(symbolic, &self.factors).solve_in_place_with_conj(
            Conj::No,
            MatMut::from_column_major_slice_mut(x, rows, 1),
            Par::Seq,
            MemStack::new(&mut memory),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// An unsymmetric matrix on the pattern of a grid, with zeros on part of its diagonal.
    fn sample(m: usize) -> SparseMatrix {
        let n = m * m;
        let mut matrix = SparseMatrix {
            column_start: vec![0],
            ..SparseMatrix::default()
        };
        for column in 0..n {
            for row in [
                column.checked_sub(m),
                column.checked_sub(1),
                Some(column),
                (column + 1 < n).then_some(column + 1),
                (column + m < n).then_some(column + m),
            ]
            .into_iter()
            .flatten()
            {
                let value = ((row * 7 + column * 13) % 11) as f64 / 3.0 - 1.5;
                let diagonal = if column % 9 == 4 { -value } else { 4.0 };
                matrix.rows.push(row);
                matrix.values.push(if row == column {
                    value + diagonal
                } else {
                    value
                });
            }
            matrix.column_start.push(matrix.rows.len());
        }
        matrix
    }

    fn multiply(matrix: &SparseMatrix, x: &[f64]) -> Vec<f64> {
        let mut y = vec![0.0; x.len()];
        for (column, factor) in x.iter().enumerate() {
            for k in matrix.column_start[column]..matrix.column_start[column + 1] {
                y[matrix.rows[k]] += factor * matrix.values[k];
            }
        }
        y
    }

    #[test]
    fn solves_and_reuses_the_structure() {
        let mut matrix = sample(12);
        let structure = LuStructure::analyse(&matrix).unwrap();
        let x: Vec<f64> = (0..144).map(|k| f64::from(k % 5) - 1.7).collect();
        for factor in [1.0, 0.3] {
            let at = matrix.position(25, 24).unwrap();
            matrix.values[at] *= factor;
            let mut y = multiply(&matrix, &x);
            SparseLu::factorise(&structure, &matrix)
                .unwrap()
                .solve(&mut y);
            assert!(x.iter().zip(&y).all(|(a, b)| (a - b).abs() < 1e-11));
        }
    }

    #[test]
    fn an_empty_column_is_refused() {
        let matrix = SparseMatrix {
            column_start: vec![0, 2, 2],
            rows: vec![0, 1],
            values: vec![1.0, 1.0],
        };
        let structure = LuStructure::analyse(&matrix).unwrap();
        assert!(matches!(
            SparseLu::factorise(&structure, &matrix),
            Err(FactorError::Singular { .. })
        ));
    }
}
