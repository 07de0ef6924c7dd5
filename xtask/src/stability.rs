//! `cargo xtask stability`: the failure atlas. What is varied, what should happen, what each method did.
//!
//! Every study gives the methods problems with known or independently judged answers. Its tables, pictures and findings are described
//! in `studies/stability/study.toml`. No method is asked how good its answer is: the conditions are checked by other code, and answers are compared with
//! exact ones, with all solutions by enumeration, or with finer models. The task fails if the default chain gives a wrong
//! answer, leaves a supported problem unsolved, or another one without answer or proof.

mod atlas;
mod clearance;
mod context;
mod friction;
mod history;
mod joint;
mod judge;
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

use clap::Args;

use context::{Context, Found};
use outcome::Outcome;
use row::Row;

use crate::publish::{TaskError, bar};
use crate::study::Description;
use crate::study::table::Tables;

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

/// One question of the atlas: the name of its files, its title, and what answers it.
struct Study(
    &'static str,
    &'static str,
    fn(&Context) -> Result<Found, TaskError>,
);

const STUDIES: [Study; 9] = [
    Study("01-friction", "Coefficient of friction", friction::run),
    Study("02-load-steps", "Size of load steps", load_steps::run),
    Study("03-clearance", "Clearance", clearance::run),
    Study(
        "04-separation",
        "Separation and re-contact",
        separation::run,
    ),
    Study("05-penalty", "Penalty stiffness", penalty::run),
    Study("06-mesh-quality", "Mesh quality", mesh_quality::run),
    Study(
        "07-stiffness",
        "Stiffness ratio and incompressibility",
        stiffness::run,
    ),
    Study("08-law", "Static and dynamic friction, softening", law::run),
    Study("09-random", "Random small problems", random::run),
];
/// The only one in which a body is pulled off.
const SEPARATION: &str = "04-separation";

/// Runs the task: progress on stderr, outcomes and findings on stdout.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let failures = study(options)?;
    for failure in &failures {
        eprintln!("FAIL {failure}");
    }
    Ok(failures.is_empty())
}

/// Makes and writes the chosen studies; what is wrong with them.
fn study(options: &Options) -> Result<Vec<String>, TaskError> {
    let only = options.only.as_deref().unwrap_or_default();
    let chosen: Vec<&Study> = (STUDIES.iter())
        .filter(|study| study.0.contains(only))
        .collect();
    if chosen.is_empty() {
        let names: Vec<&str> = STUDIES.iter().map(|study| study.0).collect();
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
            Err(error) => {
                failures.push(format!("{}: {error}", study.0));
                continue;
            }
        };
        let own = (found.failures.iter().cloned()).chain(unanswered(study, &found.rows));
        failures.extend(own.map(|failure| format!("{}: {failure}", study.0)));
        print!("{}", atlas::text(study.1, &found.rows));
        let outcomes = tables.entry("outcomes".to_owned()).or_default();
        outcomes.extend(atlas::records(study.0, &found.rows));
        let records = found.rows.iter().map(|row| row.record(found.varied));
        if !found.rows.is_empty() {
            tables.insert(format!("{}{}", study.0, found.suffix), records.collect());
        }
        for (suffix, records) in found.more {
            tables.insert(format!("{}{suffix}", study.0), records);
        }
        if let Some(folder) = &mut folder {
            for picture in &found.pictures {
                folder.write_picture(study.0, picture)?;
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

fn observe(study: &Study, quick: bool) -> Result<Found, TaskError> {
    let progress = bar("{msg:>28} {wide_bar} {pos}/{len} {elapsed}", 0);
    progress.set_message(study.1);
    let context = Context { quick, progress };
    let findings = (study.2)(&context);
    context.progress.finish_and_clear();
    findings
}

/// Answers of the default chain that must not be: wrong ones, supported problems without an answer, and what is neither solved
/// nor proved.
fn unanswered(study: &Study, rows: &[Row]) -> impl Iterator<Item = String> {
    let provable = study.0 == SEPARATION;
    rows.iter()
        .filter(|row| row.method == methods::CHAIN)
        .filter(move |row| {
            let proved = provable && row.outcome == Outcome::Certified && !row.coercive;
            !row.outcome.is_answer() && !proved
        })
        .map(|row| {
            let (outcome, note) = (row.outcome.name(), &row.note);
            format!(
                "{}, {}: the default chain is {outcome}: {note}",
                row.case, row.value
            )
        })
}
