//! Names and parameters in files, and what is refused.

use serde::{Deserialize, Serialize};
use stickslip_friction::{
    Coulomb, FibreCoverage, FrictionError, FrictionLaw, History, Interval, Kernel, PlyFraction,
    PressurePower, SlipPath, SlipPower, StaticDynamic, Transition,
};

use crate::{coulomb, equal_plies, on_hole};

/// The part of a file that names a law.
#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Scene {
    friction: Box<dyn FrictionLaw>,
}

fn read(text: &str) -> Box<dyn FrictionLaw> {
    toml::from_str::<Scene>(text)
        .unwrap_or_else(|error| panic!("{text}\n{error}"))
        .friction
}

fn refusal(text: &str) -> String {
    match toml::from_str::<Scene>(text) {
        Ok(scene) => panic!("{text} is read as {scene:?}"),
        Err(error) => error.to_string(),
    }
}

#[test]
fn toml_names_a_law_by_its_tag() {
    let written: [(&str, Box<dyn FrictionLaw>); 7] = [
        ("friction.coulomb = { mu = 0.3 }", coulomb(0.3)),
        ("friction.coulomb = { mu = 0 }", coulomb(0.0)),
        (
            "friction.static_dynamic = { static = 0.35, dynamic = 0.3 }",
            Box::new(StaticDynamic::new(0.35, 0.3, Transition::Drop).unwrap()),
        ),
        (
            "[friction.static_dynamic]\nstatic = 0.3\ndynamic = 0.35\ntransition = \"lagged\"\nallow_strengthening = true",
            Box::new(StaticDynamic::allowing_strengthening(0.3, 0.35, Transition::Lagged).unwrap()),
        ),
        (
            "friction.slip_power = { static = 0.35, dynamic = 0.3, slip_scale = 0.001, exponent = 1 }",
            Box::new(SlipPower::new(0.35, 0.3, 0.001, 1.0, SlipPath::Committed).unwrap()),
        ),
        (
            "friction.slip_power = { static = 0.35, dynamic = 0.3, slip_scale = 2, exponent = 1, path = \"current\" }",
            Box::new(SlipPower::new(0.35, 0.3, 2.0, 1.0, SlipPath::Current).unwrap()),
        ),
        (
            "friction.pressure_power = { mu = 0.3, reference_pressure = 100.0, exponent = 0.8 }",
            Box::new(PressurePower::new(0.3, 100.0, 0.8).unwrap()),
        ),
    ];
    for (text, expected) in written {
        // The derived Debug shows every parameter, and a double without loss.
        assert_eq!(format!("{:?}", read(text)), format!("{expected:?}"));
    }
}

const COVERAGE: &str = r"
[friction.fibre_coverage]
plies = [{ angle = 0.0, fraction = 0.5 }, { angle = 1.0471975511965976, fraction = 0.5 }]
fibre_fraction = 0.6
kernel.swept = { kappa = 0.5 }
fibre.coulomb = { mu = 0.15 }
matrix.static_dynamic = { static = 0.4, dynamic = 0.35 }
";

#[test]
fn laws_nest_in_files() {
    let law = read(COVERAGE);
    let expected = FibreCoverage::new(
        equal_plies(&[0.0, 60.0]),
        0.6,
        Kernel::Swept { kappa: 0.5 },
        coulomb(0.15),
        Box::new(StaticDynamic::new(0.4, 0.35, Transition::Drop).unwrap()),
    )
    .unwrap();
    for theta in [0.0, 25.0, 90.0] {
        let ask = |law: &dyn FrictionLaw| law.bound(7.0, 0.1, &on_hole(theta), &History::default());
        assert_eq!(ask(law.as_ref()), ask(&expected));
    }
    let tangent = COVERAGE.replace("swept = { kappa = 0.5 }", "tangent = { width = 0.1 }");
    assert!(format!("{:?}", read(&tangent)).contains("Tangent { width: 0.1 }"));
}

#[test]
fn json_has_the_same_shape() {
    let text = serde_json::to_string(&coulomb(0.25)).unwrap();
    assert_eq!(text, r#"{"coulomb":{"mu":0.25}}"#);
    let law: Box<dyn FrictionLaw> =
        Box::new(StaticDynamic::new(0.5, 0.25, Transition::Drop).unwrap());
    assert_eq!(
        serde_json::to_string(&law).unwrap(),
        r#"{"static_dynamic":{"static":0.5,"dynamic":0.25,"transition":"drop","allow_strengthening":false}}"#
    );
    let read: Box<dyn FrictionLaw> = serde_json::from_str(r#"{"coulomb":{"mu":0.25}}"#).unwrap();
    assert_eq!(read.name(), "coulomb");
}

#[test]
fn toml_round_trip_of_every_law() {
    for friction in crate::every_law() {
        let shown = format!("{friction:?}");
        let text = toml::to_string(&Scene { friction }).unwrap();
        assert_eq!(format!("{:?}", read(&text)), shown, "{text}");
    }
}

#[test]
fn refusals_in_files_name_law_parameter_and_number() {
    let cases = [
        ("friction.coulomb = {}", "missing field `mu`"),
        (
            "friction.coulomb = { mu = 0.3, nu = 1 }",
            "unknown field `nu`",
        ),
        ("friction.colomb = { mu = 0.3 }", "colomb"),
        (
            "friction.coulomb = { mu = -0.1 }",
            "friction law 'coulomb': mu = -0.1 is outside [0, ∞)",
        ),
        (
            "friction.coulomb = { mu = nan }",
            "mu = NaN is outside [0, ∞)",
        ),
        (
            "friction.coulomb = { mu = inf }",
            "mu = inf is outside [0, ∞)",
        ),
        ("friction.coulomb = { mu = \"0.3\" }", "expected f64"),
        (
            "friction.static_dynamic = { static = 0.3 }",
            "missing field `dynamic`",
        ),
        (
            "friction.static_dynamic = { static = 0.3, dynamic = 0.35 }",
            "'static_dynamic': dynamic = 0.35 is greater than static = 0.3",
        ),
        (
            "friction.static_dynamic = { static = 0.3, dynamic = 0.2, transition = \"soon\" }",
            "unknown variant `soon`",
        ),
        (
            "friction.pressure_power = { mu = 0.3, reference_pressure = 1.0, exponent = 1.5 }",
            "exponent = 1.5 is outside (0, 1]",
        ),
    ];
    for (text, expected) in cases {
        let message = refusal(text);
        assert!(message.contains(expected), "{text}: {message}");
    }
    let spoilt = [
        (
            "fraction = 0.5 }]",
            "fraction = 0.4 }]",
            "the 2 plies sum to 0.9, not to 1",
        ),
        (
            "mu = 0.15",
            "mu = -0.15",
            "friction law 'coulomb': mu = -0.15 is outside [0, ∞)",
        ),
        (
            "kappa = 0.5",
            "kappa = 0.5, width = 1.0",
            "keys in table: width",
        ),
        ("angle = 0.0", "angel = 0.0", "unknown field `angel`"),
        (
            "fibre_fraction = 0.6",
            "fibre_fraction = 0.95",
            "fibre_fraction = 0.95 is outside [0, 0.90689968",
        ),
    ];
    for (right, wrong, expected) in spoilt {
        assert!(COVERAGE.contains(right));
        let message = refusal(&COVERAGE.replace(right, wrong));
        assert!(message.contains(expected), "{wrong}: {message}");
    }
}

fn outside(law: &'static str, parameter: &str, value: f64, allowed: Interval) -> FrictionError {
    FrictionError::OutOfRange {
        law,
        parameter: parameter.to_owned(),
        value,
        allowed,
    }
}

/// NaN is not equal to itself, so errors are compared as text.
fn assert_refused<T: std::fmt::Debug>(result: Result<T, FrictionError>, expected: &FrictionError) {
    assert_eq!(result.unwrap_err().to_string(), expected.to_string());
}

#[test]
fn constructors_refuse_what_is_no_coefficient() {
    const LEAST: Interval = Interval::NON_NEGATIVE;
    for bad in [-0.1, f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let static_dynamic =
            |fixed, moving| StaticDynamic::allowing_strengthening(fixed, moving, Transition::Drop);
        let slip_power = |fixed, moving| {
            SlipPower::allowing_strengthening(fixed, moving, 1.0, 1.0, SlipPath::Current)
        };
        assert_refused(Coulomb::new(bad), &outside("coulomb", "mu", bad, LEAST));
        assert_refused(
            static_dynamic(bad, 0.1),
            &outside("static_dynamic", "static", bad, LEAST),
        );
        assert_refused(
            static_dynamic(0.1, bad),
            &outside("static_dynamic", "dynamic", bad, LEAST),
        );
        assert_refused(
            slip_power(bad, 0.1),
            &outside("slip_power", "static", bad, LEAST),
        );
        assert_refused(
            slip_power(0.1, bad),
            &outside("slip_power", "dynamic", bad, LEAST),
        );
        assert_refused(
            PressurePower::new(bad, 1.0, 1.0),
            &outside("pressure_power", "mu", bad, LEAST),
        );
    }
}

#[test]
fn constructors_refuse_what_is_no_scale_or_exponent() {
    const POSITIVE: Interval = Interval::POSITIVE;
    for bad in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        let slip_power =
            |scale, exponent| SlipPower::new(0.3, 0.2, scale, exponent, SlipPath::Committed);
        assert_refused(
            slip_power(bad, 1.0),
            &outside("slip_power", "slip_scale", bad, POSITIVE),
        );
        assert_refused(
            slip_power(1.0, bad),
            &outside("slip_power", "exponent", bad, POSITIVE),
        );
        let pressure = PressurePower::new(0.3, bad, 1.0);
        assert_refused(
            pressure,
            &outside("pressure_power", "reference_pressure", bad, POSITIVE),
        );
        let unit = Interval::open_closed(0.0, 1.0);
        assert_refused(
            PressurePower::new(0.3, 1.0, bad),
            &outside("pressure_power", "exponent", bad, unit),
        );
    }
}

#[test]
fn strengthening_must_be_meant() {
    let refused = |law| FrictionError::Strengthening {
        law,
        static_coefficient: 0.3,
        dynamic_coefficient: 0.35,
    };
    assert_eq!(
        StaticDynamic::new(0.3, 0.35, Transition::Lagged).unwrap_err(),
        refused("static_dynamic")
    );
    assert_eq!(
        SlipPower::new(0.3, 0.35, 1.0, 1.0, SlipPath::Current).unwrap_err(),
        refused("slip_power")
    );
    assert!(StaticDynamic::new(0.3, 0.3, Transition::Drop).is_ok());
}

#[test]
fn lay_ups_that_are_none_are_refused() {
    let build = |plies, fibre_fraction, kernel| {
        FibreCoverage::new(plies, fibre_fraction, kernel, coulomb(0.1), coulomb(0.2))
    };
    let swept = Kernel::Swept { kappa: 0.5 };
    let unit = Interval::closed(0.0, 1.0);
    let refused =
        |parameter: &str, value, allowed| outside("fibre_coverage", parameter, value, allowed);
    let second_ply = |angle: f64, fraction: f64| {
        let mut plies = equal_plies(&[0.0, 90.0]);
        plies[1] = PlyFraction { angle, fraction };
        plies
    };
    assert_eq!(
        build(vec![], 0.6, swept).unwrap_err(),
        FrictionError::NoPlies {
            law: "fibre_coverage"
        }
    );
    assert_eq!(
        build(second_ply(0.0, 0.25), 0.6, swept).unwrap_err(),
        FrictionError::FractionSum {
            law: "fibre_coverage",
            plies: 2,
            sum: 0.75,
            tolerance: 1e-9
        }
    );
    for bad in [-0.5, 1.5, f64::NAN] {
        assert_refused(
            build(second_ply(0.0, bad), 0.6, swept),
            &refused("plies[1].fraction", bad, unit),
        );
    }
    for bad in [f64::NAN, f64::INFINITY] {
        assert_refused(
            build(second_ply(bad, 0.5), 0.6, swept),
            &refused("plies[1].angle", bad, Interval::FINITE),
        );
    }
    let packing = Interval::closed(0.0, std::f64::consts::FRAC_PI_2 / 3.0_f64.sqrt());
    for bad in [-0.1, 0.9069, f64::NAN] {
        assert_refused(
            build(second_ply(0.0, 0.5), bad, swept),
            &refused("fibre_fraction", bad, packing),
        );
    }
    for bad in [-0.1, f64::NAN, f64::INFINITY] {
        assert_refused(
            build(second_ply(0.0, 0.5), 0.6, Kernel::Swept { kappa: bad }),
            &refused("kernel.swept.kappa", bad, Interval::NON_NEGATIVE),
        );
        assert_refused(
            build(second_ply(0.0, 0.5), 0.6, Kernel::Tangent { width: bad }),
            &refused("kernel.tangent.width", bad, Interval::POSITIVE),
        );
    }
    // Within the tolerance of the sum, on both sides.
    assert!(build(second_ply(0.0, 0.5 + 9e-10), 0.6, swept).is_ok());
    assert!(build(second_ply(0.0, 0.5 - 1.1e-9), 0.6, swept).is_err());
}
