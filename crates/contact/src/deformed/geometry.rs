//! Contact points at given displacements of the bodies.

use nalgebra::{DVector, Matrix2, Vector2};
use stickslip_fem_core::InterfaceOperator;
use stickslip_fem_core::mesh::Point;

use super::curve::Curve;
use super::{DeformedGaps, Facing};
use crate::problem::{ContactPair, ContactPoint, Couple, Stencil, frame};

/// All contact points of a problem at one displacement of its bodies.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    pairs: Vec<ContactPair>,
    /// The displacements of the places that the points face, of each pair's points.
    faced: Vec<Vec<Stencil>>,
    couples: Vec<Couple>,
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
        let (mut before, mut bend, mut couples) = (0, 0.0_f64, Vec::new());
        let mut found = Vec::with_capacity(pairs.len());
        let mut all_faced = Vec::with_capacity(pairs.len());
        for (pair, facing) in pairs.iter().zip(&gaps.facings) {
            let edges = Edges::new(gaps, pair, facing, moved);
            let mut points = Vec::with_capacity(pair.points.len());
            let mut arms = Vec::with_capacity(pair.points.len());
            let mut faced = Vec::with_capacity(pair.points.len());
            for (k, point) in pair.points.iter().enumerate() {
                let by = edges.closest(k).ok_or(Unfaced { point: before + k })?;
                bend = bend.max(edges.bend(k, by));
                let (point, arm) = edges.point(k, point, by);
                points.push(point);
                arms.push(arm);
                faced.push(stencil(&facing.second, facing.second.slope(k), k, by));
            }
            all_faced.push(faced);
            couples.extend(edges.couples(pair, &points, &arms, before));
            before += points.len();
            found.push(ContactPair {
                points,
                ..pair.clone()
            });
        }
        Ok(Self {
            pairs: found,
            faced: all_faced,
            couples,
            bend,
        })
    }

    /// The pairs with their points, whose gaps are those at the displacement.
    pub(crate) fn pairs(&self) -> &[ContactPair] {
        &self.pairs
    }

    /// How turns of edges enter the motion of the points.
    pub(crate) fn couples(&self) -> &[Couple] {
        &self.couples
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

    /// Normal and tangential motion `[length]` of all points where the bodies are displaced by `moved`, as forces do work on it.
    pub(crate) fn relative(&self, moved: &[DVector<f64>]) -> Vec<[f64; 2]> {
        let seconds = self.points().map(|(_, point)| &point.second);
        self.motions(moved, seconds)
    }

    /// The same of the places that the points face.
    pub(crate) fn relative_to_faced(&self, moved: &[DVector<f64>]) -> Vec<[f64; 2]> {
        self.motions(moved, self.faced.iter().flatten())
    }

    fn motions<'a>(
        &'a self,
        moved: &[DVector<f64>],
        seconds: impl Iterator<Item = &'a Stencil>,
    ) -> Vec<[f64; 2]> {
        let motion = |((pair, point), second): ((&ContactPair, &ContactPoint), &Stencil)| {
            let own = motion(&point.first, point.normal, &moved[pair.first]);
            let other = motion(second, point.normal, &moved[pair.second]);
            [own[0] - other[0], own[1] - other[1]]
        };
        let mut all: Vec<[f64; 2]> = self.points().zip(seconds).map(motion).collect();
        for couple in &self.couples {
            let turn = couple.turn_of(moved[couple.body].as_slice());
            for (point, row) in &couple.rows {
                for i in 0..2 {
                    all[*point][i] += turn * row[i];
                }
            }
        }
        all
    }

    /// By how much a closest point may be away from where it is taken for `[length]`.
    pub(crate) fn error(&self) -> f64 {
        self.bend
    }
}

fn motion(stencil: &Stencil, normal: [f64; 2], moved: &DVector<f64>) -> [f64; 2] {
    let frame = frame(normal);
    let terms = stencil.terms().iter();
    let sum = terms.fold(Vector2::zeros(), |sum, term| {
        sum + term.matrix() * (frame * moved.fixed_rows::<2>(2 * term.node))
    });
    [sum[0], sum[1]]
}

/// The two displaced edges of a pair, circles without the turns about their centres of bodies that are free to turn.
struct Edges<'a> {
    facing: &'a Facing,
    /// The turns that are taken out.
    turns: [Option<Turn>; 2],
    /// Displacements of the points of the first edge, and of the nodes of the second.
    first: Vec<Point>,
    second: Vec<Point>,
}

/// The mean turn of an edge about a centre, by the areas of its nodes.
struct Turn {
    /// Places of the nodes, seen from the centre.
    arms: Vec<Point>,
    /// Weights of the nodes' displacements.
    weights: Vec<Point>,
}

impl Turn {
    /// That of the points of `pair` at `places`, whose displacements by a translation are `translated`. A translation is no turn: areas and places are those of one edge only where
    /// nodes stand at equal angles on both.
    fn new(
        places: impl Iterator<Item = Point>,
        centre: Point,
        pair: &ContactPair,
        translated: impl Fn(usize) -> Matrix2<f64>,
    ) -> Self {
        let arms: Vec<Vector2<f64>> = places
            .map(|[x, y]| Vector2::new(x - centre[0], y - centre[1]))
            .collect();
        let all = || (pair.points.iter().zip(&arms)).enumerate();
        let across = |arm: &Vector2<f64>| Vector2::new(-arm.y, arm.x);
        let (mut resultant, mut whole) = (Vector2::zeros(), Matrix2::zeros());
        for (k, (point, arm)) in all() {
            let by = translated(k);
            resultant += by.transpose() * across(arm) * point.area;
            whole += by.transpose() * by * point.area;
        }
        let drift = whole
            .try_inverse()
            .map_or_else(Vector2::zeros, |own| own * resultant);
        let weights: Vec<Vector2<f64>> = all()
            .map(|(k, (point, arm))| (across(arm) - translated(k) * drift) * point.area)
            .collect();
        let size: f64 = weights
            .iter()
            .zip(&arms)
            .map(|(own, arm)| own.dot(&across(arm)))
            .sum();
        Self {
            weights: weights.iter().map(|own| (own / size).into()).collect(),
            arms: arms.into_iter().map(Into::into).collect(),
        }
    }

    /// Takes the turn out of the displacements `moved` of the nodes.
    fn take_out(&self, moved: &mut [Point]) {
        let both = moved.iter().zip(&self.weights);
        let turn: f64 = both
            .map(|(by, weight)| by[0] * weight[0] + by[1] * weight[1])
            .sum();
        for (by, [x, y]) in moved.iter_mut().zip(&self.arms) {
            *by = [by[0] + turn * y, by[1] - turn * x];
        }
    }
}

impl<'a> Edges<'a> {
    fn new(
        gaps: &DeformedGaps<'_>,
        pair: &ContactPair,
        facing: &'a Facing,
        moved: &[DVector<f64>],
    ) -> Self {
        let curve = &facing.second;
        let at = |body: usize, node: usize| {
            let moved = &moved[body];
            [moved[2 * node], moved[2 * node + 1]]
        };
        let node = |point: &ContactPoint| point.first.node().unwrap_or_default();
        let first = (pair.points.iter()).map(|point| at(pair.first, node(point)));
        let second = curve.nodes().iter().map(|&node| at(pair.second, node));
        let mut both: [Vec<Point>; 2] = [first.collect(), second.collect()];
        let mut turns = [None, None];
        // Of a cylinder on a plane the turn about its centre rolls it.
        if let (Some(first), Some(second)) = (facing.centre, curve.centre()) {
            // Where the bodies turn about, which means over hats do within the circle.
            let [upper, lower] = [pair.first, pair.second].map(|body| gaps.bodies[body]);
            if gaps.turning[pair.first] {
                let places = pair.points.iter().map(|point| upper.points()[node(point)]);
                let translated = |k: usize| gaps.translated(pair.first, node(&pair.points[k]));
                turns[0] = Some(Turn::new(places, first, pair, translated));
            }
            if gaps.turning[pair.second] {
                let places = curve.nodes().iter().map(|&node| lower.points()[node]);
                let translated = |k: usize| gaps.translated(pair.second, curve.nodes()[k]);
                turns[1] = Some(Turn::new(places, second, pair, translated));
            }
        }
        for (turn, moved) in turns.iter().zip(&mut both) {
            if let Some(turn) = turn {
                turn.take_out(moved);
            }
        }
        let [first, second] = both;
        Self {
            facing,
            turns,
            first,
            second,
        }
    }

    /// How the turns that are taken out move `points`, which are at `arms` along the second edge and begin with the number `before`. A turn by φ about the
    /// centre moves the edge along itself, by `arm` φ, and not as its nodes do.
    fn couples(
        &self,
        pair: &ContactPair,
        points: &[ContactPoint],
        arms: &[f64],
        before: usize,
    ) -> Vec<Couple> {
        let sides = [(pair.first, 1.0), (pair.second, -1.0)];
        let turns = self.turns.iter().zip(sides).enumerate();
        let couple = |(side, (turn, (body, sign))): (usize, (&Option<Turn>, (usize, f64)))| {
            let turn = turn.as_ref()?;
            let nodes: Vec<usize> = if side == 0 {
                let nodes = points.iter().map(|point| point.first.node());
                nodes.map(Option::unwrap_or_default).collect()
            } else {
                self.facing.second.nodes().to_vec()
            };
            let row = |(k, point): (usize, &ContactPoint)| {
                let stencil = if side == 0 {
                    &point.first
                } else {
                    &point.second
                };
                let position = |node: usize| nodes.iter().position(|&own| own == node);
                let as_nodes = stencil.terms().iter().fold([0.0; 2], |sum, term| {
                    let [x, y] = position(term.node).map_or([0.0; 2], |own| turn.arms[own]);
                    let along = frame(point.normal) * Vector2::new(-y, x);
                    let weight = term.weights[0][0];
                    [sum[0] + weight * along[0], sum[1] + weight * along[1]]
                });
                let row = [-sign * as_nodes[0], sign * (arms[k] - as_nodes[1])];
                (before + k, row)
            };
            Some(Couple {
                body,
                turn: nodes
                    .iter()
                    .copied()
                    .zip(turn.weights.iter().copied())
                    .collect(),
                rows: points.iter().enumerate().map(row).collect(),
            })
        };
        turns.filter_map(couple).collect()
    }

    /// Where the point `k` of the first edge stands, seen from the origin of the second.
    fn place(&self, k: usize) -> Point {
        let (place, by, origin) = (
            self.facing.first[k],
            self.first[k],
            self.facing.second.origin(),
        );
        [0, 1].map(|axis| (place[axis] - origin[axis]) + by[axis])
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

    /// The point `k`, which is `point` on the undeformed edges and faces the place `by` beyond the node `k` of the second one; with the length |x′| of
    /// that edge by its parameter there.
    fn point(&self, k: usize, point: &ContactPoint, by: f64) -> (ContactPoint, f64) {
        let curve = &self.facing.second;
        let local = curve.local(&self.second, k, by);
        let normal = if curve.is_mirrored(k) {
            point.normal
        } else {
            curve.normal(local.tangent)
        };
        let to = self.place(k);
        let away = [to[0] - local.place[0], to[1] - local.place[1]];
        let found = ContactPoint {
            second: stencil(curve, curve.skew(k), k, by),
            normal,
            gap: away[0] * normal[0] + away[1] * normal[1],
            ..point.clone()
        };
        (found, local.tangent[0].hypot(local.tangent[1]))
    }
}

/// Weights of the nodes in the displacement `by` beyond the node at `position`, with the derivative `slopes` there.
fn stencil(curve: &Curve, slopes: &[(usize, f64)], position: usize, by: f64) -> Stencil {
    let mut weights = vec![(position, 1.0)];
    for &(node, slope) in slopes.iter().filter(|_| by != 0.0) {
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
pub fn is_free_to_turn(body: &dyn InterfaceOperator) -> bool {
    const ROUNDING: f64 = 1e-9;
    body.modes().column_iter().any(|mode| {
        let apart = (2..mode.len()).map(|row| (mode[row] - mode[row % 2]).abs());
        apart.fold(0.0, f64::max) > ROUNDING * mode.amax()
    })
}
