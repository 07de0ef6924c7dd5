//! Scenes that stand in files because their numbers were drawn at random.

use std::path::{Path, PathBuf};

use serde_json::Value;
use stickslip::host::HOST;
use stickslip::results::Results;
use stickslip::run::{self, RunError};
use stickslip::scene::{Format, Scene};

fn text(name: &str) -> String {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("scenes");
    let path = folder.join(name).with_extension("json");
    std::fs::read_to_string(&path).unwrap_or_else(|cause| panic!("{}: {cause}", path.display()))
}

fn solve(text: &str, name: &str, changes: &[&str]) -> Result<Results, RunError> {
    let scene = Scene::from_text_on(text, Format::Json, name, Path::new(""), changes, HOST)
        .unwrap_or_else(|cause| panic!("{name}: {cause:?}"));
    run::run(&scene, &mut |_| {})
}

/// Runs `tests/scenes/<name>.json` with `changes` as by `--set`.
///
/// # Panics
/// Without such a scene, and where it is refused or not solved.
pub(crate) fn solved(name: &str, changes: &[&str]) -> Results {
    solve(&text(name), name, changes).unwrap_or_else(|cause| panic!("{name} {changes:?}: {cause}"))
}

/// Runs the same scene with all lengths times `length`, moduli times `modulus`, and forces as that makes them.
///
/// # Panics
/// As [`solved`].
pub(crate) fn scaled(name: &str, length: f64, modulus: f64) -> Results {
    let mut scene: Value =
        serde_json::from_str(&text(name)).unwrap_or_else(|cause| panic!("{name}: {cause}"));
    scale(&mut scene, length, modulus);
    solve(&scene.to_string(), name, &[])
        .unwrap_or_else(|cause| panic!("{name} × {length:e}, {modulus:e}: {cause}"))
}

fn scale(value: &mut Value, length: f64, modulus: f64) {
    match value {
        Value::Array(list) => list
            .iter_mut()
            .for_each(|item| scale(item, length, modulus)),
        Value::Object(table) => table
            .values_mut()
            .for_each(|item| scale(item, length, modulus)),
        Value::String(text) => {
            let Some((number, unit)) = text.split_once(' ') else {
                return;
            };
            let factor = match unit {
                "mm" => length,
                "N" => modulus * length * length,
                "MPa" | "GPa" => modulus,
                _ => return,
            };
            if let Ok(number) = number.parse::<f64>() {
                *text = format!("{:e} {unit}", number * factor);
            }
        }
        _ => {}
    }
}
