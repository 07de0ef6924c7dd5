use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::region::fit::{Amount, Smoothing};
use stickslip_hybrid::region::outputs::{EdgeRows, displacement_rows};
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::Region;

use super::support::body;

/// Standard deviation of uniform errors of a quarter of a fringe at 2400 lines/mm `[mm]`.
const NOISE: f64 = 1e-4 / 1.7320508;

fn sector(cells: [usize; 2]) -> ArcSector {
    ArcSector {
        centre: [0.0, 0.0],
        hole: 9.525,
        stand_off: 0.0,
        outer: 19.05,
        angles: [-1.0, 1.0],
        cells,
        growth: 1.0,
        kind: ElementKind::Q8,
    }
}

/// The sector's body, pressed and sheared at its inner edge over ±0.8 rad as by a pin, held at the outer one.
fn truth() -> (Arc<ElasticBody>, Vec<f64>) {
    let body = body(sector([80, 40]).mesh().unwrap());
    let mesh = body.mesh();
    let inner = &mesh.edge_set("inner").unwrap().edges;
    let forces = edge_load(mesh, inner, 2.0, |point| {
        let theta = point.position[1].atan2(point.position[0]);
        let (s, c) = theta.sin_cos();
        let inside = (1.0 - (theta / 0.8).powi(2)).max(0.0);
        let pressure = 200.0 * inside * inside;
        let tau = 0.25 * pressure * (2.5 * theta).sin();
        [pressure * c + tau * s, pressure * s - tau * c]
    });
    let held = |direction| Support {
        nodes: mesh.node_set("outer").unwrap().to_vec(),
        direction,
        displacement: 0.0,
    };
    let driven = ElasticBody::clone(&body)
        .with_supports([held(HeldDirection::X), held(HeldDirection::Y)])
        .with_load_cases(vec![LoadCase { forces, ..LoadCase::default() }])
        .unwrap();
    let u = Arc::new(driven).condense(&[]).unwrap().displacements(&[], &[1.0], &[]);
    (body, u)
}

fn scatter(across: usize) -> Vec<[f64; 2]> {
    let mut random = StdRng::seed_from_u64(42);
    let around = 2 * across;
    (0..across * around)
        .map(|k| {
            let jitter = || -> f64 { 0.5 };
            let f = ((k % around) as f64 + jitter() + random.random_range(-0.4..0.4)) / around as f64;
            let g = ((k / around) as f64 + jitter() + random.random_range(-0.4..0.4)) / across as f64;
            let (theta, r) = (-1.0 + 2.0 * f, 9.525 * (1.0 + g));
            [r * theta.cos(), r * theta.sin()]
        })
        .collect()
}

struct Experiment {
    region: Region,
    edge: EdgeRows,
    /// Error-free displacements at the places, x and y in turn.
    exact: Vec<f64>,
    places: Vec<[f64; 2]>,
    /// Stresses at the edge nodes from the truth mesh.
    stresses: Vec<f64>,
}

impl Experiment {
    fn new(cells: [usize; 2], across: usize) -> Self {
        let (fine, u) = truth();
        let apply = |rows: &[Vec<(usize, f64)>]| -> Vec<f64> {
            rows.iter().map(|row| row.iter().map(|&(dof, w)| w * u[dof]).sum()).collect()
        };
        let places = scatter(across);
        let exact = apply(&displacement_rows(fine.mesh(), &places).unwrap());
        let coarse = body(sector(cells).mesh().unwrap());
        let edge = EdgeRows::new(&coarse, "inner").unwrap();
        let fine_edge = EdgeRows::new(&fine, "inner").unwrap();
        let fine_stresses = apply(&fine_edge.rows);
        let step = (fine_edge.nodes.len() - 1) / (edge.nodes.len() - 1);
        let stresses = fine_stresses.chunks_exact(3).step_by(step).flatten().copied().collect();
        Self { region: Region::new(&coarse, &[]).unwrap(), edge, exact, places, stresses }
    }

    fn data(&self, noise: &mut dyn FnMut() -> f64) -> Measurement {
        let part = |axis: usize, noise: &mut dyn FnMut() -> f64| {
            self.exact.iter().skip(axis).step_by(2).map(|u| u + noise()).collect::<Vec<_>>()
        };
        let count = self.places.len();
        Measurement {
            places: self.places.clone(),
            displacements: [part(0, noise), part(1, noise)],
            valid: [vec![true; count], vec![true; count]],
            deviation: [NOISE; 2],
        }
    }

    fn stresses(&self, fitted: &NodalDisplacements) -> Vec<f64> {
        self.region.solve(fitted).unwrap().outputs(&self.edge.rows)
    }

    /// Root mean square of the shear entries of `values` at nodes farther than two cells from the ends.
    fn shear_rms(&self, values: &[f64]) -> f64 {
        let nodes = values.len() / 3;
        let squares: Vec<f64> = (4..nodes - 4).map(|k| values[3 * k + 2].powi(2)).collect();
        (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
    }
}

fn uniform(seed: u64) -> impl FnMut() -> f64 {
    let mut random = StdRng::seed_from_u64(seed);
    let half = NOISE * 3.0_f64.sqrt();
    move || random.random_range(-half..=half)
}

/// Noise of the shear over seeds, bias of the mean, and the propagated noise.
fn noise_and_bias(experiment: &Experiment, smoothing: Smoothing, seeds: u64) -> [f64; 4] {
    let mut all = Vec::new();
    let mut amount = 0.0;
    let mut propagated = 0.0;
    for seed in 0..seeds {
        let fit = experiment.region.fit(&experiment.data(&mut uniform(seed)), smoothing).unwrap();
        amount = fit.amount;
        all.push(experiment.stresses(&fit.displacements));
        let own = experiment.region.propagate(&experiment.edge.rows, &fit.displacements).unwrap();
        propagated += experiment.shear_rms(&own.deviations()).powi(2) / seeds as f64;
    }
    let count = seeds as f64;
    let size = all[0].len();
    let mean: Vec<f64> = (0..size).map(|k| all.iter().map(|s| s[k]).sum::<f64>() / count).collect();
    let squares = all.iter().map(|s| {
        let off: Vec<f64> = s.iter().zip(&mean).map(|(a, b)| a - b).collect();
        experiment.shear_rms(&off).powi(2)
    });
    let noise = (squares.sum::<f64>() / (count - 1.0)).sqrt();
    let exact = experiment.region.fit(&experiment.data(&mut || 0.0), Smoothing { amount: Amount::Given(amount), ..smoothing }).unwrap();
    let off: Vec<f64> = (experiment.stresses(&exact.displacements).iter().zip(&experiment.stresses))
        .map(|(a, b)| a - b)
        .collect();
    [noise, experiment.shear_rms(&off), propagated.sqrt(), amount]
}

#[test]
fn smoothing_takes_the_noise_and_little_else() {
    for (cells, across) in [([20, 10], 20), ([20, 10], 40), ([40, 20], 40)] {
        let experiment = Experiment::new(cells, across);
        println!(
            "{cells:?} cells, {} places; shear rms of truth {:.2}",
            experiment.places.len(), experiment.shear_rms(&experiment.stresses)
        );
        for smoothing in [
            Smoothing { order: 2, amount: Amount::Given(0.0) },
            Smoothing { order: 2, amount: Amount::CrossValidated },
            Smoothing { order: 3, amount: Amount::CrossValidated },
        ] {
            let [noise, bias, propagated, amount] = noise_and_bias(&experiment, smoothing, 10);
            println!("{smoothing:?}: noise {noise:.3}, propagated {propagated:.3}, bias {bias:.3}, amount {amount:.1e}");
        }
    }
}
