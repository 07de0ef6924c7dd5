//! Reductions to nodes: exact polynomials, order of convergence, covariance against seeds, places the data do not cover.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::data::{Field, FringeLine, FringeLines, Measurement, Track};
use stickslip_hybrid::moire::Grating;
use stickslip_hybrid::reduce::{LocalPolynomial, Reason, ReduceError, Reduction};

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
    let mut list = vec![Reduction::linear(m, places, &wanted, f64::INFINITY).unwrap()];
    list.extend(
        (1..=3).map(|order| Reduction::polynomial(m, places, &wanted, &polynomial(order)).unwrap()),
    );
    list.into_iter()
        .map(|reduction| reduction.complete().unwrap())
        .collect()
}

#[test]
fn polynomials_come_back_to_rounding() {
    let places = nodes();
    for (k, order) in [1, 1, 2, 3].into_iter().enumerate() {
        let field = |[x, y]: Point| {
            let s = 1.0 + 2.0 * x - y;
            [s.powi(order), (3.0 - x - 0.5 * y).powi(order)]
        };
        let m = measured(scattered(12, 1), field);
        let found = methods(&m, &places)[k].displacements(&m).unwrap();
        assert_eq!(found.nodes, all(&places));
        for (n, &place) in places.iter().enumerate() {
            for c in 0..2 {
                // Values are at most 27; weights of one sign cannot amplify rounding, others by their sum of sizes, below 10 here.
                assert!(
                    (found.values[2 * n + c] - field(place)[c]).abs() < 1e-12,
                    "method {k}, node {n}"
                );
            }
        }
    }
}

#[test]
fn smooth_fields_converge_at_the_order_of_the_method() {
    let places = nodes();
    let field = |[x, y]: Point| [(3.0 * x + y).sin(), (x - 2.0 * y).exp()];
    let errors: Vec<Vec<f64>> = [24, 48, 96]
        .iter()
        .map(|&n| {
            let m = measured(scattered(n, 2), field);
            methods(&m, &places)
                .iter()
                .map(|reduction| {
                    let values = reduction.displacements(&m).unwrap().values;
                    let square: f64 = values
                        .chunks(2)
                        .zip(&places)
                        .flat_map(|(u, &place)| [0, 1].map(|c| (u[c] - field(place)[c]).powi(2)))
                        .sum();
                    (square / values.len() as f64).sqrt()
                })
                .collect()
        })
        .collect();
    for (k, order) in [2.0, 2.0, 3.0, 4.0].into_iter().enumerate() {
        let slope = (errors[0][k] / errors[2][k]).log2() / 2.0;
        println!(
            "method {k}: errors {:.1e} {:.1e} {:.1e}, slope {slope:.2}",
            errors[0][k], errors[1][k], errors[2][k]
        );
        // Scattered places: the mean over 80 values leaves a scatter of the slope; less than the order by 0.3 is a lost order.
        assert!(slope > order - 0.3, "method {k}: slope {slope}");
    }
}

/// Noise over seeds against the propagated covariance: the variances, the largest covariance off the diagonal, and all of them.
fn against_seeds(
    covariance: &[f64],
    size: usize,
    seeds: u64,
    sample: impl Fn(&mut StdRng) -> Vec<f64>,
) {
    let mut sums = vec![0.0; size * size];
    for seed in 0..seeds {
        let noise = sample(&mut StdRng::seed_from_u64(seed));
        for row in 0..size {
            for column in 0..size {
                sums[row * size + column] += noise[row] * noise[column];
            }
        }
    }
    let (mut trace, mut expected) = (0.0, 0.0);
    let mut deviations = Vec::new();
    for row in 0..size {
        let variance = covariance[row * size + row];
        trace += sums[row * size + row] / seeds as f64;
        expected += variance;
        deviations.push((sums[row * size + row] / seeds as f64 / variance).sqrt());
        for column in 0..size {
            // A covariance over S seeds scatters by √((Σᵢᵢ Σⱼⱼ + Σᵢⱼ²)/S); five of these in none of a few thousand entries.
            let exact = covariance[row * size + column];
            let scatter = ((variance * covariance[column * size + column] + exact * exact)
                / seeds as f64)
                .sqrt();
            let found = sums[row * size + column] / seeds as f64;
            assert!(
                (found - exact).abs() <= 5.0 * scatter,
                "({row}, {column}): {found:.3e} for {exact:.3e}"
            );
        }
    }
    let total = (trace / expected).sqrt();
    let worst = deviations
        .iter()
        .fold(0.0, |worst: f64, ratio| worst.max((ratio - 1.0).abs()));
    println!(
        "noise over {seeds} seeds: {total:.4} of the propagated, worst entry off by {worst:.3}"
    );
    assert!((total - 1.0).abs() < 0.1 && worst < 0.1);
}

/// Uniform noise of the given standard deviation; its half width is √3 of it.
fn uniform(random: &mut StdRng, deviation: f64) -> f64 {
    let half = 3.0_f64.sqrt() * deviation;
    random.random_range(-half..half)
}

#[test]
fn noise_over_seeds_has_the_propagated_covariance() {
    let places: Vec<Point> = nodes().into_iter().take(20).collect();
    let mut m = measured(scattered(12, 3), |_| [0.0; 2]);
    m.deviation = [1e-4, 2e-4];
    m.mask(Field::U, |k| k % 17 == 5);
    for (k, reduction) in methods(&m, &places).iter().enumerate() {
        let found = reduction.displacements(&m).unwrap();
        print!("method {k}: ");
        against_seeds(&found.covariance, 2 * places.len(), 2000, |random| {
            let noise = m.deviation.map(|deviation| -> Vec<f64> {
                (0..m.places.len())
                    .map(|_| uniform(random, deviation))
                    .collect()
            });
            reduction.values([&noise[0], &noise[1]]).unwrap()
        });
    }
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

#[test]
fn fringe_lines_converge_at_second_order_and_carry_their_covariance() {
    let grating = Grating::new(2400.0).unwrap();
    let places = on_circle(36);
    let error = |count| {
        let fields = [
            ring(count, 2.0, |t| 20.0 * t.sin(), 4, Field::U),
            ring(count, 2.0, |t| 15.0 * (2.0 * t).cos(), 5, Field::V),
        ];
        let pair = [&fields[0], &fields[1]];
        let reduction = Reduction::along_lines(pair, &places, &all(&places), 1e-9)
            .unwrap()
            .complete()
            .unwrap();
        let found = reduction
            .fringe_displacements(pair, &grating, [0.1, 0.2])
            .unwrap();
        let square: f64 = (0..36)
            .map(|k| {
                let t = std::f64::consts::TAU * k as f64 / 36.0;
                let u = found.values[2 * k] - 20.0 * t.sin() / 2400.0;
                let v = found.values[2 * k + 1] - 15.0 * (2.0 * t).cos() / 2400.0;
                u * u + v * v
            })
            .sum();
        ((square / 72.0).sqrt(), reduction, found)
    };
    let [(coarse, reduction, found), (fine, ..)] = [error(40), error(320)];
    let slope = (coarse / fine).log2() / 3.0;
    println!("fringe lines: errors {coarse:.1e} {fine:.1e}, slope {slope:.2}");
    assert!(slope > 1.7, "slope {slope}");
    against_seeds(&found.covariance, 72, 2000, |random| {
        let noise = [0.1, 0.2].map(|order| -> Vec<f64> {
            (0..40)
                .map(|_| uniform(random, grating.displacement(order)))
                .collect()
        });
        reduction.values([&noise[0], &noise[1]]).unwrap()
    });
}

#[test]
fn neighbouring_nodes_share_data_and_components_do_not() {
    let places = vec![[0.25, 0.0], [0.75, 0.0]];
    let m = Measurement {
        deviation: [2.0, 3.0],
        ..measured(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], |_| [0.0; 2])
    };
    let reduction = Reduction::linear(&m, &places, &[0, 1], 2.0)
        .unwrap()
        .complete()
        .unwrap();
    let covariance = reduction.displacements(&m).unwrap().covariance;
    // Weights ¾, ¼ and ¼, ¾: variances 10/16, covariance 6/16, times σ².
    let exact = [
        [2.5, 0.0, 1.5, 0.0],
        [0.0, 5.625, 0.0, 3.375],
        [1.5, 0.0, 2.5, 0.0],
        [0.0, 3.375, 0.0, 5.625],
    ];
    assert!(
        covariance
            .iter()
            .zip(exact.as_flattened())
            .all(|(a, b)| (a - b).abs() < 1e-14)
    );
}

#[test]
fn nodes_without_data_are_named_with_their_place() {
    // A plate with a hole of radius 0.3, into which triangles would reach from all sides.
    let grid: Vec<Point> = (0..=20)
        .flat_map(|i| (0..=20).map(move |j| [f64::from(i) / 20.0, f64::from(j) / 20.0]))
        .filter(|[x, y]| (x - 0.5).hypot(y - 0.5) > 0.3)
        .collect();
    let m = measured(grid, |[x, y]| [x, y]);
    let places = vec![
        [0.5, 0.5],
        [0.1, 0.1],
        [1.2, 0.5],
        [0.5, 0.15],
        [1.0, 0.333],
    ];
    let wanted = all(&places);
    let linear = Reduction::linear(&m, &places, &wanted, 0.15).unwrap();
    assert_eq!(linear.nodes(), [1, 3, 4]);
    assert!(matches!(linear.uncovered()[0].reason, Reason::Gap { .. }));
    assert_eq!(linear.uncovered()[1].reason, Reason::Outside);
    let words = linear.complete().unwrap_err().to_string();
    assert!(
        words.starts_with(
            "2 of 5 nodes are not covered by the data: node 0 at (0.5, 0.5), component x: in a gap"
        ),
        "{words}"
    );
    assert!(
        words.ends_with("node 2 at (1.2, 0.5), component x: outside the data"),
        "{words}"
    );

    let fit = LocalPolynomial {
        largest_radius: 0.2,
        ..polynomial(2)
    };
    let local = Reduction::polynomial(&m, &places, &wanted, &fit).unwrap();
    assert_eq!(local.nodes(), [1, 3, 4]);
    assert!(matches!(
        local.uncovered()[0].reason,
        Reason::Sparse { neighbours: 12, .. }
    ));
    let near_edge = vec![[1.02, 0.5]];
    let local = Reduction::polynomial(&m, &near_edge, &[0], &fit).unwrap();
    assert!(matches!(
        local.uncovered()[0].reason,
        Reason::OneSided { .. }
    ));
    let beyond = LocalPolynomial {
        extrapolate: true,
        ..fit
    };
    let found = Reduction::polynomial(&m, &near_edge, &[0], &beyond)
        .unwrap()
        .displacements(&m)
        .unwrap();
    assert!((found.values[0] - 1.02).abs() < 1e-12);

    let lines = [
        ring(20, 2.0, |_| 0.0, 1, Field::U),
        ring(20, 2.0, |_| 0.0, 1, Field::V),
    ];
    let reduction = Reduction::along_lines(
        [&lines[0], &lines[1]],
        &[[2.0, 0.0], [2.5, 0.0]],
        &[0, 1],
        0.01,
    )
    .unwrap();
    assert!(matches!(
        reduction.uncovered()[0].reason,
        Reason::OffLines { .. }
    ));
    let swapped = Reduction::along_lines([&lines[1], &lines[0]], &[[2.0, 0.0]], &[0], 0.01);
    assert!(matches!(swapped, Err(ReduceError::Field { .. })));
}

#[test]
fn masked_places_take_no_part() {
    let field = |[x, y]: Point| [x + 2.0 * y, x - y];
    let mut m = measured(scattered(12, 6), field);
    let full = methods(&m, &nodes());
    m.mask(Field::U, |k| k % 3 == 0);
    m.mask(Field::V, |k| k % 4 == 0);
    for reduction in methods(&m, &nodes()) {
        for k in 0..nodes().len() {
            for field in Field::BOTH {
                let mut stencil = reduction.stencil(k, field).unwrap().iter();
                assert!(stencil.all(|&(index, _)| m.valid[field.component()][index]));
            }
        }
        let values = reduction.displacements(&m).unwrap().values;
        assert!(
            values
                .iter()
                .enumerate()
                .all(|(i, u)| (u - field(nodes()[i / 2])[i % 2]).abs() < 1e-12)
        );
    }
    // A reduction made for other data says what is missing.
    assert!(matches!(
        full[0].displacements(&m),
        Err(ReduceError::Masked { .. })
    ));
    let fewer = measured(scattered(3, 1), field);
    assert!(matches!(
        full[0].displacements(&fewer),
        Err(ReduceError::Size {
            found: 16,
            needed: 169,
            ..
        })
    ));
}

#[test]
fn bad_settings_and_data_are_refused() {
    let good = measured(scattered(4, 1), |_| [0.0; 2]);
    let place = [[0.5, 0.5]];
    assert!(matches!(
        Reduction::linear(&good, &place, &[1], 1.0),
        Err(ReduceError::NoSuchNode { node: 1, count: 1 })
    ));
    assert!(matches!(
        Reduction::linear(&good, &[[f64::NAN, 0.0]], &[0], 1.0),
        Err(ReduceError::NotFinite { .. })
    ));
    assert!(matches!(
        Reduction::linear(&good, &place, &[0], f64::NAN),
        Err(ReduceError::Setting { .. })
    ));
    let row = measured(vec![[0.0, 0.0], [1.0, 1.0], [2.0, 2.0]], |_| [0.0; 2]);
    let twice = measured(vec![[0.0, 0.0], [1.0, 1.0], [1.0, 1.0], [0.0, 1.0]], |_| {
        [0.0; 2]
    });
    for (m, words) in [
        (&row, "all 3 lie on one line"),
        (&twice, "only 3 of 4 places are distinct"),
    ] {
        let error = Reduction::linear(m, &place, &[0], 1.0).unwrap_err();
        assert!(error.to_string().ends_with(words), "{error}");
    }
    let fit = |order, neighbours| LocalPolynomial {
        neighbours,
        ..LocalPolynomial {
            order,
            ..polynomial(1)
        }
    };
    let error = |m: &Measurement, fit| Reduction::polynomial(m, &place, &[0], &fit).unwrap_err();
    assert_eq!(error(&good, fit(4, 20)), ReduceError::Order(4));
    assert!(matches!(
        error(&good, fit(2, 5)),
        ReduceError::Neighbours { needed: 6, .. }
    ));
    assert!(matches!(
        error(&good, fit(1, 26)),
        ReduceError::TooFew { valid: 25, .. }
    ));
    let line = Reduction::polynomial(&row, &[[1.0, 1.0]], &[0], &fit(1, 3)).unwrap();
    assert_eq!(line.uncovered()[0].reason, Reason::Degenerate);
    let mut broken = good.clone();
    broken.valid[1].pop();
    assert!(matches!(
        Reduction::linear(&broken, &place, &[0], 1.0),
        Err(ReduceError::Data(_))
    ));
    let mut infinite = good;
    infinite.displacements[0][3] = f64::INFINITY;
    assert!(matches!(
        Reduction::linear(&infinite, &place, &[0], 1.0),
        Err(ReduceError::Data(_))
    ));
}

#[test]
fn extreme_coordinates_are_no_trouble() {
    for scale in [1e-150, 1e-12, 1e12, 1e150] {
        let places: Vec<Point> = scattered(6, 9)
            .iter()
            .map(|place| place.map(|x| scale * x))
            .collect();
        let m = measured(places, |[x, y]| [x / scale, y / scale]);
        let node = [[0.45 * scale, 0.55 * scale], [1e300, 0.0]];
        for reduction in [
            Reduction::linear(&m, &node, &[0, 1], f64::INFINITY).unwrap(),
            Reduction::polynomial(&m, &node, &[0, 1], &polynomial(2)).unwrap(),
        ] {
            assert_eq!(reduction.nodes(), [0]);
            assert!((reduction.displacements(&m).unwrap().values[1] - 0.55).abs() < 1e-12);
        }
    }
}

#[test]
fn same_data_same_bits_for_any_number_of_threads() {
    let m = measured(scattered(20, 8), |[x, y]| [x * y, y.sin()]);
    let reduce = |threads| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        pool.install(|| {
            Reduction::polynomial(&m, &nodes(), &all(&nodes()), &polynomial(3)).unwrap()
        })
    };
    assert_eq!(reduce(1), reduce(3));
}
