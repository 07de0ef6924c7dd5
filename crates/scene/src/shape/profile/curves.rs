//! The exact curves of an outline's edges.

use std::borrow::Cow;

use stickslip_fem_core::mesh::Point;
use stickslip_mesher::{Contour, Course, Cutout, Piece};

use crate::shape::curve::Curve;
use crate::shape::outline::{Edge, Role};

/// Edges around the body, which is on their left.
pub(super) fn around(contour: &Contour) -> Vec<Edge> {
    joined(curves(contour.start, &contour.pieces))
}

/// Edges of a cut-out, with the body on their left; one circle is a hole.
pub(super) fn cut_out(own: &Cutout) -> Vec<Edge> {
    let mut curves = curves(own.start, &own.pieces);
    curves.reverse();
    for (_, curve) in &mut curves {
        *curve = curve.reversed();
    }
    let mut edges = joined(curves);
    if let [only] = edges.as_mut_slice()
        && let Some(circle) = only.curve.as_circle()
    {
        only.curve = circle;
        only.role = Role::Hole;
    }
    edges
}

/// The named curve of each piece of a loop from `start`.
fn curves(start: Point, pieces: &[Piece]) -> Vec<(String, Curve)> {
    let begins = std::iter::once(start).chain(pieces.iter().map(|piece| piece.to));
    let curve = |(piece, from): (&Piece, Point)| {
        let ends = [from, piece.to];
        let bent = match &piece.course {
            Course::Line => None,
            Course::Arc(through) => Curve::through(from, *through, piece.to),
            Course::Spline(_) => Curve::spline(ends, &piece.course),
        };
        (piece.name.clone(), bent.unwrap_or(Curve::Segment { ends }))
    };
    pieces.iter().zip(begins).map(curve).collect()
}

/// The edges of a loop of named curves, of which neighbours with one name are one edge.
fn joined(mut curves: Vec<(String, Curve)>) -> Vec<Edge> {
    // An edge may go on beyond where the loop begins.
    let count = curves.len();
    let begins = |k: &usize| curves[*k].0 != curves[(*k + count - 1) % count].0;
    let first = (0..count).find(begins).unwrap_or(0);
    curves.rotate_left(first);
    let runs = curves.chunk_by(|(one, _), (other, _)| one == other);
    let edge = |run: &[(String, Curve)]| Edge {
        name: Cow::Owned(run[0].0.clone()),
        curve: Curve::joined(&run.iter().map(|(_, curve)| curve).collect::<Vec<_>>()),
        role: Role::Free,
        size: None,
    };
    runs.map(edge).collect()
}
