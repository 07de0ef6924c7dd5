//! Plies and the laminates made of them.

use std::collections::BTreeMap;
use std::sync::Arc;

use stickslip_fem_core::material::{MaterialError, PlaneState};
use stickslip_laminate::laminate::LaminateError;
use stickslip_laminate::ply::PlyError;
use stickslip_laminate::{Laminate, Layup, Ply, PlyConstants, Strength, Strengths};

use super::Builder;
use crate::diagnostic::LaminateProblem;
use crate::document::{Part, child};
use crate::format::SceneFormat;
use crate::material::{LaminateFormat, PlyFormat, StrengthsFormat};
use crate::schema::LaminateSheet;
use crate::units::{Quantity, Stress};

/// Largest difference of two thicknesses that were meant to be equal, relative: sums of plies in other units round.
const SAME_THICKNESS: f64 = 1e-9;

impl Builder<'_> {
    /// The plies that exist.
    pub(super) fn plies(&mut self, format: &SceneFormat) -> BTreeMap<String, Ply> {
        let mut plies = BTreeMap::new();
        for (name, given) in &format.plies {
            self.name("plies", name);
            let table = child("plies", name);
            match self.ply(&table, name, given) {
                Ok(ply) => {
                    plies.insert(name.clone(), ply);
                }
                Err(cause) => {
                    let key = ply_key(&table, &cause);
                    self.report(&key, Part::Value, LaminateProblem::Ply { cause }.into());
                }
            }
        }
        plies
    }

    fn ply(&mut self, table: &str, name: &str, given: &PlyFormat) -> Result<Ply, PlyError> {
        let expansion = |given: &Option<Quantity<_>>| given.as_ref().map_or(0.0, Quantity::value);
        let PlyFormat {
            e1,
            e2,
            g12,
            nu12,
            thickness,
            expansion1,
            expansion2,
            strengths,
        } = given;
        let constants = PlyConstants {
            e1: e1.value(),
            e2: e2.value(),
            g12: g12.value(),
            nu12: *nu12,
            alpha1: expansion(expansion1),
            alpha2: expansion(expansion2),
            thickness: thickness.value(),
        };
        let strengths = strengths.as_ref().map(|given| {
            if given.is_empty() {
                self.missing(&child(table, "strengths"), "xt");
            }
            given.strengths(&constants)
        });
        Ply::new(name, constants, strengths.unwrap_or_default())
    }

    /// The laminate `name`; `None` where that has been reported.
    pub(super) fn laminate(
        &mut self,
        table: &str,
        name: &str,
        given: &LaminateFormat,
        plies: &BTreeMap<String, Ply>,
        plane: PlaneState,
    ) -> Option<LaminateSheet> {
        let table = child(table, "laminate");
        let layup_key = child(&table, "layup");
        let material = || name.to_owned();
        if plane == PlaneState::Strain {
            let material = material();
            let problem = LaminateProblem::PlaneStrain { material };
            self.report(&table, Part::Key, problem.into());
        }
        let LaminateFormat {
            layup,
            ply,
            angle,
            cure,
            held_flat,
        } = given;
        let layup: Layup = match layup.parse() {
            Ok(layup) => layup,
            Err(cause) => {
                let material = material();
                let problem = LaminateProblem::Layup { material, cause };
                self.report(&layup_key, Part::Value, problem.into());
                return None;
            }
        };
        let default = self.default_ply(&table, &layup, ply.as_ref(), plies)?;
        let named: Vec<Ply> = plies.values().cloned().collect();
        let angle = angle.as_ref().map_or(0.0, Quantity::value);
        let cure = cure.as_ref().map_or(0.0, Quantity::value);
        match sheet(&layup, &default, &named, [angle, cure], *held_flat) {
            Ok(sheet) => Some(sheet),
            Err(cause) => {
                let material = material();
                let problem = LaminateProblem::Laminate { material, cause };
                self.report(&layup_key, Part::Value, problem.into());
                None
            }
        }
    }

    /// The ply of layers for which the lay-up names none, or any where it names all.
    fn default_ply(
        &mut self,
        table: &str,
        layup: &Layup,
        given: Option<&String>,
        plies: &BTreeMap<String, Ply>,
    ) -> Option<Ply> {
        let unnamed = layup.stack().iter().any(|stacked| stacked.ply.is_none());
        match given {
            Some(name) => {
                let found = plies.get(name);
                // A ply that is refused for itself needs no second message.
                if found.is_none() && self.document.get(&child("plies", name)).is_none() {
                    let known = plies.keys().cloned().collect();
                    self.undefined(&child(table, "ply"), "ply", name, known);
                }
                found.cloned()
            }
            None if unnamed => {
                self.missing(table, "ply");
                None
            }
            None => {
                let first = layup.stack().first().and_then(|first| first.ply.as_ref())?;
                let known = || plies.keys().cloned().collect();
                if !plies.contains_key(first) {
                    self.undefined(&child(table, "layup"), "ply", first, known());
                }
                plies.get(first).cloned()
            }
        }
    }

    /// The thickness of a body of the laminate `sheet`, whatever stands in the scene.
    pub(super) fn laminate_thickness(
        &mut self,
        table: &str,
        material: &str,
        given: Option<&Quantity<crate::units::Length>>,
        sheet: &LaminateSheet,
    ) -> f64 {
        let thickness = sheet.laminate.thickness();
        if let Some(given) = given
            && (given.value() - thickness).abs() > SAME_THICKNESS * thickness
        {
            let unit = crate::units::unit_of(given.text());
            let laminate =
                unit.map_or_else(|| format!("{thickness} mm"), |unit| unit.show(thickness));
            let problem = LaminateProblem::Thickness {
                material: material.to_owned(),
                given: given.text().to_owned(),
                laminate,
            };
            let key = child(table, "thickness");
            self.report(&key, Part::Value, problem.into());
        }
        thickness
    }
}

/// The laminate of `layup` whose 0° is at `angle` `[rad]` from +x.
fn sheet(
    layup: &Layup,
    default: &Ply,
    named: &[Ply],
    [angle, cure]: [f64; 2],
    held_flat: bool,
) -> Result<LaminateSheet, LaminateError> {
    let own = Laminate::of_plies(layup, default, named)?;
    let layers = own.layers().iter();
    let turned = layers.map(|layer| {
        let ply = Arc::new(layer.ply().clone());
        (ply, layer.angle() + angle.to_degrees())
    });
    let laminate = if angle == 0.0 {
        own
    } else {
        Laminate::from_layers(turned)?
    };
    let membrane = if held_flat {
        laminate.flat_membrane_material()
    } else {
        laminate.membrane_material()?
    };
    Ok(LaminateSheet {
        layup: layup.to_string(),
        laminate,
        membrane,
        angle,
        cure,
    })
}

/// The key that a ply's error is about.
fn ply_key(table: &str, cause: &PlyError) -> String {
    let name = match cause {
        PlyError::Constant {
            cause:
                MaterialError::Modulus { name, .. } | MaterialError::OrthotropicPoisson { name, .. },
            ..
        } => (*name).to_owned(),
        PlyError::Thickness { .. } => "thickness".to_owned(),
        PlyError::Strength { strength, .. } => child("strengths", strength),
        _ => return table.to_owned(),
    };
    child(table, name)
}

impl StrengthsFormat {
    fn is_empty(&self) -> bool {
        self.given().is_empty()
    }

    fn given(&self) -> Strengths {
        let stress = |given: &Option<Quantity<Stress>>| given.as_ref().map(Quantity::value);
        let Self {
            xt,
            xc,
            yt,
            yc,
            s12,
            zt,
            zc,
            s13,
            s23,
            strain_1t,
            strain_1c,
            strain_2t,
            strain_2c,
            strain_12,
            linear_strain_limits: _,
        } = self;
        Strengths {
            xt: stress(xt),
            xc: stress(xc),
            yt: stress(yt),
            yc: stress(yc),
            s12: stress(s12),
            zt: stress(zt),
            zc: stress(zc),
            s13: stress(s13),
            s23: stress(s23),
            strain_1t: *strain_1t,
            strain_1c: *strain_1c,
            strain_2t: *strain_2t,
            strain_2c: *strain_2c,
            strain_12: *strain_12,
        }
    }

    fn strengths(&self, constants: &PlyConstants) -> Strengths {
        let given = self.given();
        let finite = Strength::ALL
            .iter()
            .all(|&strength| given.get(strength).is_none_or(|value| value > 0.0));
        // A strength that is refused is refused under its own name, not as the strain made of it.
        if self.linear_strain_limits && finite {
            given.with_linear_strain_limits(constants.e1, constants.e2, constants.g12)
        } else {
            given
        }
    }
}
