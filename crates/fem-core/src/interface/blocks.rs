//! The compliance of a body with many edges in contact, as blocks: dense within an edge, of low rank between edges.
//!
//! ```text
//! C = diag(C_1, …, C_N) + U M Uᵀ,     U = diag(U_1, …, U_N),     M_kk = 0
//! ```
//!
//! The columns of U_k are the few shapes of forces on edge k that reach the other edges, on a hole its lowest harmonics. Memory is
//! 8 (Σ n_k² + (Σ r_k)²) bytes, with n_k components and r_k shapes of edge k, where the whole matrix takes 8 (Σ n_k)².

use nalgebra::{DMatrix, DVector};

/// One block: the components of an edge.
#[derive(Clone, Debug, PartialEq)]
pub struct Block {
    /// Their numbers among all components, ascending, n.
    pub rows: Vec<usize>,
    /// Compliance of the edge `[length/force]`, n × n.
    pub own: DMatrix<f64>,
    /// Shapes of forces that reach other blocks `[1]`, n × r.
    pub shapes: DMatrix<f64>,
}

/// A symmetric compliance in blocks.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockCompliance {
    blocks: Vec<Block>,
    /// First shape of each block, and their number at the end.
    first: Vec<usize>,
    core: DMatrix<f64>,
    /// Block of each component, and its number in it.
    place: Vec<(usize, usize)>,
}

impl BlockCompliance {
    /// The compliance of `blocks`, whose rows are together those of all components, each once, with M = `core` `[length/force]`, Σr × Σr,
    /// symmetric and zero between shapes of one block.
    pub fn new(blocks: Vec<Block>, core: DMatrix<f64>) -> Self {
        let mut first = vec![0];
        let order = blocks.iter().map(|block| block.rows.len()).sum();
        let mut place = vec![(0, 0); order];
        for (index, block) in blocks.iter().enumerate() {
            first.push(first[index] + block.shapes.ncols());
            for (local, &row) in block.rows.iter().enumerate() {
                place[row] = (index, local);
            }
        }
        Self {
            blocks,
            first,
            core,
            place,
        }
    }

    /// Number of components.
    pub fn order(&self) -> usize {
        self.place.len()
    }

    /// The blocks.
    pub fn blocks(&self) -> &[Block] {
        &self.blocks
    }

    /// M `[length/force]` between the shapes of all blocks.
    pub fn core(&self) -> &DMatrix<f64> {
        &self.core
    }

    /// Range of the shapes of block `block` among those of all.
    pub fn shapes_of(&self, block: usize) -> std::ops::Range<usize> {
        self.first[block]..self.first[block + 1]
    }

    /// The block of the component `row`, and its number there.
    pub fn place(&self, row: usize) -> (usize, usize) {
        self.place[row]
    }

    /// Largest number of shapes of a block.
    pub fn rank(&self) -> usize {
        let ranks = self.blocks.iter().map(|block| block.shapes.ncols());
        ranks.max().unwrap_or(0)
    }

    /// Numbers that are held.
    pub fn entries(&self) -> usize {
        let of_block = |block: &Block| block.own.len() + block.shapes.len();
        self.core.len() + self.blocks.iter().map(of_block).sum::<usize>()
    }

    /// The compliance of each component under its own force `[length/force]`.
    pub fn diagonal(&self) -> DVector<f64> {
        let own = |&(block, local): &(usize, usize)| self.blocks[block].own[(local, local)];
        DVector::from_iterator(self.order(), self.place.iter().map(own))
    }

    /// Computes C f `[length]` of the forces `forces` `[force]`.
    pub fn times(&self, forces: &DVector<f64>) -> DVector<f64> {
        let mut reach = DVector::zeros(self.core.nrows());
        let mut moved = DVector::zeros(self.order());
        for (index, block) in self.blocks.iter().enumerate() {
            let own = block.gathered(forces);
            if own.iter().all(|&force| force == 0.0) {
                continue;
            }
            block.scatter(&(&block.own * &own), &mut moved);
            let shapes = self.shapes_of(index);
            reach
                .rows_range_mut(shapes)
                .gemv_tr(1.0, &block.shapes, &own, 0.0);
        }
        let felt = &self.core * reach;
        for (index, block) in self.blocks.iter().enumerate() {
            let felt = felt.rows_range(self.shapes_of(index));
            block.scatter(&(&block.shapes * felt), &mut moved);
        }
        moved
    }

    /// The column `column` of C `[length/force]`, 2n.
    pub fn column(&self, column: usize) -> DVector<f64> {
        let mut unit = DVector::zeros(self.order());
        unit[column] = 1.0;
        self.times(&unit)
    }

    /// C as one matrix `[length/force]`, 2n × 2n.
    pub fn matrix(&self) -> DMatrix<f64> {
        let all: Vec<usize> = (0..self.order()).collect();
        self.part(&all, &all)
    }

    /// The part of C `[length/force]` in `rows` and `columns`.
    pub fn part(&self, rows: &[usize], columns: &[usize]) -> DMatrix<f64> {
        let mut part = DMatrix::zeros(rows.len(), columns.len());
        let (above, beside) = (self.by_block(rows), self.by_block(columns));
        let chosen: Vec<DMatrix<f64>> = (beside.iter().zip(&self.blocks))
            .map(|(own, block)| block.shapes.select_rows(own.iter().map(|(_, local)| local)))
            .collect();
        for (i, (own, block)) in above.iter().zip(&self.blocks).enumerate() {
            if own.is_empty() {
                continue;
            }
            let felt = block.shapes.select_rows(own.iter().map(|(_, local)| local))
                * self.core.rows_range(self.shapes_of(i));
            for (j, other) in beside.iter().enumerate() {
                if i == j {
                    for &(column, b) in other {
                        for &(row, a) in own {
                            part[(row, column)] = block.own[(a, b)];
                        }
                    }
                } else if !other.is_empty() {
                    let between = felt.columns_range(self.shapes_of(j)) * chosen[j].transpose();
                    for (values, &(column, _)) in between.column_iter().zip(other) {
                        for (value, &(row, _)) in values.iter().zip(own) {
                            part[(row, column)] = *value;
                        }
                    }
                }
            }
        }
        part
    }

    /// For each block the positions in `rows` of its components, with their numbers in the block.
    fn by_block(&self, rows: &[usize]) -> Vec<Vec<(usize, usize)>> {
        let mut all = vec![Vec::new(); self.blocks.len()];
        for (position, &row) in rows.iter().enumerate() {
            let (block, local) = self.place[row];
            all[block].push((position, local));
        }
        all
    }
}

impl Block {
    /// Its components of `all`.
    fn gathered(&self, all: &DVector<f64>) -> DVector<f64> {
        DVector::from_iterator(self.rows.len(), self.rows.iter().map(|&row| all[row]))
    }

    /// Adds `own`, one number for each of its components, to those of all.
    fn scatter(&self, own: &DVector<f64>, all: &mut DVector<f64>) {
        for (value, &row) in own.iter().zip(&self.rows) {
            all[row] += value;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Blocks of 2, 3 and 1 components in mixed order, with 1, 2 and 1 shapes.
    fn sample() -> BlockCompliance {
        let rows = [vec![0, 4], vec![1, 2, 5], vec![3]];
        let first = [0, 1, 3, 4];
        let value = |i: usize, j: usize| ((i * 5 + j * 3) % 7) as f64 / 7.0;
        let blocks = rows.into_iter().enumerate().map(|(k, rows)| {
            let n = rows.len();
            Block {
                rows,
                own: DMatrix::from_fn(n, n, |i, j| value(i + j + k, i * j) + 2.0),
                shapes: DMatrix::from_fn(n, first[k + 1] - first[k], |i, j| value(i + k, j)),
            }
        });
        let of = |shape: usize| first[1..].iter().filter(|&&end| end <= shape).count();
        let core = DMatrix::from_fn(4, 4, |i, j| {
            if of(i) == of(j) {
                0.0
            } else {
                value(i + j, i * j)
            }
        });
        BlockCompliance::new(blocks.collect(), core)
    }

    #[test]
    fn parts_columns_and_products_are_those_of_one_matrix() {
        let blocks = sample();
        let whole = blocks.matrix();
        // The middle product is summed in another order on either side.
        assert!((&whole - whole.transpose()).amax() < 1e-15);
        assert_eq!(blocks.diagonal(), whole.diagonal());
        for column in 0..6 {
            assert!((blocks.column(column) - whole.column(column)).amax() < 1e-15);
        }
        let forces = DVector::from_vec(vec![1.0, -2.0, 0.0, 0.5, 3.0, 0.0]);
        // Sums of a dozen products of order ten.
        assert!((blocks.times(&forces) - &whole * &forces).amax() < 1e-13);
        let (rows, columns) = ([5, 0, 3], [2, 4]);
        let part = blocks.part(&rows, &columns);
        let expected = whole.select_rows(&rows).select_columns(&columns);
        assert!((part - expected).amax() < 1e-15);
    }
}
