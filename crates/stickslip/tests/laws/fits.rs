//! What data of known truth say of laws.

use std::time::Instant;

use stickslip::experiment::laws::{Comparison, fit};
use stickslip_hybrid::calibrate::Settings;

use crate::common::{aluminium, candidate, law, measured, window};

fn show(found: &Comparison) {
    println!(
        "{} data, {:.2} ms per evaluation",
        found.data,
        1e3 * found.evaluation_seconds
    );
    for own in &found.fits {
        println!(
            "{}: χ²/dof {:.3} ({:+.1}), ΔAICc {:.1}, ΔBIC {:.1}, {} evaluations, {} refused {:?}, {:.1} s: {}",
            own.law.name,
            own.calibration.reduced(),
            own.calibration.excess(),
            own.distance,
            own.bic_distance,
            own.calibration.evaluations,
            own.calibration.refusals,
            own.calibration.first_refusal,
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

#[test]
fn explore() {
    let truth = aluminium(1.125);
    let model = aluminium(2.25);
    let places = window(20.0, 1.0, 0.2);
    let drop = candidate(
        "drop",
        r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#,
        &[("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])],
    );
    let coulomb = candidate(
        "coulomb",
        r#"{ "coulomb": { "mu": 0.3 } }"#,
        &[("mu", [0.0, 1.0])],
    );
    let text = r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#;
    let data = measured(&truth, law(text), &[3, 6, 9], &places, 0.25, 1);
    let start = Instant::now();
    let found = fit(
        &model,
        &[coulomb.clone(), drop.clone()],
        &data,
        &Settings::default(),
    )
    .unwrap();
    show(&found);
    println!("{:?}", start.elapsed());
    let none = measured(
        &truth,
        law(r#"{ "coulomb": { "mu": 0.0 } }"#),
        &[3, 6, 9],
        &places,
        0.25,
        1,
    );
    show(&fit(&model, &[coulomb], &none, &Settings::default()).unwrap());
}
