//! Rigid motions that a set of contact conditions leaves free.

use nalgebra::{DMatrix, SymmetricEigen};

use super::InterfaceProblem;

/// Relative size below which a resistance is rounding.
const NEGLIGIBLE: f64 = 1e-12;

/// Rigid motions that the touching points do not resist.
#[derive(Clone, Debug)]
pub struct FreeMotions {
    /// Orthonormal columns that span them, m × f `[1]`.
    pub basis: DMatrix<f64>,
    /// Orthogonal projector on them, m × m `[1]`.
    pub projector: DMatrix<f64>,
}

impl FreeMotions {
    /// The rigid motions of `problem` that none of the contact conditions on `rows` of (g, Δs) resists, if there are any.
    pub fn of(problem: &InterfaceProblem, rows: impl IntoIterator<Item = usize>) -> Option<Self> {
        let modes = problem.modes();
        let rigid = modes.ncols();
        if rigid == 0 {
            return None;
        }
        let mut gram = DMatrix::zeros(rigid, rigid);
        for row in rows {
            let motion = modes.row(row);
            gram += motion.transpose() * motion;
        }
        let scale = gram.trace().max(1.0);
        let eigen = SymmetricEigen::new(gram);
        let free: Vec<usize> = (0..rigid)
            .filter(|&k| eigen.eigenvalues[k] <= NEGLIGIBLE * scale)
            .collect();
        if free.is_empty() {
            return None;
        }
        let basis = eigen.eigenvectors.select_columns(&free);
        Some(Self {
            projector: &basis * basis.transpose(),
            basis,
        })
    }
}
