//! What a whole load history costs, in units of one ordinary sparse Cholesky factorisation of the same stiffness matrix.
//!
//! The history is everything of a run but its files: meshes, assembly, factorisation, 14 contact steps, edge stresses. The
//! yardstick is faer's own factorisation, symbolic and numeric, in its minimum-degree order. Both are timed in the same
//! process; the ratios printed at the end come from alternating runs.

use std::hint::black_box;
use std::path::Path;
use std::time::Instant;

use criterion::{BenchmarkId, Criterion};
use stickslip::host::HOST;
use stickslip::model::{Model, ModelBodyKind};
use stickslip::run::run;
use stickslip::scene::Scene;
use stickslip_fem_core::linalg::{LowerMatrix, reference_factorisation};

/// Corner-node spacings on the hole [deg] that give about 12, 50 and 200 thousand unknowns.
const SPACINGS: [f64; 3] = [3.75, 1.8, 0.9];
/// Pairs of alternating runs behind each printed ratio.
const PAIRS: usize = 7;

struct Case {
    scene: Scene,
    matrix: LowerMatrix,
}

fn case(spacing: f64) -> Case {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-benchmark.toml");
    let overrides = [
        format!("mesh.spacing={spacing} deg"),
        "mesh.element=Q8".into(),
        "output.fields=none".into(),
    ];
    let scene =
        Scene::from_file(&path, &overrides, HOST).expect("the scene is part of the repository");
    let model = Model::build(&scene).expect("the scene can be modelled");
    let mut matrix = LowerMatrix {
        column_start: vec![0],
        ..LowerMatrix::default()
    };
    for body in &model.bodies {
        if let ModelBodyKind::Elastic(elastic) = &body.kind {
            let structure = elastic
                .analyse(&body.interface)
                .expect("the body is supported");
            append(&mut matrix, &structure.stiffness(elastic));
        }
    }
    Case { scene, matrix }
}

/// Adds `block` as a further diagonal block.
fn append(matrix: &mut LowerMatrix, block: &LowerMatrix) {
    let (rows, entries) = (matrix.order(), matrix.rows.len());
    matrix
        .column_start
        .extend(block.column_start[1..].iter().map(|start| start + entries));
    matrix.rows.extend(block.rows.iter().map(|row| row + rows));
    matrix.values.extend(&block.values);
}

fn history(case: &Case) {
    black_box(run(&case.scene, &mut |_| {}).expect("every step of the benchmark is solved"));
}

fn factorisation(case: &Case, threads: usize) {
    black_box(
        reference_factorisation(&case.matrix, threads).expect("the matrix is positive definite"),
    );
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

fn main() {
    let mut criterion = Criterion::default().sample_size(10).configure_from_args();
    let cases: Vec<Case> = SPACINGS.map(case).into();
    let mut group = criterion.benchmark_group("pin-benchmark");
    for case in &cases {
        let unknowns = case.matrix.order();
        group.bench_function(
            BenchmarkId::new("history of 14 steps", unknowns),
            |bencher| {
                bencher.iter(|| history(case));
            },
        );
        group.bench_function(BenchmarkId::new("one factorisation", unknowns), |bencher| {
            bencher.iter(|| factorisation(case, 1));
        });
    }
    group.finish();
    println!(
        "unknowns   history s   one factorisation s: 1 thread, 2 threads   ratio to the faster, median of {PAIRS} pairs (min … max)"
    );
    for case in &cases {
        let runs: Vec<[f64; 3]> = (0..PAIRS)
            .map(|_| {
                [
                    seconds(|| history(case)),
                    seconds(|| factorisation(case, 1)),
                    seconds(|| factorisation(case, 2)),
                ]
            })
            .collect();
        let column = |k: usize| median(runs.iter().map(|run| run[k]).collect());
        let ratios: Vec<f64> = runs.iter().map(|run| run[0] / run[1].min(run[2])).collect();
        let (low, high) = ratios
            .iter()
            .fold((f64::INFINITY, 0.0_f64), |(low, high), &r| {
                (low.min(r), high.max(r))
            });
        println!(
            "{:>8}   {:>9.4}   {:>8.4}, {:>8.4}   {:.2} ({low:.2} … {high:.2})",
            case.matrix.order(),
            column(0),
            column(1),
            column(2),
            median(ratios.clone()),
        );
    }
    criterion.final_summary();
}
