//! Loads as a file spells them.

use serde::{Deserialize, Serialize};

use crate::schema::BearingLaw;
use crate::units::{Force, Quantity, Stress, Temperature, UnitName};

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LoadFormat {
    pub(crate) name: Option<String>,
    pub(crate) on: String,
    pub(crate) force: Option<ForceFormat>,
    pub(crate) bearing: Option<BearingFormat>,
    pub(crate) pressure: Option<PressureFormat>,
    pub(crate) polar_traction: Option<PolarTractionFormat>,
    pub(crate) temperature: Option<TemperatureFormat>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct ForceFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BearingFormat {
    pub(crate) direction: Vec<f64>,
    pub(crate) law: BearingLaw,
    pub(crate) steps: Vec<Quantity<Force>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PressureFormat {
    pub(crate) steps: Vec<Quantity<Stress>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PolarTractionFormat {
    pub(crate) file: String,
    pub(crate) stress: UnitName<Stress>,
    #[serde(default = "default_theta")]
    pub(crate) theta: String,
    #[serde(default = "default_radial")]
    pub(crate) radial: String,
    #[serde(default = "default_shear")]
    pub(crate) shear: String,
    pub(crate) steps: Vec<f64>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct TemperatureFormat {
    pub(crate) steps: Vec<Quantity<Temperature>>,
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
