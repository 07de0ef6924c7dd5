//! Springs from a formula for a whole fastener, less what contact resolves of it.

use stickslip_text::significant;

use super::fasteners::Slice;
use super::{Builder, Materials};
use crate::document::child;
use crate::schema::fastener::{FormulaFormat, JointFormat, LumpedFormat};
use crate::schema::{Formula, HuthJoint, Lap, LapPlate, Material, Springs, Substance};

/// Part of a thickness or modulus by which equal ones may differ.
const EQUAL: f64 = 1e-9;

impl Builder<'_> {
    /// The springs of `lumped` between `slices`; rigid ones where they cannot be found, which has been reported.
    pub(super) fn lumped(
        &mut self,
        table: &str,
        lumped: &LumpedFormat,
        slices: &[Slice<'_>],
        materials: &Materials,
    ) -> Springs {
        let key = child(table, "springs.lumped");
        let formula = self.formula(&key, lumped);
        let lap = self.lap(&key, slices, materials);
        let (Some(formula), Some(lap)) = (formula, lap) else {
            return Springs::Rigid;
        };
        let Some(whole) = formula.compliance(&lap) else {
            let (kind, other) = if lap.is_double {
                ("three plates", "\"huth\" or \"tate-rosenfeld\"")
            } else {
                (
                    "two plates",
                    "\"huth\", \"boeing\", \"swift\" or \"grumman\"",
                )
            };
            let message = format!(
                "the formula of {} is not made for a joint of {kind}",
                formula.authors()
            );
            self.conflict(&child(&key, "formula"), message, format!("write {other}"));
            return Springs::Rigid;
        };
        let (force, resolved) = (lumped.force.value(), lumped.resolved.value());
        let left = whole - resolved / force;
        if left < 0.0 {
            let message = format!(
                "contact resolves {} mm at {} N, and the formula of {} has only {} mm for the whole fastener",
                significant(resolved, 4),
                significant(force, 4),
                formula.authors(),
                significant(whole * force, 4)
            );
            let remedy = "nothing is left for the springs: take springs.beam, or springs.rigid";
            self.conflict(&child(&key, "resolved"), message, remedy);
            return Springs::Rigid;
        }
        // Each side of a double lap carries half of the force.
        let sides = slices.len() - 1;
        Springs::Given {
            compliance: vec![left * sides as f64; sides],
        }
    }

    fn formula(&mut self, key: &str, lumped: &LumpedFormat) -> Option<Formula> {
        let formula = match (lumped.formula, lumped.joint) {
            (FormulaFormat::Huth, Some(joint)) => Formula::Huth(match joint {
                JointFormat::BoltedMetal => HuthJoint::BoltedMetal,
                JointFormat::RivetedMetal => HuthJoint::RivetedMetal,
                JointFormat::BoltedComposite => HuthJoint::BoltedComposite,
            }),
            (FormulaFormat::Huth, None) => {
                let message = "the formula of Huth has other numbers for each kind of joint";
                let remedy =
                    "add joint = \"bolted-metal\", \"riveted-metal\" or \"bolted-composite\"";
                self.conflict(key, message, remedy);
                return None;
            }
            (_, Some(_)) => {
                let message = "only the formula of Huth distinguishes kinds of joints";
                self.conflict(&child(key, "joint"), message, "remove it");
                return None;
            }
            (FormulaFormat::Boeing, None) => Formula::Boeing,
            (FormulaFormat::Swift, None) => Formula::Swift,
            (FormulaFormat::Grumman, None) => Formula::Grumman,
            (FormulaFormat::TateRosenfeld, None) => Formula::TateRosenfeld,
        };
        Some(formula)
    }

    /// The lap of two plates, or of one between two equal ones.
    fn lap(&mut self, key: &str, slices: &[Slice<'_>], materials: &Materials) -> Option<Lap> {
        let plates: Option<Vec<LapPlate>> = (slices.iter())
            .map(|slice| {
                let [young, _, thickness] = self.isotropic(key, slice.plate, materials)?;
                Some(LapPlate { thickness, young })
            })
            .collect();
        let [young, poisson, _] = self.isotropic(key, slices.first()?.body, materials)?;
        let is_same = |a: f64, b: f64| (a - b).abs() <= EQUAL * a;
        let plates = match plates?[..] {
            [first, other] => [first, other],
            [lower, middle, upper]
                if is_same(lower.thickness, upper.thickness)
                    && is_same(lower.young, upper.young) =>
            {
                [middle, lower]
            }
            _ => {
                let message = format!(
                    "formulas are for two plates, or for one between two equal ones, and here are {}{}",
                    slices.len(),
                    if slices.len() == 3 {
                        ", whose outer ones differ"
                    } else {
                        ""
                    }
                );
                let remedy = "give displacements of your own: springs.given";
                self.conflict(key, message, remedy);
                return None;
            }
        };
        Some(Lap {
            plates,
            is_double: slices.len() == 3,
            diameter: 2.0 * slices.first()?.radius,
            young,
            poisson,
        })
    }

    /// Young's modulus `[MPa]`, Poisson's ratio and thickness `[mm]` of `body`; `None` if it has none, which is reported.
    fn isotropic(&mut self, key: &str, body: &str, materials: &Materials) -> Option<[f64; 3]> {
        let substance = &self.bodies.get(body)?.substance;
        if let Substance::Elastic {
            material,
            thickness,
        } = substance
            && let Some(Material::Isotropic { young, poisson, .. }) = materials.get(material)
        {
            return Some([*young, *poisson, *thickness]);
        }
        let message = format!(
            "'{body}' has no isotropic material, and formulas have one modulus for each plate and fastener"
        );
        let remedy = "work the formula out with the moduli along the load, and give displacements: springs.given";
        self.conflict(key, message, remedy);
        None
    }
}
