//! Study 1: the coefficient of friction, through the bound up to which a step has one solution.

use stickslip_contact::uniqueness_bound;
use stickslip_laboratory::discrete::{self, Discrete};

use stickslip_report::svg::Svg;

use super::history::Stages;
use super::joint::{Joint, coulomb, set};
use super::methods::{CHAIN, Method, methods};
use super::outcome::{Outcome, judge};
use super::picture::{Legend, map};
use super::row::Row;
use super::{Context, Findings, Study, Trouble};

pub(super) const STUDY: Study = Study {
    name: "01-friction",
    title: "Coefficient of friction",
    varied: "μ from 0 to 3: one node with known answers, pushed and with its load removed; a flat punch; a pin in a plate, \
             loaded and unloaded",
    expectation: "Below the bound μ_c a step has one solution and every method may find it. From there on there can be several, \
                  and states that hold without any load: the answer must be one of them. A supported body always has one.",
    run,
};

const VARIED: &str = "coefficient of friction μ [1]";
const PUSHED: &str = "one node, pushed";
const WEDGED: &str = "one node, load removed";
const PUNCH: &str = "flat punch, pressed and pushed to and fro";
const PIN: &str = "pin in a plate, 14 steps and unloaded";
/// Stiffness [[k_t, k_c], [k_c, k_n]] and load (t, n) of the node that is pushed: μ_c = 1, and beyond it stick, slip and open
/// are all admissible.
const STIFFNESS: [[f64; 2]; 2] = [[1.0, -1.0], [-1.0, 2.0]];
const LOAD: [f64; 2] = [1.25, -1.0];
/// Contact force without load, over the largest of the history, from which a state counts as wedged.
const HELD: f64 = 1e-6;

fn run(context: &Context) -> Result<Findings, Trouble> {
    let count = context.sized(6, 30);
    let values: Vec<f64> = (0..=count)
        .map(|k| 3.0 * f64::from(k) / f64::from(count))
        .collect();
    let spacing = context.sized("18 deg", "9 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let nodes = context.sized(5, 13);
    let mut rows = context.rows_of(&values, |&mu| {
        let methods = methods();
        let mut rows = Vec::new();
        let node = discrete::one_node(mu, STIFFNESS, LOAD, 0.0, 0.0)?;
        rows.extend(alone(PUSHED, mu, &node, &methods));
        rows.extend(alone(WEDGED, mu, &discrete::wedged(mu)?, &methods));
        let punch = discrete::flat_punch(nodes, mu)?;
        let push = punch.multipliers[1];
        let loads: Vec<Vec<f64>> = [0.0, 1.0, -1.0]
            .map(|share| vec![1.0, share * push])
            .to_vec();
        let loads = [loads, vec![vec![0.0, 0.0]]].concat();
        rows.extend(followed(
            PUNCH,
            mu,
            &Stages::follow(&punch.problem, &loads),
            &methods,
        ));
        let problem = pin.problem_with(&coulomb(mu)?)?;
        let loads = [pin.loads.clone(), vec![vec![0.0; problem.load_cases()]]].concat();
        rows.extend(followed(
            PIN,
            mu,
            &Stages::follow(&problem, &loads),
            &methods,
        ));
        Ok(rows)
    })?;
    // Case by case, for the table.
    rows.sort_by_key(|row| {
        [PUSHED, WEDGED, PUNCH, PIN]
            .iter()
            .position(|case| *case == row.case)
    });
    let bounds = bounds(nodes, &pin)?;
    let name = |bound: f64, exact: bool| {
        let sign = if exact { "=" } else { "≈" };
        format!("one solution below μ_c {sign} {bound:.2}")
    };
    let dividers: Vec<(String, f64, String)> = bounds
        .iter()
        .map(|&(case, bound, exact)| (case.to_owned(), bound, name(bound, exact)))
        .collect();
    let picture = map(
        &rows,
        &Legend {
            title: "Which method can be trusted at which coefficient of friction",
            subtitle: "Left of the line a step has one solution; right of it there may be several. The worst step of a history counts.",
            varied: VARIED,
            label: &|mu| format!("{mu:.1}"),
            dividers: &dividers,
        },
    )?;
    let summary = summary(&rows, &bounds)?;
    Ok(Findings {
        remarks: remarks(&rows, &dividers),
        tables: vec![("", super::row::csv("mu", &rows))],
        pictures: vec![
            (
                "-summary",
                summary,
                "Worst outcome of each method in four problems over the coefficient of friction"
                    .into(),
            ),
            (
                "",
                picture,
                "Outcome of each method over the coefficient of friction".into(),
            ),
        ],
        rows,
        ..Findings::default()
    })
}

/// The worst outcome of each method in any of the problems.
fn summary(rows: &[Row], bounds: &[(&str, f64, bool)]) -> Result<Svg, Trouble> {
    const WORST: &str = "worst of the four problems";
    let mut worst: Vec<Row> = Vec::new();
    for row in rows {
        let same = |other: &&mut Row| other.method == row.method && other.value == row.value;
        match worst.iter_mut().find(same) {
            Some(other) => other.outcome = other.outcome.max(row.outcome),
            None => worst.push(Row {
                case: WORST.into(),
                ..row.clone()
            }),
        }
    }
    let least = bounds
        .iter()
        .map(|&(_, bound, _)| bound)
        .fold(f64::INFINITY, f64::min);
    Ok(map(
        &worst,
        &Legend {
            title: "Which solver can be trusted at which coefficient of friction",
            subtitle: "One node pushed, and with its load removed; a flat punch, pushed to and fro; a pin in a plate, loaded and unloaded.",
            varied: VARIED,
            label: &|mu| format!("{mu:.1}"),
            dividers: &[(
                WORST.to_owned(),
                least,
                "several solutions possible →".into(),
            )],
        },
    )?)
}

/// Bounds of uniqueness: exact for one node, estimated where all points touch or did touch.
fn bounds(nodes: usize, pin: &Joint) -> Result<Vec<(&'static str, f64, bool)>, Trouble> {
    let mut bounds = vec![
        (PUSHED, discrete::one_node_bound(STIFFNESS), true),
        (WEDGED, 1.5, true),
    ];
    let punch = discrete::flat_punch(nodes, 0.3)?;
    let pressed = Stages::follow(&punch.problem, &[vec![1.0, 0.0]]);
    let problem = pin.problem_with(&coulomb(0.3)?)?;
    let pulled = Stages::follow(&problem, &pin.loads[..4]);
    for (case, problem, stages) in [(PUNCH, &punch.problem, &pressed), (PIN, &problem, &pulled)] {
        let bound = stages
            .last()
            .and_then(|answer| uniqueness_bound(problem, &answer.status));
        bounds.extend(
            bound
                .filter(|bound| bound.is_finite())
                .map(|bound| (case, bound, false)),
        );
    }
    Ok(bounds)
}

/// One increment, against its known answers.
fn alone(case: &str, mu: f64, given: &Discrete, methods: &[Method]) -> Vec<Row> {
    let taken = methods
        .iter()
        .find(|method| method.is_chain())
        .and_then(|chain| chain.solver.solve(&given.step()).ok())
        .map(|solution| solution.trial);
    let held = case == WEDGED
        && taken
            .as_ref()
            .is_some_and(|trial| trial.forces.amax() > 0.0);
    methods
        .iter()
        .map(|method| {
            let mut row = judge(method, given, taken.as_ref());
            if held && method.is_chain() {
                row.note = "wedged: contact forces are left without load".into();
            }
            Row::of_steps(case, mu, given.coercive, &[row])
        })
        .collect()
}

/// A history that ends without load; what still presses there is noted with the default chain.
fn followed(case: &str, mu: f64, stages: &Stages, methods: &[Method]) -> Vec<Row> {
    let mut rows = stages.rows(case, mu, methods);
    let forces = |trial: &stickslip_contact::state::TrialState| trial.forces.amax();
    let largest = stages
        .list
        .iter()
        .filter_map(|stage| stage.answer.as_ref())
        .map(forces)
        .fold(0.0, f64::max);
    let unloaded = stages
        .list
        .last()
        .filter(|stage| stage.given.multipliers.iter().all(|&load| load == 0.0));
    let left = unloaded
        .and_then(|stage| stage.answer.as_ref())
        .map_or(0.0, forces);
    if left > HELD * largest {
        for row in rows.iter_mut().filter(|row| row.method == CHAIN) {
            row.note = format!(
                "wedged: {:.2} of the largest contact force is left without load",
                left / largest
            );
        }
    }
    rows
}

fn remarks(rows: &[Row], dividers: &[(String, f64, String)]) -> Vec<String> {
    let mut remarks = Vec::new();
    let wedged = |case: &str| {
        rows.iter()
            .filter(|row| row.case == case && row.note.contains("wedged"))
            .map(|row| row.value)
            .reduce(f64::min)
    };
    for case in [WEDGED, PUNCH, PIN] {
        remarks.push(match wedged(case) {
            Some(mu) => format!(
                "{}: the default chain's answer stays wedged from μ = {mu:.1} on.",
                capital(case)
            ),
            None => format!(
                "{}: the default chain's answer is free of force at every μ.",
                capital(case)
            ),
        });
    }
    let mut others: Vec<&str> = Vec::new();
    for row in rows
        .iter()
        .filter(|row| row.case == WEDGED && row.outcome == Outcome::Other)
    {
        if !others.contains(&row.method) {
            others.push(row.method);
        }
    }
    if !others.is_empty() {
        remarks.push(format!(
            "In the other state of that node end: {}.",
            others.join(", ")
        ));
    }
    let bound = |case: &str| {
        dividers
            .iter()
            .find(|(of, _, _)| of == case)
            .map_or(f64::INFINITY, |(_, bound, _)| *bound)
    };
    let first = |failing: &dyn Fn(&Row) -> bool| {
        rows.iter()
            .filter(|row| failing(row))
            .map(|row| row.value)
            .reduce(f64::min)
    };
    for method in ["status iteration", "Tresca fixed point"] {
        let failing =
            |row: &Row| row.method == method && row.case == PIN && !row.outcome.is_answer();
        if let Some(mu) = first(&failing) {
            remarks.push(format!(
                "On the pin the {method} first fails at μ = {mu:.1}."
            ));
        }
    }
    let several = |row: &Row| row.outcome == Outcome::Other && row.value < bound(&row.case);
    let below = rows.iter().filter(|row| several(row)).count();
    remarks.push(format!("Second solutions below the bound: {below}."));
    remarks
}

fn capital(text: &str) -> String {
    let mut characters = text.chars();
    characters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(characters).collect()
    })
}
