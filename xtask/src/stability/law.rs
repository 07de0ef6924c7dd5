//! Study 8: laws under which a step has several answers: traction that drops when slip begins, and traction that softens with slip.

mod enumerated;

use std::sync::Arc;

use stickslip_contact::Chain;
use stickslip_contact::solver::InterfaceSolver;
use stickslip_friction::{FrictionLaw, SlipPath, SlipPower, StaticDynamic, Transition};

use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::{CHAIN, methods};
use super::outcome::Outcome;
use super::picture::{Legend, map, power};
use super::row::{Row, csv};
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "08-law",
    title: "Static and dynamic friction, softening",
    varied: "pin in a plate: μd/μs from 1 to 0 with μs = 0.35, the traction dropping at once or from the next step on; a coefficient \
             that falls from 0.35 to 0.15 over a slip from 10 mm down to 10⁻⁹ mm, of which the step in progress counts",
    expectation: "Points between the two bounds may stick or slip, so a step has many answers; each must meet all conditions, and the \
                  committed state decides between them. Softening faster than the bodies unload, a point jumps; the chain still \
                  finds an answer.",
    run,
};

const DROP: &str = "drop at the onset of slip";
const LAGGED: &str = "drop from the next step on";
const SOFTENING: &str = "softening with slip";
const STATIC: f64 = 0.35;
const DYNAMIC: f64 = 0.15;
/// Values of each case.
const COLUMNS: usize = 11;

fn run(context: &Context) -> Result<Findings, Trouble> {
    let spacing = context.sized("9 deg", "4.5 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let columns: Vec<usize> = (0..COLUMNS).step_by(context.sized(5, 1)).collect();
    let parts = context.rows_of(&columns, |&column| {
        let mut rows = Vec::new();
        for case in [DROP, LAGGED, SOFTENING] {
            let (value, law) = law(case, column)?;
            let problem = pin.problem_with(&law)?;
            let stages = Stages::follow(&problem, &pin.loads);
            let doubtful = doubtful(&stages);
            for mut row in stages.rows(case, value, &methods()) {
                if row.method == CHAIN && doubtful > 0 {
                    let rest = match row.note.as_str() {
                        "" => String::new(),
                        note => format!("; {note}"),
                    };
                    row.note = format!("at most {doubtful} points may as well slip{rest}");
                }
                rows.push(row);
            }
        }
        Ok(rows)
    })?;
    let mut rows = parts;
    rows.sort_by_key(|row| {
        [DROP, LAGGED, SOFTENING]
            .iter()
            .position(|case| *case == row.case)
    });
    let of_law = |softening: bool, varied: &str, label: &dyn Fn(f64) -> String| {
        let own: Vec<Row> = rows
            .iter()
            .filter(|row| (row.case == SOFTENING) == softening)
            .cloned()
            .collect();
        let legend = Legend {
            title: "Laws under which a step has several answers",
            subtitle: "Pin in a plate, 14 steps up to 1980 lbf and back; μs = 0.35.",
            varied,
            label,
            dividers: &[],
        };
        map(&own, &legend)
    };
    let drops = of_law(false, "dynamic over static friction μd/μs [1]", &|share| {
        format!("{share:.1}")
    })?;
    let slopes = of_law(
        true,
        "slip over which μ falls from 0.35 to 0.15 [mm]",
        &power,
    )?;
    let several = rows
        .iter()
        .filter(|row| row.method == CHAIN && row.note.contains("may as well slip"))
        .count();
    let unanswered: Vec<String> = rows
        .iter()
        .filter(|row| row.method == CHAIN && !row.outcome.is_answer())
        .map(|row| format!("{}, {}: {}", row.case, row.value, row.note))
        .collect();
    let others = rows
        .iter()
        .filter(|row| row.outcome == Outcome::Other)
        .count();
    let mut remarks = vec![format!(
        "In {several} of {} histories of the pin some points could as well slip; other methods end in another valid answer than the \
         default chain's {others} times. All solutions of so many points are not known.",
        rows.iter().filter(|row| row.method == CHAIN).count()
    )];
    remarks.push(on_a_punch(&columns)?);
    if !unanswered.is_empty() {
        remarks.push(format!(
            "The default chain ends without an answer in {} histories.",
            unanswered.len()
        ));
    }
    Ok(Findings {
        remarks,
        tables: vec![("", csv("ratio_or_slip_mm", &rows))],
        pictures: vec![
            (
                "-drop",
                drops,
                "Outcome of each method over the drop of friction".into(),
            ),
            (
                "-softening",
                slopes,
                "Outcome of each method over the slope of friction".into(),
            ),
        ],
        rows,
        ..Findings::default()
    })
}

/// What enumeration says of the laws of `columns` on a punch of few points.
fn on_a_punch(columns: &[usize]) -> Result<String, Trouble> {
    let mut shares = enumerated::Shares::default();
    for &column in columns {
        for case in [DROP, LAGGED, SOFTENING] {
            shares.add(&law(case, column)?.1)?;
        }
    }
    Ok(shares.text())
}

/// Slip over which the softening law falls `[mm]`.
fn slip_scale(column: usize) -> f64 {
    10.0_f64.powi(1 - column as i32)
}

/// The law of a column, and the value that makes it.
fn law(case: &str, column: usize) -> Result<(f64, Arc<dyn FrictionLaw>), Trouble> {
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
