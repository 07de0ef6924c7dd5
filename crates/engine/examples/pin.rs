//! A pin-loaded plate from its text to its largest pressure and hoop stress.
//!
//! Run with `cargo run --release -p stickslip-engine --example pin`.

use std::error::Error;
use std::path::Path;

use stickslip_engine::run::{run_with, solver};
use stickslip_scene::{Format, Scene};

const TEXT: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.plate]
material = "aluminium"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.strip = { half_width = "20 mm", left = "80 mm", right = "20 mm" } }
[bodies.pin]
material = "aluminium"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "3 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["2 kN", "4 kN", "1 kN"] }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let overrides: [&str; 0] = [];
    let scene = Scene::from_text(TEXT, Format::Toml, "pin.toml", Path::new(""), &overrides)?;
    let solver = solver(scene.analysis.solver);
    let results = run_with(&scene, solver.as_ref(), &mut |_| {})?;
    for (index, step) in results.steps.iter().enumerate() {
        let hole = &step.edges[0].rows;
        let pressure = hole.iter().map(|row| row.pressure).fold(0.0, f64::max);
        let hoop = hole
            .iter()
            .map(|row| row.sigma_tangential)
            .fold(0.0, f64::max);
        println!(
            "step {}: largest pressure {pressure:.1} MPa, hoop stress {hoop:.1} MPa",
            index + 1
        );
    }
    Ok(())
}
