//! The contract over random parameters.

use proptest::prelude::*;
use stickslip_friction::contract::{Sample, check};
use stickslip_friction::fibre_coverage::MAXIMUM_FIBRE_FRACTION;
use stickslip_friction::{
    Coulomb, FibreCoverage, FrictionLaw, Kernel, Mirror, Place, PlyFraction, PressurePower,
    SlipPath, SlipPower, StaticDynamic, Transition,
};

use crate::on_hole;

type AnyLaw = BoxedStrategy<Box<dyn FrictionLaw>>;

/// Pressures and slips of the samples below; the laws' own scales are within two decades of them.
const PRESSURE: f64 = 7.0;
const SLIP: f64 = 0.02;

fn scale(around: f64) -> impl Strategy<Value = f64> {
    (-2.0..2.0_f64).prop_map(move |decades| around * 10.0_f64.powf(decades))
}

fn coefficients() -> impl Strategy<Value = (f64, f64)> {
    (0.0..1.5, 0.0..=1.0).prop_map(|(fixed, part)| (fixed, fixed * part))
}

fn coulomb() -> AnyLaw {
    (0.0..2.0)
        .prop_map(|mu| Box::new(Coulomb::new(mu).unwrap()) as _)
        .boxed()
}

fn static_dynamic() -> AnyLaw {
    (coefficients(), any::<bool>(), any::<bool>())
        .prop_map(|((larger, smaller), lagged, stronger)| {
            let transition = if lagged {
                Transition::Lagged
            } else {
                Transition::Drop
            };
            let law = if stronger {
                StaticDynamic::allowing_strengthening(smaller, larger, transition)
            } else {
                StaticDynamic::new(larger, smaller, transition)
            };
            Box::new(law.unwrap()) as _
        })
        .boxed()
}

fn slip_power() -> AnyLaw {
    (
        coefficients(),
        scale(SLIP),
        0.05..6.0,
        any::<bool>(),
        any::<bool>(),
    )
        .prop_map(
            |((larger, smaller), slip_scale, exponent, current, stronger)| {
                let path = if current {
                    SlipPath::Current
                } else {
                    SlipPath::Committed
                };
                let law = if stronger {
                    SlipPower::allowing_strengthening(smaller, larger, slip_scale, exponent, path)
                } else {
                    SlipPower::new(larger, smaller, slip_scale, exponent, path)
                };
                Box::new(law.unwrap()) as _
            },
        )
        .boxed()
}

fn pressure_power() -> AnyLaw {
    (0.0..2.0, scale(PRESSURE), 0.01..=1.0)
        .prop_map(|(mu, reference, exponent)| {
            Box::new(PressurePower::new(mu, reference, exponent).unwrap()) as _
        })
        .boxed()
}

fn any_simple_law() -> AnyLaw {
    prop_oneof![coulomb(), static_dynamic(), slip_power(), pressure_power()].boxed()
}

fn plies() -> impl Strategy<Value = Vec<PlyFraction>> {
    prop::collection::vec((-4.0..4.0, 0.01..1.0_f64), 1..6).prop_map(|parts| {
        let sum: f64 = parts.iter().map(|(_, part)| part).sum();
        let ply = |(angle, part)| PlyFraction {
            angle,
            fraction: part / sum,
        };
        parts.into_iter().map(ply).collect()
    })
}

/// Plies as many at an angle as at its reflection about a line, and the line.
fn balanced() -> impl Strategy<Value = (Vec<PlyFraction>, f64)> {
    (plies(), -3.0..3.0).prop_map(|(plies, line): (Vec<PlyFraction>, f64)| {
        let half = |ply: &PlyFraction| {
            [ply.angle, 2.0 * line - ply.angle].map(|angle| PlyFraction {
                angle,
                fraction: 0.5 * ply.fraction,
            })
        };
        (plies.iter().flat_map(half).collect(), line)
    })
}

fn kernel() -> impl Strategy<Value = Kernel> {
    prop_oneof![
        (0.0..10.0).prop_map(|kappa| Kernel::Swept { kappa }),
        (1e-3..2.0).prop_map(|width| Kernel::Tangent { width }),
    ]
}

fn fibre_coverage() -> impl Strategy<Value = FibreCoverage> {
    let parts = (
        plies(),
        0.0..=MAXIMUM_FIBRE_FRACTION,
        kernel(),
        any_simple_law(),
        any_simple_law(),
    );
    parts.prop_map(|(plies, fibre_fraction, kernel, fibre, matrix)| {
        FibreCoverage::new(plies, fibre_fraction, kernel, fibre, matrix).unwrap()
    })
}

fn keeps_the_contract(law: &dyn FrictionLaw) -> Result<(), TestCaseError> {
    let mut sample = Sample::default_for(PRESSURE, SLIP);
    sample.places = [0.0, 40.0, 205.0].map(on_hole).to_vec();
    check(law, &sample).map_err(|violation| TestCaseError::fail(violation.to_string()))
}

proptest! {
    #[test]
    fn simple_laws_keep_the_contract(law in any_simple_law()) {
        keeps_the_contract(law.as_ref())?;
    }

    #[test]
    fn mixed_laws_keep_the_contract(law in fibre_coverage()) {
        keeps_the_contract(&law)?;
    }

    #[test]
    fn balanced_plies_claim_symmetry_and_have_it((plies, line) in balanced(), kernel in kernel(), law in any_simple_law()) {
        let law = FibreCoverage::new(plies, 0.6, kernel, Box::new(Coulomb::new(0.2).unwrap()), law).unwrap();
        // The line lies on the x axis in a body that is turned back by it.
        let place = Place { material_angle: -line, ..on_hole(50.0) };
        let mirror = Mirror { line: 0.0, material_angle: -line };
        prop_assert!(law.is_symmetric(&mirror));
        let mut sample = Sample::default_for(PRESSURE, SLIP);
        sample.places = vec![place];
        check(&law, &sample).map_err(|violation| TestCaseError::fail(violation.to_string()))?;
    }

    #[test]
    fn coverage_is_a_fraction_and_even_in_the_tangent(law in fibre_coverage(), theta in 0.0..360.0) {
        let place = on_hole(theta);
        let covered = law.coverage(&place);
        prop_assert!((0.0..=1.0).contains(&covered));
        let opposite = stickslip_friction::Place { tangent: place.tangent.map(|x| -x), ..place };
        prop_assert_eq!(law.coverage(&opposite), covered);
    }

    #[test]
    fn any_number_builds_a_law_or_is_refused(mu in any::<f64>(), other in any::<f64>(), scale in any::<f64>(), m in any::<f64>()) {
        let coefficient = |x: f64| x.is_finite() && x >= 0.0;
        let positive = |x: f64| x.is_finite() && x > 0.0;
        let both = coefficient(mu) && coefficient(other);
        prop_assert_eq!(Coulomb::new(mu).is_ok(), coefficient(mu));
        prop_assert_eq!(StaticDynamic::new(mu, other, Transition::Drop).is_ok(), both && other <= mu);
        prop_assert_eq!(StaticDynamic::allowing_strengthening(mu, other, Transition::Drop).is_ok(), both);
        let slip_power = SlipPower::allowing_strengthening(mu, other, scale, m, SlipPath::Current);
        prop_assert_eq!(slip_power.is_ok(), both && positive(scale) && positive(m));
        let pressure_power = PressurePower::new(mu, scale, m);
        prop_assert_eq!(pressure_power.is_ok(), coefficient(mu) && positive(scale) && m > 0.0 && m <= 1.0);
    }
}
