//! Constrained Delaunay refinement by circumcentres.
//!
//! A triangle is bad if its circumradius exceeds [`ROUGH`] h or the sine of its least angle is below [`FLAT`]. Its circumcentre becomes a node unless
//! a boundary edge hides it or has it in its diametral circle; such an edge is halved on its true curve, unless it is fixed.

use std::collections::{BTreeMap, BTreeSet, HashSet};

use spade::handles::{FixedFaceHandle, FixedVertexHandle, InnerTag};
use spade::{ConstrainedDelaunayTriangulation, HierarchyHintGenerator, Point2, Triangulation};
use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::edges::{Boundary, Origin, Segment};
use crate::plan::Plan;
use crate::vector::{circumcircle, distance, dot, least_sine, minus, orient};

/// Largest circumradius in sizes; equilateral cells of side h have 0.577.
const ROUGH: f64 = 0.65;

/// Sine of the least angle asked for, 28°.
const FLAT: f64 = 0.469;

/// Cosine of the largest angle, 120°, at which a new node may see a fixed edge (Shewchuk's diametral lens).
const LENS: f64 = -0.5;

/// Sine of the least angle accepted where fixed edges force it, 5°.
const FLATTEST: f64 = 0.0872;

/// Shortest distance of a new node from others, in sizes.
const CLOSEST: f64 = 0.1;

/// Rounds before refinement is given up.
const ROUNDS: usize = 200;

/// Triangles passed on the way to a circumcentre before it counts as hidden.
const WALK: usize = 10_000;

type Delaunay =
    ConstrainedDelaunayTriangulation<Point2<f64>, (), (), (), HierarchyHintGenerator<f64>>;

type Face = FixedFaceHandle<InnerTag>;

/// A triangulation under refinement. Nodes are numbered as they were added.
pub(crate) struct Refinement<'a> {
    plan: &'a Plan,
    limit: usize,
    delaunay: Delaunay,
    segments: BTreeMap<[usize; 2], Segment>,
    acute: BTreeSet<usize>,
    /// Triangles found good where their nodes are now; only looked up, so that its order does not matter.
    good: HashSet<[usize; 3]>,
}

/// What a triangulation can be made from again.
pub(crate) struct State {
    /// Sine of the least angle.
    pub(crate) least_sine: f64,
    points: Vec<Point>,
    segments: BTreeMap<[usize; 2], Segment>,
}

/// What became of a bad triangle.
enum Outcome {
    Changed,
    Blocked,
}

/// Where a walk towards a point ended.
enum Found {
    Face(Face),
    Hidden([usize; 2]),
    Lost,
}

impl<'a> Refinement<'a> {
    /// The triangulation of a boundary, to have at most `limit` nodes.
    pub(crate) fn new(
        plan: &'a Plan,
        boundary: Boundary,
        limit: usize,
    ) -> Result<Self, ContourError> {
        let segments = boundary.segments.iter().map(|s| (key(s.ends), *s));
        let segments = segments.collect();
        let delaunay = triangulated(&boundary.points, &segments)?;
        Ok(Self {
            plan,
            limit,
            delaunay,
            segments,
            acute: boundary.acute,
            good: HashSet::new(),
        })
    }

    /// Positions of all nodes.
    pub(crate) fn points(&self) -> Vec<Point> {
        let vertices = self.delaunay.vertices();
        vertices.map(|vertex| plain(vertex.position())).collect()
    }

    /// Nodes and boundary edges, with the shape of the worst cell away from acute corners.
    pub(crate) fn state(&self) -> State {
        let triangles = self.triangles().into_iter();
        let shapes = triangles
            .filter(|t| !self.at_acute_corner(*t))
            .map(|t| least_sine(self.positions(t)));
        State {
            least_sine: shapes.fold(f64::INFINITY, f64::min),
            points: self.points(),
            segments: self.segments.clone(),
        }
    }

    /// Goes back to a state.
    pub(crate) fn restore(&mut self, state: State) -> Result<(), ContourError> {
        self.segments = state.segments;
        self.moved(&state.points)
    }

    /// Boundary edges, sorted.
    pub(crate) fn segments(&self) -> impl Iterator<Item = &Segment> {
        self.segments.values()
    }

    /// Triangulates anew with the nodes moved to `points`.
    pub(crate) fn moved(&mut self, points: &[Point]) -> Result<(), ContourError> {
        self.delaunay = triangulated(points, &self.segments)?;
        self.good.clear();
        Ok(())
    }

    /// Inserts nodes until no triangle is bad that could be mended.
    pub(crate) fn refine(&mut self) -> Result<(), ContourError> {
        for _ in 0..ROUNDS {
            let bad = self.bad();
            let mut changed = self.split_encroached()?;
            for triangle in &bad {
                changed |= matches!(self.mend(*triangle)?, Outcome::Changed);
            }
            if !changed {
                return Ok(());
            }
        }
        let bad = self.bad();
        Err(self.incomplete(&bad))
    }

    /// Refuses cells that fixed edges made flatter than [`FLATTEST`].
    pub(crate) fn accepted(&self) -> Result<(), ContourError> {
        let triangles = self.triangles().into_iter();
        let flat =
            |t: &[usize; 3]| !self.at_acute_corner(*t) && least_sine(self.positions(*t)) < FLATTEST;
        let flat: Vec<[usize; 3]> = triangles.filter(flat).collect();
        if flat.is_empty() {
            Ok(())
        } else {
            Err(self.incomplete(&flat))
        }
    }

    /// The error of cells that stayed bad.
    fn incomplete(&self, bad: &[[usize; 3]]) -> ContourError {
        let worst = bad.iter().map(|t| self.positions(*t));
        let worst = worst.min_by(|a, b| least_sine(*a).total_cmp(&least_sine(*b)));
        let worst = worst.unwrap_or_default();
        ContourError::Incomplete {
            cells: bad.len(),
            angle: least_sine(worst).asin(),
            at: worst[0],
        }
    }

    fn at_acute_corner(&self, triangle: [usize; 3]) -> bool {
        triangle.iter().any(|node| self.acute.contains(node))
    }

    /// Triangles of the body, each from its smallest node counter-clockwise, sorted.
    pub(crate) fn triangles(&self) -> Vec<[usize; 3]> {
        let inside = self.inside();
        let faces = self.delaunay.inner_faces();
        let faces = faces.filter(|face| inside[face.index()]);
        let mut triangles: Vec<[usize; 3]> = faces
            .map(|face| {
                let [a, b, c] = face.vertices().map(|vertex| vertex.index());
                match a.min(b).min(c) {
                    least if least == a => [a, b, c],
                    least if least == b => [b, c, a],
                    _ => [c, a, b],
                }
            })
            .collect();
        triangles.sort_unstable();
        triangles
    }

    /// Which faces, by index, lie in the body: an odd number of boundary edges away from outside.
    fn inside(&self) -> Vec<bool> {
        let mut level: Vec<Option<bool>> = vec![None; self.delaunay.num_all_faces()];
        let mut stack = Vec::new();
        for edge in self.delaunay.convex_hull() {
            // One of the two is outside and is passed over.
            stack.push((edge.face(), edge.is_constraint_edge()));
            stack.push((edge.rev().face(), edge.is_constraint_edge()));
        }
        while let Some((face, inside)) = stack.pop() {
            let Some(inner) = face.as_inner() else {
                continue;
            };
            if level[face.index()].is_some() {
                continue;
            }
            level[face.index()] = Some(inside);
            for edge in inner.adjacent_edges() {
                stack.push((edge.rev().face(), inside != edge.is_constraint_edge()));
            }
        }
        level.into_iter().map(|l| l == Some(true)).collect()
    }

    /// Bad triangles, the worst first.
    fn bad(&mut self) -> Vec<[usize; 3]> {
        let mut bad = Vec::new();
        for triangle in self.triangles() {
            if self.good.contains(&triangle) {
                continue;
            }
            match self.badness(triangle) {
                Some(badness) => bad.push((badness, triangle)),
                None => {
                    self.good.insert(triangle);
                }
            }
        }
        bad.sort_by(|a: &(f64, _), b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
        bad.into_iter().map(|(_, triangle)| triangle).collect()
    }

    /// How bad a triangle is, if it is.
    fn badness(&self, triangle: [usize; 3]) -> Option<f64> {
        let corners = self.positions(triangle);
        let (_, radius) = circumcircle(corners);
        let middle = [0, 1].map(|c| corners.iter().map(|p| p[c]).sum::<f64>() / 3.0);
        let size = radius / (ROUGH * self.plan.size.at(middle));
        let shape = FLAT / least_sine(corners);
        let worst = if self.at_acute_corner(triangle) {
            size
        } else {
            size.max(shape)
        };
        (worst > 1.0).then_some(worst)
    }

    /// Tries to destroy a triangle, if it still exists.
    fn mend(&mut self, triangle: [usize; 3]) -> Result<Outcome, ContourError> {
        let Some(face) = self.face(triangle) else {
            return Ok(Outcome::Changed);
        };
        let corners = self.positions(triangle);
        let (centre, _) = circumcircle(corners);
        if !centre.iter().all(|c| c.is_finite()) {
            return Ok(Outcome::Blocked);
        }
        match self.walk(face, centre) {
            Found::Face(face) => {
                let (encroached, nearest) = self.conflicts(face, centre);
                if !encroached.is_empty() {
                    return self.split_any(&encroached);
                }
                if nearest < CLOSEST * self.plan.size.at(centre) {
                    return Ok(Outcome::Blocked);
                }
                self.insert(centre, triangle[0])?;
                Ok(Outcome::Changed)
            }
            Found::Hidden(segment) => self.split_any(&[segment]),
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
    fn split_encroached(&mut self) -> Result<bool, ContourError> {
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
            changed |= matches!(self.split_any(&[segment])?, Outcome::Changed);
        }
        Ok(changed)
    }

    /// Halves those of some boundary edges that may be.
    fn split_any(&mut self, segments: &[[usize; 2]]) -> Result<Outcome, ContourError> {
        let mut outcome = Outcome::Blocked;
        for &ends in segments {
            if self.split(ends)? {
                outcome = Outcome::Changed;
            }
        }
        Ok(outcome)
    }

    /// Halves a boundary edge on its true curve; false if it is fixed or already short.
    fn split(&mut self, ends: [usize; 2]) -> Result<bool, ContourError> {
        let Some(&segment) = self.segments.get(&key(ends)) else {
            return Ok(false);
        };
        let Origin::Piece {
            piece,
            from,
            to,
            open: true,
        } = segment.origin
        else {
            return Ok(false);
        };
        let half = f64::midpoint(from, to);
        let middle = self.plan.outline.tracks[piece].at(half);
        if (to - from) / 2.0 < CLOSEST * self.plan.size.at(middle) {
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
        for (ends, from, to) in [
            ([segment.ends[0], node], from, half),
            ([node, segment.ends[1]], half, to),
        ] {
            let origin = Origin::Piece {
                piece,
                from,
                to,
                open: true,
            };
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

    fn positions(&self, triangle: [usize; 3]) -> [Point; 3] {
        triangle
            .map(FixedVertexHandle::from_index)
            .map(|node| plain(self.delaunay.vertex(node).position()))
    }
}

/// The constrained Delaunay triangulation of points, numbered as they come.
fn triangulated(
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

fn refused(error: spade::InsertionError) -> ContourError {
    ContourError::Triangulation {
        reason: error.to_string(),
    }
}

fn crossed(at: Point) -> ContourError {
    ContourError::Triangulation {
        reason: format!(
            "boundary edges near ({:.6}, {:.6}) coincide or cross; use a finer spacing there",
            at[0], at[1]
        ),
    }
}

fn key([a, b]: [usize; 2]) -> [usize; 2] {
    [a.min(b), a.max(b)]
}

fn plain(position: Point2<f64>) -> Point {
    [position.x, position.y]
}

/// The position of a node; what is too small for the exact predicates is 0 there.
fn position(point: Point) -> Point2<f64> {
    let [x, y] = point.map(|c| {
        if c.abs() < spade::MIN_ALLOWED_VALUE {
            0.0
        } else {
            c
        }
    });
    Point2::new(x, y)
}
