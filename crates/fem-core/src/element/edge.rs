//! The sides of plane elements: shape functions along a boundary edge, and a rule to integrate there.
//!
//! ```text
//! linear: N = ((1 − ξ)/2, –, (1 + ξ)/2);   quadratic: N = (ξ(ξ − 1)/2, 1 − ξ², ξ(ξ + 1)/2),   ξ ∈ [−1, 1]
//! ```

/// Five-point Gauss–Legendre rule on [−1, 1], abscissa and weight: exact to degree 9.
pub const GAUSS_5: [(f64, f64); 5] = [
    (-0.906_179_845_938_664, 0.236_926_885_056_189_1),
    (-0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.0, 0.568_888_888_888_888_9),
    (0.538_469_310_105_683_1, 0.478_628_670_499_366_5),
    (0.906_179_845_938_664, 0.236_926_885_056_189_1),
];

/// Shape functions of an edge of polynomial `order` 1 or 2 at ξ, in walk order: start, middle (0 on a linear edge), end.
pub fn edge_shape(order: usize, xi: f64) -> [f64; 3] {
    if order == 2 {
        [xi * (xi - 1.0) / 2.0, 1.0 - xi * xi, xi * (xi + 1.0) / 2.0]
    } else {
        [(1.0 - xi) / 2.0, 0.0, f64::midpoint(1.0, xi)]
    }
}

/// Slopes ∂N/∂ξ of [`edge_shape`].
pub fn edge_slope(order: usize, xi: f64) -> [f64; 3] {
    if order == 2 {
        [xi - 0.5, -2.0 * xi, xi + 0.5]
    } else {
        [-0.5, 0.0, 0.5]
    }
}
