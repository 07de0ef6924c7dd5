//! A convex quadratic problem between bounds,
//!
//! ```text
//! min ½ xᵀH x + cᵀx,   l ≤ x ≤ u;     y = H x + c:   y = 0 (l < x < u),   y ≥ 0 (x = l),   y ≤ 0 (x = u)
//! ```
//!
//! by a primal–dual active set: solve with frozen sets, move every unknown that violates its sign to another set, repeat
//! (Hintermüller, Ito & Kunisch 2002). Where that stops reducing the number of violations, only the violating unknown of
//! largest index moves until there are fewer, which ends for every positive definite H (Júdice & Pires 1994).

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::linalg::DenseLu;

use super::frozen::lu_operations;
use super::{FailureCause, Work};

/// Relative size below which a violation is rounding.
const ROUNDING: f64 = 1e-12;

#[derive(Clone, Copy, Debug, PartialEq)]
enum Side {
    Free,
    Lower,
    Upper,
}

/// The problem's matrix, and the sets where the last solution was.
pub(super) struct Boxed {
    matrix: DMatrix<f64>,
    sides: Vec<Side>,
    /// Free unknowns that the factors belong to.
    factors: Option<(Vec<usize>, DenseLu)>,
}

impl Boxed {
    /// The problem of a symmetric positive definite `matrix`, to be started from the lower bounds.
    pub(super) fn new(matrix: DMatrix<f64>) -> Self {
        Self {
            sides: vec![Side::Lower; matrix.nrows()],
            matrix,
            factors: None,
        }
    }

    /// The solution x with linear term `linear` and [lower, upper] bounds `bounds`; the last sets are where it starts.
    pub(super) fn solve(
        &mut self,
        linear: &DVector<f64>,
        bounds: &[[f64; 2]],
        work: &mut Work,
    ) -> Result<DVector<f64>, FailureCause> {
        const PATIENCE: usize = 10;
        let limit = 100 + 20 * bounds.len();
        let (mut fewest, mut patience) = (usize::MAX, PATIENCE);
        for (side, [lower, upper]) in self.sides.iter_mut().zip(bounds) {
            if lower == upper {
                *side = Side::Lower;
            }
        }
        for _ in 0..limit {
            let x = self.with_frozen_sets(linear, bounds, work)?;
            let slope = &self.matrix * &x + linear;
            work.operations += 2 * (x.len() * x.len()) as u64;
            let moves = self.violations(&x, &slope, linear, bounds);
            if moves.is_empty() {
                return Ok(x);
            }
            if moves.len() < fewest {
                (fewest, patience) = (moves.len(), PATIENCE);
            } else {
                patience = patience.saturating_sub(1);
            }
            let single = if patience > 0 { 0 } else { moves.len() - 1 };
            for &(unknown, side) in &moves[single..] {
                self.sides[unknown] = side;
            }
        }
        Err(FailureCause::Limit(limit))
    }

    fn with_frozen_sets(
        &mut self,
        linear: &DVector<f64>,
        bounds: &[[f64; 2]],
        work: &mut Work,
    ) -> Result<DVector<f64>, FailureCause> {
        let free: Vec<usize> = (0..bounds.len())
            .filter(|&i| self.sides[i] == Side::Free)
            .collect();
        let mut x = DVector::from_fn(bounds.len(), |i, _| match self.sides[i] {
            Side::Free => 0.0,
            Side::Lower => bounds[i][0],
            Side::Upper => bounds[i][1],
        });
        let mut side = DVector::from_fn(free.len(), |i, _| -linear[free[i]]);
        for (column, &value) in x.iter().enumerate() {
            if value != 0.0 {
                let column = self.matrix.column(column);
                for (entry, &row) in side.iter_mut().zip(&free) {
                    *entry -= value * column[row];
                }
            }
        }
        work.solves += 1;
        let order = free.len() as u64;
        let known = self.factors.take().filter(|(of, _)| *of == free);
        let (free, factors) = if let Some(known) = known {
            work.operations += 2 * order * order;
            known
        } else {
            work.factorisations += 1;
            work.operations += lu_operations(order);
            let block = DMatrix::from_fn(free.len(), free.len(), |i, j| {
                self.matrix[(free[i], free[j])]
            });
            let factors = DenseLu::new(block).map_err(|_| FailureCause::Singular)?;
            (free, factors)
        };
        factors.solve(&mut side);
        for (&value, &unknown) in side.iter().zip(&free) {
            x[unknown] = value;
        }
        self.factors = Some((free, factors));
        Ok(x)
    }

    /// Unknowns that violate the sign conditions, with the set that they belong to instead.
    fn violations(
        &self,
        x: &DVector<f64>,
        slope: &DVector<f64>,
        linear: &DVector<f64>,
        bounds: &[[f64; 2]],
    ) -> Vec<(usize, Side)> {
        let (beyond, steep) = (ROUNDING * x.amax(), ROUNDING * linear.amax());
        (0..bounds.len())
            .filter_map(|i| {
                let [lower, upper] = bounds[i];
                if lower == upper {
                    return None;
                }
                let side = match self.sides[i] {
                    Side::Free if x[i] < lower - beyond => Side::Lower,
                    Side::Free if x[i] > upper + beyond => Side::Upper,
                    Side::Lower if slope[i] < -steep => Side::Free,
                    Side::Upper if slope[i] > steep => Side::Free,
                    side => side,
                };
                (side != self.sides[i]).then_some((i, side))
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn meets_the_sign_conditions() {
        for n in [1, 3, 12, 40] {
            let a = DMatrix::from_fn(n, n, |i, j| {
                ((i * 5 + j * 3 + i * j) % 7) as f64 / 7.0 - 0.4
            });
            let matrix = &a * a.transpose() + DMatrix::identity(n, n) * 0.05;
            let linear = DVector::from_fn(n, |i, _| ((i * 11) % 5) as f64 - 2.0);
            let bounds: Vec<[f64; 2]> = (0..n)
                .map(|i| {
                    if i % 3 == 0 {
                        [0.0, f64::INFINITY]
                    } else {
                        [-0.3, 0.2]
                    }
                })
                .collect();
            let mut problem = Boxed::new(matrix.clone());
            let x = problem
                .solve(&linear, &bounds, &mut Work::default())
                .unwrap();
            let slope = &matrix * &x + &linear;
            for (i, &[lower, upper]) in bounds.iter().enumerate() {
                assert!(x[i] >= lower - 1e-11 && x[i] <= upper + 1e-11);
                assert!(slope[i] > -1e-11 || x[i] > upper - 1e-11);
                assert!(slope[i] < 1e-11 || x[i] < lower + 1e-11);
            }
        }
    }
}
