//! Nodes and edges on the boundary of what is to be triangulated.

use std::collections::BTreeSet;

use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::plan::Plan;
use crate::size::SHARP;

/// Where an edge of the triangulation's boundary comes from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Origin {
    /// Part of a piece between two arc lengths `[length]`.
    Piece {
        piece: usize,
        from: f64,
        to: f64,
        /// Whether it may be split.
        open: bool,
    },
    /// The outermost edge of a ring from its ray `ray + 1` to `ray`.
    Ring { ring: usize, ray: usize },
}

/// A directed edge with the body on its left.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Segment {
    pub(crate) ends: [usize; 2],
    pub(crate) origin: Origin,
}

impl Segment {
    /// Whether it may not be split.
    pub(crate) fn fixed(&self) -> bool {
        !matches!(self.origin, Origin::Piece { open: true, .. })
    }
}

/// The boundary of what is to be triangulated.
#[derive(Debug)]
pub(crate) struct Boundary {
    pub(crate) points: Vec<Point>,
    pub(crate) segments: Vec<Segment>,
    /// Nodes at acute corners.
    pub(crate) acute: BTreeSet<usize>,
}

/// Steps of the integral of 1/h per size.
const STEPS_PER_SIZE: f64 = 4.0;

impl Boundary {
    /// Divides the pieces by the size function; at most `limit` nodes.
    pub(crate) fn new(plan: &Plan, limit: usize) -> Result<Self, ContourError> {
        let mut boundary = Self {
            points: Vec::new(),
            segments: Vec::new(),
            acute: BTreeSet::new(),
        };
        for pieces in &plan.outline.loops {
            let first = boundary.points.len();
            for k in pieces.clone() {
                boundary.piece(plan, k, limit)?;
            }
            // The last node of the last piece is the first of the first.
            if let Some(last) = boundary.segments.last_mut() {
                last.ends[1] = first;
            }
        }
        for (k, ring) in plan.rings.iter().enumerate() {
            let first = boundary.points.len();
            let count = ring.outer().len();
            boundary.points.extend(ring.outer());
            let segments = (0..count).map(|ray| Segment {
                ends: [first + (ray + 1) % count, first + ray],
                origin: Origin::Ring { ring: k, ray },
            });
            boundary.segments.extend(segments);
        }
        Ok(boundary)
    }

    /// Adds the nodes of piece `k` without its end.
    fn piece(&mut self, plan: &Plan, k: usize, limit: usize) -> Result<(), ContourError> {
        let track = &plan.outline.tracks[k];
        let next = plan.outline.after(k);
        if plan.outline.angle(k) < SHARP {
            self.acute.insert(self.points.len());
        }
        let [first, last] = [plan.first_edges[k], plan.first_edges[next]]
            .map(|edge| edge.map_or(0.0, |chord| track.chord_to_length(chord)));
        let (from, to) = (first, track.length() - last);
        let mut places = vec![from];
        places.extend(plan.divided(k, from, to, limit)?);
        places.push(to);
        let closed = [first > 0.0, last > 0.0];
        if closed[0] {
            places.insert(0, 0.0);
        }
        if closed[1] {
            places.push(track.length());
        }
        let edges = places.len() - 1;
        for (n, pair) in places.windows(2).enumerate() {
            let node = self.points.len();
            self.points.push(track.at(pair[0]));
            self.segments.push(Segment {
                ends: [node, node + 1],
                origin: Origin::Piece {
                    piece: k,
                    from: pair[0],
                    to: pair[1],
                    open: !(closed[0] && n == 0 || closed[1] && n + 1 == edges),
                },
            });
        }
        Ok(())
    }
}

impl Plan {
    /// Arc lengths strictly between two on a piece, equally spaced in ∫ ds/h.
    fn divided(
        &self,
        piece: usize,
        from: f64,
        to: f64,
        limit: usize,
    ) -> Result<Vec<f64>, ContourError> {
        let track = &self.outline.tracks[piece];
        let mut steps = vec![(from, 0.0)];
        let (mut s, mut total) = (from, 0.0);
        let mut size = self.size.at(track.at(s));
        while s < to {
            // The last step ends at `to` and leaves no sliver.
            let step = size / STEPS_PER_SIZE;
            let next = if s + 1.5 * step >= to { to } else { s + step };
            let next_size = self.size.at(track.at(next));
            total += (next - s) * (1.0 / size + 1.0 / next_size) / 2.0;
            (s, size) = (next, next_size);
            steps.push((s, total));
            if total > limit as f64 {
                let nodes = ((to - from) / (s - from) * total) as usize;
                return Err(ContourError::TooLarge { nodes, limit });
            }
        }
        let count = (total - 0.1).ceil().max(1.0) as usize;
        let mut k = 0;
        let place = |n: usize| {
            let wanted = total * n as f64 / count as f64;
            // The last entry is `total`, which exceeds what is wanted.
            while k + 2 < steps.len() && steps[k + 1].1 < wanted {
                k += 1;
            }
            let ((s, a), (next, b)) = (steps[k], steps[k + 1]);
            s + (next - s) * (wanted - a) / (b - a)
        };
        Ok((1..count).map(place).collect())
    }
}
