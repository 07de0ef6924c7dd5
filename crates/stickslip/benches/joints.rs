//! What one load step of many joints costs, of which none knows of another: the same for each, however many there are.

use std::fmt::Write as _;
use std::hint::black_box;
use std::path::Path;

use criterion::{BenchmarkId, Criterion, Throughput};
use stickslip::host::HOST;
use stickslip::run::run;
use stickslip::scene::{Format, Scene};

/// Numbers of joints.
const JOINTS: [usize; 3] = [1, 20, 200];

/// Copies of README's plate and pin.
fn scene(joints: usize) -> Scene {
    let mut text = r#"
version = 1
[output]
figures = false
fields = "none"
[materials.aluminium.isotropic]
young = "10400 ksi"
poisson = 0.33
[mesh]
element = "Q4"
spacing = "6 deg"
"#
    .to_owned();
    for k in 0..joints {
        let copy = r#"
[bodies.plateK]
material = "aluminium"
thickness = "0.06 in"
[bodies.plateK.shape.plate_with_hole]
hole_radius = "0.375 in"
outline.strip = { half_width = "1.495 in", left = "7.005 in", right = "1.5 in" }
[bodies.pinK]
material = "aluminium"
thickness = "0.06 in"
shape.disk = { radius = "0.3745 in" }
[[contacts]]
first = "plateK.hole"
second = "pinK.rim"
friction.static_dynamic = { static = 0.35, dynamic = 0.25 }
[[supports]]
on = "pinK.centre"
fix = ["x", "y"]
[[loads]]
on = "plateK.left"
force = { direction = [-1, 0], steps = ["1240 lbf"] }
"#;
        write!(text, "{}", copy.replace('K', &k.to_string()))
            .expect("text takes all that is written");
    }
    Scene::from_text_on(
        &text,
        Format::Toml,
        "joints.toml",
        Path::new(""),
        &[] as &[&str],
        HOST,
    )
    .expect("the scene is valid")
}

fn main() {
    let mut criterion = Criterion::default().sample_size(10).configure_from_args();
    let mut group = criterion.benchmark_group("independent-joints");
    for joints in JOINTS {
        let scene = scene(joints);
        group.throughput(Throughput::Elements(joints as u64));
        group.bench_function(BenchmarkId::new("one load step", joints), |bencher| {
            bencher.iter(|| {
                black_box(run(&scene, &mut |_| {}).expect("every joint is solved"));
            });
        });
    }
    group.finish();
    criterion.final_summary();
}
