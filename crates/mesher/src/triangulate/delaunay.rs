//! Triangulations of the library, and points as it takes them.

use std::collections::BTreeMap;

use spade::{ConstrainedDelaunayTriangulation, HierarchyHintGenerator, Point2, Triangulation};
use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::edges::Segment;

/// Constrained triangulations of plain points; they find places in logarithmic time.
pub(super) type Delaunay =
    ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

/// The constrained Delaunay triangulation of points, numbered as they come.
pub(super) fn triangulated(
    points: &[Point],
    segments: &BTreeMap<[usize; 2], Segment>,
) -> Result<Delaunay, ContourError> {
    let vertices: Vec<Point2<f64>> = points.iter().map(|&point| position(point)).collect();
    let edges = segments.keys().copied().collect();
    let mut conflicts = Vec::new();
    let delaunay = Delaunay::try_bulk_load_cdt(vertices, edges, |ends| conflicts.push(ends))
        .map_err(refused)?;
    if delaunay.num_vertices() != points.len() || delaunay.num_constraints() != segments.len() {
        let at = conflicts.first().and_then(|ends| points.get(ends[0]));
        return Err(crossed(at.copied().unwrap_or([f64::NAN; 2])));
    }
    Ok(delaunay)
}

pub(super) fn refused(error: spade::InsertionError) -> ContourError {
    ContourError::Triangulation {
        reason: error.to_string(),
    }
}

pub(super) fn crossed(at: Point) -> ContourError {
    ContourError::EdgesMeet { at }
}

pub(super) fn key([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

pub(super) fn plain(position: Point2<f64>) -> Point {
    [position.x, position.y]
}

/// The position of a node; what is too small for the exact predicates is 0 there.
pub(super) fn position(point: Point) -> Point2<f64> {
    let [x, y] = point.map(|c| {
        if c.abs() < spade::MIN_ALLOWED_VALUE {
            0.0
        } else {
            c
        }
    });
    Point2::new(x, y)
}
