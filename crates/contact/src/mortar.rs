//! Contact points between edges whose nodes do not match: the mortar projection.
//!
//! Along a common parameter (angle on circles, arc length on lines) the pressure of the contact is p = Σ_k λ_k ψ_k / A_k,
//! one multiplier function ψ_k per node k of the first edge. The contact conditions are met in the mean that ψ_k takes,
//!
//! ```text
//! (g, s)_k = (1/w_k) ∫ ψ_k [ g₀ e₁ + F (Σ_j N_j u_j − Σ_l N_l u_l) ] ds,     w_k = ∫ ψ_k ds,   A_k = t w_k,   F = [e_n; e_t]
//! ```
//!
//! over the common segments of both edges, so motions are lengths, multipliers λ_k are forces, and the forces on the two
//! bodies are the consistent nodal loads of one traction: equal and opposite, with equal moments on a straight edge and
//! moments that differ by the facets' distance O(h²) on a curved one. Uniform pressure passes any straight interface exactly.
//!
//! | multipliers | on an edge that the second body covers | on an edge that it covers in part |
//! | --- | --- | --- |
//! | [`Multipliers::Standard`] | ψ_k = N_k | piecewise linear between neighbouring nodes |
//! | [`Multipliers::Dual`] | ∫ ψ_k N_j ds = δ_kj ∫ N_j ds | the same, to the piecewise linear functions, on the covered part |
//!
//! Dual functions are the combinations ψ = D M⁻¹ N of an edge's own shape functions, with M_ij = ∫ N_i N_j ds and
//! D = diag(∫ N_i ds). Since w_k = D_kk, all weights are positive: on a whole edge of a plane body, whose nodes are Gauss–Lobatto
//! points, ∫ N_i ds is Lobatto's weight: ½, ½ or ⅙, ⁴⁄₆, ⅙ of its length, and so on (it is the corners of quadratic *faces* in space
//! that would need a change of basis). On part of an edge of order 2 or more ∫ N_i ds can be negative, but never with piecewise linear
//! functions (Puso, Laursen & Solberg 2008), which take over there.
//! All functions of an edge sum to 1. Where the second body covers too little of an edge to distinguish its functions,
//! dual functions do not exist and the standard ones are used.
//!
//! Sources: Bernardi, Maday & Patera (1994); Wohlmuth (2000), dual functions; Puso & Laursen (2004), segments; Cichosz & Bischoff
//! (2011), dual functions on edges covered in part.

mod basis;
mod gather;
mod side;

use std::fmt;

use nalgebra::Matrix2;
use stickslip_fem_core::mesh::{MAX_ORDER, Point};
use thiserror::Error;

pub use side::EdgeSide;

use crate::problem::{ContactPoint, Stencil};

/// Why two edges cannot be projected on each other.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum MortarError {
    /// Edges have the orders of the elements.
    #[error("edges of order {0}; 1 to {MAX_ORDER} exist")]
    Order(usize),
    /// There are not as many parameters as nodes.
    #[error("{parameters} parameters for {nodes} nodes")]
    Parameters {
        /// Parameters given.
        parameters: usize,
        /// Nodes given.
        nodes: usize,
    },
    /// The number of nodes does not make whole edges.
    #[error("{nodes} nodes do not make whole edges of order {order}")]
    Nodes {
        /// Nodes given.
        nodes: usize,
        /// Order of the edges.
        order: usize,
    },
    /// The parameter does not ascend, or a number of it is not finite.
    #[error("the parameter goes from {from} to {to} after node {node} of the walk; it must ascend")]
    NotAscending {
        /// Place in the walk.
        node: usize,
        /// Parameter there.
        from: f64,
        /// Parameter at the next node.
        to: f64,
    },
    /// A mid-side node lies outside the middle half of its edge, where the edge folds back on itself.
    #[error(
        "the mid-side node {node} of the walk lies {fraction:.3} along its edge; 0.25 to 0.75 is possible"
    )]
    MidSide {
        /// Place in the walk.
        node: usize,
        /// Fraction of the edge.
        fraction: f64,
    },
    /// The nodes inside an edge of order above 2 are so far from their places that the edge folds back on itself.
    #[error("edge {edge} of the walk folds back on itself between its nodes")]
    Folded {
        /// Place of the edge in the walk.
        edge: usize,
    },
    /// A closed edge spans more than its period, or two closed edges differ in it.
    #[error("an edge spans {span} of a period of {period}")]
    Period {
        /// What it spans.
        span: f64,
        /// The period.
        period: f64,
    },
    /// A length or thickness is not positive.
    #[error("the {what} is {value}; it must be positive")]
    NotPositive {
        /// What it is.
        what: &'static str,
        /// Its value.
        value: f64,
    },
    /// A position is needed of a node that has none.
    #[error("node {node} of {count} has no position")]
    NoPosition {
        /// Index of the node.
        node: usize,
        /// Positions given.
        count: usize,
    },
    /// The edges do not face each other anywhere.
    #[error("the edges have no common part")]
    NoOverlap,
}

/// The functions that contact forces are made of.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Multipliers {
    /// The shape functions of the first edge.
    #[default]
    Standard,
    /// Functions biorthogonal to them: on a straight edge each point stands on one node of the first body alone.
    Dual,
}

/// Distance between the undeformed edges.
#[derive(Clone, Copy)]
pub enum InitialGap<'a> {
    /// Exact gap `[length]` at a parameter.
    Exact(&'a dyn Fn(f64) -> f64),
    /// Between the meshes as they are: positions `[length]` of the contact points of the first and of the second body.
    Faceted(&'a [Point], &'a [Point]),
}

impl fmt::Debug for InitialGap<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(match self {
            Self::Exact(_) => "Exact",
            Self::Faceted(..) => "Faceted",
        })
    }
}

/// What a projection needs beside the edges.
#[derive(Clone, Copy)]
pub struct Projection<'a> {
    /// Functions of the contact forces.
    pub multipliers: Multipliers,
    /// Length `[length]` of the contact per unit of the parameter: 1 for arc length, the radius for an angle.
    pub length: f64,
    /// Thickness `[length]` of the contact.
    pub thickness: f64,
    /// Unit normal e_n from the second body into the first at a parameter.
    pub normal: &'a dyn Fn(f64) -> [f64; 2],
    /// Initial gap.
    pub gap: InitialGap<'a>,
    /// Angle of the first body's 1-axis from x `[rad]`.
    pub material_angle: f64,
    /// Whether the first edge starts, and ends, on a line of symmetry. Shear is odd there, so the multiplier of that node
    /// has no tangential part.
    pub symmetry: [bool; 2],
}

impl fmt::Debug for Projection<'_> {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter
            .debug_struct("Projection")
            .field("multipliers", &self.multipliers)
            .field("length", &self.length)
            .field("thickness", &self.thickness)
            .field("gap", &self.gap)
            .field("material_angle", &self.material_angle)
            .field("symmetry", &self.symmetry)
            .finish_non_exhaustive()
    }
}

/// The contact points of two edges.
#[derive(Clone, Debug, PartialEq)]
pub struct Projected {
    /// One point per node of the first edge that faces the second, in walk order.
    pub points: Vec<ContactPoint>,
    /// Place of each point's node in the walk of the first edge.
    pub nodes: Vec<usize>,
}

/// Contact points between the edges of two bodies: one per node of `first` wherever `second` faces it.
///
/// Integrals are exact where the inner nodes of edges lie at their Gauss–Lobatto points (by parameter); the balance of forces is exact
/// in any case. Resultants converge as between edges that match. The pressure at a point ripples with the pattern of the two
/// spacings, least where the first edge is the coarser one; a rigid body is the second.
///
/// ```
/// use stickslip_contact::{EdgeSide, InitialGap, Multipliers, Projection, mortar};
///
/// let three = EdgeSide::open(vec![0, 1, 2, 3], vec![0.0, 1.0, 2.0, 3.0], 1)?;
/// let two = EdgeSide::open(vec![0, 1, 2], vec![0.0, 1.5, 3.0], 1)?;
/// let projection = Projection {
///     multipliers: Multipliers::Dual,
///     length: 1.0,
///     thickness: 1.0,
///     normal: &|_| [0.0, 1.0],
///     gap: InitialGap::Exact(&|_| 0.0),
///     material_angle: 0.0,
///     symmetry: [false; 2],
/// };
/// let made = mortar::project(&three, &two, &projection)?;
/// assert_eq!(made.points.len(), 4);
/// assert_eq!(made.points[1].second.terms().len(), 3);
/// # Ok::<(), stickslip_contact::MortarError>(())
/// ```
///
/// # Errors
/// [`MortarError::Period`], [`MortarError::NotPositive`], [`MortarError::NoPosition`]; [`MortarError::NoOverlap`] where no
/// point would be left.
pub fn project(
    first: &EdgeSide,
    second: &EdgeSide,
    projection: &Projection<'_>,
) -> Result<Projected, MortarError> {
    let period = side::common_period(first, second)?;
    for (what, value) in [
        ("length per parameter", projection.length),
        ("thickness", projection.thickness),
    ] {
        if !(value > 0.0 && value.is_finite()) {
            return Err(MortarError::NotPositive { what, value });
        }
    }
    if let InitialGap::Faceted(of_first, of_second) = projection.gap {
        check_positions(first, of_first)?;
        check_positions(second, of_second)?;
    }
    let gathered = gather::all(first, second, period, projection);
    let largest = gathered.iter().fold(0.0_f64, |m, node| m.max(node.weight));
    let mut made = Projected {
        points: Vec::new(),
        nodes: Vec::new(),
    };
    for (node, sums) in gathered.iter().enumerate() {
        if sums.weight > VANISHING * largest {
            made.points.push(point(first, node, sums, projection));
            made.nodes.push(node);
        }
    }
    if made.points.is_empty() {
        return Err(MortarError::NoOverlap);
    }
    Ok(made)
}

/// Weights below this part of the largest are rounding: a node that touches the other edge's end.
const VANISHING: f64 = 1e-10;
/// Weights of nodes below this are rounding, as those that dual functions leave at the other nodes of an edge.
const NOTHING: f64 = 1e-14;

fn check_positions(side: &EdgeSide, positions: &[Point]) -> Result<(), MortarError> {
    let count = positions.len();
    match side.nodes().iter().find(|&&node| node >= count) {
        Some(&node) => Err(MortarError::NoPosition { node, count }),
        None => Ok(()),
    }
}

fn point(
    first: &EdgeSide,
    node: usize,
    sums: &gather::NodeSums,
    projection: &Projection<'_>,
) -> ContactPoint {
    let normal = (projection.normal)(first.parameter()[node]);
    let last = first.parameter().len() - 1;
    let [at_start, at_end] = projection.symmetry;
    let shears = first.period().is_some() || !((at_start && node == 0) || (at_end && node == last));
    let stencil = |terms: &gather::Terms| {
        let seen = terms
            .iter()
            .filter(|(_, sum)| sum.amax() > NOTHING * sums.weight);
        let term = |(&node, sum): (&usize, &Matrix2<f64>)| {
            gather::in_frame(node, &(sum / sums.weight), normal, shears)
        };
        Stencil::new(seen.map(term).collect())
    };
    let gap = match projection.gap {
        InitialGap::Exact(_) => sums.gap / sums.weight,
        InitialGap::Faceted(of_first, of_second) => {
            let along = |terms: &gather::Terms, positions: &[Point]| -> f64 {
                let part = |(&node, sum): (&usize, &Matrix2<f64>)| {
                    sum[(0, 0)] * positions[node][0] + sum[(0, 1)] * positions[node][1]
                };
                terms.iter().map(part).sum()
            };
            (along(&sums.first, of_first) - along(&sums.second, of_second)) / sums.weight
        }
    };
    ContactPoint {
        first: stencil(&sums.first),
        second: stencil(&sums.second),
        normal,
        gap,
        area: sums.weight * projection.thickness,
        material_angle: projection.material_angle,
    }
}
