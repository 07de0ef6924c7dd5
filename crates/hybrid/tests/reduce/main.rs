//! Reductions to nodes: exact polynomials, order of convergence, covariance against seeds, places the data do not cover.

mod accuracy;
mod noise;
mod refusals;

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::data::{Field, FringeLine, FringeLines, Measurement, Track};
use stickslip_hybrid::reduce::{LocalPolynomial, Reduction};

type Point = [f64; 2];

/// Places of a grid of n × n steps on the unit square, each moved by up to a quarter of a step.
fn scattered(n: usize, seed: u64) -> Vec<Point> {
    let mut random = StdRng::seed_from_u64(seed);
    let step = 1.0 / n as f64;
    (0..(n + 1) * (n + 1))
        .map(|k| {
            [k % (n + 1), k / (n + 1)].map(|i| step * (i as f64 + random.random_range(-0.25..0.25)))
        })
        .collect()
}

fn measured(places: Vec<Point>, field: impl Fn(Point) -> [f64; 2]) -> Measurement {
    let values: Vec<[f64; 2]> = places.iter().map(|&place| field(place)).collect();
    Measurement {
        displacements: [0, 1].map(|c: usize| values.iter().map(|u| u[c]).collect()),
        valid: [vec![true; places.len()], vec![true; places.len()]],
        deviation: [0.0; 2],
        places,
    }
}

/// Nodes inside the unit square, off any grid.
fn nodes() -> Vec<Point> {
    let mut random = StdRng::seed_from_u64(7);
    (0..40)
        .map(|_| [0; 2].map(|_| random.random_range(0.2..0.8)))
        .collect()
}

fn all(places: &[Point]) -> Vec<usize> {
    (0..places.len()).collect()
}

fn polynomial(order: usize) -> LocalPolynomial {
    LocalPolynomial {
        order,
        neighbours: [6, 12, 20][order - 1],
        largest_radius: f64::INFINITY,
        extrapolate: false,
    }
}

fn methods(m: &Measurement, places: &[Point]) -> Vec<Reduction> {
    let wanted = all(places);
    let mut list = vec![Reduction::linear(m, places, &wanted, Some(f64::INFINITY)).unwrap()];
    list.extend(
        (1..=3).map(|order| Reduction::polynomial(m, places, &wanted, &polynomial(order)).unwrap()),
    );
    list.into_iter()
        .map(|reduction| reduction.complete().unwrap())
        .collect()
}

fn ring(
    count: usize,
    radius: f64,
    order: impl Fn(f64) -> f64,
    jitter: u64,
    field: Field,
) -> FringeLines {
    let mut random = StdRng::seed_from_u64(jitter);
    let step = std::f64::consts::TAU / count as f64;
    let centres: Vec<(Point, f64)> = (0..count)
        .map(|k| {
            let t = step * (k as f64 + random.random_range(-0.3..0.3));
            ([radius * t.cos(), radius * t.sin()], order(t))
        })
        .collect();
    let track = Track::Circle {
        centre: [0.0; 2],
        closed: true,
    };
    let line = FringeLine::new("test", "hole", track, &centres, 1e-9).unwrap();
    FringeLines {
        field,
        lines: vec![line],
    }
}

fn on_circle(count: usize) -> Vec<Point> {
    (0..count)
        .map(|k| {
            let t = std::f64::consts::TAU * k as f64 / count as f64;
            [2.0 * t.cos(), 2.0 * t.sin()]
        })
        .collect()
}
