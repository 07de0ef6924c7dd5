//! What data of known truth say of laws.

use stickslip::experiment::laws::{Comparison, fit};
use stickslip_hybrid::calibrate::Settings;

use crate::common::{aluminium, candidate, law, measured, window};

pub(crate) fn show(found: &Comparison) {
    println!(
        "{} data, {:.2} ms per evaluation",
        found.data,
        1e3 * found.evaluation_seconds
    );
    for own in &found.fits {
        println!(
            "{}: χ²/dof {:.3} ({:+.1}), ΔAICc {:.1}, ΔBIC {:.1}, {} evaluations, {} refused, {:.1} s: {}",
            own.law.name,
            own.calibration.reduced(),
            own.calibration.excess(),
            own.distance,
            own.bic_distance,
            own.calibration.evaluations,
            own.calibration.refusals,
            own.seconds,
            own.words()
        );
        for parameter in &own.calibration.estimates {
            println!(
                "    {} = {:.5} ± {:?} {:?}",
                parameter.name, parameter.value, parameter.deviation, parameter.bounds
            );
        }
    }
}

const DROP: &str = r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#;

#[test]
fn explore_drop() {
    let drop = candidate(
        "drop",
        DROP,
        &[("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])],
    );
    for (truth, models) in [(1.125, [1.6, 2.25, 3.0]), (2.25, [3.0, 4.5, 2.25])] {
        let truth = aluminium(truth);
        let places = window(20.0, 2.0, 0.2);
        let all: &[&[usize]] = &[&[3, 6], &[3, 6, 9]];
        for steps in all {
            let data = measured(&truth, law(DROP), steps, &places, 0.25, 1);
            for degrees in models {
                let start = std::time::Instant::now();
                let model = aluminium(degrees);
                let found = fit(
                    &model,
                    std::slice::from_ref(&drop),
                    &data,
                    &Settings::default(),
                )
                .unwrap();
                println!("model {degrees} {steps:?} {:?}", start.elapsed());
                show(&found);
            }
        }
    }
}

#[test]
fn explore_slip() {
    let truth = aluminium(2.25);
    let model = aluminium(4.5);
    let places = window(20.0, 2.0, 0.2);
    let slip = candidate(
        "slip",
        r#"{ "slip_power": { "static": 0.35, "dynamic": 0.25, "slip_scale": 0.002, "exponent": 1.0 } }"#,
        &[
            ("static", [0.0, 1.0]),
            ("dynamic", [0.0, 1.0]),
            ("slip_scale", [1e-4, 1e-1]),
            ("exponent", [0.2, 5.0]),
        ],
    );
    let slip3 = candidate(
        "slip3",
        r#"{ "slip_power": { "static": 0.35, "dynamic": 0.25, "slip_scale": 0.002, "exponent": 2.0 } }"#,
        &[
            ("static", [0.0, 1.0]),
            ("dynamic", [0.0, 1.0]),
            ("slip_scale", [1e-4, 1e-1]),
        ],
    );
    let drop = candidate(
        "drop",
        DROP,
        &[("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])],
    );
    for scale in ["0.002", "0.0005"] {
        let text = format!(
            r#"{{ "slip_power": {{ "static": 0.4, "dynamic": 0.2, "slip_scale": {scale}, "exponent": 2.0 }} }}"#
        );
        let data = measured(&truth, law(&text), &[2, 3, 6, 9], &places, 0.25, 1);
        let found = fit(
            &model,
            &[slip.clone(), slip3.clone(), drop.clone()],
            &data,
            &Settings::default(),
        )
        .unwrap();
        println!("scale {scale}");
        show(&found);
    }
}
