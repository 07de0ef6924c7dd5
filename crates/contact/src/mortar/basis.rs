//! Multiplier functions of one edge.

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::element::EdgeValues;

use super::Multipliers;

/// Functions from which an edge's multipliers are made, by the part of it that faces the other body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Family {
    /// The edge's own shape functions.
    Shape,
    /// Piecewise linear between neighbouring nodes: their integral over any part of the edge is positive.
    Hats,
}

impl Family {
    /// Values at parameter `at` of an edge with nodes at `span` whose shape functions there are `shape`.
    pub(super) fn values(self, span: &[f64], shape: EdgeValues, at: f64) -> EdgeValues {
        if self == Self::Shape {
            return shape;
        }
        // The last node at or before `at` that another follows.
        let node = (span.partition_point(|&node| node <= at)).clamp(1, span.len() - 1) - 1;
        let part = (at - span[node]) / (span[node + 1] - span[node]);
        let mut values = EdgeValues::default();
        values[node] = 1.0 - part;
        values[node + 1] = part;
        values
    }
}

/// The matrix T of ψ = T φ for `size` functions φ with values `samples` and weights of integration.
pub(super) fn combination(
    multipliers: Multipliers,
    size: usize,
    samples: &[(f64, &[f64])],
) -> DMatrix<f64> {
    let dual = match multipliers {
        Multipliers::Standard => None,
        Multipliers::Dual => dual(size, samples),
    };
    dual.unwrap_or_else(|| DMatrix::identity(size, size))
}

/// D M⁻¹ over the functions that do not vanish on the samples; `None` if those cannot be distinguished.
fn dual(functions: usize, samples: &[(f64, &[f64])]) -> Option<DMatrix<f64>> {
    /// Smallest eigenvalue of the mass matrix of functions of unit norm, below which half of the digits are lost.
    const DISTINCT: f64 = 1e-8;
    let mut mass = DMatrix::<f64>::zeros(functions, functions);
    let mut integrals = DVector::<f64>::zeros(functions);
    for &(weight, values) in samples {
        for (i, a) in values.iter().enumerate() {
            integrals[i] += weight * a;
            for (j, b) in values.iter().enumerate() {
                mass[(i, j)] += weight * a * b;
            }
        }
    }
    let present: Vec<usize> = (0..functions).filter(|&i| mass[(i, i)] > 0.0).collect();
    let norms: Vec<f64> = present.iter().map(|&i| mass[(i, i)].sqrt()).collect();
    let size = present.len();
    let scaled = DMatrix::from_fn(size, size, |i, j| {
        mass[(present[i], present[j])] / (norms[i] * norms[j])
    });
    if scaled.symmetric_eigenvalues().min() < DISTINCT {
        return None;
    }
    let inverse = scaled.try_inverse()?;
    let mut combination = DMatrix::zeros(functions, functions);
    for i in 0..size {
        for j in 0..size {
            combination[(present[i], present[j])] =
                integrals[present[i]] * inverse[(i, j)] / (norms[i] * norms[j]);
        }
    }
    Some(combination)
}

#[cfg(test)]
mod tests {
    use super::*;
    use stickslip_fem_core::element::{edge_nodes, edge_rule, edge_shape};

    fn of_edge(order: usize) -> DMatrix<f64> {
        let samples: Vec<(f64, EdgeValues)> = (edge_rule(order).iter())
            .map(|&(xi, weight)| (weight, edge_shape(order, xi)))
            .collect();
        let slices: Vec<_> = (samples.iter())
            .map(|(weight, values)| (*weight, &values[..=order]))
            .collect();
        combination(Multipliers::Dual, order + 1, &slices)
    }

    /// Wohlmuth (2000): ψ₁ = 2 N₁ − N₂.
    #[test]
    fn dual_functions_of_a_linear_edge() {
        let t = of_edge(1);
        let expected = DMatrix::from_row_slice(2, 2, &[2.0, -1.0, -1.0, 2.0]);
        assert!((&t - expected).amax() < 1e-14, "{t}");
    }

    /// M = (2/30) [4 2 −1; 2 16 2; −1 2 4], D = (2/6) (1, 4, 1): the rows of D M⁻¹ by hand.
    #[test]
    fn dual_functions_of_a_quadratic_edge() {
        let t = of_edge(2);
        let expected = DMatrix::from_row_slice(
            3,
            3,
            &[
                1.5, -0.25, 0.5, //
                -1.0, 1.5, -1.0, //
                0.5, -0.25, 1.5,
            ],
        );
        assert!((&t - expected).amax() < 1e-13, "{t}");
    }

    /// ∫ ψ_k N_j = δ_kj ∫ N_j, the Lobatto weight, on edges of every order.
    #[test]
    fn dual_functions_are_biorthogonal() {
        for order in 1..=8 {
            let t = of_edge(order);
            let weights = edge_nodes(order).unwrap();
            let mut products = DMatrix::zeros(order + 1, order + 1);
            for &(xi, weight) in edge_rule(order) {
                let shape = DVector::from_column_slice(&edge_shape(order, xi)[..=order]);
                products += weight * (&t * &shape) * shape.transpose();
            }
            for k in 0..=order {
                for j in 0..=order {
                    let expected = if k == j { weights[j].1 } else { 0.0 };
                    // Rounding of an inverse whose condition is below 1e3 on these nodes.
                    assert!((products[(k, j)] - expected).abs() < 1e-12, "order {order}");
                }
            }
        }
    }

    #[test]
    fn functions_that_are_linearly_dependent_have_no_dual() {
        let at_one_place: &[f64] = &[0.4, 0.6];
        assert_eq!(
            combination(Multipliers::Dual, 2, &[(1.0, at_one_place)]),
            DMatrix::identity(2, 2)
        );
    }
}
