//! Study 5: the stiffness of penalty springs, and what multipliers make of it.

use stickslip_contact::{AugmentedLagrangian, InterfaceSolver, Penalty};
use stickslip_report::axis::Axis;
use stickslip_report::chart::{LineChart, Panels, Series, SeriesStyle};

use super::history::Stages;
use super::joint::{Joint, set};
use super::methods::Method;
use super::picture::{Legend, map, power};
use super::row::{Row, csv};
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "05-penalty",
    title: "Penalty stiffness",
    varied: "stiffness of the contact springs from 10⁻³ to 10¹² times the body's own at a contact point, pin in a plate, friction 0.25",
    expectation: "The penalty's error falls in proportion to 1/stiffness until rounding takes over. The augmented Lagrangian \
                  reaches the same answer from springs of any stiffness, in fewer updates the stiffer they are.",
    run,
};

const PENALTY: &str = "penalty";
const AUGMENTED: &str = "augmented Lagrangian";

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
        Ok(stages.rows("pin in a plate, 14 steps", factor, &methods))
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
    let series = |value: &dyn Fn(&Row) -> Option<f64>| {
        [PENALTY, AUGMENTED].map(|name| {
            let own = rows.iter().filter(|row| row.method == name);
            let points = own
                .filter_map(|row| Some([row.value, value(row).filter(|value| *value > 0.0)?]))
                .collect();
            Series::new(name, points).style(SeriesStyle::Both)
        })
    };
    let chart = |title: &str, label: &str, series: [Series; 2]| {
        let [penalty, augmented] = series;
        let x = Axis::log("stiffness of the springs over the body's own [1]");
        LineChart::new(title, x, Axis::log(label))
            .with(penalty)
            .with(augmented)
    };
    let panels = Panels::new(
        "Accuracy and work over the stiffness of the springs",
        2,
        vec![
            chart(
                "Error",
                "error of the contact forces over the largest [1]",
                series(&|row| row.error),
            ),
            chart(
                "Iterations",
                "solves and updates per load step [1]",
                series(&|row| Some(row.iterations() as f64 / steps)),
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
            "The penalty is best at {}, where the contact forces are off by {error:.0e}: here springs add to the compliance of the \
             points, whose condition does not suffer from stiff ones, unlike that of a stiffness matrix to which springs are added.",
            power(factor)
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
