//! Study 1: the coefficient of friction, through the estimated bound up to which a step has one solution.

mod starts;

use std::sync::Mutex;

use stickslip_contact::state::TrialState;
use stickslip_contact::{InterfaceProblem, uniqueness_bound};
use stickslip_laboratory::discrete::{self, Discrete, Known};
use toml::Table;

use super::context::{Context, Found};
use super::history::{Stage, Stages};
use super::joint::{Joint, coulomb, set};
use super::judge::judge;
use super::methods::{CHAIN, Method, methods};
use super::row::Row;
use crate::publish::TaskError;
use crate::study::record::fields;
use starts::{Stuck, stuck};

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

/// What was found of a case at a μ.
type Studied = (&'static str, Vec<Row>, Fact);

/// A case at a μ.
type Entry = (&'static str, f64, Fact);

/// What is the same at each μ.
struct Setup {
    pin: Joint,
    stuck_pin: Stuck,
    stuck_punch: Stuck,
    /// Nodes of the punch that is pushed to and fro.
    nodes: usize,
}

impl Setup {
    fn new(context: &Context) -> Result<Self, TaskError> {
        let spacing = context.sized("18 deg", "9 deg");
        let pin = Joint::of_scene("pin-benchmark", &set(&[("mesh.spacing", spacing.into())]))?;
        Ok(Self {
            stuck_pin: stuck(&|mu| pin.problem_with(&coulomb(mu)?), &pin.loads[..4])?,
            stuck_punch: stuck(&coarse_punch, &[vec![1.0, 0.0], vec![1.0, 1.0]])?,
            nodes: context.sized(5, 13),
            pin,
        })
    }

    /// All cases at a μ.
    fn found(&self, mu: f64) -> Result<[Studied; 6], TaskError> {
        let methods = methods();
        let one = |case, given: &Discrete, bound| {
            (
                case,
                alone(case, mu, given, &methods),
                facts_of(given, bound),
            )
        };
        let node = discrete::one_node(mu, STIFFNESS, LOAD, 0.0, 0.0)?;
        let pushed = one(PUSHED, &node, Some(discrete::one_node_bound(STIFFNESS)));
        let wedged = one(WEDGED, &discrete::wedged(mu)?, Some(WEDGE_BOUND));
        let bound = |given: &Discrete| uniqueness_bound(&given.problem, &given.committed.status);
        let given = enumerated(self.stuck_punch.without_load(coarse_punch(mu)?));
        let stuck_punch = one(STUCK_PUNCH, &given, bound(&given));
        let punch = discrete::flat_punch(self.nodes, mu)?;
        let push = punch.multipliers[1];
        let loads = [[1.0, 0.0], [1.0, push], [1.0, -push], [0.0, 0.0]].map(Vec::from);
        let punch = history(PUNCH, mu, &Stages::follow(&punch.problem, &loads), &methods);
        let problem = self.pin.problem_with(&coulomb(mu)?)?;
        let loads = [
            self.pin.loads.clone(),
            vec![vec![0.0; problem.load_cases()]],
        ]
        .concat();
        let pin = history(PIN, mu, &Stages::follow(&problem, &loads), &methods);
        let given = self.stuck_pin.without_load(problem);
        let stuck_pin = one(STUCK_PIN, &given, bound(&given));
        Ok([pushed, wedged, stuck_punch, punch, pin, stuck_pin])
    }
}

fn coarse_punch(mu: f64) -> Result<InterfaceProblem, TaskError> {
    Ok(discrete::flat_punch(COARSE, mu)?.problem)
}

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let count = context.sized(6, 30);
    let values = (0..=count).map(|k| 3.0 * f64::from(k) / f64::from(count));
    let values: Vec<f64> = values.collect();
    let setup = Setup::new(context)?;
    let facts = Mutex::new(Vec::<Entry>::new());
    let mut rows = context.rows_of(&values, |&mu| {
        let found = setup.found(mu)?;
        let mut facts = facts.lock().map_err(|_| "a problem panicked")?;
        facts.extend(found.iter().map(|(case, _, known)| (*case, mu, *known)));
        Ok(found.into_iter().flat_map(|(_, rows, _)| rows).collect())
    })?;
    let mut facts = facts.into_inner().map_err(|_| "a problem panicked")?;
    // Whatever the order in which threads ended.
    facts.sort_by(|(_, a, _), (_, b, _)| a.total_cmp(b));
    // Case by case, for the table.
    rows.sort_by_key(|row| CASES.iter().position(|case| *case == row.case));
    let worst = worst_of(&rows, &facts);
    for row in &mut rows {
        let mut facts = facts.iter();
        let own = facts.find(|(case, mu, _)| *case == row.case && *mu == row.value);
        if let Some(bound) = own.and_then(|(_, _, fact)| fact.bound) {
            let is_exact = [PUSHED, WEDGED].contains(&row.case.as_str());
            let kind = if is_exact { EXACT } else { ESTIMATE };
            let own = fields([("bound", bound.into()), ("kind_of_bound", kind.into())]);
            row.more.extend(own);
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
    let states = given.solutions.iter().flat_map(|known| &known.states);
    let unloaded = given.is_unloaded();
    let held = |state: &&TrialState| unloaded && state.forces.amax() > floor;
    Fact {
        bound,
        solutions: states.clone().count(),
        wedged: states.filter(held).count(),
    }
}

/// One increment, against its known answers: of several the one nearest to the committed state.
fn alone(case: &str, mu: f64, given: &Discrete, methods: &[Method]) -> Vec<Row> {
    let chain = methods.iter().find(|method| method.is_chain());
    let taken = chain.and_then(|chain| chain.solver.solve(&given.step()).ok());
    let taken = taken.map(|solution| solution.trial);
    let floor = HELD * given.committed.forces.amax();
    let left = taken.as_ref().map_or(0.0, |trial| trial.forces.amax());
    let held = case != PUSHED && left > floor;
    let known = given.solutions.as_ref();
    let nearest = known.and_then(|known| given.nearest(&known.states));
    let row = |method: &Method| {
        let mut row = judge(method, given, nearest.or(taken.as_ref()));
        if held && method.is_chain() {
            row.note = "wedged: contact forces are left without load".into();
        }
        Row::of_steps(case, mu, given.coercive, &[row])
    };
    methods.iter().map(row).collect()
}

/// A history that ends without load; what still presses there is noted with the default chain.
fn history(case: &'static str, mu: f64, stages: &Stages, methods: &[Method]) -> Studied {
    let mut rows = stages.rows(case, mu, methods);
    let forces = |stage: &Stage| Some(stage.answer.as_ref()?.forces.amax());
    let largest = stages.list.iter().filter_map(forces).fold(0.0, f64::max);
    let unloaded = stages.list.last().filter(|stage| stage.given.is_unloaded());
    let left = unloaded.and_then(forces).unwrap_or(0.0);
    if left > HELD * largest {
        let share = left / largest;
        let note = format!("wedged: {share:.2} of the largest contact force is left without load");
        for row in rows.iter_mut().filter(|row| row.method == CHAIN) {
            row.note.clone_from(&note);
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
