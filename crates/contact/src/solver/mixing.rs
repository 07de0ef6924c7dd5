//! Acceleration of a fixed-point iteration x ← S(x) (Anderson 1965; Walker & Ni 2011): of the last iterates, the combination
//! whose change S(x) − x is least in the mean square,
//!
//! ```text
//! x ← S(x) − Σ γ_j ΔS_j,   γ = argmin ‖f − Σ γ_j Δf_j‖,   f = S(x) − x
//! ```
//!
//! with a restart where the change grows, as it does when a point changes its status.

use std::collections::VecDeque;

use nalgebra::{DMatrix, DVector};

/// The last iterates and what became of them.
pub(super) struct Mixing {
    depth: usize,
    /// Changes f and images S(x), oldest first.
    past: VecDeque<(DVector<f64>, DVector<f64>)>,
    least: f64,
}

impl Mixing {
    /// Combines up to `depth` differences of iterates; none with zero.
    pub(super) fn new(depth: usize) -> Self {
        Self {
            depth,
            past: VecDeque::new(),
            least: f64::INFINITY,
        }
    }

    /// The next iterate after `image` = S(`iterate`).
    pub(super) fn next(&mut self, iterate: &DVector<f64>, image: DVector<f64>) -> DVector<f64> {
        /// Growth of the change beyond which past iterates are discarded.
        const GROWTH: f64 = 2.0;
        if self.depth == 0 {
            return image;
        }
        let change = &image - iterate;
        let size = change.norm();
        if size > GROWTH * self.least {
            self.past.clear();
            self.least = size;
        }
        self.least = self.least.min(size);
        self.past.push_back((change, image));
        if self.past.len() > self.depth + 1 {
            self.past.pop_front();
        }
        self.combine()
    }

    fn combine(&self) -> DVector<f64> {
        let last = self.past.len() - 1;
        let (change, image) = &self.past[last];
        let differences: Vec<DVector<f64>> = (0..last)
            .map(|j| &self.past[j + 1].0 - &self.past[j].0)
            .collect();
        let mut next = image.clone();
        if differences.is_empty() {
            return next;
        }
        let weights = DMatrix::from_columns(&differences)
            .svd(true, true)
            .solve(change, 1e-10)
            .ok()
            .filter(|weights| weights.iter().all(|weight| weight.is_finite()));
        if let Some(weights) = weights {
            for (j, &weight) in weights.iter().enumerate() {
                next -= (&self.past[j + 1].1 - &self.past[j].1) * weight;
            }
        }
        next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A linear map in n dimensions is solved in n + 1 evaluations.
    #[test]
    fn linear_maps_are_solved_at_once() {
        let map = DMatrix::from_row_slice(3, 3, &[0.9, 0.2, 0.0, -0.1, 0.8, 0.3, 0.0, 0.1, 0.95]);
        let shift = DVector::from_vec(vec![1.0, -2.0, 0.5]);
        let mut mixing = Mixing::new(5);
        let mut x = DVector::zeros(3);
        for _ in 0..6 {
            let image = &map * &x + &shift;
            x = mixing.next(&x, image);
        }
        assert!((&map * &x + &shift - &x).amax() < 1e-9);
    }
}
