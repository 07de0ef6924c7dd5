//! Loads as a file spells them.

use serde::{Deserialize, Serialize};

use crate::scene::schema::BearingLaw;
use crate::units::{Force, Quantity, Stress, Temperature, UnitName};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct LoadFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) name: Option<String>,
    pub(in crate::scene) on: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) force: Option<ForceFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) bearing: Option<BearingFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) pressure: Option<PressureFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) polar_traction: Option<PolarTractionFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) temperature: Option<TemperatureFormat>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct ForceFormat {
    pub(in crate::scene) direction: Vec<f64>,
    pub(in crate::scene) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct BearingFormat {
    pub(in crate::scene) direction: Vec<f64>,
    pub(in crate::scene) law: BearingLaw,
    pub(in crate::scene) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct PressureFormat {
    pub(in crate::scene) steps: Vec<Quantity<Stress>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct PolarTractionFormat {
    pub(in crate::scene) file: String,
    pub(in crate::scene) stress: UnitName<Stress>,
    #[serde(default = "default_theta")]
    pub(in crate::scene) theta: String,
    #[serde(default = "default_radial")]
    pub(in crate::scene) radial: String,
    #[serde(default = "default_shear")]
    pub(in crate::scene) shear: String,
    pub(in crate::scene) steps: Vec<f64>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct TemperatureFormat {
    pub(in crate::scene) steps: Vec<Quantity<Temperature>>,
}

fn default_theta() -> String {
    "theta_deg".to_owned()
}

fn default_radial() -> String {
    "sigma_r".to_owned()
}

fn default_shear() -> String {
    "tau_rtheta".to_owned()
}
