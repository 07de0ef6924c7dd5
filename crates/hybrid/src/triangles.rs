//! Delaunay triangles of measured places, and linear interpolation on them.

use spade::handles::FixedVertexHandle;
use spade::{
    DelaunayTriangulation, HasPosition, HierarchyHintGenerator, Point2, PositionInTriangulation,
    Triangulation,
};
use stickslip_fem_core::mesh::Point;
use thiserror::Error;

use crate::order_statistics::median;

/// Distance from the hull, in units of the data's extent, that is rounding.
const SLACK: f64 = 1e-9;

/// Why places cannot be triangulated.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum TriangulationError {
    /// No place is valid.
    #[error("no place is valid")]
    NoPlaces,
    /// The larger extent of the places along x or y `[length]`: 0 where all are one, infinite where they lie too far apart.
    #[error("the extent of the places is {0}; it must be finite and more than 0")]
    Extent(f64),
    /// Places coincide.
    #[error("only {distinct} of {count} places are distinct")]
    Repeated {
        /// Distinct places.
        distinct: usize,
        /// All places.
        count: usize,
    },
    /// The places span no plane.
    #[error("all {0} places lie on one line")]
    OnOneLine(usize),
    /// The library for triangulations refuses a place, in its own words.
    #[error("{0}")]
    Refused(String),
}

/// Why no triangle interpolates at a place.
pub(crate) enum NoTriangle {
    /// It lies outside the hull of the places.
    Outside,
    /// The triangle around it is a gap in the data.
    Gap { side: f64, longest: f64 },
}

struct Vertex {
    position: Point2<f64>,
    index: usize,
}

impl HasPosition for Vertex {
    type Scalar = f64;

    fn position(&self) -> Point2<f64> {
        self.position
    }
}

/// A Delaunay triangulation of some of a list of places.
pub(crate) struct Triangles<'a> {
    places: &'a [Point],
    origin: Point,
    extent: f64,
    mesh: DelaunayTriangulation<Vertex, (), (), (), HierarchyHintGenerator<f64>>,
}

impl<'a> Triangles<'a> {
    /// Triangulates the places that are `valid`.
    pub(crate) fn new(places: &'a [Point], valid: &[bool]) -> Result<Self, TriangulationError> {
        let chosen: Vec<usize> = (0..places.len()).filter(|&k| valid[k]).collect();
        let first = *chosen.first().ok_or(TriangulationError::NoPlaces)?;
        let (mut low, mut high) = (places[first], places[first]);
        for &k in &chosen {
            for c in 0..2 {
                low[c] = low[c].min(places[k][c]);
                high[c] = high[c].max(places[k][c]);
            }
        }
        let extent = (high[0] - low[0]).max(high[1] - low[1]);
        if !(extent.is_finite() && extent > 0.0) {
            return Err(TriangulationError::Extent(extent));
        }
        let frame = |place| scaled(place, low, extent);
        let vertices = chosen
            .iter()
            .map(|&index| Vertex {
                position: frame(places[index]),
                index,
            })
            .collect();
        let mesh = DelaunayTriangulation::bulk_load(vertices)
            .map_err(|cause| TriangulationError::Refused(cause.to_string()))?;
        let triangles = Self {
            places,
            origin: low,
            extent,
            mesh,
        };
        if triangles.mesh.num_vertices() != chosen.len() {
            Err(TriangulationError::Repeated {
                distinct: triangles.mesh.num_vertices(),
                count: chosen.len(),
            })
        } else if triangles.mesh.num_inner_faces() == 0 {
            Err(TriangulationError::OnOneLine(chosen.len()))
        } else {
            Ok(triangles)
        }
    }

    /// Indices and weights that interpolate at `place`, from a triangle whose sides are at most `longest`.
    pub(crate) fn weights(
        &self,
        place: Point,
        longest: f64,
    ) -> Result<Vec<(usize, f64)>, NoTriangle> {
        let position = scaled(place, self.origin, self.extent);
        if [position.x, position.y]
            .iter()
            .any(|x| !(-SLACK..=1.0 + SLACK).contains(x))
        {
            return Err(NoTriangle::Outside);
        }
        let corners: Vec<(FixedVertexHandle, f64)> = match self.mesh.locate(position) {
            PositionInTriangulation::OnVertex(vertex) => vec![(vertex, 1.0)],
            PositionInTriangulation::OnEdge(edge) => {
                let edge = self.mesh.directed_edge(edge);
                let t = edge.project_point(position).relative_position();
                let [from, to] = edge.vertices().map(|vertex| vertex.fix());
                vec![(from, 1.0 - t), (to, t)]
            }
            PositionInTriangulation::OnFace(face) => {
                let face = self.mesh.face(face);
                let weights = face.barycentric_interpolation(position);
                face.vertices()
                    .map(|vertex| vertex.fix())
                    .into_iter()
                    .zip(weights)
                    .collect()
            }
            PositionInTriangulation::OutsideOfConvexHull(edge) => {
                let edge = self.mesh.directed_edge(edge);
                [edge, edge.next(), edge.prev()]
                    .into_iter()
                    .find_map(|edge| {
                        let t = edge.project_point(position).relative_position();
                        let near = edge.distance_2(position) <= SLACK * SLACK;
                        let [from, to] = edge.vertices().map(|vertex| vertex.fix());
                        let t = t.clamp(0.0, 1.0);
                        near.then(|| vec![(from, 1.0 - t), (to, t)])
                    })
                    .ok_or(NoTriangle::Outside)?
            }
            PositionInTriangulation::NoTriangulation => return Err(NoTriangle::Outside),
        };
        let stencil: Vec<(usize, f64)> = corners
            .into_iter()
            .map(|(vertex, weight)| (self.mesh.vertex(vertex).data().index, weight))
            .collect();
        let side = self.longest_side(&stencil);
        if side > longest {
            return Err(NoTriangle::Gap { side, longest });
        }
        Ok(stencil)
    }

    /// Median of the longest sides of all triangles.
    pub(crate) fn typical_side(&self) -> f64 {
        let faces = self.mesh.inner_faces();
        let corners = faces.map(|face| {
            let corners = face.vertices().map(|vertex| (vertex.data().index, 0.0));
            self.longest_side(&corners)
        });
        // There is at least one triangle.
        median(corners.collect()).unwrap_or(f64::INFINITY)
    }

    fn longest_side(&self, corners: &[(usize, f64)]) -> f64 {
        let mut longest: f64 = 0.0;
        for (n, &(a, _)) in corners.iter().enumerate() {
            for &(b, _) in &corners[n + 1..] {
                let [p, q] = [self.places[a], self.places[b]];
                longest = longest.max((p[0] - q[0]).hypot(p[1] - q[1]));
            }
        }
        longest
    }
}

/// A place in the frame of the data's extent; what is too small for the exact predicates is 0 there.
fn scaled(place: Point, origin: Point, extent: f64) -> Point2<f64> {
    let [x, y] = [0, 1].map(|c| {
        let x = (place[c] - origin[c]) / extent;
        if x.abs() < spade::MIN_ALLOWED_VALUE {
            0.0
        } else {
            x
        }
    });
    Point2::new(x, y)
}
