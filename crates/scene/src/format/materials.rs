//! Plies and materials as a file spells them.

use serde::{Deserialize, Serialize};

use crate::declaration::{
    POSITIVE, REQUIRED, Table, angle, expansion, flag, length, number, stress, table, temperature,
    text, words,
};
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

/// `[materials.NAME.isotropic]`, `[materials.NAME.orthotropic]` or `[materials.NAME.laminate]`.
#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum MaterialFormat {
    Isotropic(IsotropicFormat),
    Orthotropic(Box<OrthotropicFormat>),
    Laminate(Box<LaminateFormat>),
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct IsotropicFormat {
    pub(crate) young: Quantity<Stress>,
    pub(crate) poisson: f64,
    pub(crate) expansion: Option<Quantity<PerTemperature>>,
    #[serde(rename = "yield")]
    pub(crate) yield_stress: Option<Quantity<Stress>>,
}

#[derive(Debug, Clone, Deserialize, Serialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct OrthotropicFormat {
    pub(crate) e1: Quantity<Stress>,
    pub(crate) e2: Quantity<Stress>,
    pub(crate) g12: Quantity<Stress>,
    pub(crate) nu12: f64,
    pub(crate) angle: Option<Quantity<Angle>>,
    pub(crate) expansion1: Option<Quantity<PerTemperature>>,
    pub(crate) expansion2: Option<Quantity<PerTemperature>>,
    pub(crate) e3: Option<Quantity<Stress>>,
    pub(crate) nu13: Option<f64>,
    pub(crate) nu23: Option<f64>,
    pub(crate) expansion3: Option<Quantity<PerTemperature>>,
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

#[rustfmt::skip]
pub(crate) const TABLES: &[Table] = &[
    Table::new("plies.NAME", &[
        stress("e1", REQUIRED, r#""140 GPa""#, "E1, along the fibres").noted(" > 0"),
        stress("e2", REQUIRED, r#""9 GPa""#, "E2, across them").noted(" > 0"),
        stress("g12", REQUIRED, r#""5 GPa""#, "shear modulus G12").noted(" > 0"),
        number("nu12", REQUIRED, "0.3", "ν12, |ν12| < √(E1/E2)"),
        length("thickness", REQUIRED, r#""0.125 mm""#, "thickness of the cured ply").noted(" > 0"),
        expansion("expansion1", "0", r#""0.02e-6 1/K""#, "along the fibres"),
        expansion("expansion2", "0", r#""22.5e-6 1/K""#, "across them"),
        table("strengths", "none known", "strengths, as far as they are known"),
    ]),
    Table::new("plies.NAME.strengths", &[
        stress("xt", "not known", r#""1500 MPa""#, "tension along the fibres").noted(" > 0"),
        stress("xc", "not known", r#""1200 MPa""#, "compression along the fibres").noted(" > 0"),
        stress("yt", "not known", r#""50 MPa""#, "tension across the fibres").noted(" > 0"),
        stress("yc", "not known", r#""200 MPa""#, "compression across the fibres").noted(" > 0"),
        stress("s12", "not known", r#""70 MPa""#, "shear in the plane").noted(" > 0"),
        stress("zt", "not known", r#""50 MPa""#, "tension through the thickness").noted(" > 0"),
        stress("zc", "not known", r#""200 MPa""#, "compression through the thickness").noted(" > 0"),
        stress("s13", "not known", r#""70 MPa""#, "shear in the 1–3 plane").noted(" > 0"),
        stress("s23", "not known", r#""100 MPa""#, "shear in the 2–3 plane, often taken as yc/2").noted(" > 0"),
        number("strain_1t", "not known", "0.0105", "strain in tension along the fibres").noted(" > 0"),
        number("strain_1c", "not known", "0.0085", "strain in compression along the fibres").noted(" > 0"),
        number("strain_2t", "not known", "0.005", "strain in tension across the fibres").noted(" > 0"),
        number("strain_2c", "not known", "0.02", "strain in compression across the fibres").noted(" > 0"),
        number("strain_12", "not known", "0.014", "engineering shear strain in the plane").noted(" > 0"),
        flag("linear_strain_limits", "`false`", "true", "strain limits that are not given are strength over modulus"),
    ]),
    Table::new("materials.NAME", &[
        table("isotropic", "one of the three", "the same in all directions"),
        table("orthotropic", "one of the three", "three planes of symmetry, such as a ply, or a laminate as a whole"),
        table("laminate", "one of the three", "a stack of plies"),
    ]).choice(),
    Table::new("materials.NAME.isotropic", &[
        stress("young", REQUIRED, r#""70 GPa""#, "Young's modulus E").range(POSITIVE),
        number("poisson", REQUIRED, "0.3", "Poisson's ratio ν, −1 < ν ≤ 0.5, in plane strain < 0.5"),
        expansion("expansion", "0", r#""2.3e-5 1/K""#, "coefficient of thermal expansion"),
        stress("yield", "not known", r#""350 MPa""#,
            "von Mises stress at which it yields: results say where and in which step a body reaches it, and stay elastic beyond").range(POSITIVE),
    ]),
    Table::new("materials.NAME.orthotropic", &[
        stress("e1", REQUIRED, r#""140 GPa""#, "E1").range(POSITIVE),
        stress("e2", REQUIRED, r#""9 GPa""#, "E2").range(POSITIVE),
        stress("g12", REQUIRED, r#""5 GPa""#, "shear modulus G12").range(POSITIVE),
        number("nu12", REQUIRED, "0.3", "ν12, |ν12| < √(E1/E2)"),
        angle("angle", "0 deg", r#""45 deg""#, "direction of the 1-axis from +x"),
        expansion("expansion1", "0", r#""-0.9e-6 1/K""#, "along the 1-axis"),
        expansion("expansion2", "0", r#""27e-6 1/K""#, "along the 2-axis"),
        stress("e3", "required in plane strain", r#""9 GPa""#, "E3, through the thickness").range(POSITIVE),
        number("nu13", "required in plane strain", "0.3", "ν13"),
        number("nu23", "required in plane strain", "0.4", "ν23"),
        expansion("expansion3", "0", r#""27e-6 1/K""#, "along the 3-axis; matters in plane strain"),
    ]),
    Table::new("materials.NAME.laminate", &[
        text("layup", REQUIRED, r#""[0/±45/90]s""#,
            "the stack; one that is not symmetric bends when it is stretched and is refused with the size of that coupling"),
        words("ply", "name of a ply", "required, unless the lay-up names all, as in `[0:carbon/90:glass]s`", r#""carbon""#,
            "the ply wherever the lay-up names none"),
        angle("angle", "0 deg", r#""30 deg""#, "direction of the lay-up's 0° from +x"),
        temperature("cure", "0 K", r#""-150 K""#,
            "temperature since the plies were free of stress, usually since the cure and negative; what stays in the plies is \
            held while loads grow"),
        flag("held_flat", "`false`", "true", "accepts a lay-up that is not symmetric, because something holds the plate flat"),
    ]),
];
