//! Study 5: the stiffness of penalty springs, and what multipliers make of it.

mod stiffness_side;

use stickslip_contact::{AugmentedLagrangian, InterfaceSolver, Penalty};

use super::context::{Context, Found};
use super::history::Stages;
use super::joint::{Joint, set};
use super::judge::distance;
use super::methods::Method;
use super::row::Row;
use crate::publish::TaskError;

const CASE: &str = "pin in a plate, 14 steps";
const PENALTY: &str = "penalty";
const AUGMENTED: &str = "augmented Lagrangian";
const STIFFNESS_SIDE: &str = "penalty added to the stiffness, statuses given";

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let exponents: Vec<i32> = (-3..=12).step_by(context.sized(3, 1)).collect();
    let spacing = context.sized("9 deg", "4.5 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let stages = Stages::follow(&pin.problem()?, &pin.loads);
    let rows = context.rows_of(&exponents, |&exponent| {
        let factor = 10.0_f64.powi(exponent);
        let springs = Penalty { factor };
        let multipliers = AugmentedLagrangian {
            factor,
            ..AugmentedLagrangian::default()
        };
        let method = |name, solver: Box<dyn InterfaceSolver>| Method { name, solver };
        let methods = [
            method(PENALTY, Box::new(springs)),
            method(AUGMENTED, Box::new(multipliers)),
        ];
        let mut rows = stages.rows(CASE, factor, &methods);
        rows.push(stiffness_side(&pin, &stages, factor)?);
        Ok(rows)
    })?;
    Ok(Found::of("stiffness", rows))
}

/// The steps of `stages` with springs added to the stiffness of the bodies.
fn stiffness_side(pin: &Joint, stages: &Stages, factor: f64) -> Result<Row, TaskError> {
    let mut error: f64 = 0.0;
    let mut count = 0;
    for stage in &stages.list {
        if let Some(answer) = &stage.answer {
            let forces = stiffness_side::forces(pin, &stage.given, answer, factor)?;
            let floor = stage.given.committed.forces.amax();
            let own = distance(&forces, &answer.forces, floor);
            error = if own.is_nan() { own } else { error.max(own) };
            count += 1;
        }
    }
    Ok(Row {
        solved: count,
        steps: stages.list.len(),
        ..Row::of_error(CASE, factor, STIFFNESS_SIDE, Some(error))
    })
}
