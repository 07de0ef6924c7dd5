//! Experiments as their users meet them: synthetic pictures, measured fields from every kind of data, and what bad data say.

mod assumed;
mod backs;
mod balance;
mod bearing;
mod chain;
mod commands;
mod deviations;
mod foreign;
mod friction;
mod lines;
mod lists;
mod margins;
mod materials;
mod meshes;
mod models;
mod pictures;
mod places;
mod ready;
mod reductions;
mod refusals;
mod rotation;
mod stated;
mod stresses;
mod tables;

use std::fmt::Write as _;
use std::fs;
use std::path::Path;
use std::process::{Command, Output};

use serde_json::Value;
use tempfile::TempDir;

/// A quick scene: aluminium pin and plate, loaded in two steps and unloaded in one.
const SCENE: &str = r#"version = 1
[materials.aluminium.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "aluminium"
thickness = "1.5 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.pin]
material = "aluminium"
thickness = "1.5 mm"
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
force = { direction = [-1, 0], steps = ["0.1 kN", "1 kN", "0.5 kN"] }
"#;

/// Pictures of it: 250 x 250 pixels, carriers of 0.24 fringes per pixel.
const FRINGES: &str = r#"version = 1
title = "Pin"
[specimen]
scene = "scene.toml"
body = "plate"
[grating]
frequency = "2400 1/mm"
[fringes]
window = [["2 mm", "-5 mm"], ["12 mm", "5 mm"]]
pixel = "0.04 mm"
carrier = { u = ["6 1/mm", "0 1/mm"], v = ["0 1/mm", "6 1/mm"] }
"#;

/// A state of a table that a test writes.
const TABLE: &str = r#"version = 1
[specimen]
material.isotropic = { young = "70 GPa", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "5 mm" }
[[states]]
name = "up"
table = { file = "up.csv", scale = "1 mm", y_axis = "up", deviation = "1e-4 mm" }
"#;

/// A folder with these files.
fn folder_with(files: &[(&str, &str)]) -> TempDir {
    let folder = TempDir::new().unwrap();
    for (name, text) in files {
        fs::write(folder.path().join(name), text).unwrap();
    }
    folder
}

fn stickslip(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .current_dir(folder)
        .args(arguments)
        .output()
        .unwrap()
}

/// Runs a command that must succeed; its summary.
fn succeeds(folder: &Path, arguments: &[&str]) -> Value {
    let output = stickslip(folder, &[arguments, &["--json"]].concat());
    let error = String::from_utf8(output.stderr).unwrap();
    assert!(output.status.success() && error.is_empty(), "{error}");
    serde_json::from_slice(&output.stdout).unwrap()
}

/// The findings of a summary that have this kind.
fn findings<'a>(summary: &'a Value, kind: &str) -> Vec<&'a Value> {
    let all = summary["findings"].as_array().unwrap().iter();
    all.filter(|own| own["kind"] == kind).collect()
}

/// The only finding of this kind, with its level.
fn finding<'a>(summary: &'a Value, kind: &str, level: &str) -> &'a Value {
    let [own] = findings(summary, kind)[..] else {
        panic!("{kind}: {summary}");
    };
    assert_eq!(own["level"], level, "{own}");
    own
}

/// Whether `value` is the number `expected`, but for rounding of decimal digits.
fn close(value: &Value, expected: f64) -> bool {
    value
        .as_f64()
        .is_some_and(|own| (own - expected).abs() <= 1e-9 * expected.abs())
}

/// Runs a command that must fail; its standard error.
fn fails(folder: &Path, arguments: &[&str]) -> String {
    let output = stickslip(folder, arguments);
    assert_eq!(output.status.code(), Some(1), "{arguments:?}");
    assert!(output.stdout.is_empty());
    String::from_utf8(output.stderr).unwrap()
}

/// The numbers of a table, without its header; NaN where empty.
fn numbers(path: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path).unwrap();
    let row = |line: &str| {
        let cells = line.split(',');
        cells.map(|cell| cell.parse().unwrap_or(f64::NAN)).collect()
    };
    text.lines().skip(1).map(row).collect()
}

/// A grid of places around the hole with the displacements `u` as text of a table.
fn grid(header: &str, u: impl Fn(f64, f64) -> [f64; 2]) -> String {
    let mut text = format!("{header}\n");
    for i in -12..=12 {
        for j in -12..=12 {
            let (x, y) = (f64::from(i), f64::from(j));
            if x.hypot(y) > 5.0 {
                let [u, v] = u(x, y);
                writeln!(text, "{x},{y},{u:e},{v:e}").unwrap();
            }
        }
    }
    text
}
