//! Sparse and dense factorisations: the one place that knows faer.
//!
//! A symmetric positive definite matrix is held as the lower triangle of its *already ordered* rows and columns, so that
//! the factor `K = L Lᵀ` keeps that order. With the interface unknowns last, the trailing block of `L` is the Cholesky
//! factor of the Schur complement,
//!
//! ```text
//! K = [K_ii K_ic; K_ci K_cc],   S = K_cc − K_ci K_ii⁻¹ K_ic = L_cc L_ccᵀ.
//! ```

mod dense;
mod lu;
mod matrix;
mod ordering;
mod sparse;
mod symmetric;
mod trailing;
mod yardstick;

pub use dense::{
    DenseLu, SingularMatrix, invert_from_cholesky, solve_lower, solve_lower_transposed,
};
pub use lu::{LuStructure, SparseLu, SparseMatrix};
pub use matrix::Matrix;
pub use ordering::minimum_degree;
pub use sparse::{LowerMatrix, SparseCholesky, SparseStructure};
pub use symmetric::{DenseCholesky, NoEigenvalues, NotPositiveDefinite, SymmetricEigen};
pub use yardstick::reference_factorisation;

use thiserror::Error;

/// Why a sparse factorisation failed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum FactorError {
    /// A pivot was not positive: the matrix is not positive definite.
    #[error(
        "the stiffness matrix is not positive definite (pivot of unknown {unknown}): a part of the body can move freely"
    )]
    NotPositiveDefinite {
        /// Index of the unknown in the matrix as it was handed in.
        unknown: usize,
    },
    /// A column of an unsymmetric matrix has no pivot.
    #[error("the matrix is singular: column {column} has no pivot")]
    Singular {
        /// Index of the column in the order of elimination.
        column: usize,
    },
    /// The factor does not fit in memory, or its indices overflow.
    #[error("a factor of {unknowns} unknowns does not fit in memory")]
    TooLarge {
        /// Number of unknowns.
        unknowns: usize,
    },
}
