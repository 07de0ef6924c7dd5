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
    /// What second derivatives of displacements add to closest points at most `[length]`.
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

    /// The pairs with their points, whose gaps are those at the displacement.
    pub(crate) fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    fn points(&self) -> impl Iterator<Item = (&ContactPair, &ContactPoint)> {
        let points = |pair: &'_ ContactPair| pair.points.len();
        let all = self.pairs.iter();
        all.flat_map(move |pair| (0..points(pair)).map(move |k| (pair, &pair.points[k])))
    }

    /// Gaps `[length]` of all points.
    pub(crate) fn gaps(&self) -> Vec<f64> {
        self.points().map(|(_, point)| point.gap).collect()
    }

    /// Normals of all points.
    pub(crate) fn normals(&self) -> Vec<[f64; 2]> {
        self.points().map(|(_, point)| point.normal).collect()
    }

    /// Normal and tangential motion `[length]` of all points where the bodies are displaced by `moved`.
    pub(crate) fn relative(&self, moved: &[DVector<f64>]) -> Vec<[f64; 2]> {
        let motion = |(pair, point): (&ContactPair, &ContactPoint)| {
            relative(point, &moved[pair.first], &moved[pair.second])
        };
        self.points().map(motion).collect()
    }

    /// By how much a closest point may be away from where it is taken for `[length]`.
    pub(crate) fn error(&self) -> f64 {
        self.bend
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
    /// Displacements of the points of the first edge, and of the nodes of the second.
    first: Vec<Point>,
    second: Vec<Point>,
}

impl<'a> Edges<'a> {
    fn new(
        gaps: &DeformedGaps<'_>,
        pair: &ContactPair,
        facing: &'a Facing,
        moved: &[DVector<f64>],
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
        let to = self.place(k);
        let away = [to[0] - local.place[0], to[1] - local.place[1]];
        ContactPoint {
            second: stencil(curve, k, by),
            normal,
            gap: away[0] * normal[0] + away[1] * normal[1],
            ..point.clone()
        }
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
