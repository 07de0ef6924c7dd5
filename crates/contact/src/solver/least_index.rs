//! Least-index principal pivoting of the linear complementarity problem
//!
//! ```text
//! w = M z + q,   z ≥ 0, w ≥ 0, zᵀw = 0
//! ```
//!
//! (Murty 1974; Bard-type methods: Keller 1973). Of each pair one variable is basic. While basic variables are negative, the
//! pair of least index among them exchanges its two. If all principal minors of M are positive, no set of basic variables
//! recurs and the method ends after finitely many pivots. That holds without friction, and for small μ; beyond, sets may
//! recur, which is detected.
//!
//! The pairs of a frictional step are ordered normal, tangential, reverse slip. The last has a zero on the diagonal of M
//! unless its point sticks, but is negative then only together with its λ_n, which comes first.

use std::collections::HashMap;

use nalgebra::{DMatrix, DVector};

use super::tableau::Dictionary;
use super::{FailureCause, Work};

/// Size below which a pivot is rounding, relative to the largest entry of its column.
const NEGLIGIBLE: f64 = 1e-10;
/// Size below which a negative value is rounding, relative to the largest value.
const ROUNDING: f64 = 1e-12;

/// The z ≥ 0 of the last dictionary, after at most `limit` pivots, and whether it solves the problem; points of a
/// [`FailureCause::Cycled`] are indices of pairs.
pub(super) fn least_index(
    matrix: &DMatrix<f64>,
    constant: &DVector<f64>,
    limit: usize,
    work: &mut Work,
) -> (DVector<f64>, Result<(), FailureCause>) {
    let n = constant.len();
    let mut table = DMatrix::zeros(n, n + 1);
    table.column_mut(0).copy_from(constant);
    table.columns_mut(1, n).copy_from(matrix);
    // Row i and column i + 1 belong to pair i throughout; wᵢ has index 1 + i, zᵢ index 1 + n + i.
    let mut dictionary = Dictionary {
        table,
        basic: (1..=n).collect(),
        nonbasic: (n + 1..=2 * n).collect(),
    };
    let outcome = exchange(&mut dictionary, limit, work);
    let z = DVector::from_fn(n, |i, _| {
        if dictionary.basic[i] > n {
            dictionary.table[(i, 0)].max(0.0)
        } else {
            0.0
        }
    });
    (z, outcome)
}

fn exchange(
    dictionary: &mut Dictionary,
    limit: usize,
    work: &mut Work,
) -> Result<(), FailureCause> {
    let n = dictionary.basic.len();
    let mut basis = vec![0_u64; n.div_ceil(64)];
    let mut seen = HashMap::from([(basis.clone(), 0)]);
    let mut exchanged = Vec::new();
    for _ in 0..limit {
        let values = dictionary.table.column(0);
        let rounding = ROUNDING * values.amax();
        let Some(pair) = (0..n).find(|&i| values[i] < -rounding) else {
            return Ok(());
        };
        let column = dictionary.table.column(pair + 1);
        if column[pair].abs() <= NEGLIGIBLE * column.amax() {
            return Err(FailureCause::Singular);
        }
        dictionary.pivot(pair, pair + 1);
        work.pivots += 1;
        work.operations += 2 * (n * (n + 1)) as u64;
        exchanged.push(pair);
        basis[pair / 64] ^= 1 << (pair % 64);
        if let Some(first) = seen.insert(basis.clone(), exchanged.len()) {
            let period = exchanged.len() - first;
            let points = exchanged[first..].to_vec();
            return Err(FailureCause::Cycled { period, points });
        }
    }
    Err(FailureCause::Limit(limit))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_problems_with_positive_principal_minors() {
        for n in [1, 2, 5, 30] {
            let a = DMatrix::from_fn(n, n, |i, j| {
                ((i * 5 + j * 3 + i * j) % 7) as f64 / 7.0 - 0.4
            });
            let matrix = &a * a.transpose() + DMatrix::identity(n, n) * 0.5;
            let constant = DVector::from_fn(n, |i, _| ((i * 11) % 5) as f64 - 2.0);
            let mut work = Work::default();
            let (z, outcome) = least_index(&matrix, &constant, 1000, &mut work);
            outcome.unwrap();
            let w = &matrix * &z + &constant;
            assert!(z.min() >= 0.0 && w.min() > -1e-12 && z.dot(&w).abs() < 1e-11);
            assert!(work.pivots > 0 && work.operations > 0);
        }
    }

    #[test]
    fn a_problem_without_solution_repeats() {
        // w = −z − 1 has none: each exchange makes the other variable negative.
        let (matrix, constant) = (
            DMatrix::from_element(1, 1, -1.0),
            DVector::from_element(1, -1.0),
        );
        let (_, outcome) = least_index(&matrix, &constant, 10, &mut Work::default());
        let cycle = FailureCause::Cycled {
            period: 2,
            points: vec![0, 0],
        };
        assert_eq!(outcome, Err(cycle));
    }
}
