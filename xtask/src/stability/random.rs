//! Study 9: very many small random problems against all their solutions.

use rayon::prelude::*;
use stickslip_contact::problem::ProblemPoint;
use stickslip_contact::{ContactState, InterfaceProblem};
use stickslip_laboratory::LaboratoryError;
use stickslip_laboratory::discrete::{self, Known};
use stickslip_report::color::Color;
use stickslip_report::map::{Category, Group, OutcomeMap};
use stickslip_report::svg::Svg;
use toml::Table;

use super::context::{Context, Found};
use super::judge::judge;
use super::methods::{Method, methods};
use super::outcome::Outcome;
use crate::publish::TaskError;
use crate::study::record::fields;

/// Problems that go through the default chain, and each of how many that goes through every method.
const PROBLEMS: [u64; 2] = [4000, 100_000];
const EVERY: u64 = 20;
/// Problems that one piece of progress stands for.
const BATCH: u64 = 500;
/// Problems after which the number of rigid motions repeats.
const MOTIONS: u64 = 5;
/// Width of a bin of μ.
const BIN: f64 = 0.3;
const BINS: usize = 10;
/// Share of the problems without supports that may stay unresolved.
const UNRESOLVED: f64 = 1e-3;

/// Index of the cells with wrong answers, after those of 0 to 100 %.
const WRONG: usize = 101;

/// What is known of a problem before any method sees it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Class {
    Supported,
    Solvable,
    Unsolvable,
    /// Floating, with statuses that leave the solution undetermined: enumeration finds none, and proves nothing.
    Undetermined,
}

impl Class {
    const ALL: [Self; 4] = [
        Self::Supported,
        Self::Solvable,
        Self::Unsolvable,
        Self::Undetermined,
    ];

    fn name(self) -> &'static str {
        match self {
            Self::Supported => "supported",
            Self::Solvable => "floating, with solution",
            Self::Unsolvable => "floating, without solution",
            Self::Undetermined => "floating, undetermined",
        }
    }
}

/// One judged trial.
struct Trial {
    class: Class,
    bin: usize,
    /// Index of the method.
    method: usize,
    outcome: Outcome,
    /// Number of all solutions.
    solutions: usize,
    /// Whether all solutions are known: statuses on a border, or with a family of solutions, leave that open.
    complete: bool,
    seed: u64,
    note: String,
}

impl Trial {
    fn is_of(&self, class: Class, bin: usize, method: usize) -> bool {
        self.class == class && self.bin == bin && self.method == method
    }
}

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let problems = context.sized(PROBLEMS[0], PROBLEMS[1]);
    let batches: Vec<u64> = (0..problems / BATCH).collect();
    context.progress.set_length(problems);
    let trials: Vec<Vec<Trial>> = batches
        .par_iter()
        .map(|&batch| {
            let methods = methods();
            let seeds = batch * BATCH..(batch + 1) * BATCH;
            let trials: Result<Vec<_>, _> = seeds.map(|seed| tried(seed, &methods)).collect();
            context.progress.inc(BATCH);
            Ok(trials?.into_iter().flatten().collect())
        })
        .collect::<Result<_, LaboratoryError>>()?;
    let trials: Vec<Trial> = trials.into_iter().flatten().collect();
    let names: Vec<&str> = methods().iter().map(|method| method.name).collect();
    Ok(Found {
        more: vec![
            ("", table(&trials, &names)),
            ("-classes", classes(&trials)),
            ("-nearest", nearest(&trials, &names)),
        ],
        pictures: vec![picture(&trials, &names)?],
        failures: failures(&trials),
        ..Found::default()
    })
}

/// Three of five are supported, one floats along one motion and one along two.
fn floating(seed: u64) -> usize {
    match seed % MOTIONS {
        0..=2 => 0,
        3 => 1,
        _ => 2,
    }
}

fn tried(seed: u64, methods: &[Method]) -> Result<Vec<Trial>, LaboratoryError> {
    let mut given = discrete::random(seed, floating(seed))?;
    let all = discrete::enumerate(&given);
    let complete = !all.singular && !all.borderline;
    let class = match (given.coercive, all.states.is_empty()) {
        (true, _) => Class::Supported,
        (false, false) => Class::Solvable,
        (false, true) if complete => Class::Unsolvable,
        (false, true) => Class::Undetermined,
    };
    let solutions = all.states.len();
    // Of several solutions the one to be taken.
    let answer = given.nearest(&all.states).cloned();
    given.solutions = Some(Known {
        complete,
        states: all.states,
    });
    let bin = ((friction(&given.problem, &given.committed) / BIN) as usize).min(BINS - 1);
    let is_for_all = (seed / MOTIONS).is_multiple_of(EVERY);
    let chosen = if is_for_all { methods.len() } else { 1 };
    let trial = |(method, solver)| {
        let row = judge(solver, &given, answer.as_ref());
        Trial {
            class,
            bin,
            method,
            outcome: row.outcome,
            solutions,
            complete,
            seed,
            note: row.note,
        }
    };
    Ok(methods[..chosen].iter().enumerate().map(trial).collect())
}

/// μ of a problem with one Coulomb law.
fn friction(problem: &InterfaceProblem, state: &ContactState) -> f64 {
    let bound = |point: &ProblemPoint| {
        problem
            .law(0)
            .bound(1.0, 0.0, &point.place, &state.history[0])
            .stick
    };
    problem.points().first().map_or(0.0, bound)
}

/// Outcomes by class, bin of μ and method.
fn table(trials: &[Trial], names: &[&str]) -> Vec<Table> {
    let mut rows = Vec::new();
    for class in Class::ALL {
        for bin in 0..BINS {
            for (method, name) in names.iter().enumerate() {
                let own = trials
                    .iter()
                    .filter(|trial| trial.is_of(class, bin, method));
                let own: Vec<&Trial> = own.collect();
                let mut row = Table::from_iter(fields([
                    ("class", class.name().into()),
                    ("mu_from", (BIN * bin as f64).into()),
                    ("mu_to", (BIN * (bin + 1) as f64).into()),
                    ("method", (*name).into()),
                    ("problems", (own.len() as i64).into()),
                ]));
                row.extend(outcomes(&own));
                rows.push(row);
            }
        }
    }
    rows
}

/// How often each outcome occurred.
fn outcomes(trials: &[&Trial]) -> Table {
    let count = |outcome: Outcome| {
        let count = (trials.iter())
            .filter(|trial| trial.outcome == outcome)
            .count();
        (outcome.name().to_owned(), (count as i64).into())
    };
    Outcome::ALL.map(count).into_iter().collect()
}

/// What the default chain does with each class.
fn classes(trials: &[Trial]) -> Vec<Table> {
    let row = |class: Class| {
        let own = |trial: &&Trial| trial.method == 0 && trial.class == class;
        let own: Vec<&Trial> = trials.iter().filter(own).collect();
        let count = |wanted: fn(&Trial) -> bool| {
            let count = own.iter().filter(|trial| wanted(trial)).count();
            (count as i64).into()
        };
        let mut row = Table::from_iter(fields([
            ("class", class.name().into()),
            ("problems", count(|_| true)),
            ("several", count(|trial| trial.solutions > 1)),
            ("open", count(|trial| !trial.complete)),
        ]));
        row.extend(outcomes(&own));
        row
    };
    Class::ALL.map(row).to_vec()
}

fn picture(trials: &[Trial], names: &[&str]) -> Result<Svg, TaskError> {
    let groups = Class::ALL.map(|class| shares(trials, names, class));
    let middles = (0..BINS).map(|bin| format!("{:.2}", BIN * (bin as f64 + 0.5)));
    let map = OutcomeMap {
        title: "Random problems of 1 to 3 points: percentage that is solved or proved impossible"
            .into(),
        subtitle: "Against enumeration of all statuses; percentages are rounded down. Regularised answers count if they are within 1 %."
            .into(),
        x_label: "coefficient of friction μ, middle of the bin [1]".into(),
        columns: middles.collect(),
        groups: groups.into_iter().filter(|group| !group.rows.is_empty()).collect(),
        categories: levels(),
        width: 860.0,
    };
    Ok(map.render()?)
}

/// Cells by the percentage that is answered, from 0 to 100 in their order; the last is for wrong answers.
fn levels() -> Vec<Category> {
    let level = |percent: usize| {
        let (label, color) = match percent {
            100 => ("all", Color::rgb(0x8c, 0xc5, 0xe3)),
            99 => ("99 % and more", Color::rgb(0xc9, 0xe5, 0xc0)),
            90..99 => ("90 % and more", Color::rgb(0xf2, 0xd9, 0x6b)),
            50..90 => ("50 % and more", Color::rgb(0xe8, 0x8b, 0x3a)),
            _ => ("less", Color::rgb(0xc6, 0x58, 0x3c)),
        };
        Category {
            label: label.into(),
            mark: percent.to_string(),
            color,
        }
    };
    let wrong = Category {
        label: "wrong answers".into(),
        mark: "!".into(),
        color: Color::rgb(0x11, 0x11, 0x11),
    };
    (0..=100).map(level).chain([wrong]).collect()
}

/// The level of each method in each bin of μ.
fn shares(trials: &[Trial], names: &[&str], class: Class) -> Group {
    let level = |method: usize, bin: usize| {
        let own = trials
            .iter()
            .filter(|trial| trial.is_of(class, bin, method));
        let (mut all, mut answered, mut wrong) = (0_usize, 0_usize, false);
        for trial in own {
            let useful = matches!(trial.outcome, Outcome::Approximate | Outcome::Certified);
            all += 1;
            answered += usize::from(useful || trial.outcome.is_answer());
            wrong |= trial.outcome == Outcome::Wrong;
        }
        (all > 0).then(|| if wrong { WRONG } else { 100 * answered / all })
    };
    let rows = names.iter().enumerate().map(|(method, name)| {
        let cells: Vec<_> = (0..BINS).map(|bin| level(method, bin)).collect();
        ((*name).to_owned(), cells)
    });
    Group {
        label: class.name().into(),
        rows: rows
            .filter(|(_, cells)| cells.iter().any(Option::is_some))
            .collect(),
        divider: None,
    }
}

/// How often each method's answer is the solution nearest to the last accepted state, where there are several.
fn nearest(trials: &[Trial], names: &[&str]) -> Vec<Table> {
    let row = |(method, name): (usize, &&str)| {
        let own = |trial: &&Trial| trial.method == method && trial.solutions > 1;
        let own = trials.iter().filter(own);
        let solved: Vec<&Trial> = own.filter(|trial| trial.outcome.is_answer()).collect();
        let is_nearest = |trial: &&&Trial| trial.outcome == Outcome::Solved;
        let taken = solved.iter().filter(is_nearest).count();
        let row = fields([
            ("method", (*name).into()),
            ("nearest_taken", (taken as i64).into()),
            ("solved", (solved.len() as i64).into()),
        ]);
        (!solved.is_empty()).then(|| Table::from_iter(row))
    };
    names.iter().enumerate().filter_map(row).collect()
}

/// Failures of the default chain, with the seeds that repeat them.
fn failures(trials: &[Trial]) -> Vec<String> {
    let chain: Vec<&Trial> = trials.iter().filter(|trial| trial.method == 0).collect();
    let bad = |trial: &&&Trial| {
        trial.outcome == Outcome::Wrong
            || (trial.class == Class::Supported && !trial.outcome.is_answer())
    };
    let describe = |trial: &&Trial| {
        let (class, outcome) = (trial.class.name(), trial.outcome.name());
        format!("seed {} ({class}): {outcome} {}", trial.seed, trial.note)
    };
    let mut failures: Vec<String> = chain.iter().filter(bad).map(describe).collect();
    let floating = chain.iter().filter(|trial| trial.class != Class::Supported);
    let is_unresolved = |trial: &&&Trial| trial.outcome == Outcome::Unresolved;
    let unresolved = floating.clone().filter(is_unresolved);
    let unresolved: Vec<u64> = unresolved.map(|trial| trial.seed).collect();
    if unresolved.len() as f64 > UNRESOLVED * floating.count() as f64 {
        let count = unresolved.len();
        failures.push(format!(
            "{count} floating problems unresolved, seeds {unresolved:?}"
        ));
    }
    failures
}
