//! Smoothing: inner nodes move where the least angle of the cells around them grows.

use std::collections::BTreeMap;
use std::f64::consts::FRAC_PI_4;

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::edges::Origin;
use crate::triangulate::Refinement;
use crate::vector::{along, circumcircle, distance, least_sine, middle, orient};

/// Passes of smoothing, each followed by a new triangulation.
const PASSES: usize = 5;

/// Passes at most, while cells are below [`GOOD`].
const MOST_PASSES: usize = 12;

/// Sine of the least angle, 30°, that ends smoothing.
const GOOD: f64 = 0.5;

/// Sine of the least angle, 32°, below which the best place of a node is searched for.
const POOR: f64 = 0.53;

/// Steps of that search.
const SEARCH: usize = 12;

/// Moves inner nodes and triangulates anew, refines what became bad, and keeps the best state.
pub(crate) fn smooth(refinement: &mut Refinement<'_>) -> Result<(), ContourError> {
    let mut best = refinement.state();
    for done in 1..=MOST_PASSES {
        let mut points = refinement.points();
        let triangles = refinement.triangles();
        pass(&mut points, &triangles, &freedom(refinement));
        refinement.moved(&points)?;
        refinement.refine()?;
        let state = refinement.state();
        if state.least_sine >= best.least_sine {
            best = state;
        }
        if done >= PASSES && best.least_sine > GOOD {
            break;
        }
    }
    refinement.restore(best)?;
    refinement.accepted()
}

/// How a node may move.
#[derive(Clone, Copy, PartialEq)]
enum Freedom {
    Free,
    /// Along the mirror where this coordinate is 0.
    Along(usize),
    Fixed,
}

/// How nodes of boundary edges may move.
fn freedom(refinement: &Refinement<'_>) -> BTreeMap<usize, Freedom> {
    let mut all: BTreeMap<usize, Freedom> = BTreeMap::new();
    for segment in refinement.segments() {
        let own = match segment.origin {
            Origin::Axis { across, open: true } => Freedom::Along(across),
            _ => Freedom::Fixed,
        };
        for node in segment.ends {
            let known = all.entry(node).or_insert(own);
            if *known != own {
                *known = Freedom::Fixed;
            }
        }
    }
    all
}

fn pass(points: &mut [Point], triangles: &[[usize; 3]], bound: &BTreeMap<usize, Freedom>) {
    let mut around: Vec<Vec<[usize; 2]>> = vec![Vec::new(); points.len()];
    for &[a, b, c] in triangles {
        for (node, ends) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
            around[node].push(ends);
        }
    }
    for (node, star) in around.iter().enumerate() {
        let freedom = bound.get(&node).copied().unwrap_or(Freedom::Free);
        if freedom == Freedom::Fixed || star.is_empty() {
            continue;
        }
        let held = |mut at: Point| {
            if let Freedom::Along(across) = freedom {
                at[across] = 0.0;
            }
            at
        };
        let worst = |at: Point| {
            let at = held(at);
            let cells = star.iter().map(|&[a, b]| [at, points[a], points[b]]);
            cells.map(least_sine).fold(f64::INFINITY, f64::min)
        };
        let now = points[node];
        let targets = [mean(star, points), weighted_circumcentre(now, star, points)];
        let tries = targets.into_iter().flat_map(|to| [to, middle(now, to)]);
        let mut best = better((worst(now), now), tries, worst);
        if best.0 < POOR {
            let sides = star.iter().map(|ends| distance(now, points[ends[0]]));
            best = searched(best, sides.fold(f64::INFINITY, f64::min), worst);
        }
        points[node] = held(best.1);
    }
}

/// The best of a place and others, by a measure.
fn better(
    first: (f64, Point),
    others: impl Iterator<Item = Point>,
    worst: impl Fn(Point) -> f64,
) -> (f64, Point) {
    others.fold(first, |best, at| {
        let found = worst(at);
        // A place that is not finite has a sine of NaN, which exceeds nothing.
        if found > best.0 { (found, at) } else { best }
    })
}

/// The best place by a pattern search of eight directions with halving steps, the first a quarter of `reach`.
fn searched(
    mut best: (f64, Point),
    reach: f64,
    worst: impl Fn(Point) -> f64 + Copy,
) -> (f64, Point) {
    let mut step = reach / 4.0;
    for _ in 0..SEARCH {
        let from = best.1;
        let around = (0..8).map(|k| along(from, step, unit_vector(f64::from(k) * FRAC_PI_4)));
        best = better(best, around, worst);
        if best.1 == from {
            step /= 2.0;
        }
    }
    best
}

/// Mean of the neighbours, each of which begins one edge of the star.
fn mean(star: &[[usize; 2]], points: &[Point]) -> Point {
    [0, 1].map(|c| star.iter().map(|ends| points[ends[0]][c]).sum::<f64>() / star.len() as f64)
}

/// Mean of the circumcentres of the star's triangles, weighted by their areas (Chen & Xu 2004).
fn weighted_circumcentre(at: Point, star: &[[usize; 2]], points: &[Point]) -> Point {
    let (mut sum, mut weight) = ([0.0; 2], 0.0);
    for &[a, b] in star {
        let triangle = [at, points[a], points[b]];
        let area = orient(triangle[0], triangle[1], triangle[2]);
        let (centre, _) = circumcircle(triangle);
        weight += area;
        sum = [0, 1].map(|c| sum[c] + area * centre[c]);
    }
    sum.map(|c| c / weight)
}
