//! Plies, laminates and the settings of their failure analysis, as a file spells it.

use serde::{Deserialize, Serialize};

use super::ProgressiveFormat;
use crate::schema::EnvelopePlane;
use crate::units::{Angle, Length, PerTemperature, Quantity, Stress, Temperature};

/// `[plies.NAME]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct PlyFormat {
    pub(crate) e1: Quantity<Stress>,
    pub(crate) e2: Quantity<Stress>,
    pub(crate) g12: Quantity<Stress>,
    pub(crate) nu12: f64,
    pub(crate) thickness: Quantity<Length>,
    pub(crate) expansion1: Option<Quantity<PerTemperature>>,
    pub(crate) expansion2: Option<Quantity<PerTemperature>>,
    pub(crate) strengths: Option<StrengthsFormat>,
}

/// `[plies.NAME.strengths]`: magnitudes, each where it is known.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct StrengthsFormat {
    pub(crate) xt: Option<Quantity<Stress>>,
    pub(crate) xc: Option<Quantity<Stress>>,
    pub(crate) yt: Option<Quantity<Stress>>,
    pub(crate) yc: Option<Quantity<Stress>>,
    pub(crate) s12: Option<Quantity<Stress>>,
    pub(crate) zt: Option<Quantity<Stress>>,
    pub(crate) zc: Option<Quantity<Stress>>,
    pub(crate) s13: Option<Quantity<Stress>>,
    pub(crate) s23: Option<Quantity<Stress>>,
    pub(crate) strain_1t: Option<f64>,
    pub(crate) strain_1c: Option<f64>,
    pub(crate) strain_2t: Option<f64>,
    pub(crate) strain_2c: Option<f64>,
    pub(crate) strain_12: Option<f64>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) linear_strain_limits: bool,
}

/// `[materials.NAME.laminate]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct LaminateFormat {
    pub(crate) layup: String,
    pub(crate) ply: Option<String>,
    pub(crate) angle: Option<Quantity<Angle>>,
    pub(crate) cure: Option<Quantity<Temperature>>,
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub(crate) held_flat: bool,
}

/// `[failure]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct FailureFormat {
    pub(crate) criteria: Vec<String>,
    pub(crate) bodies: Option<Vec<String>>,
    pub(crate) clear_of_supports: Option<Quantity<Length>>,
    #[serde(default = "default_interaction")]
    pub(crate) tsai_wu_interaction: f64,
    #[serde(default = "default_shear_weight")]
    pub(crate) hashin_shear_weight: f64,
    pub(crate) characteristic: Option<CharacteristicFormat>,
    pub(crate) envelopes: Option<EnvelopesFormat>,
    pub(crate) progressive: Option<ProgressiveFormat>,
}

/// `[failure.characteristic]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct CharacteristicFormat {
    pub(crate) tension: Quantity<Length>,
    pub(crate) compression: Quantity<Length>,
}

/// `[failure.envelopes]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(default, deny_unknown_fields)]
pub(crate) struct EnvelopesFormat {
    pub(crate) planes: Vec<EnvelopePlane>,
    pub(crate) directions: usize,
    pub(crate) last_ply: Option<DiscountFormat>,
}

/// `[failure.envelopes.last_ply]`.
#[derive(Debug, Clone, Copy, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct DiscountFormat {
    pub(crate) fibre: f64,
    pub(crate) matrix: f64,
}

impl Default for EnvelopesFormat {
    fn default() -> Self {
        Self {
            planes: vec![EnvelopePlane::Normal, EnvelopePlane::Shear],
            directions: 180,
            last_ply: None,
        }
    }
}

pub(crate) const fn default_interaction() -> f64 {
    -0.5
}

pub(crate) const fn default_shear_weight() -> f64 {
    1.0
}
