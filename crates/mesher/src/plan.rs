//! What a mesh is made from: the exact outline, the rings and the size of cells.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::{Curve, ElementKind, Point};

use crate::contour::{Contour, Hole, checked};
use crate::outline::Outline;
use crate::ring::Ring;
use crate::size::{SHARP, Size};
use crate::vector::distance;
use crate::{ContourError, Division};

/// A checked contour and division, ready to be meshed.
#[derive(Debug)]
pub(crate) struct Plan {
    pub(crate) outline: Outline,
    pub(crate) rings: Vec<Ring>,
    pub(crate) size: Size,
    /// Length of the first edges on both sides of the corner where a piece begins, if the corner is acute `[length]`.
    pub(crate) first_edges: Vec<Option<f64>>,
}

/// Cells of a triangulation in units of ∫ dA/h²: between equilateral ones of circumradius 0.65 h and those of sides h.
const CELLS_PER_SIZE: f64 = 3.6;

/// Longest first edge beside an acute corner over the shorter piece.
pub(crate) const FIRST_EDGE: f64 = 0.25;

/// Deepest halving of the box in which the number of cells is estimated.
const DEPTH: usize = 9;

impl Plan {
    pub(crate) fn new(contour: &Contour, division: &Division) -> Result<Self, ContourError> {
        let outline = checked(contour)?;
        check_division(division, &outline.names)?;
        check_points(division, &outline)?;
        Ok(Self::of(outline, &contour.holes, division))
    }

    /// The plan of what has been checked.
    pub(crate) fn of(outline: Outline, holes: &[Hole], division: &Division) -> Self {
        let rings: Vec<Ring> = (0..holes.len())
            .map(|k| Ring::new(k, holes, &outline))
            .collect();
        let mut size = Size::new(holes, division, &outline, &rings);
        let first_edges = (0..outline.tracks.len())
            .map(|k| first_edge(&outline, k, &mut size))
            .collect();
        Self {
            outline,
            rings,
            size,
            first_edges,
        }
    }

    /// The line or circle that all pieces called `name` lie on, or the hole with that name.
    pub(crate) fn shared_curve(&self, name: &str) -> Option<Curve> {
        if let Some(ring) = self.rings.iter().find(|ring| ring.name == name) {
            let (centre, radius) = (ring.centre, ring.radius);
            return Some(Curve::Arc { centre, radius });
        }
        let pieces = self.outline.names.iter().zip(&self.outline.tracks);
        let mut own = pieces
            .filter(|(piece, _)| *piece == name)
            .map(|(_, track)| track);
        let first = own.next()?;
        // Arcs from three points know their circle to rounding over their sagitta only.
        let tolerance = 1e3 * self.outline.tolerance;
        own.all(|track| first.continues(track, tolerance))
            .then(|| first.curve())
            .flatten()
    }

    /// About how many cells and corner nodes the mesh will have, rather more than fewer.
    pub(crate) fn estimate(&self, refined: &BTreeMap<usize, f64>) -> (f64, f64) {
        let [low, high] = self.outline.bounds;
        let middle = [0, 1].map(|c| f64::midpoint(low[c], high[c]));
        let half = [0, 1].map(|c| (high[c] - low[c]) / 2.0);
        let cells = CELLS_PER_SIZE * self.integral(middle, half, DEPTH);
        let structured: usize = self.rings.iter().map(Ring::cells).sum();
        let pieces = self.outline.numbers.iter().zip(&self.outline.tracks);
        // A row of cells along fine pieces that the integral does not resolve.
        let along: f64 = pieces
            .filter_map(|(piece, track)| {
                Some(track.length() * refined.get(piece)? / self.size.cap())
            })
            .sum();
        let cells = cells.max(2.0 * along) + structured as f64;
        let holes: usize = self.rings.iter().map(|ring| ring.angles.len()).sum();
        (cells, cells / 2.0 + along + holes as f64 + 8.0)
    }

    /// ∫ dA/h² over the part of a box that is to be triangulated `[1]`.
    fn integral(&self, middle: Point, half: Point, depth: usize) -> f64 {
        let size = self.size.at(middle);
        let [a, b] = half;
        if depth > 0 && a.hypot(b) > size {
            let quarters = [[-0.5, -0.5], [0.5, -0.5], [-0.5, 0.5], [0.5, 0.5]];
            let parts = quarters
                .map(|[s, t]| [middle[0] + s * a, middle[1] + t * b])
                .map(|centre| self.integral(centre, [a / 2.0, b / 2.0], depth - 1));
            return parts.into_iter().sum();
        }
        let in_ring = |ring: &Ring| distance(ring.centre, middle) < ring.reach;
        if self.rings.iter().any(in_ring) || !self.outline.contains(middle) {
            return 0.0;
        }
        4.0 * a * b / (size * size)
    }
}

/// Equal first edges beside an acute corner cut an isosceles cell off it; beyond, cells are as small as its base.
fn first_edge(outline: &Outline, k: usize, size: &mut Size) -> Option<f64> {
    let angle = outline.angle(k);
    if angle >= SHARP {
        return None;
    }
    let (before, after) = (&outline.tracks[outline.before(k)], &outline.tracks[k]);
    let shorter = before.length().min(after.length());
    let edge = size.at(after.from).min(FIRST_EDGE * shorter);
    let ends = [
        before.at(before.length() - before.chord_to_length(edge, before.length(), true)),
        after.at(after.chord_to_length(edge, 0.0, false)),
    ];
    size.add(&ends, distance(ends[0], ends[1]));
    Some(edge)
}

/// Points are ends of pieces, and nothing else has their names.
fn check_points(division: &Division, outline: &Outline) -> Result<(), ContourError> {
    for (name, &at) in &division.points {
        if outline.names.contains(name) {
            return Err(ContourError::DuplicateName { name: name.clone() });
        }
        let apart = outline.tracks.iter().map(|track| distance(track.from, at));
        let nearest = apart.fold(f64::INFINITY, f64::min);
        if nearest.is_nan() || nearest > outline.tolerance {
            return Err(ContourError::NoEnd {
                point: name.clone(),
                at,
                distance: nearest,
            });
        }
    }
    Ok(())
}

fn check_division(division: &Division, names: &[String]) -> Result<(), ContourError> {
    let kind = division.kind;
    if !matches!(kind, ElementKind::T3 | ElementKind::T6) {
        return Err(ContourError::Kind { kind });
    }
    positive("fineness", division.fineness)?;
    let value = division.growth / division.fineness;
    if !(value > 0.0 && value <= 1.0) {
        return Err(ContourError::Growth { value });
    }
    if let Some(c) = division.centre.into_iter().find(|c| !c.is_finite()) {
        return Err(ContourError::NotFinite {
            what: "centre".into(),
            value: c,
        });
    }
    if let Some(value) = division.spacing {
        positive("spacing", value)?;
    }
    let mut refined = division.refined.iter();
    if let Some((&piece, &times)) = refined
        .find(|&(piece, times)| *piece >= names.len() || !(*times >= 1.0 && times.is_finite()))
    {
        return Err(ContourError::Refined {
            piece,
            times,
            count: names.len(),
        });
    }
    Ok(())
}

fn positive(what: &str, value: f64) -> Result<(), ContourError> {
    let what = what.to_owned();
    if !value.is_finite() {
        return Err(ContourError::NotFinite { what, value });
    }
    if value <= 0.0 {
        return Err(ContourError::NotPositive { what, value });
    }
    Ok(())
}
