//! Progressive failure of a joint, as a file spells it.

use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::schema::Axis;
use crate::units::{FractureEnergy, Length, Quantity};

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
