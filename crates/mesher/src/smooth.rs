//! Smoothing: inner nodes move where the least angle of the cells around them grows.

use std::collections::BTreeSet;

use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::triangulate::Refinement;
use crate::vector::{circumcircle, least_sine, middle, orient};

/// Passes of smoothing, each followed by a new triangulation.
const PASSES: usize = 6;

/// Moves inner nodes and triangulates anew, and refines what became bad.
pub(crate) fn smooth(refinement: &mut Refinement<'_>) -> Result<(), ContourError> {
    for _ in 0..PASSES {
        let mut points = refinement.points();
        let triangles = refinement.triangles();
        let fixed: BTreeSet<usize> = refinement.segments().flat_map(|s| s.ends).collect();
        pass(&mut points, &triangles, &fixed);
        refinement.moved(&points)?;
        refinement.refine()?;
    }
    refinement.accepted()
}

fn pass(points: &mut [Point], triangles: &[[usize; 3]], fixed: &BTreeSet<usize>) {
    let mut around: Vec<Vec<[usize; 2]>> = vec![Vec::new(); points.len()];
    for &[a, b, c] in triangles {
        for (node, ends) in [(a, [b, c]), (b, [c, a]), (c, [a, b])] {
            around[node].push(ends);
        }
    }
    for (node, star) in around.iter().enumerate() {
        if fixed.contains(&node) || star.is_empty() {
            continue;
        }
        let worst = |at: Point| {
            let sines = star
                .iter()
                .map(|&[a, b]| least_sine([at, points[a], points[b]]));
            sines.fold(f64::INFINITY, f64::min)
        };
        let now = points[node];
        let targets = [mean(star, points), weighted_circumcentre(now, star, points)];
        let steps = targets.into_iter().flat_map(|to| [to, middle(now, to)]);
        let (mut best, mut at) = (worst(now), now);
        for to in steps {
            // A target that is not finite has a sine of NaN, which exceeds nothing.
            let sine = worst(to);
            if sine > best {
                (best, at) = (sine, to);
            }
        }
        points[node] = at;
    }
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
