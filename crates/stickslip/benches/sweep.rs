//! What a case of a sweep costs, in units of one run of its scene on one core.
//!
//! A scene-time is everything of a run but its files, on a pool of one thread: meshes, factorisations, contact, stresses, balance. Cases
//! are those of `scenes/sweeps/thousand.toml` on two workers: outlines that differ, one outline whose clearance, friction and load
//! differ, and all thousand of them. Once with the scene's question of ply failure, once as contact alone.

use std::fs;
use std::hint::black_box;
use std::num::NonZeroUsize;
use std::path::Path;
use std::sync::atomic::AtomicBool;
use std::time::Instant;

use stickslip::host::HOST;
use stickslip::run::run;
use stickslip::sweep::{Sweep, engine};
use tempfile::TempDir;

/// Runs behind a scene-time.
const RUNS: usize = 9;
const WORKERS: usize = 2;
/// Combinations of clearance, friction and load of each outline in the sweep.
const LIGHT: usize = 40;

fn sweep(folder: &Path, failure: bool) -> Sweep {
    let scenes = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/sweeps");
    let read = |name: &str| fs::read_to_string(scenes.join(name)).expect("part of the repository");
    let mut scene = read("pinned-joint.toml");
    if !failure {
        let start = scene.find("[failure]").expect("the scene asks for failure");
        let end = scene.find("[output]").expect("and says what to write");
        scene.replace_range(start..end, "");
    }
    let put =
        |name: &str, text: &str| fs::write(folder.join(name), text).expect("a folder to write to");
    put("pinned-joint.toml", &scene);
    put("sweep.toml", &read("thousand.toml"));
    Sweep::from_file(&folder.join("sweep.toml"), &[] as &[&str], HOST).expect("the sweep reads")
}

fn seconds(work: impl FnOnce()) -> f64 {
    let start = Instant::now();
    work();
    start.elapsed().as_secs_f64()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// Median time of a run of the sweep's middle outline.
fn scene_time(sweep: &Sweep) -> f64 {
    let scene = sweep.scene_of(12 * LIGHT).expect("the scene reads");
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(1)
        .build()
        .expect("one thread");
    let once = || seconds(|| drop(black_box(pool.install(|| run(&scene, &mut |_| {})))));
    median((0..RUNS).map(|_| once()).collect())
}

/// Wall time per case.
fn per_case(sweep: &Sweep, cases: &[usize]) -> f64 {
    let workers = NonZeroUsize::new(WORKERS).expect("some workers");
    let mut solved = 0;
    let wall = seconds(|| {
        let stop = AtomicBool::new(false);
        engine::run(sweep, cases, workers, &stop, &mut |row| {
            assert!(row.measures().is_some(), "{row:?}");
            solved += 1;
            Ok(())
        })
        .expect("every case has a row");
    });
    assert_eq!(solved, cases.len());
    wall / cases.len() as f64
}

fn main() {
    println!("wall time per case on {WORKERS} workers, in scene-times of one core");
    println!(
        "question   scene-time s   outlines differ   clearance, friction, load differ   all 1000"
    );
    for (name, failure) in [("contact", false), ("failure", true)] {
        let folder = TempDir::new().expect("a temporary folder");
        let sweep = sweep(folder.path(), failure);
        let all: Vec<usize> = (0..sweep.cases()).collect();
        let outlines: Vec<usize> = all.iter().copied().step_by(LIGHT).collect();
        // The first case condenses the bodies; the others are what is asked.
        let one = &all[..LIGHT];
        let scene = scene_time(&sweep);
        let heavy = per_case(&sweep, &outlines) / scene;
        let first = per_case(&sweep, &one[..1]);
        let light = (per_case(&sweep, one) * LIGHT as f64 - first) / (LIGHT - 1) as f64 / scene;
        let mixed = per_case(&sweep, &all) / scene;
        println!("{name:8} {scene:>14.4} {heavy:>17.3} {light:>34.3} {mixed:>10.3}");
    }
}
