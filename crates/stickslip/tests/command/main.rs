//! The command as its users meet it: exit codes, streams, and messages with file, line, value and remedy.

mod checks;
mod conflicts;
mod files;
mod folders;
mod limits;
mod lists;
mod meshes;
mod particular;
mod refusals;
mod texts;

use std::fs;
use std::path::Path;
use std::process::{Command, Output};

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
