//! Springs by formulas for whole fasteners.

use stickslip::scene::schema::{Formula, HuthJoint, Lap, LapPlate};
use stickslip::scene::{Format, Scene};

use super::{double_lap, single_lap};
use crate::model;

/// What contact is said to resolve `[mm/N]`.
const RESOLVED: f64 = 4e-6;

fn lumped(formula: &str) -> String {
    format!("lumped = {{ {formula}, force = \"2 kN\", resolved = \"8 µm\" }}")
}

/// The lap of the plates of both scenes, thicknesses of the first or middle one and of the other.
fn lap(thicknesses: [f64; 2], is_double: bool) -> Lap {
    Lap {
        plates: thicknesses.map(|thickness| LapPlate {
            thickness,
            young: 72e3,
        }),
        is_double,
        diameter: 5.98,
        young: 210e3,
        poisson: 0.3,
    }
}

/// Displacement of the middle or the first slice against the others under one newton `[mm]`.
fn compliance(text: &str, forces: &[f64]) -> f64 {
    let model = model(text, &[]);
    let whole = &model.fasteners[0].link.flexibility;
    let pairs = (0..forces.len()).flat_map(|i| (0..forces.len()).map(move |j| (i, j)));
    pairs
        .map(|(i, j)| forces[i] * whole[(3 * i, 3 * j)] * forces[j])
        .sum()
}

#[test]
fn springs_are_what_a_formula_has_beside_contact() {
    let joint = Formula::Huth(HuthJoint::BoltedMetal);
    for (formula, of) in [
        (joint, "formula = \"huth\", joint = \"bolted-metal\""),
        (Formula::Boeing, "formula = \"boeing\""),
        (Formula::Swift, "formula = \"swift\""),
        (Formula::Grumman, "formula = \"grumman\""),
    ] {
        let found = compliance(&single_lap(&lumped(of), 0.01), &[-1.0, 1.0]);
        let whole = formula.compliance(&lap([3.0, 4.0], false)).unwrap();
        let apart = found - (whole - RESOLVED);
        assert!(apart.abs() < 1e-12 * whole, "{of}: {found} {whole}");
    }
    for (formula, of) in [
        (joint, "formula = \"huth\", joint = \"bolted-metal\""),
        (Formula::TateRosenfeld, "formula = \"tate-rosenfeld\""),
    ] {
        let text = double_lap(&lumped(of), [2.5, 4.0, 2.5]);
        let found = compliance(&text, &[-0.5, 1.0, -0.5]);
        let whole = formula.compliance(&lap([4.0, 2.5], true)).unwrap();
        let apart = found - (whole - RESOLVED);
        assert!(apart.abs() < 1e-12 * whole, "{of}: {found} {whole}");
    }
}

#[test]
fn what_no_formula_holds_for_is_refused() {
    let huth = "formula = \"huth\", joint = \"bolted-metal\"";
    let more = lumped(huth).replace("8 µm", "1 mm");
    let two = |springs: &str| single_lap(springs, 0.01);
    let three = |springs: &str| double_lap(springs, [2.5, 4.0, 2.5]);
    for (text, part) in [
        (two(&more), "contact resolves 1 mm at 2000 N"),
        (two(&lumped("formula = \"huth\"")), "each kind of joint"),
        (two(&lumped("formula = \"swift\", joint = \"bolted-metal\"")), "only the formula of Huth"),
        (two(&lumped("formula = \"tate-rosenfeld\"")), "a joint of two plates"),
        (three(&lumped("formula = \"boeing\"")), "a joint of three plates"),
        (double_lap(&lumped(huth), [2.0, 4.0, 5.0]), "outer ones differ"),
        (
            three(&lumped(huth)).replacen("2.99 mm", "2.5 mm", 1),
            "has the radius 2.99 mm and 'one' 2.5 mm",
        ),
        (
            two(&lumped(huth)).replace(
                "[materials.aluminium.isotropic]\nyoung = \"72 GPa\"\npoisson = 0.33",
                "[materials.aluminium.orthotropic]\ne1 = \"72 GPa\"\ne2 = \"60 GPa\"\nnu12 = 0.33\ng12 = \"20 GPa\"",
            ),
            "isotropic",
        ),
    ] {
        let none: &[&str] = &[];
        let found = Scene::from_text(&text, Format::Toml, "lap.toml", std::path::Path::new(""), none);
        let message = found.unwrap_err().to_string();
        assert!(message.contains(part), "{part}: {message}");
    }
}
