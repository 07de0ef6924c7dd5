//! What error bars cost on a region of 20 000 displacements: factorisation, exact covariance of the edge stresses, and 1000 draws.
//!
//! The last line gives each as a number of pairs of triangular solves of one right-hand side, all measured in this run.

use std::hint::black_box;
use std::sync::Arc;
use std::time::{Duration, Instant};

use criterion::{Criterion, criterion_group, criterion_main};
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::body::SparseRow;
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_hybrid::data::NodalDisplacements;
use stickslip_hybrid::region::outputs::EdgeRows;
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::transfer::Transfer;
use stickslip_hybrid::region::{Region, independent_covariance};

const DRAWS: usize = 1000;
/// Samples behind the medians of the last line.
const SAMPLES: usize = 11;

fn body() -> Arc<ElasticBody> {
    let sector = ArcSector {
        centre: [0.0, 0.0],
        hole: 9.525,
        stand_off: 0.0,
        outer: 19.05,
        angles: [-1.0, 1.0],
        cells: [84, 39],
        growth: 1.5,
        kind: ElementKind::Q8,
    };
    let mesh = Arc::new(sector.mesh().expect("radii and angles increase"));
    let aluminium = Isotropic::new(70.3e3, 0.34, PlaneState::Stress).expect("admissible constants");
    let materials: Vec<Arc<dyn Material>> = vec![Arc::new(aluminium)];
    Arc::new(ElasticBody::new(mesh, materials, 1.524).expect("one material for the one block"))
}

struct Case {
    region: Region,
    rows: Vec<SparseRow>,
    measured: NodalDisplacements,
    values: Vec<f64>,
}

fn case(body: &Arc<ElasticBody>) -> Case {
    let region = Region::new(body, &[]).expect("the body can be partitioned");
    let nodes = region.prescribed_nodes();
    let places = body.mesh().nodes();
    let measured = NodalDisplacements {
        values: nodes
            .iter()
            .flat_map(|&node| places[node].map(|x| 1e-3 * x))
            .collect(),
        covariance: independent_covariance(nodes.len(), [6e-5; 2]),
        nodes,
    };
    Case {
        rows: EdgeRows::new(body, "inner")
            .expect("a sector has an inner edge")
            .rows,
        values: region.values(&measured).expect("all nodes are measured"),
        measured,
        region,
    }
}

impl Case {
    fn one_solve(&self) {
        let found = self.region.outputs_of(&[], &self.values);
        let _ = black_box(found.expect("one state"));
    }

    fn transfer(&self) -> Transfer {
        let found = self.region.transfer(&self.rows);
        found.expect("rows of the region's own nodes")
    }

    fn covariance(&self) {
        let found = self.region.propagate_by(&self.transfer(), &self.measured);
        let _ = black_box(found.expect("measured with covariance"));
    }

    /// The transfer is that of the covariance.
    fn draws(&self, transfer: &Transfer) {
        let found = (self.region).simulate_by(transfer, &self.measured, DRAWS, 7);
        let _ = black_box(found.expect("measured with covariance"));
    }
}

fn median(mut work: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..SAMPLES)
        .map(|_| {
            let start = Instant::now();
            work();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[SAMPLES / 2]
}

fn region(criterion: &mut Criterion) {
    let body = body();
    let case = case(&body);
    let transfer = case.transfer();
    let factorise = || {
        let _ = black_box(Region::new(&body, &[]).expect("as before"));
    };
    let mut group = criterion.benchmark_group("region of 20 000 displacements");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(3));
    group.bench_function("one pair of triangular solves", |b| {
        b.iter(|| case.one_solve());
    });
    group.bench_function("structure and factorisation", |b| b.iter(factorise));
    group.bench_function("covariance of the edge", |b| {
        b.iter(|| case.covariance());
    });
    group.bench_function("1000 draws", |b| {
        b.iter(|| case.draws(&transfer));
    });
    group.finish();

    let one = median(|| case.one_solve());
    let parts = [
        median(factorise),
        median(|| case.covariance()),
        median(|| case.draws(&transfer)),
    ]
    .map(|time| time / one);
    println!(
        "{} displacements, {} prescribed, {} outputs; in pairs of triangular solves: factorisation {:.0}, covariance {:.0}, \
         {DRAWS} draws {:.0}, together {:.0}",
        2 * body.mesh().nodes().len(),
        case.values.len(),
        case.rows.len(),
        parts[0],
        parts[1],
        parts[2],
        parts.iter().sum::<f64>()
    );
}

criterion_group!(benches, region);
criterion_main!(benches);
