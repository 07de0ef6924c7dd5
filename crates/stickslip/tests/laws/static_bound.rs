//! How often the bound of static friction holds where the truth has one coefficient.
//!
//! `STICKSLIP_SEEDS=50 cargo test --release -p stickslip --test laws static_friction -- --nocapture` asks as many seeds of each case.

use std::path::Path;
use std::sync::Arc;

use stickslip::experiment::Experiment;
use stickslip::experiment::analysed::{Analysed, Workbench};
use stickslip::experiment::identified::{Identified, identify, ratio};
use stickslip::experiment::measured::Measured;
use stickslip::host::HOST;
use stickslip::scene::Format;
use stickslip_hybrid::identify::{Bounds, normal_quantile};

use crate::common::{aluminium, law, measured_fields, seeds, window};

/// Load steps at 520 lbf on the way up and at 535 lbf on the way down, from 0.
const STEPS: [usize; 2] = [2, 11];
const COEFFICIENTS: [f64; 2] = [0.18, 0.35];
/// Errors of places 0.25 mm apart, in fringes: what pictures leave after their band is cut out, and less.
const ERRORS: [f64; 2] = [0.004, 0.02];

const EXPERIMENT: &str = r#"
version = 1
[specimen]
material.isotropic = { young = "10400 ksi", poisson = 0.33 }
thickness = "0.06 in"
hole = { centre = ["0 mm", "0 mm"], radius = "0.375 in" }
[[states]]
name = "up"
table = { file = "up.csv", scale = "1 mm", y_axis = "up" }
[[states]]
name = "down"
table = { file = "down.csv", scale = "1 mm", y_axis = "up" }
[region]
sector = { angles = ["-8 deg", "108 deg"], outer = "12.5 mm", cells = [48, 12], growth = 2.0 }
smoothing = { order = 2, amount = AMOUNT }
[identify]
samples = 2
"#;

fn experiment(amount: f64) -> Experiment {
    let text = EXPERIMENT.replace("AMOUNT", &format!("{amount:?}"));
    let none: [&str; 0] = [];
    Experiment::from_text(
        &text,
        Format::Toml,
        "edge.toml",
        Path::new("."),
        &none,
        HOST,
    )
    .unwrap()
}

/// What the greatest single ratio inside of slip zones would claim, with as many parts of the doubt as there are places.
fn by_single_places(found: &Identified, analysed: &[Analysed]) -> Option<f64> {
    let Some(Bounds::Between(_, high)) = found.dynamic.as_ref().map(|fit| fit.bounds) else {
        return None;
    };
    let count: usize = found.zones.iter().map(|zone| zone.inside.len()).sum();
    let quantile = normal_quantile(1.0 - 0.05 / count.max(1) as f64);
    let places = found.zones.iter().flat_map(|zone| {
        let sign = if zone.positive { 1.0 } else { -1.0 };
        zone.inside.clone().map(move |place| {
            let (ratio, deviation) = ratio(&analysed[zone.state], place);
            sign * ratio - quantile * deviation
        })
    });
    let greatest = places.fold(f64::NEG_INFINITY, f64::max);
    (greatest > high).then_some(greatest)
}

#[test]
fn a_bound_of_static_friction_does_not_exceed_the_one_coefficient_of_the_truth() {
    let truth = aluminium(1.125);
    let mut places = window(12.6, 0.25, 0.1);
    places.retain(|[x, y]| *x > -4.0 && *y > -3.0 && x.hypot(*y) < 12.8);
    let experiment = experiment(10.0);
    let bench = Workbench::new(&experiment).unwrap();
    let [mut asked, mut wrong, mut single] = [0; 3];
    for (error, mu) in ERRORS
        .into_iter()
        .flat_map(|e| COEFFICIENTS.map(|mu| (e, mu)))
    {
        let text = format!(r#"{{ "coulomb": {{ "mu": {mu} }} }}"#);
        for seed in 1..=seeds(1) {
            let own = Arc::from(law(&text));
            let fields = measured_fields(&truth, own, &STEPS, &places, error, seed);
            let analysed: Vec<Analysed> = (fields.into_iter().enumerate())
                .map(|(state, field)| bench.stresses(&Measured::new(state, field)).unwrap())
                .collect();
            let found = identify(&experiment, &analysed).unwrap();
            let bound = found.static_bound().map(|grip| grip.at_least);
            let alone = by_single_places(&found, &analysed);
            println!(
                "μ {mu}, error {error}, seed {seed}: {:.4?} {bound:?}, single places {alone:.4?}, resolution {:.2}°",
                found.dynamic_bounds(),
                analysed[0].resolution.to_degrees()
            );
            asked += 1;
            wrong += usize::from(bound.is_some_and(|bound| bound > mu));
            single += usize::from(alone.is_some_and(|bound| bound > mu));
        }
    }
    println!("false bounds: {wrong} of {asked}; single places would make {single}");
    // 95 % of bounds hold; of few all.
    assert!(20 * wrong <= asked, "{wrong} of {asked}");
}
