//! The law meets the contract, and its crate's binary runs it in a scene by name.

use std::path::Path;
use std::process::{Command, Output};

use custom_law as _;
use stickslip_friction::{FrictionLaw, Mirror, contract};

fn stickslip(arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_custom-law"))
        .args(arguments)
        .output()
        .expect("the binary was built for this test")
}

#[test]
fn meets_the_contract() {
    let text = r#"{ "running_in": { "fresh": 0.05, "worn": 0.3, "slip_scale": 0.01 } }"#;
    let law: Box<dyn FrictionLaw> = serde_json::from_str(text).unwrap();
    contract::check(law.as_ref(), &contract::Sample::default_for(100.0, 1e-2)).unwrap();
    // The claim keeps half models for it.
    let about_x = Mirror {
        line: 0.0,
        material_angle: 0.0,
    };
    assert!(law.is_symmetric(&about_x));
}

#[test]
fn a_scene_names_it_and_the_coating_wears_in() {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("coated-pin.toml");
    let folder = tempfile::tempdir().unwrap();
    let target = folder.path().join("results");
    let run = stickslip(&[
        "run",
        scene.to_str().unwrap(),
        "--json",
        "--output",
        target.to_str().unwrap(),
    ]);
    assert!(
        run.status.success(),
        "{}",
        String::from_utf8_lossy(&run.stderr)
    );
    let summary: serde_json::Value = serde_json::from_slice(&run.stdout).unwrap();
    let hoop = |step: usize| {
        summary["steps"][step]["peak_hoop_over_bearing"]
            .as_f64()
            .unwrap()
    };
    // Friction raises the hoop stress at the end of contact, so wear shows from cycle to cycle at the same load.
    assert!(
        hoop(0) < hoop(2) && hoop(2) < hoop(4),
        "{} {} {}",
        hoop(0),
        hoop(2),
        hoop(4)
    );
}

#[test]
fn its_parameters_carry_units_and_ranges() {
    let scene = Path::new(env!("CARGO_MANIFEST_DIR")).join("coated-pin.toml");
    for (value, word) in [
        ("0.0005", "unit"),
        ("-1 in", "slip_scale"),
        ("3 psi", "length"),
    ] {
        let set = format!("contacts.0.friction.running_in.slip_scale={value}");
        let refused = stickslip(&["check", scene.to_str().unwrap(), "--set", &set]);
        assert!(!refused.status.success());
        let message = String::from_utf8_lossy(&refused.stderr).into_owned();
        assert!(message.contains(word), "{value}: {message}");
    }
    let list = stickslip(&["list"]);
    assert!(String::from_utf8_lossy(&list.stdout).contains("running_in"));
}
