//! Reads an experiment from a text, and shows between which bounds friction is looked for.
//!
//! Run with `cargo run --release -p stickslip-experiment --example range`. The data are not read.

use std::path::Path;

use stickslip_experiment::{Candidate, Experiment};
use stickslip_scene::Format;
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::host::Host;

const TEXT: &str = r#"
version = 1
[specimen]
material.isotropic = { young = "10.4 Msi", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "0.375 in" }
[[states]]
name = "up"
table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
[[laws]]
friction.coulomb = { mu = 0.3 }
free.mu = [0.05, 0.6]
"#;

fn main() -> Result<(), SceneError> {
    let (folder, none) = (Path::new("."), &[] as &[&str]);
    let read = |text: &str| {
        Experiment::from_text(text, Format::Toml, "mine.toml", folder, none, Host::NONE)
    };
    if let Err(error) = read(&TEXT.replace("0.375 in", "-1 in")) {
        println!("{error}");
    }
    let experiment = read(TEXT)?;
    let radius = experiment.specimen.hole.radius;
    assert!((radius - 9.525).abs() < 1e-12);
    for plan in &experiment.laws {
        let candidate = Candidate::new(plan)
            .map_err(|(key, problem)| experiment.error_at(&format!("laws.0.{key}"), *problem))?;
        let [low, high] = candidate.parameters[0].range;
        println!(
            "hole of {radius:.3} mm: {} from {low} to {high}",
            candidate.parameters[0].name
        );
    }
    Ok(())
}
