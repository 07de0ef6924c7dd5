//! Arithmetic of plane vectors.

use stickslip_fem_core::mesh::Point;
pub(crate) use stickslip_fem_core::vector::{cross, dot, minus};

/// a + t b.
pub(crate) fn along(a: Point, t: f64, b: Point) -> Point {
    [a[0] + t * b[0], a[1] + t * b[1]]
}

/// Turned about the origin, so that what lay along x lies along `direction`.
pub(crate) fn turned([x, y]: Point, [cos, sin]: Point) -> Point {
    [cos * x - sin * y, sin * x + cos * y]
}

pub(crate) fn middle(a: Point, b: Point) -> Point {
    [f64::midpoint(a[0], b[0]), f64::midpoint(a[1], b[1])]
}

pub(crate) fn distance(a: Point, b: Point) -> f64 {
    let d = minus(a, b);
    // Coordinates that the triangulation allows neither overflow nor underflow.
    dot(d, d).sqrt()
}

/// Twice the signed area of the triangle, positive if a, b, c are counter-clockwise.
pub(crate) fn orient(a: Point, b: Point, c: Point) -> f64 {
    cross(minus(b, a), minus(c, a))
}

/// Angles at the three corners `[rad]`.
pub(crate) fn corner_angles([a, b, c]: [Point; 3]) -> [f64; 3] {
    let angle = |p, q, r| {
        let (u, v) = (minus(q, p), minus(r, p));
        cross(u, v).atan2(dot(u, v))
    };
    [angle(a, b, c), angle(b, c, a), angle(c, a, b)]
}

/// Sine of the least angle of a triangle; negative if it is inverted.
pub(crate) fn least_sine([a, b, c]: [Point; 3]) -> f64 {
    let sides = [distance(a, b), distance(b, c), distance(c, a)];
    let shortest = sides[0].min(sides[1]).min(sides[2]);
    orient(a, b, c) * shortest / (sides[0] * sides[1] * sides[2])
}

/// Centre and radius of the circle through three points; not finite if they lie on a line.
pub(crate) fn circumcircle([a, b, c]: [Point; 3]) -> (Point, f64) {
    let (u, v) = (minus(b, a), minus(c, a));
    let (uu, vv) = (dot(u, u), dot(v, v));
    let twice = 2.0 * cross(u, v);
    let offset = [
        (v[1] * uu - u[1] * vv) / twice,
        (u[0] * vv - v[0] * uu) / twice,
    ];
    (along(a, 1.0, offset), offset[0].hypot(offset[1]))
}

/// Lowest and highest coordinates of no point at all.
pub(crate) const NOWHERE: [Point; 2] = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];

/// The box grown to contain `point`.
pub(crate) fn grown([low, high]: [Point; 2], point: Point) -> [Point; 2] {
    [
        [low[0].min(point[0]), low[1].min(point[1])],
        [high[0].max(point[0]), high[1].max(point[1])],
    ]
}
