//! Files that are read and written, and never lost.

use std::fs;

use serde_json::Value;
use tempfile::TempDir;

use super::{SCENE, fails, folder_with, succeeds};

#[test]
fn files() {
    let folder = TempDir::new().unwrap();
    let message = fails(folder.path(), &["check", "none.toml"]);
    assert!(
        message.contains("the scene file 'none.toml' does not exist")
            && message.contains("stickslip init"),
        "{message}"
    );
    let message = fails(folder.path(), &["check", "."]);
    assert!(message.contains("the file '.' cannot be read"), "{message}");
    fs::write(folder.path().join("latin.toml"), b"title = \"caf\xe9\"").unwrap();
    let message = fails(folder.path(), &["check", "latin.toml"]);
    assert!(
        message.contains("'latin.toml' cannot be read") && message.contains("UTF-8"),
        "{message}"
    );
}

#[test]
fn results_are_never_lost_by_accident() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    let run = [
        "run",
        "pin.toml",
        "--set",
        "output.figures=false",
        "--output",
    ];
    let with = |more: &[&'static str]| [&run[..], more].concat();
    let printed = succeeds(path, &with(&["results"]));
    assert!(printed.contains("results"), "{printed}");
    assert!(path.join("results/summary.json").exists());

    let message = fails(path, &with(&["results"]));
    assert!(
        message.contains("results") && message.contains("exists"),
        "{message}"
    );
    assert!(
        message.contains("--force") && message.contains("--output"),
        "{message}"
    );
    let summary = succeeds(path, &with(&["results", "--force", "--json"]));
    assert!(serde_json::from_str::<Value>(&summary).is_ok(), "{summary}");

    fs::create_dir(path.join("letters")).unwrap();
    fs::write(path.join("letters/one.txt"), "dear").unwrap();
    fails(path, &with(&["letters", "--force"]));
    assert_eq!(
        fs::read_to_string(path.join("letters/one.txt")).unwrap(),
        "dear"
    );

    // A file where a folder should be cannot be written into, whoever asks.
    for target in ["pin.toml", "pin.toml/results"] {
        let message = fails(path, &with(&[target, "--force"]));
        for part in [target, "'pin.toml' is a file, not a folder", "--output DIR"] {
            assert!(message.contains(part), "'{part}' is missing in:\n{message}");
        }
    }
    assert_eq!(fs::read_to_string(path.join("pin.toml")).unwrap(), SCENE);
    let names = fs::read_dir(path)
        .unwrap()
        .map(|entry| entry.unwrap().file_name());
    assert_eq!(names.count(), 3, "nothing else is left behind");
}

#[test]
fn init_writes_scenes_that_check_and_never_overwrites() {
    let folder = TempDir::new().unwrap();
    for template in [
        "pin-loaded-plate",
        "pin-infinite-plate",
        "laminate-joint",
        "hertz",
        "open-hole",
    ] {
        let file = format!("{template}.toml");
        let printed = succeeds(folder.path(), &["init", template]);
        assert!(
            printed.contains(&format!("next: stickslip check {file}")),
            "{printed}"
        );
        succeeds(folder.path(), &["check", &file]);
        let message = fails(folder.path(), &["init", template]);
        assert!(
            message.contains("exists already")
                && message.contains(&format!("stickslip init {template} ")),
            "{message}"
        );
    }
    succeeds(folder.path(), &["init", "open-hole", "mine.toml"]);
    succeeds(folder.path(), &["check", "mine.toml"]);
    let message = fails(folder.path(), &["init", "open-hol"]);
    assert!(
        message.contains("there is no template 'open-hol'")
            && message.contains("pin-loaded-plate, "),
        "{message}"
    );
    let message = fails(folder.path(), &["init", "open-hole", "nowhere/mine.toml"]);
    assert!(
        message.contains("'nowhere/mine.toml' cannot be written"),
        "{message}"
    );
}

#[test]
fn the_template_of_a_laminate_reports_load_ply_and_mode() {
    let folder = TempDir::new().unwrap();
    succeeds(folder.path(), &["init", "laminate-joint"]);
    let run = ["run", "laminate-joint.toml", "--output", "out", "--set"];
    let coarse = ["mesh.spacing=6 deg", "--set", "output.figures=false"];
    let printed = succeeds(folder.path(), &[&run[..], &coarse].concat());
    for part in [
        "Failure of 'plate', lay-up [0/±45/90]s",
        "first ply",
        "Yamada–Sun: on the characteristic curve",
        "'plate' fails by ",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    assert!(!printed.contains("mixed:"), "{printed}");
}
