//! The failure analysis of laminates as a file spells it.

use serde::{Deserialize, Serialize};

use super::ProgressiveFormat;
use crate::declaration::choices::quoted;
use crate::declaration::{
    NONE, POSITIVE, REQUIRED, Range, Table, counts, filled, integer, length, names, number,
    numbers, table, words,
};
use crate::schema::EnvelopePlane;
use crate::units::{Length, Quantity};

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

const NOT_NEGATIVE: Range = numbers(" ≥ 0", "at least 0 mm", |value| value >= 0.0);

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("failure", &[
        names("criteria", criteria, REQUIRED, r#"["tsai_wu", "hashin"]"#,
            "one or more; the first one is drawn").range(filled(r#"at least one, such as ["max_stress"]"#)),
        words("bodies", "list of bodies", "all of a laminate", r#"["coupon"]"#,
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
        words("planes", r#"list of `"normal"`, `"shear"`"#, r#"`["normal","shear"]`"#, r#"["normal"]"#,
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
