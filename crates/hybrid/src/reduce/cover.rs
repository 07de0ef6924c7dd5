//! Nodes that the data do not cover.

use std::fmt;

use stickslip_fem_core::mesh::Point;

use crate::data::letter;
use crate::triangles::NoTriangle;

/// A node that the data do not cover.
#[derive(Clone, Debug, PartialEq)]
pub struct Uncovered {
    /// Index of the node.
    pub node: usize,
    /// Its place `[length]`.
    pub place: Point,
    /// The component that is not covered, 0 or 1; 0 if neither is.
    pub component: usize,
    /// Why not.
    pub reason: Reason,
}

impl fmt::Display for Uncovered {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let [x, y] = self.place;
        write!(
            f,
            "node {} at ({x}, {y}), {}: {}",
            self.node,
            letter(self.component),
            self.reason
        )
    }
}

/// Why a node is not covered.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Reason {
    /// It lies outside the hull of the valid places.
    Outside,
    /// The triangle around it is a gap in the data.
    Gap {
        /// Longest side of the triangle `[length]`.
        side: f64,
        /// What is allowed `[length]`.
        longest: f64,
    },
    /// Too few valid places are near.
    Sparse {
        /// Requested neighbours.
        neighbours: usize,
        /// Radius within which there are as many `[length]`.
        radius: f64,
        /// What is allowed `[length]`.
        largest: f64,
    },
    /// All its neighbours lie on one side of it.
    OneSided {
        /// Angle without neighbours, degrees.
        open: f64,
    },
    /// Its neighbours lie on a curve that does not determine the polynomial, or on one another.
    Degenerate,
    /// The nearest fringe line is too far.
    OffLines {
        /// Distance of the line `[length]`.
        distance: f64,
        /// What is allowed `[length]`.
        reach: f64,
    },
    /// It lies beyond the ends of all fringe lines.
    BeyondLines,
}

impl From<NoTriangle> for Reason {
    fn from(cause: NoTriangle) -> Self {
        match cause {
            NoTriangle::Outside => Self::Outside,
            NoTriangle::Gap { side, longest } => Self::Gap { side, longest },
        }
    }
}

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.describe(&|length| length.to_string()))
    }
}

impl Reason {
    /// The reason as text, with its lengths `[length]` as `length` spells them.
    pub fn describe(&self, length: &dyn Fn(f64) -> String) -> String {
        match self {
            Self::Outside => "outside the data".to_owned(),
            Self::Gap { side, longest } => format!(
                "in a gap of the data, a triangle with a side of {} (at most {} is allowed)",
                length(*side),
                length(*longest)
            ),
            Self::Sparse {
                neighbours,
                radius,
                largest,
            } => format!(
                "its {neighbours} neighbours reach as far as {} (at most {} is allowed)",
                length(*radius),
                length(*largest)
            ),
            Self::OneSided { open } => {
                format!("its neighbours leave {open:.0}° open, so it would be extrapolated")
            }
            Self::Degenerate => "its neighbours do not determine the polynomial".to_owned(),
            Self::OffLines { distance, reach } => format!(
                "the nearest fringe line is {} away (at most {} is allowed)",
                length(*distance),
                length(*reach)
            ),
            Self::BeyondLines => "beyond the ends of all fringe lines".to_owned(),
        }
    }
}
