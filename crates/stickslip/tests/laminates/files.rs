//! What a run with laminates writes: tables, summary, fields, figures; and the scenes that come with the program.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::host::HOST;
use stickslip::keep;
use stickslip::run;
use stickslip::scene::Scene;
use tempfile::TempDir;

use super::{PIN, scene};

/// Runs a scene into a folder.
pub(crate) fn written(scene: &Scene) -> (TempDir, PathBuf) {
    let folder = TempDir::new().unwrap();
    let path = folder.path().join("results");
    let results = run::run(scene, &mut |_| {}).unwrap();
    let target = ResultFolder::create(&path, Overwrite::Refuse).unwrap();
    let path = keep::results(&results, target, scene.output.figures).unwrap();
    (folder, path)
}

pub(crate) fn read(folder: &Path, name: &str) -> String {
    fs::read_to_string(folder.join(name)).unwrap_or_else(|error| panic!("{name}: {error}"))
}

pub(crate) fn summary(folder: &Path) -> Value {
    serde_json::from_str(&read(folder, "summary.json")).unwrap()
}

fn shipped(name: &str, changes: &[&str]) -> Scene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../../scenes")
        .join(name);
    Scene::from_file(&path, changes, HOST).unwrap()
}

#[test]
fn tables_name_their_units_and_have_a_row_for_everything() {
    let changes = [
        "failure.characteristic={ tension = \"1 mm\", compression = \"2 mm\" }",
        "failure.criteria=[\"max_stress\", \"hashin\"]",
        "loads.0.force.steps=[\"1 kN\", \"2 kN\"]",
        "output.fields=peak",
        "units.stress=psi",
    ];
    let (_folder, path) = written(&scene(PIN, &changes));
    let steps = read(&path, "failure-plate.csv");
    assert!(
        steps.starts_with("step,load pull [N],criterion,reserve_factor [-],margin [-],index [-],ply,angle [deg],layers,mode,x [mm],"),
        "{steps}"
    );
    assert!(steps.contains(",sigma_1 [psi],sigma_2 [psi],tau_12 [psi]\n"));
    assert_eq!(steps.lines().count(), 1 + 2 * 2);
    let first = read(&path, "first-ply-plate.csv");
    assert_eq!(first.lines().count(), 1 + 4 * 2);
    assert!(first.contains("characteristic curve,hashin,"));
    let edge = read(&path, "plies-pin-step-02.csv");
    let heading = edge.lines().next().unwrap();
    assert!(
        heading.starts_with("theta [deg],sigma_1 0 deg [psi],"),
        "{heading}"
    );
    assert!(
        heading.contains("sigma_2 -60 deg [psi]") && heading.contains("index hashin 60 deg [-]")
    );
    // Corner nodes every 6° and one between two of them, all around.
    assert_eq!(edge.lines().count(), 1 + 120);
    assert_eq!(
        read(&path, "characteristic-plate.csv").lines().count(),
        1 + 181
    );
    let all = read(&path, "steps.csv");
    assert!(all.starts_with("step,") && all.contains("plate: reserve_factor hashin [-]"));
    let field = read(&path, "fields/plate-step-02.vtu");
    assert!(field.contains("index max_stress -60 deg [-]"));
    let page = read(&path, "report.html");
    assert!(page.contains("Failure of plies") && page.contains("first ply"));
}

#[test]
fn the_summary_holds_failure() {
    let changes = [
        "materials.laminate.laminate.cure=-50 K",
        "failure.characteristic={ tension = \"1 mm\", compression = \"2 mm\" }",
    ];
    let (_folder, path) = written(&scene(PIN, &changes));
    let summary = summary(&path);
    let failure = &summary["failure"][0];
    assert_eq!(failure["body"], "plate");
    assert_eq!(failure["layup"], "[0_2/60_2/-60_2]s");
    assert_eq!(failure["cure"]["value"], -50.0);
    assert_eq!(failure["plies"][1]["angle_deg"], 60.0);
    assert_eq!(
        failure["plies"][1]["layers"],
        serde_json::json!([3, 4, 9, 10])
    );
    assert!(
        failure["plies"][1]["residual_stress"]["sigma_2"]
            .as_f64()
            .unwrap()
            > 0.0
    );
    let first = &failure["first_ply"][0];
    assert_eq!(
        (&first["fails"], &first["reached"]),
        (&Value::from(true), &Value::from(false))
    );
    let (factor, load) = (
        first["factor"].as_f64().unwrap(),
        first["load"]["value"].as_f64().unwrap(),
    );
    assert!((1000.0 * factor - load).abs() < 1e-6 * load);
    assert!(failure["characteristic"]["curve"][0]["joint_mode"].is_string());
    let step = &failure["steps"][0][0];
    let (reserve, margin) = (
        step["reserve_factor"].as_f64().unwrap(),
        step["margin"].as_f64().unwrap(),
    );
    assert!((reserve - 1.0 - margin).abs() < 1e-9);
}

#[test]
fn the_quasi_isotropic_scene_runs_on_a_coarse_mesh_and_all_its_figures_are_drawn() {
    let changes = ["mesh.spacing=4.5 deg", "mesh.coarse_spacing=9 deg"];
    let scene = shipped("pin-quasi-isotropic.toml", &changes);
    let (_folder, path) = written(&scene);
    let summary = summary(&path);
    assert_eq!(summary["failure"].as_array().unwrap().len(), 2);
    assert_eq!(summary["steps"].as_array().unwrap().len(), 12);
    let notes = summary["notes"].to_string();
    assert!(!notes.contains("could not be drawn"), "{notes}");
    for name in [
        "ply-index-coulomb",
        "ply-stresses-coverage",
        "ply-map-plate-step-10",
        "characteristic-plate",
    ] {
        assert!(path.join(format!("figures/{name}.svg")).is_file(), "{name}");
    }
    // The cracks of the report: across the fibres of the 60° plies, beside the net section.
    let first = &summary["failure"][1]["first_ply"][0]["at"];
    assert_eq!(
        (&first["ply_angle_deg"], &first["mode"]),
        (&Value::from(60.0), &Value::from("matrix tension"))
    );
    let angle = first["angle_deg"].as_f64().unwrap();
    assert!((60.0..90.0).contains(&angle), "{angle}");
}

#[test]
fn the_envelope_scene_runs_and_its_coupon_fails_on_the_envelope() {
    let scene = shipped(
        "failure-envelope.toml",
        &["failure.envelopes.directions=36"],
    );
    let (_folder, path) = written(&scene);
    let summary = summary(&path);
    assert!(!summary["notes"].to_string().contains("could not be drawn"));
    for name in [
        "envelope-normal-coupon",
        "envelope-shear-coupon",
        "ply-map-coupon-step-03",
    ] {
        assert!(path.join(format!("figures/{name}.svg")).is_file(), "{name}");
    }
    let envelopes = read(&path, "envelopes-coupon.csv");
    // Two planes, two bounds, five criteria.
    assert_eq!(envelopes.lines().count(), 1 + 36 * 2 * 2 * 5);
    let tension = envelopes
        .lines()
        .find(|line| line.contains(",first ply,max_stress,"))
        .unwrap();
    let stress: f64 = tension.split(',').nth(3).unwrap().parse().unwrap();
    let first = &summary["failure"][0]["first_ply"][0];
    assert_eq!(first["reached"], true);
    let load = -first["load"]["value"].as_f64().unwrap();
    assert!((load - stress).abs() < 1e-8 * stress, "{load} {stress}");
}
