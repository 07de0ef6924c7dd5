//! What a shape brings: its edges and points, its extent and symmetry, its mesh, and how it is described.

use std::borrow::Cow;
use std::f64::consts::PI;
use std::fmt;
use std::io;
use std::path::Path;

use stickslip_fem_core::generate::{Extent, Generate, GenerateError};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use thiserror::Error;

use super::Shape;
use super::curve::Curve;
use super::note::FileNote;
use crate::units::{Length, Quantity};

/// A circle that was fitted to the corner nodes of an edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircleFit {
    /// Radius of the circle of least squares `[mm]`.
    pub fitted: f64,
    /// How far corner nodes are from it at most `[mm]`.
    pub scatter: f64,
    /// The radius that is given instead `[mm]`.
    pub given: Option<f64>,
}

impl CircleFit {
    /// Whether a `length` `[mm]` counts beside a `clearance` or an overlap `[mm]` of this circle: as more than a twentieth of it, and than rounding.
    pub fn counts(&self, length: f64, clearance: f64) -> bool {
        length > f64::max(0.05 * clearance.abs(), 1e-12 * self.fitted)
    }
}

/// A body's shape. Coordinates are those of the body, whose centre stands where [`placement`](crate::placement) puts it; all
/// lengths in `[mm]`.
pub trait Outline: fmt::Debug {
    /// Name in scenes, below `shape`.
    fn name(&self) -> &'static str;

    /// Its edges, in the order in which messages list them.
    fn edges(&self) -> Vec<Edge>;

    /// Its named points that are no edges, with their places `[mm]`.
    fn points(&self) -> Vec<(Cow<'static, str>, Point)> {
        Vec::new()
    }

    /// Its named areas, whose mean displacement a support can hold.
    fn areas(&self) -> &'static [&'static str] {
        &[]
    }

    /// The smallest and the largest x and y of its points `[mm]`.
    fn bounds(&self) -> [Point; 2];

    /// The coordinate that changes sign between its two mirror halves, 0 for x and 1 for y; `None` if it is modelled whole. The half on
    /// the positive side is meshed.
    fn mirror(&self) -> Option<usize>;

    /// The keys of mesh settings that divide it, beside `element`; others are refused.
    fn mesh_keys(&self) -> &'static [&'static str];

    /// Whether its mesh is divided by angles about its centre, and otherwise by lengths.
    fn is_round(&self) -> bool {
        self.mesh_keys().contains(&"angles")
    }

    /// What of it stands in no key of the scene but in a file, as a checksum.
    fn digest(&self) -> Option<&str> {
        None
    }

    /// Corners at which the body reaches over more than a half turn (of an outline more than 180.5°, of a mesh what its chords do not explain), each with its inner
    /// angle `[rad]`, in the coordinates of the shape.
    fn reentrant_corners(&self) -> Vec<(Point, f64)> {
        Vec::new()
    }

    /// Number of nodes of the point `name`: more than one in a mesh from a file.
    fn nodes_of_point(&self, _name: &str) -> usize {
        1
    }

    /// By how much the closed edge `edge` is no circle, where it is nearly one.
    fn why_not_round(&self, _edge: &str) -> Option<&str> {
        None
    }

    /// How the circle `edge` was fitted to nodes that are off it.
    fn fit(&self, _edge: &str) -> Option<CircleFit> {
        None
    }

    /// What a reader must know of its file.
    fn notes(&self) -> &[FileNote] {
        &[]
    }

    /// Whether it brings a mesh that no setting divides.
    fn has_own_mesh(&self) -> bool {
        self.mesh_keys().is_empty()
    }

    /// Whether it is divided into triangles whatever cells are asked for, which have any shape and corners anywhere.
    fn is_general(&self) -> bool {
        let cells = self.cells(ElementKind::Q8);
        !self.has_own_mesh() && cells.is_some_and(|kind| kind.corners() == 3)
    }

    /// Whether one length says all of its size, so that its plane compliance is that of any other size.
    fn is_similar(&self) -> bool {
        false
    }

    /// Up to where its contact edge is divided equally `[rad or mm]`, where the scene says `given`; `None` for all of it.
    fn fine_to(&self, given: Option<f64>) -> Option<f64> {
        given
    }

    /// By how many times the smallest cells along its edges are smaller than the largest ones `[1]`, where the scene says so.
    fn refinement(&self) -> f64 {
        1.0
    }

    /// The generator of its mesh.
    ///
    /// # Errors
    /// [`DivisionError`] for a division that does not suit it.
    fn meshing(&self, divided: &Divided<'_>) -> Result<Meshing, DivisionError>;

    /// Whether scenes say themselves where its points are.
    fn is_placed(&self) -> bool {
        false
    }

    /// The same body with its points moved by `by` `[mm]`; `None` of one that is not [placed](Self::is_placed), or that no number can move so far.
    fn moved(&self, _by: Point) -> Option<Shape> {
        None
    }

    /// Whether it is the same however it is turned about its origin.
    fn turns_freely(&self) -> bool {
        false
    }

    /// By what angle about its origin the scene turns it `[rad]`.
    fn turn(&self) -> f64 {
        0.0
    }

    /// The same body turned by `angle` `[rad]` about its origin; `None` of one that is not [placed](Self::is_placed).
    fn turned(&self, _angle: f64) -> Option<Shape> {
        None
    }

    /// One line about it, with lengths `[mm]` as `show` writes them.
    fn describe(&self, show: &dyn Fn(f64) -> String) -> String;

    /// Whether `name` is that of an area, and of no edge or point that a file calls the same.
    fn is_area(&self, name: &str) -> bool {
        self.areas().contains(&name)
            && self.edge(name).is_none()
            && self.points().iter().all(|(own, _)| own != name)
    }

    /// The edge called `name`.
    fn edge(&self, name: &str) -> Option<Edge> {
        self.edges().into_iter().find(|edge| edge.name == name)
    }

    /// The first edge with this role.
    fn edge_with(&self, role: Role) -> Option<Edge> {
        self.edges().into_iter().find(|edge| edge.role == role)
    }

    /// Its hole, if it has exactly one.
    fn only_hole(&self) -> Option<Edge> {
        let edges = self.edges().into_iter();
        let mut holes = edges.filter(|edge| edge.role == Role::Hole);
        holes.next().filter(|_| holes.next().is_none())
    }

    /// The kind of its cells where the scene asks for `asked`; `None` where it has none of that order.
    fn cells(&self, asked: ElementKind) -> Option<ElementKind> {
        Some(asked)
    }

    /// Radius `[mm]` of the closed circle called `name`.
    fn circle(&self, name: &str) -> Option<f64> {
        self.edge(name)?.circle()
    }
}

/// The keys that divide circles.
pub(super) const CIRCLE_KEYS: &[&str] = &["spacing", "angles", "fine_to", "coarse_spacing"];

/// A named edge.
#[derive(Debug, Clone, PartialEq)]
pub struct Edge {
    /// Name of its node and edge sets.
    pub name: Cow<'static, str>,
    /// Where it lies exactly.
    pub curve: Curve,
    /// Its part in contacts.
    pub role: Role,
    /// Key of the size that places it, below `shape`: of a circle its radius, of a straight edge its distance from the centre.
    pub size: Option<Cow<'static, str>>,
}

/// The part of an edge in contacts, or in the size of a plate around a hole. A hole takes a rim; a cap takes a surface, and the two bodies
/// are divided together.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Role {
    /// None.
    Free,
    /// A circle with the body around it.
    Hole,
    /// A circle with the body inside.
    Rim,
    /// An arc that touches the origin from above.
    Cap,
    /// The line y = 0 with the body below.
    Surface,
    /// The straight edge at +x, where a plate's end distance is measured from the hole.
    End,
    /// A straight edge along x, half of a plate's width from the hole.
    Side,
}

/// Two edges that can touch.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Touch {
    /// A circle in a hole.
    Circles {
        /// Radii of the hole and of the circle `[mm]`.
        radii: [f64; 2],
    },
    /// A cap on a surface.
    Cylinder {
        /// Radius of the cap `[mm]`.
        radius: f64,
    },
    /// Open edges of known curves, which stand where their bodies' coordinates say.
    Open,
}

impl Edge {
    /// A closed circle about the body's centre, whose radius has the key `size`.
    pub(super) fn circular(
        name: &'static str,
        role: Role,
        radius: f64,
        size: &'static str,
    ) -> Self {
        Self {
            name: name.into(),
            curve: Curve::Circle {
                centre: [0.0; 2],
                radius,
            },
            role,
            size: Some(size.into()),
        }
    }

    /// A straight edge without a part in contacts or sizes.
    pub(super) fn straight(name: &'static str, ends: [Point; 2]) -> Self {
        Self {
            name: name.into(),
            curve: Curve::Segment { ends },
            role: Role::Free,
            size: None,
        }
    }

    /// The same edge with a part in contacts or sizes.
    pub(super) fn with_role(self, role: Role) -> Self {
        Self { role, ..self }
    }

    /// The same edge with the key of its distance from the centre.
    pub(super) fn placed_by(self, size: &'static str) -> Self {
        let size = Some(size.into());
        Self { size, ..self }
    }

    /// Radius `[mm]` of a closed circle; `None` of any other curve.
    pub fn circle(&self) -> Option<f64> {
        match self.curve {
            Curve::Circle { radius, .. } => Some(radius),
            Curve::Arc { .. } | Curve::Segment { .. } | Curve::Chain { .. } => None,
        }
    }

    /// The coordinate `[mm]` along `axis` (0 for x, 1 for y) that all points of a straight edge share.
    pub fn level(&self, axis: usize) -> Option<f64> {
        match self.curve {
            Curve::Segment { ends: [from, to] } if from[axis] == to[axis] => Some(from[axis]),
            _ => None,
        }
    }

    /// The side of the line `axis` = 0 (0 for x, 1 for y) on which the whole edge lies `[1]`: 1 for coordinates ≥ 0, −1 for coordinates ≤ 0;
    /// `None` for a circle and an edge that crosses the line.
    pub fn side(&self, axis: usize) -> Option<f64> {
        let [least, most] = self.curve.range(axis);
        if least >= 0.0 && most > 0.0 {
            Some(1.0)
        } else if most <= 0.0 && least < 0.0 {
            Some(-1.0)
        } else {
            None
        }
    }

    /// Whether results can be written along the edge: along a circle, or over x with the normal +y or, on an arc above or below its
    /// centre, ±e_r. Along other edges they stand over the arc length of [their curve](Curve::path).
    pub fn is_reportable(&self) -> bool {
        match self.curve {
            Curve::Circle { .. } => true,
            Curve::Arc {
                centre, ends, turn, ..
            } => {
                let [from, to] = ends.map(|end| end[1] - centre[1]);
                from * to > 0.0 && turn.abs() < PI
            }
            Curve::Segment { .. } => self.level(1).is_some(),
            Curve::Chain { .. } => false,
        }
    }

    /// Whether the edge's normal in results, e_r of a circle and +y of others, points into the body.
    pub fn has_inward_normal(&self) -> bool {
        match self.curve {
            Curve::Circle { .. } => self.role == Role::Hole,
            Curve::Arc { ends, .. } | Curve::Segment { ends } => ends[1][0] > ends[0][0],
            Curve::Chain { .. } => false,
        }
    }

    /// How this edge, as the first of a contact, touches `second`; `None` where gaps between the two are not known.
    pub fn touches(&self, second: &Self) -> Option<Touch> {
        match (self.role, &self.curve, second.role, &second.curve) {
            (
                Role::Hole,
                Curve::Circle { radius: hole, .. },
                Role::Rim,
                Curve::Circle { radius: inner, .. },
            ) => Some(Touch::Circles {
                radii: [*hole, *inner],
            }),
            (Role::Cap, Curve::Arc { radius, .. }, Role::Surface, _) => {
                Some(Touch::Cylinder { radius: *radius })
            }
            (Role::Free, one, Role::Free, other)
                if one.path().is_some() && other.path().is_some() =>
            {
                Some(Touch::Open)
            }
            _ => None,
        }
    }
}

/// How a body is divided.
#[derive(Debug, Clone, Copy)]
pub struct Divided<'a> {
    /// Kind of the cells.
    pub kind: ElementKind,
    /// Angles of the corner nodes of a round shape `[rad]`, from 0 to π (half) or to below 2π (whole); empty for others.
    pub angles: &'a [f64],
    /// Spacing of corner nodes on the contact edge of a shape that is not round `[mm]`; `None` where the scene gives angles.
    pub spacing: Option<f64>,
    /// Up to where that spacing holds, in its unit, where the scene says so.
    pub fine_to: Option<f64>,
    /// Places of the corner nodes on the contact edge instead, from end to end `[mm]`.
    pub places: Option<&'a [f64]>,
    /// Layers between a hole and what surrounds it, where the scene gives them.
    pub layers: Option<usize>,
    /// By how many times cells of a general outline that no division of edges rules are smaller than usual `[1]`.
    pub fineness: f64,
    /// Most layers of a round shape, and rows below given places, where the scene gives none.
    pub most_layers: usize,
    /// Half or whole.
    pub extent: Extent,
    /// Where the body's centre stands `[mm]`.
    pub centre: Point,
    /// The shape that it is divided together with, of a cap or a surface.
    pub partner: Option<&'a dyn Outline>,
    /// Most nodes.
    pub most: usize,
}

impl Divided<'_> {
    /// Divisions of half the circle.
    pub(super) fn half_count(&self) -> f64 {
        match self.extent {
            Extent::Half => self.angles.len() as f64 - 1.0,
            Extent::Whole => self.angles.len() as f64 / 2.0,
        }
    }
}

/// How a mesh is made.
pub struct Meshing {
    /// Its generator.
    pub generator: Box<dyn Generate<Output = Mesh>>,
    /// Radial layers of a round shape.
    pub layers: Option<usize>,
}

impl fmt::Debug for Meshing {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        let mut shown = formatter.debug_struct("Meshing");
        shown.field("layers", &self.layers).finish_non_exhaustive()
    }
}

/// Why a body cannot be divided as the scene says.
#[derive(Debug, Clone, Error, PartialEq)]
#[non_exhaustive]
pub enum DivisionError {
    /// Angles, where a length is needed.
    #[error("a line contact is divided by a length, such as spacing = \"0.02 mm\"")]
    NeedsLength,
    /// A cap without a surface, or a surface without a cap.
    #[error("a cap is divided together with the surface that it touches")]
    NoPartner,
    /// Cells that the shape is not divided into.
    #[error(
        "an outline is divided into triangles with straight or quadratic edges, not into {kind}; give element = \"T6\""
    )]
    NoCells {
        /// Name of the kind that is asked for.
        kind: &'static str,
    },
    /// A mesh whose file was refused.
    #[error("its mesh could not be read")]
    NoFile,
    /// So many nodes that they are not counted exactly.
    #[error("the mesh would have about {nodes:.3e} nodes")]
    TooManyNodes {
        /// About how many `[1]`.
        nodes: f64,
    },
    /// The generator refuses its input.
    #[error(transparent)]
    Generate(#[from] GenerateError),
}

/// Checks the sizes of a shape while its table is read, and keeps what is wrong.
pub(crate) trait Sizes {
    /// Reports the size at `key`, which is not what is `allowed`.
    fn refuse(&mut self, key: &str, size: &Quantity<Length>, allowed: &str);

    /// The text of a file whose path is relative to the folder of the scene, or of the one that it includes by the name `included`.
    fn file(&self, path: &Path, included: Option<&str>) -> io::Result<String>;

    /// Reports that the file `path`, named at `key`, cannot be used.
    fn bad_file(&mut self, key: &str, path: &str, cause: String, remedy: String);

    /// Reports that what stands at `key` does not fit together, as `message` says.
    fn conflict(&mut self, key: &str, message: String, remedy: &str);
}

#[cfg(test)]
mod tests {
    use std::f64::consts::TAU;

    use super::*;

    fn segment(from: Point, to: Point) -> Edge {
        Edge::straight("edge", [from, to])
    }

    fn arc(centre: Point, radius: f64, ends: [Point; 2]) -> Edge {
        let [from, to] = ends.map(|[x, y]| (y - centre[1]).atan2(x - centre[0]));
        let curve = Curve::Arc {
            centre,
            radius,
            ends,
            turn: (to - from).rem_euclid(TAU),
        };
        Edge {
            curve,
            ..segment([0.0; 2], [0.0; 2])
        }
    }

    #[test]
    fn an_edge_is_on_the_side_of_all_of_its_points() {
        for (edge, sides) in [
            (segment([-1.0, 2.0], [3.0, 2.0]), [None, Some(1.0)]),
            (segment([-1.0, 2.0], [-3.0, 5.0]), [Some(-1.0), Some(1.0)]),
            (segment([0.0, -2.0], [3.0, 0.0]), [Some(1.0), Some(-1.0)]),
            (segment([0.0, -2.0], [0.0, 1.0]), [None, None]),
            // Half a circle, and three quarters of one.
            (
                arc([0.0, 5.0], 5.0, [[0.0, 0.0], [0.0, 10.0]]),
                [Some(1.0), Some(1.0)],
            ),
            (
                arc([4.0, 5.0], 5.0, [[4.0, 0.0], [-1.0, 5.0]]),
                [None, Some(1.0)],
            ),
            (
                Edge::circular("rim", Role::Rim, 2.0, "radius"),
                [None, None],
            ),
            // A quarter, an arc that dips under y = 0 between its ends, and one with both ends at y = 0.
            (
                arc([2.0, 1.0], 1.0, [[2.0, 0.0], [3.0, 1.0]]),
                [Some(1.0), Some(1.0)],
            ),
            (
                arc([0.0, 4.0], 5.0, [[-4.0, 1.0], [4.0, 1.0]]),
                [None, None],
            ),
            (
                arc([0.0, 3.0], 5.0, [[-4.0, 0.0], [4.0, 0.0]]),
                [None, Some(-1.0)],
            ),
        ] {
            assert_eq!([0, 1].map(|axis| edge.side(axis)), sides, "{edge:?}");
        }
    }

    #[test]
    fn results_are_written_over_x_where_the_normal_is_known() {
        for (edge, reportable) in [
            (Edge::circular("rim", Role::Rim, 2.0, "radius"), true),
            (segment([-1.0, 2.0], [3.0, 2.0]), true),
            (segment([2.0, -1.0], [2.0, 3.0]), false),
            (segment([-1.0, 2.0], [3.0, 2.5]), false),
            (arc([0.0, 4.0], 5.0, [[-4.0, 1.0], [4.0, 1.0]]), true),
            (arc([4.0, 0.0], 5.0, [[1.0, 4.0], [1.0, -4.0]]), false),
        ] {
            assert_eq!(edge.is_reportable(), reportable, "{edge:?}");
        }
    }
}
