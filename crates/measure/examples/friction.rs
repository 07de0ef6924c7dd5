//! Makes fringe pictures of a pin-loaded plate, and finds its coefficient of friction again from the pictures alone.
//!
//! Run with `cargo run --release -p stickslip-measure --example friction`. The program has no files: what is read is held in memory.

use std::error::Error;
use std::path::Path;

use stickslip_experiment::Experiment;
use stickslip_experiment::stickslip_hybrid::identify::Bounds;
use stickslip_measure::ExperimentError;
use stickslip_measure::chain::{Album, Depth, run};
use stickslip_measure::synthesis::{Camera, Shots};
use stickslip_scene::Format;
use stickslip_scene::host::{Host, MemoryFiles};

const SCENE: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.plate]
material = "aluminium"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "9.5 mm", outline.strip = { half_width = "38 mm", left = "178 mm", right = "38 mm" } }
[bodies.pin]
material = "aluminium"
thickness = "2 mm"
shape.disk = { radius = "9.49 mm" }
[mesh]
spacing = "1.5 deg"
fine_to = "100 deg"
coarse_spacing = "4.5 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.25 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["3 kN"] }
"#;

const EXPERIMENT: &str = r#"
version = 1
[specimen]
scene = "pin.toml"
body = "plate"
edge = "hole"
[grating]
frequency = "2400 1/mm"
[fringes]
window = [["-4.2 mm", "-2.1 mm"], ["12.8 mm", "12.8 mm"]]
pixel = "0.018 mm"
carrier = { u = ["14 1/mm", "0 1/mm"], v = ["0 1/mm", "14 1/mm"] }
order_error = 0.25
seed = 1
[[states]]
name = "up"
step = 1
[reduce]
method = "fit"
margin = "0.1 mm"
[region]
sector = { angles = ["-8 deg", "108 deg"], outer = "12.5 mm", cells = [48, 12], growth = 2.0 }
smoothing = { order = 2, amount = 10.0 }
"#;

/// Keeps no picture.
struct NoAlbum;

impl Album for NoAlbum {
    fn add(&mut self, _: &Camera<'_>, _: usize, _: &Shots) -> Result<(), ExperimentError> {
        Ok(())
    }

    fn complete(&mut self, _: &Camera<'_>) {}
}

fn main() -> Result<(), Box<dyn Error>> {
    let host = Host::of(MemoryFiles::from_iter([("pin.toml", SCENE)]));
    let folder = Path::new("");
    let overrides: [&str; 0] = [];
    let experiment = Experiment::from_text(
        EXPERIMENT,
        Format::Toml,
        "experiment.toml",
        folder,
        &overrides,
        host,
    )?;
    let findings = run(&experiment, Depth::Identify, &mut NoAlbum, &mut |_| {})?;
    let friction = findings.friction.ok_or("the chain ended early")?;
    match &friction.identified.dynamic {
        Some(fit) => {
            let bounds = match fit.bounds {
                Bounds::Between(low, high) => format!("between {low:.3} and {high:.3}"),
                Bounds::AtMost(high) => format!("at most {high:.3}"),
                Bounds::AtLeast(low) => format!("at least {low:.3}"),
                Bounds::Nothing => "not identifiable".to_owned(),
            };
            println!(
                "friction {:.3}, {bounds}; the pictures were made with 0.25",
                fit.mu
            );
        }
        None => println!("nothing slips beyond doubt"),
    }
    Ok(())
}
