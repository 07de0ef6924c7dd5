//! Study 5: the stiffness of penalty springs, and what multipliers make of it.

mod stiffness_side;

use stickslip_contact::{AugmentedLagrangian, InterfaceSolver, Penalty};
use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Panels, Series, SeriesStyle};

use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::Method;
use super::outcome::{distance, regularised};
use super::picture::{Legend, map, power};
use super::row::{Row, csv};
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "05-penalty",
    title: "Penalty stiffness",
    varied: "stiffness of the contact springs from 10⁻³ to 10¹² times the body's own at a contact point, pin in a plate, friction 0.25",
    expectation: "The penalty's error falls in proportion to 1/stiffness until rounding takes over: late where springs add to the \
                  compliance of the points, soon where they add to a stiffness, as most codes have it. The augmented Lagrangian reaches \
                  the same answer from springs of any stiffness, in fewer updates the stiffer they are.",
    run,
};

const CASE: &str = "pin in a plate, 14 steps";
const PENALTY: &str = "penalty";
const AUGMENTED: &str = "augmented Lagrangian";
const STIFFNESS_SIDE: &str = "penalty added to the stiffness, statuses given";
const METHODS: [&str; 3] = [PENALTY, AUGMENTED, STIFFNESS_SIDE];

/// Width of a panel `[px]`, and its aspect.
const PANEL: f64 = 720.0;
const ASPECT: f64 = 0.5;

fn run(context: &Context) -> Result<Findings, Trouble> {
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
    let picture = map(
        &rows,
        &Legend {
            title: "Penalty stiffness from 10⁻³ to 10¹²",
            subtitle: "Pin in a plate, friction 0.25, 14 steps; the worst step counts.",
            varied: "stiffness of the springs over the body's own [1]",
            label: &power,
            dividers: &[],
        },
    )?;
    let steps = stages.list.len() as f64;
    let chart =
        |title: &str, label: &str, names: &[&'static str], value: &dyn Fn(&Row) -> Option<f64>| {
            let x = Axis::log("stiffness of the springs over the body's own [1]");
            let mut chart = LineChart::new(title, x, Axis::log(label)).size(PANEL, ASPECT);
            for &name in names {
                let own = rows.iter().filter(|row| row.method == name);
                let points = own
                    .filter_map(|row| Some([row.value, value(row).filter(|value| *value > 0.0)?]))
                    .collect();
                chart = chart.with(Series::new(name, points).style(SeriesStyle::Both));
            }
            chart
        };
    let panels = Panels::new(
        "Accuracy and work over the stiffness of the springs",
        1,
        vec![
            chart(
                "Error",
                "error of the contact forces over the largest [1]",
                &METHODS,
                &|row| row.error,
            ),
            chart(
                "Iterations",
                "solves and updates per load step [1]",
                &METHODS[..2],
                &|row| Some(row.iterations() as f64 / steps),
            ),
        ],
    );
    Ok(Findings {
        remarks: remarks(&rows, steps),
        tables: vec![("", csv("stiffness", &rows))],
        pictures: vec![
            (
                "",
                picture,
                "Outcome of penalty and augmented Lagrangian over the stiffness".into(),
            ),
            (
                "-error",
                panels.render()?,
                "Error and iterations over the stiffness of the springs".into(),
            ),
        ],
        rows,
        ..Findings::default()
    })
}

fn remarks(rows: &[Row], steps: f64) -> Vec<String> {
    let penalty = rows.iter().filter(|row| row.method == PENALTY);
    let best = penalty
        .filter_map(|row| Some((row.value, row.error?)))
        .min_by(|a, b| a.1.total_cmp(&b.1));
    let augmented = rows
        .iter()
        .filter(|row| row.method == AUGMENTED && row.outcome.is_answer());
    let fewest = augmented
        .clone()
        .map(|row| (row.value, row.iterations() as f64 / steps))
        .min_by(|a, b| a.1.total_cmp(&b.1));
    let mut remarks = Vec::new();
    if let Some((factor, error)) = best {
        remarks.push(format!(
            "With springs in the compliance the penalty is best at {}, where the contact forces are off by {error:.0e}: the condition of \
             the points' compliance does not suffer from stiff springs.",
            power(factor)
        ));
    }
    let stiff: Vec<(f64, f64)> = rows
        .iter()
        .filter(|row| row.method == STIFFNESS_SIDE)
        .filter_map(|row| Some((row.value, row.error?)))
        .collect();
    let best = stiff.iter().min_by(|a, b| a.1.total_cmp(&b.1));
    if let (Some((factor, error)), Some((stiffest, lost))) = (best, stiff.last()) {
        remarks.push(format!(
            "With springs added to the stiffness of the bodies it is best at {}, off by {error:.0e}; at {} it is off by {lost:.0e}, because the \
             spring's force is a large stiffness times a small difference of displacements.",
            power(*factor),
            power(*stiffest)
        ));
    }
    if let Some((factor, count)) = fewest {
        remarks.push(format!(
            "The augmented Lagrangian solves all steps at {} of {} stiffnesses, within its limit of updates, and needs fewest iterations at {}: {count:.0} per step.",
            augmented.count(),
            rows.iter().filter(|row| row.method == AUGMENTED).count(),
            power(factor)
        ));
    }
    remarks
}

/// The steps of `stages` with springs added to the stiffness of the bodies.
fn stiffness_side(pin: &Joint, stages: &Stages, factor: f64) -> Result<Row, Trouble> {
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
        case: CASE.into(),
        value: factor,
        method: STIFFNESS_SIDE,
        outcome: regularised(Some(error), error),
        solved: count,
        steps: stages.list.len(),
        error: Some(error),
        ..Row::default()
    })
}
