//! Nodal stress by extrapolation from the quadrature points.
//!
//! In each cell the polynomial of the reference coordinates that fits the stresses at the quadrature points best, weighted
//! by the quadrature weights,
//!
//! ```text
//! σ̂(ξ) = Σₖ cₖ φₖ(ξ),   min Σ_q w_q |σ̂(ξ_q) − σ_q|²,   φ = 1 (T3), 1 ξ η (T6), 1 ξ η ξη (Q4, Q8, Q9), Pᵢ(ξ) Pⱼ(η) (i, j < p),
//! ```
//!
//! is evaluated at the nodes, and the values of the cells that meet at a node are averaged. On 3×3 Gauss points the fit
//! equals bilinear extrapolation from the 2×2 points, where serendipity and Lagrange cells are superconvergent; on (p + 1)² points,
//! with Legendre's polynomials, extrapolation from p×p points.
//!
//! Stress may jump where two materials meet, so averages never cross from one block to another.

use nalgebra::DMatrix;

use super::gauss::{ElasticField, Points};
use crate::element::{Element, KindVisitor, with_element};
use crate::mesh::{ElementKind, Point};

/// Stress at the nodes of one block.
#[derive(Clone, Debug, PartialEq)]
pub struct BlockStresses {
    /// Global indices of the block's nodes, ascending.
    pub nodes: Vec<usize>,
    /// Stress (σ_xx, σ_yy, τ_xy) at each of these nodes `[stress]`.
    pub values: Vec<[f64; 3]>,
}

impl BlockStresses {
    /// Stress (σ_xx, σ_yy, τ_xy) `[stress]` at the global node `node`, `None` if the block does not touch it.
    pub fn at(&self, node: usize) -> Option<[f64; 3]> {
        self.nodes.binary_search(&node).ok().map(|k| self.values[k])
    }
}

/// Stress at the nodes, block by block: a node between two blocks has a value in each.
#[derive(Clone, Debug, PartialEq)]
pub struct NodalStresses {
    pub(super) blocks: Vec<BlockStresses>,
    pub(super) node_count: usize,
}

impl NodalStresses {
    /// Stresses of each block of the mesh, in order.
    pub fn blocks(&self) -> &[BlockStresses] {
        &self.blocks
    }

    /// One stress per node of the mesh, the plain mean of the blocks that meet there `[stress]`: for pictures, not for
    /// numbers where materials meet.
    pub fn averaged(&self) -> Vec<[f64; 3]> {
        let mut mean = Mean::new(self.node_count);
        for block in &self.blocks {
            for (&node, &value) in block.nodes.iter().zip(&block.values) {
                mean.add(node, value);
            }
        }
        mean.into_values()
    }

    /// The mean, as [`Self::averaged`], of a quantity that `of` makes of a block's index and the stress `[stress]` there: one per node, in the unit of `of`.
    pub fn averaged_of(&self, of: impl Fn(usize, [f64; 3]) -> f64) -> Vec<f64> {
        let mut mean = Mean::new(self.node_count);
        for (index, block) in self.blocks.iter().enumerate() {
            for (&node, &value) in block.nodes.iter().zip(&block.values) {
                mean.add(node, [of(index, value), 0.0, 0.0]);
            }
        }
        mean.into_values()
            .into_iter()
            .map(|[value, ..]| value)
            .collect()
    }
}

impl ElasticField<'_> {
    /// Stress at every node, extrapolated from the quadrature points of each cell and averaged within each block.
    ///
    /// Inside a smooth mesh the error falls as h² on kinds of order 1 and 2; at the boundary as h on T3 and Q4, as h² on T6, Q8 and Q9.
    /// On kinds of order p > 2 it falls as h^p everywhere.
    pub fn nodal_stresses(&self) -> NodalStresses {
        let blocks = (0..self.mesh.blocks().len())
            .map(|block| self.extrapolated(block))
            .collect();
        NodalStresses {
            blocks,
            node_count: self.mesh.nodes().len(),
        }
    }

    pub(super) fn extrapolated(&self, block: usize) -> BlockStresses {
        let cells = &self.mesh.blocks()[block];
        let samples = self.sample(block, Points::Quadrature);
        let weights = extrapolation(cells.kind);
        let mut mean = Mean::new(self.mesh.nodes().len());
        for (cell, nodes) in cells
            .connectivity
            .chunks_exact(cells.kind.nodes())
            .enumerate()
        {
            let stress = &samples.stress[samples.of(cell)];
            for (a, &node) in nodes.iter().enumerate() {
                let mut value = [0.0; 3];
                for (q, sample) in stress.iter().enumerate() {
                    (0..3).for_each(|i| value[i] += weights[(a, q)] * sample[i]);
                }
                mean.add(node, value);
            }
        }
        mean.into_block()
    }
}

/// Means of stresses at nodes.
pub(super) struct Mean {
    sum: Vec<[f64; 3]>,
    count: Vec<u32>,
}

impl Mean {
    pub(super) fn new(nodes: usize) -> Self {
        Self {
            sum: vec![[0.0; 3]; nodes],
            count: vec![0; nodes],
        }
    }

    pub(super) fn add(&mut self, node: usize, value: [f64; 3]) {
        (0..3).for_each(|i| self.sum[node][i] += value[i]);
        self.count[node] += 1;
    }

    pub(super) fn has(&self, node: usize) -> bool {
        self.count[node] > 0
    }

    fn value(&self, node: usize) -> [f64; 3] {
        self.sum[node].map(|sum| sum / f64::from(self.count[node].max(1)))
    }

    fn into_values(self) -> Vec<[f64; 3]> {
        (0..self.sum.len()).map(|node| self.value(node)).collect()
    }

    pub(super) fn into_block(self) -> BlockStresses {
        let nodes: Vec<usize> = (0..self.sum.len()).filter(|&node| self.has(node)).collect();
        let values = nodes.iter().map(|&node| self.value(node)).collect();
        BlockStresses { nodes, values }
    }
}

/// The matrix `[1]` that takes values at the quadrature points of a cell of `kind` (columns) to values at its nodes (rows): what
/// [`ElasticField::nodal_stresses`] does in each cell.
pub fn extrapolation(kind: ElementKind) -> DMatrix<f64> {
    with_element(kind, Extrapolation)
}

/// Yields the matrix that takes values at quadrature points (columns) to values at nodes (rows).
struct Extrapolation;

impl KindVisitor for Extrapolation {
    type Output = DMatrix<f64>;

    fn visit<const N: usize, E: Element<N>>(self) -> DMatrix<f64> {
        let basis = |xi: Point| basis(E::KIND, xi);
        let terms = basis([0.0; 2]).len();
        let points = E::QUADRATURE;
        let sampled = DMatrix::from_fn(terms, points.len(), |k, q| basis(points[q].at)[k]);
        let weighted = DMatrix::from_fn(terms, points.len(), |k, q| {
            points[q].weight * basis(points[q].at)[k]
        });
        let at_nodes = DMatrix::from_fn(N, terms, |a, k| basis(E::NODES[a])[k]);
        let gram = &weighted * sampled.transpose();
        // The basis of every kind is unisolvent on its quadrature points, so the Gram matrix is positive definite; the test
        // `every_kind_extrapolates_its_basis` visits all kinds.
        let coefficients = gram
            .lu()
            .solve(&weighted)
            .expect("positive definite Gram matrix");
        at_nodes * coefficients
    }
}

/// Terms of the fit in a cell of `kind` at the reference point (ξ, η): complete polynomials of degree p − 1 on triangles, products of
/// Legendre's polynomials of degree p − 1, at least 1, on quadrilaterals.
fn basis(kind: ElementKind, [xi, eta]: Point) -> Vec<f64> {
    let degree = kind.order() - 1;
    if kind.corners() == 3 {
        let power = |k: usize, j: usize| xi.powi((k - j) as i32) * eta.powi(j as i32);
        return (0..=degree)
            .flat_map(|k| (0..=k).map(move |j| power(k, j)))
            .collect();
    }
    let [along_xi, along_eta] = [xi, eta].map(|x| legendre(degree.max(1), x));
    (along_eta.iter())
        .flat_map(|q| along_xi.iter().map(move |p| p * q))
        .collect()
}

/// Legendre's polynomials of degree 0 … `degree` at `x`.
fn legendre(degree: usize, x: f64) -> Vec<f64> {
    let mut values = vec![1.0, x];
    for k in 2..=degree {
        let (k_th, odd) = (k as f64, (2 * k - 1) as f64);
        values.push((odd * x * values[k - 1] - (k_th - 1.0) * values[k - 2]) / k_th);
    }
    values
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Largest difference at the nodes between a term of the basis and its extrapolation.
    struct Error;

    impl KindVisitor for Error {
        type Output = f64;

        fn visit<const N: usize, E: Element<N>>(self) -> f64 {
            let at = |places: &[Point]| {
                let columns: Vec<_> = places.iter().map(|&xi| basis(E::KIND, xi)).collect();
                DMatrix::from_fn(columns.len(), columns[0].len(), |a, k| columns[a][k])
            };
            let points: Vec<Point> = E::QUADRATURE.iter().map(|point| point.at).collect();
            (extrapolation(E::KIND) * at(&points) - at(&E::NODES)).amax()
        }
    }

    #[test]
    fn every_kind_extrapolates_its_basis() {
        for kind in ElementKind::ALL {
            let error = with_element(kind, Error);
            assert!(error < 1e-12, "{kind:?}: {error:.1e}");
        }
    }
}
