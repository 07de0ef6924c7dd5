//! `stickslip joint`: sweep over joints, row by row into a table that can be gone on with.

use std::fs::{self, OpenOptions};
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::process::exit;
use std::sync::atomic::Ordering;
use std::time::Instant;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use miette::Diagnostic;
use rayon::prelude::*;
use serde_json::{Value, json};
use stickslip_report::FigureError;
use stickslip_report::page::PageError;
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use thiserror::Error;

use super::console::Console;
use super::experiment::{Kind, kind_of};
use super::failure::{CommandError, Failure, OwnError};
use super::folder::{of_a_sweep, results_folder};
use super::interrupt::{INTERRUPTED, flag};
use super::memory::host;
use crate::folder::{FolderError, LIST, MARKER, SharedFolder};
use crate::sweep::engine::run;
use crate::sweep::figures::{Drawing, draw};
use crate::sweep::page::{Account, page};
use crate::sweep::row::Row;
use crate::sweep::{Minimum, Sweep, SweepError, findings, minima, table, verdict, warning};
use stickslip_scene::limits::Content;

const TABLE: &str = "cases.csv";
const IDENTITY: &str = "sweep.json";

#[derive(Debug, Args)]
pub(super) struct JointArguments {
    /// Sweep file: TOML, or JSON if the name ends in .json
    sweep: PathBuf,
    /// Folder for the results; by default the sweep's name with -results
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Go on with the table that is in the folder
    #[arg(long)]
    resume: bool,
    /// Cases to solve at the same time; by default as many as there are cores
    #[arg(long, value_name = "N")]
    jobs: Option<NonZeroUsize>,
    /// Set any key of the sweep's scene, for example --set mesh.spacing="3 deg"
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

/// Why a sweep cannot begin, or be kept.
#[derive(Debug, Error, Diagnostic)]
enum JointError {
    #[error("'{path}' holds results already")]
    #[diagnostic(
        code(joint::exists),
        help("go on with them by --resume, or name another folder with --output DIR")
    )]
    Exists { path: String },
    #[error("'{path}' holds other files and no sweep")]
    #[diagnostic(
        code(joint::folder),
        help("name a new or an empty folder with --output DIR")
    )]
    NotASweep { path: String },
    #[error("'{path}': {cause}")]
    #[diagnostic(
        code(joint::file),
        help("check that the folder and its files can be read and written")
    )]
    File { path: String, cause: String },
    #[error("'{path}' cannot be written")]
    #[diagnostic(
        code(joint::table),
        help("make room on the disk, and go on with --resume")
    )]
    Table {
        path: String,
        #[source]
        cause: csv::Error,
    },
    #[error("the figure '{name}' cannot be drawn as PNG")]
    #[diagnostic(code(joint::picture))]
    Picture {
        name: String,
        #[source]
        cause: FigureError,
    },
    #[error(transparent)]
    #[diagnostic(code(joint::folder))]
    Folder(#[from] FolderError),
    #[error("the page cannot be written")]
    #[diagnostic(code(joint::page))]
    Page(#[from] PageError),
    #[error(transparent)]
    #[diagnostic(transparent)]
    Sweep(#[from] SweepError),
    #[error("none of the {cases} cases has an answer; the first says: {reason}")]
    #[diagnostic(
        code(joint::nothing),
        help("run one case by itself: `stickslip run` with the base scene and --set")
    )]
    Nothing { cases: usize, reason: String },
    #[error("interrupted; {done} of {cases} cases are in '{path}'")]
    #[diagnostic(code(joint::interrupted), help("--resume goes on with the others"))]
    Interrupted {
        done: usize,
        cases: usize,
        path: String,
    },
}

impl OwnError for JointError {}

/// Solves all cases that the folder's table does not have yet.
pub(super) fn joint(arguments: &JointArguments, console: Console) -> Result<(), Failure> {
    let path = arguments.sweep.display().to_string();
    match kind_of(&arguments.sweep) {
        Some(Kind::Scene) => return Err(CommandError::SceneForSweep { path }.into()),
        Some(Kind::Experiment) => return Err(CommandError::ExperimentGiven { path }.into()),
        Some(Kind::Sweep) | None => {}
    }
    let sweep = Sweep::from_file(
        &arguments.sweep,
        &arguments.overrides,
        host().shared_by(arguments.jobs().get()),
    )?;
    let folder = results_folder(arguments.output.as_ref(), &arguments.sweep);
    let (mut files, mut rows) = open(&sweep, &folder, arguments.resume)?;
    let begun = rows.len();
    let pending: Vec<usize> = (0..sweep.cases())
        .filter(|case| rows.iter().all(|row| row.case != *case))
        .collect();
    let stop = flag();
    let jobs = arguments.jobs();
    let bar = bar(&sweep, begun, console);
    let path = files.file(TABLE);
    let start = Instant::now();
    let mut writer = table::Writer::after_rows(appended(&path)?);
    let ended = run(&sweep, &pending, jobs, &stop, &mut |row| {
        writer.write(&sweep, &row)?;
        rows.push(row);
        bar.inc(1);
        Ok(())
    });
    drop(writer);
    bar.finish_and_clear();
    let effort = ended.map_err(|error| match error {
        SweepError::Write { cause } => JointError::Table {
            path: path.display().to_string(),
            cause,
        },
        error => error.into(),
    })?;
    rows.sort_by_key(|row| row.case);
    let account = Account {
        seconds: start.elapsed().as_secs_f64(),
        solved_now: rows.len() - begun,
        jobs: jobs.get(),
        effort,
    };
    let summary = keep(&sweep, &rows, &mut files, &account)?;
    if stop.load(Ordering::Relaxed) && rows.len() < sweep.cases() {
        let interrupted = JointError::Interrupted {
            done: rows.len(),
            cases: sweep.cases(),
            path: path.display().to_string(),
        };
        console.fail(&interrupted.into());
        exit(INTERRUPTED);
    }
    report(&sweep, &rows)?;
    console.result(|| text(&sweep, &rows, &folder, &account), &summary)
}

impl JointArguments {
    fn jobs(&self) -> NonZeroUsize {
        let cores = || std::thread::available_parallelism().unwrap_or(NonZeroUsize::MIN);
        self.jobs.unwrap_or_else(cores)
    }
}

/// Makes the folder ready for further rows; returns those that it has.
fn open(
    sweep: &Sweep,
    folder: &Path,
    resume: bool,
) -> Result<(SharedFolder, Vec<Row>), JointError> {
    let shown = folder.display().to_string();
    let file = |path: &Path, cause: &dyn std::fmt::Display| JointError::File {
        path: path.display().to_string(),
        cause: cause.to_string(),
    };
    fs::create_dir_all(folder).map_err(|cause| file(folder, &cause))?;
    let (identity, table) = (folder.join(IDENTITY), folder.join(TABLE));
    let entries = fs::read_dir(folder).map_err(|cause| file(folder, &cause))?;
    // A sweep that was killed at once leaves a list without files, or half of a file.
    let mut others = entries.flatten().filter(|entry| {
        let name = entry.file_name().to_string_lossy().into_owned();
        name != LIST && !(name.starts_with('.') && name.contains(".partial-"))
    });
    let mut rows = Vec::new();
    if identity.is_file() || table.is_file() {
        if !resume {
            return Err(JointError::Exists { path: shown });
        }
        let read = |path: &Path, content| {
            let text = host().read_text(path, content);
            text.map_err(|cause| file(path, &cause))
        };
        check_identity(sweep, &read(&identity, Content::Document)?)?;
        // A sweep that ended before its first row has no table yet.
        if table.is_file() {
            rows = table::read(sweep, &read(&table, Content::Table)?)?;
        }
    } else if others.next().is_some() {
        return Err(JointError::NotASweep { path: shown });
    }
    let own = json!({
        "format": "stickslip-sweep",
        "format_version": 1,
        "title": sweep.title,
        "hash": sweep.hash,
        "cases": sweep.cases(),
    });
    let mut files = SharedFolder::open(folder, of_a_sweep)?;
    files.write(IDENTITY, format!("{own:#}\n").as_bytes())?;
    files.write(TABLE, &table::text(sweep, &rows)?)?;
    Ok((files, rows))
}

/// Whether the folder's rows belong to this sweep.
fn check_identity(sweep: &Sweep, text: &str) -> Result<(), SweepError> {
    let other = |what: &str| SweepError::Other {
        what: what.to_owned(),
    };
    let value: Value =
        serde_json::from_str(text).map_err(|_| other("its sweep.json is not JSON"))?;
    if value["hash"] == sweep.hash.as_str() {
        return Ok(());
    }
    let title = value["title"].as_str().unwrap_or("without a title");
    Err(other(&format!(
        "that of '{title}' with {} cases; axes, scene or --set differ",
        value["cases"]
    )))
}

fn appended(path: &Path) -> Result<fs::File, JointError> {
    let opened = OpenOptions::new().append(true).open(path);
    opened.map_err(|cause| JointError::File {
        path: path.display().to_string(),
        cause: cause.to_string(),
    })
}

/// Writes the table by case, the pictures, the page and the summary; returns the summary.
fn keep(
    sweep: &Sweep,
    rows: &[Row],
    files: &mut SharedFolder,
    account: &Account,
) -> Result<Value, JointError> {
    files.write(TABLE, &table::text(sweep, rows)?)?;
    let (drawings, not_shown) = draw(sweep, rows);
    write_pictures(&drawings, files)?;
    let report = page(sweep, rows, &drawings, &not_shown, account)?.render()?;
    files.write("report.html", report.as_bytes())?;
    let summary = summary(sweep, rows, account);
    files.write(MARKER, format!("{summary:#}\n").as_bytes())?;
    Ok(summary)
}

fn write_pictures(drawings: &[Drawing], files: &mut SharedFolder) -> Result<(), JointError> {
    let drawn = drawings.par_iter().map(|drawing| {
        let png = to_png(&drawing.picture, DEFAULT_SCALE);
        png.map_err(|cause| JointError::Picture {
            name: drawing.name.clone(),
            cause,
        })
    });
    let drawn: Vec<Vec<u8>> = drawn.collect::<Result<_, _>>()?;
    for (drawing, png) in drawings.iter().zip(&drawn) {
        let svg = drawing.picture.as_str().as_bytes();
        files.write(&format!("figures/{}.svg", drawing.name), svg)?;
        files.write(&format!("figures/{}.png", drawing.name), png)?;
    }
    Ok(())
}

fn summary(sweep: &Sweep, rows: &[Row], account: &Account) -> Value {
    let solved = rows.iter().filter(|row| row.measures().is_some()).count();
    json!({
        "format": "stickslip-sweep-summary",
        "format_version": 1,
        "title": sweep.title,
        "sweep_hash": sweep.hash,
        "axes": sweep.axes.iter().map(|axis| axis.key.name()).collect::<Vec<_>>(),
        "cases": sweep.cases(),
        "solved": solved,
        "unresolved": rows.len() - solved,
        "verdict": verdict(sweep, rows),
        "minima": minima(sweep, rows).iter().map(|own| minimum(sweep, own)).collect::<Vec<_>>(),
        "findings": findings(rows),
        "solved_in_this_run": account.solved_now,
        "wall_time_s": account.seconds,
        "workers": account.jobs,
        "bodies_condensed": account.effort.condensed,
    })
}

/// A minimum along an axis, for programs.
fn minimum(sweep: &Sweep, own: &Minimum<'_>) -> Value {
    json!({
        "number": own.number,
        "axis": sweep.axes[own.axis].key.name(),
        "case": own.case,
        "value": own.value[0],
        "error": own.value[1],
        "unit": own.unit,
        "within_error_of_a_neighbour": own.is_open,
    })
}

/// A sweep without a single answer has failed.
fn report(sweep: &Sweep, rows: &[Row]) -> Result<(), JointError> {
    let reason = |row: &Row| match &row.outcome {
        crate::sweep::row::Outcome::Solved(_) => None,
        crate::sweep::row::Outcome::Unresolved(reason) => Some(reason.clone()),
    };
    let reasons: Vec<String> = rows.iter().filter_map(reason).collect();
    match reasons.first() {
        Some(first) if reasons.len() == rows.len() => Err(JointError::Nothing {
            cases: sweep.cases(),
            reason: first.clone(),
        }),
        _ => Ok(()),
    }
}

fn text(sweep: &Sweep, rows: &[Row], folder: &Path, account: &Account) -> String {
    let warning = warning(rows).map_or_else(String::new, |text| format!("warning: {text}\n"));
    format!(
        "{}\n{}\n{warning}{} cases in {:.1} s, {} worker{}, {} bodies condensed\nresults in {}\n",
        sweep.title,
        verdict(sweep, rows),
        account.solved_now,
        account.seconds,
        account.jobs,
        if account.jobs == 1 { "" } else { "s" },
        account.effort.condensed,
        folder.display()
    )
}

fn bar(sweep: &Sweep, done: usize, console: Console) -> ProgressBar {
    if !console.shows_progress() {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{wide_bar} {pos}/{len} cases, {elapsed}, {eta} left");
    let bar = ProgressBar::new(sweep.cases() as u64).with_position(done as u64);
    // The template above is valid; a plain bar would do as well.
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
