//! How the motion of a contact point is made of the motion of a body's nodes.
//!
//! ```text
//! (u_n, u_t) = Σ_j W_j F u_j,     F = [e_n; e_t]
//! ```
//!
//! A node that is itself the contact point has W = I. A projection on a straight edge has W_j = w_j I with Σ w_j = 1; on a
//! curved edge W_j also turns, because the normal turns under the point's share of the edge.

use nalgebra::Matrix2;
use stickslip_fem_core::mesh::Point;

/// Part of one node in the motion of a contact point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StencilTerm {
    /// Index of the node among the body's contact points.
    pub node: usize,
    /// Rows of W: weights `[1]` of the node's normal and tangential displacement (in the point's frame) in the point's
    /// normal motion, and in its tangential motion.
    pub weights: [[f64; 2]; 2],
}

/// The nodes of one body that a contact point stands on. A plain node converts from its index.
///
/// ```
/// use stickslip_contact::Stencil;
///
/// let node: Stencil = 7.into();
/// let middle = Stencil::weighted([(7, 0.5), (8, 0.5)]);
/// assert_eq!((node.terms().len(), middle.terms().len()), (1, 2));
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Stencil(Vec<StencilTerm>);

impl Stencil {
    /// A stencil of any terms. Each node stands in it once.
    pub fn new(terms: Vec<StencilTerm>) -> Self {
        Self(terms)
    }

    /// A weighted mean of nodes, normal and tangential alike: pairs of node and weight `[1]`.
    pub fn weighted(nodes: impl IntoIterator<Item = (usize, f64)>) -> Self {
        let term = |(node, weight)| StencilTerm {
            node,
            weights: [[weight, 0.0], [0.0, weight]],
        };
        Self(nodes.into_iter().map(term).collect())
    }

    /// Its terms.
    pub fn terms(&self) -> &[StencilTerm] {
        &self.0
    }

    /// The node that it is, if it is a single one.
    pub fn node(&self) -> Option<usize> {
        const WHOLE: [[f64; 2]; 2] = [[1.0, 0.0], [0.0, 1.0]];
        match self.0[..] {
            [term] if term.weights == WHOLE => Some(term.node),
            _ => None,
        }
    }

    /// Mean position `[length]` of its nodes among `points`, weighted as the normal motion is.
    pub(super) fn position(&self, points: &[Point]) -> Point {
        if let [term] = self.0[..] {
            return points[term.node];
        }
        let (mut sum, mut total) = ([0.0; 2], 0.0);
        for term in &self.0 {
            let weight = term.weights[0][0];
            total += weight;
            sum = std::array::from_fn(|i| sum[i] + weight * points[term.node][i]);
        }
        sum.map(|value| value / total)
    }
}

impl From<usize> for Stencil {
    fn from(node: usize) -> Self {
        Self::weighted([(node, 1.0)])
    }
}

impl StencilTerm {
    pub(crate) fn matrix(&self) -> Matrix2<f64> {
        let [[nn, nt], [tn, tt]] = self.weights;
        Matrix2::new(nn, nt, tn, tt)
    }
}

/// The rows of B_b that belong to one contact point: how the displacements of body b enter its relative motion.
#[derive(Clone, Debug, PartialEq)]
pub struct BodyRows {
    /// Index of the contact point.
    pub point: usize,
    /// Node among the body's contact points, and the matrix `[1]` that takes its displacement (x, y) into (normal, tangential)
    /// motion, with − for the second body of a pair.
    pub terms: Vec<(usize, Matrix2<f64>)>,
}
