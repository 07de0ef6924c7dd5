//! Makes fringe pictures of a pulled plate with a hole, measures its displacements in them, and prints the files and answers of the page.
//!
//! Run with `cargo run --release -p stickslip-experiment-pages --example page`. The program has no files: what is read and written is held in memory.

use std::error::Error;
use std::path::Path;
use std::sync::Mutex;

use stickslip_experiment::Experiment;
use stickslip_experiment_pages::report;
use stickslip_experiment_pages::stickslip_measure::chain::Depth;
use stickslip_scene::Format;
use stickslip_scene::host::{Host, MemoryFiles};

const SCENE: &str = r#"
version = 1
[materials.epoxy.isotropic]
young = "3 GPa"
poisson = 0.36
[bodies.plate]
material = "epoxy"
thickness = "4 mm"
shape.plate_with_hole = { hole_radius = "6 mm", outline.strip = { half_width = "24 mm", left = "48 mm", right = "48 mm" } }
[mesh]
spacing = "6 deg"
[[supports]]
on = "plate.right"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["300 N"] }
[[edges]]
on = "plate.hole"
"#;

const EXPERIMENT: &str = r#"
version = 1
[specimen]
scene = "plate.toml"
body = "plate"
edge = "hole"
[grating]
frequency = "1200 1/mm"
[fringes]
window = [["-9 mm", "-9 mm"], ["9 mm", "9 mm"]]
pixel = "0.05 mm"
carrier = { u = ["5 1/mm", "0 1/mm"], v = ["0 1/mm", "5 1/mm"] }
seed = 1
[[states]]
name = "pulled"
step = 1
[reduce]
method = "fit"
[region]
sector = { angles = ["20 deg", "160 deg"], outer = "8.5 mm", cells = [24, 6] }
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let host = Host::of(MemoryFiles::from_iter([("plate.toml", SCENE)]));
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
    let page = report(&experiment, Depth::Reduce, folder, &mut |_| {})?;
    println!("{}", page.text_answers());
    let files = Mutex::new(Vec::new());
    page.write(&|name, bytes| {
        if let Ok(mut files) = files.lock() {
            files.push((name.to_owned(), bytes.len()));
        }
        Ok(())
    })?;
    let mut files = files.into_inner()?;
    files.sort();
    for (name, bytes) in &files {
        println!("{bytes:>8} bytes  {name}");
    }
    println!("{} files", files.len());
    Ok(())
}
