//! Settings of the failure analysis of laminates.

use super::progressive::ProgressiveFormat;
use super::{Control, Progressive};
use crate::declaration::choices::quoted;
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Range, Table, counts, described, filled, integer, length, names,
    number, numbers, table,
};
use crate::units::{Length, Quantity};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stickslip_laminate::{Degradation, FailureCriterion};

/// The question of `[failure]`.
#[derive(Debug, Clone)]
pub struct Failure {
    /// Criteria, at least one; every ply of the bodies has the strengths that they ask for. The first one is drawn.
    pub criteria: Vec<Arc<dyn FailureCriterion>>,
    /// Bodies of a laminate, at least one, in the order of their names.
    pub bodies: Vec<String>,
    /// Distance from the ends of supports within which no ply is checked `[mm]`, at least 0; a part of the body's size where not given.
    pub clear_of_supports: Option<f64>,
    /// Hypotheses on stresses at a distance from the hole.
    pub characteristic: Option<Characteristic>,
    /// Failure envelopes of the bodies' laminates.
    pub envelopes: Option<Envelopes>,
    /// Failure of a joint, followed until its load path is lost.
    pub progressive: Option<Progressive>,
}

impl Failure {
    /// Whether a joint is followed by a drive, which needs no load.
    pub fn is_driven(&self) -> bool {
        let control = self.progressive.as_ref().map(|asked| &asked.control);
        matches!(control, Some(Control::Displacement { .. }))
    }
}

/// Characteristic distances from the edge of a hole.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Characteristic {
    /// R_t, at the net section `[mm]`.
    pub tension: f64,
    /// R_c, at the bearing point `[mm]`.
    pub compression: f64,
}

/// Failure envelopes to compute.
#[derive(Debug, Clone, PartialEq)]
pub struct Envelopes {
    /// Their planes, at least one.
    pub planes: Vec<EnvelopePlane>,
    /// Number of directions of load in each, at least 3.
    pub directions: usize,
    /// How failed plies soften, where the last ply's failure is asked for as well.
    pub last_ply: Option<Degradation>,
}

/// Plane of the mean stresses of an envelope.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum EnvelopePlane {
    /// (σ_x, σ_y).
    Normal,
    /// (σ_x, τ_xy).
    Shear,
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

impl FailureFormat {
    /// The question, with what other tables are needed for.
    pub(crate) fn failure(
        &self,
        criteria: Vec<Arc<dyn FailureCriterion>>,
        bodies: Vec<String>,
        envelopes: Option<Envelopes>,
        progressive: Option<Progressive>,
    ) -> Failure {
        // What is named `_` makes what is handed in.
        let Self {
            criteria: _,
            bodies: _,
            clear_of_supports,
            tsai_wu_interaction: _,
            hashin_shear_weight: _,
            characteristic,
            envelopes: _,
            progressive: _,
        } = self;
        let characteristic = characteristic.as_ref();
        Failure {
            criteria,
            bodies,
            clear_of_supports: clear_of_supports.as_ref().map(Quantity::value),
            characteristic: characteristic.map(
                |CharacteristicFormat {
                     tension,
                     compression,
                 }| Characteristic {
                    tension: tension.value(),
                    compression: compression.value(),
                },
            ),
            envelopes,
            progressive,
        }
    }
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

impl EnvelopesFormat {
    pub(crate) fn envelopes(&self, last_ply: Option<Degradation>) -> Envelopes {
        let Self {
            planes,
            directions,
            last_ply: _,
        } = self;
        let mut planes = planes.clone();
        planes.dedup();
        Envelopes {
            planes,
            directions: *directions,
            last_ply,
        }
    }
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

const NOT_NEGATIVE: Range = numbers(" ≥ 0", "at least 0 mm", |value| value >= 0.0);

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("failure", &[
        names("criteria", criteria, REQUIRED, r#"["tsai_wu", "hashin"]"#,
            "one or more; the first one is drawn").range(filled(r#"at least one, such as ["max_stress"]"#)),
        described("bodies", "list of bodies", "all of a laminate", r#"["coupon"]"#,
            "bodies whose plies are checked").range(filled("at least one body; leave it out for all bodies of a laminate")),
        length("clear_of_supports", "5 % of the body's smaller outer dimension", r#""2 mm""#,
            "distance from the ends of supported edges and platens, and from points that are held, within which no ply is checked").range(NOT_NEGATIVE),
        number("tsai_wu_interaction", "`-0.5`", "0.0",
            "F12 of `tsai_wu` as a multiple of √(F11 F22)").noted(" between −1 and 1"),
        number("hashin_shear_weight", "`1.0`", "0.0", "weight of shear in fibre tension of `hashin`").noted(" from 0 to 1"),
        table("characteristic", NONE, "failure at a distance from the hole"),
        table("envelopes", NONE, "failure envelopes of the bodies' laminates"),
        table("progressive", NONE, "a pinned joint followed beyond the failure of its plies"),
    ]),
    Table::new("failure.characteristic", &[
        length("tension", REQUIRED, r#""1.8 mm""#, "R_t, at the net section").range(POSITIVE),
        length("compression", REQUIRED, r#""1.8 mm""#, "R_c, at the bearing point").range(POSITIVE),
    ]),
    Table::new("failure.envelopes", &[
        described("planes", r#"list of `"normal"`, `"shear"`"#, r#"`["normal","shear"]`"#, r#"["normal"]"#,
            "(σ_x, σ_y) and (σ_x, τ_xy)").range(filled(r#"at least one of "normal" and "shear""#)),
        integer("directions", "`180`", "360", "directions of load in each plane").range(counts(3, 100_000)),
        table("last_ply", NONE, "the last ply's failure as well, by ply discount"),
    ]),
    Table::new("failure.envelopes.last_ply", &[
        number("fibre", REQUIRED, "0.1", "on E1, after fibre failure; on E2 and G12 the smaller of both"),
        number("matrix", REQUIRED, "0.1", "on E2 and G12, after failure of the matrix"),
    ]),
];

/// The registered failure criteria.
fn criteria() -> String {
    let names = stickslip_laminate::failure::criteria().map(|own| own.name);
    format!("list of {}", quoted(names))
}
