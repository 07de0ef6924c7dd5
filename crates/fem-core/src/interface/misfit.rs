//! Matrices and vectors of an operator that do not fit.

use nalgebra::{Dim, Dyn, Matrix, RawStorage};
use thiserror::Error;

/// What is wrong with a matrix or a vector of an operator.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum Misfit {
    /// It does not fit the number of points or of free motions.
    #[error("{what} is {rows} × {columns}, where {expected_rows} × {expected_columns} is needed")]
    Shape {
        /// What it is.
        what: String,
        /// Its rows.
        rows: usize,
        /// Its columns.
        columns: usize,
        /// The rows that fit.
        expected_rows: usize,
        /// The columns that fit.
        expected_columns: usize,
    },
    /// It holds an infinite or undefined number.
    #[error("{what} is not finite")]
    NotFinite {
        /// What it is.
        what: String,
    },
}

/// Checks that `values`, named by `what`, are as many as expected and finite.
pub(super) fn fits<C: Dim, S: RawStorage<f64, Dyn, C>>(
    what: impl FnOnce() -> String,
    values: &Matrix<f64, Dyn, C, S>,
    [expected_rows, expected_columns]: [usize; 2],
) -> Result<(), Misfit> {
    let (rows, columns) = values.shape();
    if [rows, columns] != [expected_rows, expected_columns] {
        return Err(Misfit::Shape {
            what: what(),
            rows,
            columns,
            expected_rows,
            expected_columns,
        });
    }
    if values.iter().all(|value| value.is_finite()) {
        Ok(())
    } else {
        Err(Misfit::NotFinite { what: what() })
    }
}
