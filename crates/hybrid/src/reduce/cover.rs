//! Nodes that the data do not cover.

use std::fmt;

use stickslip_fem_core::mesh::Point;

use crate::data::letter;

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
        /// Neighbours asked for.
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

impl fmt::Display for Reason {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Outside => write!(f, "outside the data"),
            Self::Gap { side, longest } => {
                write!(
                    f,
                    "in a gap of the data, a triangle with a side of {side} (at most {longest} is allowed)"
                )
            }
            Self::Sparse {
                neighbours,
                radius,
                largest,
            } => {
                write!(
                    f,
                    "its {neighbours} neighbours reach as far as {radius} (at most {largest} is allowed)"
                )
            }
            Self::OneSided { open } => {
                write!(
                    f,
                    "its neighbours leave {open:.0}° open, so it would be extrapolated"
                )
            }
            Self::Degenerate => write!(f, "its neighbours do not determine the polynomial"),
            Self::OffLines { distance, reach } => {
                write!(
                    f,
                    "the nearest fringe line is {distance} away (at most {reach} is allowed)"
                )
            }
            Self::BeyondLines => write!(f, "beyond the ends of all fringe lines"),
        }
    }
}
