//! Quadrature rules on the reference cells: Gauss products on the square, symmetric interior points on the triangle.

use super::QuadraturePoint;
use crate::kind::Point;

/// 1/√3, abscissa of the two-point Gauss rule.
const G2: f64 = 0.577_350_269_189_625_8;
/// √(3/5), outer abscissa of the three-point Gauss rule.
const G3: f64 = 0.774_596_669_241_483_4;

const fn point(xi: f64, eta: f64, weight: f64) -> QuadraturePoint {
    QuadraturePoint {
        at: [xi, eta],
        weight,
    }
}

/// 2×2 Gauss points, in the order of the corners.
pub(super) const SQUARE_2X2_POINTS: [Point; 4] = [[-G2, -G2], [G2, -G2], [G2, G2], [-G2, G2]];

/// 2×2 Gauss: exact to degree 3 in each coordinate.
pub(super) const SQUARE_2X2: [QuadraturePoint; 4] = [
    point(-G2, -G2, 1.0),
    point(G2, -G2, 1.0),
    point(G2, G2, 1.0),
    point(-G2, G2, 1.0),
];

/// 3×3 Gauss, ξ fastest: exact to degree 5 in each coordinate.
pub(super) const SQUARE_3X3: [QuadraturePoint; 9] = [
    point(-G3, -G3, 25.0 / 81.0),
    point(0.0, -G3, 40.0 / 81.0),
    point(G3, -G3, 25.0 / 81.0),
    point(-G3, 0.0, 40.0 / 81.0),
    point(0.0, 0.0, 64.0 / 81.0),
    point(G3, 0.0, 40.0 / 81.0),
    point(-G3, G3, 25.0 / 81.0),
    point(0.0, G3, 40.0 / 81.0),
    point(G3, G3, 25.0 / 81.0),
];

/// Centroid of the triangle: exact to degree 1.
pub(super) const TRIANGLE_1: [QuadraturePoint; 1] = [point(1.0 / 3.0, 1.0 / 3.0, 0.5)];

/// Three interior points: exact to degree 2 (Strang and Fix, 1973).
pub(super) const TRIANGLE_3: [QuadraturePoint; 3] = [
    point(1.0 / 6.0, 1.0 / 6.0, 1.0 / 6.0),
    point(2.0 / 3.0, 1.0 / 6.0, 1.0 / 6.0),
    point(1.0 / 6.0, 2.0 / 3.0, 1.0 / 6.0),
];

/// The points of [`TRIANGLE_3`].
pub(super) const TRIANGLE_3_POINTS: [Point; 3] =
    [TRIANGLE_3[0].at, TRIANGLE_3[1].at, TRIANGLE_3[2].at];
