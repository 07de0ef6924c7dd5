//! Linear and quadratic triangle in area coordinates λ₀ = 1 − ξ − η, λ₁ = ξ, λ₂ = η:
//!
//! ```text
//! T3: Nᵢ = λᵢ;    T6: corners λᵢ(2λᵢ − 1), mid-sides 4 λᵢ λⱼ.
//! ```
//!
//! ```text
//!  2
//!  │╲
//!  5  4
//!  │    ╲
//!  0──3──1
//! ```

use super::quadrature::{TRIANGLE_1, TRIANGLE_3, TRIANGLE_3_POINTS};
use super::{Element, QuadraturePoint};
use crate::kind::{ElementKind, Point};

/// Gradients of the area coordinates.
const AREA_GRADIENTS: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

fn area_coordinates(xi: Point) -> [f64; 3] {
    [1.0 - xi[0] - xi[1], xi[0], xi[1]]
}

/// Three-node triangle: constant strain.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct T3;

impl Element<3> for T3 {
    const KIND: ElementKind = ElementKind::T3;
    const NODES: [Point; 3] = [[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]];
    const QUADRATURE: &'static [QuadraturePoint] = &TRIANGLE_1;
    const SUPERCONVERGENT: &'static [Point] = &[TRIANGLE_1[0].at];

    fn shape(xi: Point) -> [f64; 3] {
        area_coordinates(xi)
    }

    fn gradients(_: Point) -> [[f64; 2]; 3] {
        AREA_GRADIENTS
    }
}

/// Six-node triangle: complete quadratic displacement.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct T6;

impl Element<6> for T6 {
    const KIND: ElementKind = ElementKind::T6;
    const NODES: [Point; 6] = [
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [0.5, 0.0],
        [0.5, 0.5],
        [0.0, 0.5],
    ];
    const QUADRATURE: &'static [QuadraturePoint] = &TRIANGLE_3;
    const SUPERCONVERGENT: &'static [Point] = &TRIANGLE_3_POINTS;

    fn shape(xi: Point) -> [f64; 6] {
        let l = area_coordinates(xi);
        let corner = |i: usize| l[i] * (2.0 * l[i] - 1.0);
        let side = |i: usize, j: usize| 4.0 * l[i] * l[j];
        [
            corner(0),
            corner(1),
            corner(2),
            side(0, 1),
            side(1, 2),
            side(2, 0),
        ]
    }

    fn gradients(xi: Point) -> [[f64; 2]; 6] {
        let l = area_coordinates(xi);
        let g = AREA_GRADIENTS;
        let corner = |i: usize| g[i].map(|d| (4.0 * l[i] - 1.0) * d);
        let side = |i: usize, j: usize| [0, 1].map(|k| 4.0 * (l[i] * g[j][k] + l[j] * g[i][k]));
        [
            corner(0),
            corner(1),
            corner(2),
            side(0, 1),
            side(1, 2),
            side(2, 0),
        ]
    }
}
