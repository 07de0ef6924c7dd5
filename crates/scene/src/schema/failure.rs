//! Settings of the failure analysis of laminates.

use std::sync::Arc;

use super::{Control, Progressive};
use serde::{Deserialize, Serialize};
use stickslip_laminate::{Degradation, FailureCriterion};

/// The question of `[failure]`.
#[derive(Debug, Clone)]
pub struct Failure {
    /// Criteria, at least one; every ply of the bodies has the strengths that they ask for. The first one is drawn.
    pub criteria: Vec<Arc<dyn FailureCriterion>>,
    /// Bodies of a laminate, at least one, in the order of their names.
    pub bodies: Vec<String>,
    /// Distance from the ends of supports within which no ply is checked `[mm]`, at least 0; a part of the body's size where not given.
    pub clear_of_supports: Option<f64>,
    /// Hypotheses on stresses at a distance from the hole.
    pub characteristic: Option<Characteristic>,
    /// Failure envelopes of the bodies' laminates.
    pub envelopes: Option<Envelopes>,
    /// Failure of a joint, followed until its load path is lost.
    pub progressive: Option<Progressive>,
}

impl Failure {
    /// Whether a joint is followed by a drive, which needs no load.
    pub fn is_driven(&self) -> bool {
        let control = self.progressive.as_ref().map(|asked| &asked.control);
        matches!(control, Some(Control::Displacement { .. }))
    }
}

/// Characteristic distances from the edge of a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    /// R_t, at the net section `[mm]`.
    pub tension: f64,
    /// R_c, at the bearing point `[mm]`.
    pub compression: f64,
}

/// Failure envelopes to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelopes {
    /// Their planes, at least one.
    pub planes: Vec<EnvelopePlane>,
    /// Number of directions of load in each, at least 3.
    pub directions: usize,
    /// How failed plies soften, where the last ply's failure is asked for as well.
    pub last_ply: Option<Degradation>,
}

/// Plane of the mean stresses of an envelope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EnvelopePlane {
    /// (σ_x, σ_y).
    Normal,
    /// (σ_x, τ_xy).
    Shear,
}
