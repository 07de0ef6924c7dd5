//! Covariance against seeds and by hand; fringe lines.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::data::{Field, Measurement};
use stickslip_hybrid::moire::Grating;
use stickslip_hybrid::reduce::Reduction;

use super::{Point, all, measured, methods, nodes, on_circle, ring, scattered};

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
    let reduction = Reduction::linear(&m, &places, &[0, 1], Some(2.0))
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
