//! Scenes as they are modelled: chains of round bodies, several contacts, halves and wholes, remarks.

mod bearing;
mod blocks;
mod chains;
mod cutouts;
mod deformed;
mod displacement;
mod edges;
mod frames;
mod half_plane;
mod halves;
mod heated;
mod increments;
mod ladder;
mod layers;
mod mortar;
mod open;
mod outline;
mod patterns;
mod remarks;
mod series;
mod several;
mod sharing;
mod singular;
mod splines;
mod springs;
mod stated;
mod travel;
mod turned;
mod unbalanced;
mod yields;

use std::path::Path;

use stickslip::diagnostic::Finding;
use stickslip::host::HOST;
use stickslip::model::Model;
use stickslip::results::{EdgeRow, Results};
use stickslip::run;
use stickslip::scene::{Format, Scene};

/// A pin in a bushing in a strip; one elastic constant for all, coarse.
const BUSHING: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "7 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.bushing]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "6.99 mm" } }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = { radius = "4.98 mm" }
[mesh]
spacing = "6 deg"
[[contacts]]
first = "plate.hole"
second = "bushing.outer"
friction.coulomb = { mu = 0.3 }
[[contacts]]
first = "bushing.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN", "4 kN", "1 kN"] }
[output]
fields = "none"
figures = false
"#;

/// Messages and remedies of a scene that is refused.
fn refusal(folder: &Path, text: &str, changes: &[&str]) -> String {
    let read = Scene::from_text_on(text, Format::Toml, "scene.toml", folder, changes, HOST);
    let error = read.map(|_| changes).expect_err("a refusal");
    let summaries = error.findings().iter().map(Finding::summary);
    let texts = summaries.map(|own| {
        let line = own.line.expect("a line");
        format!("{line}: {} {}", own.message, own.help.unwrap_or_default())
    });
    texts.collect::<Vec<_>>().join("\n")
}

/// A scene with changes as by `--set`, with data files in `base`.
fn scene_in(base: &Path, text: &str, changes: &[&str]) -> Scene {
    Scene::from_text_on(text, Format::Toml, "scene.toml", base, changes, HOST)
        .unwrap_or_else(|error| panic!("{error} with {changes:?}"))
}

fn scene(text: &str, changes: &[&str]) -> Scene {
    scene_in(Path::new(""), text, changes)
}

fn model(text: &str, changes: &[&str]) -> Model {
    Model::build(&scene(text, changes)).unwrap_or_else(|error| panic!("{error} with {changes:?}"))
}

fn results(scene: &Scene) -> Results {
    run::run(scene, &mut |_| {}).unwrap_or_else(|error| panic!("{error} in\n{}", scene.resolved()))
}

fn solved(text: &str, changes: &[&str]) -> Results {
    results(&scene(text, changes))
}

/// Rows of an edge at the end of a step, from θ = 0 or x = 0 upwards: the half that half and whole models share.
fn upper(results: &Results, step: usize, edge: usize) -> Vec<EdgeRow> {
    let rows = &results.steps[step].edges[edge].rows;
    let places = &results.edges[edge].parameter;
    let pairs = rows.iter().zip(places);
    pairs
        .filter(|(_, at)| **at > -1e-9)
        .map(|(row, _)| *row)
        .collect()
}

/// Largest difference of two lists relative to the largest number of the first.
fn difference(one: impl IntoIterator<Item = f64>, other: impl IntoIterator<Item = f64>) -> f64 {
    let (mut largest, mut apart) = (0.0_f64, 0.0_f64);
    for (one, other) in one.into_iter().zip(other) {
        largest = largest.max(one.abs());
        apart = apart.max((one - other).abs());
    }
    apart / largest
}

fn tractions(rows: &[EdgeRow]) -> Vec<f64> {
    rows.iter()
        .flat_map(|row| [row.pressure, row.shear])
        .collect()
}
