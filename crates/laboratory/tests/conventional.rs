//! The conventional path gives the condensed path's answer, iteration by iteration.

use stickslip::results::Results;
use stickslip::scene::Scene;
use stickslip_contact::SemismoothNewton;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_laboratory::conventional::Settings;
use stickslip_laboratory::{Pairing, Path, Problem, run};

/// Allowed difference, of the largest value: residuals are accepted at 1e-10, and the compliance of a refined mesh amplifies
/// them a hundredfold.
const TOLERANCE: f64 = 1e-8;

fn both(scene: &Scene) -> [Results; 2] {
    let condensed = run(scene, Path::Condensed(&SemismoothNewton::default())).unwrap();
    let conventional = run(scene, Path::Conventional(&Settings::default())).unwrap();
    assert_eq!(condensed.unknowns, conventional.unknowns);
    [condensed.results, conventional.results]
}

/// Largest difference of pressure, shear and slip, each of its own largest value.
fn difference([a, b]: &[Results; 2]) -> f64 {
    let mut worst = 0.0_f64;
    let mut scale = [0.0_f64; 3];
    let rows = |results: &Results| {
        let edges = results.steps.iter().map(|step| step.edges[0].rows.clone());
        edges.flatten().collect::<Vec<_>>()
    };
    let values = |row: &stickslip::results::EdgeRow| [row.pressure, row.shear, row.slip];
    let (a, b) = (rows(a), rows(b));
    for row in &a {
        for (largest, value) in scale.iter_mut().zip(values(row)) {
            *largest = largest.max(value.abs());
        }
    }
    for (a, b) in a.iter().zip(&b) {
        assert_eq!(a.status, b.status);
        for ((x, y), scale) in values(a).iter().zip(values(b)).zip(scale) {
            if scale > 0.0 {
                worst = worst.max((x - y).abs() / scale);
            }
        }
    }
    worst
}

fn check(problem: Problem, spacing: f64, element: ElementKind, overrides: &[String]) {
    let scene = problem
        .build_with(spacing, element, Pairing::NodePairs, overrides)
        .unwrap();
    let results = both(&scene);
    let found = difference(&results);
    assert!(found < TOLERANCE, "{}: {found:e}", problem.name());
    let [condensed, conventional] = &results;
    for (a, b) in condensed.steps.iter().zip(&conventional.steps) {
        assert_eq!(a.work.solves, b.work.solves);
        assert_eq!(b.work.factorisations, b.work.solves);
        assert!(b.work.operations > a.work.operations);
        assert_eq!(b.solvers, ["conventional Newton"]);
        assert!(b.balance_residual < 1e-8);
    }
}

#[test]
fn on_the_aluminium_history() {
    check(Problem::AluminiumFrictional, 9.0, ElementKind::Q4, &[]);
    check(Problem::AluminiumFrictional, 9.0, ElementKind::Q8, &[]);
    check(Problem::AluminiumFrictionless, 4.5, ElementKind::T6, &[]);
}

/// The upper body floats on its platen.
#[test]
fn on_line_contacts() {
    check(Problem::Hertz, 0.2, ElementKind::Q8, &[]);
    check(Problem::CattaneoMindlin, 0.1, ElementKind::Q4, &[]);
}

/// The plate floats, and the pin has no unknowns at all.
#[test]
fn on_a_rigid_pin() {
    let once = ["analysis.substeps=2".to_owned()];
    check(Problem::OrthotropicPin, 5.0, ElementKind::Q8, &once);
}

#[test]
fn the_same_input_gives_the_same_bits() {
    let scene = Problem::AluminiumFrictional
        .build(9.0, ElementKind::Q8, Pairing::NodePairs)
        .unwrap();
    let twice = [(); 2].map(|()| run(&scene, Path::Conventional(&Settings::default())).unwrap());
    let bits = |k: usize| {
        let steps = twice[k].results.steps.iter();
        steps
            .flat_map(|step| step.edges[0].rows.iter().map(|row| row.pressure.to_bits()))
            .collect::<Vec<_>>()
    };
    assert_eq!(bits(0), bits(1));
}
