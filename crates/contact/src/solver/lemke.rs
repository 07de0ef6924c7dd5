//! Lemke's method for the linear complementarity problem
//!
//! ```text
//! w = M z + q,   z ≥ 0, w ≥ 0, zᵀw = 0
//! ```
//!
//! (Cottle, Pang & Stone 1992, §4.4) on a dense dictionary. The covering vector d makes z₀ large enough that every w
//! starts non-negative; pivots follow the complementary rule until z₀ leaves. Ties in the ratio test go to z₀; others are
//! broken as if q were q + (ε, ε², …) with an infinitely small ε (the lexicographic rule, §4.9), so that no dictionary recurs.

use nalgebra::{DMatrix, DVector};

use super::Work;
use super::tableau::Dictionary;

/// Outcome of Lemke's method.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outcome {
    /// The complementary solution z.
    Solved(DVector<f64>),
    /// A secondary ray was met.
    Ray,
    /// The pivot limit was met.
    Limit,
}

/// Floating-point operations of a pivot of a problem with `order` complementary pairs.
pub(super) fn pivot_operations(order: usize) -> u64 {
    2 * (order * (order + 2)) as u64
}

/// Size below which an entry of a column is rounding, relative to its largest one.
const NEGLIGIBLE: f64 = 1e-10;
/// The same for values of basic variables, whose ties decide.
const ROUNDING: f64 = 1e-12;

impl Dictionary {
    /// Row of the first basic variable to vanish as the non-basic one of `column` grows; `None` on a ray.
    fn leaving(&self, column: usize) -> Option<usize> {
        let largest = self.table.column(column).amax();
        let falling = |row: &usize| self.table[(*row, column)] < -NEGLIGIBLE * largest;
        let rows: Vec<usize> = (0..self.basic.len()).filter(falling).collect();
        let mut first = self.first_to_vanish(rows, column, |row| self.table[(row, 0)].max(0.0));
        if let Some(&row) = first.iter().find(|&&row| self.basic[row] == 0) {
            return Some(row);
        }
        for power in 0..self.basic.len() {
            if first.len() <= 1 {
                break;
            }
            // Coefficient of ε^(power + 1) in the basic variables: the perturbation goes with the w of that index.
            let variable = 1 + power;
            let place = self.nonbasic.iter().position(|&other| other == variable);
            first = self.first_to_vanish(first, column, |row| match place {
                Some(position) => -self.table[(row, position + 1)],
                None if self.basic[row] == variable => 1.0,
                None => 0.0,
            });
        }
        // What is left differs by rounding only.
        let slope = |row: usize| self.table[(row, column)];
        first
            .into_iter()
            .min_by(|&a, &b| slope(a).total_cmp(&slope(b)))
    }

    /// Those of `rows` for which value / −slope is least, up to rounding of the values (Harris 1973).
    fn first_to_vanish(
        &self,
        rows: Vec<usize>,
        column: usize,
        value: impl Fn(usize) -> f64,
    ) -> Vec<usize> {
        let largest = rows
            .iter()
            .fold(0.0, |largest: f64, &row| largest.max(value(row).abs()));
        let time = |row: usize, slack: f64| (value(row) + slack) / -self.table[(row, column)];
        let limit = rows.iter().fold(f64::INFINITY, |least, &row| {
            least.min(time(row, ROUNDING * largest))
        });
        rows.into_iter()
            .filter(|&row| time(row, 0.0) <= limit)
            .collect()
    }

    /// Whether z₀ is zero up to rounding, so that the dictionary holds a solution.
    fn is_uncovered(&self) -> bool {
        let rounding = ROUNDING * self.table.column(0).amax();
        let row = self.basic.iter().position(|&variable| variable == 0);
        row.is_none_or(|row| self.table[(row, 0)] <= rounding)
    }
}

/// Solves the problem with covering vector `cover` (positive) in at most `limit` pivots, which are counted in `work`.
pub(super) fn lemke(
    matrix: &DMatrix<f64>,
    constant: &DVector<f64>,
    cover: &DVector<f64>,
    limit: usize,
    work: &mut Work,
) -> Outcome {
    let n = constant.len();
    if constant.iter().all(|&value| value >= 0.0) {
        return Outcome::Solved(DVector::zeros(n));
    }
    // Column 1 is z₀, the others are z.
    let mut table = DMatrix::zeros(n, n + 2);
    table.column_mut(0).copy_from(constant);
    table.column_mut(1).copy_from(cover);
    table.view_mut((0, 2), (n, n)).copy_from(matrix);
    let mut dictionary = Dictionary {
        table,
        basic: (1..=n).collect(),
        nonbasic: std::iter::once(0).chain(n + 1..=2 * n).collect(),
    };
    // Of equal ratios the last one is lexicographically least.
    let start = (0..n).rev().min_by(|&a, &b| {
        let ratio = |k: usize| constant[k] / cover[k];
        ratio(a).total_cmp(&ratio(b))
    });
    let Some(mut row) = start else {
        return Outcome::Ray;
    };
    let mut column = 1;
    for _ in 0..limit {
        let leaving = dictionary.basic[row];
        dictionary.pivot(row, column);
        work.pivots += 1;
        work.operations += pivot_operations(n);
        if dictionary.is_uncovered() {
            return Outcome::Solved(read_off(&dictionary, n));
        }
        let entering = if leaving > n {
            leaving - n
        } else {
            leaving + n
        };
        let Some(position) = dictionary
            .nonbasic
            .iter()
            .position(|&variable| variable == entering)
        else {
            return Outcome::Ray;
        };
        column = position + 1;
        match dictionary.leaving(column) {
            Some(next) => row = next,
            None => return Outcome::Ray,
        }
    }
    Outcome::Limit
}

fn read_off(dictionary: &Dictionary, n: usize) -> DVector<f64> {
    let mut z = DVector::zeros(n);
    for (row, &variable) in dictionary.basic.iter().enumerate() {
        if variable > n {
            z[variable - n - 1] = dictionary.table[(row, 0)].max(0.0);
        }
    }
    z
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn solves_positive_definite_problems() {
        for n in [1, 2, 5, 30] {
            let a = DMatrix::from_fn(n, n, |i, j| {
                ((i * 5 + j * 3 + i * j) % 7) as f64 / 7.0 - 0.4
            });
            let matrix = &a * a.transpose() + DMatrix::identity(n, n) * 0.5;
            let constant = DVector::from_fn(n, |i, _| ((i * 11) % 5) as f64 - 2.0);
            let mut work = Work::default();
            let Outcome::Solved(z) = lemke(
                &matrix,
                &constant,
                &DVector::repeat(n, 1.0),
                1000,
                &mut work,
            ) else {
                panic!("a positive definite problem has a solution");
            };
            let w = &matrix * &z + &constant;
            assert!(z.min() >= 0.0 && w.min() > -1e-12 && z.dot(&w).abs() < 1e-11);
        }
    }

    #[test]
    fn a_ray_is_not_a_solution() {
        // w = −z − 1 has none.
        let (matrix, constant) = (
            DMatrix::from_element(1, 1, -1.0),
            DVector::from_element(1, -1.0),
        );
        assert_eq!(
            lemke(
                &matrix,
                &constant,
                &DVector::repeat(1, 1.0),
                10,
                &mut Work::default()
            ),
            Outcome::Ray
        );
    }
}
