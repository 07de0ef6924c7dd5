//! `stickslip fringes`, `reduce`, `hybrid` and `identify`: an experiment to one depth of its chain.

use std::path::{Path, PathBuf};
use std::time::Duration;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use miette::Diagnostic;
use serde_json::json;
use thiserror::Error;

use super::console::Console;
use super::failure::{CommandError, Failure, OwnError};
use super::folder::{Owner, prepare, results_folder};
use super::located::located;
use super::memory::host;
use crate::folder::FolderError;
use crate::keep;
use stickslip_engine::run::Progress;
use stickslip_experiment::Experiment;
use stickslip_experiment::RegionShape;
use stickslip_experiment_pages::report;
use stickslip_measure::ExperimentError;
use stickslip_measure::chain::Depth;
use stickslip_scene::Format;
use stickslip_scene::diagnostic::{SceneError, SourceText};
use stickslip_scene::document::Document;
use stickslip_scene::limits::Content;

#[derive(Debug, Args)]
pub(super) struct ExperimentArguments {
    /// Experiment file: TOML, or JSON if its name ends in .json
    experiment: PathBuf,
    /// Folder for the results; by default the experiment's name with -results
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace results that are in the folder already, once the new ones are complete; other files in it are named and nothing is replaced
    #[arg(long)]
    force: bool,
    /// Set any key of the experiment, for example --set fringes.pixel="0.05 mm" or --set states.0.step=3
    #[arg(long = "set", value_name = "KEY=VALUE")]
    overrides: Vec<String>,
}

/// The results cannot be kept.
#[derive(Debug, Error, Diagnostic)]
enum KeepError {
    #[error(transparent)]
    #[diagnostic(
        code(experiment::folder),
        help(
            "name a folder with --output DIR; it is made if it does not exist, and --force replaces results that are there already, but no \
             files of others"
        )
    )]
    Folder(#[from] FolderError),
    #[error(transparent)]
    #[diagnostic(code(experiment::output))]
    Report(keep::KeepError),
}

impl OwnError for KeepError {}

impl From<keep::KeepError> for KeepError {
    fn from(error: keep::KeepError) -> Self {
        match error {
            keep::KeepError::Folder(error) => Self::Folder(error),
            other => Self::Report(other),
        }
    }
}

/// Goes through the chain to `depth`. The folder is made first, so that a long chain does not end in front of a closed door.
pub(super) fn experiment(
    arguments: &ExperimentArguments,
    depth: Depth,
    console: Console,
) -> Result<(), Failure> {
    let path = arguments.experiment.display().to_string();
    match kind_of(&arguments.experiment) {
        Some(Kind::Scene) => return Err(CommandError::SceneGiven { path }.into()),
        Some(Kind::Sweep) => return Err(CommandError::SweepGiven { path }.into()),
        Some(Kind::Experiment) | None => {}
    }
    let experiment = Experiment::from_file(&arguments.experiment, &arguments.overrides, host())?;
    let path = results_folder(arguments.output.as_ref(), &arguments.experiment);
    keep_apart(&experiment, &arguments.experiment, &path)?;
    let folder =
        prepare(&path, arguments.force, Owner::Experiment, console).map_err(KeepError::from)?;
    let bar = bar(console);
    let found = report(&experiment, depth, folder.path(), &mut |progress| {
        show(&bar, progress);
    });
    bar.finish_and_clear();
    let report = found.map_err(|error| at_its_line(&experiment, &error))?;
    let (answers, summary) = (report.text_answers(), report.summary());
    let path = keep::report(report, folder).map_err(KeepError::from)?;
    let text = || format!("{answers}\nresults in {}\n", path.display());
    console.result(text, &summary)
}

/// Refuses a folder for results that holds a file from which the experiment is read: results replace what is in their folder.
fn keep_apart(experiment: &Experiment, file: &Path, folder: &Path) -> Result<(), CommandError> {
    // What does not exist yet holds nothing.
    let Ok(whole) = folder.canonicalize() else {
        return Ok(());
    };
    let specimen = [&experiment.specimen.scene, &experiment.specimen.model];
    let scenes = specimen.into_iter().flatten();
    let scenes = scenes.map(|own| PathBuf::from(&own.scene.source_name));
    let mesh = match experiment.region.as_ref().map(|region| &region.shape) {
        Some(RegionShape::Mesh(mesh)) => Some(mesh.file.clone()),
        _ => None,
    };
    let data = (experiment.states.iter())
        .flat_map(|state| {
            [
                Some(&state.source),
                state.null.as_ref(),
                state.back.as_ref(),
            ]
        })
        .flatten()
        .flat_map(|source| source.files().into_iter().map(Path::to_owned));
    let mut read = [file.to_owned()]
        .into_iter()
        .chain(scenes)
        .chain(mesh)
        .chain(data);
    let inside = |path: &PathBuf| path.canonicalize().is_ok_and(|own| own.starts_with(&whole));
    match read.find(inside) {
        Some(own) => Err(CommandError::ResultsOverData {
            folder: folder.display().to_string(),
            file: own.display().to_string(),
        }),
        None => Ok(()),
    }
}

/// What shows how far the chain is, on a terminal.
fn bar(console: Console) -> ProgressBar {
    /// Between two turns of the sign of life.
    const TURN: Duration = Duration::from_millis(120);
    if !console.shows_progress() {
        return ProgressBar::hidden();
    }
    let bar = ProgressBar::new_spinner();
    bar.enable_steady_tick(TURN);
    bar
}

/// A phase turns until its first step is done, and then has a bar.
fn show(bar: &ProgressBar, progress: Progress) {
    let template = match progress {
        Progress::Phase(phase) => {
            bar.set_message(phase);
            "{spinner} {msg:16} {elapsed}"
        }
        Progress::Step { done, total } => {
            bar.set_position(done as u64);
            bar.set_length(total as u64);
            "{spinner} {msg:16} {wide_bar} {pos}/{len}, {elapsed}"
        }
    };
    // The templates above are valid; a plain spinner would do as well.
    let style = ProgressStyle::with_template(template);
    bar.set_style(style.unwrap_or_else(|_| ProgressStyle::default_spinner()));
}

/// The error at its line, in the experiment or in its scene.
fn at_its_line(experiment: &Experiment, error: &ExperimentError) -> SceneError {
    match (error, &experiment.specimen.scene) {
        (ExperimentError::Run(cause), Some(own)) => located(&own.scene, cause),
        _ => error.located(experiment),
    }
}

/// What a file is by its tables.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Kind {
    Scene,
    Experiment,
    Sweep,
}

/// What a file is, if it can be read so far.
pub(super) fn kind_of(path: &Path) -> Option<Kind> {
    let source = SourceText {
        name: String::new(),
        text: host().read_text(path, Content::Document).ok()?,
    };
    let document = Document::parse(source, Format::of_path(path)).ok()?;
    let has = |key: &str| document.root.get(key).is_some();
    if has("specimen") {
        Some(Kind::Experiment)
    } else if has("bodies") {
        Some(Kind::Scene)
    } else if has("scene") && has("axes") {
        Some(Kind::Sweep)
    } else {
        None
    }
}

/// Checks an experiment: what it says, its data files, that they cover its region, and that this can be analysed.
pub(super) fn check(path: &Path, overrides: &[String], console: Console) -> Result<(), Failure> {
    let experiment = Experiment::from_file(path, overrides, host())?;
    let refuse = |error: ExperimentError| at_its_line(&experiment, &error);
    let checked = stickslip_experiment_pages::check::check(&experiment).map_err(refuse)?;
    let text = || {
        let line = |(name, text): &(&str, String)| format!("{name:10} {text}");
        let lines: Vec<String> = checked.lines.iter().map(line).collect();
        lines.join("\n") + "\n"
    };
    let lines: Vec<_> = (checked.lines.iter())
        .map(|(name, text)| json!({ "what": name, "text": text }))
        .collect();
    let summary = json!({
        "experiment": experiment.source_name,
        "title": experiment.title,
        "hash": experiment.hash,
        "checked": lines,
        "findings": checked.findings,
    });
    console.result(text, &summary)
}
