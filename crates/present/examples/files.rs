//! Solves a ring under pressure and prints the files that show its results, with their sizes, and the hoop stress that they show.
//!
//! Run with `cargo run --release -p stickslip-present --example files`.

use std::error::Error;
use std::path::Path;
use std::sync::Mutex;

use stickslip_ladder::run;
use stickslip_present::results::write;
use stickslip_present::serde_json::{self, Value};
use stickslip_scene::{Format, Scene};

const TEXT: &str = r#"
version = 1
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.ring]
material = "steel"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "20 mm" } }
[mesh]
spacing = "5 deg"
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
on = "ring.hole"
pressure.steps = ["10 MPa"]
[[edges]]
on = "ring.hole"
"#;

fn main() -> Result<(), Box<dyn Error>> {
    let overrides: [&str; 0] = [];
    let scene = Scene::from_text(TEXT, Format::Toml, "ring.toml", Path::new(""), &overrides)?;
    let results = run(&scene, &mut |_| {})?;
    let files = Mutex::new(Vec::new());
    let summary = write(&results, true, &|name, bytes| {
        if let Ok(mut files) = files.lock() {
            files.push((name.to_owned(), bytes.len()));
        }
        Ok(())
    })?;
    let mut files = files.into_inner()?;
    files.push(("summary.json".to_owned(), summary.len()));
    files.sort();
    for (name, bytes) in files {
        println!("{bytes:>8} bytes  {name}");
    }
    let summary: Value = serde_json::from_str(&summary)?;
    let hoop = summary["steps"][0]["peak_hoop"]["value"].as_f64();
    let hoop = hoop.ok_or("no hoop stress")?;
    // Lamé: p ((1 − ν) b² − (1 + ν) a²)/((1 − ν) b² + (1 + ν) a²) with a fixed rim.
    assert!((hoop / 7.92 - 1.0).abs() < 0.01);
    println!("hoop stress on the hole: {hoop:.3} MPa");
    Ok(())
}
