//! Facts about the coverage of the report's lay-up 0/60/−60, and limits of the mixture.
//!
//! Tolerance of comparisons between angles: the coverage is a mean of three kernels of order 1, each a few roundings from
//! exact, and the angles carry a relative ε; for the narrowest kernel, 5°, a change dψ changes it by at most dψ/ψ_w ≈ 11 dψ.
//! 1e-13 is some hundred times that.

use std::f64::consts::PI;

use stickslip_friction::fibre_coverage::{MAXIMUM_FIBRE_FRACTION, maximum_coverage};
use stickslip_friction::{
    Bound, FibreCoverage, FrictionLaw, History, Kernel, Mirror, Place, PointStatus,
};

use crate::{coulomb, coverage, equal_plies, on_hole};

const TOLERANCE: f64 = 1e-13;

fn kernels() -> Vec<Kernel> {
    let swept =
        [0.0, 0.1, 0.3, 0.36, 0.45, 0.5, 0.7, 0.72, 1.0, 5.0].map(|kappa| Kernel::Swept { kappa });
    let tangent = [5.0, 10.0, 20.0, 40.0].map(|width: f64| Kernel::Tangent {
        width: width.to_radians(),
    });
    [swept.as_slice(), tangent.as_slice()].concat()
}

fn report(kernel: Kernel) -> FibreCoverage {
    coverage(kernel, coulomb(0.15), coulomb(0.35))
}

/// θ in quarter degrees once around.
fn all_around() -> impl Iterator<Item = f64> {
    (-720..720).map(|quarter| 0.25 * f64::from(quarter))
}

fn assert_close(first: f64, second: f64, what: &str) {
    assert!(
        (first - second).abs() <= TOLERANCE,
        "{what}: {first} and {second}"
    );
}

#[test]
fn period_is_60_degrees() {
    for kernel in kernels() {
        let law = report(kernel);
        for theta in all_around() {
            let (here, next) = (
                law.coverage(&on_hole(theta)),
                law.coverage(&on_hole(theta + 60.0)),
            );
            assert_close(here, next, &format!("{kernel:?} at {theta}° and 60° on"));
        }
    }
}

#[test]
fn even_about_0_and_30_degrees() {
    for kernel in kernels() {
        let law = report(kernel);
        for theta in all_around() {
            for axis in [0.0, 30.0] {
                let left = law.coverage(&on_hole(axis - theta));
                let right = law.coverage(&on_hole(axis + theta));
                assert_close(
                    left,
                    right,
                    &format!("{kernel:?} about {axis}° at ±{theta}°"),
                );
            }
        }
    }
}

#[test]
fn largest_where_a_ply_is_tangent_and_smallest_between() {
    for kernel in kernels() {
        let law = report(kernel);
        for (tangent, between) in [(30.0, 0.0), (-30.0, 60.0), (90.0, -60.0), (-90.0, 120.0)] {
            let largest = law.coverage(&on_hole(tangent));
            let smallest = law.coverage(&on_hole(between));
            for theta in all_around() {
                let here = law.coverage(&on_hole(theta));
                assert!(
                    here <= largest + TOLERANCE,
                    "{kernel:?} at {theta}°: {here} > {largest}"
                );
                assert!(
                    here >= smallest - TOLERANCE,
                    "{kernel:?} at {theta}°: {here} < {smallest}"
                );
            }
        }
    }
}

#[test]
fn turning_the_body_turns_the_coverage() {
    for kernel in kernels() {
        let law = report(kernel);
        for theta in all_around().step_by(7) {
            let turned = Place {
                material_angle: 0.4,
                ..on_hole(theta + 0.4_f64.to_degrees())
            };
            let straight = on_hole(theta);
            let reversed = Place {
                tangent: straight.tangent.map(|component| -component),
                ..straight
            };
            let expected = law.coverage(&straight);
            assert_close(
                law.coverage(&turned),
                expected,
                &format!("{kernel:?} at {theta}°"),
            );
            assert_eq!(law.coverage(&reversed), expected);
        }
    }
}

/// Why the kernel is not a low power of the cosine: Σ sin²(θ − φ_k) = 3/2 and Σ sin⁴(θ − φ_k) = 9/8 over 0/60/−60, since
/// sin² = (1 − cos 2x)/2, sin⁴ = (3 − 4 cos 2x + cos 4x)/8 and the harmonics 2 and 4 of three equally spaced angles cancel.
/// The swept kernel, linear in |sin|, keeps the harmonics 6, 12, …
#[test]
fn squares_and_fourth_powers_cancel_and_the_kernel_does_not() {
    let sum = |theta: f64, power: i32| -> f64 {
        [0.0, 60.0, -60.0]
            .map(|ply: f64| (theta - ply).to_radians().sin().abs().powi(power))
            .iter()
            .sum()
    };
    for theta in all_around() {
        assert_close(sum(theta, 2), 1.5, "sum of squares");
        assert_close(sum(theta, 4), 1.125, "sum of fourth powers");
    }
    assert_close(sum(30.0, 1), 2.0, "sum of cosines, one ply tangent");
    assert_close(sum(0.0, 1), 3.0_f64.sqrt(), "sum of cosines, none tangent");
}

/// With the cap r = c_max/V_f − 1, reached at cos ψ = r/κ: below κ = r nothing is capped, and c(30°)/c(0°) =
/// (1 + 2κ/3)/(1 + κ/√3). From κ = 2r on, c(30°) = V_f (1 + r) and c(0°) = V_f (1 + 2r/3) whatever κ is, and the ratio is the
/// largest of all: 1.0958 at V_f = 0.6.
#[test]
fn swept_coverage_varies_by_at_most_9_6_percent() {
    let variation = |kappa: f64| {
        let law = report(Kernel::Swept { kappa });
        law.coverage(&on_hole(30.0)) / law.coverage(&on_hole(0.0)) - 1.0
    };
    let cap = maximum_coverage(0.6) / 0.6 - 1.0;
    let limit = (1.0 + cap) / (1.0 + 2.0 * cap / 3.0) - 1.0;
    assert!(limit < 0.096 && limit > 0.0955, "{limit}");
    for step in 0..400 {
        let kappa = 0.005 * f64::from(step);
        assert!(variation(kappa) <= limit + TOLERANCE, "κ = {kappa}");
    }
    let uncapped = |kappa: f64| (1.0 + 2.0 * kappa / 3.0) / (1.0 + kappa / 3.0_f64.sqrt()) - 1.0;
    assert_close(variation(0.2), uncapped(0.2), "below the cap");
    assert_close(variation(2.0 * cap), limit, "where the cap reaches ψ = 60°");
    assert_close(variation(3.0), limit, "far above");
    // Not monotonic: the cap first takes from the maximum.
    assert!(variation(0.4) < variation(0.355));
}

#[test]
fn extremes_of_packing() {
    assert_close(
        maximum_coverage(MAXIMUM_FIBRE_FRACTION),
        1.0,
        "densest packing",
    );
    assert_close(
        MAXIMUM_FIBRE_FRACTION,
        PI / (2.0 * 3.0_f64.sqrt()),
        "densest packing",
    );
    // c_max² = 2√3 V_f/π.
    assert_close(
        maximum_coverage(0.6).powi(2),
        1.2 * 3.0_f64.sqrt() / PI,
        "V_f = 0.6",
    );
    for kernel in kernels() {
        let full = |fibre_fraction: f64| {
            let plies = equal_plies(&[0.0, 45.0, -45.0, 90.0, 10.0, 20.0, 70.0]);
            FibreCoverage::new(plies, fibre_fraction, kernel, coulomb(0.0), coulomb(0.5)).unwrap()
        };
        for theta in all_around().step_by(5) {
            let place = on_hole(theta);
            assert_eq!(full(0.0).coverage(&place), 0.0, "no fibres");
            let dense = full(MAXIMUM_FIBRE_FRACTION);
            assert!((0.0..=1.0).contains(&dense.coverage(&place)));
            assert!(dense.bound(1.0, 0.0, &place, &History::default()).stick >= 0.0);
        }
    }
}

/// One unidirectional ply, by hand: at θ = 90° the fibre along x is tangent, at θ = 0° it ends normal to the edge, at θ = 30° it
/// meets the tangent at ψ = 60°.
#[test]
fn one_ply_by_hand() {
    let of = |kernel: Kernel, theta: f64| {
        let law = FibreCoverage::new(equal_plies(&[0.0]), 0.6, kernel, coulomb(0.1), coulomb(0.2))
            .unwrap();
        law.coverage(&on_hole(theta))
    };
    let swept = Kernel::Swept { kappa: 0.2 };
    assert_close(of(swept, 90.0), 0.72, "tangent");
    assert_close(of(swept, 0.0), 0.6, "normal");
    assert_close(of(swept, 30.0), 0.66, "at 60°");
    let tangent = Kernel::Tangent { width: PI / 3.0 };
    let maximum = maximum_coverage(0.6);
    assert_close(of(tangent, 90.0), maximum, "tangent");
    assert_close(
        of(tangent, 30.0),
        0.6 + (maximum - 0.6) * (-1.0_f64).exp(),
        "at 60°",
    );
    assert_close(
        of(tangent, 0.0),
        0.6 + (maximum - 0.6) * (-2.25_f64).exp(),
        "normal",
    );
}

#[test]
fn mixes_values_and_derivatives_of_both_laws() {
    let fibre: Box<dyn FrictionLaw> =
        serde_json::from_str(r#"{"slip_power":{"static":0.3,"dynamic":0.2,"slip_scale":0.5,"exponent":2,"path":"current"}}"#)
            .unwrap();
    let matrix: Box<dyn FrictionLaw> = serde_json::from_str(
        r#"{"pressure_power":{"mu":0.4,"reference_pressure":3,"exponent":0.7}}"#,
    )
    .unwrap();
    let law = coverage(Kernel::Swept { kappa: 0.3 }, fibre.clone(), matrix.clone());
    let (place, past) = (
        on_hole(17.0),
        History::default().commit(PointStatus::Slip, 0.1),
    );
    let ask = |law: &dyn FrictionLaw| law.bound(5.0, 0.2, &place, &past);
    let (own, other, covered) = (
        ask(fibre.as_ref()),
        ask(matrix.as_ref()),
        law.coverage(&place),
    );
    let mix = |first: f64, second: f64| covered * first + (1.0 - covered) * second;
    let expected = Bound {
        stick: mix(own.stick, other.stick),
        stick_dp: mix(own.stick_dp, other.stick_dp),
        slip: mix(own.slip, other.slip),
        slip_dp: mix(own.slip_dp, other.slip_dp),
        slip_ds: mix(own.slip_ds, other.slip_ds),
    };
    assert_eq!(ask(&law), expected);
    assert!(own.slip_ds < 0.0 && other.slip_ds == 0.0 && expected.slip_ds == covered * own.slip_ds);
}

#[test]
fn properties_of_the_parts_carry_over() {
    let swept = Kernel::Swept { kappa: 0.3 };
    let read = |text: &str| serde_json::from_str::<Box<dyn FrictionLaw>>(text).unwrap();
    let drop = || read(r#"{"static_dynamic":{"static":0.4,"dynamic":0.3}}"#);
    let stronger =
        || read(r#"{"static_dynamic":{"static":0.3,"dynamic":0.4,"allow_strengthening":true}}"#);
    assert!(coverage(swept, coulomb(0.1), coulomb(0.2)).is_linear());
    assert!(!coverage(swept, coulomb(0.1), drop()).is_linear());
    assert!(!coverage(swept, drop(), coulomb(0.1)).is_linear());
    assert!(!coverage(swept, coulomb(0.1), drop()).strengthens());
    assert!(coverage(swept, stronger(), drop()).strengthens());
    assert!(coverage(swept, drop(), stronger()).strengthens());
}

/// Axes at 0, 30, 45 and 90° of a body turned by `turned` degrees about which the law mirrors.
fn mirrors(angles: &[f64], turned: f64) -> Vec<f64> {
    let law = FibreCoverage::new(
        equal_plies(angles),
        0.6,
        Kernel::Tangent { width: 0.7 },
        coulomb(0.0),
        coulomb(0.8),
    )
    .unwrap();
    let about = |line: &f64| {
        law.is_symmetric(&Mirror {
            line: line.to_radians(),
            material_angle: turned.to_radians(),
        })
    };
    [0.0, 30.0, 45.0, 90.0].into_iter().filter(about).collect()
}

#[test]
fn balanced_plies_mirror_about_the_axis_that_balances_them() {
    let none: [f64; 0] = [];
    assert_eq!(mirrors(&[45.0], 0.0), [45.0]);
    assert_eq!(mirrors(&[45.0, -45.0], 0.0), [0.0, 45.0, 90.0]);
    assert_eq!(mirrors(&[0.0], 0.0), [0.0, 90.0]);
    assert_eq!(mirrors(&[0.0, 90.0], 0.0), [0.0, 45.0, 90.0]);
    assert_eq!(mirrors(&[0.0, 60.0, -60.0], 0.0), [0.0, 30.0, 90.0]);
    // 120° is −60°, and turns of the body count.
    assert_eq!(mirrors(&[60.0, 120.0], 0.0), [0.0, 90.0]);
    assert_eq!(mirrors(&[0.0, 60.0, -60.0], 30.0), [0.0, 30.0, 90.0]);
    assert_eq!(mirrors(&[-30.0, 30.0], 30.0), [30.0]);
    assert_eq!(mirrors(&[30.0, 30.0, -30.0], 0.0), none);
    assert_eq!(mirrors(&[0.0, 45.0], 0.0), none);
}

#[test]
fn a_mixture_mirrors_only_if_both_of_its_laws_do() {
    let one_ply = || -> Box<dyn FrictionLaw> {
        let kernel = Kernel::Swept { kappa: 0.5 };
        Box::new(
            FibreCoverage::new(
                equal_plies(&[45.0]),
                0.6,
                kernel,
                coulomb(0.1),
                coulomb(0.3),
            )
            .unwrap(),
        )
    };
    let mirror = Mirror {
        line: 0.0,
        material_angle: 0.0,
    };
    let swept = Kernel::Swept { kappa: 0.5 };
    assert!(report(swept).is_symmetric(&mirror));
    assert!(!coverage(swept, one_ply(), coulomb(0.2)).is_symmetric(&mirror));
    assert!(!coverage(swept, coulomb(0.2), one_ply()).is_symmetric(&mirror));
}
