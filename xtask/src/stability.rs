//! `cargo xtask stability`: the failure atlas. What is varied, what should happen, what each method did.
//!
//! Every study gives the methods problems with known or independently judged answers. Its tables, pictures and findings are described
//! in `studies/stability/study.toml`. No method is asked how good its answer is: the conditions are checked by other code, and answers are compared with
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
mod random;
mod row;
mod separation;
mod stiffness;

use std::path::PathBuf;
use std::process::ExitCode;
use std::time::Instant;

use clap::Args;
use indicatif::ProgressBar;
use rayon::prelude::*;
use stickslip_report::svg::Svg;
use toml::Table;

use outcome::Outcome;
use row::Row;

use crate::publish::bar;
use crate::study::Description;
use crate::study::table::Tables;

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
    run: fn(&Context) -> Result<Found, Trouble>,
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
struct Found {
    /// What methods did, whose outcomes are counted; what the table's name adds to the study's; and what is varied.
    rows: Vec<Row>,
    suffix: &'static str,
    varied: &'static str,
    /// Further tables, by what their names add to the study's.
    more: Vec<(&'static str, Vec<Table>)>,
    /// Pictures that no description can make, called as the study.
    pictures: Vec<Svg>,
    /// What fails the task.
    failures: Vec<String>,
}

impl Found {
    fn of(varied: &'static str, rows: Vec<Row>) -> Self {
        Self {
            rows,
            varied,
            ..Self::default()
        }
    }

    /// With a further table of rows.
    fn and(mut self, suffix: &'static str, varied: &str, rows: &[Row]) -> Self {
        let records = rows.iter().map(|row| row.record(varied)).collect();
        self.more.push((suffix, records));
        self
    }
}

/// Runs the task: progress on stderr, outcomes and findings on stdout.
pub(crate) fn main(options: &Options) -> ExitCode {
    let start = Instant::now();
    let failures = study(options).unwrap_or_else(|trouble| vec![trouble.to_string()]);
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

/// Makes and writes the chosen studies; what is wrong with them.
fn study(options: &Options) -> Result<Vec<String>, Trouble> {
    let only = options.only.as_deref().unwrap_or_default();
    let chosen: Vec<&Study> = (STUDIES.iter())
        .filter(|study| study.name.contains(only))
        .collect();
    if chosen.is_empty() {
        let names: Vec<&str> = STUDIES.iter().map(|study| study.name).collect();
        let names = names.join(", ");
        return Err(format!("no study has that in its name; the studies are {names}").into());
    }
    let description = Description::of("stability")?;
    let is_full = !options.quick && options.only.is_none();
    let mut folder = description.folder(options.output.as_deref(), is_full)?;
    let mut failures = Vec::new();
    let mut tables = Tables::new();
    for study in chosen {
        let found = match observe(study, options.quick) {
            Ok(found) => found,
            Err(trouble) => {
                failures.push(format!("{}: {trouble}", study.name));
                continue;
            }
        };
        let own = found
            .failures
            .iter()
            .cloned()
            .chain(unanswered(study, &found.rows));
        failures.extend(own.map(|failure| format!("{}: {failure}", study.name)));
        print!("{}", atlas::text(study, &found.rows));
        let outcomes = tables.entry("outcomes".to_owned()).or_default();
        outcomes.extend(atlas::records(study, &found.rows));
        if !found.rows.is_empty() {
            let records = found
                .rows
                .iter()
                .map(|row| row.record(found.varied))
                .collect();
            tables.insert(format!("{}{}", study.name, found.suffix), records);
        }
        for (suffix, records) in found.more {
            tables.insert(format!("{}{suffix}", study.name), records);
        }
        if let Some(folder) = &mut folder {
            for picture in &found.pictures {
                folder.write_picture(study.name, picture)?;
            }
        }
    }
    let mut kept = description.write(&tables, folder)?;
    for (name, rows) in tables {
        kept.entry(name).or_insert(rows);
    }
    failures.extend(description.judge(&kept, is_full)?);
    Ok(failures)
}

fn observe(study: &Study, quick: bool) -> Result<Found, Trouble> {
    let progress = bar("{msg:>28} {wide_bar} {pos}/{len} {elapsed}", 0);
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
