//! Elastic constants of a scene.

use crate::declaration::{
    POSITIVE, REQUIRED, Table, angle, described, expansion, flag, length, number, stress, table,
    temperature, text,
};
use crate::units::{Angle, Length, Measure, PerTemperature, Quantity, Stress, Temperature};
use serde::{Deserialize, Serialize};
use std::sync::Arc;
use stickslip_fem_core::material::{
    self, Isotropic, Material as _, MaterialError, Orthotropic, OrthotropicConstants, PlaneState,
};
use stickslip_friction::PlyFraction;
use stickslip_laminate::{Laminate, LaminateMembrane};

/// Constants of a material.
#[derive(Debug, Clone, PartialEq)]
pub enum Material {
    /// The same in all directions.
    Isotropic {
        /// Young's modulus `[MPa]`.
        young: f64,
        /// Poisson's ratio `[1]`.
        poisson: f64,
        /// Coefficient of thermal expansion `[1/K]`.
        expansion: f64,
        /// Von Mises stress at which it yields `[MPa]`, where it is known. The material stays elastic beyond.
        yield_stress: Option<f64>,
    },
    /// Three planes of symmetry.
    Orthotropic {
        /// In-plane constants: moduli `[MPa]` and Poisson's ratio `[1]`.
        constants: OrthotropicConstants,
        /// Direction of the 1-axis, counter-clockwise from +x `[rad]`.
        angle: f64,
        /// Coefficients of thermal expansion along 1 and 2 `[1/K]`.
        expansion: [f64; 2],
        /// What plane strain needs beside.
        out_of_plane: Option<OutOfPlane>,
    },
    /// A stack of plies, in plane stress.
    Laminate(Arc<LaminateSheet>),
}

/// A laminate as a scene uses it: in its plane.
#[derive(Debug, Clone, PartialEq)]
pub struct LaminateSheet {
    /// The lay-up as the scene has it.
    pub layup: String,
    /// The laminate in the scene's axes: its angles are from +x, those of the lay-up plus [`angle`](Self::angle).
    pub laminate: Laminate,
    /// Its membrane stiffness and expansion.
    pub membrane: LaminateMembrane,
    /// Direction of the lay-up's 0° from +x `[rad]`.
    pub angle: f64,
    /// Temperature since the plies were free of stress `[K]`, usually negative.
    pub cure: f64,
}

pub use stickslip_fem_core::material::OutOfPlane;

impl LaminateSheet {
    /// Fraction of the thickness per fibre angle from the lay-up's 0°, as the fibre-coverage law takes them.
    pub fn ply_fractions(&self) -> Vec<PlyFraction> {
        let mut fractions = self.laminate.ply_fractions();
        for fraction in &mut fractions {
            fraction.angle -= self.angle;
        }
        fractions
    }
}

impl Material {
    /// The material as elements see it. Orthotropic constants for plane strain that are not there are taken as an error of the
    /// modulus e3. A laminate is in plane stress whatever `plane` says; the scene's reader refuses plane strain.
    ///
    /// # Errors
    /// [`MaterialError`] for constants that no stable material has.
    pub fn in_plane(
        &self,
        plane: PlaneState,
    ) -> Result<Box<dyn material::Material>, MaterialError> {
        match *self {
            Self::Laminate(ref sheet) => Ok(Box::new(sheet.membrane)),
            Self::Isotropic {
                young,
                poisson,
                expansion,
                yield_stress: _,
            } => Ok(Box::new(
                Isotropic::new(young, poisson, plane)?.with_expansion(expansion)?,
            )),
            Self::Orthotropic {
                constants,
                angle,
                expansion: [first, second],
                out_of_plane,
            } => {
                let made = match (plane, out_of_plane) {
                    (PlaneState::Stress, _) => Orthotropic::new(constants, angle)?,
                    (PlaneState::Strain, Some(other)) => {
                        Orthotropic::plane_strain(constants, other, angle)?
                    }
                    (PlaneState::Strain, None) => {
                        return Err(MaterialError::Modulus {
                            name: "e3",
                            value: f64::NAN,
                        });
                    }
                };
                Ok(Box::new(made.with_expansion(first, second)?))
            }
        }
    }

    /// The laminate, if it is one.
    pub fn laminate(&self) -> Option<&Arc<LaminateSheet>> {
        match self {
            Self::Laminate(sheet) => Some(sheet),
            Self::Isotropic { .. } | Self::Orthotropic { .. } => None,
        }
    }

    /// Von Mises stress at which it yields `[MPa]`, where it is known.
    pub fn yield_stress(&self) -> Option<f64> {
        match self {
            Self::Isotropic { yield_stress, .. } => *yield_stress,
            Self::Orthotropic { .. } | Self::Laminate(_) => None,
        }
    }

    /// Direction of the 1-axis or of the lay-up's 0° from +x `[rad]`; 0 for isotropic materials.
    pub fn angle(&self) -> f64 {
        match self {
            Self::Laminate(sheet) => sheet.angle,
            Self::Isotropic { .. } => 0.0,
            Self::Orthotropic { angle, .. } => *angle,
        }
    }

    /// Whether any coefficient of thermal expansion differs from zero.
    pub fn expands(&self) -> bool {
        match self {
            Self::Laminate(sheet) => sheet.membrane.thermal_strain(1.0) != [0.0; 3],
            Self::Isotropic { expansion, .. } => *expansion != 0.0,
            Self::Orthotropic { expansion, .. } => expansion.iter().any(|value| *value != 0.0),
        }
    }
}

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

impl IsotropicFormat {
    pub(crate) fn material(&self) -> Material {
        let Self {
            young,
            poisson,
            expansion,
            yield_stress,
        } = self;
        Material::Isotropic {
            young: young.value(),
            poisson: *poisson,
            expansion: or_zero(expansion.as_ref()),
            yield_stress: yield_stress.as_ref().map(Quantity::value),
        }
    }
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

impl OrthotropicFormat {
    pub(crate) fn material(&self) -> Material {
        let Self {
            e1,
            e2,
            g12,
            nu12,
            angle,
            expansion1,
            expansion2,
            e3,
            nu13,
            nu23,
            expansion3,
        } = self;
        let out_of_plane = match (e3, *nu13, *nu23) {
            (Some(e3), Some(nu13), Some(nu23)) => Some(OutOfPlane {
                e3: e3.value(),
                nu13,
                nu23,
                alpha3: or_zero(expansion3.as_ref()),
            }),
            _ => None,
        };
        Material::Orthotropic {
            constants: OrthotropicConstants {
                e1: e1.value(),
                e2: e2.value(),
                g12: g12.value(),
                nu12: *nu12,
            },
            angle: or_zero(angle.as_ref()),
            expansion: [expansion1, expansion2].map(|own| or_zero(own.as_ref())),
            out_of_plane,
        }
    }

    /// Keys that plane strain needs and that are not given.
    pub(crate) fn missing_out_of_plane(&self) -> impl Iterator<Item = &'static str> {
        let present = [
            ("e3", self.e3.is_some()),
            ("nu13", self.nu13.is_some()),
            ("nu23", self.nu23.is_some()),
        ];
        present
            .into_iter()
            .filter_map(|(name, is_given)| (!is_given).then_some(name))
    }
}

fn or_zero<M: Measure>(given: Option<&Quantity<M>>) -> f64 {
    given.map_or(0.0, Quantity::value)
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
        described("ply", "name of a ply", "required, unless the lay-up names all, as in `[0:carbon/90:glass]s`", r#""carbon""#,
            "the ply wherever the lay-up names none"),
        angle("angle", "0 deg", r#""30 deg""#, "direction of the lay-up's 0° from +x"),
        temperature("cure", "0 K", r#""-150 K""#,
            "temperature since the plies were free of stress, usually since the cure and negative; what stays in the plies is \
            held while loads grow"),
        flag("held_flat", "`false`", "true", "accepts a lay-up that is not symmetric, because something holds the plate flat"),
    ]),
];
