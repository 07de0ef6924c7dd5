//! The line or circle that a chain of edges approximates.
//!
//! A circle through points pᵢ minimises Σ (|pᵢ − c| − R)². For a given centre c the best radius is the mean distance, so only c is
//! sought: from the algebraic fit (Kåsa) by Gauss–Newton with
//!
//! ```text
//! rᵢ = dᵢ − d̄,   ∂rᵢ/∂c = −(uᵢ − ū),   dᵢ = |pᵢ − c|,   uᵢ = (pᵢ − c)/dᵢ.
//! ```
//!
//! Sources: Kåsa (1976), *IEEE Trans. Instrum. Meas.* 25, 8–14; Chernov, *Circular and Linear Regression* (2010), chapters 4 and 5.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::{Curve, Point};
use stickslip_fem_core::vector::{cross, dot, minus};

/// Part of its length by which the nodes of a line may be off it.
const ON_LINE: f64 = 1e-6;

/// Part of the radius by which the corner nodes of a circle may be off it.
const ON_CIRCLE: f64 = 1e-5;

/// Part of its radius by which corner nodes may be off a circle that they are declared to lie on.
pub(crate) const NEARLY: f64 = 0.05;

/// Part of the height of the flattest arc over its chord by which nodes may be off it: a crooked line is no arc.
const OF_HEIGHT: f64 = 0.05;

/// Part of its chord by which a mid node may be off the middle of a straight edge.
const ON_CHORD: f64 = 1e-5;

/// The flattest arc `[rad]`.
const LEAST_TURN: f64 = 1.0 / 180.0 * std::f64::consts::PI;

/// The largest turn `[rad]` between corner nodes of straight edges, and between nodes of curved ones: corners of a square or hexagon lie
/// on a circle too.
pub(crate) const LARGEST_TURN: [f64; 2] = [0.88, 1.1];

/// A curve and how well it fits.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Recognised {
    /// The line or circle.
    pub curve: Curve,
    /// Largest distance of a corner node from it `[length]`; of a line, of any node.
    pub residual: f64,
}

/// Finds the straight line or the circle that the corner nodes of a chain lie on.
///
/// `mesh_nodes` are the places of all nodes `[length]`, `walk` the nodes of the chain in order with the mid nodes of its edges of
/// `order`; a `closed` chain does not repeat its first node (as in [`EdgePath`](stickslip_fem_core::mesh::EdgePath)).
///
/// All nodes of a line are within 1e-6 of its length. Corner nodes of a circle are within 1e-5 of its radius (and 5 % of the height of the
/// whole arc over its chord), inner nodes of edges on the circle or on the chord; an arc turns by at least 1°, has at least 4 nodes, and turns
/// by at most 50° from corner to corner (63° from node to node where mid nodes lie on the circle), so that the corners of a square are
/// no circle. None for everything else.
pub fn recognise(
    mesh_nodes: &[Point],
    walk: &[usize],
    closed: bool,
    order: usize,
) -> Option<Recognised> {
    let points: Option<Vec<Point>> = walk.iter().map(|&k| mesh_nodes.get(k).copied()).collect();
    let points = points?;
    let edges = (points.len() - usize::from(!closed && !points.is_empty())).checked_div(order)?;
    if edges == 0 || edges * order + usize::from(!closed) != points.len() {
        return None;
    }
    if !points.iter().flatten().all(|x| x.is_finite()) {
        return None;
    }
    let line = if closed { None } else { line(&points) };
    line.or_else(|| circle(&points, closed, order))
}

/// The circle of least squares through the `corners` of a closed chain, by a part of whose radius they may be off it that [`recognise`] does not accept: 5 %. None of other chains,
/// and of corners that do not go around its centre in steps of at most 50°.
pub fn nearly_circle(corners: &[Point]) -> Option<Recognised> {
    let fitted = fit(corners)?;
    let residual = corners.iter().map(|&p| fitted.off(p)).fold(0.0, f64::max);
    let turn = swept(&fitted, corners, true, LARGEST_TURN[0])?;
    let is_nearly = residual <= NEARLY * fitted.radius && (turn - TAU).abs() < 1e-6;
    is_nearly.then_some(Recognised {
        curve: Curve::Arc {
            centre: fitted.centre,
            radius: fitted.radius,
        },
        residual,
    })
}

/// Radius of the circle of least squares through the corners of a closed chain, their farthest way from it, and the largest angle `[rad]` between
/// neighbours as seen from its centre; infinite where there is none.
pub(crate) fn best_circle(corners: &[Point]) -> [f64; 3] {
    fit(corners).map_or([f64::INFINITY; 3], |circle| {
        let off = corners.iter().map(|&p| circle.off(p));
        let next = corners.iter().cycle().skip(1);
        let steps = corners.iter().zip(next);
        let steps = steps.map(|(&a, &b)| circle.turn(a, b).abs());
        [
            circle.radius,
            off.fold(0.0, f64::max),
            steps.fold(0.0, f64::max),
        ]
    })
}

fn norm(a: Point) -> f64 {
    a[0].hypot(a[1])
}

/// The line through the first and the last point.
fn line(points: &[Point]) -> Option<Recognised> {
    let (&first, &last) = (points.first()?, points.last()?);
    let along = minus(last, first);
    let length = norm(along);
    if length == 0.0 {
        return None;
    }
    let off = |&p: &Point| (cross(along, minus(p, first)) / length).abs();
    let residual = points.iter().map(off).fold(0.0, f64::max);
    let places = points.iter().map(|&p| dot(along, minus(p, first)));
    let is_straight = residual <= ON_LINE * length && places.is_sorted();
    is_straight.then_some(Recognised {
        curve: Curve::Line,
        residual,
    })
}

/// A circle; its points are given from some other origin.
#[derive(Clone, Copy, Debug)]
struct Circle {
    centre: Point,
    radius: f64,
}

impl Circle {
    fn off(&self, p: Point) -> f64 {
        (norm(minus(p, self.centre)) - self.radius).abs()
    }

    fn turn(&self, a: Point, b: Point) -> f64 {
        let (a, b) = (minus(a, self.centre), minus(b, self.centre));
        cross(a, b).atan2(dot(a, b))
    }
}

fn circle(points: &[Point], closed: bool, order: usize) -> Option<Recognised> {
    let corners: Vec<Point> = points.iter().step_by(order).copied().collect();
    let fitted = fit(&corners)?;
    let residual = corners.iter().map(|&p| fitted.off(p)).fold(0.0, f64::max);
    if residual > ON_CIRCLE * fitted.radius {
        return None;
    }
    // Whether all nodes lie on the circle, or those inside edges on chords.
    let is_curved = order > 1 && points.iter().all(|&p| on(&fitted, p));
    let evidence = if is_curved { points } else { &corners };
    let largest = LARGEST_TURN[usize::from(is_curved)];
    let total = swept(&fitted, evidence, closed, largest)?;
    let is_arc = if closed {
        evidence.len() >= 3 && (total - TAU).abs() < 1e-6
    } else {
        let height = fitted.radius * (1.0 - (0.5 * total.min(std::f64::consts::PI)).cos());
        points.len() >= 4
            && corners.len() >= 3
            && (LEAST_TURN..TAU).contains(&total)
            && residual <= OF_HEIGHT * height
    };
    let middles_fit = is_curved || middles_on(&fitted, points, order);
    (is_arc && middles_fit).then_some(Recognised {
        curve: Curve::Arc {
            centre: fitted.centre,
            radius: fitted.radius,
        },
        residual,
    })
}

fn on(circle: &Circle, p: Point) -> bool {
    circle.off(p) <= ON_CIRCLE * circle.radius
}

/// The angle that a chain sweeps about the centre, if all its steps go one way and none is larger than `largest`.
fn swept(circle: &Circle, points: &[Point], closed: bool, largest: f64) -> Option<f64> {
    let next = points.iter().cycle().skip(1);
    let steps = points.len() - usize::from(!closed);
    let turns = points.iter().zip(next).take(steps);
    let (mut sum, mut sign) = (0.0, 0.0);
    for (&a, &b) in turns {
        let turn = circle.turn(a, b);
        if turn.abs() > largest || turn == 0.0 || turn * sign < 0.0 {
            return None;
        }
        sign = turn;
        sum += turn;
    }
    Some(sum.abs())
}

/// Whether inner nodes of each edge lie on the circle or on the chord of the edge.
fn middles_on(circle: &Circle, points: &[Point], order: usize) -> bool {
    let count = points.len();
    // Positions are taken modulo the number of points.
    (0..count).filter(|k| k % order != 0).all(|k| {
        let start = points[k - k % order];
        let end = points[(k - k % order + order) % count];
        let chord = minus(end, start);
        let off = cross(chord, minus(points[k], start)).abs();
        on(circle, points[k]) || off <= ON_CHORD * dot(chord, chord)
    })
}

/// The circle of least squares through points.
fn fit(points: &[Point]) -> Option<Circle> {
    let count = points.len() as f64;
    let mean = [0, 1].map(|i| points.iter().map(|p| p[i]).sum::<f64>() / count);
    let scale = points
        .iter()
        .map(|&p| norm(minus(p, mean)))
        .fold(0.0, f64::max);
    if points.len() < 3 || scale == 0.0 {
        return None;
    }
    let local: Vec<Point> = points
        .iter()
        .map(|&p| minus(p, mean).map(|x| x / scale))
        .collect();
    let mut centre = kasa(&local)?;
    for _ in 0..30 {
        let step = gauss_newton(&local, centre)?;
        centre = [centre[0] + step[0], centre[1] + step[1]];
        if norm(step) <= 1e-14 * (1.0 + norm(centre)) {
            break;
        }
    }
    let radius = local.iter().map(|&p| norm(minus(p, centre))).sum::<f64>() / count;
    let found = Circle {
        centre: [mean[0] + scale * centre[0], mean[1] + scale * centre[1]],
        radius: scale * radius,
    };
    let is_finite = found.radius.is_finite() && norm(found.centre).is_finite();
    is_finite.then_some(found)
}

/// The centre of the algebraic fit to points about their mean.
fn kasa(points: &[Point]) -> Option<Point> {
    let (mut matrix, mut right) = ([0.0; 3], [0.0; 2]);
    for &[x, y] in points {
        let square = x * x + y * y;
        matrix = [matrix[0] + x * x, matrix[1] + x * y, matrix[2] + y * y];
        right = [right[0] + 0.5 * x * square, right[1] + 0.5 * y * square];
    }
    solve(matrix, right)
}

/// The step of the centre that best reduces the differences of distances.
fn gauss_newton(points: &[Point], centre: Point) -> Option<Point> {
    let count = points.len() as f64;
    let spans = || points.iter().map(|&p| minus(p, centre));
    let (mut mean, mut mean_direction) = (0.0, [0.0; 2]);
    for span in spans() {
        let distance = norm(span);
        mean += distance / count;
        for i in 0..2 {
            mean_direction[i] += span[i] / distance / count;
        }
    }
    let (mut matrix, mut right) = ([0.0; 3], [0.0; 2]);
    for span in spans() {
        let distance = norm(span);
        let [x, y] = minus(span.map(|x| x / distance), mean_direction);
        matrix = [matrix[0] + x * x, matrix[1] + x * y, matrix[2] + y * y];
        let difference = distance - mean;
        right = [right[0] + x * difference, right[1] + y * difference];
    }
    solve(matrix, right)
}

/// Solves [[a, b], [b, c]] x = right; none if the points lie on a line.
fn solve([a, b, c]: [f64; 3], right: [f64; 2]) -> Option<Point> {
    let determinant = a * c - b * b;
    // A matrix this close to singular belongs to an arc far flatter than the flattest.
    let is_regular = determinant > 1e-14 * (a + c).powi(2);
    is_regular.then(|| {
        [
            (c * right[0] - b * right[1]) / determinant,
            (a * right[1] - b * right[0]) / determinant,
        ]
    })
}
