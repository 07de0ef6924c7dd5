//! Roughness of displacements along the boundary.
//!
//! ```text
//! dᵀ R d = Σ_i h_i |k! d[s_i, …, s_{i+k}]|²,   h_i = (s_{i+k} − s_i)/k
//! ```
//!
//! with divided differences over neighbouring nodes at arc lengths s, which need no equal spacing.

use stickslip_fem_core::linalg::Matrix;

use crate::region::Region;
use crate::region::outline::{Chain, smooth_chains};

/// R for differences of order `order`, over the prescribed degrees of freedom.
pub(super) fn penalty(region: &Region, order: usize) -> Matrix {
    let mut position = vec![None; 2 * region.mesh().nodes().len()];
    for (k, &dof) in region.prescribed().iter().enumerate() {
        position[dof] = Some(k);
    }
    let size = region.prescribed().len();
    let mut matrix = Matrix::zeros(size, size);
    for chain in smooth_chains(region.mesh()) {
        for window in windows(region, &chain, order) {
            let weights = difference(&window.lengths, order);
            let step = (window.lengths[order] - window.lengths[0]) / order as f64;
            for axis in 0..2 {
                let own = window.nodes.iter().map(|node| position[2 * node + axis]);
                let Some(own) = own.collect::<Option<Vec<usize>>>() else {
                    continue;
                };
                for (&i, a) in own.iter().zip(&weights) {
                    for (&j, b) in own.iter().zip(&weights) {
                        matrix[(i, j)] += step * a * b;
                    }
                }
            }
        }
    }
    matrix
}

/// Neighbouring nodes with their positions along the boundary.
struct Window {
    nodes: Vec<usize>,
    lengths: Vec<f64>,
}

/// All runs of `order` + 1 nodes of a chain.
fn windows(region: &Region, chain: &Chain, order: usize) -> Vec<Window> {
    let count = chain.nodes.len();
    let runs = match (chain.closed, count > order) {
        (_, false) => 0,
        (true, true) => count,
        (false, true) => count - order,
    };
    let nodes = region.mesh().nodes();
    let run = |first: usize| {
        let own: Vec<usize> = (first..=first + order)
            .map(|k| chain.nodes[k % count])
            .collect();
        let mut lengths = vec![0.0];
        for pair in own.windows(2) {
            let ([x, y], [u, v]) = (nodes[pair[0]], nodes[pair[1]]);
            lengths.push(lengths[lengths.len() - 1] + (u - x).hypot(v - y));
        }
        Window {
            nodes: own,
            lengths,
        }
    };
    (0..runs).map(run).collect()
}

/// Weights of the derivative of order `order` of the polynomial through values at `at`: k!/Π (s_a − s_b).
fn difference(at: &[f64], order: usize) -> Vec<f64> {
    let factorial: f64 = (1..=order).map(|k| k as f64).product();
    (at.iter().enumerate())
        .map(|(a, s)| {
            let others = at.iter().enumerate().filter(|&(b, _)| b != a);
            others.fold(factorial, |weight, (_, other)| weight / (s - other))
        })
        .collect()
}
