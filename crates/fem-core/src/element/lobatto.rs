//! Quadrilaterals of any order on `[-1, 1]²`: Lagrange polynomials on the tensor grid of the Gauss–Lobatto points.
//!
//! ```text
//! Nₐ = ℓᵢ(ξ) ℓⱼ(η),   ℓ₀ … ℓ_p on −1 = x₀ < … < x_p = 1, the roots of (1 − x²) P_p'(x)
//! ```
//!
//! ```text
//!  3──9──8──2
//!  │        │      order 3: corners, inner nodes of edges along the walk around the cell, the inside in rows
//! 10 14 15  7
//!  │        │
//! 11 12 13  6
//!  │        │
//!  0──4──5──1
//! ```
//!
//! |ℓᵢ| ≤ 1 between the nodes (Fejér), so that interpolation and conditioning stay good at every order, and ∫ ℓᵢ dξ > 0, so that a
//! pressure on an edge makes positive forces on its nodes. (p + 1)² Gauss points integrate the stiffness of a parallelogram exactly;
//! on curved cells their error is below that of the shape functions.
//!
//! Source: Karniadakis and Sherwin, *Spectral/hp Element Methods* (2005), sections 2.3 and 3.1.

use std::array;

use super::edge::{lagrange, lagrange_slopes};
use super::legendre::{gauss, lobatto};
use super::{Element, QuadraturePoint};
use crate::kind::{ElementKind, Point, tensor_place};

/// Quadrilateral with `L` = p + 1 nodes along an edge of order p, `N` = L² in all.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Lobatto<const L: usize, const N: usize>;

impl<const L: usize, const N: usize> Lobatto<L, N> {
    /// Nodes along an edge, with Lobatto's weights.
    const LINE: [(f64, f64); L] = lobatto::<L>();
    /// Column and row of each node.
    const PLACES: [[usize; 2]; N] = {
        assert!(N == L * L, "a tensor grid");
        let mut places = [[0; 2]; N];
        let mut node = 0;
        while node < N {
            places[node] = tensor_place(L - 1, node);
            node += 1;
        }
        places
    };
    /// Product of the rule of L Gauss points with itself, ξ fastest.
    const SQUARE: [QuadraturePoint; N] = {
        let line = gauss::<L>();
        let mut square = [QuadraturePoint {
            at: [0.0; 2],
            weight: 0.0,
        }; N];
        let mut k = 0;
        while k < N {
            let ((xi, of_xi), (eta, of_eta)) = (line[k % L], line[k / L]);
            square[k] = QuadraturePoint {
                at: [xi, eta],
                weight: of_xi * of_eta,
            };
            k += 1;
        }
        square
    };
    /// Product of p Gauss points with themselves, ξ fastest, in the first places.
    const BARLOW: [Point; N] = match L - 1 {
        1 => Self::products(&gauss::<1>()),
        2 => Self::products(&gauss::<2>()),
        3 => Self::products(&gauss::<3>()),
        4 => Self::products(&gauss::<4>()),
        5 => Self::products(&gauss::<5>()),
        6 => Self::products(&gauss::<6>()),
        7 => Self::products(&gauss::<7>()),
        _ => Self::products(&gauss::<8>()),
    };

    const fn products(line: &[(f64, f64)]) -> [Point; N] {
        let mut points = [[0.0; 2]; N];
        let (count, mut k) = (line.len(), 0);
        while k < count * count {
            points[k] = [line[k % count].0, line[k / count].0];
            k += 1;
        }
        points
    }
}

impl<const L: usize, const N: usize> Element<N> for Lobatto<L, N> {
    const KIND: ElementKind = {
        use ElementKind::{P1, P2, P3, P4, P5, P6, P7, P8};
        [P1, P2, P3, P4, P5, P6, P7, P8][L - 2]
    };
    const NODES: [Point; N] = {
        let mut nodes = [[0.0; 2]; N];
        let mut node = 0;
        while node < N {
            let [i, j] = Self::PLACES[node];
            nodes[node] = [Self::LINE[i].0, Self::LINE[j].0];
            node += 1;
        }
        nodes
    };
    const QUADRATURE: &'static [QuadraturePoint] = &Self::SQUARE;
    const SUPERCONVERGENT: &'static [Point] = Self::BARLOW.split_at((L - 1) * (L - 1)).0;

    fn shape([x, y]: Point) -> [f64; N] {
        let [along_x, along_y] = [x, y].map(|at| lagrange(&Self::LINE, at));
        array::from_fn(|a| {
            let [i, j] = Self::PLACES[a];
            along_x[i] * along_y[j]
        })
    }

    fn gradients([x, y]: Point) -> [[f64; 2]; N] {
        let [along_x, along_y] = [x, y].map(|at| lagrange(&Self::LINE, at));
        let [slope_x, slope_y] = [x, y].map(|at| lagrange_slopes(&Self::LINE, at));
        array::from_fn(|a| {
            let [i, j] = Self::PLACES[a];
            [slope_x[i] * along_y[j], along_x[i] * slope_y[j]]
        })
    }
}
