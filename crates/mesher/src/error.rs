//! What the mesher refuses.

use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::mesh::{ElementKind, MeshError, Point};
use thiserror::Error;

/// Why a contour was not meshed.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum ContourError {
    /// A loop of one piece or none.
    #[error("{} has {count} edges, at least 2 are needed", called(cutout.as_ref()))]
    TooFewPieces {
        /// Name of the cut-out; `None` of the outline.
        cutout: Option<String>,
        /// How many there are.
        count: usize,
    },
    /// A number that must be finite.
    #[error("{what} must be finite, not {value}")]
    NotFinite {
        /// Which number.
        what: String,
        /// Its value: a coordinate or size `[length]`, or the fineness `[1]`.
        value: f64,
    },
    /// A number that must be positive.
    #[error("{what} must be positive, not {value}")]
    NotPositive {
        /// Which number.
        what: String,
        /// Its value: a size `[length]` or the fineness `[1]`.
        value: f64,
    },
    /// A piece or hole without a name.
    #[error("{what} has no name")]
    EmptyName {
        /// Which piece or hole, counted from 1.
        what: String,
    },
    /// A name that is used twice where it must not be.
    #[error("the name '{name}' is used twice; only neighbouring edges may share one")]
    DuplicateName {
        /// The name.
        name: String,
    },
    /// The last piece does not end where the first begins.
    #[error(
        "{} is open: its last edge '{piece}' ends at ({}, {}), a distance of {gap} from the start ({}, {})",
        called(cutout.as_ref()), end[0], end[1], start[0], start[1]
    )]
    Open {
        /// Name of the cut-out; `None` of the outline.
        cutout: Option<String>,
        /// Name of the last piece.
        piece: String,
        /// Its end `[length]`.
        end: Point,
        /// Start of the loop `[length]`.
        start: Point,
        /// Distance between them `[length]`.
        gap: f64,
    },
    /// A piece that ends where it begins.
    #[error("edge '{piece}' has no length: it begins and ends at ({}, {})", at[0], at[1])]
    ZeroLength {
        /// Name of the piece.
        piece: String,
        /// Where it is `[length]`.
        at: Point,
    },
    /// An arc that three points do not define.
    #[error(
        "the three points of arc '{piece}' lie on a line or coincide; give a point between its ends, or none for a straight edge"
    )]
    StraightArc {
        /// Name of the piece.
        piece: String,
    },
    /// A spline whose points make no curve.
    #[error("spline '{piece}' {flaw}")]
    Spline {
        /// Name of the piece.
        piece: String,
        /// What is wrong with it.
        flaw: SplineFlaw,
    },
    /// Pieces in the wrong order.
    #[error(
        "{} is clockwise (its signed area is {area}); reverse the order of its edges",
        called(cutout.as_ref())
    )]
    Clockwise {
        /// Name of the cut-out; `None` of the outline.
        cutout: Option<String>,
        /// Signed area of the loop `[length²]`.
        area: f64,
    },
    /// Two pieces that cross or touch.
    #[error("edges '{first}' and '{second}' meet near ({:.6}, {:.6})", at[0], at[1])]
    Crossing {
        /// Name of the first piece.
        first: String,
        /// Name of the second.
        second: String,
        /// About where `[length]`.
        at: Point,
    },
    /// Two neighbouring pieces that leave no room between them, inside or outside.
    #[error(
        "pieces '{first}' and '{second}' form a cusp: the inner angle between them is {angle:.4} rad at ({}, {})",
        at[0], at[1]
    )]
    Cusp {
        /// Name of the piece that ends there.
        first: String,
        /// Name of the piece that begins there.
        second: String,
        /// Angle inside the body `[rad]`.
        angle: f64,
        /// The corner `[length]`.
        at: Point,
    },
    /// A cut-out beside the body.
    #[error("cut-out '{cutout}' lies outside the outline, such as its corner ({:.6}, {:.6})", at[0], at[1])]
    CutoutOutside {
        /// Name of the cut-out.
        cutout: String,
        /// A corner of it `[length]`.
        at: Point,
    },
    /// A cut-out where another one has left nothing.
    #[error("cut-out '{inner}' lies inside cut-out '{outer}'")]
    CutoutInside {
        /// Name of the one inside.
        inner: String,
        /// Name of the one around it.
        outer: String,
    },
    /// A hole beside the body.
    #[error(
        "hole '{hole}' lies outside the body, {distance} from its nearest edge to the hole's centre"
    )]
    HoleOutside {
        /// Name of the hole.
        hole: String,
        /// Distance from its centre to the nearest edge `[length]`.
        distance: f64,
    },
    /// A hole that reaches the outline.
    #[error(
        "hole '{hole}' crosses edge '{piece}': its centre is {distance} away and its radius is {radius}"
    )]
    HoleCrosses {
        /// Name of the hole.
        hole: String,
        /// Name of the piece.
        piece: String,
        /// Distance from the hole's centre to the piece `[length]`.
        distance: f64,
        /// Radius of the hole `[length]`.
        radius: f64,
    },
    /// Two holes that overlap or touch.
    #[error(
        "holes '{first}' and '{second}' overlap: their centres are {distance} apart and their radii add up to {radii}"
    )]
    HolesOverlap {
        /// Name of the first hole.
        first: String,
        /// Name of the second.
        second: String,
        /// Distance between their centres `[length]`.
        distance: f64,
        /// Sum of their radii `[length]`.
        radii: f64,
    },
    /// Too few nodes around a hole.
    #[error("hole '{hole}' has {count} angles, at least {needed} are needed")]
    TooFewAngles {
        /// Name of the hole.
        hole: String,
        /// How many there are.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// Angles that do not increase strictly within [0, 2π).
    #[error(
        "the angles of hole '{hole}' must increase strictly from at least 0 to below 2π, but angle {index} is {value} rad"
    )]
    Angles {
        /// Name of the hole.
        hole: String,
        /// Index of the angle.
        index: usize,
        /// The angle `[rad]`.
        value: f64,
    },
    /// Neighbouring angles too far apart for cells that follow the circle.
    #[error(
        "the angles of hole '{hole}' leave an interval of {width:.4} rad after {after:.4} rad; the widest allowed is {widest:.4} rad"
    )]
    AngleGap {
        /// Name of the hole.
        hole: String,
        /// Angle before the interval `[rad]`.
        after: f64,
        /// Width of the interval `[rad]`.
        width: f64,
        /// The widest allowed `[rad]`.
        widest: f64,
    },
    /// A kind of cell other than T3 and T6.
    #[error("contours are meshed with T3 or T6, not {kind:?}")]
    Kind {
        /// The kind asked for.
        kind: ElementKind,
    },
    /// A growth of the cell size over the fineness that gives no good cells.
    #[error("the growth of the cell size must be above 0 and at most 1, not {value}")]
    Growth {
        /// The growth asked for over the fineness `[1]`.
        value: f64,
    },
    /// Cells on a piece that is not there, or that would be larger than elsewhere.
    #[error(
        "cells on piece {piece} of {count} cannot be {times} times smaller; pieces count from 0, and 1 or more is possible"
    )]
    Refined {
        /// Number of the piece.
        piece: usize,
        /// How many times smaller its cells are to be `[1]`.
        times: f64,
        /// Number of pieces.
        count: usize,
    },
    /// A point at which no piece ends.
    #[error("no edge ends at point '{point}' ({}, {}); the nearest end is {distance} away", at[0], at[1])]
    NoEnd {
        /// Name of the point.
        point: String,
        /// Where it is `[length]`.
        at: Point,
        /// Distance of the nearest end of a piece `[length]`.
        distance: f64,
    },
    /// Cells that stayed large or flat.
    #[error("{}, at ({:.6}, {:.6})", incomplete(*cells, *angle), at[0], at[1])]
    Incomplete {
        /// How many cells.
        cells: usize,
        /// Least angle of the worst `[rad]`.
        angle: f64,
        /// About where it is `[length]`.
        at: Point,
    },
    /// Edges of the boundary that leave no room for a triangle.
    #[error("{MEET}, at ({:.6}, {:.6})", at[0], at[1])]
    EdgesMeet {
        /// About where `[length]`.
        at: Point,
    },
    /// The triangulation refused its input, for example coordinates beyond its range.
    #[error("the triangulation failed: {reason}")]
    Triangulation {
        /// What it reported.
        reason: String,
    },
    /// More nodes than allowed.
    #[error("the mesh would have more than {limit} nodes, about {nodes}")]
    TooLarge {
        /// About how many nodes.
        nodes: usize,
        /// The limit in force.
        limit: usize,
    },
    /// The triangles are in order but their curved cells are not.
    #[error("the generated mesh is not valid; give the holes more angles")]
    Mesh(#[from] MeshError),
}

impl ContourError {
    /// What stopped a triangulation in a frame of its own, at its place outside that frame.
    pub(crate) fn at_places(mut self, place: impl Fn(Point) -> Point) -> Self {
        if let Self::Incomplete { at, .. } | Self::EdgesMeet { at } = &mut self {
            *at = place(*at);
        }
        self
    }
}

/// Why points make no spline that bounds a body.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SplineFlaw {
    /// Its ends alone.
    #[error("has no point between its ends")]
    NoPoint,
    /// More points than its checks are made for.
    #[error("has {count} points between its ends, {most} at most are possible")]
    TooManyPoints {
        /// How many there are.
        count: usize,
        /// How many are possible.
        most: usize,
    },
    /// Neighbours at one place.
    #[error("passes ({:.6}, {:.6}) twice in a row", at[0], at[1])]
    RepeatedPoint {
        /// Where they are `[length]`.
        at: Point,
    },
    /// A turn that its points do not resolve.
    #[error(
        "turns with a radius of {radius:.3e} near ({:.6}, {:.6}), between points that are {chord:.6} apart",
        at[0], at[1]
    )]
    Tight {
        /// About where `[length]`.
        at: Point,
        /// The radius of curvature `[length]`.
        radius: f64,
        /// Distance between the two points beside it `[length]`.
        chord: f64,
    },
    /// A loop.
    #[error("meets itself near ({:.6}, {:.6})", at[0], at[1])]
    Meets {
        /// About where `[length]`.
        at: Point,
    },
}

/// What a message calls a loop.
fn called(cutout: Option<&String>) -> String {
    cutout.map_or_else(
        || "the outline".to_owned(),
        |name| format!("cut-out '{name}'"),
    )
}

const MEET: &str = "boundary edges coincide or cross; use a finer spacing there";

/// That `cells` stayed large or flat, the worst with the least angle `angle` `[rad]`.
fn incomplete(cells: usize, angle: f64) -> String {
    let degrees = angle.to_degrees();
    format!(
        "refinement is incomplete: {cells} cells are too large or too flat, the worst with a least angle of {degrees:.2}°; \
         give holes near it more angles, or a finer spacing"
    )
}

/// Memory of a node of a triangle mesh with its share of the cells `[bytes]`.
const NODE_BYTES: usize = 64;

impl From<ContourError> for GenerateError {
    fn from(error: ContourError) -> Self {
        match error {
            ContourError::TooLarge { nodes, limit } => Self::TooLarge {
                nodes,
                bytes: nodes.saturating_mul(NODE_BYTES),
                limit,
            },
            ContourError::Mesh(error) => Self::Mesh(error),
            ContourError::Incomplete { cells, angle, at } => Self::Contour {
                reason: incomplete(cells, angle),
                at: Some(at),
            },
            ContourError::EdgesMeet { at } => Self::Contour {
                reason: MEET.to_owned(),
                at: Some(at),
            },
            other => Self::Contour {
                reason: other.to_string(),
                at: None,
            },
        }
    }
}
