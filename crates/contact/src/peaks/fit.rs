//! Small least-squares fits.

use nalgebra::{DMatrix, DVector};

/// Equations of a fit: coefficients of the unknowns and right-hand sides.
#[derive(Clone, Debug)]
pub(super) struct Equations {
    unknowns: usize,
    rows: Vec<f64>,
    values: Vec<f64>,
}

impl Equations {
    pub(super) fn new(unknowns: usize) -> Self {
        Self {
            unknowns,
            rows: Vec::new(),
            values: Vec::new(),
        }
    }

    /// Adds Σ c_k x_k = `value` with `terms` (k, c_k).
    pub(super) fn add(&mut self, terms: impl IntoIterator<Item = (usize, f64)>, value: f64) {
        let start = self.rows.len();
        self.rows.resize(start + self.unknowns, 0.0);
        for (unknown, coefficient) in terms {
            self.rows[start + unknown] += coefficient;
        }
        self.values.push(value);
    }

    /// The first unknown, `None` with fewer equations than unknowns or a value that is not finite.
    pub(super) fn first(self) -> Option<f64> {
        const RANK: f64 = 1e-12;
        let count = self.values.len();
        let finite = |values: &[f64]| values.iter().all(|value| value.is_finite());
        if count < self.unknowns || !finite(&self.rows) || !finite(&self.values) {
            return None;
        }
        let matrix = DMatrix::from_row_slice(count, self.unknowns, &self.rows);
        let found = matrix
            .svd(true, true)
            .solve(&DVector::from_vec(self.values), RANK);
        found.ok().map(|x| x[0])
    }
}

/// The middle one of an odd number of values, the mean of the middle two of an even number; `None` of none.
pub(super) fn median(mut values: Vec<f64>) -> Option<f64> {
    values.sort_by(f64::total_cmp);
    let half = values.len() / 2;
    match values.len() {
        0 => None,
        count if count % 2 == 1 => Some(values[half]),
        _ => Some(f64::midpoint(values[half - 1], values[half])),
    }
}

/// Largest less smallest value.
pub(super) fn range(values: &[f64]) -> f64 {
    let [low, high] = [f64::min, f64::max].map(|pick| values.iter().copied().reduce(pick));
    high.unwrap_or(0.0) - low.unwrap_or(0.0)
}
