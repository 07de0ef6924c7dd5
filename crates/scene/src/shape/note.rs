//! What of the file of a mesh was passed over or changed.

use std::fmt;

use serde::{Serialize, Serializer};
use stickslip_mesh_files::Note;

/// Something of the file of a mesh that was passed over, or nodes of it that were moved. Serialised as its text.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum FileNote {
    /// What the reader of the file has to say.
    Read(Note),
    /// Mid nodes of an edge were put from chords onto its curve.
    MidNodes {
        /// The edge.
        edge: String,
        /// How many.
        moved: usize,
        /// The curve.
        onto: FileCurve,
    },
    /// Nodes of an edge were put onto the circle that the scene declares it to be.
    DeclaredCircle {
        /// The edge.
        edge: String,
        /// How many nodes.
        moved: usize,
        /// Radius of the circle `[mm]`.
        radius: f64,
        /// How far corner nodes were from it at most `[mm]`.
        residual: f64,
    },
    /// An edge that the scene declares to be a spline is a line or a circle.
    NoSpline {
        /// The edge.
        edge: String,
    },
}

/// A curve that the edge of a file approximates.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum FileCurve {
    /// A circle of this radius `[mm]`.
    Circle(f64),
    /// Arcs, and lines between them.
    Arcs,
    /// A spline through its nodes.
    Spline,
}

impl fmt::Display for FileNote {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Read(note) => note.fmt(out),
            Self::MidNodes { edge, moved, onto } => {
                write!(
                    out,
                    "{moved} mid nodes of '{edge}' were put from chords onto its {onto}"
                )
            }
            Self::DeclaredCircle {
                edge,
                moved,
                radius,
                residual,
            } => write!(
                out,
                "{moved} nodes of '{edge}' were put onto its circle of radius {radius:.6} mm, from which its corners were up to {residual:.2e} mm away"
            ),
            Self::NoSpline { edge } => write!(
                out,
                "'{edge}' of `splines` is a line or a circle, and stays one"
            ),
        }
    }
}

impl fmt::Display for FileCurve {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Circle(radius) => write!(out, "circle of radius {radius:.6} mm"),
            Self::Arcs => out.write_str("arcs"),
            Self::Spline => out.write_str("spline"),
        }
    }
}

impl Serialize for FileNote {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
