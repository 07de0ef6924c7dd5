//! From the covariance of the measured displacements to that of anything linear in them.
//!
//! ```text
//! T = ∂y/∂Δ¹ = A₁ − A₂ K₂₂⁻¹ K₂₁,     Σ_y = T Σ Tᵀ
//! ```
//!
//! T costs one solve per output, with A₂ᵀ on the right, or one per prescribed displacement, with K₂₁, whichever are fewer.

use faer::{Mat, MatRef};
use rand::SeedableRng;
use rand::rngs::StdRng;
use stickslip_fem_core::body::SparseRow;

use super::dense::{by_rows, cholesky, multiply, sandwich};
use super::{Region, RegionError, check_rows, length, product};
use crate::data::NodalDisplacements;
use crate::random::normal;

/// Bytes of right-hand sides that pass through the factor at once: about a hundred columns of 20 000 unknowns, beyond which a pass
/// gains nothing.
const PASS_BYTES: usize = 1 << 24;

/// How outputs follow from the prescribed displacements.
#[derive(Clone, Debug)]
pub struct Transfer {
    /// T, outputs × prescribed.
    pub(super) matrix: Mat<f64>,
    /// Solves with K₂₂ that it took.
    pub solves: usize,
}

impl Transfer {
    /// Number of outputs and of prescribed displacements.
    pub fn shape(&self) -> [usize; 2] {
        [self.matrix.nrows(), self.matrix.ncols()]
    }

    /// ∂y/∂Δ¹ of output `output` and prescribed displacement `prescribed`, both less than the [`shape`](Self::shape).
    pub fn derivative(&self, output: usize, prescribed: usize) -> f64 {
        self.matrix[(output, prescribed)]
    }

    /// Outputs of the prescribed displacements `values`.
    ///
    /// # Errors
    /// [`RegionError::Length`] unless they are as many as T has columns.
    pub fn apply(&self, values: &[f64]) -> Result<Vec<f64>, RegionError> {
        let expected = self.matrix.ncols();
        if values.len() != expected {
            let name = "the vector of prescribed displacements";
            return Err(length(name, expected, values.len()));
        }
        Ok(self.product(values))
    }

    pub(super) fn product(&self, values: &[f64]) -> Vec<f64> {
        let values = MatRef::from_column_major_slice(values, values.len(), 1);
        by_rows(&multiply(self.matrix.as_ref(), values))
    }
}

/// Outputs with what is known of their errors.
#[derive(Clone, Debug, PartialEq)]
pub struct Propagated {
    /// The outputs y.
    pub values: Vec<f64>,
    /// Their covariance Σ_y, square, row by row.
    pub covariance: Vec<f64>,
    /// Solves with K₂₂ that it took.
    pub solves: usize,
}

impl Propagated {
    /// Standard deviation of each output.
    pub fn deviations(&self) -> Vec<f64> {
        let size = self.values.len();
        (0..size)
            .map(|k| self.covariance[k * size + k].max(0.0).sqrt())
            .collect()
    }
}

impl Region {
    /// T of the outputs whose rows A are `outputs`.
    ///
    /// # Errors
    /// [`RegionError::Body`] if a row names a node that does not exist.
    pub fn transfer(&self, outputs: &[SparseRow]) -> Result<Transfer, RegionError> {
        check_rows(self.mesh(), outputs)?;
        let columns = self.prescribed().len();
        let solves = outputs.len().min(columns);
        let mut matrix = Mat::zeros(outputs.len(), columns);
        let pass = self.columns_in_a_pass();
        if outputs.len() <= columns {
            for (first, rows) in outputs.chunks(pass).enumerate() {
                let derivatives = self.stiffness.derivatives(rows);
                for (k, row) in derivatives.chunks_exact(columns.max(1)).enumerate() {
                    for (j, &value) in row.iter().enumerate() {
                        matrix[(first * pass + k, j)] = value;
                    }
                }
            }
        } else {
            for first in (0..columns).step_by(pass) {
                let count = pass.min(columns - first);
                let mut unit = vec![0.0; count * columns];
                (0..count).for_each(|k| unit[k * columns + first + k] = 1.0);
                let found = self.solved(outputs, &unit);
                for (k, state) in found.chunks_exact(outputs.len()).enumerate() {
                    for (i, &value) in state.iter().enumerate() {
                        matrix[(i, first + k)] = value;
                    }
                }
            }
        }
        Ok(Transfer { matrix, solves })
    }

    /// Outputs of `measured`, whose rows A are `outputs`, with their exact covariance.
    ///
    /// # Errors
    /// As [`Region::solve`]; [`RegionError::NoCovariance`].
    pub fn propagate(
        &self,
        outputs: &[SparseRow],
        measured: &NodalDisplacements,
    ) -> Result<Propagated, RegionError> {
        let values = self.values(measured)?;
        let covariance = self.covariance(measured)?;
        let transfer = self.transfer(outputs)?;
        Ok(Propagated {
            values: transfer.product(&values),
            covariance: by_rows(&sandwich(transfer.matrix.as_ref(), covariance.as_ref())),
            solves: transfer.solves,
        })
    }

    /// Outputs of several states of the prescribed displacements, one state after the other in `values` and in the answer; the
    /// right-hand sides pass through the factor together.
    ///
    /// # Errors
    /// [`RegionError::Length`] if the last state is not complete, [`RegionError::Body`] if a row names a node that does not exist.
    pub fn outputs_of(
        &self,
        outputs: &[SparseRow],
        values: &[f64],
    ) -> Result<Vec<f64>, RegionError> {
        check_rows(self.mesh(), outputs)?;
        let expected = values
            .len()
            .next_multiple_of(self.prescribed().len().max(1));
        if values.len() != expected {
            let name = "the vector of prescribed displacements of all states";
            return Err(length(name, expected, values.len()));
        }
        Ok(self.solved(outputs, values))
    }

    fn solved(&self, outputs: &[SparseRow], values: &[f64]) -> Vec<f64> {
        let own = self.prescribed().len().max(1);
        let mut all = Vec::with_capacity(outputs.len() * values.len() / own);
        for values in values.chunks(self.columns_in_a_pass() * own) {
            let states = self.stiffness.solve(values, &[]);
            for state in 0..states.count() {
                let displacements = states.displacements(state);
                all.extend(outputs.iter().map(|row| product(row, &displacements)));
            }
        }
        all
    }

    /// Outputs for `count` random draws of the prescribed displacements around `measured`, normal with its covariance, one draw
    /// after the other: a Monte Carlo check of [`propagate`](Self::propagate). The same `seed` gives the same draws.
    ///
    /// # Errors
    /// As [`propagate`](Self::propagate); [`RegionError::NotCovariance`].
    pub fn simulate(
        &self,
        outputs: &[SparseRow],
        measured: &NodalDisplacements,
        count: usize,
        seed: u64,
    ) -> Result<Vec<f64>, RegionError> {
        let values = self.values(measured)?;
        let root = square_root(&self.covariance(measured)?)?;
        let mut random = StdRng::seed_from_u64(seed);
        let noise = Mat::from_fn(values.len(), count, |_, _| normal(&mut random));
        let noise = multiply(root.as_ref(), noise.as_ref());
        let draws: Vec<f64> = (0..count)
            .flat_map(|k| {
                let noise = &noise;
                values
                    .iter()
                    .enumerate()
                    .map(move |(i, value)| value + noise[(i, k)])
            })
            .collect();
        self.outputs_of(outputs, &draws)
    }

    fn columns_in_a_pass(&self) -> usize {
        (PASS_BYTES / size_of::<f64>() / self.unknowns().max(1)).max(1)
    }
}

/// L with L Lᵀ = Σ. Displacements that are known exactly have rows of zeros, which are left out of the factorisation.
fn square_root(covariance: &Mat<f64>) -> Result<Mat<f64>, RegionError> {
    let size = covariance.nrows();
    let uncertain: Vec<usize> = (0..size).filter(|&i| covariance[(i, i)] != 0.0).collect();
    let count = uncertain.len();
    let part = Mat::from_fn(count, count, |i, j| {
        covariance[(uncertain[i], uncertain[j])]
    });
    let lower = cholesky(part).map_err(|row| RegionError::NotCovariance {
        row: uncertain.get(row).copied().unwrap_or(row),
    })?;
    let mut root = Mat::zeros(size, size);
    for (i, &row) in uncertain.iter().enumerate() {
        for (j, &column) in uncertain[..=i].iter().enumerate() {
            root[(row, column)] = lower[(i, j)];
        }
    }
    Ok(root)
}
