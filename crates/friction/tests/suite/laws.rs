//! The laws' formulas at numbers worked out by hand, and their state logic.

use stickslip_friction::{
    Bound, Coulomb, FrictionLaw, History, PointStatus, PressurePower, SlipPath, SlipPower,
    StaticDynamic, Transition,
};

use crate::on_hole;

/// A few roundings of a number of order 1.
const ROUNDING: f64 = 1e-14;

fn ask(law: &dyn FrictionLaw, pressure: f64, slip_increment: f64, past: &History) -> Bound {
    law.bound(pressure, slip_increment, &on_hole(20.0), past)
}

fn past(steps: &[(PointStatus, f64)]) -> History {
    steps
        .iter()
        .fold(History::default(), |past, &(status, slip)| {
            past.commit(status, slip)
        })
}

fn assert_close(value: f64, expected: f64) {
    assert!(
        (value - expected).abs() <= ROUNDING * expected.abs(),
        "{value}, not {expected}"
    );
}

#[test]
fn coulomb_is_proportional() {
    let law = Coulomb::new(0.25).unwrap();
    let expected = Bound {
        stick: 2.0,
        stick_dp: 0.25,
        slip: 2.0,
        slip_dp: 0.25,
        slip_ds: 0.0,
    };
    assert_eq!(ask(&law, 8.0, 0.0, &History::default()), expected);
    assert_eq!(
        ask(&law, 8.0, 3.0, &past(&[(PointStatus::Slip, 1.0)])),
        expected
    );
    assert!(law.is_linear());
    assert_eq!(law.name(), "coulomb");
}

/// Post & Reddy 1988, part II: Eq. 2.1 or 2.2 by the condition after the last load increment; a point that comes into contact,
/// also again, starts as a sticking one.
#[test]
fn static_bound_unless_the_point_slipped_in_the_last_step() {
    use PointStatus::{Open, Slip, Stick};
    let histories: [(&[(PointStatus, f64)], f64); 7] = [
        (&[], 0.5),
        (&[(Open, 0.0)], 0.5),
        (&[(Stick, 0.0)], 0.5),
        (&[(Slip, 1.0)], 0.25),
        (&[(Slip, 1.0), (Slip, -1.0)], 0.25),
        (&[(Slip, 1.0), (Stick, 0.0)], 0.5),
        (&[(Slip, 1.0), (Open, 0.0)], 0.5),
    ];
    let drop = StaticDynamic::new(0.5, 0.25, Transition::Drop).unwrap();
    let lagged = StaticDynamic::new(0.5, 0.25, Transition::Lagged).unwrap();
    for (steps, stick) in histories {
        let past = past(steps);
        for slip_increment in [0.0, 2.0] {
            assert_eq!(
                ask(&drop, 4.0, slip_increment, &past),
                Bound::proportional(stick, 0.25, 4.0),
                "{steps:?}"
            );
            assert_eq!(
                ask(&lagged, 4.0, slip_increment, &past),
                Bound::proportional(stick, stick, 4.0),
                "{steps:?}"
            );
        }
    }
}

#[test]
fn only_one_coefficient_per_step_is_linear() {
    let law = |fixed: f64, moving: f64, transition| {
        StaticDynamic::new(fixed, moving, transition).unwrap()
    };
    assert!(!law(0.5, 0.25, Transition::Drop).is_linear());
    assert!(law(0.5, 0.25, Transition::Lagged).is_linear());
    assert!(law(0.5, 0.5, Transition::Drop).is_linear());
    let power = |path| SlipPower::new(0.5, 0.25, 1.0, 1.0, path).unwrap();
    assert!(power(SlipPath::Committed).is_linear());
    assert!(!power(SlipPath::Current).is_linear());
    assert!(PressurePower::new(0.5, 1.0, 1.0).unwrap().is_linear());
    assert!(!PressurePower::new(0.5, 1.0, 0.5).unwrap().is_linear());
}

#[test]
fn strengthening_is_what_the_coefficients_say() {
    let law = |fixed, moving| {
        StaticDynamic::allowing_strengthening(fixed, moving, Transition::Drop).unwrap()
    };
    assert!(law(0.2, 0.3).strengthens());
    assert!(!law(0.3, 0.3).strengthens());
    assert!(!law(0.3, 0.2).strengthens());
    let power = SlipPower::allowing_strengthening(0.2, 0.3, 1.0, 1.0, SlipPath::Current).unwrap();
    assert!(power.strengthens());
    assert!(
        ask(&power, 1.0, 1.0, &History::default()).slip
            > ask(&power, 1.0, 1.0, &History::default()).stick
    );
}

/// μs = 0.5, μd = 0.1, s₀ = 2, m = 2: μ(0) = 0.5; μ(2) = 0.1 + 0.4/4 = 0.2, μ′(2) = −2·0.1/4 = −0.05; μ(6) = 0.1 + 0.4/16 = 0.125,
/// μ′(6) = −2·0.025/8 = −0.00625.
#[test]
fn slip_power_by_hand() {
    let slid = past(&[(PointStatus::Slip, 1.5), (PointStatus::Slip, -0.5)]);
    let committed = SlipPower::new(0.5, 0.1, 2.0, 2.0, SlipPath::Committed).unwrap();
    assert_eq!(
        ask(&committed, 10.0, 4.0, &History::default()),
        Bound::proportional(0.5, 0.5, 10.0)
    );
    let bound = ask(&committed, 10.0, 4.0, &slid);
    assert_close(bound.stick, 2.0);
    assert_eq!(
        (bound.slip, bound.slip_dp, bound.slip_ds),
        (bound.stick, bound.stick_dp, 0.0)
    );

    let current = SlipPower::new(0.5, 0.1, 2.0, 2.0, SlipPath::Current).unwrap();
    let bound = ask(&current, 10.0, 4.0, &slid);
    for (value, expected) in [
        (bound.stick, 2.0),
        (bound.stick_dp, 0.2),
        (bound.slip, 1.25),
        (bound.slip_dp, 0.125),
        (bound.slip_ds, -0.0625),
    ] {
        assert_close(value, expected);
    }
    // Slip starts from the stick bound: no drop at its onset.
    let onset = ask(&current, 10.0, 0.0, &slid);
    assert_eq!(onset.slip, onset.stick);
    assert_close(onset.slip_ds, -0.5);
}

#[test]
fn slip_power_far_away_is_dynamic() {
    let law = SlipPower::new(0.5, 0.1, 1e-300, 40.0, SlipPath::Current).unwrap();
    let bound = ask(&law, 1.0, 1e300, &past(&[(PointStatus::Slip, 1e300)]));
    assert_eq!((bound.stick, bound.slip, bound.slip_ds), (0.1, 0.1, 0.0));
}

/// μ₀ = 0.2, p₀ = 4, m = 1/2: F(1) = 0.8·(1/4)^½ = 0.4, F′(1) = ½·0.2·(1/4)^(−½) = 0.2; F(4) = 0.8, F(16) = 1.6.
#[test]
fn pressure_power_by_hand() {
    let law = PressurePower::new(0.2, 4.0, 0.5).unwrap();
    let value = |pressure: f64| ask(&law, pressure, 0.0, &History::default());
    assert_close(value(1.0).stick, 0.4);
    assert_close(value(1.0).stick_dp, 0.2);
    assert_close(value(4.0).slip, 0.8);
    assert_close(value(16.0).slip, 1.6);
    assert_eq!(value(16.0).slip_ds, 0.0);
}

/// At p → 0 the derivative grows to that at ε p₀ and no further: m μ₀ ε^(m−1) = 0.1/√ε for the law above.
#[test]
fn pressure_power_has_a_finite_derivative_without_pressure() {
    let law = PressurePower::new(0.2, 4.0, 0.5).unwrap();
    let largest = 0.1 / f64::EPSILON.sqrt();
    for pressure in [-3.0, 0.0, 1e-300, 1e-20, 4.0 * f64::EPSILON] {
        let bound = ask(&law, pressure, 0.0, &History::default());
        assert_close(bound.stick_dp, largest);
        assert_eq!(bound.stick > 0.0, pressure > 0.0);
    }
    assert!(ask(&law, 8.0 * f64::EPSILON, 0.0, &History::default()).stick_dp < largest);
    let steep = PressurePower::new(1.0, 1.0, f64::MIN_POSITIVE).unwrap();
    assert!(
        ask(&steep, 0.0, 0.0, &History::default())
            .stick_dp
            .is_finite()
    );
}

#[test]
fn no_pressure_no_shear_and_a_nan_shows() {
    for law in crate::every_law() {
        for pressure in [0.0, -0.0, -5.0, f64::NEG_INFINITY] {
            let bound = ask(
                law.as_ref(),
                pressure,
                1e-3,
                &past(&[(PointStatus::Slip, 1e-3)]),
            );
            assert_eq!(
                (bound.stick, bound.slip, bound.slip_ds),
                (0.0, 0.0, 0.0),
                "{law:?}"
            );
            let beyond = ask(
                law.as_ref(),
                1e-13,
                1e-3,
                &past(&[(PointStatus::Slip, 1e-3)]),
            );
            assert!(bound.stick_dp >= beyond.stick_dp && bound.slip_dp >= beyond.slip_dp);
        }
        assert!(
            ask(law.as_ref(), f64::NAN, 0.0, &History::default())
                .stick
                .is_nan(),
            "{law:?}"
        );
    }
}
