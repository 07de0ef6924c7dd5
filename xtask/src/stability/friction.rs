//! Study 1: the coefficient of friction, through the estimated bound up to which a step has one solution.

mod starts;

use std::sync::Mutex;

use stickslip_contact::{InterfaceProblem, uniqueness_bound};
use stickslip_laboratory::discrete::{self, Discrete, Known};
use toml::Table;

use super::history::Stages;
use super::joint::{Joint, coulomb, set};
use super::methods::{CHAIN, Method, methods};
use super::outcome::judge;
use super::row::Row;
use super::{Context, Found};
use crate::publish::Trouble;
use crate::study::record::fields;
use starts::stuck;

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
/// What bounds are, as maps say it.
const EXACT: &str = "one solution below μ_c =";
const ESTIMATE: &str = "estimate: one solution below μ_c ≈";
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

pub(super) fn run(context: &Context) -> Result<Found, Trouble> {
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
    let worst = worst_of(&rows, &facts);
    for row in &mut rows {
        let mut facts = facts.iter();
        let own = facts.find(|(case, mu, _)| *case == row.case && *mu == row.value);
        if let Some(bound) = own.and_then(|(_, _, fact)| fact.bound) {
            let is_exact = [PUSHED, WEDGED].contains(&row.case.as_str());
            row.more.extend(fields([
                ("bound", bound.into()),
                (
                    "kind_of_bound",
                    if is_exact { EXACT } else { ESTIMATE }.into(),
                ),
            ]));
        }
    }
    let facts = facts.iter().map(|(case, mu, fact)| fact.record(case, *mu));
    let mut found = Found::of("mu", rows).and("-summary", "mu", &worst);
    found.more.push(("-facts", facts.collect()));
    Ok(found)
}

impl Fact {
    fn record(&self, case: &str, mu: f64) -> Table {
        let mut record = Table::from_iter(fields([
            ("case", case.into()),
            ("mu", mu.into()),
            ("solutions", (self.solutions as i64).into()),
            ("wedged", (self.wedged as i64).into()),
        ]));
        record.extend(self.bound.map(|bound| ("bound".to_owned(), bound.into())));
        record
    }
}

/// The worst outcome of each method in any of the problems, and the least bound of all.
fn worst_of(rows: &[Row], facts: &[Entry]) -> Vec<Row> {
    let mut worst: Vec<Row> = Vec::new();
    for row in rows {
        let same = |other: &&mut Row| other.method == row.method && other.value == row.value;
        if let Some(other) = worst.iter_mut().find(same) {
            other.outcome = other.outcome.max(row.outcome);
            continue;
        }
        let own = facts.iter().filter(|(_, mu, _)| *mu == row.value);
        let bounds = own.filter_map(|(_, _, fact)| fact.bound);
        let least = bounds.fold(f64::INFINITY, f64::min);
        worst.push(Row {
            case: "worst of the six problems".into(),
            more: fields([("bound", least.into())]).into_iter().collect(),
            ..row.clone()
        });
    }
    worst
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
