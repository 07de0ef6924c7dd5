//! Assumed bearing pressures.

use std::f64::consts::{FRAC_PI_2, PI};

use stickslip::host::HOST;
use stickslip::model::Model;
use stickslip::results::Results;

use crate::{model, scene, solved};

/// A ring so wide that its edge does not matter: what it reflects of the force's field R/r reaches the hole with (R/r)², 400⁻².
const RING: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.plate]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "2 m" }
[mesh]
spacing = "5 deg"
[[supports]]
on = "plate.outer"
fix = ["x", "y"]
[[loads]]
name = "pin"
on = "plate.hole"
bearing = { direction = [1, 0], law = "cosine", steps = ["2 kN", "4 kN"] }
[[edges]]
on = "plate.hole"
[output]
fields = "none"
figures = false
"#;

/// P/(D t) of the first step `[MPa]`.
const MEAN: f64 = 2000.0 / 20.0;

/// σ_θ at the node at `degrees` over P/(D t).
fn hoop(results: &Results, step: usize, degrees: f64) -> f64 {
    let places = &results.edges[0].parameter;
    let node = places
        .iter()
        .position(|place| (place - degrees.to_radians()).abs() < 1e-9)
        .unwrap();
    results.steps[step].edges[0].rows[node].sigma_tangential / MEAN
}

fn choice(model: &Model) -> &str {
    let found = model.choices.iter().find(|choice| choice.what == "model");
    &found.unwrap().value
}

#[test]
fn the_hoop_stress_has_the_closed_form() {
    let results = solved(RING, &[]);
    let cosine = |theta: f64| if theta < FRAC_PI_2 { theta.cos() } else { 0.0 };
    for degrees in [0.0, 30.0, 60.0, 75.0, 105.0, 120.0, 150.0, 180.0_f64] {
        let theta = degrees.to_radians();
        let exact = 8.0 / (PI * PI) + 2.7 / PI * theta.cos() - 4.0 / PI * cosine(theta);
        // Third order: (5° in radians)³ is 7e-4.
        let error = hoop(&results, 0, degrees) - exact;
        assert!(error.abs() < 2e-4, "{degrees}°: {error:e}");
    }
    // At the kink of the pressure the hoop stress has the slope of x ln x: first order, 5° in radians is 0.09.
    assert!((hoop(&results, 0, 90.0) * PI * PI / 8.0 - 1.0).abs() < 0.02);
    assert!((hoop(&results, 1, 90.0) / hoop(&results, 0, 90.0) - 2.0).abs() < 1e-9);
    let rows = &results.steps[0].edges[0].rows;
    for (row, theta) in rows.iter().zip(&results.edges[0].parameter) {
        let expected = 4.0 / PI * cosine(*theta);
        assert!((row.sigma_normal / MEAN + expected).abs() < 1e-12 && row.tau == 0.0);
    }
    assert_eq!(results.steps[1].loads[0].unit, "N");
    assert!(results.steps[1].balance_residual < 1e-10);
}

#[test]
fn half_and_whole_agree_and_the_load_turns_with_its_direction() {
    for law in ["cosine", "uniform"] {
        let law = format!("loads.0.bearing.law={law}");
        let half = solved(RING, &[&law]);
        let whole = solved(RING, &[&law, "analysis.model=whole"]);
        let up = solved(RING, &[&law, "loads.0.bearing.direction=[0, 3]"]);
        for degrees in [0.0, 45.0, 60.0, 90.0] {
            let apart = [
                hoop(&whole, 1, degrees) - hoop(&half, 1, degrees),
                hoop(&whole, 1, -degrees) - hoop(&half, 1, degrees),
                hoop(&up, 1, 90.0 - degrees) - hoop(&half, 1, degrees),
            ];
            assert!(
                apart.iter().all(|a| a.abs() < 1e-8),
                "{law} {degrees}°: {apart:?}"
            );
        }
    }
}

#[test]
fn a_skew_force_needs_the_whole() {
    assert_eq!(choice(&model(RING, &[])), "half");
    assert_eq!(
        choice(&model(RING, &["loads.0.bearing.direction=[-1, 0]"])),
        "half"
    );
    assert_eq!(
        choice(&model(RING, &["loads.0.bearing.direction=[1, 1]"])),
        "whole"
    );
}

#[test]
fn a_hole_is_either_held_by_a_pin_or_by_a_pressure() {
    let both = [
        "bodies.pin={ rigid = true, shape.disk.radius = \"4.9 mm\" }",
        "contacts.0={ first = \"plate.hole\", second = \"pin.rim\", friction.coulomb.mu = 0 }",
        "supports.1={ on = \"pin.centre\", fix = [\"x\", \"y\"] }",
    ];
    let error = Model::build(&scene(RING, &both)).unwrap_err().to_string();
    assert!(
        error.contains("plate.hole is held by pin.rim in contact 'pin'")
            && error.contains("'pin' stands for a pin"),
        "{error}"
    );
}

#[test]
fn a_rigid_body_takes_none() {
    let rigid = [
        "bodies.plate={ rigid = true, shape.plate_with_hole = { hole_radius = \"5 mm\", outline.ring.radius = \"9 mm\" } }",
    ];
    let read = stickslip::scene::Scene::from_text_on(
        RING,
        stickslip::scene::Format::Toml,
        "scene.toml",
        std::path::Path::new(""),
        &rigid,
        HOST,
    );
    // Refused when it is read or when it is modelled, and by its name.
    let error = match read {
        Err(error) => error.to_string(),
        Ok(scene) => Model::build(&scene).unwrap_err().to_string(),
    };
    assert!(error.contains("plate"), "{error}");
}
