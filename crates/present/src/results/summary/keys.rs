//! The keys of `summary.json` in their order.

use std::collections::BTreeMap;

use serde::Serialize;

use crate::results::bypass;
use crate::results::failure::summary::Failure;
use crate::results::fasteners;
use crate::results::findings::Entry;
use crate::results::quantities::SummaryQuantities;
use crate::results::quantity::{Quantity, Vector};
use crate::results::sets;
use crate::results::stresses;

/// Version of the format; a change that could break a reader raises it.
pub(super) const FORMAT_VERSION: u32 = 2;

/// Everything in `summary.json`, in its order.
#[derive(Debug, Serialize)]
pub(crate) struct Summary<'a> {
    pub(super) format: &'static str,
    pub(super) format_version: u32,
    pub(super) title: &'a str,
    pub(super) source: &'a str,
    pub(super) scene_hash: &'a str,
    pub(super) program: Program,
    pub(super) units: Units,
    pub(super) choices: Vec<Choice>,
    pub(crate) notes: Vec<String>,
    pub(super) findings: Vec<Entry>,
    pub(super) bodies: Vec<Body<'a>>,
    pub(super) dofs: usize,
    pub(super) factorisations: usize,
    pub(super) wall_time_s: BTreeMap<&'static str, f64>,
    /// How an accuracy was sought, where one was.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) accuracy: Option<Sought>,
    /// Name of the edge whose quantities stand directly in each step.
    pub(super) edge: Option<&'a str>,
    pub(super) edges: Vec<Edge<'a>>,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) fasteners: Vec<fasteners::Entry<'a>>,
    pub(super) steps: Vec<Step<'a>>,
    /// Failure of the laminated bodies for which the scene requests it.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) failure: Vec<Failure<'a>>,
}

/// How an accuracy was sought.
#[derive(Debug, Serialize)]
pub(super) struct Sought {
    /// Relative errors that were asked for.
    pub(super) asked: Option<Asked>,
    /// Whether it was reached, and otherwise why not.
    pub(super) end: &'static str,
    pub(super) rungs: Vec<Tried>,
}

/// Relative errors that were asked for.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Asked {
    Overall(f64),
    /// By the names that scenes give numbers.
    Named(BTreeMap<&'static str, f64>),
}

/// A model that was tried.
#[derive(Debug, Serialize)]
pub(super) struct Tried {
    pub(super) model: String,
    pub(super) increments: usize,
    pub(super) increments_of_steps: Vec<usize>,
    /// Largest relative error, and what has it.
    pub(super) error: Option<f64>,
    pub(super) of: Option<&'static str>,
    pub(super) stopped: bool,
    pub(super) wall_time_s: f64,
}

#[derive(Debug, Serialize)]
pub(super) struct Program {
    pub(super) name: &'static str,
    pub(super) version: &'static str,
}

#[derive(Debug, Serialize)]
pub(super) struct Units {
    pub(super) length: &'static str,
    pub(super) force: &'static str,
    pub(super) stress: &'static str,
    pub(super) energy: String,
    pub(super) angle: &'static str,
}

#[derive(Debug, Serialize)]
pub(super) struct Choice {
    pub(super) what: String,
    pub(super) value: String,
    pub(super) reason: String,
}

#[derive(Debug, Serialize)]
pub(super) struct Body<'a> {
    pub(super) name: &'a str,
    pub(super) rigid: bool,
    pub(super) nodes: usize,
    pub(super) elements: usize,
    pub(super) dofs: usize,
    pub(super) factor_entries: usize,
    pub(super) free_motions: usize,
    #[serde(rename = "yield")]
    pub(super) yield_stress: Option<Quantity>,
}

#[derive(Debug, Serialize)]
pub(super) struct Edge<'a> {
    pub(super) name: &'a str,
    pub(super) kind: &'static str,
    pub(super) contact: bool,
    pub(super) body: &'a str,
    pub(super) law: Option<&'a str>,
    /// Name of what its steps are counted by.
    pub(super) load_name: String,
    pub(super) radius: Option<Quantity>,
    /// Radial clearance of two circles, negative for an interference.
    pub(super) clearance: Option<Quantity>,
    /// θ_b of the bearing point from which angles are counted; null where they count from +x, and on a line.
    pub(super) bearing_angle_deg: Option<f64>,
    /// How the bearing point was found.
    pub(super) bearing_found: Option<String>,
    pub(super) nodes: usize,
    pub(super) half: bool,
}

#[derive(Debug, Serialize)]
pub(super) struct Load<'a> {
    pub(super) name: &'a str,
    pub(super) value: Option<f64>,
    pub(super) unit: &'a str,
}

#[derive(Debug, Serialize)]
pub(super) struct Step<'a> {
    #[serde(rename = "step")]
    pub(super) number: usize,
    pub(super) load: Option<Quantity>,
    pub(super) loads: Vec<Load<'a>>,
    pub(super) unloading: bool,
    #[serde(flatten)]
    pub(super) edge: Option<EdgeStep>,
    pub(super) edges: BTreeMap<&'a str, OwnEdgeStep>,
    /// What loads act on, and what is held.
    pub(super) sets: Vec<sets::Entry<'a>>,
    /// Largest stresses of bodies.
    pub(super) stresses: Vec<stresses::Entry<'a>>,
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) fasteners: BTreeMap<&'a str, fasteners::StepEntry>,
    /// Bearing and bypass loads at rows of fasteners, by plates.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) bypass: BTreeMap<&'a str, Vec<bypass::Entry<'a>>>,
    pub(super) iterations: usize,
    pub(super) pivots: usize,
    pub(super) solvers: &'a [&'static str],
    pub(super) increments: usize,
    pub(super) cutbacks: usize,
    pub(super) points_in_doubt: usize,
    pub(super) solver_notes: SolverNotes,
    pub(super) solutions_counted: Option<usize>,
    pub(super) other_solver: Option<OtherAnswer>,
    pub(super) finer_increments: Option<OtherAnswer>,
    pub(super) friction_coefficient: Option<f64>,
    /// Estimate of the friction coefficient up to which the step is unique.
    pub(super) uniqueness_estimate: Option<f64>,
    pub(super) balance_residual: Option<f64>,
    pub(super) complementarity_residual: Option<f64>,
    pub(super) cone_violation: Option<f64>,
    pub(super) dissipation: Quantity,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) dissipation_error: Option<Quantity>,
    pub(super) wall_time_s: f64,
}

/// How another way to the end of a step changes its answer.
#[derive(Debug, Serialize)]
pub(super) struct OtherAnswer {
    pub(super) solver: &'static str,
    pub(super) increments: usize,
    pub(super) peak_pressure_change: Option<f64>,
    pub(super) traction_change: Option<f64>,
    pub(super) slip_change: Option<f64>,
    pub(super) dissipation_change: Option<f64>,
}

/// What failed before a step was solved.
#[derive(Debug, Serialize)]
pub(super) struct SolverNotes {
    pub(super) failed: Vec<Failed>,
    pub(super) first_cycle: Option<Cycle>,
}

#[derive(Debug, Serialize)]
pub(super) struct Failed {
    pub(super) solver: &'static str,
    pub(super) reason: &'static str,
    pub(super) count: usize,
}

#[derive(Debug, Serialize)]
pub(super) struct Cycle {
    pub(super) solver: &'static str,
    pub(super) period: usize,
    pub(super) nodes: Vec<Vector>,
}

/// One edge at the end of a step, and the load that acts on it.
#[derive(Debug, Serialize)]
pub(super) struct OwnEdgeStep {
    pub(super) load: Option<Quantity>,
    pub(super) unloading: bool,
    #[serde(flatten)]
    pub(super) edge: EdgeStep,
}

/// Quantities of one edge at the end of a step.
#[derive(Debug, Serialize)]
pub(super) struct EdgeStep {
    #[serde(flatten)]
    pub(super) zones: Zones,
    #[serde(flatten)]
    pub(super) quantities: SummaryQuantities,
    pub(super) fewest_contact_nodes: Option<usize>,
    pub(super) contact_resolved: Option<bool>,
    pub(super) resultant: Option<Vector>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) resultant_error: Option<Vector>,
}

/// Zones along the edge: in degrees on a circle, in lengths on a line.
#[derive(Debug, Serialize)]
#[serde(untagged)]
pub(super) enum Zones {
    Circle {
        contact_zones_deg: Vec<ContactZone>,
        stick_zones_deg: Vec<ContactZone>,
        slip_zones_deg: Vec<SlipZone>,
    },
    Line {
        contact_zones: Vec<ContactZone>,
        stick_zones: Vec<ContactZone>,
        slip_zones: Vec<SlipZone>,
    },
}

#[derive(Debug, Serialize)]
pub(super) struct ContactZone {
    pub(super) start: Option<f64>,
    pub(super) end: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) unit: Option<&'static str>,
}

#[derive(Debug, Serialize)]
pub(super) struct SlipZone {
    pub(super) start: Option<f64>,
    pub(super) end: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) unit: Option<&'static str>,
    pub(super) direction: &'static str,
}
