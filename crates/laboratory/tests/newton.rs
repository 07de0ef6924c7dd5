//! How many iterations the first member of the default chain needs on a history with friction.

use stickslip_contact::SemismoothNewton;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::measure::summary;
use stickslip_laboratory::{Pairing, Path, Problem, run};

/// Median over the load steps, the confirming iteration included.
fn median_iterations(spacing: f64) -> f64 {
    let problem = Problem::AluminiumFrictional;
    let scene = problem
        .build(spacing, ElementKind::Q8, Pairing::NodePairs)
        .unwrap();
    let newton = SemismoothNewton::default();
    let results = run(&scene, Path::Condensed(&newton)).unwrap().results;
    let steps = results.steps.iter();
    let iterations: Vec<f64> = steps.map(|step| step.work.solves as f64).collect();
    summary(&iterations).median
}

#[test]
fn newton_takes_few_iterations_and_few_more_on_finer_meshes() {
    for (spacing, most) in [(9.0, 6.0), (4.5, 6.0), (2.25, 8.0), (1.125, 8.0)] {
        let median = median_iterations(spacing);
        assert!(median <= most, "{median} at {spacing}°");
    }
}
