//! Parts of a sparse Cholesky factor, and solves with its trailing block.

use std::ops::Range;

use faer::linalg::matmul::matmul;
use faer::linalg::triangular_solve::solve_lower_triangular_in_place;
use faer::reborrow::{Reborrow, ReborrowMut};
use faer::{Accum, Mat, MatMut, Par};
use nalgebra::DMatrix;

use super::SparseCholesky;

impl SparseCholesky {
    /// Copies the trailing block of L, `count` × `count`, lower triangular, in the unit of L; `count` is at most the number of unknowns.
    pub fn trailing_block(&self, count: usize) -> DMatrix<f64> {
        let order = self.unknowns();
        self.block(order - count..order, order - count..order)
    }

    /// Copies the part of L in `rows` and `columns`, in the unit of L.
    pub fn block(&self, rows: Range<usize>, columns: Range<usize>) -> DMatrix<f64> {
        let mut block = DMatrix::zeros(rows.len(), columns.len());
        let Some(factor) = self.supernodal() else {
            return block;
        };
        let symbolic = factor.symbolic();
        let starts = symbolic.supernode_begin();
        let from = starts.partition_point(|&start| start <= columns.start);
        for s in from.saturating_sub(1)..symbolic.n_supernodes() {
            let supernode = factor.supernode(s);
            let (start, entries) = (supernode.start(), supernode.val());
            let width = entries.ncols();
            if start >= columns.end {
                break;
            }
            let pattern = supernode.pattern();
            for column in columns.start.max(start)..columns.end.min(start + width) {
                let local = column - start;
                for row in rows.start.max(column)..rows.end.min(start + width) {
                    block[(row - rows.start, column - columns.start)] =
                        entries[(row - start, local)];
                }
                let first = pattern.partition_point(|&row| row < rows.start);
                for (k, &row) in pattern.iter().enumerate().skip(first) {
                    if row >= rows.end {
                        break;
                    }
                    block[(row - rows.start, column - columns.start)] = entries[(width + k, local)];
                }
            }
        }
        block
    }

    /// Overwrites `x`, columns of one entry for each unknown from `first` on, with T⁻¹ x, T the trailing block of L from there, in any units.
    pub fn solve_trailing(&self, first: usize, x: &mut DMatrix<f64>) {
        let Some(factor) = self.supernodal() else {
            return;
        };
        let (order, count) = x.shape();
        let mut x = MatMut::from_column_major_slice_mut(x.as_mut_slice(), order, count);
        let symbolic = factor.symbolic();
        let ends = symbolic.supernode_end();
        for s in ends.partition_point(|&end| end <= first)..symbolic.n_supernodes() {
            let supernode = factor.supernode(s);
            let (start, entries) = (supernode.start(), supernode.val());
            let width = entries.ncols();
            let skipped = first.saturating_sub(start);
            let (own, at) = (width - skipped, start + skipped - first);
            let entries = entries.subcols(skipped, own);
            let diagonal = entries.subrows(skipped, own);
            if (0..count).all(|c| (at..at + own).all(|row| x[(row, c)] == 0.0)) {
                continue;
            }
            solve_lower_triangular_in_place(diagonal, x.rb_mut().subrows_mut(at, own), Par::Seq);
            let below = entries.subrows(width, entries.nrows() - width);
            let mut felt = Mat::<f64>::zeros(below.nrows(), count);
            let moved = x.rb().subrows(at, own);
            matmul(felt.as_mut(), Accum::Replace, below, moved, 1.0, Par::Seq);
            for c in 0..count {
                for (k, &row) in supernode.pattern().iter().enumerate() {
                    x[(row - first, c)] -= felt[(k, c)];
                }
            }
        }
    }
}
