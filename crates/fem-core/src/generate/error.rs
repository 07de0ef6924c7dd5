//! What a generator refuses.

use thiserror::Error;

use crate::mesh::{MeshError, Point};

/// Why a mesh was not generated.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum GenerateError {
    /// A size or ratio that must be positive and finite.
    #[error("{what} must be positive and finite, not {value}")]
    NotPositive {
        /// Name of the input.
        what: &'static str,
        /// Its value: a size `[length]` or a ratio `[1]`.
        value: f64,
    },
    /// A number that must be finite.
    #[error("{what} must be finite, not {value}")]
    NotFinite {
        /// Name of the input.
        what: &'static str,
        /// Its value: a coordinate `[length]`, an angle `[rad]` or a fraction `[1]`.
        value: f64,
    },
    /// A size that must be smaller than another.
    #[error("{what} ({value}) must be smaller than {bound_name} ({bound})")]
    TooBig {
        /// Name of the input.
        what: &'static str,
        /// Its value `[length]`.
        value: f64,
        /// Name of what it must not reach.
        bound_name: &'static str,
        /// Value of that `[length]`.
        bound: f64,
    },
    /// Too few cells, layers, coordinates or angles.
    #[error("{what}: {count} given, at least {needed} needed")]
    TooFew {
        /// Name of the input.
        what: &'static str,
        /// How many there are.
        count: usize,
        /// How many are needed.
        needed: usize,
    },
    /// A list that must increase strictly (NaN does not).
    #[error("{what} must increase strictly, but entry {index} is {value} after {previous}")]
    NotIncreasing {
        /// Name of the list.
        what: &'static str,
        /// Index of the entry.
        index: usize,
        /// The entry before, in the unit of the list.
        previous: f64,
        /// The entry, in the unit of the list.
        value: f64,
    },
    /// A list that must start or end elsewhere.
    #[error("{what} must be {expected}, not {value}")]
    WrongEnd {
        /// Which end of which list.
        what: &'static str,
        /// What it must be, as text.
        expected: &'static str,
        /// What it is, in the unit of the list.
        value: f64,
    },
    /// Explicit layer fractions that do not match the number of layers.
    #[error("{fractions} layer fractions given for {layers} layers")]
    FractionCount {
        /// Number of fractions.
        fractions: usize,
        /// Number of layers.
        layers: usize,
    },
    /// The angles leave no hole node that could be joined to a corner of the plate.
    #[error(
        "no hole angle fits the plate corner at {corner:.3} rad: the nearest free one is {nearest:.3} rad; \
         add angles around {corner:.3} rad"
    )]
    CornerUnresolved {
        /// Direction of the corner seen from the hole's centre `[rad]`.
        corner: f64,
        /// The nearest angle that is not taken by another corner `[rad]`.
        nearest: f64,
    },
    /// A ray from the hole to the plate's outline would cut through the hole.
    #[error(
        "the hole node at {angle:.3} rad would be joined to the outline at {outline:.3} rad through the hole; \
         add angles around the plate corners"
    )]
    RayThroughHole {
        /// Angle on the hole `[rad]`.
        angle: f64,
        /// Angle of the outline's node `[rad]`.
        outline: f64,
    },
    /// Quadrilaterals cannot fill a closed outline with an odd number of edges.
    #[error("a whole disk needs an even number of rim angles, not {count}; add or remove one")]
    OddRim {
        /// Number of rim angles.
        count: usize,
    },
    /// A set names a block that the builder did not make.
    #[error("set '{set}' names block {block}, but there are only {count}")]
    UnknownBlock {
        /// Name of the set.
        set: String,
        /// Number of the block.
        block: usize,
        /// How many blocks there are.
        count: usize,
    },
    /// More nodes than allowed.
    #[error("the mesh would have {nodes} nodes (about {bytes} bytes); the limit is {limit} nodes")]
    TooLarge {
        /// Number of nodes.
        nodes: usize,
        /// Memory for the mesh alone `[bytes]`.
        bytes: usize,
        /// The limit in force.
        limit: usize,
    },
    /// An outline or a hole that cannot be meshed, from generators of other crates.
    #[error("{reason}{}", at.map_or_else(String::new, |[x, y]| format!(", at ({x:.6}, {y:.6})")))]
    Contour {
        /// What is wrong, with names and numbers.
        reason: String,
        /// About where `[length]`, if it is at one place.
        at: Option<Point>,
    },
    /// The input is in order but the mesh is not, for example because angles vary too abruptly.
    #[error("the generated mesh is not valid; use more layers or a smoother list of angles")]
    Mesh(#[from] MeshError),
}

impl GenerateError {
    /// What stopped a generator in a frame of its own, at its place outside that frame.
    #[must_use]
    pub fn placed(mut self, place: impl Fn(Point) -> Point) -> Self {
        if let Self::Contour { at: Some(at), .. } = &mut self {
            *at = place(*at);
        }
        self
    }
}
