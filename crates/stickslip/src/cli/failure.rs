//! Why a command fails.

use miette::Diagnostic;
use thiserror::Error;

use stickslip_scene::diagnostic::{FindingSummary, SceneError, render};

/// A failure outside the scene.
#[derive(Debug, Error, Diagnostic)]
pub(super) enum CommandError {
    /// `init` does not overwrite.
    #[error("the file '{path}' exists already")]
    #[diagnostic(
        code(init::exists),
        help("name another file: stickslip init {template} my-scene.toml")
    )]
    FileExists { path: String, template: String },
    /// There is no such template.
    #[error("there is no template '{name}'")]
    #[diagnostic(code(init::template), help("templates: {}", known.join(", ")))]
    UnknownTemplate { name: String, known: Vec<String> },
    /// `init` writes no such files.
    #[error("'{path}' ends in .{extension}, and templates are written as TOML or JSON")]
    #[diagnostic(
        code(init::format),
        help(
            "name the file .toml, or .json for one without comments: stickslip init {template} {instead}"
        )
    )]
    TemplateFormat {
        path: String,
        extension: String,
        template: String,
        instead: String,
    },
    /// A file cannot be written.
    #[error("the file '{path}' cannot be written: {cause}")]
    #[diagnostic(
        code(init::write),
        help("check that its folder exists and can be written to")
    )]
    Write { path: String, cause: String },
    /// A sketch cannot be drawn or written.
    #[error("the sketch '{path}' was not written: {cause}")]
    #[diagnostic(
        code(check::sketch),
        help("name a new file, such as --sketch scene.svg; files that exist are not replaced")
    )]
    Sketch { path: String, cause: String },
    /// Results would replace what they are made from.
    #[error(
        "the folder '{folder}' holds '{file}', which the experiment reads: results cannot be written over it"
    )]
    #[diagnostic(
        code(experiment::output),
        help("name another folder with --output DIR; it may be inside of '{folder}'")
    )]
    ResultsOverData { folder: String, file: String },
    /// A scene where an experiment is asked for.
    #[error("'{path}' is a scene, not an experiment")]
    #[diagnostic(
        code(experiment::scene),
        help(
            "`stickslip run {path}` solves it; an experiment names it by [specimen] scene = \"…\", and `stickslip init experiment` writes one"
        )
    )]
    SceneGiven { path: String },
    /// A scene where a sweep is asked for.
    #[error("'{path}' is a scene, not a sweep")]
    #[diagnostic(
        code(joint::scene),
        help(
            "`stickslip run {path}` solves it; a sweep names it by scene = \"…\" and varies its keys along [[axes]], see docs/joint-sweeps.md"
        )
    )]
    SceneForSweep { path: String },
    /// An experiment where a scene is asked for.
    #[error("'{path}' is an experiment, not a scene")]
    #[diagnostic(
        code(run::experiment),
        help(
            "`stickslip reduce {path}` makes its measured fields, `stickslip hybrid` edge stresses too, `stickslip identify` friction too; \
             `stickslip check` checks it"
        )
    )]
    ExperimentGiven { path: String },
    /// A sweep where a scene or an experiment is asked for.
    #[error("'{path}' is a sweep: it varies a scene")]
    #[diagnostic(
        code(run::sweep),
        help(
            "`stickslip joint {path}` solves its cases; `stickslip check` and `stickslip run` take its scene"
        )
    )]
    SweepGiven { path: String },
    /// Arguments that make no sense.
    #[error("{message}")]
    #[diagnostic(code(command::usage), help("{usage}"))]
    Usage { message: String, usage: String },
    /// A signal before the results were complete.
    #[error("interrupted; nothing was written")]
    #[diagnostic(code(run::interrupted))]
    Interrupted,
    /// A signal when the results were complete.
    #[error("interrupted; the results were complete")]
    #[diagnostic(code(run::interrupted))]
    InterruptedLate,
    /// Standard output cannot be written.
    #[error("the output cannot be written: {cause}")]
    #[diagnostic(code(output::write))]
    Output { cause: String },
}

impl CommandError {
    /// A refusal of the arguments: its first paragraph is the message, the others say what would do.
    pub(super) fn usage(refusal: &clap::Error) -> Self {
        let text = refusal.to_string();
        let (message, usage) = text.trim().split_once("\n\n").unwrap_or((text.trim(), ""));
        Self::Usage {
            message: message.trim_start_matches("error: ").to_owned(),
            usage: usage.to_owned(),
        }
    }
}

/// Why a command fails.
#[derive(Debug)]
pub(super) enum Failure {
    /// Something is wrong with the scene.
    Scene(SceneError),
    /// Something else is wrong.
    Other(Box<dyn Diagnostic + Send + Sync>),
}

impl From<SceneError> for Failure {
    fn from(error: SceneError) -> Self {
        Self::Scene(error)
    }
}

/// An error of the command itself, not of a scene.
pub(super) trait OwnError: Diagnostic + Send + Sync + 'static {}

impl OwnError for CommandError {}

impl<E: OwnError> From<E> for Failure {
    fn from(error: E) -> Self {
        Self::Other(Box::new(error))
    }
}

impl Failure {
    /// The failure as text for people.
    pub(super) fn render(&self, width: usize, colours: bool) -> String {
        match self {
            Self::Scene(error) => error.render(width, colours),
            Self::Other(error) => render(error.as_ref(), width, colours),
        }
    }

    /// The failure for programs.
    pub(super) fn summaries(&self) -> Vec<FindingSummary> {
        match self {
            Self::Scene(error) => error
                .findings()
                .iter()
                .map(stickslip_scene::diagnostic::Finding::summary)
                .collect(),
            Self::Other(error) => vec![FindingSummary {
                code: error.code().map(|code| code.to_string()),
                message: error.to_string(),
                help: error.help().map(|help| help.to_string()),
                source: None,
                line: None,
                column: None,
                key: None,
            }],
        }
    }
}
