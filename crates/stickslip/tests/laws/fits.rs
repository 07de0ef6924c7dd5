//! What data of known truth say of laws.

use stickslip::experiment::laws::{Candidate, Comparison, ContactModel, Fit, Verdict, fit};
use stickslip_hybrid::calibrate::Settings;
use stickslip_hybrid::identify::Bounds;

use crate::common::{aluminium, candidate, laminate, law, measured, window};

const DROP: &str = r#"{ "static_dynamic": { "static": 0.35, "dynamic": 0.25 } }"#;
/// A quarter of a fringe, evenly spread.
const ERROR: f64 = 0.25;

fn show(found: &Comparison) {
    println!(
        "{} data, {:.2} ms per evaluation",
        found.data,
        1e3 * found.evaluation_seconds
    );
    for own in &found.fits {
        println!(
            "{}: χ²/dof {:.3}, AICc {:+.1}, BIC {:+.1}, {} evaluations, {} refused: {}",
            own.law.name,
            own.calibration.reduced(),
            own.distance,
            own.bic_distance,
            own.calibration.evaluations,
            own.calibration.refusals,
            own.describe()
        );
        for parameter in &own.calibration.estimates {
            println!(
                "    {} = {:.5} {:?}",
                parameter.name, parameter.value, parameter.bounds
            );
        }
    }
}

fn fitted(
    model: &ContactModel,
    truth: &ContactModel,
    true_law: &str,
    laws: &[Candidate],
    steps: &[usize],
) -> Comparison {
    let data = measured(
        truth,
        law(true_law),
        steps,
        &window(20.0, 2.0, 0.2),
        ERROR,
        1,
    );
    let found = fit(model, laws, &data, &Settings::default()).unwrap();
    show(&found);
    found
}

fn bounds(fit: &Fit, parameter: &str) -> Bounds {
    let mut all = fit.calibration.estimates.iter();
    all.find(|own| own.name == parameter).unwrap().bounds
}

fn coulomb() -> Candidate {
    let text = r#"{ "coulomb": { "mu": 0.3 } }"#;
    candidate("Coulomb", text, &[("mu", [0.0, 1.0])])
}

fn drop_law() -> Candidate {
    let free = [("static", [0.0, 1.0]), ("dynamic", [0.0, 1.0])];
    candidate("static and dynamic", DROP, &free)
}

#[test]
fn the_dynamic_coefficient_is_found_and_the_static_one_has_an_upper_bound_alone() {
    let (truth, model) = (aluminium(2.25), aluminium(4.5));
    let found = fitted(&model, &truth, DROP, &[coulomb(), drop_law()], &[3, 6, 9]);
    let own = &found.fits[1];
    assert!(own.explains(), "{}", own.calibration.excess());
    assert!((own.calibration.values()[1] - 0.25).abs() < 0.002);
    // It cannot be below the dynamic one, which is the law's word and not that of the data.
    assert!(matches!(bounds(own, "static"), Bounds::AtMost(high) if (0.35..0.5).contains(&high)));
    assert!(own.describe().contains("static is bounded on one side"));
    // One coefficient explains the same data: the drop itself is not seen.
    assert!(found.fits[0].explains() && found.fits[0].distance < 4.0);
}

#[test]
fn a_full_transition_gives_all_parameters_of_the_slip_power_law_and_rules_the_others_out() {
    let (truth, model) = (aluminium(2.25), aluminium(4.5));
    let text = r#"{ "slip_power": { "static": 0.4, "dynamic": 0.2, "slip_scale": 0.002, "exponent": 2.0 } }"#;
    let transition = candidate(
        "slip power",
        text,
        &[
            ("static", [0.0, 1.0]),
            ("dynamic", [0.0, 1.0]),
            ("slip_scale", [1e-4, 1e-1]),
            ("exponent", [0.2, 8.0]),
        ],
    );
    let found = fitted(
        &model,
        &truth,
        text,
        &[coulomb(), drop_law(), transition],
        &[2, 3, 6, 9],
    );
    let own = &found.fits[2];
    assert_eq!((found.best, own.verdict), (2, Verdict::Preferred));
    assert!(own.explains());
    for (name, truth) in [
        ("static", 0.4),
        ("dynamic", 0.2),
        ("slip_scale", 0.002),
        ("exponent", 2.0),
    ] {
        let bounds = bounds(own, name);
        assert!(
            matches!(bounds, Bounds::Between(..)) && bounds.contain(truth),
            "{name} {bounds:?}"
        );
    }
    for other in &found.fits[..2] {
        assert_eq!(other.verdict, Verdict::RuledOut);
        assert!(!other.explains());
    }
}

#[test]
fn a_coefficient_that_falls_with_pressure_is_distinguished_from_a_constant_one() {
    let (truth, model) = (aluminium(2.25), aluminium(4.5));
    let text =
        r#"{ "pressure_power": { "mu": 0.3, "reference_pressure": 100.0, "exponent": 0.8 } }"#;
    let power = candidate(
        "pressure power",
        text,
        &[("mu", [0.0, 1.0]), ("exponent", [0.5, 1.0])],
    );
    let found = fitted(&model, &truth, text, &[coulomb(), power], &[3, 6, 9]);
    assert_eq!((found.best, found.fits[0].verdict), (1, Verdict::RuledOut));
    let own = &found.fits[1];
    assert!((own.calibration.values()[0] - 0.3).abs() < 0.005);
    assert!((own.calibration.values()[1] - 0.8).abs() < 0.02);
}

#[test]
fn fibre_coverage_on_a_quasi_isotropic_plate_is_distinguished_from_one_coefficient() {
    let (truth, model) = (laminate(2.25), laminate(4.5));
    let free = [
        ("fibre.coulomb.mu", [0.0, 0.5]),
        ("matrix.coulomb.mu", [0.0, 1.0]),
    ];
    let coverage = Candidate::of_law("coverage", model.own_law().as_ref(), &free).unwrap();
    let text = serde_json::to_string(truth.own_law().as_ref()).unwrap();
    let found = fitted(&model, &truth, &text, &[coulomb(), coverage], &[0, 1, 2]);
    assert_eq!((found.best, found.fits[0].verdict), (1, Verdict::RuledOut));
    let own = &found.fits[1];
    assert!(own.explains());
    for (name, truth) in [("fibre.coulomb.mu", 0.1), ("matrix.coulomb.mu", 0.4)] {
        let bounds = bounds(own, name);
        assert!(matches!(bounds, Bounds::Between(..)), "{bounds:?}");
        let value = own.calibration.values()[usize::from(name.starts_with("matrix"))];
        assert!((value - truth).abs() < 0.03, "{name} {value}");
    }
}

#[test]
fn without_friction_the_coefficient_is_at_most_something_small() {
    let (truth, model) = (aluminium(2.25), aluminium(4.5));
    let none = r#"{ "coulomb": { "mu": 0.0 } }"#;
    let found = fitted(&model, &truth, none, &[coulomb()], &[3, 6, 9]);
    assert!(matches!(bounds(&found.fits[0], "mu"), Bounds::AtMost(high) if high < 0.003));
}

#[test]
fn parameters_that_a_law_does_not_have_are_named() {
    let found = Candidate::of_law("drop", law(DROP).as_ref(), &[("statik", [0.0, 1.0])]);
    let (name, problem) = found.unwrap_err();
    assert_eq!(name, "statik");
    let words = problem.to_string();
    assert!(words.contains("statik"), "{words}");
    // Values that the law refuses are its own words.
    let refused = drop_law().law(&[0.1, 0.3]).unwrap_err();
    assert!(
        refused
            .to_string()
            .contains("dynamic = 0.3 is greater than static = 0.1")
    );
}
