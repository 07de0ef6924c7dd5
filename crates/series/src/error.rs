//! Why no operator can be made.

use thiserror::Error;

/// Why no operator can be made. Angles in rad, lengths in those of the body.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum SeriesError {
    /// Fewer nodes than hats need.
    #[error("{count} node{}; at least 2 are needed", if *count == 1 { "" } else { "s" })]
    Count {
        /// Number of nodes.
        count: usize,
    },
    /// An angle that is not finite or lies outside of where nodes may be.
    #[error("the angle {angle} is not one of a node here")]
    Angle {
        /// The angle `[rad]`.
        angle: f64,
    },
    /// Neighbours that are too close, too far or in the wrong order.
    #[error("nodes {} and {} are {spacing} rad apart: 1e-7 to 0.785 are possible", node + 1, node + 2)]
    Spacing {
        /// The first of the two nodes.
        node: usize,
        /// Their distance `[rad]`.
        spacing: f64,
    },
    /// Places that no hats stand on.
    #[error("node {} stands at {place}: places must be finite and increase, from 0 on in a half", node + 1)]
    Place {
        /// The node.
        node: usize,
        /// Its place `[length]`.
        place: f64,
    },
    /// A length that is not positive.
    #[error("the {what} is {value}, not a positive length")]
    Length {
        /// What it is the length of.
        what: &'static str,
        /// The value `[length]`.
        value: f64,
    },
    /// A load that is not a finite number.
    #[error("load case {case}: {what} is {value}")]
    LoadNotFinite {
        /// Index of the load case.
        case: usize,
        /// What it is.
        what: &'static str,
        /// The value, in the unit of what it is.
        value: f64,
    },
    /// A load that does not mirror itself in the axis of a half model.
    #[error("load case {case}: {what} is {value}; in a half model it must be 0")]
    NotSymmetric {
        /// Index of the load case.
        case: usize,
        /// What it is.
        what: &'static str,
        /// The value, in the unit of what it is.
        value: f64,
    },
    /// A load that a support takes up at once.
    #[error("load case {case}: {what} acts where the body is held")]
    LoadOnSupport {
        /// Index of the load case.
        case: usize,
        /// What acts.
        what: &'static str,
    },
    /// A motion of a support that the body does not have.
    #[error("load case {case}: {what} acts on a body that floats")]
    NoSupport {
        /// Index of the load case.
        case: usize,
        /// What acts.
        what: &'static str,
    },
    /// The circle whose mean displacement stands for that of the centre is too large.
    #[error(
        "the circle about the centre has {ratio} of the disk's radius: more than 0 and at most {largest} are possible"
    )]
    CentreCircle {
        /// Its radius over that of the disk `[1]`.
        ratio: f64,
        /// The largest one `[1]`.
        largest: f64,
    },
    /// An outline that does not go around the hole.
    #[error("edge {edge} of the outline {what}")]
    Outline {
        /// Index of the edge.
        edge: usize,
        /// What is wrong with it.
        what: &'static str,
    },
    /// A half model that moves along x, across its line of symmetry.
    #[error("a half model does not move along x")]
    MovesAcross,
    /// A hole that reaches the outline.
    #[error("the outline comes within {distance} of the hole's centre, the hole reaches {radius}")]
    HoleOutside {
        /// Distance of the outline from the hole's centre `[length]`.
        distance: f64,
        /// The hole's radius `[length]`.
        radius: f64,
    },
    /// A ligament between hole and outline that is too thin for a series.
    #[error(
        "a ligament of {ligament:.4} beside a hole of radius {radius} needs {needed} modes of at most {largest}: use finite elements"
    )]
    Ligament {
        /// Width of the ligament `[length]`.
        ligament: f64,
        /// The hole's radius `[length]`.
        radius: f64,
        /// Number of modes that it needs `[1]`.
        needed: f64,
        /// The largest number.
        largest: i64,
    },
    /// A half model in an outline that is not symmetric.
    #[error(
        "the outline is not symmetric about the x axis through the hole's centre: use nodes of the whole circle"
    )]
    NotMirrored,
    /// A load on an edge that is not there.
    #[error("load case {case}: the outline has {edges} edges, none with the index {edge}")]
    UnknownEdge {
        /// Index of the load case.
        case: usize,
        /// The index given.
        edge: usize,
        /// Number of edges.
        edges: usize,
    },
    /// A fit that leaves too much of the load on the outer edge.
    #[error(
        "polynomials of degree {degree} leave {residual:.1e} of the mean traction on the outer edge"
    )]
    NotFitted {
        /// What is left, relative to the mean traction `[1]`.
        residual: f64,
        /// The largest degree.
        degree: usize,
    },
    /// A state whose vectors do not fit the body.
    #[error("{found} {what} of a body that has {expected}")]
    State {
        /// What they are.
        what: &'static str,
        /// How many were given.
        found: usize,
        /// How many fit.
        expected: usize,
    },
    /// A point that the body does not have.
    #[error("the point ({}, {}) is outside of the body", point[0], point[1])]
    OutsideBody {
        /// The point `[length]`.
        point: [f64; 2],
    },
    /// A material that the body cannot have.
    #[error("the material {what}")]
    Material {
        /// What is wrong with it.
        what: &'static str,
    },
}
