//! From the covariance of the measured displacements to that of anything linear in them.
//!
//! ```text
//! T = ∂y/∂Δ¹ = A₁ − A₂ K₂₂⁻¹ K₂₁,     Σ_y = T Σ Tᵀ
//! ```
//!
//! T costs one solve per output, with A₂ᵀ on the right, or one per prescribed displacement, with K₂₁, whichever are fewer. Right-hand sides
//! pass through the factor a hundred at a time, and passes run beside each other; each has the same bits wherever it runs.

use rand::SeedableRng;
use rand::rngs::StdRng;
use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::linalg::{DenseCholesky, Matrix};
use stickslip_fem_core::parallel;

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
    pub(super) matrix: Matrix,
    /// Solves with K₂₂ that it took.
    pub solves: usize,
}

impl Transfer {
    /// Number of outputs and of prescribed displacements.
    pub fn shape(&self) -> [usize; 2] {
        [self.matrix.rows(), self.matrix.columns()]
    }

    /// ∂y/∂Δ¹ `[output/length]` of output `output` and prescribed displacement `prescribed`, both less than the [`shape`](Self::shape).
    pub fn derivative(&self, output: usize, prescribed: usize) -> f64 {
        self.matrix[(output, prescribed)]
    }

    /// Computes the outputs y = T Δ¹ of the prescribed displacements `values` `[length]`; one number per row of T.
    ///
    /// # Errors
    /// [`RegionError::Length`] unless they are as many as T has columns.
    pub fn apply(&self, values: &[f64]) -> Result<Vec<f64>, RegionError> {
        let expected = self.matrix.columns();
        if values.len() != expected {
            let name = "the vector of prescribed displacements";
            return Err(length(name, expected, values.len()));
        }
        Ok(self.product(values))
    }

    pub(super) fn product(&self, values: &[f64]) -> Vec<f64> {
        self.matrix.multiply_vector(values)
    }
}

/// Outputs with what is known of their errors.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Propagated {
    /// The outputs y, in their units.
    pub values: Vec<f64>,
    /// Their covariance Σ_y, square, row by row, in products of their units.
    pub covariance: Vec<f64>,
    /// Solves with K₂₂ that it took.
    pub solves: usize,
}

impl Propagated {
    /// Computes the standard deviation of each output, √Σ_y,ii, in its unit.
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
        let pass = self.columns_in_a_pass();
        let matrix = if outputs.len() <= columns {
            let found =
                parallel::map_chunks(outputs, pass, |rows| self.stiffness.derivatives(rows));
            Matrix::from_fn(outputs.len(), columns, |i, j| {
                found[i / pass][i % pass * columns + j]
            })
        } else {
            let firsts: Vec<usize> = (0..columns).step_by(pass).collect();
            let one = |first: &usize| {
                let count = pass.min(columns - first);
                let mut unit = vec![0.0; count * columns];
                (0..count).for_each(|k| unit[k * columns + first + k] = 1.0);
                self.solved(outputs, &unit)
            };
            let found = parallel::map(&firsts, one);
            Matrix::from_fn(outputs.len(), columns, |i, j| {
                found[j / pass][j % pass * outputs.len() + i]
            })
        };
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
        self.propagate_by(&self.transfer(outputs)?, measured)
    }

    /// As [`propagate`](Self::propagate), of the outputs of a `transfer` of this region, without a solve.
    ///
    /// # Errors
    /// As [`Region::solve`]; [`RegionError::NoCovariance`].
    pub fn propagate_by(
        &self,
        transfer: &Transfer,
        measured: &NodalDisplacements,
    ) -> Result<Propagated, RegionError> {
        let covariance = self.covariance(measured)?;
        Ok(Propagated {
            values: transfer.apply(&self.values(measured)?)?,
            covariance: transfer
                .matrix
                .propagate_covariance(&covariance)
                .to_row_major(),
            solves: transfer.solves,
        })
    }

    /// Outputs, in their units, of several states of the prescribed displacements `[length]`, one state after the other in `values` and in the answer; the
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
        let mut nodes: Vec<usize> = outputs.iter().flatten().map(|(dof, _)| dof / 2).collect();
        nodes.sort_unstable();
        nodes.dedup();
        let pass = |values: &[f64]| -> Vec<f64> {
            let states = self.stiffness.solve(values, &[]);
            let mut displacements = vec![0.0; 2 * self.mesh().nodes().len()];
            let mut all = Vec::with_capacity(outputs.len() * states.count());
            for state in 0..states.count() {
                states.read(state, nodes.iter().copied(), &mut displacements);
                all.extend(outputs.iter().map(|row| product(row, &displacements)));
            }
            all
        };
        parallel::map_chunks(values, self.columns_in_a_pass() * own, pass).concat()
    }

    /// Outputs, in their units, for `count` random draws of the prescribed displacements around `measured`, normal with its covariance, one draw
    /// after the other: a Monte Carlo check of [`propagate`](Self::propagate). The same `seed` gives the same draws. One solve per draw,
    /// or those of T where they are fewer.
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
        if outputs.len().min(self.prescribed().len()) < count {
            return self.simulate_by(&self.transfer(outputs)?, measured, count, seed);
        }
        let values = self.values(measured)?;
        let root = square_root(&self.covariance(measured)?)?;
        let noise = root.multiply(&noise(values.len(), count, seed));
        let draws = Matrix::from_fn(count, values.len(), |k, i| values[i] + noise[(i, k)]);
        self.outputs_of(outputs, &draws.to_row_major())
    }

    /// Outputs, in their units, as by [`simulate`](Self::simulate), of a `transfer` of this region, without a solve.
    ///
    /// # Errors
    /// As [`simulate`](Self::simulate).
    pub fn simulate_by(
        &self,
        transfer: &Transfer,
        measured: &NodalDisplacements,
        count: usize,
        seed: u64,
    ) -> Result<Vec<f64>, RegionError> {
        let values = self.values(measured)?;
        let mean = transfer.apply(&values)?;
        let root = square_root(&self.covariance(measured)?)?;
        let root = transfer.matrix.multiply(&root);
        let noise = root.multiply(&noise(values.len(), count, seed));
        let draws = Matrix::from_fn(count, mean.len(), |k, i| mean[i] + noise[(i, k)]);
        Ok(draws.to_row_major())
    }

    fn columns_in_a_pass(&self) -> usize {
        (PASS_BYTES / size_of::<f64>() / self.unknowns().max(1)).max(1)
    }
}

/// Standard normal numbers, a column for each draw.
fn noise(rows: usize, count: usize, seed: u64) -> Matrix {
    let mut random = StdRng::seed_from_u64(seed);
    Matrix::from_fn(rows, count, |_, _| normal(&mut random))
}

/// L with L Lᵀ = Σ. Displacements that are known exactly have rows of zeros, which are left out of the factorisation.
fn square_root(covariance: &Matrix) -> Result<Matrix, RegionError> {
    let size = covariance.rows();
    let uncertain: Vec<usize> = (0..size).filter(|&i| covariance[(i, i)] != 0.0).collect();
    let count = uncertain.len();
    let part = Matrix::from_fn(count, count, |i, j| {
        covariance[(uncertain[i], uncertain[j])]
    });
    let factor = DenseCholesky::new(part).map_err(|cause| RegionError::NotCovariance {
        row: uncertain.get(cause.row).copied().unwrap_or(cause.row),
    })?;
    let mut root = Matrix::zeros(size, size);
    for (i, &row) in uncertain.iter().enumerate() {
        for (j, &column) in uncertain[..=i].iter().enumerate() {
            root[(row, column)] = factor.lower()[(i, j)];
        }
    }
    Ok(root)
}
