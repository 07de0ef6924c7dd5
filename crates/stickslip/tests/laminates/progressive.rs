//! Joints followed to their failure by scenes.

use std::path::Path;

use stickslip::results::ProgressiveFailure;
use stickslip::run::run;
use stickslip::scene::Scene;

/// The ready scene `name` with further `overrides`.
fn scene(name: &str, overrides: &[&str]) -> Scene {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    Scene::from_file(&folder.join(name), overrides).unwrap()
}

fn followed(name: &str) -> ProgressiveFailure {
    let results = run(&scene(name, &[]), &mut |_| {}).unwrap();
    results.failure[0].progressive.clone().unwrap()
}

#[test]
fn each_ready_joint_fails_in_its_mode() {
    for (name, mode) in [
        ("joint-bearing.toml", "bearing"),
        ("joint-shear-out.toml", "shear-out"),
        ("joint-net-tension.toml", "net tension"),
    ] {
        let joint = followed(name);
        let first = joint.first().unwrap();
        println!(
            "{name}: {:?}, first ply {:.0} N, peak {:.0} N, {} increments",
            joint.mode.as_ref().unwrap().mode,
            first.load,
            joint.peak_load(),
            joint.curve.len()
        );
        assert_eq!(joint.mode.as_ref().unwrap().mode.name(), mode, "{name}");
        assert_eq!(joint.strength, Some(joint.peak_load()));
        assert!(first.load < joint.peak_load());
        assert!(joint.mode.as_ref().unwrap().reasons.len() >= 2);
    }
}

#[test]
fn a_scene_that_cannot_be_followed_is_refused_with_its_key() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let displacement = "failure.progressive.control.displacement";
    for (value, key) in [
        ("drop=1.5", "drop"),
        ("end=\"0 mm\"", "end"),
        ("increments=0", "increments"),
        ("on=\"plate.hole\"", "on"),
    ] {
        let error = Scene::from_file(
            &folder.join("joint-bearing.toml"),
            &[format!("{displacement}.{value}")],
        )
        .unwrap_err();
        assert_eq!(error.findings()[0].key, format!("{displacement}.{key}"));
    }
}
