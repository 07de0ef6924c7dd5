//! What one evaluation of a friction law costs, in units of a plain run of its scene.
//!
//! An evaluation is a history of contact solves on bodies that are condensed already, with the displacements of three states at 372
//! places. The scene is that of the aluminium plate at its own mesh and at two coarser ones.

use std::hint::black_box;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use criterion::Criterion;
use stickslip::experiment::SpecimenScene;
use stickslip::experiment::laws::ContactModel;
use stickslip::host::HOST;
use stickslip::run::run;
use stickslip::scene::Scene;

/// Runs behind a scene-time.
const RUNS: usize = 9;
const STATES: [usize; 3] = [3, 6, 9];

fn scene(degrees: f64) -> SpecimenScene {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-loaded-aluminium.toml");
    let overrides = [
        format!("mesh.spacing=\"{degrees} deg\""),
        format!("mesh.coarse_spacing=\"{} deg\"", (4.0 * degrees).min(9.0)),
    ];
    SpecimenScene {
        scene: Arc::new(Scene::from_file(&path, &overrides, HOST).expect("part of the repository")),
        body: "plate".to_owned(),
        edge: "hole".to_owned(),
    }
}

fn places() -> Vec<[f64; 2]> {
    let at = |k: i32| -20.0 + 2.0 * f64::from(k);
    let grid = (0..=20).flat_map(|i| (0..=20).map(move |j| [at(i), at(j)]));
    grid.filter(|[x, y]| x.hypot(*y) > 9.7).collect()
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn main() {
    let mut criterion = Criterion::default().configure_from_args().sample_size(20);
    for degrees in [1.125, 2.25, 4.5] {
        let own = scene(degrees);
        let model = ContactModel::new(&own).expect("the scene is modelled");
        let view = model.view(&places()).expect("places in the plate");
        let law = Arc::clone(model.own_law());
        let evaluation = || {
            let states = model.states(Arc::clone(&law), 10).expect("a solution");
            STATES.map(|step| view.displacements(&states[step]))
        };
        criterion.bench_function(&format!("evaluation at {degrees} deg"), |bencher| {
            bencher.iter(|| black_box(evaluation()));
        });
        let time = |work: &dyn Fn()| {
            let once = || {
                let start = Instant::now();
                work();
                start.elapsed().as_secs_f64()
            };
            median((0..RUNS).map(|_| once()).collect())
        };
        let plain = time(&|| drop(black_box(run(&own.scene, &mut |_| {}))));
        let one = time(&|| drop(black_box(evaluation())));
        println!(
            "{degrees} deg, {} nodes of the edge: evaluation {:.2} ms, plain run {:.1} ms, ratio {:.3}",
            model.edge().len(),
            1e3 * one,
            1e3 * plain,
            one / plain
        );
    }
    criterion.final_summary();
}
