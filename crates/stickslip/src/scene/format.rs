//! The scene as a file spells it, key by key.
//!
//! Field names are the keys. Unknown keys are refused, every quantity carries its unit, and choices are externally tagged
//! (`shape.disk = { … }`). Serialising gives the scene with all defaults filled in.

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use stickslip_fem_core::ElementKind;
use stickslip_fem_core::material::PlaneState;

use super::schema::{Axis, FieldOutput, GapKind, ModelChoice, Ramp, SolverChoice};
use crate::units::{
    Angle, AngleOrLength, Force, Length, PerTemperature, Quantity, Stress, Temperature, UnitError,
    UnitName,
};

/// Optional keys are left out where they are empty.
macro_rules! optional {
    ($(#[$attribute:meta])* $name:ident { $($(#[$field_attribute:meta])* $field:ident: $kind:ty,)* }) => {
        $(#[$attribute])*
        #[derive(Debug, Clone, Deserialize, Serialize)]
        #[serde(deny_unknown_fields, expecting = "a table, for example { key = value }")]
        pub(super) struct $name { $($(#[$field_attribute])* pub(super) $field: $kind,)* }
    };
}

optional!(SceneFormat {
    version: u64,
    #[serde(skip_serializing_if = "Option::is_none")]
    title: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    description: Option<String>,
    #[serde(default)]
    units: UnitsFormat,
    #[serde(default)]
    analysis: AnalysisFormat,
    #[serde(default)]
    materials: BTreeMap<String, MaterialFormat>,
    bodies: BTreeMap<String, BodyFormat>,
    mesh: MeshFormat,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    contacts: Vec<ContactFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    supports: Vec<SupportFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    platens: Vec<PlatenFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    loads: Vec<LoadFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    edges: Vec<EdgeFormat>,
    #[serde(default)]
    output: OutputFormat,
});
