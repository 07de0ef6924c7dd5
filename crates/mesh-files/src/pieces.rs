//! An open chain of edges as lines and arcs, one after another.

use std::ops::RangeInclusive;

use stickslip_fem_core::mesh::{Curve, Point};

use crate::recognise::recognise;

/// Edges that a piece has on average at least: a curve of another kind falls apart into single edges.
const EDGES_OF_PIECE: usize = 3;

/// Edges by which the distances of nodes from a piece are known.
const SAMPLE: usize = 4;
/// Nodes of a longer piece may be off it by so many times as much.
const NOISE: f64 = 10.0;
/// Part of the radius, or of the length of a line, by which nodes may be off it in any case.
const ROUNDING: f64 = 1e-9;

/// A line or an arc of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Its nodes, as positions in the walk.
    pub nodes: RangeInclusive<usize>,
    /// What they lie on.
    pub curve: Curve,
}

/// Divides an open chain into lines and arcs, from its beginning; arguments as of [`recognise`]. None if a piece has fewer than three edges on average.
///
/// A piece is as long as its nodes are off it by no more than ten times what those of its first edges are, four at least, or 1e-9 of its radius or length: a flat arc that goes on as its
/// tangent leaves the tolerance of [`recognise`] late.
pub fn recognise_pieces(mesh_nodes: &[Point], walk: &[usize], order: usize) -> Option<Vec<Piece>> {
    let edges = walk.len().checked_sub(1)?.checked_div(order)?;
    let mut pieces = Vec::new();
    let mut from = 0;
    while from < edges {
        if (pieces.len() + 1) * EDGES_OF_PIECE > edges {
            return None;
        }
        let (to, piece) = longest(mesh_nodes, walk, order, [from, edges])?;
        pieces.push(piece);
        from = to;
    }
    (!pieces.is_empty()).then_some(pieces)
}

/// The piece from the corner `from`, up to the corner `end` at most, and where it ends.
fn longest(
    mesh_nodes: &[Point],
    walk: &[usize],
    order: usize,
    [from, end]: [usize; 2],
) -> Option<(usize, Piece)> {
    let up_to = |to: usize| {
        let nodes = from * order..=to * order;
        let found = recognise(mesh_nodes, walk.get(nodes)?, false, order)?;
        Some((to, found))
    };
    // Flat arcs are none before they turn by a degree, and what they end at must not be passed over.
    let next = |count: &usize| Some(count + (count / 64).max(1));
    let counts = std::iter::successors(Some(SAMPLE), next);
    let mut samples = counts.map(|count| from + count).take_while(|to| *to <= end);
    let first = samples.find_map(up_to);
    let best = match first {
        None => (from + 1..(from + SAMPLE).min(end + 1))
            .rev()
            .find_map(up_to)?,
        Some((sample, known)) => {
            let near = |to: usize| {
                let (_, found) = up_to(to)?;
                let rounding = match found.curve {
                    Curve::Arc { radius, .. } => ROUNDING * radius,
                    Curve::Line => {
                        let [a, b] = [from, to].map(|corner| mesh_nodes[walk[corner * order]]);
                        ROUNDING * (b[0] - a[0]).hypot(b[1] - a[1])
                    }
                };
                (found.residual <= rounding.max(NOISE * known.residual)).then_some((to, found))
            };
            // Twice as far each time, then in halves.
            let mut best = (sample, known);
            let mut beyond = end + 1;
            while best.0 + 1 < beyond {
                let far = from + 2 * (best.0 - from);
                let to = if far < beyond {
                    far
                } else {
                    best.0.midpoint(beyond)
                };
                match near(to) {
                    Some(found) => best = found,
                    None => beyond = to,
                }
            }
            best
        }
    };
    let (to, found) = best;
    let piece = Piece {
        nodes: from * order..=to * order,
        curve: found.curve,
    };
    Some((to, piece))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A flat of 2 mm between arcs that leave it as its tangents, in steps of `h`.
    fn face(radius: f64, h: f64) -> Vec<Point> {
        let flat = (1.0 / h).round() as i32;
        let on_arc = 40;
        let place = |k: i32| {
            let beyond = f64::from(k.abs() - flat) * h;
            let sign = f64::from(k.signum());
            if beyond <= 0.0 {
                return [f64::from(k) * h, 0.0];
            }
            let angle = beyond / radius;
            [
                sign * (1.0 + radius * angle.sin()),
                radius * (1.0 - angle.cos()),
            ]
        };
        (-flat - on_arc..=flat + on_arc).map(place).collect()
    }

    #[test]
    fn flat_arcs_end_where_the_flat_begins() {
        let h = 0.05;
        let nodes = face(50.0, h);
        let walk: Vec<usize> = (0..nodes.len()).collect();
        let pieces = recognise_pieces(&nodes, &walk, 1).unwrap();
        let ranges: Vec<_> = pieces.iter().map(|piece| piece.nodes.clone()).collect();
        assert_eq!(ranges, [0..=40, 40..=80, 80..=120]);
        assert_eq!(pieces[1].curve, Curve::Line);
        let Curve::Arc { radius, .. } = pieces[0].curve else {
            panic!("{pieces:?}");
        };
        assert!((radius - 50.0).abs() < 1e-6, "{radius}");
    }

    #[test]
    fn an_ellipse_is_neither() {
        let angle = |k: usize| 0.05 * k as f64;
        let nodes: Vec<Point> = (0..60)
            .map(|k| [2.0 * angle(k).cos(), angle(k).sin()])
            .collect();
        let walk: Vec<usize> = (0..nodes.len()).collect();
        assert_eq!(recognise_pieces(&nodes, &walk, 1), None);
    }
}
