//! Lemke's method for the linear complementarity problem
//!
//!     w = M z + q,   z ≥ 0, w ≥ 0, zᵀw = 0
//!
//! (Cottle, Pang & Stone 1992, §4.4) on a dense dictionary. The covering vector d makes z₀ large enough that every w
//! starts non-negative; pivots follow the complementary rule until z₀ leaves. Ties in the ratio test go to z₀ first and
//! then to the larger pivot.

use nalgebra::{DMatrix, DVector};

/// Outcome of Lemke's method.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Outcome {
    /// The complementary solution z.
    Solved(DVector<f64>),
    /// A secondary ray was met, or the pivot limit.
    Unsolved,
}

/// A variable of the dictionary: z₀ has index 0, wᵢ index 1 + i, zᵢ index 1 + n + i.
type Variable = usize;

struct Dictionary {
    /// Rows: basic variables; columns: constant, then non-basic variables. basic = table · (1, nonbasic).
    table: DMatrix<f64>,
    basic: Vec<Variable>,
    nonbasic: Vec<Variable>,
}

impl Dictionary {
    /// Exchanges the basic variable of `row` with the non-basic one of `column`.
    fn pivot(&mut self, row: usize, column: usize) {
        let pivot = self.table[(row, column)];
        let pivot_row: Vec<f64> = self
            .table
            .row(row)
            .iter()
            .map(|value| -value / pivot)
            .collect();
        let pivot_column = self.table.column(column).into_owned();
        for (j, &factor) in pivot_row.iter().enumerate() {
            if j == column {
                let mut target = self.table.column_mut(j);
                target.copy_from(&(&pivot_column / pivot));
                target[row] = 1.0 / pivot;
            } else {
                let mut target = self.table.column_mut(j);
                if factor != 0.0 {
                    target.axpy(factor, &pivot_column, 1.0);
                }
                target[row] = factor;
            }
        }
        std::mem::swap(&mut self.basic[row], &mut self.nonbasic[column - 1]);
    }

    /// Row of the first basic variable to vanish as the non-basic one of `column` grows; `None` on a ray.
    fn leaving(&self, column: usize) -> Option<usize> {
        const TIE: f64 = 1e-12;
        let largest = self.table.column(column).amax();
        let mut best: Option<(f64, usize)> = None;
        for row in 0..self.basic.len() {
            let slope = self.table[(row, column)];
            if slope >= -1e-11 * largest {
                continue;
            }
            let ratio = self.table[(row, 0)].max(0.0) / -slope;
            let better = match best {
                None => true,
                Some((least, other)) => {
                    let tie = (ratio - least).abs() <= TIE * (1.0 + least.abs());
                    if tie {
                        self.basic[other] != 0
                            && (self.basic[row] == 0
                                || slope.abs() > self.table[(other, column)].abs())
                    } else {
                        ratio < least
                    }
                }
            };
            if better {
                best = Some((ratio, row));
            }
        }
        best.map(|(_, row)| row)
    }
}

/// Solves the problem with covering vector `cover` (positive) in at most `limit` pivots, which are counted in `pivots`.
pub(super) fn lemke(
    matrix: &DMatrix<f64>,
    constant: &DVector<f64>,
    cover: &DVector<f64>,
    limit: usize,
    pivots: &mut usize,
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
    let start = (0..n)
        .map(|k| constant[k] / cover[k])
        .enumerate()
        .min_by(|a, b| a.1.total_cmp(&b.1));
    let Some((mut row, _)) = start else {
        return Outcome::Unsolved;
    };
    let mut column = 1;
    for _ in 0..limit {
        let leaving = dictionary.basic[row];
        dictionary.pivot(row, column);
        *pivots += 1;
        if leaving == 0 {
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
            return Outcome::Unsolved;
        };
        column = position + 1;
        match dictionary.leaving(column) {
            Some(next) => row = next,
            None => return Outcome::Unsolved,
        }
    }
    Outcome::Unsolved
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
            let mut pivots = 0;
            let Outcome::Solved(z) = lemke(
                &matrix,
                &constant,
                &DVector::repeat(n, 1.0),
                1000,
                &mut pivots,
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
            lemke(&matrix, &constant, &DVector::repeat(1, 1.0), 10, &mut 0),
            Outcome::Unsolved
        );
    }
}
