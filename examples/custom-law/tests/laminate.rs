//! The criterion and the point model keep their contracts, and a scene names them.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};
use std::sync::Arc;

use custom_law::criterion::Crushing;
use stickslip_laminate::contract::{
    CriterionSample, PointSample, check_criterion, check_parameters,
};
use stickslip_laminate::progressive::PointModelParameters;
use stickslip_laminate::{FailureCriterion, Laminate, Ply, PlyConstants, Strengths};

fn ply() -> Ply {
    let constants = PlyConstants {
        e1: 140e3,
        e2: 9e3,
        g12: 5e3,
        nu12: 0.3,
        alpha1: 0.0,
        alpha2: 3e-5,
        thickness: 0.125,
    };
    let strengths = Strengths::in_plane(1500.0, 1200.0, 50.0, 200.0, 70.0);
    Ply::new("carbon", constants, strengths).unwrap()
}

fn scene() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("soft-joint.toml")
}

fn stickslip(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_custom-law"))
        .args(arguments)
        .output()
        .expect("the binary was built for this test")
}

#[test]
fn both_keep_their_contracts() {
    let sample = CriterionSample::default_for(ply(), [1200.0, 200.0, 70.0]);
    check_criterion(&Crushing, &sample).unwrap();

    let text = r#"{ "soft_shear": { "limit": 150.0 } }"#;
    let parameters: Box<dyn PointModelParameters> = serde_json::from_str(text).unwrap();
    let laminate = Laminate::new(&"[0/±45/90]s".parse().unwrap(), &ply()).unwrap();
    let criterion: Arc<dyn FailureCriterion> = Arc::new(Crushing);
    let sample = PointSample::default_for(0.02, -150.0);
    check_parameters(parameters.as_ref(), &laminate, &criterion, &sample).unwrap();
}

#[test]
fn a_scene_names_them_and_softer_shear_bears_less() {
    let peak = |limit: &str| {
        let folder = tempfile::tempdir().unwrap();
        let target = folder.path().join("results");
        let set = format!("failure.progressive.model.soft_shear.limit=\"{limit}\"");
        let scene = scene();
        let run = stickslip(&[
            "run",
            scene.to_str().unwrap(),
            "--json",
            "--set",
            &set,
            "--output",
            target.to_str().unwrap(),
        ]);
        let errors = String::from_utf8_lossy(&run.stderr);
        assert!(run.status.success(), "{errors}");
        let text = String::from_utf8_lossy(&run.stdout).into_owned();
        assert!(text.contains("shear levelling off at") && text.contains("crushing"));
        let summary: serde_json::Value = serde_json::from_str(&text).unwrap();
        let progressive = &summary["failure"][0]["progressive"];
        let curve = progressive["curve"].as_array();
        let last = curve.and_then(|curve| curve.last()?["load"]["value"].as_f64());
        last.unwrap_or_else(|| panic!("{progressive:#}"))
    };
    let [soft, hard] = ["40 MPa", "4 GPa"].map(peak);
    assert!(soft < 0.99 * hard, "{soft} {hard}");
}

#[test]
fn its_parameters_carry_units_and_ranges() {
    for (value, word) in [("40", "unit"), ("-1 MPa", "limit = -1"), ("3 mm", "stress")] {
        let set = format!("failure.progressive.model.soft_shear.limit={value}");
        let refused = stickslip(&["check", scene().to_str().unwrap(), "--set", &set]);
        assert!(!refused.status.success());
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(message.contains(word), "{value}: {message}");
    }
    let list = stickslip(&["list"]);
    let list = String::from_utf8_lossy(&list.stdout);
    assert!(
        list.contains("crushing") && list.contains("soft_shear"),
        "{list}"
    );
}
