//! Reads a scene from a text, changes a key, and shows what is reported about mistakes and which pressure the model gets.
//!
//! Run with `cargo run --release -p stickslip-scene --example read`.

use std::path::Path;

use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::{Format, Scene};

const TEXT: &str = r#"
version = 1
[materials.steel.isotropic]
young = "30 Msi"
poisson = 0.3
[bodies.plate]
material = "steel"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "2 in" } }
[mesh]
spacing = "5 deg"
[[supports]]
on = "plate.outer"
fix = ["x", "y"]
[[loads]]
on = "plate.hole"
pressure.steps = ["10 MPa", "20 MPa"]
"#;

fn read(overrides: &[&str]) -> Result<Scene, SceneError> {
    Scene::from_text(TEXT, Format::Toml, "press.toml", Path::new("."), overrides)
}

fn main() -> Result<(), SceneError> {
    if let Err(error) = read(&["mesh.spacing=5 mm", "materials.steel.isotropic.poisson=0.6"]) {
        println!("{error}");
        for finding in error.findings() {
            println!("  {}: {}", finding.key, finding.problem);
        }
    }
    let scene = read(&["loads.0.pressure.steps=[\"3 ksi\"]"])?;
    let pressure = scene.loads[0].kind.steps()[0];
    // 1 psi is 6.894757 kPa.
    assert!((pressure - 20.684271).abs() < 1e-5);
    println!("{}: {pressure:.3} MPa", scene.loads[0].name);
    Ok(())
}
