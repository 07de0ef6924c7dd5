//! The contract holds for every law, and catches laws that break it.

use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};
use stickslip_friction::contract::{Breach, Copied, Quantity, Sample, check};
use stickslip_friction::{Bound, Direction, FrictionLaw, History, Mirror, Place};

const MU: f64 = 0.3;

fn sample() -> Sample {
    Sample::default_for(100.0, 1e-3)
}

#[test]
fn every_law_keeps_the_contract() {
    for law in crate::every_law() {
        check(law.as_ref(), &sample()).unwrap_or_else(|violation| panic!("{law:?}: {violation}"));
    }
}

/// Ways to get a law wrong.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
enum Fault {
    PressureDerivative,
    SlipDerivative,
    NegativeBound,
    NegativeAfterReversal,
    NotFinite,
    Cohesion,
    NegativePressure,
    Strengthening,
    StickSeesSlip,
    NotLinear,
    CountsCalls,
    RemembersLargestTrial,
    Clone,
    SeesUpperHalf,
    SeesDirection,
    SeesFibre,
}

#[derive(Debug, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Broken {
    fault: Fault,
    #[serde(skip)]
    memory: AtomicU64,
}

impl Broken {
    fn with(fault: Fault) -> Self {
        Self {
            fault,
            memory: AtomicU64::new(0),
        }
    }
}

#[typetag::serde(name = "broken")]
impl FrictionLaw for Broken {
    fn bound(&self, pressure: f64, slip_increment: f64, place: &Place, past: &History) -> Bound {
        let mut bound = Bound::proportional(MU, MU, pressure);
        match self.fault {
            // Wrong in the fifth digit: far beyond rounding, and easily overlooked.
            Fault::PressureDerivative => bound.slip_dp *= 1.0 + 1e-5,
            Fault::SlipDerivative => bound.slip_ds = -1e-3 * bound.slip,
            Fault::NegativeBound => bound = Bound::proportional(-MU, -MU, pressure),
            Fault::NegativeAfterReversal
                if past.direction() == Direction::Negative && past.slip_path() > 0.1 =>
            {
                bound = Bound::proportional(MU, -MU, pressure);
            }
            Fault::NotFinite => bound.stick_dp = f64::INFINITY,
            Fault::Cohesion => bound.stick += 1.0,
            Fault::NegativePressure if pressure < 0.0 => bound.stick_dp = 0.0,
            Fault::Strengthening => bound = Bound::proportional(MU, 1.1 * MU, pressure),
            Fault::StickSeesSlip => {
                bound.stick *= 1.0 + slip_increment;
                bound.stick_dp *= 1.0 + slip_increment;
            }
            Fault::NotLinear => bound.slip *= 1.0 - 1e-12,
            Fault::CountsCalls if self.memory.fetch_add(1, Ordering::Relaxed) > 1000 => {
                bound.stick *= 1.1;
            }
            Fault::SeesUpperHalf if place.position[1] > 0.0 => {
                bound = Bound::proportional(2.0 * MU, 2.0 * MU, pressure);
            }
            Fault::SeesDirection if past.direction() == Direction::Positive => {
                bound = Bound::proportional(2.0 * MU, 2.0 * MU, pressure);
            }
            // As of one ply along the 1-axis: symmetric about that axis alone, and the one across.
            Fault::SeesFibre => {
                let (sine, cosine) = place.material_angle.sin_cos();
                let along = place.tangent[0] * cosine + place.tangent[1] * sine;
                let coefficient = MU * (1.0 + along * along);
                bound = Bound::proportional(coefficient, coefficient, pressure);
            }
            Fault::RemembersLargestTrial => {
                let before = self
                    .memory
                    .fetch_max(slip_increment.to_bits(), Ordering::Relaxed);
                bound.slip /= 1.0 + f64::from_bits(before);
            }
            _ => {}
        }
        bound
    }

    fn is_linear(&self) -> bool {
        self.fault == Fault::NotLinear
    }

    fn is_symmetric(&self, _mirror: &Mirror) -> bool {
        matches!(
            self.fault,
            Fault::SeesUpperHalf | Fault::SeesDirection | Fault::SeesFibre
        )
    }

    fn box_clone(&self) -> Box<dyn FrictionLaw> {
        if self.fault == Fault::Clone {
            crate::coulomb(2.0 * MU)
        } else {
            Box::new(Self::with(self.fault))
        }
    }
}

fn breach(fault: Fault) -> Breach {
    let violation = check(&Broken::with(fault), &sample()).expect_err("a broken law passes");
    assert_eq!(violation.law, "broken");
    assert!(violation.to_string().contains("'broken'"), "{violation}");
    *violation.breach
}

#[test]
fn catches_wrong_derivatives() {
    match breach(Fault::PressureDerivative) {
        Breach::WrongDerivative {
            quantity: Quantity::SlipDp,
            stated,
            difference,
            ..
        } => {
            assert_eq!(stated, MU * (1.0 + 1e-5));
            // The tolerance of the contract, 1e-8 F/p + 1e-6 F', with F/p = F' = MU.
            assert!((difference - MU).abs() <= 1.01e-6 * MU);
        }
        other => panic!("{other}"),
    }
    assert!(matches!(
        breach(Fault::SlipDerivative),
        Breach::WrongDerivative {
            quantity: Quantity::SlipDs,
            ..
        }
    ));
}

#[test]
fn catches_negative_bounds_and_negative_dissipation() {
    match breach(Fault::NegativeBound) {
        Breach::Negative {
            quantity: Quantity::Stick,
            value,
            at,
        } => assert_eq!(value, -MU * at.pressure),
        other => panic!("{other}"),
    }
    // No history of the grid has slipped by 0.1; the random ones get there.
    match breach(Fault::NegativeAfterReversal) {
        Breach::NegativeDissipation {
            dissipation, at, ..
        } => {
            assert_eq!(dissipation, -MU * at.pressure * at.slip_increment);
            assert_eq!(at.past.direction(), Direction::Negative);
        }
        other => panic!("{other}"),
    }
}

#[test]
fn catches_infinite_numbers() {
    assert!(matches!(
        breach(Fault::NotFinite),
        Breach::NotFinite {
            quantity: Quantity::StickDp,
            value: f64::INFINITY,
            ..
        }
    ));
}

#[test]
fn catches_shear_without_pressure() {
    match breach(Fault::Cohesion) {
        Breach::NotZeroWithoutPressure {
            quantity: Quantity::Stick,
            value,
            at,
        } => assert_eq!((value, at.pressure), (1.0, 0.0)),
        other => panic!("{other}"),
    }
    match breach(Fault::NegativePressure) {
        Breach::NegativePressureMatters { negative, none, .. } => {
            assert_eq!((negative.stick_dp, none.stick_dp), (0.0, MU));
        }
        other => panic!("{other}"),
    }
}

#[test]
fn catches_strengthening_that_is_not_declared() {
    match breach(Fault::Strengthening) {
        Breach::SlipAboveStick { slip, stick, at } => {
            assert_eq!(slip, 1.1 * MU * at.pressure);
            assert_eq!(stick, MU * at.pressure);
        }
        other => panic!("{other}"),
    }
    match breach(Fault::StickSeesSlip) {
        Breach::StickDependsOnSlip { value, without, at } => {
            assert_eq!(value, without * (1.0 + at.slip_increment));
        }
        other => panic!("{other}"),
    }
}

#[test]
fn catches_a_law_that_is_not_linear() {
    match breach(Fault::NotLinear) {
        Breach::NotLinear {
            bound,
            coefficient,
            at,
        } => {
            assert_eq!(coefficient, MU);
            assert_eq!(bound.slip, MU * at.pressure * (1.0 - 1e-12));
        }
        other => panic!("{other}"),
    }
}

#[test]
fn catches_a_claim_of_symmetry_that_is_false() {
    for fault in [Fault::SeesUpperHalf, Fault::SeesDirection, Fault::SeesFibre] {
        match breach(fault) {
            Breach::NotSymmetric {
                own, mirrored, at, ..
            } => assert_ne!(own, mirrored, "{fault:?} at {at}"),
            other => panic!("{fault:?}: {other}"),
        }
    }
}

#[test]
fn catches_a_memory_of_its_own() {
    for fault in [Fault::CountsCalls, Fault::RemembersLargestTrial] {
        match breach(fault) {
            Breach::NotPure { first, second, .. } => assert_ne!(first, second),
            other => panic!("{fault:?}: {other}"),
        }
    }
}

#[test]
fn catches_a_copy_that_is_another_law() {
    match breach(Fault::Clone) {
        Breach::CopyDiffers { copied, name, .. } => {
            assert_eq!((copied, name), (Copied::Cloned, "coulomb"));
        }
        other => panic!("{other}"),
    }
}

/// A Coulomb law with hand-picked serde mistakes.
macro_rules! badly_written_law {
    ($law:ident, $name:literal) => {
        #[typetag::serde(name = $name)]
        impl FrictionLaw for $law {
            fn bound(&self, pressure: f64, _: f64, _: &Place, _: &History) -> Bound {
                Bound::proportional(self.mu, self.mu, pressure)
            }

            fn box_clone(&self) -> Box<dyn FrictionLaw> {
                Box::new(self.clone())
            }
        }
    };
}

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Forgets {
    #[serde(skip)]
    mu: f64,
}
badly_written_law!(Forgets, "forgets");

#[derive(Debug, Clone, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct WritesAnotherName {
    #[serde(rename(serialize = "friction"))]
    mu: f64,
}
badly_written_law!(WritesAnotherName, "writes_another_name");

#[derive(Debug, Clone, Serialize, Deserialize)]
struct AcceptsAnything {
    mu: f64,
}
badly_written_law!(AcceptsAnything, "accepts_anything");

#[test]
fn catches_laws_that_cannot_be_read_again() {
    let forgets = check(&Forgets { mu: MU }, &sample()).unwrap_err();
    match *forgets.breach {
        Breach::CopyDiffers {
            copied,
            original,
            copy,
            ..
        } => {
            assert_eq!(copied, Copied::Read);
            assert_eq!((original.stick_dp, copy.stick_dp), (MU, 0.0));
        }
        other => panic!("{other}"),
    }
    let renames = check(&WritesAnotherName { mu: MU }, &sample()).unwrap_err();
    match *renames.breach {
        Breach::NotSerialisable { message } => {
            assert!(message.contains("unknown field `friction`"), "{message}");
        }
        other => panic!("{other}"),
    }
}

#[test]
fn catches_unknown_parameters() {
    let violation = check(&AcceptsAnything { mu: MU }, &sample()).unwrap_err();
    assert!(
        matches!(*violation.breach, Breach::UnknownParameterAccepted { .. }),
        "{violation}"
    );
}

#[test]
fn a_sample_that_tests_nothing_is_refused() {
    let useless = |change: fn(&mut Sample)| {
        let mut sample = sample();
        change(&mut sample);
        check(crate::coulomb(MU).as_ref(), &sample)
            .unwrap_err()
            .breach
    };
    let changes: [fn(&mut Sample); 6] = [
        |sample| sample.pressures.clear(),
        |sample| sample.pressures.push(f64::NAN),
        |sample| sample.slip_increments = vec![0.0],
        |sample| sample.slip_increments.push(-1.0),
        |sample| sample.places.clear(),
        |sample| sample.histories.clear(),
    ];
    for change in changes {
        assert!(matches!(*useless(change), Breach::UselessSample { .. }));
    }
    for scale in [0.0, -1.0, f64::NAN, f64::INFINITY] {
        assert!(
            check(
                crate::coulomb(MU).as_ref(),
                &Sample::default_for(scale, 1.0)
            )
            .is_err()
        );
        assert!(
            check(
                crate::coulomb(MU).as_ref(),
                &Sample::default_for(1.0, scale)
            )
            .is_err()
        );
    }
}
