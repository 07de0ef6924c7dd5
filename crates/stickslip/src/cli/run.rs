//! `stickslip run`: solve a scene and write a folder of results.

use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use miette::Diagnostic;
use thiserror::Error;

use super::SceneArguments;
use super::console::Console;
use super::experiment::{Kind, kind_of};
use super::failure::{CommandError, Failure, OwnError};
use super::folder::{Owner, prepare, results_folder};
use super::located::located;
use crate::folder::FolderError;
use crate::keep;
use stickslip_engine::run::Progress;
use stickslip_ladder::run as solve;
use stickslip_present::results::{self as output, sentences};
use stickslip_scene::Scene;

/// Histories with fewer steps are over before a bar helps.
const LONG_HISTORY: usize = 5;

#[derive(Debug, Args)]
pub(super) struct RunArguments {
    #[command(flatten)]
    scene: SceneArguments,
    /// Folder for the results; by default the scene's name with -results
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace results that are in the folder already, once the new ones are complete; other files in it are named and nothing is replaced
    #[arg(long)]
    force: bool,
}

/// The results cannot be kept.
#[derive(Debug, Error, Diagnostic)]
enum KeepError {
    #[error(transparent)]
    #[diagnostic(
        code(run::folder),
        help(
            "name a folder with --output DIR; it is made if it does not exist, and --force replaces results that are there already, but no \
             files of others"
        )
    )]
    Folder(#[from] FolderError),
    #[error(transparent)]
    #[diagnostic(
        code(run::output),
        help("`--set output.figures=false --set output.fields=none` writes tables only")
    )]
    Output(keep::KeepError),
}

impl OwnError for KeepError {}

impl From<keep::KeepError> for KeepError {
    fn from(error: keep::KeepError) -> Self {
        match error {
            keep::KeepError::Folder(error) => Self::Folder(error),
            other => Self::Output(other),
        }
    }
}

/// Solves the scene. The folder is made first, so that a long run does not end in front of a closed door.
pub(super) fn run(arguments: &RunArguments, console: Console) -> Result<(), Failure> {
    let path = arguments.scene.scene.display().to_string();
    match kind_of(&arguments.scene.scene) {
        Some(Kind::Experiment) => return Err(CommandError::ExperimentGiven { path }.into()),
        Some(Kind::Sweep) => return Err(CommandError::SweepGiven { path }.into()),
        Some(Kind::Scene) | None => {}
    }
    let scene = arguments.scene.read()?;
    let path = results_folder(arguments.output.as_ref(), &arguments.scene.scene);
    let folder = prepare(&path, arguments.force, Owner::Run, console).map_err(KeepError::from)?;
    let bar = bar(&scene, console);
    let solved = solve(&scene, &mut |progress| show(&bar, progress));
    bar.finish_and_clear();
    let results = solved.map_err(|error| located(&scene, &error))?;
    let path = keep::results(&results, folder, scene.output.figures).map_err(KeepError::from)?;
    let table = output::summary_table(&results, Console::width())
        .map_err(|error| KeepError::Output(error.into()))?;
    let warnings: String = (sentences(&results).iter())
        .map(|sentence| ["warning: ", sentence, "\n\n"].concat())
        .collect();
    let unstated = match results.ladder {
        Some(_) => "",
        None => unstated(&scene),
    };
    // As large as the results of a long history: made for those who read it only.
    let summary = console.json.then(|| output::summary_json(&results));
    let summary = (summary.transpose()).map_err(|error| KeepError::Output(error.into()))?;
    console.result(
        || {
            format!(
                "{table}\n{warnings}{unstated}results in {}\n",
                path.display()
            )
        },
        &summary,
    )
}

/// That no errors are stated, and how to get them.
fn unstated(scene: &Scene) -> &'static str {
    let mut bodies = scene.bodies.values();
    if bodies.any(|body| body.shape.has_own_mesh()) {
        return "No errors are stated: of a mesh from a file none are known; run a finer file beside it.\n\n";
    }
    "No errors are stated: `--set analysis.accuracy=\"1 %\"` states those of this mesh; a scene without [mesh] is divided until they are as small.\n\n"
}

fn bar(scene: &Scene, console: Console) -> ProgressBar {
    if !console.shows_progress() || scene.steps() < LONG_HISTORY {
        return ProgressBar::hidden();
    }
    let style = ProgressStyle::with_template("{msg:14} {wide_bar} {pos}/{len} steps, {elapsed}");
    let bar = ProgressBar::new(scene.steps() as u64);
    // The template above is valid; a plain bar would do as well.
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}

fn show(bar: &ProgressBar, progress: Progress) {
    match progress {
        Progress::Phase(phase) => bar.set_message(phase),
        Progress::Step { done, total } => {
            bar.set_length(total as u64);
            bar.set_position(done as u64);
        }
    }
}
