//! The command as its users meet it: exit codes, streams, and messages with file, line, value and remedy.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

const SCENE: &str = r#"version = 1
title = "Pin"
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
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "6 deg"
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN", "2 kN"] }
"#;

fn stickslip(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap()
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

/// Runs a command that must succeed silently on standard error; its standard output.
fn succeeds(folder: &Path, arguments: &[&str]) -> String {
    let output = stickslip(folder, arguments);
    assert!(
        output.status.success(),
        "{arguments:?}: {}",
        text(&output.stderr)
    );
    assert_eq!(text(&output.stderr), "", "{arguments:?}");
    text(&output.stdout)
}

/// Runs a command that must fail with exit code 1 and no standard output; its standard error.
fn fails(folder: &Path, arguments: &[&str]) -> String {
    let output = stickslip(folder, arguments);
    assert_eq!(
        output.status.code(),
        Some(1),
        "{arguments:?}: {}",
        text(&output.stdout)
    );
    assert_eq!(text(&output.stdout), "", "{arguments:?}");
    text(&output.stderr)
}

fn folder_with(name: &str, scene: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join(name), scene).unwrap();
    folder
}

/// Checks the scene with `from` replaced by `to`; the message must hold every part.
#[track_caller]
fn refused(from: &str, to: &str, parts: &[&str]) {
    assert!(SCENE.contains(from), "{from}");
    let folder = folder_with("bad.toml", &SCENE.replacen(from, to, 1));
    let message = fails(folder.path(), &["check", "bad.toml"]);
    for part in parts {
        assert!(message.contains(part), "'{part}' is missing in:\n{message}");
    }
}

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
fn keys() {
    refused(
        "poisson =",
        "poison =",
        &[
            "bad.toml:5:1",
            "unknown key 'poison'",
            "did you mean 'poisson'?",
        ],
    );
    refused(
        "version = 1\n",
        "",
        &["bad.toml:1:1", "version", "add the line `version = 1`"],
    );
    refused(
        "version = 1",
        "version = 3",
        &[
            "bad.toml:1:11",
            "version 3",
            "this program reads `version = 1`",
        ],
    );
    refused(
        "young = \"210 GPa\"\n",
        "",
        &[
            "bad.toml:3:18",
            "'young' is missing",
            "add for example `young = \"70 GPa\"`",
        ],
    );
    refused(
        "title = \"Pin\"",
        "title = Pin",
        &["bad.toml:2:9", "this is not valid TOML", "double quotes"],
    );
    refused(
        "title = \"Pin\"",
        "title = \"a\"\ntitle = \"b\"",
        &["bad.toml:3:1", "duplicate key"],
    );
}

#[test]
fn quantities() {
    refused(
        "\"2 mm\"",
        "2",
        &[
            "bad.toml:8:13",
            "2 has no unit; a length is expected",
            "for example \"2 mm\"",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"2 MPa\"",
        &[
            "bad.toml:8:13",
            "expected a length, but \"2 MPa\" is a stress",
            "units that fit here: mm",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"2 inch\"",
        &[
            "bad.toml:8:13",
            "'inch' in \"2 inch\" is not a known unit",
            "mm, cm, m, um, in",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"-2 mm\"",
        &[
            "bad.toml:8:13",
            "thickness = -2 mm is outside its range",
            "greater than 0",
        ],
    );
    refused(
        "\"2 mm\"",
        "\"nan mm\"",
        &["bad.toml:8:13", "\"nan mm\" is not a finite number"],
    );
    refused(
        "mu = 0.2",
        "mu = inf",
        &["bad.toml:22:27", "inf is not a finite number"],
    );
    refused(
        "\"1 kN\",",
        "\"1e999 kN\",",
        &["bad.toml:28:41", "\"1e999 kN\" is not a finite number"],
    );
}

#[test]
fn materials_and_bodies() {
    refused(
        "poisson = 0.3",
        "poisson = 0.51",
        &[
            "bad.toml:5:11",
            "Poisson's ratio 0.51",
            "at most 0.5 in plane stress",
            "0.25 to 0.35",
        ],
    );
    refused(
        "material = \"steel\"",
        "material = \"stele\"",
        &[
            "bad.toml:7:12",
            "there is no material 'stele'",
            "did you mean 'steel'?",
        ],
    );
    refused(
        "\"4.99 mm\"",
        "\"5.25 mm\"",
        &[
            "bad.toml:15:25",
            "radius 5.25 mm",
            "radius 5 mm",
            "overlap by 0.25 mm",
            "interference = true",
        ],
    );
    refused(
        "half_width = \"20 mm\"",
        "half_width = \"4 mm\"",
        &["bad.toml:11:", "greater than the hole's radius, 5 mm"],
    );
}

#[test]
fn contacts_supports_and_loads() {
    refused(
        "friction.coulomb = { mu = 0.2 }",
        "",
        &[
            "bad.toml:18:",
            "contact 'pin' has no friction law",
            "friction.coulomb = { mu = 0 }",
        ],
    );
    refused(
        "on = \"pin.centre\"",
        "on = \"pin.top\"",
        &[
            "bad.toml:24:6",
            "'pin' (disk) has no edge or point 'top'",
            "pin.rim, pin.centre",
        ],
    );
    refused(
        "[[supports]]\non = \"pin.centre\"\nfix = [\"x\", \"y\"]\n",
        "",
        &[
            "bad.toml:12:",
            "nothing holds 'pin' and 'plate'",
            "[[supports]] on = \"pin.",
        ],
    );
    refused(
        "on = \"plate.left\"",
        "on = \"plate.end\"",
        &["bad.toml:27:6", "no edge 'end'", "plate.hole, plate.left"],
    );
    refused(
        "on = \"plate.left\"",
        "on = \"block.left\"",
        &["bad.toml:27:6", "there is no body 'block'", "pin, plate"],
    );
    let more = "[[loads]]\non = \"plate.top\"\npressure.steps = [\"1 MPa\"]\n[[loads]]";
    refused(
        "[[loads]]",
        more,
        &[
            "bad.toml:31:",
            "load 'load2' has 2 steps, but load 'load1' has 1",
            "same number of steps",
        ],
    );
}

#[test]
fn meshes_that_do_not_fit_into_memory() {
    refused(
        "\"6 deg\"",
        "\"1e-5 deg\"",
        &["bad.toml:17:11", "nodes", "GB", "make mesh.spacing larger"],
    );
}

#[test]
fn asymmetric_halves_are_refused_at_their_key() {
    let half = "[analysis]\nmodel = \"half\"\n[[loads]]\non = \"plate.top\"\npressure.steps = [\"1 MPa\", \"1 MPa\"]\n[[loads]]";
    refused(
        "[[loads]]",
        half,
        &[
            "bad.toml:27:9",
            "model = \"half\" asks for symmetry",
            "auto",
        ],
    );
}

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
fn json_scenes_point_at_their_lines() {
    let table: Value = toml::from_str(SCENE).unwrap();
    let pretty = serde_json::to_string_pretty(&table).unwrap();
    let folder = folder_with("pin.json", &pretty);
    succeeds(folder.path(), &["check", "pin.json"]);
    let bad = pretty.replacen("\"6 deg\"", "6", 1);
    let line = bad
        .lines()
        .position(|line| line.contains("\"spacing\""))
        .unwrap()
        + 1;
    fs::write(folder.path().join("bad.json"), &bad).unwrap();
    let message = fails(folder.path(), &["check", "bad.json"]);
    assert!(
        message.contains(&format!("bad.json:{line}:")) && message.contains("6 has no unit"),
        "{message}"
    );
}

#[test]
fn errors_in_json_carry_the_same_parts() {
    let folder = folder_with("bad.toml", &SCENE.replacen("poisson =", "poison =", 1));
    let errors: Value =
        serde_json::from_str(&fails(folder.path(), &["--json", "check", "bad.toml"])).unwrap();
    let error = &errors["errors"][0];
    assert_eq!(error["code"], "scene::unknown_key");
    assert_eq!(error["message"], "unknown key 'poison'");
    assert_eq!(
        (&error["source"], &error["line"], &error["column"]),
        (&"bad.toml".into(), &5.into(), &1.into())
    );
    assert_eq!(error["key"], "materials.steel.isotropic.poison");
    assert!(
        error["help"]
            .as_str()
            .unwrap()
            .contains("did you mean 'poisson'?")
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
    let message = fails(path, &with(&["pin.toml/results"]));
    assert!(
        message.contains("pin.toml") && message.contains("help:"),
        "{message}"
    );
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
fn list_names_laws_with_their_parameters() {
    let printed = succeeds(Path::new("."), &["list"]);
    for part in [
        "coulomb",
        "mu",
        "slip_scale",
        "default \"committed\"",
        "pin-infinite-plate",
        "Q9",
        "pivoting",
        "ksi",
    ] {
        assert!(printed.contains(part), "'{part}' is missing in:\n{printed}");
    }
    let laws: Value =
        serde_json::from_str(&succeeds(Path::new("."), &["list", "laws", "--json"])).unwrap();
    let names: Vec<_> = laws["laws"]
        .as_array()
        .unwrap()
        .iter()
        .map(|law| law["name"].as_str().unwrap())
        .collect();
    assert_eq!(
        names,
        [
            "coulomb",
            "fibre_coverage",
            "pressure_power",
            "slip_power",
            "static_dynamic"
        ]
    );
}

#[test]
fn senseless_arguments_exit_with_two() {
    for arguments in [&["solve"][..], &["check"], &["list", "everything"], &[]] {
        let output = stickslip(Path::new("."), arguments);
        assert_eq!(output.status.code(), Some(2), "{arguments:?}");
        assert!(!output.stderr.is_empty());
    }
    assert!(stickslip(Path::new("."), &["--help"]).status.success());
}
