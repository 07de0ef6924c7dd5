//! Where intervals have their limits: models that have no answer beyond some value, as a contact problem that does not converge, and
//! errors that several blocks have in common, as those of one null field.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::calibrate::{
    Block, Calibration, Correlation, Data, Noise, Parameter, Settings, calibrate,
};
use stickslip_hybrid::identify::Bounds;

const PLACES: usize = 30;

fn along(k: usize) -> f64 {
    k as f64 / (PLACES - 1) as f64
}

#[test]
fn the_end_of_a_profile_is_found_beside_places_that_the_model_refuses() {
    // The slope has the standard deviation 0.025: 4.89 of them are the confidence 0.999999, steps of the profile are at 3.85 and 5.3.
    const SLOPE: f64 = 0.6;
    const DEVIATION: f64 = 0.025;
    let norm = (0..PLACES).map(|k| along(k).powi(2)).sum::<f64>().sqrt();
    let values: Vec<f64> = (0..PLACES).map(|k| SLOPE * along(k)).collect();
    let block = Block {
        values,
        noise: Noise::Independent(vec![DEVIATION * norm; PLACES]),
        nuisance: Vec::new(),
    };
    let data = Data::new(vec![block]).unwrap();
    let settings = Settings {
        confidence: 0.999_999,
        ..Settings::default()
    };
    let fitted = |refused: std::ops::Range<f64>| {
        let model = |at: &[f64]| {
            let deviations = (at[0] - SLOPE) / DEVIATION;
            if refused.contains(&deviations) {
                return Err(format!("no convergence at {}", at[0]));
            }
            Ok((0..PLACES).map(|k| at[0] * along(k)).collect())
        };
        let parameters = [Parameter::new("slope", [0.0, 1.0])];
        let found = calibrate(&model, &parameters, &data, &settings).unwrap();
        assert!((found.estimates[0].value - SLOPE).abs() < 1e-6);
        assert!(found.refusals > 0);
        found.estimates[0].bounds
    };
    let low = SLOPE - 4.8916 * DEVIATION;
    let high = SLOPE + 4.8916 * DEVIATION;
    let is = |found: f64, expected: f64| (found - expected).abs() < 5e-3 * (expected - SLOPE).abs();
    // The walk steps over the end into the refusal: bisection finds the end between them.
    for from in [5.0, 5.1, 5.25, 8.0] {
        let found = fitted(from..f64::INFINITY);
        assert!(
            matches!(found, Bounds::Between(a, b) if is(a, low) && is(b, high)),
            "{from} {found:?}"
        );
    }
    let below = fitted(f64::NEG_INFINITY..-5.1);
    assert!(
        matches!(below, Bounds::Between(a, b) if is(a, low) && is(b, high)),
        "{below:?}"
    );
    // Where the model ends first, the data say nothing of that side.
    for from in [1.0, 3.0, 4.5] {
        let found = fitted(from..f64::INFINITY);
        assert!(
            matches!(found, Bounds::AtLeast(a) if is(a, low)),
            "{from} {found:?}"
        );
    }
    let both = {
        let model = |at: &[f64]| {
            if (at[0] - SLOPE).abs() > DEVIATION {
                return Err("no convergence");
            }
            Ok((0..PLACES).map(|k| at[0] * along(k)).collect())
        };
        let parameters = [Parameter::new("slope", [0.0, 1.0])];
        calibrate(&model, &parameters, &data, &settings).unwrap()
    };
    assert_eq!(both.estimates[0].bounds, Bounds::Nothing);
    // A gap of refusals inside of the interval is stepped over.
    let gap = fitted(1.2..1.8);
    assert!(
        matches!(gap, Bounds::Between(a, b) if is(a, low) && is(b, high)),
        "{gap:?}"
    );
}

#[test]
fn errors_in_common_make_deviations_wrong_by_the_root_of_the_largest_eigenvalue_at_most() {
    const SEEDS: u64 = 400;
    // Both blocks hold an error of their own and one in common, of equal variance: the correlation is 1/2.
    let spread = |signs: [f64; 2]| {
        let mut random = StdRng::seed_from_u64(5);
        let mut normal = || (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
        let (mut squares, mut stated) = (0.0, 0.0);
        for _ in 0..SEEDS {
            let common: Vec<f64> = (0..PLACES).map(|_| normal()).collect();
            let mut block = |sign: f64| Block {
                values: (0..PLACES)
                    .map(|k| 5.0 * sign * along(k) + normal() + common[k])
                    .collect(),
                noise: Noise::Independent(vec![2.0_f64.sqrt(); PLACES]),
                nuisance: Vec::new(),
            };
            let data = Data::new(signs.map(&mut block).into()).unwrap();
            let model = |at: &[f64]| {
                let along = |sign: f64| (0..PLACES).map(move |k| at[0] * sign * along(k));
                Ok::<Vec<f64>, String>(signs.into_iter().flat_map(along).collect())
            };
            let parameters = [Parameter::new("slope", [-20.0, 20.0])];
            let found = calibrate(&model, &parameters, &data, &Settings::default()).unwrap();
            squares += (found.estimates[0].value - 5.0).powi(2);
            stated = found.estimates[0].deviation.unwrap();
        }
        (squares / SEEDS as f64).sqrt() / stated
    };
    let (alike, opposite) = (spread([1.0, 1.0]), spread([1.0, -1.0]));
    println!("true over stated deviation: {alike:.3} alike, {opposite:.3} oppositely");
    // √(1 ± ρ); a spread of 400 deviates by 1/√800.
    let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 4.0 / 800.0_f64.sqrt();
    assert!(near(alike, 1.5_f64.sqrt()), "{alike}");
    assert!(near(opposite, 0.5_f64.sqrt()), "{opposite}");
}

#[test]
fn an_error_of_known_shape_adds_its_square_to_the_covariance() {
    let values = vec![1.0, -0.5, 2.0, 0.25];
    let shape = vec![0.3, 0.1, -0.7, 0.2];
    let predicted = [0.2, 0.1, 1.0, 0.0];
    let nuisance = vec![vec![1.0; 4]];
    let own = Block {
        values: values.clone(),
        noise: Noise::Independent(vec![0.5; 4]),
        nuisance: nuisance.clone(),
    };
    let entry = |k: usize| {
        let (i, j) = (k / 4, k % 4);
        shape[i] * shape[j] + if i == j { 0.25 } else { 0.0 }
    };
    let whole = Block {
        noise: Noise::Correlated((0..16).map(entry).collect()),
        ..own.clone()
    };
    let plain = Data::new(vec![own.clone()]).unwrap();
    assert_eq!(plain.amounts(&predicted), [None]);
    let data = plain
        .clone()
        .with_shapes(std::slice::from_ref(&shape))
        .unwrap();
    let expected = Data::new(vec![whole]).unwrap().chi_squared(&predicted);
    let found = data.chi_squared(&predicted);
    assert!((found - expected).abs() < 1e-12, "{found} {expected}");
    // The most likely amount is where χ² of the data and its own square are least together.
    let amount = data.amounts(&predicted)[0].unwrap();
    let at = |c: f64| {
        let moved: Vec<f64> = (0..4).map(|k| predicted[k] + c * shape[k]).collect();
        plain.chi_squared(&moved) + c * c
    };
    assert!((at(amount.value) - found).abs() < 1e-12);
    let beside = at(amount.value + amount.deviation) - found;
    assert!((beside - 1.0).abs() < 1e-12, "{beside}");
    let moved: Vec<f64> = (0..4)
        .map(|k| predicted[k] + amount.value * shape[k])
        .collect();
    for (a, b) in data.fitted(&predicted).iter().zip(plain.fitted(&moved)) {
        assert!((a - b).abs() < 1e-12);
    }
    // What nuisances take already is no error, and a shape is as long as its block.
    let taken = plain.clone().with_shapes(&[vec![0.0; 4]]).unwrap();
    assert_eq!(taken.amounts(&predicted), [None]);
    assert!(plain.with_shapes(&[vec![1.0; 3]]).is_err());
}

/// Each datum four times over says no more than once, if its inflation says so.
#[test]
fn repeated_data_with_their_inflation_say_what_single_ones_say() {
    const COPIES: usize = 4;
    let mut random = StdRng::seed_from_u64(5);
    let values: Vec<f64> = (0..PLACES)
        .map(|k| 0.4 + 0.6 * along(k) + 0.1 * (random.random::<f64>() - 0.5))
        .collect();
    let fitted = |copies: usize, inflation: f64| {
        let block = Block {
            values: values.repeat(copies),
            noise: Noise::Independent(vec![0.03; copies * PLACES]),
            nuisance: Vec::new(),
        };
        let line = |at: &[f64]| -> Result<Vec<f64>, String> {
            let once: Vec<f64> = (0..PLACES).map(|k| at[0] + at[1] * along(k)).collect();
            Ok(once.repeat(copies))
        };
        let settings = Settings {
            correlation: Correlation {
                inflation,
                squares: inflation,
            },
            ..Settings::default()
        };
        let parameters = ["offset", "slope"].map(|name| Parameter::new(name, [0.0, 1.0]));
        calibrate(
            &line,
            &parameters,
            &Data::new(vec![block]).unwrap(),
            &settings,
        )
        .unwrap()
    };
    let [once, often] = [fitted(1, 1.0), fitted(COPIES, COPIES as f64)];
    let near = |a: f64, b: f64| (a - b).abs() < 1e-3 * (a.abs() + b.abs());
    for (a, b) in once.estimates.iter().zip(&often.estimates) {
        assert!(near(a.value, b.value), "{a:?} {b:?}");
        assert!(near(a.deviation.unwrap(), b.deviation.unwrap()));
        let (Bounds::Between(low, high), Bounds::Between(other, end)) = (a.bounds, b.bounds) else {
            panic!("{a:?} {b:?}");
        };
        assert!(near(low, other) && near(high, end), "{a:?} {b:?}");
    }
    assert!(near(once.covariance[1], often.covariance[1]));
    for of in [Calibration::aic, Calibration::aicc, Calibration::bic] {
        assert!(near(of(&once), of(&often)), "{} {}", of(&once), of(&often));
    }
    assert!(near(often.effective_data(), PLACES as f64));
    // χ² itself is that of all data.
    assert!(near(COPIES as f64 * once.chi_squared, often.chi_squared));
}
