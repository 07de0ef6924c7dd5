use std::f64::consts::TAU;
use std::sync::Arc;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::ElasticBody;
use stickslip_fem_core::mesh::{ElementKind, Point};
use stickslip_hybrid::data::{Measurement, NodalDisplacements};
use stickslip_hybrid::region::checks::{CheckInput, ChiSquared, FreeEdge, KnownForce};
use stickslip_hybrid::region::sector::ArcSector;
use stickslip_hybrid::region::{Region, independent_covariance};

use super::support::{POISSON, YOUNG, body, sampled};

const NOISE: f64 = 1e-4;
const RADIUS: f64 = 5.0;
const TENSION: f64 = 40.0;

/// Displacements of a plate with a hole of radius 5 about the origin under tension along x at infinity (Kirsch 1898): without
/// traction on the hole.
fn kirsch([x, y]: Point) -> [f64; 2] {
    let (r, theta) = (x.hypot(y), y.atan2(x));
    let (q, kappa) = (RADIUS / r, (3.0 - POISSON) / (1.0 + POISSON));
    let factor = TENSION * RADIUS * (1.0 + POISSON) / (4.0 * YOUNG);
    let (c1, c3) = (theta.cos(), (3.0 * theta).cos());
    let (s1, s3) = (theta.sin(), (3.0 * theta).sin());
    let cube = q * q * q;
    [
        factor * ((kappa + 1.0) / q * c1 + 2.0 * q * ((1.0 + kappa) * c1 + c3) - 2.0 * cube * c3),
        factor * ((kappa - 3.0) / q * s1 + 2.0 * q * ((1.0 - kappa) * s1 + s3) - 2.0 * cube * s3),
    ]
}

fn plate() -> Arc<ElasticBody> {
    let sector = ArcSector {
        centre: [0.0, 0.0],
        hole: RADIUS,
        stand_off: 0.0,
        outer: 15.0,
        angles: [0.4, 2.7],
        cells: [24, 14],
        growth: 3.0,
        kind: ElementKind::Q8,
    };
    body(sector.mesh().unwrap())
}

fn normal(random: &mut StdRng) -> f64 {
    let (u, v): (f64, f64) = (random.random(), random.random());
    NOISE * (-2.0 * (1.0 - u).ln()).sqrt() * (TAU * v).cos()
}

fn noisy(region: &Region, random: &mut StdRng) -> NodalDisplacements {
    let mut measured = sampled(region.mesh(), &region.prescribed_nodes(), kirsch);
    measured
        .values
        .iter_mut()
        .for_each(|value| *value += normal(random));
    measured.covariance = independent_covariance(measured.nodes.len(), [NOISE; 2]);
    measured
}

fn scattered(random: &mut StdRng) -> Measurement {
    let places: Vec<Point> = (0..300)
        .map(|_| {
            let (r, theta) = (
                random.random_range(5.0..16.0),
                random.random_range(0.45_f64..2.65),
            );
            [r * theta.cos(), r * theta.sin()]
        })
        .collect();
    let displacements = [0, 1].map(|axis| {
        places
            .iter()
            .map(|&p| kirsch(p)[axis] + normal(random))
            .collect()
    });
    let mut valid = [vec![true; places.len()], vec![true; places.len()]];
    valid[0][0] = false;
    Measurement {
        places,
        displacements,
        valid,
        deviation: [NOISE; 2],
    }
}

#[test]
fn good_data_pass_and_bad_data_do_not() {
    let body = plate();
    let free = [FreeEdge {
        edge: "inner".into(),
        ranges: vec![[5.0 * 0.6, 5.0 * 2.5]],
    }];
    let inside = body.mesh().element(24 * 7 + 12).1[2];
    let region = Region::new(&body, &[inside]).unwrap();
    let mut random = StdRng::seed_from_u64(11);
    let seeds = 40;
    let (mut misfits, mut tractions, mut forces) = (Vec::new(), Vec::new(), Vec::new());
    for _ in 0..seeds {
        let measured = noisy(&region, &mut random);
        let unused = scattered(&mut random);
        let input = CheckInput {
            unused: Some(&unused),
            free_edges: &free,
            known_forces: &[],
        };
        let checks = region.check(&measured, input).unwrap();
        let misfit = checks.misfit.unwrap();
        assert!(!misfit.outside.is_empty() && misfit.points.len() > 400);
        misfits.push(misfit.chi_squared.excess());
        tractions.push(checks.free_edges[0].excess());
        forces.push(checks.interior_forces.unwrap().excess());
    }
    for (name, excess) in [
        ("misfit", &misfits),
        ("traction", &tractions),
        ("force", &forces),
    ] {
        let count = excess.len() as f64;
        let mean = excess.iter().sum::<f64>() / count;
        let spread = (excess.iter().map(|e| (e - mean).powi(2)).sum::<f64>() / count).sqrt();
        println!("{name}: excess of χ² over {seeds} seeds: mean {mean:.2}, deviation {spread:.2}");
        // Mean 0 and standard deviation 1; chi-squared numbers have a long tail.
        assert!(
            mean.abs() < 4.0 / count.sqrt() && (0.6..1.5).contains(&spread),
            "{name} {mean} {spread}"
        );
    }

    let mut wrong = noisy(&region, &mut random);
    let k = wrong.nodes.iter().position(|&node| node == inside).unwrap();
    wrong.values[2 * k] += 10.0 * NOISE;
    let unused = scattered(&mut random);
    let input = CheckInput {
        unused: Some(&unused),
        ..CheckInput::default()
    };
    let checks = region.check(&wrong, input).unwrap();
    assert!(checks.interior_forces.unwrap().excess() > 10.0);
    assert!(checks.misfit.unwrap().chi_squared.excess() > 3.0);
}

#[test]
fn the_force_through_an_arc_is_the_known_one() {
    let body = plate();
    let region = Region::new(&body, &[]).unwrap();
    let mut random = StdRng::seed_from_u64(5);
    // Through the outer arc goes what goes through the two sides: the hole carries nothing. From the stress function, the force
    // through a curve from angle a to b is t [Φ_y, −Φ_x].
    let force = known_force([0.4, 2.7]);
    let known = [KnownForce {
        edge: "outer".into(),
        force,
    }];
    let seeds = 60;
    let mut squares = [0.0; 2];
    for _ in 0..seeds {
        let input = CheckInput {
            known_forces: &known,
            ..CheckInput::default()
        };
        let balance = &region
            .check(&noisy(&region, &mut random), input)
            .unwrap()
            .balance[0];
        (0..2).for_each(|i| {
            squares[i] += (balance.excess[i] / balance.deviation[i]).powi(2) / f64::from(seeds);
        });
    }
    println!("mean squares of the excess in deviations: {squares:?}");
    let one_sigma = (2.0 / f64::from(seeds)).sqrt();
    assert!(
        squares.iter().all(|s| (s - 1.0).abs() < 4.0 * one_sigma),
        "{squares:?}"
    );
}

/// ∫ t σ e_r ds over the outer arc by Simpson's rule with Kirsch's stresses.
fn known_force([a, b]: [f64; 2]) -> [f64; 2] {
    let steps = 2000;
    let (q2, r) = (1.0 / 9.0, 15.0);
    let mut sum = [0.0; 2];
    for k in 0..=steps {
        let theta = a + (b - a) * f64::from(k) / f64::from(steps);
        let weight = if k == 0 || k == steps {
            1.0
        } else {
            f64::from(2 + 2 * (k % 2))
        };
        let (c2, s2) = ((2.0 * theta).cos(), (2.0 * theta).sin());
        let rr = TENSION / 2.0 * ((1.0 - q2) + (1.0 - 4.0 * q2 + 3.0 * q2 * q2) * c2);
        let rt = -TENSION / 2.0 * (1.0 + 2.0 * q2 - 3.0 * q2 * q2) * s2;
        let factor = 2.0 * r * weight * (b - a) / f64::from(steps) / 3.0;
        sum[0] += factor * (rr * theta.cos() - rt * theta.sin());
        sum[1] += factor * (rr * theta.sin() + rt * theta.cos());
    }
    sum
}

#[test]
fn squares_of_given_numbers_count_in_units_of_their_variances() {
    let found = ChiSquared::of(&[1.0, 4.0], &[1.0, 0.0, 0.0, 4.0]).unwrap();
    assert_eq!((found.count, found.value), (2, 5.0));
    assert!((found.deviation - 2.0).abs() < 1e-12);
    // Numbers that are one and the same vary together.
    let same = ChiSquared::of(&[1.0, 1.0], &[1.0; 4]).unwrap();
    assert!((same.deviation - 8.0_f64.sqrt()).abs() < 1e-12);
    assert!(ChiSquared::of(&[1.0], &[1.0; 4]).is_err());
    assert!(ChiSquared::of(&[1.0], &[0.0]).is_err());
}
