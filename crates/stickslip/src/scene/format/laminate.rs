//! Plies, laminates and what is asked about their failure, as a file spells it.

use serde::{Deserialize, Serialize};

use super::{ProgressiveFormat, is_false};
use crate::scene::schema::EnvelopePlane;
use crate::units::{Angle, Length, PerTemperature, Quantity, Stress, Temperature};

/// `[plies.NAME]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct PlyFormat {
    pub(in crate::scene) e1: Quantity<Stress>,
    pub(in crate::scene) e2: Quantity<Stress>,
    pub(in crate::scene) g12: Quantity<Stress>,
    pub(in crate::scene) nu12: f64,
    pub(in crate::scene) thickness: Quantity<Length>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) expansion1: Option<Quantity<PerTemperature>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) expansion2: Option<Quantity<PerTemperature>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strengths: Option<StrengthsFormat>,
}

/// `[plies.NAME.strengths]`: magnitudes, each where it is known.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct StrengthsFormat {
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) xt: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) xc: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) yt: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) yc: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) s12: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) zt: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) zc: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) s13: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) s23: Option<Quantity<Stress>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strain_1t: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strain_1c: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strain_2t: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strain_2c: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) strain_12: Option<f64>,
    #[serde(default, skip_serializing_if = "is_false")]
    pub(in crate::scene) linear_strain_limits: bool,
}

/// `[materials.NAME.laminate]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct LaminateFormat {
    pub(in crate::scene) layup: String,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) ply: Option<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) angle: Option<Quantity<Angle>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) cure: Option<Quantity<Temperature>>,
    #[serde(default, skip_serializing_if = "is_false")]
    pub(in crate::scene) held_flat: bool,
}

/// `[failure]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct FailureFormat {
    pub(in crate::scene) criteria: Vec<String>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) bodies: Option<Vec<String>>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) clear_of_supports: Option<Quantity<Length>>,
    #[serde(default = "default_interaction")]
    pub(in crate::scene) tsai_wu_interaction: f64,
    #[serde(default = "default_shear_weight")]
    pub(in crate::scene) hashin_shear_weight: f64,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) characteristic: Option<CharacteristicFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) envelopes: Option<EnvelopesFormat>,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) progressive: Option<ProgressiveFormat>,
}

/// `[failure.characteristic]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct CharacteristicFormat {
    pub(in crate::scene) tension: Quantity<Length>,
    pub(in crate::scene) compression: Quantity<Length>,
}

/// `[failure.envelopes]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(
    default,
    deny_unknown_fields,
    expecting = "a table, such as { key = value }"
)]
pub(in crate::scene) struct EnvelopesFormat {
    pub(in crate::scene) planes: Vec<EnvelopePlane>,
    pub(in crate::scene) directions: usize,
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(in crate::scene) last_ply: Option<DiscountFormat>,
}

/// `[failure.envelopes.last_ply]`.
#[derive(Debug, Clone, Copy, Deserialize, Serialize)]
#[serde(deny_unknown_fields, expecting = "a table, such as { key = value }")]
pub(in crate::scene) struct DiscountFormat {
    pub(in crate::scene) fibre: f64,
    pub(in crate::scene) matrix: f64,
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

const fn default_interaction() -> f64 {
    -0.5
}

const fn default_shear_weight() -> f64 {
    1.0
}
