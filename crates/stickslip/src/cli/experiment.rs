//! `stickslip fringes`, `reduce`, `hybrid` and `identify`: an experiment to one depth of its chain.

use std::path::PathBuf;

use clap::Args;
use miette::Diagnostic;
use stickslip_report::folder::{FolderError, Overwrite, ResultFolder};
use thiserror::Error;

use super::console::Console;
use super::failure::Failure;
use super::interrupt::guarded;
use super::run::located;
use crate::experiment::chain::{Depth, tell};
use crate::experiment::story::StoryError;
use crate::experiment::{Experiment, ExperimentError};

#[derive(Debug, Args)]
pub(super) struct ExperimentArguments {
    /// Experiment file: TOML, or JSON if its name ends in .json
    experiment: PathBuf,
    /// Folder for the results; by default the experiment's name with -results
    #[arg(long, value_name = "DIR")]
    output: Option<PathBuf>,
    /// Replace results that are in the folder already, once the new ones are complete
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
            "name a folder with --output DIR; it is made if it does not exist, and --force replaces results that are there already"
        )
    )]
    Folder(#[from] FolderError),
    #[error(transparent)]
    #[diagnostic(code(experiment::output))]
    Story(#[from] StoryError),
}

/// Goes through the chain to `depth`. The folder is made first, so that a long chain does not end in front of a closed door.
pub(super) fn experiment(
    arguments: &ExperimentArguments,
    depth: Depth,
    console: Console,
) -> Result<(), Failure> {
    let experiment = Experiment::from_file(&arguments.experiment, &arguments.overrides)?;
    let overwrite = if arguments.force {
        Overwrite::Force
    } else {
        Overwrite::Refuse
    };
    let path = arguments.folder();
    let folder =
        guarded(console, || ResultFolder::create(&path, overwrite)).map_err(KeepError::from)?;
    let story = tell(&experiment, depth, &mut |_| ()).map_err(|error| match &error {
        ExperimentError::Run(cause) => match &experiment.specimen.scene {
            Some(own) => located(&own.scene, cause),
            None => error.located(&experiment),
        },
        _ => error.located(&experiment),
    })?;
    let (answers, summary) = (story.text_answers(), story.summary());
    let path = story.write(folder).map_err(KeepError::from)?;
    let text = || format!("{answers}\nresults in {}\n", path.display());
    console.result(text, &summary)
}

impl ExperimentArguments {
    fn folder(&self) -> PathBuf {
        let default = || {
            let stem = self.experiment.file_stem().unwrap_or_default();
            PathBuf::from(format!("{}-results", stem.to_string_lossy()))
        };
        self.output.clone().unwrap_or_else(default)
    }
}
