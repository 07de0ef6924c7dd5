//! Constrained Delaunay refinement by circumcentres.

mod delaunay;
mod mend;
mod rounds;

use std::collections::{BTreeMap, BTreeSet, HashSet};

use spade::Triangulation;
use spade::handles::FixedVertexHandle;
use stickslip_fem_core::mesh::Point;

use crate::ContourError;
use crate::edges::{Boundary, Segment};
use crate::plan::Plan;
use crate::vector::least_sine;

use delaunay::{Delaunay, key, plain, triangulated};

/// Sine of the least angle asked for, 28°.
const FLAT: f64 = 0.469;

/// Sine of the least angle accepted where fixed edges force it, 5°.
const FLATTEST: f64 = 0.0872;

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

/// Nodes, counter-clockwise triangles, and boundary edges with the body on their left.
pub(crate) struct Triangles {
    pub(crate) points: Vec<Point>,
    pub(crate) cells: Vec<[usize; 3]>,
    pub(crate) segments: Vec<Segment>,
}

/// What a triangulation can be made from again.
pub(crate) struct State {
    /// Sine of the least angle.
    pub(crate) least_sine: f64,
    points: Vec<Point>,
    segments: BTreeMap<[usize; 2], Segment>,
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

    /// What the mesh is made from.
    pub(crate) fn finished(&self) -> Triangles {
        Triangles {
            points: self.points(),
            cells: self.triangles(),
            segments: self.segments().copied().collect(),
        }
    }

    fn place(&self, node: usize) -> Point {
        plain(
            self.delaunay
                .vertex(FixedVertexHandle::from_index(node))
                .position(),
        )
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

    fn positions(&self, triangle: [usize; 3]) -> [Point; 3] {
        triangle.map(|node| self.place(node))
    }
}
