//! Settings of the progressive failure analysis of a joint.

use super::{Axis, SetRef};
use crate::declaration::choices::coded;
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Range, Table, counts, described, energy, integer, length, names,
    number, numbers, set, table, table_as,
};
use crate::units::{FractureEnergy, Length, Quantity};
use serde::{Deserialize, Serialize};
use serde_json::Value;
use std::sync::Arc;
use stickslip_joint::FractureEnergies;
use stickslip_laminate::FailureCriterion;
use stickslip_laminate::laminate::Laminate;
use stickslip_laminate::progressive::{PointModel, PointModelParameters, ProgressiveError};

/// The question of `[failure.progressive]`.
#[derive(Debug, Clone)]
pub struct Progressive {
    /// The laminated body whose plies fail; one contact touches its hole.
    pub body: String,
    /// How its plies lose stiffness.
    pub model: ProgressiveModel,
    /// Fracture energies `[N/mm]` that scale the strengths with the mesh, by ply discount only.
    pub crack_band: Option<FractureEnergies>,
    /// What is raised.
    pub control: Control,
}

/// How plies lose stiffness: a registered point model, as the scene gives it.
#[derive(Debug, Clone)]
pub struct ProgressiveModel {
    /// Its parameters.
    pub parameters: Arc<dyn PointModelParameters>,
    /// The criterion by which plies fail, for a model that needs one.
    pub criterion: Arc<dyn FailureCriterion>,
}

/// What is raised until the joint fails.
#[derive(Debug, Clone, PartialEq)]
pub enum Control {
    /// The loads, through the scene's steps.
    Loads {
        /// Increments of each step.
        increments: usize,
    },
    /// The displacement of an edge or point, in place of all loads.
    Displacement {
        /// What is driven.
        on: SetRef,
        /// Along which axis.
        axis: Axis,
        /// To where `[mm]`.
        end: f64,
        /// In how many increments.
        increments: usize,
        /// Part `[1]` of the peak load, in (0, 1], by which the load falls before the history ends.
        drop: f64,
    },
}

impl ProgressiveModel {
    /// The model of a point of `laminate`.
    ///
    /// # Errors
    /// [`ProgressiveError`] for a missing strength, or strengths whose yield surface is open.
    pub fn point(&self, laminate: Laminate) -> Result<Arc<dyn PointModel>, ProgressiveError> {
        self.parameters.model(laminate, &self.criterion)
    }
}

/// `[failure.progressive]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ProgressiveFormat {
    pub(crate) body: Option<String>,
    /// `model.NAME = { … }`, read by the registry of point models.
    pub(crate) model: Value,
    pub(crate) crack_band: Option<CrackBandFormat>,
    #[serde(default)]
    pub(crate) control: ControlFormat,
}

/// `[failure.progressive.crack_band]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CrackBandFormat {
    pub(crate) fibre_tension: Option<Quantity<FractureEnergy>>,
    pub(crate) fibre_compression: Option<Quantity<FractureEnergy>>,
    pub(crate) matrix_tension: Option<Quantity<FractureEnergy>>,
    pub(crate) matrix_compression: Option<Quantity<FractureEnergy>>,
    pub(crate) shear: Option<Quantity<FractureEnergy>>,
}

/// `control.NAME = { … }`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum ControlFormat {
    Loads(LoadsFormat),
    Displacement(DisplacementFormat),
}

impl Default for ControlFormat {
    fn default() -> Self {
        Self::Loads(LoadsFormat::default())
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LoadsFormat {
    #[serde(default = "default_load_increments")]
    pub(crate) increments: usize,
}

impl LoadsFormat {
    pub(crate) fn control(&self) -> Control {
        let Self { increments } = *self;
        Control::Loads { increments }
    }
}

impl Default for LoadsFormat {
    fn default() -> Self {
        Self {
            increments: default_load_increments(),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DisplacementFormat {
    pub(crate) on: String,
    #[serde(default = "default_axis")]
    pub(crate) axis: Axis,
    pub(crate) end: Quantity<Length>,
    #[serde(default = "default_increments")]
    pub(crate) increments: usize,
    #[serde(default = "default_drop")]
    pub(crate) drop: f64,
}

impl DisplacementFormat {
    pub(crate) fn control(&self, on: SetRef) -> Control {
        let Self {
            on: _,
            axis,
            end,
            increments,
            drop,
        } = self;
        Control::Displacement {
            on,
            axis: *axis,
            end: end.value(),
            increments: *increments,
            drop: *drop,
        }
    }
}

const fn default_load_increments() -> usize {
    10
}

const fn default_increments() -> usize {
    40
}

const fn default_axis() -> Axis {
    Axis::X
}

const fn default_drop() -> f64 {
    0.3
}

const NOT_ZERO: Range = numbers(", not 0", "not 0; its sign is the direction", |value| {
    value != 0.0
});

const PART: Range = numbers(" in (0, 1]", "greater than 0, at most 1", |value| {
    value > 0.0 && value <= 1.0
});

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("failure.progressive", &[
        described("body", "body", "the only one of `failure.bodies`", r#""coupon""#,
            "the body whose plies fail; one contact touches its hole"),
        names("model", models, REQUIRED, ".ply_discount = { fibre = 0.01, matrix = 0.1 }",
            "how plies lose stiffness: the point model by name, with its parameters; those of other crates too"),
        table("crack_band", NONE, "fracture energies that scale strengths with the cells, by ply discount only"),
        table_as("control", "the loads, in 10 increments each", ".loads = {}", "what is raised"),
    ]),
    Table::new("failure.progressive.crack_band", &[
        energy("fibre_tension", NONE, r#""90 kJ/m2""#, "fibres in tension").range(POSITIVE),
        energy("fibre_compression", NONE, r#""80 kJ/m2""#, "fibres in compression").range(POSITIVE),
        energy("matrix_tension", NONE, r#""0.25 kJ/m2""#, "matrix in tension across the fibres").range(POSITIVE),
        energy("matrix_compression", NONE, r#""0.8 kJ/m2""#, "matrix in compression across the fibres").range(POSITIVE),
        energy("shear", NONE, r#""0.8 kJ/m2""#, "matrix in shear").range(POSITIVE),
    ]),
    Table::new("failure.progressive.control", &[
        table("loads", NONE, "the scene's loads, step by step, to the strength"),
        table("displacement", NONE, "an edge or point is driven in place of the load on it, past the peak"),
    ]),
    Table::new("failure.progressive.control.loads", &[
        integer("increments", "`10`", "20", "increments of each load step").range(counts(1, 10_000)),
    ]),
    Table::new("failure.progressive.control.displacement", &[
        set("on", REQUIRED, r#""plate.left""#,
            "the edge or point that is driven, of an elastic body; a support or platen there gives way along the axis"),
        described("axis", r#"`"x"`, `"y"`"#, r#"`"x"`"#, r#""y""#, "axis of the drive"),
        length("end", REQUIRED, r#""-0.4 mm""#, "displacement at the end").range(NOT_ZERO),
        integer("increments", "`40`", "60",
            "increments of the history, cut where many plies fail at once").range(counts(1, 10_000)),
        number("drop", "`0.3`", "0.5",
            "part of the peak load by which the load falls before the history ends, as in bearing tests (ASTM D5961)").range(PART),
    ]),
];

/// The registered point models, each a table.
fn models() -> String {
    let names = stickslip_laminate::progressive::point_models().map(|own| own.name);
    format!("table {}", coded(names))
}
