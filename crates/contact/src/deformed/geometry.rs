//! Contact points at given displacements of the bodies.

use nalgebra::DVector;
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;

use super::curve::Curve;
use super::{DeformedGaps, Facing};
use crate::problem::{ContactPair, ContactPoint, Stencil, frame};

/// All contact points of a problem at one displacement of its bodies.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    pairs: Vec<ContactPair>,
    /// The most that a closest point may be away from where it is taken for `[length]`.
    bend: f64,
}

/// A point whose closest place on the second edge is not found.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Unfaced {
    /// Index of the point in the problem.
    pub(crate) point: usize,
}

impl Geometry {
    /// The points of `pairs` where the bodies of `gaps` are displaced by `moved`.
    pub(crate) fn at(
        gaps: &DeformedGaps<'_>,
        pairs: &[ContactPair],
        moved: &[DVector<f64>],
    ) -> Result<Self, Unfaced> {
        let (mut before, mut bend) = (0, 0.0_f64);
        let mut found = Vec::with_capacity(pairs.len());
        for (pair, facing) in pairs.iter().zip(&gaps.facings) {
            let edges = Edges::new(gaps, pair, facing, moved);
            let mut points = Vec::with_capacity(pair.points.len());
            for (k, point) in pair.points.iter().enumerate() {
                let by = edges.closest(k).ok_or(Unfaced { point: before + k })?;
                bend = bend.max(edges.bend(k, by));
                points.push(edges.point(k, point, by));
            }
            before += points.len();
            found.push(ContactPair {
                points,
                ..pair.clone()
            });
        }
        Ok(Self { pairs: found, bend })
    }

    /// The pairs with their points.
    pub(crate) fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// Gap and tangential motion `[length]` of all points, interleaved, where the bodies are displaced by `moved`.
    pub(crate) fn motion(&self, moved: &[DVector<f64>]) -> DVector<f64> {
        let points = self
            .pairs
            .iter()
            .flat_map(|pair| pair.points.iter().map(move |point| (pair, point)));
        let motion = points.flat_map(|(pair, point)| {
            let [normal, tangential] = relative(point, &moved[pair.first], &moved[pair.second]);
            [point.gap + normal, tangential]
        });
        DVector::from_vec(motion.collect())
    }

    /// The largest change to `other` of a gap, relative to the largest motion, where the bodies are displaced by `moved`, or of a normal.
    pub(crate) fn change(&self, other: &Self, moved: &[DVector<f64>]) -> f64 {
        let [motion, next] = [self, other].map(|geometry| geometry.motion(moved));
        let size = motion.amax().max(next.amax());
        let gaps = (0..motion.len()).step_by(2);
        let gap = gaps.fold(0.0, |most: f64, k| most.max((next[k] - motion[k]).abs()));
        let turn = self.normals().zip(other.normals()).map(|(one, next)| {
            let [x, y] = [0, 1].map(|i| next[i] - one[i]);
            x.hypot(y)
        });
        let relative = if size > 0.0 { gap / size } else { 0.0 };
        turn.fold(relative, f64::max)
    }

    /// By how much a closest point is away from where it is taken for, relative to the largest motion where the bodies are displaced by `moved`.
    pub(crate) fn error(&self, moved: &[DVector<f64>]) -> f64 {
        let size = self.motion(moved).amax();
        if size > 0.0 { self.bend / size } else { 0.0 }
    }

    fn normals(&self) -> impl Iterator<Item = [f64; 2]> {
        let points = self.pairs.iter().flat_map(|pair| &pair.points);
        points.map(|point| point.normal)
    }
}

/// Normal and tangential motion of the first body against the second at `point`.
fn relative(point: &ContactPoint, first: &DVector<f64>, second: &DVector<f64>) -> [f64; 2] {
    let own = motion(&point.first, point.normal, first);
    let other = motion(&point.second, point.normal, second);
    [own[0] - other[0], own[1] - other[1]]
}

fn motion(stencil: &Stencil, normal: [f64; 2], moved: &DVector<f64>) -> [f64; 2] {
    let frame = frame(normal);
    let terms = stencil.terms().iter();
    let sum = terms.fold(nalgebra::Vector2::zeros(), |sum, term| {
        sum + term.matrix() * (frame * moved.fixed_rows::<2>(2 * term.node))
    });
    [sum[0], sum[1]]
}

/// The two displaced edges of a pair, without turns about their centres of bodies that are free to turn.
struct Edges<'a> {
    facing: &'a Facing,
    /// Displacements of the two bodies.
    bodies: [&'a DVector<f64>; 2],
    /// Displacements of the points of the first edge, and of the nodes of the second.
    first: Vec<Point>,
    second: Vec<Point>,
}

impl<'a> Edges<'a> {
    fn new(
        gaps: &DeformedGaps<'_>,
        pair: &ContactPair,
        facing: &'a Facing,
        moved: &'a [DVector<f64>],
    ) -> Self {
        let bodies = [pair.first, pair.second].map(|body| &moved[body]);
        let turns = [pair.first, pair.second].map(|body| is_free_to_turn(gaps.bodies[body]));
        let at = |body: usize, node: usize| [bodies[body][2 * node], bodies[body][2 * node + 1]];
        let node = |point: &ContactPoint| point.first.node().unwrap_or_default();
        let curve = &facing.second;
        let first = (pair.points.iter()).map(|point| at(0, node(point)));
        let second = curve.nodes().iter().map(|&node| at(1, node));
        let (mut first, mut second): (Vec<Point>, Vec<Point>) = (first.collect(), second.collect());
        let areas: Vec<f64> = pair.points.iter().map(|point| point.area).collect();
        if let (true, Some(centre)) = (turns[0], facing.centre) {
            take_out_turn(&mut first, &facing.first, centre, &areas);
        }
        if let (true, Some(centre)) = (turns[1], curve.centre()) {
            let places: Vec<Point> = (0..second.len()).map(|k| curve.node(k)).collect();
            take_out_turn(&mut second, &places, centre, &areas);
        }
        Self {
            facing,
            bodies,
            first,
            second,
        }
    }

    /// Where the point `k` of the first edge stands.
    fn place(&self, k: usize) -> Point {
        let (place, by) = (self.facing.first[k], self.first[k]);
        [place[0] + by[0], place[1] + by[1]]
    }

    /// How far beyond the node `k` of the second edge the place lies that is nearest to the point `k` of the first.
    fn closest(&self, k: usize) -> Option<f64> {
        let curve = &self.facing.second;
        if curve.is_mirrored(k) {
            return Some(0.0);
        }
        curve.nearest(&self.second, self.place(k), k)
    }

    /// What the second derivative of displacements adds `by` beyond the node `k`.
    fn bend(&self, k: usize, by: f64) -> f64 {
        let [x, y] = self.facing.second.bend(&self.second, k);
        0.5 * by * by * x.hypot(y)
    }

    /// The point `k`, which is `point` on the undeformed edges and faces the place `by` beyond the node `k` of the second one.
    fn point(&self, k: usize, point: &ContactPoint, by: f64) -> ContactPoint {
        let curve = &self.facing.second;
        let local = curve.local(&self.second, k, by);
        let normal = if curve.is_mirrored(k) {
            point.normal
        } else {
            curve.normal(local.tangent)
        };
        let mut found = ContactPoint {
            second: stencil(curve, k, by),
            normal,
            gap: 0.0,
            ..point.clone()
        };
        let to = self.place(k);
        let away = [to[0] - local.place[0], to[1] - local.place[1]];
        let [linear, _] = relative(&found, self.bodies[0], self.bodies[1]);
        found.gap = away[0] * normal[0] + away[1] * normal[1] - linear;
        found
    }
}

/// Weights of the nodes in the displacement `by` beyond the node at `position`.
fn stencil(curve: &Curve, position: usize, by: f64) -> Stencil {
    let mut weights = vec![(position, 1.0)];
    for &(node, slope) in curve.slope(position).iter().filter(|_| by != 0.0) {
        if node == position {
            weights[0].1 += by * slope;
        } else {
            weights.push((node, by * slope));
        }
    }
    let node = |(position, weight): (usize, f64)| (curve.nodes()[position], weight);
    Stencil::weighted(weights.into_iter().map(node))
}

/// Whether a rigid motion of `body` that its supports leave free is not a translation.
fn is_free_to_turn(body: &dyn InterfaceOperator) -> bool {
    const ROUNDING: f64 = 1e-9;
    body.modes().column_iter().any(|mode| {
        let apart = (2..mode.len()).map(|row| (mode[row] - mode[row % 2]).abs());
        apart.fold(0.0, f64::max) > ROUNDING * mode.amax()
    })
}

/// Takes the mean turn about `centre` out of the displacements `moved` of `places`, each of which counts by its part of `areas`.
fn take_out_turn(moved: &mut [Point], places: &[Point], centre: Point, areas: &[f64]) {
    let arm = |place: &Point| [place[0] - centre[0], place[1] - centre[1]];
    let (mut turn, mut whole) = (0.0, 0.0);
    for ((by, place), area) in moved.iter().zip(places).zip(areas) {
        let [x, y] = arm(place);
        turn += area * (x * by[1] - y * by[0]);
        whole += area * (x * x + y * y);
    }
    let turn = turn / whole;
    for (by, place) in moved.iter_mut().zip(places) {
        let [x, y] = arm(place);
        *by = [by[0] + turn * y, by[1] - turn * x];
    }
}
