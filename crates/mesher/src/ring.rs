//! Structured layers of cells around a hole.
//!
//! ```text
//! x(k, j) = c + (R + Tₖ fⱼ) (cos θₖ, sin θₖ),   fⱼ = ((1 + δₖ)ʲ − 1) / ((1 + δₖ)ⁿ − 1)
//! ```
//!
//! with δₖ the mean interval of angles beside θₖ, so that cells are about square where Tₖ = R ((1 + δₖ)ⁿ − 1). Neighbours limit Tₖ.

use std::f64::consts::TAU;

use stickslip_fem_core::mesh::Point;

use crate::contour::Hole;
use crate::plan::Outline;
use crate::vector::{along, distance, unit};

/// Layers unless more or fewer are asked for.
const LAYERS: usize = 3;

/// Least mean thickness of a layer over the width of its cells on the hole; angles of such cells are above 25°, and a curved
/// edge of π/3 does not fold them (its sagitta is 0.134 of its chord, a quarter of the thickness bounds it).
const THINNEST: f64 = 0.6;

/// Share of the gap to the outline that a ring may take.
const SHARE_OUTLINE: f64 = 0.4;

/// Share of the gap to another hole that a ring may take.
const SHARE_HOLE: f64 = 1.0 / 3.0;

/// Largest change of the thickness per length along the hole.
const SLOPE: f64 = 0.3;

/// Largest change of δ per angle.
const SPACING_SLOPE: f64 = 0.3;

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
                let point = along(hole.centre, hole.radius, unit(angle));
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
            let enough = |(t, width): (&f64, &f64)| {
                *t >= THINNEST * layers as f64 * hole.radius * width
            };
            let fits = thickness.iter().zip(&widths).all(enough);
            fits.then_some((layers, thickness))
        });
        let (layers, thickness) = fitting.unwrap_or((0, vec![0.0; widths.len()]));
        let rows = (0..=layers)
            .map(|j| row(hole, &widths, &thickness, j, layers))
            .collect();
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
        along(self.centre, self.radius, unit(f64::midpoint(a, b)))
    }
}

/// Mean width of the intervals beside each angle `[rad]`, smoothed to [`SPACING_SLOPE`].
fn widths(angles: &[f64]) -> Vec<f64> {
    let intervals = intervals(angles);
    let count = angles.len();
    let mut widths: Vec<f64> = (0..count)
        .map(|k| f64::midpoint(intervals[k], intervals[(k + count - 1) % count]))
        .collect();
    limit_slope(&mut widths, &intervals, SPACING_SLOPE);
    widths
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

/// Row `j` of `layers`.
fn row(hole: &Hole, widths: &[f64], thickness: &[f64], j: usize, layers: usize) -> Vec<Point> {
    let sum = |width: f64, terms: usize| (terms as f64 * width.ln_1p()).exp_m1();
    let rays = hole.angles.iter().zip(widths).zip(thickness);
    rays.map(|((&angle, &width), &t)| {
        let offset = match j {
            0 => 0.0,
            j if j == layers => t,
            j => t * sum(width, j) / sum(width, layers),
        };
        along(hole.centre, hole.radius + offset, unit(angle))
    })
    .collect()
}
