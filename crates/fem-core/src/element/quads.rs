//! Quadrilaterals on `[-1, 1]²`: bilinear, serendipity and biquadratic.
//!
//! ```text
//! Q4: Nₐ = ¼ (1 + ξₐξ)(1 + ηₐη)
//! Q8: corners ¼ (1 + ξₐξ)(1 + ηₐη)(ξₐξ + ηₐη − 1),  mid-sides ½ (1 − ξ²)(1 + ηₐη) and ½ (1 + ξₐξ)(1 − η²)
//! Q9: Nₐ = ℓ(ξ; ξₐ) ℓ(η; ηₐ),  ℓ the quadratic Lagrange polynomials on −1, 0, 1
//! ```
//!
//! ```text
//!  3───6───2
//!  │       │
//!  7   8   5
//!  │       │
//!  0───4───1
//! ```

use std::array;

use super::quadrature::{SQUARE_2X2, SQUARE_2X2_POINTS, SQUARE_3X3};
use super::{Element, QuadraturePoint};
use crate::kind::{ElementKind, Point};

/// Four-node bilinear quadrilateral.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Q4;

impl Element<4> for Q4 {
    const KIND: ElementKind = ElementKind::Q4;
    const NODES: [Point; 4] = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    const QUADRATURE: &'static [QuadraturePoint] = &SQUARE_2X2;
    const SUPERCONVERGENT: &'static [Point] = &[[0.0, 0.0]];

    fn shape([x, y]: Point) -> [f64; 4] {
        Self::NODES.map(|[a, b]| 0.25 * (1.0 + a * x) * (1.0 + b * y))
    }

    fn gradients([x, y]: Point) -> [[f64; 2]; 4] {
        Self::NODES.map(|[a, b]| [0.25 * a * (1.0 + b * y), 0.25 * b * (1.0 + a * x)])
    }
}

/// Eight-node serendipity quadrilateral.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Q8;

impl Element<8> for Q8 {
    const KIND: ElementKind = ElementKind::Q8;
    const NODES: [Point; 8] = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [0.0, -1.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
    ];
    const QUADRATURE: &'static [QuadraturePoint] = &SQUARE_3X3;
    const SUPERCONVERGENT: &'static [Point] = &SQUARE_2X2_POINTS;

    fn shape([x, y]: Point) -> [f64; 8] {
        array::from_fn(|k| {
            let [a, b] = Self::NODES[k];
            match k {
                0..4 => 0.25 * (1.0 + a * x) * (1.0 + b * y) * (a * x + b * y - 1.0),
                4 | 6 => 0.5 * (1.0 - x * x) * (1.0 + b * y),
                _ => 0.5 * (1.0 + a * x) * (1.0 - y * y),
            }
        })
    }

    fn gradients([x, y]: Point) -> [[f64; 2]; 8] {
        array::from_fn(|k| {
            let [a, b] = Self::NODES[k];
            match k {
                0..4 => [
                    0.25 * a * (1.0 + b * y) * (2.0 * a * x + b * y),
                    0.25 * b * (1.0 + a * x) * (a * x + 2.0 * b * y),
                ],
                4 | 6 => [-x * (1.0 + b * y), 0.5 * b * (1.0 - x * x)],
                _ => [0.5 * a * (1.0 - y * y), -y * (1.0 + a * x)],
            }
        })
    }
}

/// Nine-node biquadratic quadrilateral.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Q9;

/// Column and row of each node of [`Q9`] in the 3×3 lattice of −1, 0, 1.
const Q9_LATTICE: [[usize; 2]; 9] = [
    [0, 0],
    [2, 0],
    [2, 2],
    [0, 2],
    [1, 0],
    [2, 1],
    [1, 2],
    [0, 1],
    [1, 1],
];

fn lagrange(x: f64) -> [f64; 3] {
    [0.5 * x * (x - 1.0), 1.0 - x * x, 0.5 * x * (x + 1.0)]
}

fn lagrange_derivative(x: f64) -> [f64; 3] {
    [x - 0.5, -2.0 * x, x + 0.5]
}

impl Element<9> for Q9 {
    const KIND: ElementKind = ElementKind::Q9;
    const NODES: [Point; 9] = [
        [-1.0, -1.0],
        [1.0, -1.0],
        [1.0, 1.0],
        [-1.0, 1.0],
        [0.0, -1.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [-1.0, 0.0],
        [0.0, 0.0],
    ];
    const QUADRATURE: &'static [QuadraturePoint] = &SQUARE_3X3;
    const SUPERCONVERGENT: &'static [Point] = &SQUARE_2X2_POINTS;

    fn shape([x, y]: Point) -> [f64; 9] {
        let (along_x, along_y) = (lagrange(x), lagrange(y));
        Q9_LATTICE.map(|[i, j]| along_x[i] * along_y[j])
    }

    fn gradients([x, y]: Point) -> [[f64; 2]; 9] {
        let (along_x, along_y) = (lagrange(x), lagrange(y));
        let (slope_x, slope_y) = (lagrange_derivative(x), lagrange_derivative(y));
        Q9_LATTICE.map(|[i, j]| [slope_x[i] * along_y[j], along_x[i] * slope_y[j]])
    }
}
