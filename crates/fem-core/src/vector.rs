//! Arithmetic of plane vectors, which are [`Point`]s.

use crate::kind::Point;

/// Computes a − b.
pub fn minus(a: Point, b: Point) -> Point {
    [a[0] - b[0], a[1] - b[1]]
}

/// Computes the scalar product a · b.
pub fn dot(a: Point, b: Point) -> f64 {
    a[0] * b[0] + a[1] * b[1]
}

/// Computes a × b, positive where b lies counter-clockwise of a.
pub fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}
