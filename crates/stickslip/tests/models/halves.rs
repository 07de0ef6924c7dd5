//! Half or whole: what breaks the symmetry, and that both give the same.

use std::fmt::Write as _;
use std::fs;

use stickslip::model::{Model, ModelError};
use tempfile::TempDir;

use super::{BUSHING, difference, model, results, scene, scene_in, tractions, upper};

/// A hole whose edge is loaded by the stresses of a table.
const TABLE: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "25 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "4.99 mm"
[mesh]
spacing = "6 deg"
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 0.2
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "ring.outer"
polar_traction = { file = "table.csv", stress = "MPa", steps = [1.0, 0.4] }
[output]
fields = "none"
figures = false
"#;

fn why(model: &Model) -> (&str, &str) {
    let choice = model.choices.iter().find(|choice| choice.what == "model");
    choice
        .map(|choice| (choice.value.as_str(), choice.reason.as_str()))
        .unwrap()
}

#[test]
fn a_platen_on_one_side_needs_the_whole() {
    let model_with = |platen: &str| model(BUSHING, &[&format!("platens.0={platen}")]);
    let top = model_with("{ on = \"plate.top\", free = [\"x\"] }");
    assert_eq!(
        why(&top),
        ("whole", "the platen on plate.top has no mirror image")
    );
    let left = model_with("{ on = \"plate.left\", free = [\"x\"] }");
    assert_eq!(why(&left).0, "half");
}

#[test]
fn an_edge_that_a_half_lacks_needs_the_whole() {
    let bottom = "edges=[{ on = \"plate.bottom\" }]";
    let whole = model(BUSHING, &[bottom]);
    let (value, reason) = why(&whole);
    assert_eq!(value, "whole");
    assert!(
        reason.contains("plate.bottom is to be reported"),
        "{reason}"
    );
    assert_eq!(
        why(&model(BUSHING, &["edges=[{ on = \"plate.top\" }]"])).0,
        "half"
    );
    let refused = Model::build(&scene(BUSHING, &[bottom, "analysis.model=half"])).unwrap_err();
    assert!(matches!(refused, ModelError::NotSymmetric(_)));
    let words = refused.to_string();
    assert!(
        words.contains("plate.bottom") && words.contains("\"whole\" or \"auto\""),
        "{words}"
    );
}

#[test]
fn a_table_of_half_the_circle_is_mirrored_exactly() {
    let folder = TempDir::new().unwrap();
    let mut table = "theta_deg,sigma_r,tau_rtheta\n".to_owned();
    for degrees in [0.0_f64, 5.0, 17.0, 40.0, 71.0, 90.0, 118.0, 150.0, 180.0] {
        let theta = degrees.to_radians();
        let (radial, shear) = (20.0 - 30.0 * theta.cos(), 30.0 * theta.sin());
        // Writing into a string does not fail.
        let _ = writeln!(table, "{degrees},{radial},{shear}");
    }
    fs::write(folder.path().join("table.csv"), table).unwrap();
    let [half, whole] = ["half", "whole"].map(|kind| {
        let model = format!("analysis.model={kind}");
        results(&scene_in(folder.path(), TABLE, &[model.as_str()]))
    });
    for step in 0..2 {
        let resultant =
            |results: &stickslip::results::Results| results.steps[step].edges[0].resultant;
        let [x, y] = resultant(&whole);
        assert!(x.abs() > 100.0 && y.abs() < 1e-8 * x.abs(), "{x}, {y}");
        assert!((resultant(&half)[0] / x - 1.0).abs() < 1e-9);
        let apart = difference(
            tractions(&upper(&half, step, 0)),
            tractions(&upper(&whole, step, 0)),
        );
        assert!(apart < 1e-8, "step {step}: {apart:e}");
    }
}
