//! Study 1: the coefficient of friction, through the estimated bound up to which a step has one solution.

mod starts;
mod text;

use std::sync::Mutex;

use stickslip_contact::{InterfaceProblem, uniqueness_bound};
use stickslip_laboratory::discrete::{self, Discrete, Known};
use stickslip_report::svg::Svg;

use super::history::Stages;
use super::joint::{Joint, coulomb, set};
use super::methods::{CHAIN, Method, methods};
use super::outcome::judge;
use super::picture::{Legend, map};
use super::row::Row;
use super::{Context, Findings, Study, Trouble};
use starts::stuck;
use text::remarks;

pub(super) const STUDY: Study = Study {
    name: "01-friction",
    title: "Coefficient of friction",
    varied: "μ from 0 to 3: one node with known answers, pushed and with its load removed; a flat punch; a pin in a plate, \
             loaded and unloaded; punch and pin with their load removed at once from a state in which all touching points stick",
    expectation: "Below the bound μ_c a step has one solution and every method may find it. From there on there can be several, \
                  and states that hold without any load: the answer must be one of them, the one nearest to the last state where \
                  all are known. A supported body always has one. The bound is exact for one node and an estimate for more.",
    run,
};

const VARIED: &str = "coefficient of friction μ [1]";
const PUSHED: &str = "one node, pushed";
const WEDGED: &str = "one node, load removed";
const STUCK_PUNCH: &str = "punch of 5 nodes, load removed from full stick";
const PUNCH: &str = "flat punch, pressed and pushed to and fro";
const PIN: &str = "pin in a plate, 14 steps and unloaded";
const STUCK_PIN: &str = "pin in a plate, load removed from full stick";
const CASES: [&str; 6] = [PUSHED, WEDGED, STUCK_PUNCH, PUNCH, PIN, STUCK_PIN];
/// Stiffness [[k_t, k_c], [k_c, k_n]] and load (t, n) of the node that is pushed: μ_c = 1, and beyond it stick, slip and open
/// are all admissible.
const STIFFNESS: [[f64; 2]; 2] = [[1.0, -1.0], [-1.0, 2.0]];
const LOAD: [f64; 2] = [1.25, -1.0];
/// Bound of the node whose load is removed.
const WEDGE_BOUND: f64 = 1.5;
/// Contact force without load, over the largest of the history, from which a state counts as wedged.
const HELD: f64 = 1e-6;
/// Nodes of the punch whose statuses are all enumerated.
const COARSE: usize = 5;

/// What is known of a case at one μ besides its rows.
#[derive(Clone, Copy, Debug, Default)]
struct Fact {
    /// Bound of uniqueness, least of all steps.
    bound: Option<f64>,
    /// Number of all solutions, where they are enumerated, and of those that hold without load.
    solutions: usize,
    wedged: usize,
}

/// A case at a μ.
type Entry = (&'static str, f64, Fact);

fn run(context: &Context) -> Result<Findings, Trouble> {
    let count = context.sized(6, 30);
    let values: Vec<f64> = (0..=count)
        .map(|k| 3.0 * f64::from(k) / f64::from(count))
        .collect();
    let spacing = context.sized("18 deg", "9 deg");
    let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
    let nodes = context.sized(5, 13);
    let stuck_pin = stuck(&|mu| pin.problem_with(&coulomb(mu)?), &pin.loads[..4])?;
    let punch = |mu: f64| -> Result<InterfaceProblem, Trouble> {
        Ok(discrete::flat_punch(COARSE, mu)?.problem)
    };
    let stuck_punch = stuck(&punch, &[vec![1.0, 0.0], vec![1.0, 1.0]])?;
    let facts = Mutex::new(Vec::<Entry>::new());
    let mut rows = context.rows_of(&values, |&mu| {
        let methods = methods();
        let mut found = Vec::new();
        let node = discrete::one_node(mu, STIFFNESS, LOAD, 0.0, 0.0)?;
        let bound = Some(discrete::one_node_bound(STIFFNESS));
        found.push((
            PUSHED,
            alone(PUSHED, mu, &node, &methods),
            facts_of(&node, bound),
        ));
        let node = discrete::wedged(mu)?;
        let known = facts_of(&node, Some(WEDGE_BOUND));
        found.push((WEDGED, alone(WEDGED, mu, &node, &methods), known));
        let given = enumerated(stuck_punch.without_load(punch(mu)?));
        let bound = uniqueness_bound(&given.problem, &given.committed.status);
        let rows = alone(STUCK_PUNCH, mu, &given, &methods);
        found.push((STUCK_PUNCH, rows, facts_of(&given, bound)));
        let punch = discrete::flat_punch(nodes, mu)?;
        let push = punch.multipliers[1];
        let loads: Vec<Vec<f64>> = [0.0, 1.0, -1.0]
            .map(|share| vec![1.0, share * push])
            .to_vec();
        let loads = [loads, vec![vec![0.0, 0.0]]].concat();
        found.push(history(
            PUNCH,
            mu,
            &Stages::follow(&punch.problem, &loads),
            &methods,
        ));
        let problem = pin.problem_with(&coulomb(mu)?)?;
        let loads = [pin.loads.clone(), vec![vec![0.0; problem.load_cases()]]].concat();
        found.push(history(
            PIN,
            mu,
            &Stages::follow(&problem, &loads),
            &methods,
        ));
        let given = stuck_pin.without_load(problem);
        let bound = uniqueness_bound(&given.problem, &given.committed.status);
        let rows = alone(STUCK_PIN, mu, &given, &methods);
        found.push((STUCK_PIN, rows, facts_of(&given, bound)));
        let mut facts = facts.lock().map_err(|_| "a problem panicked")?;
        facts.extend(found.iter().map(|(case, _, known)| (*case, mu, *known)));
        Ok(found.into_iter().flat_map(|(_, rows, _)| rows).collect())
    })?;
    let facts = facts.into_inner().map_err(|_| "a problem panicked")?;
    // Case by case, for the table.
    rows.sort_by_key(|row| CASES.iter().position(|case| *case == row.case));
    findings(rows, &facts)
}

fn findings(rows: Vec<Row>, facts: &[Entry]) -> Result<Findings, Trouble> {
    let dividers = dividers(facts);
    let picture = map(
        &rows,
        &Legend {
            title: "Which method can be trusted at which coefficient of friction",
            subtitle: "Left of the line a step has one solution (exact for one node, an estimate elsewhere); right of it there may be several. The worst step of a history counts.",
            varied: VARIED,
            label: &|mu| format!("{mu:.1}"),
            dividers: &dividers,
        },
    )?;
    let summary = summary(&rows, &dividers)?;
    Ok(Findings {
        remarks: remarks(&rows, facts, &dividers),
        tables: vec![("", super::row::csv("mu", &rows))],
        pictures: vec![
            (
                "-summary",
                summary,
                "Worst outcome of each method in six problems over the coefficient of friction"
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

/// For each case the first μ that reaches the bound at that μ, with the bound.
fn dividers(facts: &[Entry]) -> Vec<(String, f64, String)> {
    let of_case = |case: &'static str| {
        let mut own: Vec<(f64, f64)> = facts
            .iter()
            .filter(|(of, _, _)| *of == case)
            .filter_map(|(_, mu, known)| Some((*mu, known.bound?)))
            .collect();
        own.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (mu, bound) = own.into_iter().find(|(mu, bound)| mu >= bound)?;
        let name = if [PUSHED, WEDGED].contains(&case) {
            format!("one solution below μ_c = {bound:.2}")
        } else {
            format!("estimate: one solution below μ_c ≈ {bound:.2}")
        };
        Some((case.to_owned(), mu, name))
    };
    CASES.into_iter().filter_map(of_case).collect()
}

/// The worst outcome of each method in any of the problems.
fn summary(rows: &[Row], dividers: &[(String, f64, String)]) -> Result<Svg, Trouble> {
    const WORST: &str = "worst of the six problems";
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
    let least = dividers
        .iter()
        .map(|(_, mu, _)| *mu)
        .fold(f64::INFINITY, f64::min);
    Ok(map(
        &worst,
        &Legend {
            title: "Which solver can be trusted at which coefficient of friction",
            subtitle: "One node, a flat punch and a pin in a plate: pushed, loaded and unloaded, and with their load removed at once.",
            varied: VARIED,
            label: &|mu| format!("{mu:.1}"),
            dividers: &[(
                WORST.to_owned(),
                least,
                "several solutions possible (estimate) →".into(),
            )],
        },
    )?)
}

/// `given` with all its solutions.
fn enumerated(mut given: Discrete) -> Discrete {
    let all = discrete::enumerate(&given);
    given.solutions = Some(Known {
        complete: !all.singular && !all.borderline,
        states: all.states,
    });
    given
}

fn facts_of(given: &Discrete, bound: Option<f64>) -> Fact {
    let floor = HELD * given.committed.forces.amax();
    let states = given
        .solutions
        .as_ref()
        .map_or(&[][..], |known| &known.states);
    let unloaded = given.is_unloaded();
    let held = states
        .iter()
        .filter(|state| unloaded && state.forces.amax() > floor);
    Fact {
        bound,
        solutions: states.len(),
        wedged: held.count(),
    }
}

/// One increment, against its known answers: of several the one nearest to the committed state.
fn alone(case: &str, mu: f64, given: &Discrete, methods: &[Method]) -> Vec<Row> {
    let taken = methods
        .iter()
        .find(|method| method.is_chain())
        .and_then(|chain| chain.solver.solve(&given.step()).ok())
        .map(|solution| solution.trial);
    let floor = HELD * given.committed.forces.amax();
    let held = case != PUSHED
        && taken
            .as_ref()
            .is_some_and(|trial| trial.forces.amax() > floor);
    let known = given.solutions.as_ref();
    let nearest = known.and_then(|known| given.nearest(&known.states));
    methods
        .iter()
        .map(|method| {
            let mut row = judge(method, given, nearest.or(taken.as_ref()));
            if held && method.is_chain() {
                row.note = "wedged: contact forces are left without load".into();
            }
            Row::of_steps(case, mu, given.coercive, &[row])
        })
        .collect()
}

/// A history that ends without load; what still presses there is noted with the default chain.
fn history(
    case: &'static str,
    mu: f64,
    stages: &Stages,
    methods: &[Method],
) -> (&'static str, Vec<Row>, Fact) {
    let mut rows = stages.rows(case, mu, methods);
    let forces = |trial: &stickslip_contact::state::TrialState| trial.forces.amax();
    let answers = || stages.list.iter().filter_map(|stage| stage.answer.as_ref());
    let largest = answers().map(forces).fold(0.0, f64::max);
    let unloaded = stages.list.last().filter(|stage| stage.given.is_unloaded());
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
    let bounds = stages.list.iter().filter_map(|stage| {
        let answer = stage.answer.as_ref()?;
        uniqueness_bound(&stage.given.problem, &answer.status)
    });
    let known = Fact {
        bound: bounds.reduce(f64::min),
        ..Fact::default()
    };
    (case, rows, known)
}
