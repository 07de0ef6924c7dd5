//! Nodes and edges on the boundary of what is to be triangulated.

use std::borrow::Cow;
use std::collections::BTreeSet;
use std::f64::consts::PI;

use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::curve::Track;
use crate::plan::{FIRST_EDGE, Plan};
use crate::ring::Ring;
use crate::size::SHARP;
use crate::vector::{cross, distance, dot, middle};

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
    /// Part of a mirror.
    Axis {
        /// The coordinate that is 0 on it.
        across: usize,
        /// Whether it may be split.
        open: bool,
    },
}

impl Origin {
    /// Whether it lies on the mirror where coordinate `wanted` is 0.
    pub(crate) fn is_axis(&self, wanted: usize) -> bool {
        matches!(self, Self::Axis { across, .. } if *across == wanted)
    }

    /// The middle of an edge that may be split, half its length `[length]`, and where its halves come from; `ends` are its ends.
    pub(crate) fn halves(self, plan: &Plan, ends: [Point; 2]) -> Option<(Point, f64, [Self; 2])> {
        match self {
            Self::Piece {
                piece,
                from,
                to,
                open: true,
            } => {
                let half = f64::midpoint(from, to);
                let origins = [self.part(from, half, true), self.part(half, to, true)];
                Some((
                    plan.outline.tracks[piece].at(half),
                    (to - from) / 2.0,
                    origins,
                ))
            }
            Self::Axis { open: true, .. } => Some((
                middle(ends[0], ends[1]),
                distance(ends[0], ends[1]) / 2.0,
                [self; 2],
            )),
            _ => None,
        }
    }

    /// Part of the same, between two arc lengths of its track `[length]`.
    fn part(self, from: f64, to: f64, open: bool) -> Self {
        match self {
            Self::Piece { piece, .. } => Self::Piece {
                piece,
                from,
                to,
                open,
            },
            Self::Axis { across, .. } => Self::Axis { across, open },
            Self::Ring { .. } => self,
        }
    }
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
        !matches!(
            self.origin,
            Origin::Piece { open: true, .. } | Origin::Axis { open: true, .. }
        )
    }
}

/// Part of the boundary before it is divided, with the body on its left.
#[derive(Clone, Debug)]
pub(crate) struct Link {
    pub(crate) ends: [Point; 2],
    pub(crate) origin: Origin,
}

impl Link {
    /// Closed chains around the whole of a body.
    pub(crate) fn loops(plan: &Plan) -> Vec<Vec<Self>> {
        let piece = |piece: usize| {
            let track = &plan.outline.tracks[piece];
            Self {
                ends: [track.from, track.to],
                origin: Origin::Piece {
                    piece,
                    from: 0.0,
                    to: track.length(),
                    open: true,
                },
            }
        };
        let around = |(ring, own): (usize, &Ring)| {
            let row = own.outer();
            let rays = (0..row.len()).rev();
            rays.map(|ray| Self {
                ends: [row[(ray + 1) % row.len()], row[ray]],
                origin: Origin::Ring { ring, ray },
            })
            .collect()
        };
        let pieces = plan.outline.loops.iter();
        let pieces = pieces.map(|own| own.clone().map(piece).collect());
        pieces
            .chain(plan.rings.iter().enumerate().map(around))
            .collect()
    }

    /// Straight along a mirror.
    pub(crate) fn axis(ends: [Point; 2], across: usize) -> Self {
        let origin = Origin::Axis { across, open: true };
        Self { ends, origin }
    }

    /// Its track, and where on it it begins and ends `[length]`.
    pub(crate) fn track<'a>(&self, plan: &'a Plan) -> (Cow<'a, Track>, [f64; 2]) {
        if let Origin::Piece {
            piece, from, to, ..
        } = self.origin
        {
            (Cow::Borrowed(&plan.outline.tracks[piece]), [from, to])
        } else {
            let track = Track::line(self.ends[0], self.ends[1]);
            let length = track.length();
            (Cow::Owned(track), [0.0, length])
        }
    }

    /// Its parts between `places` on its track, ascending inside it `[length]`.
    pub(crate) fn divided(&self, plan: &Plan, places: &[f64]) -> Vec<Self> {
        let (track, [from, to]) = self.track(plan);
        let all: Vec<f64> = [from]
            .into_iter()
            .chain(places.iter().copied())
            .chain([to])
            .collect();
        let last = all.len() - 2;
        let pairs = all.windows(2).enumerate();
        pairs
            .map(|(k, pair)| Self {
                ends: [
                    if k == 0 {
                        self.ends[0]
                    } else {
                        track.at(pair[0])
                    },
                    if k == last {
                        self.ends[1]
                    } else {
                        track.at(pair[1])
                    },
                ],
                origin: self.origin.part(pair[0], pair[1], true),
            })
            .collect()
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
    /// Divides closed chains by the size function; at most `limit` nodes.
    pub(crate) fn new(
        plan: &Plan,
        chains: &[Vec<Link>],
        limit: usize,
    ) -> Result<Self, ContourError> {
        let mut boundary = Self {
            points: Vec::new(),
            segments: Vec::new(),
            acute: BTreeSet::new(),
        };
        for links in chains {
            let first = boundary.points.len();
            let count = links.len();
            let corner = |k: usize| plan.corner(&links[(k + count - 1) % count], &links[k % count]);
            for k in 0..count {
                boundary.link(plan, &links[k], [corner(k), corner(k + 1)], limit)?;
            }
            // The last node of the last link is the first of the first.
            if let Some(last) = boundary.segments.last_mut() {
                last.ends[1] = first;
            }
        }
        Ok(boundary)
    }

    /// Adds the nodes of a link without its end; `corners` are the first edges that acute corners at its ends ask for.
    fn link(
        &mut self,
        plan: &Plan,
        link: &Link,
        corners: [Option<f64>; 2],
        limit: usize,
    ) -> Result<(), ContourError> {
        if corners[0].is_some() {
            self.acute.insert(self.points.len());
        }
        let node = self.points.len();
        if matches!(link.origin, Origin::Ring { .. }) {
            self.points.push(link.ends[0]);
            self.segments.push(Segment {
                ends: [node, node + 1],
                origin: link.origin,
            });
            return Ok(());
        }
        let (track, [begin, end]) = link.track(plan);
        let first_edge = |edge: Option<f64>, at: f64, is_back: bool| {
            edge.map_or(0.0, |chord| track.chord_to_length(chord, at, is_back))
        };
        let first = first_edge(corners[0], begin, false);
        let last = first_edge(corners[1], end, true);
        let (from, to) = (begin + first, end - last);
        let mut places = vec![from];
        places.extend(plan.divided(&track, [from, to], limit)?);
        places.push(to);
        let closed = [first > 0.0, last > 0.0];
        if closed[0] {
            places.insert(0, begin);
        }
        if closed[1] {
            places.push(end);
        }
        let edges = places.len() - 1;
        for (n, pair) in places.windows(2).enumerate() {
            let at = if n == 0 {
                link.ends[0]
            } else {
                track.at(pair[0])
            };
            self.points.push(at);
            let open = !(closed[0] && n == 0 || closed[1] && n + 1 == edges);
            self.segments.push(Segment {
                ends: [node + n, node + n + 1],
                origin: link.origin.part(pair[0], pair[1], open),
            });
        }
        Ok(())
    }
}

impl Plan {
    /// Length of the first edges on both sides of the corner between two links, if it is acute `[length]`.
    fn corner(&self, before: &Link, after: &Link) -> Option<f64> {
        if let (Origin::Piece { .. }, Origin::Piece { piece, from, .. }) =
            (before.origin, after.origin)
        {
            return self.first_edges[piece].filter(|_| from == 0.0);
        }
        if [before, after]
            .iter()
            .any(|link| matches!(link.origin, Origin::Ring { .. }))
        {
            return None;
        }
        let ((a, [_, end]), (b, [begin, _])) = (before.track(self), after.track(self));
        let (arrives, leaves) = (a.tangent(end), b.tangent(begin));
        let angle = PI - cross(arrives, leaves).atan2(dot(arrives, leaves));
        let shorter = [before, after].map(|link| {
            let (_, [from, to]) = link.track(self);
            to - from
        });
        let longest = FIRST_EDGE * shorter[0].min(shorter[1]);
        (angle < SHARP).then(|| self.size.at(after.ends[0]).min(longest))
    }

    /// Arc lengths strictly between two on a track, equally spaced in ∫ ds/h.
    fn divided(
        &self,
        track: &Track,
        [from, to]: [f64; 2],
        limit: usize,
    ) -> Result<Vec<f64>, ContourError> {
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
