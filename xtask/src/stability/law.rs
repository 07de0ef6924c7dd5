//! Study 8: laws under which a step has several answers: traction that drops when slip begins, and traction that softens with slip.

mod enumerated;

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_contact::solver::InterfaceSolver;
use stickslip_friction::{FrictionLaw, SlipPath, SlipPower, StaticDynamic, Transition};

use super::context::{Context, Found};
use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::{CHAIN, methods};
use crate::publish::TaskError;
use crate::study::record::fields;

const DROP: &str = "drop at the onset of slip";
const LAGGED: &str = "drop from the next step on";
const SOFTENING: &str = "softening with slip";
const CASES: [&str; 3] = [DROP, LAGGED, SOFTENING];
const STATIC: f64 = 0.35;
const DYNAMIC: f64 = 0.15;
/// Values of each case.
const COLUMNS: usize = 11;

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let spacing = context.sized("9 deg", "4.5 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let columns: Vec<usize> = (0..COLUMNS).step_by(context.sized(5, 1)).collect();
    let mut rows = context.rows_of(&columns, |&column| {
        let mut rows = Vec::new();
        for case in CASES {
            let (value, law) = law(case, column)?;
            let problem = pin.problem_with(&law)?;
            let stages = Stages::follow(&problem, &pin.loads);
            let doubtful = doubtful(&stages);
            for mut row in stages.rows(case, value, &methods()) {
                if row.method == CHAIN && doubtful > 0 {
                    let first = format!("at most {doubtful} points may as well slip");
                    let notes = [first, row.note]
                        .into_iter()
                        .filter(|note| !note.is_empty());
                    row.note = notes.collect::<Vec<_>>().join("; ");
                    row.more
                        .extend(fields([("doubtful", (doubtful as i64).into())]));
                }
                rows.push(row);
            }
        }
        Ok(rows)
    })?;
    rows.sort_by_key(|row| CASES.iter().position(|case| *case == row.case));
    let mut shares = enumerated::Shares::default();
    for &column in &columns {
        for case in CASES {
            shares.add(&law(case, column)?.1)?;
        }
    }
    Ok(Found {
        more: vec![("-punch", shares.records())],
        ..Found::of("ratio_or_slip_mm", rows)
    })
}

/// Slip over which the softening law falls `[mm]`.
fn slip_scale(column: usize) -> f64 {
    10.0_f64.powi(1 - column as i32)
}

/// The law of a column, and the value that makes it.
fn law(case: &str, column: usize) -> Result<(f64, Arc<dyn FrictionLaw>), TaskError> {
    let share = (COLUMNS - 1 - column) as f64 / (COLUMNS - 1) as f64;
    let drop = |transition| StaticDynamic::new(STATIC, share * STATIC, transition);
    Ok(match case {
        DROP => (share, Arc::new(drop(Transition::Drop)?)),
        LAGGED => (share, Arc::new(drop(Transition::Lagged)?)),
        _ => {
            let scale = slip_scale(column);
            let law = SlipPower::new(STATIC, DYNAMIC, scale, 1.0, SlipPath::Current)?;
            (scale, Arc::new(law))
        }
    })
}

/// Largest number of points of a step that stick although slip would be admissible too.
fn doubtful(stages: &Stages) -> usize {
    let chain = Chain::default();
    let count = |stage: &super::history::Stage| {
        chain
            .solve(&stage.given.step())
            .map_or(0, |solution| solution.doubtful)
    };
    stages.list.iter().map(count).max().unwrap_or(0)
}
