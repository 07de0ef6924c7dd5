//! The dictionary of a linear complementarity problem: some variables as linear functions of the others.

use nalgebra::DMatrix;

/// A variable of the dictionary: z₀ has index 0, wᵢ index 1 + i, zᵢ index 1 + n + i.
pub(super) type Variable = usize;

pub(super) struct Dictionary {
    /// Rows: basic variables; columns: constant, then non-basic variables. basic = table · (1, nonbasic).
    pub(super) table: DMatrix<f64>,
    pub(super) basic: Vec<Variable>,
    pub(super) nonbasic: Vec<Variable>,
}

impl Dictionary {
    /// Exchanges the basic variable of `row` with the non-basic one of `column`.
    pub(super) fn pivot(&mut self, row: usize, column: usize) {
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
}
