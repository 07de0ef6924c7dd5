//! The sides of plane elements: shape functions along a boundary edge, and rules to integrate there.
//!
//! The nodes of an edge of order p are the p + 1 Gauss–Lobatto points of [−1, 1], which for orders 1 and 2 are the ends and the
//! middle, and its shape functions the Lagrange polynomials on them:
//!
//! ```text
//! linear: N = ((1 − ξ)/2, (1 + ξ)/2);   quadratic: N = (ξ(ξ − 1)/2, 1 − ξ², ξ(ξ + 1)/2);   ∫ Nₐ dξ = Lobatto's weight > 0
//! ```

use super::legendre::{gauss, lobatto};
use crate::kind::MAX_ORDER;

/// Five-point Gauss–Legendre rule on [−1, 1], abscissa and weight: exact to degree 9.
const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// One number per node of an edge in walk order; zeros after those of an edge of lower order.
pub type EdgeValues = [f64; MAX_ORDER + 1];

/// Nodes and weights of Lobatto's rule on the edge of `order` 1 … [`MAX_ORDER`], in walk order; `None` for any other. The weights
/// are ∫ Nₐ dξ `[1]`.
pub const fn edge_nodes(order: usize) -> Option<&'static [(f64, f64)]> {
    Some(match order {
        1 => &const { lobatto::<2>() },
        2 => &const { lobatto::<3>() },
        3 => &const { lobatto::<4>() },
        4 => &const { lobatto::<5>() },
        5 => &const { lobatto::<6>() },
        6 => &const { lobatto::<7>() },
        7 => &const { lobatto::<8>() },
        8 => &const { lobatto::<9>() },
        _ => return None,
    })
}

/// A Gauss rule on [−1, 1], abscissa and weight `[1]`, for products of shape functions of an edge of `order` with the length of a curved
/// edge: exact to degree 2p + 5 at least.
pub const fn edge_rule(order: usize) -> &'static [(f64, f64)] {
    match order {
        0..=2 => &GAUSS_5,
        3 => &const { gauss::<6>() },
        4 => &const { gauss::<7>() },
        5 => &const { gauss::<8>() },
        6 => &const { gauss::<9>() },
        7 => &const { gauss::<10>() },
        _ => &const { gauss::<11>() },
    }
}

/// Shape functions `[1]` of an edge of polynomial `order` at ξ, in walk order. Zero for orders that do not exist.
pub fn edge_shape(order: usize, xi: f64) -> EdgeValues {
    let mut values = EdgeValues::default();
    match order {
        1 => values[..2].copy_from_slice(&[(1.0 - xi) / 2.0, f64::midpoint(1.0, xi)]),
        2 => values[..3].copy_from_slice(&[
            xi * (xi - 1.0) / 2.0,
            1.0 - xi * xi,
            xi * (xi + 1.0) / 2.0,
        ]),
        _ => values = lagrange(edge_nodes(order).unwrap_or_default(), xi),
    }
    values
}

/// Slopes ∂N/∂ξ of [`edge_shape`] `[1]`.
pub fn edge_slope(order: usize, xi: f64) -> EdgeValues {
    let mut slopes = EdgeValues::default();
    match order {
        1 => slopes[..2].copy_from_slice(&[-0.5, 0.5]),
        2 => slopes[..3].copy_from_slice(&[xi - 0.5, -2.0 * xi, xi + 0.5]),
        _ => slopes = lagrange_slopes(edge_nodes(order).unwrap_or_default(), xi),
    }
    slopes
}

/// Lagrange polynomials on `nodes` (abscissa and weight) at `x`: Lₖ = Π_{l≠k} (x − xₗ)/(xₖ − xₗ), exactly 0 and 1 at the nodes.
pub(super) fn lagrange(nodes: &[(f64, f64)], x: f64) -> EdgeValues {
    let mut values = EdgeValues::default();
    for (k, (value, &(own, _))) in values.iter_mut().zip(nodes).enumerate() {
        *value = (nodes.iter().enumerate())
            .filter(|&(l, _)| l != k)
            .map(|(_, &(other, _))| (x - other) / (own - other))
            .product();
    }
    values
}

/// Slopes of [`lagrange`]: Lₖ' = Σ_{m≠k} 1/(xₖ − xₘ) Π_{l≠k,m} (x − xₗ)/(xₖ − xₗ).
pub(super) fn lagrange_slopes(nodes: &[(f64, f64)], x: f64) -> EdgeValues {
    let mut slopes = EdgeValues::default();
    for (k, (slope, &(own, _))) in slopes.iter_mut().zip(nodes).enumerate() {
        for (m, &(left_out, _)) in nodes.iter().enumerate().filter(|&(m, _)| m != k) {
            *slope += (nodes.iter().enumerate())
                .filter(|&(l, _)| l != k && l != m)
                .fold(1.0 / (own - left_out), |product, (_, &(other, _))| {
                    product * (x - other) / (own - other)
                });
        }
    }
    slopes
}
