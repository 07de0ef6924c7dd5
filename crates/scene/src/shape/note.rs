//! What of the file of a mesh was passed over or changed.

use std::fmt;

use serde::{Serialize, Serializer};
use stickslip_mesh_files::Note;
use stickslip_text::counted;

use crate::units::{Length, Unit, UnitName};

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

impl FileNote {
    /// The note as a part of a sentence, with lengths in `unit`.
    pub fn text(&self, unit: &Unit) -> String {
        match self {
            Self::Read(note) => note.to_string(),
            Self::MidNodes { edge, moved, onto } => {
                let onto = match onto {
                    FileCurve::Circle(radius) => format!("circle of radius {}", unit.show(*radius)),
                    FileCurve::Arcs => "arcs".to_owned(),
                    FileCurve::Spline => "spline".to_owned(),
                };
                let (nodes, were) = (counted(*moved, "mid node"), were(*moved));
                format!("{nodes} of '{edge}' {were} put from chords onto its {onto}")
            }
            Self::DeclaredCircle {
                edge,
                moved,
                radius,
                residual,
            } => format!(
                "{} of '{edge}' {} put onto its circle of radius {}, from which its corners were up to {:.2e} {} away",
                counted(*moved, "node"),
                were(*moved),
                unit.show(*radius),
                unit.from_base(*residual),
                unit.name
            ),
            Self::NoSpline { edge } => {
                format!("'{edge}' of `splines` is a line or a circle, and stays one")
            }
        }
    }
}

fn were(count: usize) -> &'static str {
    if count == 1 { "was" } else { "were" }
}

impl fmt::Display for FileNote {
    fn fmt(&self, out: &mut fmt::Formatter<'_>) -> fmt::Result {
        out.write_str(&self.text(UnitName::<Length>::base().unit()))
    }
}

impl Serialize for FileNote {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        serializer.collect_str(self)
    }
}
