//! The same material written in two ways.

use stickslip_tests::Draft;
use stickslip_tests::compare::{all_stresses, relative_difference, tractions};

/// The same numbers up to rounding; see the tests of symmetry.
const ROUNDING: f64 = 1e-8;

const YOUNG: f64 = 70e3;
const POISSON: f64 = 0.33;

fn agree(first: &Draft, second: &Draft) {
    let difference = relative_difference(all_stresses(&first.run()), all_stresses(&second.run()));
    assert!(
        difference < ROUNDING,
        "{difference:e}:\n{first:?}\n{second:?}"
    );
}

fn pin() -> Draft {
    Draft::pin().forces(0, &[800.0, 2400.0, 600.0])
}

/// Isotropic constants as orthotropic ones, with the 1-axis anywhere.
fn as_orthotropic(angle: f64, out_of_plane: bool) -> String {
    let shear = YOUNG / (2.0 * (1.0 + POISSON));
    let third = if out_of_plane {
        format!(", e3 = \"{YOUNG} MPa\", nu13 = {POISSON}, nu23 = {POISSON}")
    } else {
        String::new()
    };
    format!(
        "{{ e1 = \"{YOUNG} MPa\", e2 = \"{YOUNG} MPa\", g12 = \"{shear} MPa\", nu12 = {POISSON}, angle = \"{angle} deg\"{third} }}"
    )
}

#[test]
fn isotropic_as_orthotropic() {
    // Skew axes make the model whole, although nothing is skew in it.
    let whole = pin().set("analysis.model", "whole");
    for (reference, angle) in [(pin(), 0.0), (pin(), 90.0), (whole, 27.0)] {
        let stress = reference
            .clone()
            .set("materials.plate.orthotropic", as_orthotropic(angle, false));
        agree(&reference, &stress);
        let strain = |draft: Draft| draft.set("analysis.plane", "strain");
        let other = reference
            .clone()
            .set("materials.plate.orthotropic", as_orthotropic(angle, true));
        agree(&strain(reference), &strain(other));
    }
}

#[test]
fn turning_a_ply_by_a_quarter_exchanges_its_axes() {
    let ply = |e1: f64, e2: f64, nu12: f64, angle: f64| {
        format!(
            "{{ e1 = \"{e1} GPa\", e2 = \"{e2} GPa\", g12 = \"5 GPa\", nu12 = {nu12}, angle = \"{angle} deg\" }}"
        )
    };
    let along = pin().set("materials.plate.orthotropic", ply(140.0, 10.0, 0.3, 90.0));
    let across = pin().set(
        "materials.plate.orthotropic",
        ply(10.0, 140.0, 0.3 * 10.0 / 140.0, 0.0),
    );
    agree(&along, &across);
}

/// Plane strain is plane stress with E/(1 − ν²) and ν/(1 − ν).
#[test]
fn plane_strain_by_substitution() {
    let substituted = |draft: Draft, names: [&str; 2]| {
        names
            .iter()
            .fold(draft.set("analysis.plane", "stress"), |draft, name| {
                let young = YOUNG / (1.0 - POISSON * POISSON);
                draft
                    .set(
                        &format!("materials.{name}.isotropic.young"),
                        format!("{young} MPa"),
                    )
                    .set(
                        &format!("materials.{name}.isotropic.poisson"),
                        POISSON / (1.0 - POISSON),
                    )
            })
    };
    agree(
        &pin().set("analysis.plane", "strain"),
        &substituted(pin(), ["plate", "pin"]),
    );
    agree(
        &Draft::cylinder(),
        &substituted(Draft::cylinder(), ["lower", "upper"]),
    );
}

/// A uniformly heated plate is a plate with a larger hole: the clearance grows by R α ΔT, and nothing else happens.
#[test]
fn heating_the_plate_widens_the_clearance() {
    let (expansion, rise, radius) = (2.4e-5, 50.0, 5.0);
    let draft = pin()
        .friction("coulomb = { mu = 0 }")
        .set("contacts.0.gap", "linearised");
    let hot = draft
        .clone()
        .set("materials.plate.isotropic.expansion", format!("{expansion} 1/K"))
        .set("loads.1", format!("{{ on = \"plate\", temperature = {{ steps = [\"{rise} K\", \"{rise} K\", \"{rise} K\"] }} }}"));
    let loose = draft.set(
        "bodies.pin.shape.disk.radius",
        format!("{} mm", 4.99 - radius * expansion * rise),
    );
    // Tractions only: the hoop stress takes the strain of the heated edge from a polynomial, accurate to 1e-6 here.
    let tractions = |draft: &Draft| -> Vec<f64> {
        let steps = draft.run().steps;
        steps
            .iter()
            .flat_map(|step| tractions(&step.edges[0]).collect::<Vec<_>>())
            .collect()
    };
    let difference = relative_difference(tractions(&hot), tractions(&loose));
    assert!(difference < ROUNDING, "{difference:e}");
}
