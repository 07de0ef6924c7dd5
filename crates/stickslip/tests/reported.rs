//! What is reported of solved scenes: rounding as zero, contact where it is, stresses across the thickness.

use std::path::Path;

use serde_json::Value;
use stickslip::host::HOST;
use stickslip::output::summary_json;
use stickslip::results::Results;
use stickslip::scene::{Format, Scene};
use stickslip_contact::Status;

/// A cylinder on a block in plane strain, pressed and let go.
const CYLINDER: &str = r#"
version = 1
[analysis]
plane = "strain"
model = "whole"
[materials.aluminium.isotropic]
young = "73.1 GPa"
poisson = 0.33
[bodies.lower]
material = "aluminium"
thickness = "1 mm"
shape.block = { half_length = "10 mm", depth = "10 mm" }
[bodies.upper]
material = "aluminium"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "10 mm", depth = "10 mm" }
[mesh]
spacing = "0.2 mm"
fine_to = "1.2 mm"
[[contacts]]
name = "cylinder"
first = "upper.contact"
second = "lower.contact"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "lower.bottom"
fix = ["x", "y"]
[[platens]]
on = "upper.top"
free = ["y"]
[[loads]]
on = "upper.top"
force = { direction = [0, -1], steps = ["200 N", "500 N", "0 N"] }
[output]
fields = "peak"
figures = false
"#;

/// A pin in a strip that is pulled aslant.
const ASLANT: &str = r#"
version = 1
[analysis]
model = "whole"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "steel"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "90 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "2 mm"
shape.disk = { radius = "4.98 mm" }
[mesh]
spacing = "6 deg"
fine_to = "180 deg"
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[supports]]
on = "plate.left"
fix = ["y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN"] }
[[loads]]
on = "plate.top"
pressure = { steps = ["1 MPa"] }
[output]
fields = "none"
figures = false
"#;

fn solved(scene: &str, changes: &[&str]) -> Results {
    let scene = Scene::from_text_on(
        scene,
        Format::Toml,
        "scene.toml",
        Path::new("."),
        changes,
        HOST,
    )
    .unwrap_or_else(|error| panic!("{error} with {changes:?}"));
    stickslip::run::run(&scene, &mut |_| {}).unwrap()
}

#[test]
fn a_contact_that_opens_has_no_pressure_and_a_balance_like_the_others() {
    let results = solved(CYLINDER, &[]);
    for step in &results.steps {
        assert!(step.balance_residual < 1e-11, "{}", step.balance_residual);
    }
    let last = &results.steps[2].edges[0];
    for row in &last.rows {
        assert_eq!((row.pressure, row.shear), (0.0, 0.0));
        assert_eq!((row.sigma_tangential, row.tau), (0.0, 0.0));
        assert_eq!(row.status, Status::Open);
    }
    let summary = summary_json(&results).unwrap();
    let step = &summary["steps"][2];
    for key in [
        "peak_pressure",
        "peak_hoop",
        "contact_half_width",
        "stick_half_width",
    ] {
        assert_eq!(step[key], Value::Null, "{key}");
    }
    assert_eq!(step["contact_zones"], Value::Array(Vec::new()));
    assert_eq!(step["normal_force"]["value"], 0.0);
    assert!(summary["steps"][1]["stick_half_width"]["value"].is_f64());
}

#[test]
fn without_friction_nothing_sticks() {
    let results = solved(CYLINDER, &["contacts.0.friction.coulomb.mu=0"]);
    let edge = &results.steps[1].edges[0];
    assert!(edge.contact_half_extent.is_some());
    assert_eq!(edge.stick_half_extent, None);
    let stuck = edge.rows.iter().filter(|row| row.status == Status::Stick);
    assert_eq!(stuck.count(), 0);
    // The upper body, which spreads more freely, slips outwards on both sides; e_t points along −x.
    let sides = edge.rows.iter().zip(&results.edges[0].parameter);
    let outward: Vec<f64> = sides
        .filter(|(row, x)| row.status.touches() && x.abs() > 0.1)
        .map(|(row, x)| row.status.slip_sign() * x.signum())
        .collect();
    assert!(
        outward.iter().all(|sign| *sign == outward[0]),
        "{outward:?}"
    );
    let summary = summary_json(&results).unwrap();
    assert_eq!(summary["steps"][1]["stick_half_width"], Value::Null);
    assert!(summary["steps"][1]["contact_zones"][0]["end"].is_f64());
}

#[test]
fn plane_strain_has_a_stress_across_the_thickness() {
    let results = solved(CYLINDER, &[]);
    let fields = &results.steps[1].fields;
    assert_eq!(fields.len(), 2);
    for body in fields {
        for (stress, zz) in body.stress.iter().zip(&body.thickness_stress) {
            let expected = 0.33 * (stress[0] + stress[1]);
            // Means of products against products of means: some roundings.
            let size = stress[0].abs() + stress[1].abs();
            assert!((zz - expected).abs() <= 1e-14 * size, "{zz} {expected}");
        }
    }
    let thin = solved(CYLINDER, &["analysis.plane=stress"]);
    let fields = &thin.steps[1].fields;
    assert!(
        fields
            .iter()
            .all(|body| body.thickness_stress.iter().all(|&zz| zz == 0.0))
    );
}

#[test]
fn contact_that_is_not_symmetric_is_reported_by_its_ends() {
    let summary = summary_json(&solved(ASLANT, &[])).unwrap();
    let step = &summary["steps"][0];
    let zones = step["contact_zones_deg"].as_array().unwrap();
    assert_eq!(zones.len(), 1, "{zones:?}");
    let [start, end] = ["start", "end"].map(|key| zones[0][key].as_f64().unwrap());
    // The top pushes the plate's hole down onto the pin.
    assert!(
        start < 0.0 && end > 0.0 && (start + end).abs() > 1.0,
        "{start} {end}"
    );
    let half = step["contact_half_angle_deg"].as_f64().unwrap();
    assert!((half - 0.5 * (end - start)).abs() < 1e-9);
}
