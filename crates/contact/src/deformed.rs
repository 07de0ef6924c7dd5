//! Gaps on the deformed geometry, between linear bodies.
//!
//! Node k of the first body stands at x₁ = X₁ + u₁; the edge of the second body is the curve x₂(s), the true one of the undeformed body and
//! the displacements of its nodes between them,
//!
//! ```text
//! x₂(s) = X₂(s) + Σ_j w_j(s) u₂ⱼ,      (x₁ − x₂(s)) · x₂′(s) = 0,      x₁ = x₂(s) + g n,      n ⊥ x₂′(s),      t = n turned by +90°
//! ```
//!
//! The weights w_j are cubic, of the two nodes on either side of s, so that the curve and its normal are continuous and go through the nodes. The
//! closest point s, the normal n and the gap g follow the displacement. To first order the gap changes by n · (δu₁ − Σ w_j δu₂ⱼ): the motion of the closest
//! point along the curve does not count, because n ⊥ x₂′. So contact on a given geometry is an interface problem like any other, with
//! stencil w, frame (n, t) and initial gap
//!
//! ```text
//! g₀ = g(u*) − n · (u₁* − Σ w_j u₂ⱼ*)        exact at the displacement u* of the geometry,
//! ```
//!
//! and its compliance is a congruence transform of those of the bodies: nothing is factorised. An increment of load repeats
//!
//! 1. the geometry at the last displacement, that of the last accepted state at first;
//! 2. the step from the last accepted state on it, by any [`InterfaceSolver`](crate::InterfaceSolver);
//!
//! until neither gaps nor normals change beyond [`TOLERANCE`]. What the linearisation leaves out, the turn of n and the motion of s under the
//! forces that act, is smaller than the compliance by the size of the strains, which is the factor by which the error falls from pass
//! to pass: convergence is linear and fast, with two to four passes. An increment that does not settle within [`PASSES`] fails as
//! [`FailureCause::Geometry`](crate::solver::FailureCause::Geometry) and is cut back.
//!
//! # The curve between nodes
//!
//! Contact points pair node k of one edge with node k of the other. From there the closest point has moved by δ, and displacements are
//!
//! ```text
//! u₂(s_k + δ) = u₂ₖ + δ Σ_j D_kj u₂ⱼ,      W = I + δ D
//! ```
//!
//! with D the derivative in the cells of the edge, at corner nodes the mean of both sides by their lengths. With the areas A of the nodes, D is skew, A D + Dᵀ A = 0 but for the
//! ends of the edge. So W moves a uniform pressure as a uniform pressure, also where nodes inside of cells have other areas than corners; the usual interpolation between
//! neighbours does not, and has pressures that alternate from node to node. Where linear cells differ in length D errs by half of their difference times
//! u₂″, in a single node. Forces bear that, gaps and slips do not: a gap that is off by δ h u₂″ at a node calls for a pressure that no finer division makes
//! smaller. So places, gaps, normals and slips are those of the derivative by three nodes, and the forces are moved by D. What δ² D² u₂/2 would add is an error; beyond [`LARGEST_ERROR`] the
//! increment is refused ([`FailureCause::Apart`](crate::solver::FailureCause::Apart)).
//!
//! That bounds the error of a displacement, not of its root at an end of contact: where δ exceeds the distance of nodes, pressure falls to zero linearly over about δ instead, and the stress along the
//! edge loses its cusp. A pin with clearance c that is paired at equal angles has δ = (c/R) sin θ before any slip. So the nodes of the second edge should stand where those of
//! the first face them under load; [`Curve::places`] says where they are.
//!
//! # Bodies that turn
//!
//! A circle that turns about its centre stays where it is. The mean turn φ of a circular edge of a body that is free to turn is left out of x₁
//! and x₂, and enters slip as the motion |x₂′| φ of the edge along itself. Of forces, that is a small couple spread over the edge,
//!
//! ```text
//! φ = Σ_j τ_j · u_j,    (u_n, u_t) = B (u − φ e_z × (X − C)) + (0, |x₂′|) φ,      f = Bᵀ λ + τ Σ_k d_k · λ_k
//! ```
//!
//! by which normal forces have no moment about the centre, and tangential ones the arm |x₂′|, the stretched radius: for a disk that is what its
//! equilibrium on the deformed geometry says. Otherwise normals that tilt with the strains would turn bodies that friction alone holds, or that nothing holds.
//!
//! | quantity | geometry |
//! | --- | --- |
//! | gap, normal, tangent, closest point | deformed |
//! | slip of an increment | t · [Δu₁ − Σ w_j Δu₂ⱼ] from the last accepted state, at the end's frame and closest point |
//! | forces on the bodies | λ_n n + λ_t t at X₁ and −(λ_n n + λ_t t) at the nodes of W, which are equal and opposite, and the couple |
//! | resultants, moments and balances | deformed normals and closest points at their undeformed places, as linear bodies take forces |
//! | areas, tractions | undeformed |
//! | stiffness and loads of bodies | undeformed, linear; large turns of bodies are not covered |
//!
//! On a line of symmetry points stay, with the normal along it. Bodies that bear nowhere travel to where they begin to bear on the geometry of the last accepted
//! state. Points of the first body are single nodes, and as many nodes face them; mortar stencils are refused.
//!
//! Sources: Wriggers (2006), *Computational Contact Mechanics*, ch. 4 and 9, contact on the deformed geometry; Poulios & Renard (2015), its slip; Strand
//! (1994), skew derivatives.

mod curve;
mod geometry;
mod slopes;

use nalgebra::{DVector, Matrix2};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;

use crate::error::ContactError;
use crate::interface::Group;
use crate::problem::{ContactPair, Contacts, InterfaceProblem};
use crate::state::ContactState;

pub use curve::{Curve, CurveEnds, CurveError, CurveShape};
pub use geometry::is_free_to_turn;
pub(crate) use geometry::{Geometry, Unfaced};

/// Change of a gap relative to the largest motion of a point against another, or where that is more to a hundredth of how far points are displaced from the
/// mean of their body, and of a normal `[rad]`, up to which a geometry is settled.
pub const TOLERANCE: f64 = 1e-6;
/// Passes after which an increment that does not settle is refused.
pub const PASSES: usize = 12;

/// Error `[1]` of a closest point relative to the larger of both up to which an increment is accepted.
pub const LARGEST_ERROR: f64 = 1e-2;

/// On which geometry contact is found.
#[derive(Clone, Debug, Default)]
pub enum Kinematics<'a> {
    /// The undeformed one.
    #[default]
    Small,
    /// The deformed one.
    DeformedGaps(DeformedGaps<'a>),
}

/// The undeformed edges of a contact pair.
#[derive(Clone, Debug, PartialEq)]
pub struct Facing {
    /// Places `[length]` of the pair's points on the first edge.
    pub first: Vec<Point>,
    /// Centre of the first edge's circle `[length]`; `None` for a straight edge.
    pub centre: Option<Point>,
    /// The second edge.
    pub second: Curve,
}

/// Bodies, and the undeformed edges of every pair.
#[derive(Clone, Debug)]
pub struct DeformedGaps<'a> {
    bodies: Vec<&'a dyn InterfaceOperator>,
    facings: Vec<&'a Facing>,
    /// Whether each body is free to turn.
    turning: Vec<bool>,
    /// What the contact points of each body make of its translations; empty where they follow them.
    translated: Vec<Vec<Matrix2<f64>>>,
}

impl<'a> DeformedGaps<'a> {
    /// The edges `facings` of `pairs` between `bodies`.
    ///
    /// # Errors
    /// [`ContactError::InvalidPair`] where edges and pairs differ in number, a pair has not as many places as points, a point of the first body is not
    /// a single node, or a curve has fewer than three nodes, one that its body lacks, or parameters that do not ascend.
    pub fn new(
        bodies: &[&'a dyn InterfaceOperator],
        pairs: &[ContactPair],
        facings: &'a [Facing],
    ) -> Result<Self, ContactError> {
        let refuse = |pair: &ContactPair, point: usize, what: String| ContactError::InvalidPair {
            pair: pair.name.clone(),
            point,
            what,
        };
        for (index, pair) in pairs.iter().enumerate() {
            let facing = facings.get(index).ok_or_else(|| {
                let what = format!("{} pairs of edges for {} pairs", facings.len(), pairs.len());
                refuse(pair, 0, what)
            })?;
            if facing.first.len() != pair.points.len() {
                let (places, points) = (facing.first.len(), pair.points.len());
                let what = format!("{places} places on the first edge for {points} points");
                return Err(refuse(pair, 0, what));
            }
            if let Some(k) = (pair.points.iter()).position(|point| point.first.node().is_none()) {
                let what = "gaps on the deformed geometry need a single node of the first body";
                return Err(refuse(pair, k, what.to_owned()));
            }
            let nodes = facing.second.nodes();
            if nodes.len() != pair.points.len() {
                let (nodes, points) = (nodes.len(), pair.points.len());
                let what = format!("{nodes} nodes on the second edge for {points} points");
                return Err(refuse(pair, 0, what));
            }
            let count = bodies
                .get(pair.second)
                .map_or(0, |body| body.points().len());
            if let Some(k) = nodes.iter().position(|&node| node >= count) {
                let what = format!("node {} of {count} on the second edge", nodes[k]);
                return Err(refuse(pair, k, what));
            }
        }
        Ok(Self {
            bodies: bodies.to_vec(),
            facings: facings.iter().collect(),
            turning: bodies.iter().map(|body| is_free_to_turn(*body)).collect(),
            translated: vec![Vec::new(); bodies.len()],
        })
    }

    /// The same where `turning` says which bodies are free to turn, and `translated` what their points make of translations: means over hats are not uniform.
    pub(crate) fn of_means(self, turning: &[bool], translated: Vec<Vec<Matrix2<f64>>>) -> Self {
        Self {
            turning: turning.to_vec(),
            translated,
            ..self
        }
    }

    /// What the contact point `point` of `body` makes of a translation.
    fn translated(&self, body: usize, point: usize) -> Matrix2<f64> {
        let own = self.translated[body].get(point);
        own.copied().unwrap_or_else(Matrix2::identity)
    }

    pub(crate) fn facings(&self) -> &[&'a Facing] {
        &self.facings
    }

    /// Those of the bodies and pairs of `group`.
    pub(crate) fn of_group(&self, group: &Group) -> Self {
        Self {
            bodies: group.bodies.iter().map(|&body| self.bodies[body]).collect(),
            facings: group.pairs.iter().map(|&pair| self.facings[pair]).collect(),
            turning: group
                .bodies
                .iter()
                .map(|&body| self.turning[body])
                .collect(),
            translated: (group.bodies.iter())
                .map(|&body| self.translated[body].clone())
                .collect(),
        }
    }

    pub(crate) fn bodies(&self) -> &[&'a dyn InterfaceOperator] {
        &self.bodies
    }

    /// Displacements `[length]` of the contact points of each body in `state` of `problem`, whose contacts are `contacts`, under the
    /// load multipliers `multipliers`.
    pub(crate) fn displacements(
        &self,
        problem: &InterfaceProblem,
        contacts: &Contacts,
        state: &ContactState,
        multipliers: &[f64],
    ) -> Vec<DVector<f64>> {
        let displacement = |(index, body): (usize, &&dyn InterfaceOperator)| {
            let forces = contacts.forces_on_body(index, body.points().len(), &state.forces);
            let amounts = problem.motions_of_body(index, &state.rigid, &state.forces, multipliers);
            body.displacements(&forces, &amounts, multipliers)
        };
        self.bodies.iter().enumerate().map(displacement).collect()
    }
}
