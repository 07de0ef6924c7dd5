//! A pin-loaded plate without a mesh: its largest pressure and hoop stress, each with its error.
//!
//! Run with `cargo run --release -p stickslip-ladder --example accuracy`.

use std::error::Error;
use std::path::Path;

use stickslip_engine::results::Stated;
use stickslip_ladder::run;
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
[analysis]
accuracy = "1 %"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["2 kN"] }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let overrides: [&str; 0] = [];
    let scene = Scene::from_text(TEXT, Format::Toml, "pin.toml", Path::new(""), &overrides)?;
    let results = run(&scene, &mut |_| {})?;
    let edge = &results.steps[0].edges[0];
    for stated in [Stated::PeakPressure, Stated::PeakHoop] {
        let value = stated.value(edge).ok_or("no contact")?;
        let error = edge.errors.get(stated).ok_or("no error")?;
        println!("{}: {value:.2} ± {error:.2} MPa", stated.describe());
    }
    if let Some(ladder) = &results.ladder {
        println!("{} models", ladder.rungs.len());
    }
    Ok(())
}
