//! Times to make operators and to recover stresses: `cargo bench -p stickslip-series`.

use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_series::{Accuracy, Anchor, Circle, Disk, EdgeLoad, Hole, Nodes, Outline, Plate};

const CIRCLE: Circle = Circle {
    centre: [0.0, 0.0],
    radius: 0.375,
    thickness: 0.06,
};

fn material() -> Isotropic {
    Isotropic::new(10.4e6, 0.33, PlaneState::Stress).expect("a material")
}

fn plate(nodes: Nodes) -> Plate {
    let strip = Outline::strip(5.5, 1.5, 1.5);
    let pull = vec![EdgeLoad {
        edge: 3,
        force: [-1240.0, 0.0],
    }];
    Plate::new(
        nodes,
        &material(),
        CIRCLE,
        &strip,
        &[pull],
        Accuracy::default(),
    )
    .expect("a plate")
}

fn operators(criterion: &mut Criterion) {
    let material = material();
    for count in [61, 121, 241] {
        let nodes = Nodes::uniform_half(count).expect("nodes");
        criterion.bench_function(&format!("hole, {count} nodes"), |bencher| {
            bencher.iter(|| Hole::held(black_box(nodes.clone()), &material, CIRCLE, &[]));
        });
        criterion.bench_function(&format!("disk, {count} nodes"), |bencher| {
            let anchor = Anchor::default();
            bencher.iter(|| Disk::held(black_box(nodes.clone()), &material, CIRCLE, anchor, &[]));
        });
        criterion.bench_function(&format!("strip, {count} nodes"), |bencher| {
            bencher.iter(|| plate(black_box(nodes.clone())));
        });
        // Spacings that differ by a percent and more.
        let graded: Vec<f64> = (nodes.angles().iter())
            .map(|angle| angle + 0.02 * (2.0 * angle).sin())
            .collect();
        let graded = Nodes::mirrored(graded).expect("nodes");
        criterion.bench_function(&format!("hole, {count} graded nodes"), |bencher| {
            bencher.iter(|| Hole::held(black_box(graded.clone()), &material, CIRCLE, &[]));
        });
    }
}

fn stresses(criterion: &mut Criterion) {
    let plate = plate(Nodes::uniform_half(61).expect("nodes"));
    let state = BodyLoad {
        forces: &[1.0; 122],
        multipliers: &[1.0],
        motions: &[0.0],
    };
    let field = plate.field(&state).expect("a field");
    criterion.bench_function("hoop stress at a point of the edge, 61 nodes", |bencher| {
        bencher.iter(|| field.edge(black_box(1.234)));
    });
    for ratio in [1.01, 1.1, 2.0] {
        let place = [0.0, ratio * CIRCLE.radius];
        let name = format!("stress and displacement at {ratio} radii, 61 nodes");
        criterion.bench_function(&name, |bencher| {
            bencher.iter(|| field.at(black_box(place)));
        });
    }
}

/// Stresses of 14 states at all nodes.
fn edges(criterion: &mut Criterion) {
    for count in [61, 241, 961] {
        let nodes = Nodes::uniform_half(count).expect("nodes");
        let forces = vec![1.0; 2 * count];
        let state = BodyLoad {
            forces: &forces,
            multipliers: &[1.0],
            motions: &[0.0],
        };
        let plate = plate(nodes.clone());
        criterion.bench_function(
            &format!("edge stresses, 14 states, {count} nodes"),
            |bencher| {
                bencher.iter(|| plate.edge_stresses(black_box(&[state; 14]), nodes.angles()));
            },
        );
    }
}

criterion_group!(benches, operators, stresses, edges);
criterion_main!(benches);
