//! `cargo xtask stability`: the failure atlas. What is varied, what should happen, what each method did.
//!
//! Every study gives the methods problems with known or independently judged answers, and writes a table, pictures and a
//! sentence. No method is asked how good its answer is: the conditions are checked by other code, and answers are compared with
//! exact ones, with all solutions by enumeration, or with finer models. The task fails if the default chain gives a wrong
//! answer, leaves a supported problem unsolved, or another one without answer or proof.

mod atlas;
mod clearance;
mod friction;
mod history;
mod joint;
mod law;
mod load_steps;
mod mesh_quality;
pub(crate) mod methods;
mod outcome;
mod penalty;
mod picture;
mod random;
mod row;
mod separation;
mod stiffness;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use stickslip_report::svg::Svg;

use outcome::Outcome;
use row::Row;

use crate::publish::Published;

/// Why a study stopped.
type Trouble = Box<dyn std::error::Error + Send + Sync>;

/// What to study.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// The same studies with fewer values and coarser meshes: at most a minute. Nothing is written unless a folder is named.
    #[arg(long)]
    quick: bool,
    /// Only studies whose name contains this.
    #[arg(long, value_name = "NAME")]
    only: Option<String>,
    /// Folder for tables and pictures; docs/stability for a full run.
    #[arg(long, value_name = "FOLDER")]
    output: Option<PathBuf>,
}

/// One question of the atlas.
struct Study {
    /// Name of its files.
    name: &'static str,
    title: &'static str,
    varied: &'static str,
    expectation: &'static str,
    run: fn(&Context) -> Result<Findings, Trouble>,
}

const STUDIES: [Study; 9] = [
    friction::STUDY,
    load_steps::STUDY,
    clearance::STUDY,
    separation::STUDY,
    penalty::STUDY,
    mesh_quality::STUDY,
    stiffness::STUDY,
    law::STUDY,
    random::STUDY,
];

/// How much is computed, and where progress is shown.
struct Context {
    quick: bool,
    progress: ProgressBar,
}

impl Context {
    /// `quick` or `full`, whichever is asked for.
    fn sized<T>(&self, quick: T, full: T) -> T {
        if self.quick { quick } else { full }
    }

    /// The rows of each of `values`, computed side by side, in their order.
    fn rows_of<V: Sync>(
        &self,
        values: &[V],
        rows: impl Fn(&V) -> Result<Vec<Row>, Trouble> + Sync,
    ) -> Result<Vec<Row>, Trouble> {
        self.progress.inc_length(values.len() as u64);
        let parts = values
            .par_iter()
            .map(|value| {
                let rows = rows(value);
                self.progress.inc(1);
                rows
            })
            .collect::<Result<Vec<_>, _>>()?;
        Ok(parts.into_iter().flatten().collect())
    }
}

/// What a study found.
#[derive(Default)]
struct Findings {
    rows: Vec<Row>,
    /// Comma-separated tables, by what their names add to the study's.
    tables: Vec<(&'static str, String)>,
    /// Pictures, by what their names add to the study's, with a text for readers without them.
    pictures: Vec<(&'static str, Svg, String)>,
    /// What happened, in sentences beyond the counts of outcomes.
    remarks: Vec<String>,
    /// What fails the task.
    failures: Vec<String>,
}

/// Runs the task: progress on stderr, a table of outcomes on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    let wanted = |study: &&Study| {
        options
            .only
            .as_ref()
            .is_none_or(|name| study.name.contains(name.as_str()))
    };
    let chosen: Vec<&Study> = STUDIES.iter().filter(wanted).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = STUDIES.iter().map(|study| study.name).collect();
        eprintln!(
            "no study has that in its name; the studies are {}",
            names.join(", ")
        );
        return ExitCode::FAILURE;
    }
    let mut failures = Vec::new();
    let mut results = Vec::new();
    for study in chosen {
        match observe(study, options.quick) {
            Ok(findings) => {
                let own = findings
                    .failures
                    .iter()
                    .cloned()
                    .chain(unanswered(study, &findings.rows));
                failures.extend(own.map(|failure| format!("{}: {failure}", study.name)));
                print!("{}", atlas::text(study, &findings));
                results.push((study, findings));
            }
            Err(trouble) => failures.push(format!("{}: {trouble}", study.name)),
        }
    }
    let all = !options.quick && options.only.is_none();
    let own = all.then(|| PathBuf::from(concat!(env!("CARGO_MANIFEST_DIR"), "/../docs/stability")));
    let written = Published::open(options.output.as_deref(), own)
        .map_err(Trouble::from)
        .and_then(|folder| match folder {
            Some(mut folder) => atlas::write(&mut folder, &results, options.only.is_none()),
            None => Ok(()),
        });
    if let Err(trouble) = written {
        failures.push(trouble.to_string());
    }
    for failure in &failures {
        eprintln!("FAIL {failure}");
    }
    eprintln!("{:.0} s", start.elapsed().as_secs_f64());
    if failures.is_empty() {
        ExitCode::SUCCESS
    } else {
        ExitCode::FAILURE
    }
}

fn observe(study: &Study, quick: bool) -> Result<Findings, Trouble> {
    let progress = ProgressBar::new(0);
    // The template is a constant that is known to parse; without a style the bar only looks plainer.
    if let Ok(style) = ProgressStyle::with_template("{msg:>28} {wide_bar} {pos}/{len} {elapsed}") {
        progress.set_style(style);
    }
    progress.set_message(study.title);
    let context = Context { quick, progress };
    let findings = (study.run)(&context);
    context.progress.finish_and_clear();
    findings
}

/// Answers of the default chain that must not be: wrong ones, supported problems without an answer, and what is neither solved
/// nor proved.
fn unanswered(study: &Study, rows: &[Row]) -> impl Iterator<Item = String> {
    // Nowhere else is a body pulled off.
    let provable = study.name == separation::STUDY.name;
    rows.iter()
        .filter(|row| row.method == methods::CHAIN)
        .filter(move |row| {
            let proved = provable && row.outcome == Outcome::Certified && !row.coercive;
            !row.outcome.is_answer() && !proved
        })
        .map(|row| {
            format!(
                "{}, {}: the default chain is {}: {}",
                row.case,
                row.value,
                row.outcome.name(),
                row.note
            )
        })
}
