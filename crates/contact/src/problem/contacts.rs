//! Pairs of bodies that may touch, and the points of all pairs in one list.

use std::ops::Range;
use std::sync::Arc;

use nalgebra::{DVector, Matrix2};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;
use stickslip_friction::{FrictionLaw, Place};

use super::{BodyRows, Stencil, StencilTerm};
use crate::error::ContactError;

/// One contact point of a pair: a node of the first body against a node of the second, or a weighted share of both edges.
#[derive(Clone, Debug, PartialEq)]
pub struct ContactPoint {
    /// Where it stands on the first body; a node converts from its index among the body's contact points.
    pub first: Stencil,
    /// Where it stands on the second body.
    pub second: Stencil,
    /// Unit normal e_n `[1]` from the second body into the first; e_t is e_n turned by +90°.
    pub normal: [f64; 2],
    /// Initial gap g₀ `[length]`; negative for interference.
    pub gap: f64,
    /// Contact area that the point stands for `[length²]`: traction = force / area.
    pub area: f64,
    /// Angle of the first body's 1-axis from x `[rad]`.
    pub material_angle: f64,
}

/// Two bodies that may touch, and the friction between them.
#[derive(Clone, Debug)]
pub struct ContactPair {
    /// Name for messages and results.
    pub name: String,
    /// Where the origin of the bodies' coordinates lies in those that the friction law is given `[length]`.
    pub origin: Point,
    /// Index of the first body.
    pub first: usize,
    /// Index of the second body.
    pub second: usize,
    /// Points in walk order along the contact.
    pub points: Vec<ContactPoint>,
    /// Friction law.
    pub law: Arc<dyn FrictionLaw>,
}

/// One contact point of the assembled problem.
#[derive(Clone, Debug)]
pub struct ProblemPoint {
    /// Index of the pair it belongs to.
    pub pair: usize,
    /// Initial gap `[length]`.
    pub gap: f64,
    /// Contact area `[length²]`.
    pub area: f64,
    /// Place handed to the friction law.
    pub place: Place,
    /// Unit normal e_n `[1]`.
    pub normal: [f64; 2],
    /// What a unit normal and a unit tangential contact force do to the first body: force along x and y `[1]`, and moment
    /// about the origin `[length]`.
    pub actions: [[f64; 3]; 2],
    /// Whether the bodies can move against each other tangentially here; not so on a line of symmetry.
    pub slides: bool,
}

/// How the turn of a body's edge enters the motion of contact points in addition to their stencils, and what contact forces do to the edge in turn.
///
/// ```text
/// (u_n, u_t)_k += d_k φ,   φ = Σ_j τ_j · u_j;      f_j += τ_j Σ_k d_k · λ_k
/// ```
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Couple {
    /// Index of the body.
    pub(crate) body: usize,
    /// τ `[1/length]` of nodes, by their index among the body's contact points.
    pub(crate) turn: Vec<(usize, [f64; 2])>,
    /// d `[length]` of points, with − for the second body of a pair.
    pub(crate) rows: Vec<(usize, [f64; 2])>,
}

impl Couple {
    /// Its column of d, of `size` components.
    pub(crate) fn column(&self, size: usize) -> DVector<f64> {
        let mut column = DVector::zeros(size);
        for (point, row) in &self.rows {
            column.fixed_rows_mut::<2>(2 * point).copy_from_slice(row);
        }
        column
    }

    /// The turn φ where the body's contact points are displaced by `moved`, interleaved.
    pub(crate) fn turn_of(&self, moved: &[f64]) -> f64 {
        let terms = self.turn.iter();
        terms
            .map(|(node, [x, y])| x * moved[2 * node] + y * moved[2 * node + 1])
            .sum()
    }
}

/// The points of all pairs, pair by pair in walk order.
#[derive(Clone, Debug)]
pub struct Contacts {
    pairs: Vec<ContactPair>,
    points: Vec<ProblemPoint>,
    couples: Vec<Couple>,
    /// First point of each pair, and the number of points at the end.
    offsets: Vec<usize>,
}

impl Contacts {
    /// The points of `pairs`, which [`check`](super::check) accepts, between `bodies`.
    pub(crate) fn new(pairs: Vec<ContactPair>, bodies: &[&dyn InterfaceOperator]) -> Self {
        let mut offsets = vec![0];
        for pair in &pairs {
            offsets.push(offsets[offsets.len() - 1] + pair.points.len());
        }
        Self {
            points: problem_points(&pairs, bodies),
            couples: Vec::new(),
            pairs,
            offsets,
        }
    }

    /// The same points with `couples`.
    pub(crate) fn with_couples(mut self, couples: Vec<Couple>) -> Self {
        self.couples = couples;
        self
    }

    pub(crate) fn couples(&self) -> &[Couple] {
        &self.couples
    }

    pub(crate) fn points_mut(&mut self) -> &mut [ProblemPoint] {
        &mut self.points
    }

    /// Sets the initial gap `[length]` of every point.
    pub(crate) fn set_gaps(&mut self, gaps: &[f64]) {
        let own = self.pairs.iter_mut().flat_map(|pair| &mut pair.points);
        for ((point, own), &gap) in self.points.iter_mut().zip(own).zip(gaps) {
            (point.gap, own.gap) = (gap, gap);
        }
    }

    /// Takes over the points of `own`, whose bodies, pairs and points have the numbers `bodies`, `pairs` and `points` here.
    pub(crate) fn take_points(&mut self, own: &Self, [bodies, pairs, points]: [&[usize]; 3]) {
        for (local, &pair) in pairs.iter().enumerate() {
            self.pairs[pair].points.clone_from(&own.pairs[local].points);
            let range = self.pair_points(pair);
            let moved = &own.points[own.pair_points(local)];
            for (point, taken) in self.points[range].iter_mut().zip(moved) {
                *point = ProblemPoint {
                    pair,
                    ..taken.clone()
                };
            }
        }
        let couple = |couple: &Couple| Couple {
            body: bodies[couple.body],
            turn: couple.turn.clone(),
            rows: (couple.rows.iter())
                .map(|&(point, row)| (points[point], row))
                .collect(),
        };
        self.couples.extend(own.couples.iter().map(couple));
    }

    /// Replaces the friction of pair `pair`.
    pub(super) fn set_law(
        &mut self,
        pair: usize,
        law: Arc<dyn FrictionLaw>,
    ) -> Result<(), ContactError> {
        let pairs = self.pairs.len();
        let found = self.pairs.get_mut(pair);
        found.ok_or(ContactError::UnknownPair { pair, pairs })?.law = law;
        Ok(())
    }

    /// Contact points, pair by pair in walk order.
    pub fn points(&self) -> &[ProblemPoint] {
        &self.points
    }

    /// The pairs.
    pub fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// Range of the points of pair `pair`.
    pub fn pair_points(&self, pair: usize) -> Range<usize> {
        self.offsets[pair]..self.offsets[pair + 1]
    }

    /// The rows of B of body `index`, of the points where it touches, in their order.
    pub fn body_rows(&self, index: usize) -> Vec<BodyRows> {
        let mut rows = Vec::new();
        for (pair, number) in self.pairs().iter().zip(0..) {
            if ![pair.first, pair.second].contains(&index) {
                continue;
            }
            for (point, k) in pair.points.iter().zip(self.pair_points(number)) {
                let frame = frame(point.normal);
                let mut terms = Vec::new();
                if pair.first == index {
                    let of = |term: &StencilTerm| (term.node, term.matrix() * frame);
                    terms.extend(point.first.terms().iter().map(of));
                }
                if pair.second == index {
                    let of = |term: &StencilTerm| (term.node, -(term.matrix() * frame));
                    terms.extend(point.second.terms().iter().map(of));
                }
                rows.push(BodyRows { point: k, terms });
            }
        }
        rows
    }

    /// Forces `[force]` on the contact points of body `index` (2 × `count`, xy interleaved) by contact forces `forces`
    /// (2n, normal and tangential interleaved).
    pub fn forces_on_body(&self, index: usize, count: usize, forces: &DVector<f64>) -> Vec<f64> {
        let mut on_body = vec![0.0; 2 * count];
        for row in self.body_rows(index) {
            let at_point = forces.fixed_rows::<2>(2 * row.point);
            for (node, weight) in row.terms {
                let force = weight.transpose() * at_point;
                on_body[2 * node] += force[0];
                on_body[2 * node + 1] += force[1];
            }
        }
        for couple in self.couples.iter().filter(|couple| couple.body == index) {
            let moment = |(point, [normal, tangential]): &(usize, [f64; 2])| {
                normal * forces[2 * point] + tangential * forces[2 * point + 1]
            };
            let moment: f64 = couple.rows.iter().map(moment).sum();
            for (node, turn) in &couple.turn {
                on_body[2 * node] += turn[0] * moment;
                on_body[2 * node + 1] += turn[1] * moment;
            }
        }
        on_body
    }

    /// Friction law at point `point`.
    pub fn law(&self, point: usize) -> &dyn FrictionLaw {
        self.pairs[self.points[point].pair].law.as_ref()
    }
}

/// Rows e_n and e_t.
pub(crate) fn frame(normal: [f64; 2]) -> Matrix2<f64> {
    Matrix2::new(normal[0], normal[1], -normal[1], normal[0])
}

fn problem_points(pairs: &[ContactPair], bodies: &[&dyn InterfaceOperator]) -> Vec<ProblemPoint> {
    let mut points = Vec::new();
    for (index, pair) in pairs.iter().enumerate() {
        for point in &pair.points {
            let nodes = bodies[pair.first].points();
            let [x, y] = point.first.position(nodes);
            let place = Place {
                position: [x + pair.origin[0], y + pair.origin[1]],
                tangent: [-point.normal[1], point.normal[0]],
                material_angle: point.material_angle,
            };
            points.push(ProblemPoint {
                pair: index,
                gap: point.gap,
                area: point.area,
                place,
                normal: point.normal,
                actions: actions(point, nodes),
                slides: true,
            });
        }
    }
    points
}

/// Force and moment on the first body by a unit normal and a unit tangential force at `point`.
fn actions(point: &ContactPoint, nodes: &[Point]) -> [[f64; 3]; 2] {
    let frame = frame(point.normal);
    let mut actions = [[0.0; 3]; 2];
    for term in point.first.terms() {
        let forces = term.matrix() * frame;
        let [x, y] = nodes[term.node];
        for (row, action) in actions.iter_mut().enumerate() {
            let (along_x, along_y) = (forces[(row, 0)], forces[(row, 1)]);
            action[0] += along_x;
            action[1] += along_y;
            action[2] += x * along_y - y * along_x;
        }
    }
    actions
}
