//! Outliers: none in smooth fields with or without noise, all gross ones found.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{DataError, Field, Measurement};

use super::kirsch::{RADIUS, displacement};

/// The threshold that experiments have where they state none.
const THRESHOLD: f64 = 8.0;
/// Standard deviation of noise: 1/40 of a fringe of 2400 lines per mm.
const SIGMA: f64 = 1e-5;

/// Kirsch's displacements at places off the hole.
fn field(places: impl Iterator<Item = Point>) -> Measurement {
    let places: Vec<Point> = places.filter(|at| at[0].hypot(at[1]) > RADIUS).collect();
    let values = |c: usize| {
        let each = places.iter().map(|at| displacement(*at, c).unwrap());
        each.collect()
    };
    Measurement {
        displacements: [values(0), values(1)],
        valid: [vec![true; places.len()], vec![true; places.len()]],
        deviation: [0.0; 2],
        places,
    }
}

fn grid(half: i32, spacing: f64) -> Measurement {
    let all = (-half..=half).flat_map(|i| (-half..=half).map(move |j| [i, j]));
    field(all.map(|place| place.map(|k| spacing * f64::from(k))))
}

fn scattered(count: usize, seed: u64) -> Measurement {
    let mut random = StdRng::seed_from_u64(seed);
    let place = |_| [0, 1].map(|_: usize| random.random_range(-6.0..6.0));
    field((0..count).map(place))
}

/// No noise, normal noise (Box & Muller 1958), uniform noise.
fn noises() -> [fn(f64, f64) -> f64; 3] {
    [
        |_, _| 0.0,
        |a, b| (-2.0 * (1.0 - a).ln()).sqrt() * (std::f64::consts::TAU * b).cos(),
        |a, _| 12.0_f64.sqrt() * (a - 0.5),
    ]
}

fn noisy(mut data: Measurement, noise: fn(f64, f64) -> f64, seed: u64) -> Measurement {
    let mut random = StdRng::seed_from_u64(seed);
    for u in data.displacements.iter_mut().flatten() {
        *u += SIGMA * noise(random.random(), random.random());
    }
    data
}

/// Adds so many standard deviations up or down to one component of one of so many places; their marks.
fn spoilt(data: &mut Measurement, deviations: f64, one_of: usize, seed: u64) -> Vec<[bool; 2]> {
    let mut random = StdRng::seed_from_u64(seed);
    let mut marks = vec![[false; 2]; data.places.len()];
    for _ in 0..data.places.len() / one_of {
        let (k, c) = (
            random.random_range(0..marks.len()),
            random.random_range(0..2),
        );
        if !marks[k][c] {
            marks[k][c] = true;
            let sign = if random.random::<bool>() { 1.0 } else { -1.0 };
            data.displacements[c][k] += sign * deviations * SIGMA;
        }
    }
    marks
}

#[test]
fn smooth_fields_have_no_outliers_with_or_without_noise() {
    let (mut places, mut false_alarms, mut most) = (0, 0, 0.0_f64);
    for (seed, clean) in (1..).zip([
        grid(60, 0.1),
        grid(30, 0.2),
        grid(15, 0.4),
        grid(8, 0.8),
        scattered(400, 1),
        scattered(2000, 2),
        scattered(20_000, 3),
        scattered(20_000, 4),
    ]) {
        for noise in noises() {
            // A standard deviation that is stated, and one that is not.
            for deviation in [SIGMA, 0.0] {
                let mut data = noisy(clean.clone(), noise, seed);
                data.deviation = [deviation; 2];
                let doubtful = data.outliers(0.5 * THRESHOLD).unwrap();
                places += 2 * data.places.len();
                false_alarms += doubtful.iter().filter(|one| one.ratio > THRESHOLD).count();
                most = doubtful.iter().fold(most, |most, one| most.max(one.ratio));
            }
        }
    }
    println!("{false_alarms} false alarms of {places} displacements, the largest ratio {most:.2}");
    assert!(places > 600_000);
    assert_eq!(false_alarms, 0);
}

#[test]
fn values_off_by_a_hundred_deviations_are_found_alone_and_one_in_a_hundred() {
    for (seed, clean) in (1..).zip([grid(30, 0.2), scattered(2000, 5), scattered(20_000, 6)]) {
        for noise in noises() {
            for one_of in [100, clean.places.len()] {
                let mut data = noisy(clean.clone(), noise, seed);
                let marks = spoilt(&mut data, 100.0, one_of, seed + 7);
                data.deviation = [SIGMA; 2];
                let found = data.outliers(THRESHOLD).unwrap();
                let spoilt = marks.iter().flatten().filter(|mark| **mark).count();
                assert_eq!(found.len(), spoilt, "one of {one_of}");
                for one in found {
                    let c = one.field.component();
                    assert!(marks[one.place][c], "{one:?}");
                    let truth = clean.displacements[c][one.place];
                    assert!((one.expected - truth).abs() < 10.0 * SIGMA, "{one:?}");
                    assert_eq!(one.value, data.displacements[c][one.place]);
                }
            }
        }
    }
}

/// The limit: of displacements that are off by twenty standard deviations of the noise, half are found.
#[test]
fn half_of_the_values_that_are_off_by_twenty_deviations_are_found() {
    let fields = [grid(30, 0.2), scattered(2000, 5), scattered(20_000, 6)];
    let found = |deviations: f64| {
        let (mut found, mut all) = (0, 0);
        for (seed, clean) in (1..).zip(&fields) {
            for noise in &noises()[1..] {
                let mut data = noisy(clean.clone(), *noise, seed);
                let marks = spoilt(&mut data, deviations, 100, seed + 7);
                data.deviation = [SIGMA; 2];
                all += marks.iter().flatten().filter(|mark| **mark).count();
                let outliers = data.outliers(THRESHOLD).unwrap();
                found += (outliers.iter())
                    .filter(|one| marks[one.place][one.field.component()])
                    .count();
            }
        }
        println!("{deviations} deviations: {found} of {all} found");
        found as f64 / all as f64
    };
    let parts = [12.0, 16.0, 20.0, 25.0, 30.0].map(found);
    assert!(parts.is_sorted(), "{parts:?}");
    assert!(
        parts[0] < 0.02 && (0.3..0.7).contains(&parts[2]) && parts[4] > 0.95,
        "{parts:?}"
    );
}

/// Two that are neighbours, and a row of them, do not hide each other or make their good neighbours bad.
#[test]
fn outliers_that_are_neighbours_are_found_and_good_places_among_them_kept() {
    for row in [2, 3] {
        let mut data = grid(15, 0.4);
        let mut bad = Vec::new();
        for k in 0..row {
            let at = [3.2 + 0.4 * f64::from(k), 2.8];
            let index = (data.places.iter())
                .position(|place| (place[0] - at[0]).hypot(place[1] - at[1]) < 1e-9);
            bad.push(index.unwrap());
            data.displacements[1][index.unwrap()] += 0.02;
        }
        let found = data.outliers(THRESHOLD).unwrap();
        let mut places: Vec<usize> = found.iter().map(|one| one.place).collect();
        places.sort_unstable();
        assert_eq!(places, bad);
        assert!(found.iter().all(|one| one.field == Field::V));
    }
}

/// Lines of places far apart: the nearest neighbours make no plane.
#[test]
fn places_along_lines_have_outliers_too() {
    let lines = (-3..=3).flat_map(|j| (-60..=60).map(move |i| [i, j]));
    let places = lines.map(|[i, j]| [0.1 * f64::from(i), 1.9 * f64::from(j)]);
    let mut data = field(places);
    assert!(data.outliers(THRESHOLD).unwrap().is_empty());
    data.displacements[0][100] += 1e-3;
    let found = data.outliers(THRESHOLD).unwrap();
    assert_eq!(found.len(), 1);
    assert_eq!((found[0].place, found[0].field), (100, Field::U));
}

#[test]
fn what_cannot_be_asked_has_none_or_is_refused() {
    let mut data = scattered(400, 1);
    for threshold in [0.0, -1.0, f64::NAN] {
        let error = data.outliers(threshold).unwrap_err();
        assert!(matches!(error, DataError::Setting { .. }), "{error}");
    }
    data.displacements[0][17] = f64::NAN;
    assert!(matches!(
        data.outliers(THRESHOLD),
        Err(DataError::NotFinite { index: 17, .. })
    ));
    // A masked place is not asked, and is no neighbour.
    data.mask(Field::U, |k| k == 17);
    assert!(data.outliers(THRESHOLD).unwrap().is_empty());
    let few = Measurement {
        places: (0..8).map(|k| [f64::from(k), f64::from(k * k)]).collect(),
        displacements: [vec![0.0, 0.0, 9.0, 0.0, 0.0, 0.0, 0.0, 0.0], vec![0.0; 8]],
        valid: [vec![true; 8], vec![true; 8]],
        deviation: [0.0; 2],
    };
    assert!(few.outliers(THRESHOLD).unwrap().is_empty());
    // All alike, to the last digit; and all but one.
    let mut flat = grid(5, 1.0);
    flat.displacements = [vec![0.0; flat.places.len()], vec![0.0; flat.places.len()]];
    assert!(flat.outliers(THRESHOLD).unwrap().is_empty());
    flat.displacements[0][3] = 1e-12;
    let found = flat.outliers(THRESHOLD).unwrap();
    assert!(
        found.len() == 1 && found[0].ratio == f64::INFINITY,
        "{found:?}"
    );
}
