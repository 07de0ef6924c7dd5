//! Loads and their histories.

use std::f64::consts::PI;
use std::path::PathBuf;

use super::{BearingLaw, SetRef};

/// A load and its history.
#[derive(Debug, Clone, PartialEq)]
pub struct Load {
    /// Name in results.
    pub name: String,
    /// What loads what.
    pub kind: LoadKind,
}

/// What loads what. Every `steps` has one entry per load step, and all loads act at once.
#[derive(Debug, Clone, PartialEq)]
pub enum LoadKind {
    /// A total force on an edge of the whole body, spread evenly.
    Force {
        /// The edge.
        on: SetRef,
        /// Unit vector.
        direction: [f64; 2],
        /// Magnitudes `[N]`.
        steps: Vec<f64>,
    },
    /// An assumed pressure on half of a hole, in the place of a pin.
    Bearing {
        /// The hole.
        on: SetRef,
        /// Unit vector of the force on the body; the pressure's middle lies there.
        direction: [f64; 2],
        /// How the pressure is spread.
        law: BearingLaw,
        /// Magnitudes of the force on the whole hole `[N]`, at least 0.
        steps: Vec<f64>,
    },
    /// A pressure on an edge; positive pushes on the body, negative pulls.
    Pressure {
        /// The edge.
        on: SetRef,
        /// `[MPa]`
        steps: Vec<f64>,
    },
    /// Stresses on a circular edge, from a table.
    PolarTraction {
        /// The edge.
        on: SetRef,
        /// The table.
        table: PolarTable,
        /// Factors of the table's stresses.
        steps: Vec<f64>,
    },
    /// A temperature change of a body.
    Temperature {
        /// The body.
        body: String,
        /// `[K]`
        steps: Vec<f64>,
    },
}

impl LoadKind {
    /// Name of the body that it acts on.
    pub fn body(&self) -> &str {
        match self {
            Self::Force { on, .. }
            | Self::Bearing { on, .. }
            | Self::Pressure { on, .. }
            | Self::PolarTraction { on, .. } => &on.body,
            Self::Temperature { body, .. } => body,
        }
    }

    /// The history, in whatever unit it has.
    pub fn steps(&self) -> &[f64] {
        match self {
            Self::Force { steps, .. }
            | Self::Bearing { steps, .. }
            | Self::Pressure { steps, .. }
            | Self::PolarTraction { steps, .. }
            | Self::Temperature { steps, .. } => steps,
        }
    }
}

/// Stresses over the angle on a circle.
#[derive(Debug, Clone, PartialEq)]
pub struct PolarTable {
    /// The file that it was read from.
    pub file: PathBuf,
    /// Angles `[rad]`, strictly increasing.
    pub theta: Vec<f64>,
    /// σ_r `[MPa]`.
    pub radial: Vec<f64>,
    /// τ_rθ `[MPa]`.
    pub shear: Vec<f64>,
}

impl PolarTable {
    /// Whether the table ends at π and so stands for a load symmetric about the x axis.
    pub fn is_half(&self) -> bool {
        self.theta
            .last()
            .is_some_and(|last| (last - PI).abs() < 1e-9)
    }
}
