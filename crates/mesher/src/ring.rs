//! Structured layers of cells around a hole.
//!
//! ```text
//! x(k, j) = c + (R + Tₖ fⱼ) (cos θₖ, sin θₖ),   fⱼ = ((1 + δₖ)ʲ − 1) / ((1 + δₖ)ⁿ − 1)
//! ```
//!
//! with δₖ the mean interval of angles beside θₖ, so that cells are about square where Tₖ = R ((1 + δₖ)ⁿ − 1). Neighbours limit Tₖ.

use std::f64::consts::{PI, TAU};

use stickslip_fem_core::generate::unit_vector;
use stickslip_fem_core::mesh::Point;

use crate::contour::Hole;
use crate::outline::Outline;
use crate::vector::{along, distance, least_sine};

/// Layers unless more or fewer are asked for.
const LAYERS: usize = 3;

/// Least angle of cells in a ring, 26° `[rad]`.
const LEAST_ANGLE: f64 = 26.0 * PI / 180.0;

/// Share of the gap to the outline that a ring may take.
const SHARE_OUTLINE: f64 = 0.4;

/// Share of the gap to another hole that a ring may take.
const SHARE_HOLE: f64 = 1.0 / 3.0;

/// Largest change of the thickness per length along the hole.
const SLOPE: f64 = 0.3;

/// The nodes around a hole.
#[derive(Debug)]
pub(crate) struct Ring {
    pub(crate) name: String,
    pub(crate) centre: Point,
    pub(crate) radius: f64,
    pub(crate) angles: Vec<f64>,
    /// Rows of nodes, one per angle, from the hole outwards: one more than layers.
    pub(crate) rows: Vec<Vec<Point>>,
    /// Least distance of the outermost row from the centre `[length]`.
    pub(crate) reach: f64,
}

impl Ring {
    /// The ring of hole `k` among `holes`, all checked.
    pub(crate) fn new(k: usize, holes: &[Hole], outline: &Outline) -> Self {
        let hole = &holes[k];
        let limits: Vec<f64> = hole
            .angles
            .iter()
            .map(|&angle| {
                let point = along(hole.centre, hole.radius, unit_vector(angle));
                let others = holes.iter().enumerate().filter(|&(other, _)| other != k);
                let gaps = others.map(|(_, other)| distance(point, other.centre) - other.radius);
                let gap = gaps.fold(f64::INFINITY, f64::min);
                (SHARE_HOLE * gap).min(SHARE_OUTLINE * outline.distance(point))
            })
            .collect();
        let widths = widths(&hole.angles);
        let wanted = hole.layers.unwrap_or(LAYERS);
        let fitting = (1..=wanted).rev().find_map(|layers| {
            let thickness = thickness(hole, &widths, &limits, layers);
            let rows = rows(hole, &widths, &thickness, layers);
            good(&rows, &hole.angles).then_some((rows, thickness))
        });
        let (rows, thickness) = fitting.unwrap_or_else(|| {
            let none = vec![0.0; widths.len()];
            (rows(hole, &widths, &none, 0), none)
        });
        let least = thickness.iter().copied().fold(f64::INFINITY, f64::min);
        Self {
            name: hole.name.clone(),
            centre: hole.centre,
            radius: hole.radius,
            angles: hole.angles.clone(),
            rows,
            reach: hole.radius + least,
        }
    }

    /// The outermost row of nodes, which bounds the triangulation.
    pub(crate) fn outer(&self) -> &[Point] {
        // There is always the row on the hole.
        &self.rows[self.rows.len() - 1]
    }

    /// Number of triangles in the layers.
    pub(crate) fn cells(&self) -> usize {
        2 * self.angles.len() * (self.rows.len() - 1)
    }

    /// Point of the circle half-way between angle `k` and the next.
    pub(crate) fn halfway(&self, k: usize) -> Point {
        let a = self.angles[k];
        let next = self.angles.get(k + 1);
        let b = next.map_or_else(|| self.angles[0] + TAU, |&b| b);
        along(self.centre, self.radius, unit_vector(f64::midpoint(a, b)))
    }
}

/// Mean width of the intervals beside each angle `[rad]`.
fn widths(angles: &[f64]) -> Vec<f64> {
    let intervals = intervals(angles);
    let count = angles.len();
    (0..count)
        .map(|k| f64::midpoint(intervals[k], intervals[(k + count - 1) % count]))
        .collect()
}

/// Whether all cells between rows have good angles, large enough that a curved edge folds no T6 cell: the tangent of an angle at
/// the edge's ends must exceed four times its sagitta over its chord.
fn good(rows: &[Vec<Point>], angles: &[f64]) -> bool {
    let widest = intervals(angles).into_iter().fold(0.0, f64::max);
    let folded = (2.0 * (widest / 4.0).tan()).atan();
    let least = LEAST_ANGLE.max(folded).sin();
    let count = angles.len();
    rows.windows(2).all(|pair| {
        (0..count).all(|k| {
            let next = (k + 1) % count;
            let corners = [pair[0][k], pair[1][k], pair[1][next], pair[0][next]];
            let cells = cut(corners).map(|cell| cell.map(|n| corners[n]));
            cells.into_iter().all(|cell| least_sine(cell) > least)
        })
    })
}

/// Corners of the two triangles of a quadrilateral cut along its shorter diagonal, from the first corner if both are equal to rounding.
pub(crate) fn cut([a, b, c, d]: [Point; 4]) -> [[usize; 3]; 2] {
    if distance(a, c) <= (1.0 + 1e-9) * distance(b, d) {
        [[0, 1, 2], [0, 2, 3]]
    } else {
        [[0, 1, 3], [1, 2, 3]]
    }
}

/// Interval after each angle `[rad]`.
fn intervals(angles: &[f64]) -> Vec<f64> {
    let next = angles.iter().skip(1).copied().chain([angles[0] + TAU]);
    angles.iter().zip(next).map(|(a, b)| b - a).collect()
}

/// Lowers a closed list until neighbours differ by at most `slope` times the interval between them.
fn limit_slope(list: &mut [f64], intervals: &[f64], slope: f64) {
    let count = list.len();
    // Twice around carries a limit past the beginning.
    for k in 0..2 * count {
        let (a, b) = (k % count, (k + 1) % count);
        list[b] = list[b].min(list[a] + slope * intervals[a]);
    }
    for k in (0..2 * count).rev() {
        let (a, b) = (k % count, (k + 1) % count);
        list[a] = list[a].min(list[b] + slope * intervals[a]);
    }
}

/// Thickness of all layers together at each angle `[length]`.
fn thickness(hole: &Hole, widths: &[f64], limits: &[f64], layers: usize) -> Vec<f64> {
    let square = |width: f64| hole.radius * (layers as f64 * width.ln_1p()).exp_m1();
    let mut list: Vec<f64> = widths
        .iter()
        .zip(limits)
        .map(|(&width, &limit)| square(width).min(limit))
        .collect();
    limit_slope(&mut list, &intervals(&hole.angles), SLOPE * hole.radius);
    list
}

/// Rows of nodes from the hole outwards.
fn rows(hole: &Hole, widths: &[f64], thickness: &[f64], layers: usize) -> Vec<Vec<Point>> {
    let sum = |width: f64, terms: usize| (terms as f64 * width.ln_1p()).exp_m1();
    let row = |j: usize| {
        let rays = hole.angles.iter().zip(widths).zip(thickness);
        rays.map(|((&angle, &width), &t)| {
            let offset = match j {
                0 => 0.0,
                j if j == layers => t,
                j => t * sum(width, j) / sum(width, layers),
            };
            along(hole.centre, hole.radius + offset, unit_vector(angle))
        })
        .collect()
    };
    (0..=layers).map(row).collect()
}
