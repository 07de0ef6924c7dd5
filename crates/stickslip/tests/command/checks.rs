//! `check`, and overrides.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::{Value, json};

use super::{SCENE, fails, folder_with, succeeds};

fn scenes() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes");
    let files = fs::read_dir(folder)
        .unwrap()
        .map(|entry| entry.unwrap().path());
    let mut scenes: Vec<_> = files
        .filter(|path| path.extension().is_some_and(|end| end == "toml"))
        .collect();
    scenes.sort();
    assert!(scenes.len() >= 13);
    scenes
}

#[test]
fn run_prints_its_warnings_below_the_table() {
    let folder = folder_with("pin.toml", SCENE);
    let run = ["run", "pin.toml", "--output", "out", "--set"];
    let penalty = [
        "analysis.solver=penalty",
        "--set",
        "analysis.experimental=true",
    ];
    let printed = succeeds(folder.path(), &[&run[..], &penalty[..]].concat());
    let after = printed.split_once("\n\nwarning: The answer is not verified");
    let (table, rest) = after.unwrap_or_else(|| panic!("{printed}"));
    assert!(
        table.contains("Contact '")
            && rest.starts_with(" in load steps 1–2:")
            && rest.contains("\n\nresults in out\n"),
        "{printed}"
    );
    // Errors of this mesh are stated on request only.
    let unstated = "\n\nNo errors are stated: `--set analysis.accuracy=";
    assert!(rest.contains(unstated), "{printed}");
    let asked = [
        "run",
        "pin.toml",
        "--output",
        "asked",
        "--set",
        "analysis.accuracy=10 %",
    ];
    let printed = succeeds(folder.path(), &asked);
    assert!(!printed.contains(unstated), "{printed}");
}

#[test]
fn every_scene_passes_its_check_and_says_what_it_shows() {
    for scene in scenes() {
        let printed = succeeds(Path::new("."), &["check", scene.to_str().unwrap()]);
        assert!(
            printed.contains("\n# mesh") && printed.contains("\nversion = 1\n"),
            "{printed}"
        );
        let header = fs::read_to_string(&scene).unwrap();
        assert!(header.starts_with("# "), "{}", scene.display());
    }
}

#[test]
fn check_prints_a_scene_that_checks_again() {
    let folder = folder_with("pin.toml", SCENE);
    let first = succeeds(folder.path(), &["check", "pin.toml"]);
    fs::write(folder.path().join("again.toml"), &first).unwrap();
    let second = succeeds(folder.path(), &["check", "again.toml"]);
    let scene = |printed: &str| printed[printed.find("\nversion").unwrap()..].to_owned();
    assert_eq!(scene(&first), scene(&second));
    assert!(
        first.contains("solver = \"auto\"") && first.contains("gap = \"exact\""),
        "{first}"
    );
    assert!(first.contains("# choice"), "{first}");
}

#[test]
fn check_in_json_and_quietly() {
    let folder = folder_with("pin.toml", SCENE);
    let value: Value =
        serde_json::from_str(&succeeds(folder.path(), &["check", "pin.toml", "--json"])).unwrap();
    assert_eq!(
        (&value["title"], &value["steps"]),
        (&Value::from("Pin"), &Value::from(2))
    );
    assert_eq!(value["resolved"]["mesh"]["element"], "Q8");
    assert_eq!(value["hash"].as_str().unwrap().len(), 64);
    assert_eq!(value["findings"], json!([]));
    let wide = [
        "check",
        "pin.toml",
        "--json",
        "--set",
        "bodies.pin.thickness=1 mm",
    ];
    let value: Value = serde_json::from_str(&succeeds(folder.path(), &wide)).unwrap();
    let finding = &value["findings"][0];
    assert_eq!(finding["kind"], "unequal_thickness");
    assert_eq!(
        finding["thickness"][1],
        json!({ "value": 1.0, "unit": "mm" })
    );
    assert_eq!(
        succeeds(folder.path(), &["check", "pin.toml", "--quiet"]),
        ""
    );
}

#[test]
fn overrides() {
    let folder = folder_with("pin.toml", SCENE);
    let check = |overrides: &[&str]| {
        let mut arguments = vec!["check", "pin.toml", "--json"];
        for argument in overrides {
            arguments.extend(["--set", argument]);
        }
        serde_json::from_str::<Value>(&succeeds(folder.path(), &arguments)).unwrap()["resolved"]
            .clone()
    };
    let scene = check(&[
        "mesh.spacing=9 deg",
        "contacts.0.friction.static_dynamic={ static = 0.3, dynamic = 0.2 }",
    ]);
    assert_eq!(scene["mesh"]["spacing"], "9 deg");
    assert!(scene["contacts"][0]["friction"].get("coulomb").is_none());
    assert_eq!(
        scene["contacts"][0]["friction"]["static_dynamic"]["static"],
        0.3
    );
    let scene = check(&["analysis.substeps=4", "edges.0.on=plate.top"]);
    assert_eq!(
        (&scene["analysis"]["substeps"], &scene["edges"][0]["on"]),
        (&Value::from(4), &Value::from("plate.top"))
    );
    let message = fails(
        folder.path(),
        &[
            "check",
            "pin.toml",
            "--set",
            "contacts.0.friction.coulomb.mu=-0.15",
        ],
    );
    for part in [
        "--set:1:",
        "contacts.0.friction.coulomb.mu=-0.15",
        "mu = -0.15 is outside [0, ∞)",
        "help:",
    ] {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
    let message = fails(
        folder.path(),
        &["check", "pin.toml", "--set", "mesh.spacing"],
    );
    assert!(
        message.contains("is not of the form key=value"),
        "{message}"
    );
}

#[test]
fn check_shows_the_moduli_of_a_laminate_and_run_prints_its_failure() {
    let laminate = SCENE
        .replace(
            "[materials.steel.isotropic]",
            "[plies.carbon]\ne1 = \"135 GPa\"\ne2 = \"10 GPa\"\ng12 = \"5.8 GPa\"\nnu12 = 0.28\nthickness = \"0.25 mm\"\n\
             strengths = { xt = \"1500 MPa\", xc = \"1200 MPa\", yt = \"50 MPa\", yc = \"200 MPa\", s12 = \"70 MPa\" }\n\
             [failure]\ncriteria = [\"max_stress\"]\n[failure.characteristic]\ntension = \"1 mm\"\ncompression = \"2 mm\"\n\
             [output]\nfigures = false\n\
             [materials.skin.laminate]\nlayup = \"[0/±45/90]s\"\nply = \"carbon\"\n[materials.steel.isotropic]",
        )
        .replacen("material = \"steel\"\nthickness = \"2 mm\"", "material = \"skin\"", 1);
    let folder = folder_with("pin.toml", &laminate);
    let printed = succeeds(folder.path(), &["check", "pin.toml"]);
    for part in [
        "# laminate skin: [0/±45/90]s, 8 plies, 2 mm thick",
        "# laminate skin: Ex ",
        "coupling of stretching with bending",
        "# failure  max_stress in the plies of plate",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    let printed = succeeds(folder.path(), &["run", "pin.toml", "--output", "out"]);
    for part in [
        "Failure of 'plate', lay-up [0/±45/90]s",
        "first ply",
        "characteristic curve",
        "maximum stress: on the characteristic curve",
        "'plate' has its first crack in a ply, ",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    // What check prints is a scene again.
    let turned = succeeds(
        folder.path(),
        &[
            "check",
            "pin.toml",
            "--set",
            "materials.skin.laminate.layup=[0/90_2/0]s",
        ],
    );
    fs::write(folder.path().join("again.toml"), &turned).unwrap();
    let again = succeeds(folder.path(), &["check", "again.toml"]);
    assert!(again.contains("[0/90_2/0]s, 8 plies"), "{again}");
}

/// A sketch names bodies and their sets, and has cells where the scene gives a mesh.
#[test]
fn sketches_name_bodies_and_sets() {
    let folder = folder_with("scene.toml", SCENE);
    let drawn = |further: &[&str]| {
        let arguments = ["check", "scene.toml", "--sketch", "sketch.svg"];
        succeeds(folder.path(), &[&arguments[..], further].concat());
        let svg = fs::read_to_string(folder.path().join("sketch.svg")).unwrap();
        fs::remove_file(folder.path().join("sketch.svg")).unwrap();
        move |text: &str| svg.contains(&format!(">{text}<"))
    };
    let whole = drawn(&[
        "--set",
        "analysis.model=whole",
        "--set",
        "mesh.spacing=15 deg",
    ]);
    for text in [
        "plate",
        "pin",
        "left",
        "hole",
        "cells",
        "edges in contact",
        "held",
        "loads",
    ] {
        assert!(whole(text), "{text}");
    }
    assert!(whole("rim") && !whole("platens"));
    // A name that is longer than its edge is left out, and so are too many cells.
    let long = "bodies.plate.shape.plate_with_hole.outline.strip.left=900 mm";
    let wide = drawn(&["--set", long]);
    assert!(wide("top") && !wide("rim"));
    // So is one over the cross of the pin's support.
    let small = "bodies.plate.shape.plate_with_hole.outline.strip.left=200 mm";
    let crossed = drawn(&["--set", small, "--set", "analysis.model=whole"]);
    assert!(crossed("top") && !crossed("rim"));
    let finer = drawn(&["--set", "mesh.spacing=1 deg"]);
    assert!(finer("left") && !finer("cells"));
}
