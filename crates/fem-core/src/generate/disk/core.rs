//! The core of a disk: an octagon with a vertex on each half-axis and one in each quadrant.
//!
//! Each quadrant of the core is a quadrilateral centre – axis – corner – next axis, mapped bilinearly. On its outer sides the
//! nodes are half equally spaced, half following the rim's angles; on the half-axes equally spaced. Inside, lattice point
//! (i, j) is the crossing of the straight lines that join the i-th and j-th points of opposite sides.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_4};

use super::super::fan::{Rim, unit_vector};
use super::super::spacing::at_step;
use crate::mesh::Point;

/// Distance of the axis vertices over that of the corners when both are 45° apart: between a square (0.71) and a circle (1).
const BULGE: f64 = 0.85;

/// Farthest that a vertex turns from its nominal direction `[rad]`: 15°, which keeps the quadrants convex.
const LARGEST_TURN: f64 = FRAC_PI_4 / 3.0;

/// A quarter of the core.
#[derive(Debug)]
pub(super) struct Quadrant {
    /// First rim index of the quadrant.
    start: usize,
    /// Cells from the first axis to the corner, and from there to the next axis.
    before: usize,
    after: usize,
    /// First axis vertex, corner, next axis vertex `[length]`.
    vertices: [Point; 3],
    /// Node positions on the two outer sides, each from 0 to 1 in the sense of increasing angle.
    sides: [Vec<f64>; 2],
}

impl Quadrant {
    /// Cells along the first and the next half-axis.
    pub(super) fn cells(&self) -> [usize; 2] {
        [self.after, self.before]
    }

    /// Point at lattice position (i, j): i along the first half-axis, j along the next.
    pub(super) fn at(&self, i: f64, j: f64) -> Point {
        let [axis, corner, next] = self.vertices;
        let (columns, rows) = (self.after as f64, self.before as f64);
        let (bottom, left) = (i / columns, j / rows);
        let top = 1.0 - at_step(&self.sides[1], columns - i);
        let right = at_step(&self.sides[0], j);
        let u = ((1.0 - left) * bottom + left * top) / (1.0 - (top - bottom) * (right - left));
        let v = (1.0 - u) * left + u * right;
        [0, 1].map(|k| u * (1.0 - v) * axis[k] + u * v * corner[k] + (1.0 - u) * v * next[k])
    }

    /// Point of the outer sides at rim step `step`.
    fn outer(&self, step: f64) -> Point {
        let [axis, corner, next] = self.vertices;
        let step = step - self.start as f64;
        let before = self.before as f64;
        if step <= before {
            mixed(axis, corner, at_step(&self.sides[0], step))
        } else {
            mixed(corner, next, at_step(&self.sides[1], step - before))
        }
    }
}

/// The core of a whole or half disk.
#[derive(Debug)]
pub(super) struct Core {
    quadrants: Vec<Quadrant>,
}

impl Core {
    /// `radius` is that of the corners `[length]`; the rim has been checked for count and parity.
    pub(super) fn new(rim: &Rim, radius: f64) -> Self {
        let counts = if rim.closed {
            whole_counts(rim)
        } else {
            half_counts(rim)
        };
        let vertices = vertices(rim, radius, &counts);
        let mut start = 0;
        let mut quadrants = Vec::with_capacity(counts.len());
        for (k, [before, after]) in counts.into_iter().enumerate() {
            let sides = [
                positions(rim, start, before),
                positions(rim, start + before, after),
            ];
            let vertices = [0, 1, 2].map(|v| vertices[2 * k + v]);
            quadrants.push(Quadrant {
                start,
                before,
                after,
                vertices,
                sides,
            });
            start += before + after;
        }
        Self { quadrants }
    }

    pub(super) fn quadrants(&self) -> &[Quadrant] {
        &self.quadrants
    }

    /// Cells of the core as one lattice.
    pub(super) fn cells(&self) -> [usize; 2] {
        let first = &self.quadrants[0];
        let second = &self.quadrants[1];
        let below = self.quadrants.get(3).map_or(0, |last| last.after);
        [first.after + second.before, first.before + below]
    }

    /// Point of the outline at `step` of the rim.
    pub(super) fn outline(&self, step: f64) -> Point {
        let holds = |q: &&Quadrant| step < (q.start + q.before + q.after) as f64;
        match self.quadrants.iter().find(holds) {
            Some(quadrant) => quadrant.outer(step),
            // The end of the rim, where the last quadrant ends. Every core has quadrants.
            None => self.quadrants[self.quadrants.len() - 1].vertices[2],
        }
    }
}

/// The octagon's vertices, from the first axis on. A vertex turns part of the way to the rim node that it is joined to, so
/// that unequal lists of angles shear the rings less.
fn vertices(rim: &Rim, radius: f64, counts: &[[usize; 2]]) -> Vec<Point> {
    let ends = [0].into_iter().chain(counts.iter().flatten().copied());
    let rays = ends.scan(0, |sum, cells| {
        *sum += cells;
        Some(*sum)
    });
    let last = 2 * counts.len();
    let angles: Vec<f64> = rays
        .enumerate()
        .map(|(v, ray)| {
            let nominal = v as f64 * FRAC_PI_4;
            let turn = (rim.angles[ray] - nominal) / 2.0;
            let free = v != 0 && v != last;
            nominal
                + if free {
                    turn.clamp(-LARGEST_TURN, LARGEST_TURN)
                } else {
                    0.0
                }
        })
        .collect();
    let vertex = |(v, &angle): (usize, &f64)| {
        let axis_radius = || {
            let neighbours = [v.checked_sub(1), Some(v + 1)].into_iter().flatten();
            let apart = neighbours
                .filter_map(|k| angles.get(k))
                .map(|other| (other - angle).abs());
            let nearest = apart.fold(FRAC_PI_4, f64::min);
            1.0 - (1.0 - BULGE) * nearest / FRAC_PI_4
        };
        let relative = if v % 2 == 0 { axis_radius() } else { 1.0 };
        unit_vector(angle).map(|c| relative * radius * c)
    };
    let mut vertices: Vec<Point> = angles.iter().enumerate().map(vertex).collect();
    if rim.closed {
        vertices[last] = vertices[0];
    }
    vertices
}

fn mixed(a: Point, b: Point, share: f64) -> Point {
    [0, 1].map(|k| (1.0 - share) * a[k] + share * b[k])
}

/// Positions 0 … 1 of `cells + 1` nodes: mean of equal spacing and that of the rim's angles.
fn positions(rim: &Rim, start: usize, cells: usize) -> Vec<f64> {
    let angles = &rim.angles[start..=start + cells];
    let (from, to) = (angles[0], angles[cells]);
    let share = |k: usize| f64::midpoint(k as f64 / cells as f64, (angles[k] - from) / (to - from));
    (0..=cells).map(share).collect()
}

/// Sum of squares of the turns between rim nodes and the octagon's vertices they are joined to.
fn turns(rim: &Rim, counts: &[[usize; 2]]) -> f64 {
    let (mut index, mut vertex, mut sum) = (0, 0, 0.0);
    for cells in counts.iter().flatten() {
        index += cells;
        vertex += 1;
        sum += (rim.angles[index] - f64::from(vertex) * FRAC_PI_4).powi(2);
    }
    sum
}

/// Cells of the two outer sides of each quadrant of a half disk: [k, a], [b, k] with the smallest turns.
fn half_counts(rim: &Rim) -> Vec<[usize; 2]> {
    let cells = rim.intervals();
    let candidate = |k: usize| {
        let (first, last) = (k + 1, cells - k - 1);
        let above = rim.angles.partition_point(|&angle| angle < FRAC_PI_2);
        let near = |m: &usize| (rim.angles[*m] - FRAC_PI_2).abs();
        let choices = [above.saturating_sub(1), above].map(|m| m.clamp(first, last));
        let [a, b] = choices;
        let top = if near(&a) <= near(&b) { a } else { b };
        vec![[k, top - k], [cells - k - top, k]]
    };
    (2..=(cells - 2) / 2)
        .map(candidate)
        .fold(candidate(1), |best, other| {
            if turns(rim, &other) < turns(rim, &best) {
                other
            } else {
                best
            }
        })
}

/// Cells of the outer sides of each quadrant of a whole disk. One whose rim is mirrored about its first axis is two halves, so that models
/// of the half and of the whole have the same cells; any other is found by moving cells between the four free counts.
fn whole_counts(rim: &Rim) -> Vec<[usize; 2]> {
    if let Some(half) = rim.mirrored_half() {
        let upper = half_counts(&half);
        let lower = upper.iter().rev().map(|&[before, after]| [after, before]);
        return upper.iter().copied().chain(lower).collect();
    }
    let sides = |free: [usize; 4]| {
        let [a, b, c, d] = free;
        vec![[a, b], [c, a], [d, c], [b, d]]
    };
    let half = rim.intervals() / 2;
    let mut free = [0, 1, 2, 3].map(|k| half / 4 + usize::from(k < half % 4));
    let mut best = turns(rim, &sides(free));
    let mut step = (half / 8).max(1);
    loop {
        let mut improved = false;
        for (from, to) in (0..4).flat_map(|from| (0..4).map(move |to| (from, to))) {
            let mut moved = free;
            if from == to || moved[from] <= step {
                continue;
            }
            moved[from] -= step;
            moved[to] += step;
            let cost = turns(rim, &sides(moved));
            // A real gain only, so that rounding cannot make the search go round in circles.
            if cost < best * (1.0 - 1e-12) {
                (free, best, improved) = (moved, cost, true);
            }
        }
        match (improved, step) {
            (true, _) => {}
            (false, 1) => return sides(free),
            (false, _) => step /= 2,
        }
    }
}
