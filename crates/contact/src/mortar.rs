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
mod error;
mod gather;
mod settings;
mod side;

use nalgebra::Matrix2;
use stickslip_fem_core::mesh::Point;

pub use error::MortarError;
pub use settings::{InitialGap, Multipliers, Projection};
pub use side::EdgeSide;

use crate::problem::{ContactPoint, Stencil};

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
