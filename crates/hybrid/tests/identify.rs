//! Friction from tractions whose truth is known.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::identify::{Bounds, IdentifyError, Tractions};

const PLACES: usize = 24;

/// Pressures that fall to nothing at the last place but half of them, shears that stick up to `stick` and slip beyond with `mu`.
fn truth(mu: f64, stick: usize) -> ([Vec<f64>; 2], usize) {
    let pressure: Vec<f64> = (0..PLACES)
        .map(|k| 100.0 * (1.0 - (k as f64 / PLACES as f64).powi(2)).sqrt())
        .collect();
    let shear = (0..PLACES)
        .map(|k| {
            let part = if k < stick {
                k as f64 / stick as f64
            } else {
                1.0
            };
            mu * part * part * pressure[k]
        })
        .collect();
    ([pressure, shear], PLACES - 1)
}

/// A standard normal number.
fn normal(random: &mut StdRng) -> f64 {
    (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0
}

/// The truth with errors of standard deviation `noise` that are correlated at neighbouring places and between pressure and shear.
fn measured(mu: f64, stick: usize, noise: f64, seed: u64) -> Tractions {
    let ([pressure, shear], _) = truth(mu, stick);
    let n = 2 * PLACES;
    // Errors are x_i + x_{i+1}/2 of independent x.
    let weight = |i: usize, j: usize| match j.checked_sub(i) {
        Some(0) => noise,
        Some(1) => 0.5 * noise,
        _ => 0.0,
    };
    let mut random = StdRng::seed_from_u64(seed);
    let x: Vec<f64> = (0..=n).map(|_| normal(&mut random)).collect();
    let error = |i: usize| (0..=n).map(|j| weight(i, j) * x[j]).sum::<f64>();
    let covariance = (0..n * n)
        .map(|at| (0..=n).map(|k| weight(at / n, k) * weight(at % n, k)).sum())
        .collect();
    Tractions {
        pressure: (0..PLACES).map(|i| pressure[i] + error(i)).collect(),
        shear: (0..PLACES).map(|i| shear[i] + error(PLACES + i)).collect(),
        covariance,
    }
}

#[test]
fn exact_tractions_give_the_coefficient() {
    let ([pressure, shear], _) = truth(0.25, 8);
    let data = Tractions {
        pressure,
        shear,
        ..measured(0.25, 8, 0.1, 0)
    };
    let fit = data.slip(8..PLACES, true).unwrap();
    assert!(
        (fit.mu - 0.25).abs() < 1e-7 && fit.chi_squared < 1e-6,
        "{fit:?}"
    );
    assert_eq!(fit.degrees, PLACES - 9);
    let turned = Tractions {
        shear: data.shear.iter().map(|t| -t).collect(),
        ..data
    };
    let mirrored = turned.slip(8..PLACES, false).unwrap();
    // The cross terms of the errors turn with the sign, the coefficient does not.
    assert!((mirrored.mu - 0.25).abs() < 1e-7);
}

#[test]
fn the_interval_covers_the_truth_as_often_as_it_says() {
    let (mut covered, mut sum, seeds) = (0, 0.0, 400);
    for seed in 0..seeds {
        let fit = measured(0.25, 8, 2.0, seed).slip(8..PLACES, true).unwrap();
        covered += usize::from(fit.bounds.contain(0.25));
        sum += fit.mu - 0.25;
    }
    let [part, bias] = [covered as f64 / seeds as f64, sum / seeds as f64];
    println!("covered {part}, bias {bias}");
    assert!((0.92..=0.98).contains(&part), "{part}");
    assert!(bias.abs() < 0.002, "{bias}");
}

#[test]
fn narrow_intervals_lie_around_the_coefficient() {
    // Far narrower than the grid of coefficients that is looked at first.
    for step in 0..60 {
        let mu = 0.2 + 0.002 * f64::from(step);
        let fit = measured(mu, 8, 0.02, 5).slip(8..PLACES, true).unwrap();
        let Bounds::Between(low, high) = fit.bounds else {
            panic!("{fit:?}")
        };
        assert!(low < fit.mu && fit.mu < high, "{fit:?}");
        assert!(high - low < 1e-3 && (fit.mu - mu).abs() < 1e-3, "{fit:?}");
    }
}

#[test]
fn draws_confirm_the_interval() {
    let data = measured(0.25, 8, 2.0, 7);
    let fit = data.slip(8..PLACES, true).unwrap();
    let Bounds::Between(low, high) = fit.bounds else {
        panic!("{fit:?}")
    };
    let mut draws = data.simulate(8..PLACES, true, &fit, 4000, 1).unwrap();
    draws.sort_by(f64::total_cmp);
    let [first, last] = [draws[100], draws[3899]];
    println!("interval {low:.4} … {high:.4}, of draws {first:.4} … {last:.4}");
    // Quantiles of 4000 draws have a standard deviation of 0.025 of a half width of the interval.
    let half = 0.5 * (high - low);
    assert!((first - low).abs() < 0.12 * half && (last - high).abs() < 0.12 * half);
    let mean = draws.iter().sum::<f64>() / 4000.0;
    assert!((mean - fit.mu).abs() < 0.05 * half, "{mean} {}", fit.mu);
}

#[test]
fn zones_of_two_states_give_one_coefficient() {
    let up = measured(0.25, 8, 2.0, 11);
    let mut down = measured(0.25, 8, 2.0, 12);
    // Unloading slips the other way; the errors of pressure and shear then go against each other.
    for value in &mut down.shear {
        *value = -*value;
    }
    for row in 0..2 * PLACES {
        for column in 0..2 * PLACES {
            if (row < PLACES) != (column < PLACES) {
                down.covariance[row * 2 * PLACES + column] *= -1.0;
            }
        }
    }
    let [first, second] = [(&up, true), (&down, false)].map(|(data, positive)| {
        let zone = 8..PLACES;
        let alone = data.slip(zone.clone(), positive).unwrap();
        let part = data.of_zones(&[(zone, positive)]).unwrap();
        // The same places as a list of their own say the same.
        let own = part.slip(0..PLACES - 8, true).unwrap();
        assert!(
            (own.mu - alone.mu).abs() < 1e-9 && (own.chi_squared - alone.chi_squared).abs() < 1e-6
        );
        (part, alone)
    });
    let both = Tractions::together(&[first.0, second.0]).unwrap();
    let fit = both.slip(0..2 * (PLACES - 8), true).unwrap();
    let width = |fit: &stickslip_hybrid::identify::SlipFit| match fit.bounds {
        Bounds::Between(low, high) => high - low,
        _ => f64::INFINITY,
    };
    let alone = [width(&first.1), width(&second.1)];
    // Weights add up: 1/w² = 1/w₁² + 1/w₂².
    let expected = (alone[0].powi(-2) + alone[1].powi(-2)).powf(-0.5);
    println!("widths {alone:?}, together {}", width(&fit));
    assert!((width(&fit) / expected - 1.0).abs() < 0.05);
    let between = [first.1.mu, second.1.mu];
    assert!(fit.mu > between[0].min(between[1]) && fit.mu < between[0].max(between[1]));
}

#[test]
fn the_slip_zone_ends_where_sticking_begins() {
    let mut ends = Vec::new();
    for seed in 0..40 {
        let data = measured(0.3, 10, 0.5, seed);
        let (zone, fit) = data.slip_zone(PLACES - 1, 0, true, 3.0).unwrap();
        assert_eq!(zone.end, PLACES);
        assert!((fit.mu - 0.3).abs() < 0.02, "{fit:?}");
        ends.push(zone.start);
    }
    ends.sort_unstable();
    println!("slip begins at {ends:?}");
    // Shear departs from slip by the square of the distance: the first places of stick are hidden in the noise.
    assert!((8..=10).contains(&ends[20]), "{ends:?}");
}

/// Noise hides where sticking begins from χ² of all places, but not from a coefficient of the inner ones.
#[test]
fn a_zone_in_much_noise_does_not_go_far_into_what_sticks() {
    let seeds = 200;
    let (mut held, mut starts) = (0, Vec::new());
    for seed in 0..seeds {
        let data = measured(0.2, 14, 2.0, seed);
        let (zone, fit) = data.slip_zone(PLACES - 1, 0, true, 3.0).unwrap();
        held += usize::from(fit.bounds.contain(0.2));
        starts.push(zone.start);
    }
    starts.sort_unstable();
    let middle = starts[starts.len() / 2];
    println!(
        "{held} of {seeds} intervals hold the coefficient; zones begin at {middle} in the median"
    );
    // By χ² of all places alone 54 do, and zones begin at place 9.
    assert!(held >= 150, "{held}");
    assert!((10..=14).contains(&middle), "{middle}");
}

/// Data smoothed over many places have errors of fewer directions than there are places.
#[test]
fn covariances_of_few_directions_are_no_obstacle() {
    let n = 2 * PLACES;
    let wave = |k: usize, i: usize| (0.2 * (k + 1) as f64 * i as f64 + k as f64).cos();
    let covariance = (0..n * n)
        .map(|at| (0..6).map(|k| wave(k, at / n) * wave(k, at % n)).sum())
        .collect();
    let ([pressure, shear], _) = truth(0.25, 8);
    let data = Tractions {
        pressure,
        shear,
        covariance,
    };
    let fit = data.slip(8..PLACES, true).unwrap();
    assert!((fit.mu - 0.25).abs() < 1e-6, "{fit:?}");
    let draws = data.simulate(8..PLACES, true, &fit, 100, 1).unwrap();
    assert!(draws.iter().all(|mu| mu.is_finite()));
}

#[test]
fn no_friction_gives_an_upper_bound_and_noise_alone_gives_nothing() {
    let mut bounded = 0;
    for seed in 0..100 {
        let fit = measured(0.0, 8, 2.0, seed).slip(8..PLACES, true).unwrap();
        bounded += usize::from(matches!(fit.bounds, Bounds::AtMost(high) if high < 0.05));
    }
    // In 2.5 % of all cases chance alone lifts the lower end above zero.
    assert!(bounded >= 92, "{bounded}");
    let mut data = measured(0.0, 8, 2.0, 1);
    data.pressure
        .iter_mut()
        .chain(&mut data.shear)
        .for_each(|value| *value = 0.0);
    let fit = data.slip(8..PLACES, true).unwrap();
    assert_eq!(fit.bounds, Bounds::Nothing);
}

/// Shears that all lie on the other side of friction: an interval of coefficients from 0 on by the rise of χ² alone would vanish.
#[test]
fn an_upper_bound_does_not_shrink_as_the_data_contradict_friction() {
    let bound = |shift: f64| {
        let mut data = measured(0.0, 0, 1.0, 3);
        data.shear.iter_mut().for_each(|shear| *shear -= shift);
        match data.slip(8..PLACES, true).unwrap().bounds {
            Bounds::AtMost(high) => high,
            other => panic!("{other:?}"),
        }
    };
    let [near, far] = [2.0, 20.0].map(bound);
    assert!(far > 0.5 * near && near > 1e-3, "{near} {far}");
}

#[test]
fn bounds_widen_by_squares_and_end_where_there_is_nothing_less() {
    let wide = Bounds::Between(0.22, 0.28).widened(0.25, 0.04, 0.0);
    assert!(
        matches!(wide, Bounds::Between(low, high) if (low - 0.2).abs() < 1e-12 && (high - 0.3).abs() < 1e-12)
    );
    let wide = Bounds::Between(0.01, 0.05).widened(0.03, 0.04, 0.0);
    assert!(matches!(wide, Bounds::AtMost(_)));
    assert_eq!(
        Bounds::AtLeast(0.01).widened(0.03, 0.04, 0.0),
        Bounds::Nothing
    );
}

#[test]
fn what_does_not_fit_is_refused() {
    let data = measured(0.2, 8, 1.0, 3);
    let zone = data.slip(20..30, true).unwrap_err();
    assert_eq!(zone.to_string(), "the zone 20..30 is not among 24 places");
    assert!(matches!(
        data.slip(5..5, true),
        Err(IdentifyError::Zone { .. })
    ));
    let short = Tractions {
        covariance: vec![1.0; 9],
        ..data.clone()
    };
    assert!(matches!(
        short.slip(0..4, true),
        Err(IdentifyError::Lengths { entries: 9, .. })
    ));
    let mut broken = data.clone();
    broken.shear[3] = f64::NAN;
    assert_eq!(
        broken.slip(0..5, true),
        Err(IdentifyError::NotFinite { place: 3 })
    );
    let flat = Tractions {
        covariance: vec![0.0; 4 * PLACES * PLACES],
        ..data
    };
    assert!(matches!(
        flat.slip(0..5, true),
        Err(IdentifyError::Covariance { .. })
    ));
}
