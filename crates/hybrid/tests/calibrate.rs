//! Fits whose answers are known in closed form, and intervals that cover the truth as often as they say.

use rand::rngs::StdRng;
use rand::{RngExt, SeedableRng};
use stickslip_hybrid::calibrate::{
    Block, CalibrateError, Calibration, Data, Noise, Parameter, Settings, calibrate,
};
use stickslip_hybrid::identify::Bounds;

/// A standard normal number.
fn normal(random: &mut StdRng) -> f64 {
    (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0
}

fn independent(values: Vec<f64>, deviation: f64) -> Block {
    Block {
        noise: Noise::Independent(vec![deviation; values.len()]),
        values,
        nuisance: Vec::new(),
    }
}

fn fit(
    model: impl Fn(&[f64]) -> Vec<f64> + Sync,
    parameters: &[Parameter],
    blocks: Vec<Block>,
) -> Calibration {
    let model = |at: &[f64]| Ok::<_, String>(model(at));
    let data = Data::new(blocks).unwrap();
    calibrate(&model, parameters, &data, &Settings::default()).unwrap()
}

const PLACES: usize = 30;

fn along(k: usize) -> f64 {
    k as f64 / (PLACES - 1) as f64
}

#[test]
fn a_straight_line_has_the_answer_of_the_normal_equations() {
    let mut random = StdRng::seed_from_u64(3);
    let deviation = 0.05;
    let values: Vec<f64> = (0..PLACES)
        .map(|k| 0.4 + 1.3 * along(k) + deviation * normal(&mut random))
        .collect();
    let line = |at: &[f64]| (0..PLACES).map(|k| at[0] + at[1] * along(k)).collect();
    let parameters = [
        Parameter::new("offset", [-2.0, 2.0]),
        Parameter::new("slope", [-3.0, 3.0]),
    ];
    let found = fit(
        line,
        &parameters,
        vec![independent(values.clone(), deviation)],
    );
    // The normal equations by Cramer's rule.
    let n = PLACES as f64;
    let [sx, sxx, sy, sxy] = (0..PLACES).fold([0.0; 4], |[sx, sxx, sy, sxy], k| {
        let (x, y) = (along(k), values[k]);
        [sx + x, sxx + x * x, sy + y, sxy + x * y]
    });
    let determinant = n * sxx - sx * sx;
    let [offset, slope] = [
        (sxx * sy - sx * sxy) / determinant,
        (n * sxy - sx * sy) / determinant,
    ];
    let exact = [offset, slope];
    let deviations = [
        deviation * (sxx / determinant).sqrt(),
        deviation * (n / determinant).sqrt(),
    ];
    for k in 0..2 {
        let own = &found.estimates[k];
        assert!(
            (own.value - exact[k]).abs() < 1e-4 * deviations[k],
            "{own:?}"
        );
        assert!((own.deviation.unwrap() / deviations[k] - 1.0).abs() < 1e-6);
        // χ² is a parabola: the profile's interval is that of the standard deviation.
        let Bounds::Between(low, high) = own.bounds else {
            panic!("{:?}", own.bounds)
        };
        let half = 1.959_964 * deviations[k];
        assert!((exact[k] - low - half).abs() < 0.01 * half, "{low} {half}");
        assert!(
            (high - exact[k] - half).abs() < 0.01 * half,
            "{high} {half}"
        );
    }
    let covariance = -deviation * deviation * sx / determinant;
    assert!((found.covariance[1] / covariance - 1.0).abs() < 1e-6);
    let chi: f64 = (0..PLACES)
        .map(|k| ((values[k] - offset - slope * along(k)) / deviation).powi(2))
        .sum();
    assert!((found.chi_squared - chi).abs() < 1e-6);
    assert_eq!(found.degrees(), PLACES - 2);
    assert!((found.aic() - chi - 4.0).abs() < 1e-6);
    assert!((found.aicc() - chi - 4.0 - 12.0 / 27.0).abs() < 1e-6);
    assert!((found.bic() - chi - 2.0 * n.ln()).abs() < 1e-6);
}

#[test]
fn correlated_errors_and_nuisances_give_the_answer_of_the_whole_problem() {
    // Errors x_i + x_{i−1}, and an offset as a nuisance: the fit must equal the one with the offset as a parameter.
    let mut random = StdRng::seed_from_u64(8);
    let x: Vec<f64> = (0..=PLACES).map(|_| 0.1 * normal(&mut random)).collect();
    let values: Vec<f64> = (0..PLACES)
        .map(|k| 5.0 + 1.3 * along(k) + x[k] + x[k + 1])
        .collect();
    let covariance: Vec<f64> = (0..PLACES * PLACES)
        .map(|at| match (at / PLACES).abs_diff(at % PLACES) {
            0 => 0.02,
            1 => 0.01,
            _ => 0.0,
        })
        .collect();
    let block = |nuisance: Vec<Vec<f64>>| Block {
        values: values.clone(),
        noise: Noise::Correlated(covariance.clone()),
        nuisance,
    };
    let slope = Parameter::new("slope", [-3.0, 3.0]);
    let ones = vec![1.0; PLACES];
    let projected = fit(
        |at| (0..PLACES).map(|k| at[0] * along(k)).collect(),
        std::slice::from_ref(&slope),
        // The same nuisance twice counts once.
        vec![block(vec![
            ones.clone(),
            ones.iter().map(|one| 3.0 * one).collect(),
        ])],
    );
    let whole = fit(
        |at| (0..PLACES).map(|k| at[0] * along(k) + at[1]).collect(),
        &[slope, Parameter::new("offset", [0.0, 10.0])],
        vec![block(Vec::new())],
    );
    let [own, other] = [&projected.estimates[0], &whole.estimates[0]];
    assert_eq!(
        (projected.nuisances, projected.degrees()),
        (1, whole.degrees())
    );
    let deviation = own.deviation.unwrap();
    assert!((own.value - other.value).abs() < 1e-4 * deviation);
    assert!((deviation / other.deviation.unwrap() - 1.0).abs() < 1e-6);
    assert!((projected.chi_squared - whole.chi_squared).abs() < 1e-6);
    assert!((projected.aicc() - whole.aicc()).abs() < 1e-6);
    for (a, b) in projected.fitted.iter().zip(&whole.fitted) {
        assert!((a - b).abs() < 1e-5, "{a} {b}");
    }
}

/// Decay measured with noise.
fn decay(seed: u64, deviation: f64) -> Calibration {
    let mut random = StdRng::seed_from_u64(seed);
    let curve = |at: &[f64]| -> Vec<f64> {
        (0..PLACES)
            .map(|k| at[0] * (-along(k) / at[1]).exp())
            .collect()
    };
    let values = curve(&[2.0, 0.3])
        .iter()
        .map(|own| own + deviation * normal(&mut random))
        .collect();
    let parameters = [
        Parameter::new("height", [0.0, 10.0]),
        Parameter::new("length", [0.01, 10.0]).logarithmic(),
    ];
    fit(curve, &parameters, vec![independent(values, deviation)])
}

#[test]
fn an_exponential_is_found_and_its_intervals_cover_the_truth_as_often_as_they_say() {
    let exact = decay(0, 1e-6);
    assert!((exact.estimates[0].value - 2.0).abs() < 1e-5);
    assert!((exact.estimates[1].value - 0.3).abs() < 1e-5);
    let seeds = 300;
    let (mut covered, mut evaluations, mut chi) = ([0; 2], 0, 0.0);
    for seed in 0..seeds {
        let found = decay(seed, 0.2);
        for (k, truth) in [2.0, 0.3].into_iter().enumerate() {
            covered[k] += usize::from(found.estimates[k].bounds.contain(truth));
        }
        evaluations += found.evaluations;
        chi += found.reduced() / seeds as f64;
    }
    let parts = covered.map(|own| own as f64 / seeds as f64);
    println!(
        "covered {parts:?}, χ²/dof {chi}, evaluations {}",
        evaluations / seeds as usize
    );
    for part in parts {
        assert!((0.92..=0.98).contains(&part), "{part}");
    }
    // Its standard deviation over the seeds is √(2/28/300) = 0.015.
    assert!((chi - 1.0).abs() < 0.05, "{chi}");
}

#[test]
fn a_parameter_without_influence_is_not_identifiable() {
    let values: Vec<f64> = (0..PLACES).map(|k| 2.0 * along(k)).collect();
    let parameters = [
        Parameter::new("slope", [0.0, 5.0]),
        Parameter::new("idle", [0.0, 1.0]),
    ];
    let found = fit(
        |at| (0..PLACES).map(|k| at[0] * along(k)).collect(),
        &parameters,
        vec![independent(values, 0.1)],
    );
    assert!((found.estimates[0].value - 2.0).abs() < 1e-6);
    assert!(matches!(found.estimates[0].bounds, Bounds::Between(..)));
    assert_eq!(found.estimates[1].bounds, Bounds::Nothing);
    assert_eq!(found.estimates[1].deviation, None);
    assert!(found.covariance.is_empty());
}

#[test]
fn an_interval_that_reaches_the_end_of_the_range_is_one_sided() {
    let flat = vec![independent(vec![0.0; PLACES], 0.1)];
    let slope = |at: &[f64]| -> Vec<f64> { (0..PLACES).map(|k| at[0] * along(k)).collect() };
    let none = fit(slope, &[Parameter::new("slope", [0.0, 5.0])], flat);
    // χ² = a² Σx²/σ², so that its increase is z² at a = zσ/√Σx².
    let norm = (0..PLACES).map(|k| along(k).powi(2)).sum::<f64>().sqrt();
    let end = 1.959_964 * 0.1 / norm;
    let Bounds::AtMost(high) = none.estimates[0].bounds else {
        panic!("{:?}", none.estimates[0].bounds)
    };
    assert!((high / end - 1.0).abs() < 0.01, "{high} {end}");
    // Saturated: beyond 1 everything looks alike.
    let saturated = |at: &[f64]| -> Vec<f64> { vec![at[0].min(1.0); PLACES] };
    let full = vec![independent(vec![1.0; PLACES], 0.5)];
    let found = fit(saturated, &[Parameter::new("level", [0.0, 5.0])], full);
    let Bounds::AtLeast(low) = found.estimates[0].bounds else {
        panic!("{:?}", found.estimates[0].bounds)
    };
    let expected = 1.0 - 1.959_964 * 0.5 / (PLACES as f64).sqrt();
    assert!((low - expected).abs() < 0.01, "{low} {expected}");
}

#[test]
fn data_that_no_model_explains_show_in_chi_squared_and_the_right_model_wins() {
    let mut random = StdRng::seed_from_u64(21);
    let values: Vec<f64> = (0..PLACES)
        .map(|k| 1.0 - 2.0 * along(k) + 3.0 * along(k).powi(2) + 0.05 * normal(&mut random))
        .collect();
    let polynomial = |at: &[f64]| -> Vec<f64> {
        let value = |k: usize| at.iter().rev().fold(0.0, |sum, a| sum * along(k) + a);
        (0..PLACES).map(value).collect()
    };
    let parameters: Vec<Parameter> = ["a", "b", "c", "d"]
        .map(|name| Parameter::new(name, [-5.0, 5.0]))
        .to_vec();
    let fits: Vec<Calibration> = (1..=4)
        .map(|count| {
            let block = independent(values.clone(), 0.05);
            fit(polynomial, &parameters[..count], vec![block])
        })
        .collect();
    assert!(fits[0].excess() > 10.0 && fits[1].excess() > 10.0);
    assert!(fits[2].excess() < 3.0 && fits[3].excess() < 3.0);
    let least = |value: &dyn Fn(&Calibration) -> f64| {
        (0..4).min_by(|&a, &b| value(&fits[a]).total_cmp(&value(&fits[b])))
    };
    assert_eq!(least(&Calibration::aicc), Some(2));
    assert_eq!(least(&Calibration::bic), Some(2));
}

#[test]
fn the_search_leaves_local_minima_and_goes_round_refused_places() {
    // sin(at x): many minima. The second parameter may not exceed the first.
    let values: Vec<f64> = (0..PLACES)
        .map(|k| (7.3 * along(k)).sin() + 0.4 * along(k))
        .collect();
    let model = |at: &[f64]| {
        if at[1] > at[0] {
            return Err("the second exceeds the first".to_owned());
        }
        Ok((0..PLACES)
            .map(|k| (at[0] * along(k)).sin() + at[1] * along(k))
            .collect())
    };
    let parameters = [
        Parameter::new("frequency", [0.0, 20.0]),
        Parameter::new("slope", [0.0, 20.0]),
    ];
    let data = Data::new(vec![independent(values, 0.01)]).unwrap();
    let found = calibrate(&model, &parameters, &data, &Settings::default()).unwrap();
    assert!((found.estimates[0].value - 7.3).abs() < 1e-4, "{found:?}");
    assert!((found.estimates[1].value - 0.4).abs() < 1e-4);
    assert!(found.refusals > 0 && found.refusals < found.evaluations);
    assert_eq!(
        found.first_refusal.as_deref(),
        Some("the second exceeds the first")
    );
}

#[test]
fn what_cannot_be_fitted_is_refused() {
    let data = || Data::new(vec![independent(vec![0.0; 4], 1.0)]).unwrap();
    let one = [Parameter::new("a", [0.0, 1.0])];
    let constant = |at: &[f64]| Ok::<_, String>(vec![at[0]; 4]);
    let run = |parameters: &[Parameter], settings: &Settings| {
        calibrate(&constant, parameters, &data(), settings).unwrap_err()
    };
    let standard = Settings::default();
    assert_eq!(run(&[], &standard), CalibrateError::Parameters(0));
    let reversed = run(&[Parameter::new("a", [1.0, 0.0])], &standard);
    let range = |range, logarithmic| CalibrateError::Range {
        name: "a".to_owned(),
        range,
        logarithmic,
    };
    assert_eq!(reversed, range([1.0, 0.0], false));
    let text = reversed.to_string();
    assert!(
        text.contains("from 1 to 0") && text.ends_with("it must increase"),
        "{text}"
    );
    let zero = run(&[Parameter::new("a", [0.0, 1.0]).logarithmic()], &standard);
    assert_eq!(zero, range([0.0, 1.0], true));
    assert!(zero.to_string().ends_with("be positive, being logarithmic"));
    let confident = Settings {
        confidence: 1.0,
        ..standard
    };
    assert_eq!(run(&one, &confident), CalibrateError::Confidence(1.0));
    let many = vec![one[0].clone(); 4];
    assert!(matches!(
        run(&many, &standard),
        CalibrateError::TooFew { data: 4, .. }
    ));
    let short = |_: &[f64]| Ok::<_, String>(vec![0.0; 3]);
    assert_eq!(
        calibrate(&short, &one, &data(), &standard),
        Err(CalibrateError::Prediction {
            expected: 4,
            found: 3
        })
    );
    let mute = |_: &[f64]| Err::<Vec<f64>, _>("no solution");
    assert_eq!(
        calibrate(&mute, &one, &data(), &standard),
        Err(CalibrateError::NoPrediction {
            tried: 21,
            first: "no solution".to_owned()
        })
    );
    let broken = |block: Block| Data::new(vec![block]).unwrap_err();
    let flat = broken(independent(vec![0.0; 2], 0.0));
    assert_eq!(flat.to_string(), "deviation 0 of block 0 is 0");
    let lost = broken(independent(vec![0.0, f64::NAN], 1.0));
    assert_eq!(lost.to_string(), "value 1 of block 0 is NaN");
    let singular = broken(Block {
        values: vec![0.0; 2],
        noise: Noise::Correlated(vec![1.0; 4]),
        nuisance: Vec::new(),
    });
    assert_eq!(singular, CalibrateError::Covariance { block: 0, row: 1 });
    let long = broken(Block {
        nuisance: vec![vec![1.0; 3]],
        ..independent(vec![0.0; 2], 1.0)
    });
    assert!(matches!(
        long,
        CalibrateError::Length {
            expected: 2,
            found: 3,
            ..
        }
    ));
}
