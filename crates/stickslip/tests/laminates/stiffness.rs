//! A laminate in its plane is a homogeneous plate, and its plies feed the friction law.

use stickslip::results::{EdgeRow, Results};
use stickslip::scene::schema::Substance;
use stickslip_laminate::Curvature;

use super::{PIN, close, scene, solved};

fn rows(results: &Results) -> Vec<EdgeRow> {
    let steps = results.steps.iter();
    steps.flat_map(|step| step.edges[0].rows.clone()).collect()
}

/// Largest difference of stresses along the edge relative to the largest pressure.
fn apart(one: &Results, other: &Results) -> f64 {
    let (one, other) = (rows(one), rows(other));
    assert_eq!(one.len(), other.len());
    let largest = one.iter().map(|row| row.pressure).fold(0.0, f64::max);
    let pairs = one.iter().zip(&other);
    let differences = pairs.flat_map(|(a, b)| {
        [
            a.pressure - b.pressure,
            a.shear - b.shear,
            a.sigma_tangential - b.sigma_tangential,
        ]
    });
    differences.map(f64::abs).fold(0.0, f64::max) / largest
}

#[test]
fn a_balanced_laminate_is_the_orthotropic_material_with_its_moduli() {
    for layup in ["[0_2/60_2/-60_2]s", "[0/±45/90]s", "[0_3/90]s", "[±30]s"] {
        let layup = format!("materials.laminate.laminate.layup={layup}");
        let thickness = "bodies.pin.thickness=1.5 mm";
        let changes = [layup.as_str(), thickness];
        let laminate = scene(PIN, &changes);
        let sheet = laminate.materials["laminate"].laminate().unwrap();
        let moduli = sheet.laminate.membrane_moduli(Curvature::Suppressed);
        let Substance::Elastic { thickness, .. } = laminate.bodies["plate"].substance else {
            panic!();
        };
        close(sheet.laminate.thickness(), thickness, 0.0);
        let material = format!(
            "materials.laminate={{ orthotropic = {{ e1 = \"{} MPa\", e2 = \"{} MPa\", g12 = \"{} MPa\", nu12 = {} }} }}",
            moduli.ex, moduli.ey, moduli.gxy, moduli.nuxy
        );
        let thick = format!("bodies.plate.thickness={thickness} mm");
        let changes = [layup.as_str(), "failure.criteria=[\"max_stress\"]"];
        let own = solved(PIN, &changes);
        let plain = PIN.split("[failure]").next().unwrap().to_owned()
            + "[output]\nfields = \"none\"\nfigures = false\n";
        let other = solved(&plain, &[material.as_str(), thick.as_str()]);
        // A solve loses the condition of the stiffness matrix, (length of the plate over a cell)², times rounding: 100 mm over 6° of 5 mm.
        let condition = (100.0 / (5.0 * 6.0_f64.to_radians())).powi(2);
        let difference = apart(&own, &other);
        assert!(
            difference < condition * f64::EPSILON,
            "{layup}: {difference:.1e}"
        );
    }
}

#[test]
fn a_turned_layup_is_the_layup_with_turned_angles() {
    let turned = solved(
        PIN,
        &[
            "materials.laminate.laminate.layup=[0/45]s",
            "materials.laminate.laminate.angle=30 deg",
        ],
    );
    let written = solved(PIN, &["materials.laminate.laminate.layup=[30/75]s"]);
    assert!(apart(&turned, &written) < 1e-12);
    let angles = |results: &Results| -> Vec<f64> {
        let plies = results.failure[0].plies.iter();
        plies.map(|group| group.angle).collect()
    };
    for (one, other) in angles(&turned).into_iter().zip(angles(&written)) {
        close(one, other, 1e-14);
    }
    let choice = &turned.choices[0];
    assert_eq!(
        (choice.what.as_str(), choice.value.as_str()),
        ("model", "whole")
    );
}

#[test]
fn fibre_coverage_knows_the_plies_of_the_laminate() {
    let law = "fibre_fraction = 0.6, kernel = { tangent = { width = \"15 deg\" } }, \
               fibre = { coulomb = { mu = 0.1 } }, matrix = { coulomb = { mu = 0.4 } }";
    let without = format!("contacts.0.friction={{ fibre_coverage = {{ {law} }} }}");
    let third = 1.0 / 3.0;
    let with = format!(
        "contacts.0.friction={{ fibre_coverage = {{ {law}, plies = [\
         {{ angle = \"0 deg\", fraction = {third} }}, {{ angle = \"60 deg\", fraction = {third} }}, \
         {{ angle = \"-60 deg\", fraction = {third} }}] }} }}"
    );
    let own = solved(PIN, &[without.as_str()]);
    let given = solved(PIN, &[with.as_str()]);
    // The fractions are sums of thicknesses, a third to rounding.
    assert!(apart(&own, &given) < 1e-12);
    let coulomb = solved(PIN, &[]);
    assert!(apart(&own, &coulomb) > 1e-3);
    // A turned lay-up turns the fibres with it.
    let turn = "materials.laminate.laminate.angle=90 deg";
    let turned = solved(PIN, &[without.as_str(), turn]);
    let written = solved(
        PIN,
        &[
            without.as_str(),
            "materials.laminate.laminate.layup=[90_2/-30_2/30_2]s",
        ],
    );
    let difference = apart(&turned, &written);
    // 150° and −30° round differently, and friction passes that on with the condition of the contact problem.
    assert!(difference < 1e-11, "{difference:.1e}");
}
