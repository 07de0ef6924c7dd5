//! Multiplier functions of one edge.

use nalgebra::{DMatrix, Matrix3, Vector3};

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
    /// Values at parameter `at` of an edge over `span` whose shape functions there are `shape`.
    pub(super) fn values(self, span: [f64; 3], shape: [f64; 3], at: f64) -> [f64; 3] {
        let [start, middle, end] = span;
        match self {
            Self::Shape => shape,
            Self::Hats if at < middle => {
                let part = (at - start) / (middle - start);
                [1.0 - part, part, 0.0]
            }
            Self::Hats => {
                let part = (at - middle) / (end - middle);
                [0.0, 1.0 - part, part]
            }
        }
    }
}

/// The matrix T of ψ = T φ for the functions φ with values `samples` and weights of integration.
pub(super) fn combination(multipliers: Multipliers, samples: &[(f64, [f64; 3])]) -> Matrix3<f64> {
    let plain = Matrix3::identity();
    match multipliers {
        Multipliers::Standard => plain,
        Multipliers::Dual => dual(samples).unwrap_or(plain),
    }
}

/// D M⁻¹ over the functions that do not vanish on the samples; `None` if those cannot be told apart.
fn dual(samples: &[(f64, [f64; 3])]) -> Option<Matrix3<f64>> {
    /// Smallest eigenvalue of the mass matrix of functions of unit norm, below which half of the digits are lost.
    const DISTINCT: f64 = 1e-8;
    let (mut mass, mut integrals) = (Matrix3::zeros(), Vector3::zeros());
    for (weight, values) in samples {
        let values = Vector3::from(*values);
        mass += *weight * values * values.transpose();
        integrals += *weight * values;
    }
    let present: Vec<usize> = (0..3).filter(|&i| mass[(i, i)] > 0.0).collect();
    let norms: Vec<f64> = present.iter().map(|&i| mass[(i, i)].sqrt()).collect();
    let size = present.len();
    let scaled = DMatrix::from_fn(size, size, |i, j| {
        mass[(present[i], present[j])] / (norms[i] * norms[j])
    });
    if scaled.symmetric_eigenvalues().min() < DISTINCT {
        return None;
    }
    let inverse = scaled.try_inverse()?;
    let mut combination = Matrix3::zeros();
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
    use stickslip_fem_core::element::{GAUSS_5, edge_shape};

    fn samples(order: usize) -> Vec<(f64, [f64; 3])> {
        GAUSS_5
            .iter()
            .map(|&(xi, weight)| (weight, edge_shape(order, xi)))
            .collect()
    }

    /// Wohlmuth (2000): ψ₁ = 2 N₁ − N₂.
    #[test]
    fn dual_functions_of_a_linear_edge() {
        let t = combination(Multipliers::Dual, &samples(1));
        let expected = Matrix3::new(2.0, 0.0, -1.0, 0.0, 0.0, 0.0, -1.0, 0.0, 2.0);
        assert!((t - expected).amax() < 1e-14, "{t}");
    }

    /// M = (2/30) [4 2 −1; 2 16 2; −1 2 4], D = (2/6) (1, 4, 1): the rows of D M⁻¹ by hand.
    #[test]
    fn dual_functions_of_a_quadratic_edge() {
        let t = combination(Multipliers::Dual, &samples(2));
        let expected = Matrix3::new(
            1.5, -0.25, 0.5, //
            -1.0, 1.5, -1.0, //
            0.5, -0.25, 1.5,
        );
        assert!((t - expected).amax() < 1e-13, "{t}");
    }

    #[test]
    fn functions_that_cannot_be_told_apart_have_no_dual() {
        let at_one_place = vec![(1.0, [0.4, 0.0, 0.6])];
        assert_eq!(
            combination(Multipliers::Dual, &at_one_place),
            Matrix3::identity()
        );
    }
}
