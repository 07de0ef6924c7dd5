use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, LoadCase, Support};
use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::region::fit::{Amount, Fitter, Smoothing};
use stickslip_hybrid::region::outputs::{EdgeRows, displacement_rows};
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::{Region, independent_covariance};

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

/// Pressure and shear τ_rθ applied at an angle `[MPa]`.
fn tractions(theta: f64) -> [f64; 2] {
    let inside = (1.0 - (theta / 0.8).powi(2)).max(0.0);
    let pressure = 200.0 * inside * inside;
    [pressure, 0.25 * pressure * (2.5 * theta).sin()]
}

/// The sector's body, pressed and sheared at its inner edge over ±0.8 rad as by a pin, held at the outer one.
fn truth() -> (Arc<ElasticBody>, Vec<f64>) {
    let body = body(sector([80, 40]).mesh().unwrap());
    let mesh = body.mesh();
    let inner = &mesh.edge_set("inner").unwrap().edges;
    let forces = edge_load(mesh, inner, 2.0, |point| {
        let theta = point.position[1].atan2(point.position[0]);
        let (s, c) = theta.sin_cos();
        let [pressure, tau] = tractions(theta);
        [pressure * c + tau * s, pressure * s - tau * c]
    });
    let held = |direction| Support {
        nodes: mesh.node_set("outer").unwrap().to_vec(),
        direction,
        displacement: 0.0,
    };
    let driven = ElasticBody::clone(&body)
        .with_supports([held(HeldDirection::X), held(HeldDirection::Y)])
        .with_load_cases(vec![LoadCase {
            forces,
            ..LoadCase::default()
        }])
        .unwrap();
    let u = Arc::new(driven)
        .condense(&[])
        .unwrap()
        .displacements(&[], &[1.0], &[]);
    (body, u)
}

fn scatter(across: usize) -> Vec<[f64; 2]> {
    let mut random = StdRng::seed_from_u64(42);
    let around = 2 * across;
    (0..across * around)
        .map(|k| {
            let jitter = || -> f64 { 0.5 };
            let f =
                ((k % around) as f64 + jitter() + random.random_range(-0.4..0.4)) / around as f64;
            let g =
                ((k / around) as f64 + jitter() + random.random_range(-0.4..0.4)) / across as f64;
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
    /// The applied shear at each edge node, third of three numbers.
    stresses: Vec<f64>,
}

impl Experiment {
    fn new(cells: [usize; 2], across: usize) -> Self {
        let (fine, u) = truth();
        let apply = |rows: &[Vec<(usize, f64)>]| -> Vec<f64> {
            rows.iter()
                .map(|row| row.iter().map(|&(dof, w)| w * u[dof]).sum())
                .collect()
        };
        let places = scatter(across);
        let exact = apply(&displacement_rows(fine.mesh(), &places).unwrap());
        let coarse = body(sector(cells).mesh().unwrap());
        let edge = EdgeRows::new(&coarse, "inner").unwrap();
        let shears = edge
            .parameter
            .iter()
            .map(|s| tractions((s / 9.525).sin().asin())[1]);
        let stresses = shears.flat_map(|shear| [0.0, 0.0, shear]).collect();
        let region = Region::new(&coarse, &[]).unwrap();
        Self {
            region,
            edge,
            exact,
            places,
            stresses,
        }
    }

    fn data(&self, noise: &mut dyn FnMut() -> f64) -> Measurement {
        let part = |axis: usize, noise: &mut dyn FnMut() -> f64| {
            self.exact
                .iter()
                .skip(axis)
                .step_by(2)
                .map(|u| u + noise())
                .collect::<Vec<_>>()
        };
        let count = self.places.len();
        Measurement {
            places: self.places.clone(),
            displacements: [part(0, noise), part(1, noise)],
            valid: [vec![true; count], vec![true; count]],
            deviation: [NOISE; 2],
        }
    }
}

/// Root mean square of the shear entries of `values` at nodes farther than two cells from the ends.
fn shear_rms(values: &[f64]) -> f64 {
    let nodes = values.len() / 3;
    let squares: Vec<f64> = (4..nodes - 4).map(|k| values[3 * k + 2].powi(2)).collect();
    (squares.iter().sum::<f64>() / squares.len() as f64).sqrt()
}

fn uniform(seed: u64) -> impl FnMut() -> f64 {
    let mut random = StdRng::seed_from_u64(seed);
    let half = NOISE * 3.0_f64.sqrt();
    move || random.random_range(-half..=half)
}

/// What a reduction makes of the shear on the edge; root mean squares along it.
#[derive(Debug)]
struct Quality {
    amount: f64,
    /// Standard deviation over seeds.
    noise: f64,
    /// Deviation from the propagated covariance.
    propagated: f64,
    /// Change of the noise-free answer by the smoothing.
    added_bias: f64,
    /// Error of the noise-free answer, that of the mesh included.
    error: f64,
}

fn quality(experiment: &Experiment, fitter: &Fitter<'_>, amount: f64, seeds: u64) -> Quality {
    let rows = &experiment.edge.rows;
    let exact = experiment.data(&mut || 0.0).displacements;
    let stresses = |values: &[f64]| experiment.region.outputs_of(rows, values).unwrap();
    let smooth = stresses(&fitter.values(&exact, amount).unwrap());
    let plain = stresses(&fitter.values(&exact, 0.0).unwrap());
    let difference =
        |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a - b).collect() };
    let draws: Vec<f64> = (0..seeds)
        .flat_map(|seed| {
            fitter
                .values(&experiment.data(&mut uniform(seed)).displacements, amount)
                .unwrap()
        })
        .collect();
    let squares = stresses(&draws);
    let squares = squares
        .chunks_exact(rows.len())
        .map(|s| shear_rms(&difference(s, &smooth)).powi(2));
    let fit = fitter.fit(&exact, Amount::Given(amount)).unwrap();
    let own = experiment
        .region
        .propagate(rows, &fit.displacements)
        .unwrap();
    Quality {
        amount,
        noise: (squares.sum::<f64>() / seeds as f64).sqrt(),
        propagated: shear_rms(&own.deviations()),
        added_bias: shear_rms(&difference(&smooth, &plain)),
        error: shear_rms(&difference(&smooth, &experiment.stresses)),
    }
}

/// Shear standard deviation where every prescribed node has errors of its own: the localized hybrid analysis without a fit.
fn nodal_noise(region: &Region, edge: &EdgeRows) -> f64 {
    let nodes = region.prescribed_nodes();
    let measured = NodalDisplacements {
        values: vec![0.0; 2 * nodes.len()],
        covariance: independent_covariance(nodes.len(), [NOISE; 2]),
        nodes,
    };
    shear_rms(
        &region
            .propagate(&edge.rows, &measured)
            .unwrap()
            .deviations(),
    )
}

#[test]
fn declared_smoothing_takes_the_noise_and_little_else() {
    println!(
        "root mean squares of the shear along the edge, truth 15 to 16; displacements with ±1/4 fringe"
    );
    // 800 places in all are too few for a quarter of the noise at half of it as bias; a full field has many more.
    let cases = [
        ([20, 10], 20, false),
        ([20, 10], 40, true),
        ([40, 20], 40, true),
    ];
    for (cells, across, enough) in cases {
        let experiment = Experiment::new(cells, across);
        let data = experiment.data(&mut uniform(999));
        println!("{cells:?} cells, {} places", experiment.places.len());
        let nodal = nodal_noise(&experiment.region, &experiment.edge);
        println!(" noise of the nodal analysis {nodal:.2}");
        for order in [2, 3] {
            let fitter = Fitter::new(&experiment.region, &data, order).unwrap();
            let best = fitter.cross_validated(&data.displacements).unwrap();
            for share in [0.0, 0.4, 1.0] {
                let found = quality(&experiment, &fitter, share * best, 100);
                println!(
                    "  order {order}, share {share}: amount {:.1e}, noise {:.2}, propagated {:.2}, added bias {:.2}, error without noise {:.2}",
                    found.amount, found.noise, found.propagated, found.added_bias, found.error
                );
                // 100 seeds with some ten free modes on the edge: 1/√2000, to three standard deviations.
                assert!(
                    (found.noise / found.propagated - 1.0).abs() < 0.07,
                    "{found:?}"
                );
                if enough && order == 2 && share == 0.4 {
                    assert!(found.noise < nodal / 4.0, "{found:?}");
                    assert!(found.added_bias < found.noise / 2.0, "{found:?}");
                }
            }
        }
    }
}

#[test]
fn a_fit_states_what_it_did() {
    let experiment = Experiment::new([20, 10], 20);
    let data = experiment.data(&mut uniform(1));
    let smoothing = Smoothing {
        order: 2,
        amount: Amount::CrossValidated { share: 0.4 },
    };
    let fit = experiment.region.fit(&data, smoothing).unwrap();
    assert_eq!(fit.data, 1600);
    let fitter = Fitter::new(&experiment.region, &data, 2).unwrap();
    let best = fitter.cross_validated(&data.displacements).unwrap();
    assert!((fit.amount / best - 0.4).abs() < 1e-12);
    let values = fitter.values(&data.displacements, fit.amount).unwrap();
    assert_eq!(
        experiment.region.values(&fit.displacements).unwrap(),
        values
    );
    // The residual is that of data minus parameters squared normal numbers, near enough: √(2·1600) ≈ 57.
    let expected = 1600.0 - fit.parameters;
    println!(
        "residual {:.0}, expected {expected:.0}, parameters {:.1} of {}",
        fit.residual,
        fit.parameters,
        values.len()
    );
    assert!((fit.residual - expected).abs() < 4.0 * 57.0);
    // What is kept of each displacement adds up to the parameters, and all of it is kept without smoothing.
    let kept: f64 = fit.kept.iter().sum();
    assert!((kept / fit.parameters - 1.0).abs() < 1e-8, "{kept}");
    assert!(fit.parameters < fit.kept.len() as f64);
    let given = |amount| {
        fitter
            .fit(&data.displacements, Amount::Given(amount))
            .unwrap()
    };
    assert!(given(0.0).kept.iter().all(|part| (part - 1.0).abs() < 1e-6));
    // Residuals recomputed from the solution.
    let solution = experiment.region.solve(&fit.displacements).unwrap();
    let rows = displacement_rows(experiment.region.mesh(), &experiment.places).unwrap();
    let squares: f64 = solution
        .outputs(&rows)
        .iter()
        .enumerate()
        .map(|(k, u)| ((data.displacements[k % 2][k / 2] - u) / NOISE).powi(2))
        .sum();
    assert!(
        (squares / fit.residual - 1.0).abs() < 1e-6,
        "{squares} {}",
        fit.residual
    );
    // The estimated bias is of the size of the true one.
    let exact = experiment.data(&mut || 0.0).displacements;
    let smooth = fitter.values(&exact, fit.amount).unwrap();
    let plain = fitter.values(&exact, 1e-6 * fit.amount).unwrap();
    let norm = |v: &mut dyn Iterator<Item = f64>| v.map(|x| x * x).sum::<f64>().sqrt();
    let ratio = norm(&mut fit.bias.iter().copied())
        / norm(&mut smooth.iter().zip(&plain).map(|(a, b)| a - b));
    println!("estimated over true bias {ratio:.2}");
    assert!((0.3..3.0).contains(&ratio));
}
