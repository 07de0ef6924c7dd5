//! Friction laws where one becomes another.

use stickslip::results::{Finding, Results};
use stickslip_tests::Draft;
use stickslip_tests::compare::{all_stresses, last_tractions, relative_difference};

/// The same numbers up to rounding; see the tests of symmetry.
const ROUNDING: f64 = 1e-8;

fn run(law: &str) -> Results {
    Draft::pin()
        .friction(law)
        .forces(0, &[600.0, 1400.0, 2600.0, 1500.0, 300.0])
        .run()
}

fn loading(law: &str) -> Results {
    Draft::pin()
        .friction(law)
        .forces(0, &[600.0, 1400.0, 2600.0])
        .run()
}

fn difference(first: &Results, second: &Results) -> f64 {
    relative_difference(all_stresses(first), all_stresses(second))
}

#[test]
fn equal_static_and_dynamic_coefficients_are_coulombs_law() {
    let coulomb = run("coulomb = { mu = 0.3 }");
    for law in [
        "static_dynamic = { static = 0.3, dynamic = 0.3 }",
        "static_dynamic = { static = 0.3, dynamic = 0.3, transition = \"lagged\" }",
        "slip_power = { static = 0.3, dynamic = 0.3, slip_scale = \"1 um\", exponent = 2.0 }",
        "slip_power = { static = 0.3, dynamic = 0.3, slip_scale = \"1 um\", exponent = 2.0, path = \"current\" }",
        "pressure_power = { mu = 0.3, reference_pressure = \"10 MPa\", exponent = 1.0 }",
    ] {
        let found = difference(&coulomb, &run(law));
        assert!(found < ROUNDING, "{law}: {found:e}");
    }
}

#[test]
fn fibre_coverage_of_equal_phases_is_the_law_of_both() {
    let mixed = |phase: &str, kernel: &str| {
        format!(
            "fibre_coverage = {{ plies = [{{ angle = \"0 deg\", fraction = 0.4 }}, {{ angle = \"45 deg\", fraction = 0.3 }}, \
             {{ angle = \"-45 deg\", fraction = 0.3 }}], fibre_fraction = 0.6, kernel = {{ {kernel} }}, fibre.{phase}, matrix.{phase} }}"
        )
    };
    for phase in [
        "coulomb = { mu = 0.3 }",
        "static_dynamic = { static = 0.3, dynamic = 0.2, transition = \"lagged\" }",
    ] {
        for kernel in [
            "swept = { kappa = 0.5 }",
            "tangent = { width = \"10 deg\" }",
        ] {
            let found = difference(&run(phase), &run(&mixed(phase, kernel)));
            assert!(found < ROUNDING, "{phase} {kernel}: {found:e}");
        }
    }
    // Two different phases lie between both.
    let bounds = ["coulomb = { mu = 0.1 }", "coulomb = { mu = 0.4 }"]
        .map(|law| loading(law).steps[2].edges[0].friction_force);
    let law = mixed("coulomb = { mu = 0.1 }", "swept = { kappa = 0.5 }").replace(
        "matrix.coulomb = { mu = 0.1 }",
        "matrix.coulomb = { mu = 0.4 }",
    );
    let between = loading(&law).steps[2].edges[0].friction_force;
    assert!(
        bounds[0] < between && between < bounds[1],
        "{bounds:?} {between}"
    );
}

/// The transition from μs to μd along the slip path, s₀ or m at their ends.
#[test]
fn limits_of_the_power_law_in_slip() {
    let power = |slip_scale: &str, exponent: f64, path: &str| {
        run(&format!(
            "slip_power = {{ static = 0.35, dynamic = 0.2, slip_scale = \"{slip_scale}\", exponent = {exponent}, path = \"{path}\" }}"
        ))
    };
    // Slips are microns: over a scale of a kilometre, or with no exponent to speak of, μ stays at μs.
    let never = run("coulomb = { mu = 0.35 }");
    for path in ["committed", "current"] {
        for limit in [power("1000 m", 1.0, path), power("1 um", 1e-10, path)] {
            let found = difference(&never, &limit);
            assert!(found < 1e-7, "{path}: {found:e}");
        }
    }
    // Over a scale of 1e-12 mm, or with a large exponent, μ is μd from the step after the first slip. Every point that slips
    // while the pull grows goes on to slip, as under the lagged law.
    let at_once = |slip_scale: &str, exponent: f64| {
        loading(&format!(
            "slip_power = {{ static = 0.35, dynamic = 0.2, slip_scale = \"{slip_scale}\", exponent = {exponent} }}"
        ))
    };
    let lagged =
        loading("static_dynamic = { static = 0.35, dynamic = 0.2, transition = \"lagged\" }");
    for limit in [at_once("1e-12 mm", 30.0), at_once("1e-6 mm", 1e4)] {
        let found = difference(&lagged, &limit);
        assert!(found < ROUNDING, "{found:e}");
    }
}

#[test]
fn a_drop_is_not_unique_and_says_so() {
    let law = |transition: &str| {
        format!("static_dynamic = {{ static = 0.4, dynamic = 0.2, transition = \"{transition}\" }}")
    };
    let (drop, lagged) = (loading(&law("drop")), loading(&law("lagged")));
    let found = relative_difference(last_tractions(&drop), last_tractions(&lagged));
    assert!(found > 0.02, "{found:e}");
    let doubtful: Vec<usize> = drop.steps.iter().map(|step| step.doubtful).collect();
    assert!(doubtful.iter().any(|&count| count > 0), "{doubtful:?}");
    let said = |results: &Results| {
        results.findings.iter().find_map(|finding| match finding {
            Finding::PointsInDoubt { points, .. } => Some(*points),
            Finding::SeveralSolutions { solutions, .. } => Some(*solutions),
            _ => None,
        })
    };
    assert_eq!(said(&drop), doubtful.iter().copied().max());
    assert!(
        said(&lagged).is_none() && lagged.steps.iter().all(|step| step.doubtful == 0),
        "{:?}",
        lagged.findings
    );
    // What slips under the drop carries μd p, within the step in which it begins to slip.
    for row in drop.steps[0].edges[0]
        .rows
        .iter()
        .filter(|row| row.status.slip_sign() != 0.0)
    {
        assert!(
            (row.shear.abs() - 0.2 * row.pressure).abs() <= 1e-8 * row.pressure.max(1.0),
            "{row:?}"
        );
    }
}
