//! What every friction law must fulfil.
//!
//! ```text
//! 0 ≤ F_slip ≤ F_stick < ∞           F = 0 at p ≤ 0           (F_slip ≤ F_stick not if the law says that it strengthens)
//! ∂F/∂p, ∂F/∂|Δs|                    agree with central differences
//! F_stick                            does not depend on Δs
//! −λ_t Δs = F_slip |Δs| ≥ 0          along any history: friction takes work up
//! F(x) = F(x)                        always, whatever was asked before: a law has no memory of its own
//! F(x′) = F(x)                       at mirrored places x′, slip reversed, about each line for which the law claims symmetry
//! read(write(law)) = law             under its name, and unknown parameters are refused
//! ```
//!
//! A test of a law is one line, [`check`]. It runs the law over a [`Sample`], which is the same each time.
//!
//! The central difference `(F(x+h) − F(x−h))/2h` with `h = ε^(1/3) x` is off by `h² F‴/6` and by some `ε F/h` of rounding; for a
//! smooth law with `x³ F‴` of the order of F both are below `10⁻⁹ F/x`. A derivative must agree to `10⁻⁸ F/x + 10⁻⁶ |F′|`. A law
//! that varies on a scale much finer than its arguments is to be tested with a sample of that scale, and one with a kink with
//! a sample that avoids it.

mod sample;
mod symmetry;
mod violation;

use serde_json::Value;

use crate::history::{Direction, History, PointStatus};
use crate::law::{Bound, FrictionLaw};

use sample::Random;
pub use sample::{Sample, State};
pub use violation::{Breach, ContractViolation, Copied, Quantity};

/// Rounding allowed where two expressions of the same number are compared, relative: a few units in the last place.
const ROUNDING: f64 = 16.0 * f64::EPSILON;

/// Boxed, because a breach carries the arguments and answers of the law.
type Checked<T = ()> = Result<T, Box<Breach>>;

/// Tests `law` at `sample`.
///
/// # Errors
/// The first property that the law breaks, with the numbers.
pub fn check(law: &dyn FrictionLaw, sample: &Sample) -> Result<(), ContractViolation> {
    run(law, sample).map_err(|breach| ContractViolation {
        law: law.name(),
        breach,
    })
}

fn run(law: &dyn FrictionLaw, sample: &Sample) -> Checked {
    if let Some(fault) = sample.fault() {
        return Err(Box::new(Breach::UselessSample { fault }));
    }
    let answers = pure_answers(law, sample)?;
    for (at, bound) in &answers {
        check_values(law, at, bound)?;
        check_derivatives(law, at, bound)?;
    }
    check_without_pressure(law, sample)?;
    if law.is_linear() {
        check_linear(law, sample)?;
    }
    check_dissipation(law, sample)?;
    symmetry::check(law, sample)?;
    check_copy(law.box_clone().as_ref(), Copied::Cloned, law, &answers)?;
    check_copy(written_and_read(law)?.as_ref(), Copied::Read, law, &answers)?;
    check_unknown_parameter(law)
}

fn ask(law: &dyn FrictionLaw, at: &State) -> Bound {
    law.bound(at.pressure, at.slip_increment, &at.place, &at.past)
}

/// Equal down to the bits of NaN, so that a law that always answers NaN is not called impure.
fn same(first: &Bound, second: &Bound) -> bool {
    Quantity::ALL
        .iter()
        .all(|quantity| quantity.of(first).to_bits() == quantity.of(second).to_bits())
}

/// Answers over the whole sample, each asked again after all others, in the reverse order.
fn pure_answers(law: &dyn FrictionLaw, sample: &Sample) -> Checked<Vec<(State, Bound)>> {
    let answers: Vec<_> = sample.states().map(|at| (at, ask(law, &at))).collect();
    for (at, first) in answers.iter().rev() {
        check_same_answer(law, at, first)?;
    }
    Ok(answers)
}

fn check_same_answer(law: &dyn FrictionLaw, at: &State, first: &Bound) -> Checked {
    let second = ask(law, at);
    if same(first, &second) {
        Ok(())
    } else {
        Err(Box::new(Breach::NotPure {
            first: *first,
            second,
            at: *at,
        }))
    }
}

fn check_finite(at: &State, bound: &Bound) -> Checked {
    for quantity in Quantity::ALL {
        let value = quantity.of(bound);
        if !value.is_finite() {
            return Err(Box::new(Breach::NotFinite {
                quantity,
                value,
                at: *at,
            }));
        }
    }
    Ok(())
}

fn check_values(law: &dyn FrictionLaw, at: &State, bound: &Bound) -> Checked {
    check_finite(at, bound)?;
    for quantity in [Quantity::Stick, Quantity::Slip] {
        let value = quantity.of(bound);
        if value < 0.0 {
            return Err(Box::new(Breach::Negative {
                quantity,
                value,
                at: *at,
            }));
        }
    }
    let (stick, slip) = (bound.stick, bound.slip);
    if slip > stick * (1.0 + ROUNDING) && !law.strengthens() {
        return Err(Box::new(Breach::SlipAboveStick {
            slip,
            stick,
            at: *at,
        }));
    }
    let at_rest = State {
        slip_increment: 0.0,
        ..*at
    };
    let without = ask(law, &at_rest).stick;
    if stick != without {
        return Err(Box::new(Breach::StickDependsOnSlip {
            value: stick,
            without,
            at: *at,
        }));
    }
    Ok(())
}

fn check_derivatives(law: &dyn FrictionLaw, at: &State, bound: &Bound) -> Checked {
    let at_pressure = |pressure: f64| State { pressure, ..*at };
    let at_slip = |slip_increment: f64| State {
        slip_increment,
        ..*at
    };
    let stick = |at: State| ask(law, &at).stick;
    let slip = |at: State| ask(law, &at).slip;
    let pressure_step = Step::around(at.pressure);
    let mut comparisons = vec![
        (
            Quantity::StickDp,
            pressure_step,
            pressure_step.difference(|p| stick(at_pressure(p))),
            bound.stick,
        ),
        (
            Quantity::SlipDp,
            pressure_step,
            pressure_step.difference(|p| slip(at_pressure(p))),
            bound.slip,
        ),
    ];
    if at.slip_increment > 0.0 {
        let step = Step::around(at.slip_increment);
        comparisons.push((
            Quantity::SlipDs,
            step,
            step.difference(|s| slip(at_slip(s))),
            bound.slip,
        ));
    }
    for (quantity, step, difference, value) in comparisons {
        let stated = quantity.of(bound);
        let tolerance = 1e-8 * value / step.centre + 1e-6 * stated.abs();
        // Written so that a difference that is NaN fails.
        let agrees = (stated - difference).abs() <= tolerance;
        if !agrees {
            return Err(Box::new(Breach::WrongDerivative {
                quantity,
                stated,
                difference,
                tolerance,
                at: *at,
            }));
        }
    }
    Ok(())
}

/// Argument of a central difference.
#[derive(Clone, Copy)]
struct Step {
    centre: f64,
    half: f64,
}

impl Step {
    fn around(centre: f64) -> Self {
        Self {
            centre,
            half: f64::EPSILON.cbrt() * centre,
        }
    }

    fn difference(self, function: impl Fn(f64) -> f64) -> f64 {
        let (below, above) = (self.centre - self.half, self.centre + self.half);
        (function(above) - function(below)) / (above - below)
    }
}

fn check_without_pressure(law: &dyn FrictionLaw, sample: &Sample) -> Checked {
    for state in sample.states() {
        let at = State {
            pressure: 0.0,
            ..state
        };
        let none = ask(law, &at);
        check_finite(&at, &none)?;
        for quantity in [Quantity::Stick, Quantity::Slip, Quantity::SlipDs] {
            let value = quantity.of(&none);
            if value != 0.0 {
                return Err(Box::new(Breach::NotZeroWithoutPressure {
                    quantity,
                    value,
                    at,
                }));
            }
        }
        let at = State {
            pressure: -state.pressure,
            ..state
        };
        let negative = ask(law, &at);
        // By value: a negative zero is as good as a zero.
        if negative != none {
            return Err(Box::new(Breach::NegativePressureMatters {
                negative,
                none,
                at,
            }));
        }
    }
    Ok(())
}

fn check_linear(law: &dyn FrictionLaw, sample: &Sample) -> Checked {
    for (place, past) in sample.pasts() {
        let mut coefficient = None;
        for &pressure in &sample.pressures {
            for &slip_increment in &sample.slip_increments {
                let at = State {
                    pressure,
                    slip_increment,
                    place,
                    past,
                };
                let bound = ask(law, &at);
                let coefficient = *coefficient.get_or_insert(bound.stick_dp);
                let tolerance = ROUNDING * coefficient.abs();
                let proportional = |value: f64, derivative: f64| {
                    (value / pressure - coefficient).abs() <= tolerance
                        && (derivative - coefficient).abs() <= tolerance
                };
                if !proportional(bound.stick, bound.stick_dp)
                    || !proportional(bound.slip, bound.slip_dp)
                    || bound.slip_ds != 0.0
                {
                    return Err(Box::new(Breach::NotLinear {
                        bound,
                        coefficient,
                        at,
                    }));
                }
            }
        }
    }
    Ok(())
}

/// Random histories, at each place: a step may open, stick or slip the point, and is tried once in vain before it is accepted.
fn check_dissipation(law: &dyn FrictionLaw, sample: &Sample) -> Checked {
    let largest = |numbers: &[f64]| numbers.iter().copied().fold(0.0, f64::max);
    let (pressure_scale, slip_scale) =
        (largest(&sample.pressures), largest(&sample.slip_increments));
    let mut random = Random::new(sample.seed);
    for &place in &sample.places {
        let mut past = History::default();
        for step in 0..sample.steps {
            let pressure = pressure_scale * (1.2 * random.unit() - 0.2);
            let slip = slip_scale * (2.0 * random.unit() - 1.0);
            let status = match (pressure > 0.0, random.unit() < 0.3) {
                (false, _) => PointStatus::Open,
                (true, true) => PointStatus::Stick,
                (true, false) => PointStatus::Slip,
            };
            let slip = if status == PointStatus::Slip {
                slip
            } else {
                0.0
            };
            let at = State {
                pressure,
                slip_increment: slip.abs(),
                place,
                past,
            };
            let bound = ask(law, &at);
            let rejected = State {
                pressure: pressure_scale * random.unit(),
                slip_increment: slip_scale * random.unit(),
                ..at
            };
            ask(law, &rejected);
            check_same_answer(law, &at, &bound)?;
            let traction = -bound.slip * Direction::of(slip).sign();
            let dissipation = -traction * slip;
            if dissipation < 0.0 {
                return Err(Box::new(Breach::NegativeDissipation {
                    step,
                    dissipation,
                    at,
                }));
            }
            check_values(law, &at, &bound)?;
            past = past.commit(status, slip);
        }
    }
    Ok(())
}

fn check_copy(
    copy: &dyn FrictionLaw,
    copied: Copied,
    law: &dyn FrictionLaw,
    answers: &[(State, Bound)],
) -> Checked {
    for (at, original) in answers {
        let answer = ask(copy, at);
        if copy.name() != law.name() || !same(&answer, original) {
            return Err(Box::new(Breach::CopyDiffers {
                copied,
                name: copy.name(),
                original: *original,
                copy: answer,
                at: *at,
            }));
        }
    }
    Ok(())
}

fn not_serialisable(error: &serde_json::Error) -> Box<Breach> {
    Box::new(Breach::NotSerialisable {
        message: error.to_string(),
    })
}

/// Through a tree of values rather than text: what is tested is the law, not the digits of a format.
fn written_and_read(law: &dyn FrictionLaw) -> Checked<Box<dyn FrictionLaw>> {
    serde_json::to_value(law)
        .and_then(serde_json::from_value)
        .map_err(|error| not_serialisable(&error))
}

fn check_unknown_parameter(law: &dyn FrictionLaw) -> Checked {
    let mut written = serde_json::to_value(law).map_err(|error| not_serialisable(&error))?;
    // A law without a table of parameters, such as a unit struct, has no place for an unknown one.
    if let Some(Value::Object(parameters)) = written.get_mut(law.name()) {
        parameters.insert("no such parameter".to_owned(), Value::from(1.0));
        if serde_json::from_value::<Box<dyn FrictionLaw>>(written.clone()).is_ok() {
            return Err(Box::new(Breach::UnknownParameterAccepted {
                written: written.to_string(),
            }));
        }
    }
    Ok(())
}
