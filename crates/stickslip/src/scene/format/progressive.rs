//! Progressive failure of a joint, as a file spells it.

use serde::{Deserialize, Serialize};

use crate::scene::schema::Axis;
use crate::units::{FractureEnergy, Length, Quantity, Stress};

/// `[failure.progressive]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct ProgressiveFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) body: Option<String>,
    pub(in crate::scene) model: ModelFormat,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) crack_band: Option<CrackBandFormat>,
    #[serde(default)]
    pub(in crate::scene) control: ControlFormat,
}

/// `model.NAME = { … }`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::scene) enum ModelFormat {
    PlyDiscount(PlyDiscountFormat),
    Plasticity(PlasticityFormat),
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct PlyDiscountFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) criterion: Option<String>,
    pub(in crate::scene) fibre: f64,
    pub(in crate::scene) matrix: f64,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct PlasticityFormat {
    pub(in crate::scene) hardening: Quantity<Stress>,
}

/// `[failure.progressive.crack_band]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct CrackBandFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) fibre_tension: Option<Quantity<FractureEnergy>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) fibre_compression: Option<Quantity<FractureEnergy>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) matrix_tension: Option<Quantity<FractureEnergy>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) matrix_compression: Option<Quantity<FractureEnergy>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) shear: Option<Quantity<FractureEnergy>>,
}

/// `control.NAME = { … }`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(in crate::scene) enum ControlFormat {
    Loads(LoadsFormat),
    Displacement(DisplacementFormat),
}

impl Default for ControlFormat {
    fn default() -> Self {
        Self::Loads(LoadsFormat::default())
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct LoadsFormat {
    #[serde(default = "default_load_increments")]
    pub(in crate::scene) increments: usize,
}

impl Default for LoadsFormat {
    fn default() -> Self {
        Self {
            increments: default_load_increments(),
        }
    }
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct DisplacementFormat {
    pub(in crate::scene) on: String,
    #[serde(default = "default_axis")]
    pub(in crate::scene) axis: Axis,
    pub(in crate::scene) end: Quantity<Length>,
    #[serde(default = "default_increments")]
    pub(in crate::scene) increments: usize,
    #[serde(default = "default_drop")]
    pub(in crate::scene) drop: f64,
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
