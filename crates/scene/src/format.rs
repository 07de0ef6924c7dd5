//! The scene as a file spells it, key by key.
//!
//! Field names are the keys. Unknown keys are refused, every quantity carries its unit, and choices are externally tagged
//! (`shape.disk = { … }`). Serialising gives the scene with all defaults filled in.

mod fasteners;
mod laminate;
mod loads;
mod progressive;

use std::collections::BTreeMap;

use serde::{Deserialize, Serialize};
use serde_json::Value;
use stickslip_fem_core::mesh::ElementKind;

use super::schema::{Analysis, Axis, BodyModel, DisplayUnits, GapKind, Output, ProjectionChoice};
use crate::shape::ShapeFormat;
use crate::shape::pattern::PatternFormat;
use crate::units::{
    Angle, AngleOrLength, BedStiffness, Force, Length, PerTemperature, Quantity, SpringStiffness,
    Stress, UnitName,
};
pub(super) use fasteners::{
    EndFormat, FastenerFormat, FormulaFormat, JointFormat, LumpedFormat, SpringsFormat,
};
pub(super) use laminate::{
    CharacteristicFormat, DiscountFormat, EnvelopesFormat, FailureFormat, LaminateFormat,
    PlyFormat, StrengthsFormat, default_interaction, default_shear_weight,
};
pub(super) use loads::{
    BearingFormat, ForceFormat, LoadFormat, PolarTractionFormat, PressureFormat, TemperatureFormat,
};
pub(super) use progressive::{
    ControlFormat, CrackBandFormat, DisplacementFormat, LoadsFormat, ProgressiveFormat,
};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SceneFormat {
    pub(super) version: u64,
    pub(super) title: Option<String>,
    pub(super) description: Option<String>,
    #[serde(default)]
    pub(super) units: UnitsFormat,
    #[serde(default)]
    pub(super) analysis: Analysis,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) plies: BTreeMap<String, PlyFormat>,
    #[serde(default)]
    pub(super) materials: BTreeMap<String, MaterialFormat>,
    pub(super) bodies: BTreeMap<String, BodyFormat>,
    pub(super) mesh: Option<MeshFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) contacts: Vec<ContactFormat>,
    #[serde(default, skip_serializing_if = "BTreeMap::is_empty")]
    pub(super) fasteners: BTreeMap<String, FastenerFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) supports: Vec<SupportFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) platens: Vec<PlatenFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) loads: Vec<LoadFormat>,
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub(super) edges: Vec<EdgeFormat>,
    pub(super) failure: Option<FailureFormat>,
    #[serde(default)]
    pub(super) output: Output,
}

/// `[units]`: what results are shown in; base units where a key is missing.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub struct UnitsFormat {
    length: UnitName<Length>,
    force: UnitName<Force>,
    stress: UnitName<Stress>,
}

impl UnitsFormat {
    /// The units of results.
    pub fn display(&self) -> DisplayUnits {
        let Self {
            length,
            force,
            stress,
        } = self;
        DisplayUnits {
            length: length.unit(),
            force: force.unit(),
            stress: stress.unit(),
        }
    }
}

impl Default for UnitsFormat {
    fn default() -> Self {
        Self {
            length: UnitName::base(),
            force: UnitName::base(),
            stress: UnitName::base(),
        }
    }
}

/// `[materials.NAME.isotropic]`, `[materials.NAME.orthotropic]` or `[materials.NAME.laminate]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(super) enum MaterialFormat {
    Isotropic(IsotropicFormat),
    Orthotropic(Box<OrthotropicFormat>),
    Laminate(Box<LaminateFormat>),
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct IsotropicFormat {
    pub(super) young: Quantity<Stress>,
    pub(super) poisson: f64,
    pub(super) expansion: Option<Quantity<PerTemperature>>,
    #[serde(rename = "yield")]
    pub(super) yield_stress: Option<Quantity<Stress>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct OrthotropicFormat {
    pub(super) e1: Quantity<Stress>,
    pub(super) e2: Quantity<Stress>,
    pub(super) g12: Quantity<Stress>,
    pub(super) nu12: f64,
    pub(super) angle: Option<Quantity<Angle>>,
    pub(super) expansion1: Option<Quantity<PerTemperature>>,
    pub(super) expansion2: Option<Quantity<PerTemperature>>,
    pub(super) e3: Option<Quantity<Stress>>,
    pub(super) nu13: Option<f64>,
    pub(super) nu23: Option<f64>,
    pub(super) expansion3: Option<Quantity<PerTemperature>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct BodyFormat {
    pub(super) material: Option<String>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(super) rigid: bool,
    pub(super) thickness: Option<Quantity<Length>>,
    pub(super) shape: ShapeFormat,
    pub(super) position: Option<[Quantity<Length>; 2]>,
    pub(super) angle: Option<Quantity<Angle>>,
    #[serde(default, skip_serializing_if = "BodyModel::is_auto")]
    pub(super) model: BodyModel,
    pub(super) mesh: Option<MeshFormat>,
    pub(super) pattern: Option<PatternFormat>,
}

/// `[mesh]`, or what differs from it in `[bodies.NAME.mesh]`.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct MeshFormat {
    pub(super) element: Option<ElementKind>,
    pub(super) spacing: Option<Quantity<AngleOrLength>>,
    pub(super) angles: Option<Vec<Quantity<Angle>>>,
    pub(super) fine_to: Option<Quantity<AngleOrLength>>,
    pub(super) coarse_spacing: Option<Quantity<AngleOrLength>>,
    pub(super) layers: Option<usize>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct ContactFormat {
    pub(super) name: Option<String>,
    pub(super) first: String,
    pub(super) second: String,
    #[serde(default)]
    pub(super) gap: GapKind,
    #[serde(default)]
    pub(super) projection: ProjectionChoice,
    #[serde(default)]
    pub(super) interference: bool,
    pub(super) friction: Option<Value>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SupportFormat {
    pub(super) on: String,
    pub(super) fix: Option<Vec<Axis>>,
    pub(super) normal: Option<Quantity<Angle>>,
    pub(super) displacement: Option<Quantity<Length>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) stiffness: Option<Quantity<SpringStiffness>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) bed: Option<Quantity<BedStiffness>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PlatenFormat {
    pub(super) on: String,
    pub(super) free: Vec<Axis>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(super) struct EdgeFormat {
    pub(super) on: String,
}
