//! One step of refinement: a circumcentre inserted, or the boundary edge in its way halved.

use std::collections::BTreeSet;

use spade::Triangulation;
use spade::handles::{FixedFaceHandle, FixedVertexHandle, InnerTag};
use stickslip_fem_core::mesh::Point;

use super::delaunay::{crossed, key, plain, position, refused};
use super::{FLAT, Refinement};
use crate::ContourError;
use crate::edges::Segment;
use crate::vector::{circumcircle, distance, dot, least_sine, minus, orient};

/// Cosine of the largest angle, 120°, at which a new node may see a fixed edge (Shewchuk's diametral lens).
const LENS: f64 = -0.5;

/// Shortest distance of a new node from others, in sizes.
const CLOSEST: f64 = 0.1;

/// Shortest half of a boundary edge that is halved for triangles that are only too large, in sizes: edges that have their size stay equally long.
const HALF: f64 = 0.55;

/// Triangles passed on the way to a circumcentre before it counts as hidden.
const WALK: usize = 10_000;

type Face = FixedFaceHandle<InnerTag>;

/// What became of a bad triangle.
pub(super) enum Outcome {
    Changed,
    Blocked,
}

/// Where a walk towards a point ended.
enum Found {
    Face(Face),
    Hidden([usize; 2]),
    Lost,
}

impl Refinement<'_> {
    /// Tries to destroy a triangle, if it still exists.
    pub(super) fn mend(&mut self, triangle: [usize; 3]) -> Result<Outcome, ContourError> {
        let Some(face) = self.face(triangle) else {
            return Ok(Outcome::Changed);
        };
        let corners = self.positions(triangle);
        let (centre, _) = circumcircle(corners);
        if !centre.iter().all(|c| c.is_finite()) {
            return Ok(Outcome::Blocked);
        }
        let least = if least_sine(corners) < FLAT {
            CLOSEST
        } else {
            HALF
        };
        match self.walk(face, centre) {
            Found::Face(face) => {
                let (encroached, nearest) = self.conflicts(face, centre);
                if !encroached.is_empty() {
                    return self.split_any(&encroached, least);
                }
                if nearest < CLOSEST * self.plan.size.at(centre) {
                    return Ok(Outcome::Blocked);
                }
                self.insert(centre, triangle[0])?;
                Ok(Outcome::Changed)
            }
            Found::Hidden(segment) => self.split_any(&[segment], least),
            Found::Lost => Ok(Outcome::Blocked),
        }
    }

    /// The face with these corners.
    fn face(&self, [a, b, c]: [usize; 3]) -> Option<Face> {
        let [from, to] = [a, b].map(FixedVertexHandle::from_index);
        let edge = self.delaunay.get_edge_from_neighbors(from, to)?;
        let apex = edge.opposite_vertex()?;
        let face = edge.face().as_inner()?;
        (apex.index() == c).then(|| face.fix())
    }

    /// Walks from a face straight towards a point.
    fn walk(&self, from: Face, to: Point) -> Found {
        let mut face = self.delaunay.face(from);
        let start = plain(face.center());
        for _ in 0..WALK {
            let leaves = face.adjacent_edges().into_iter().find(|edge| {
                let [p, q] = edge.positions().map(plain);
                orient(p, q, to) < 0.0 && orient(start, to, p) <= 0.0 && orient(start, to, q) >= 0.0
            });
            let Some(edge) = leaves else {
                return Found::Face(face.fix());
            };
            if edge.is_constraint_edge() {
                return Found::Hidden(edge.vertices().map(|vertex| vertex.index()));
            }
            let Some(next) = edge.rev().face().as_inner() else {
                return Found::Lost;
            };
            face = next;
        }
        Found::Lost
    }

    /// Boundary edges with a point in their diametral circles, and the distance of the nearest node, of what the point sees from its
    /// face.
    fn conflicts(&self, face: Face, point: Point) -> (Vec<[usize; 2]>, f64) {
        let (mut seen, mut stack) = (BTreeSet::from([face]), vec![face]);
        let (mut encroached, mut nearest) = (Vec::new(), f64::INFINITY);
        while let Some(face) = stack.pop() {
            let face = self.delaunay.face(face);
            for edge in face.adjacent_edges() {
                let [p, q] = edge.positions().map(plain);
                nearest = nearest.min(distance(p, point));
                if edge.is_constraint_edge() {
                    let ends = edge.vertices().map(|vertex| vertex.index());
                    let fixed = self.segments.get(&key(ends)).is_none_or(Segment::fixed);
                    let (u, v) = (minus(p, point), minus(q, point));
                    let least = if fixed {
                        LENS * dot(u, u).sqrt() * dot(v, v).sqrt()
                    } else {
                        0.0
                    };
                    if dot(u, v) < least {
                        encroached.push(ends);
                    }
                    continue;
                }
                let Some(next) = edge.rev().face().as_inner() else {
                    continue;
                };
                let (centre, radius) = circumcircle(next.positions().map(plain));
                if distance(centre, point) < radius && seen.insert(next.fix()) {
                    stack.push(next.fix());
                }
            }
        }
        (encroached, nearest)
    }

    /// Halves boundary edges that have a node of the body in their diametral circles.
    pub(super) fn split_encroached(&mut self) -> Result<bool, ContourError> {
        let mut encroached: Vec<[usize; 2]> = Vec::new();
        for segment in self.segments.values() {
            let [from, to] = segment.ends.map(FixedVertexHandle::from_index);
            let edge = self.delaunay.get_edge_from_neighbors(from, to);
            let Some(apex) = edge.and_then(|edge| edge.opposite_position()) else {
                continue;
            };
            let [p, q] = [from, to].map(|end| plain(self.delaunay.vertex(end).position()));
            let apex = plain(apex);
            if dot(minus(p, apex), minus(q, apex)) < 0.0 {
                encroached.push(segment.ends);
            }
        }
        let mut changed = false;
        for segment in encroached {
            changed |= matches!(self.split_any(&[segment], CLOSEST)?, Outcome::Changed);
        }
        Ok(changed)
    }

    /// Halves those of some boundary edges that may be, to halves of at least `least` sizes.
    fn split_any(&mut self, segments: &[[usize; 2]], least: f64) -> Result<Outcome, ContourError> {
        let mut outcome = Outcome::Blocked;
        for &ends in segments {
            if self.split(ends, least)? {
                outcome = Outcome::Changed;
            }
        }
        Ok(outcome)
    }

    /// Halves a boundary edge on its true curve; false if it is fixed or already short.
    fn split(&mut self, ends: [usize; 2], least: f64) -> Result<bool, ContourError> {
        let Some(&segment) = self.segments.get(&key(ends)) else {
            return Ok(false);
        };
        let places = segment.ends.map(|end| self.place(end));
        let Some((middle, half, origins)) = segment.origin.halves(self.plan, places) else {
            return Ok(false);
        };
        if half < least * self.plan.size.at(middle) {
            return Ok(false);
        }
        let handles = segment.ends.map(FixedVertexHandle::from_index);
        let edge = self
            .delaunay
            .get_edge_from_neighbors(handles[0], handles[1]);
        let Some(edge) = edge.map(|edge| edge.as_undirected().fix()) else {
            return Ok(false);
        };
        self.delaunay.remove_constraint_edge(edge);
        let node = self.insert(middle, segment.ends[0])?;
        self.segments.remove(&key(ends));
        for (ends, origin) in [[segment.ends[0], node], [node, segment.ends[1]]]
            .into_iter()
            .zip(origins)
        {
            let [a, b] = ends.map(FixedVertexHandle::from_index);
            if self.delaunay.try_add_constraint(a, b).len() != 1 {
                return Err(crossed(self.points()[node]));
            }
            self.segments.insert(key(ends), Segment { ends, origin });
        }
        Ok(true)
    }

    /// Adds a node near node `hint`.
    fn insert(&mut self, point: Point, hint: usize) -> Result<usize, ContourError> {
        let count = self.delaunay.num_vertices();
        if count >= self.limit {
            return Err(ContourError::TooLarge {
                nodes: count + 1,
                limit: self.limit,
            });
        }
        let hint = FixedVertexHandle::from_index(hint);
        let added = self.delaunay.insert_with_hint(position(point), hint);
        let added = added.map_err(refused)?.index();
        if added == count {
            Ok(added)
        } else {
            Err(crossed(point))
        }
    }
}
