//! `stickslip run`: solve a scene and write a folder of results.

use std::io::IsTerminal;
use std::path::PathBuf;

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use miette::Diagnostic;
use stickslip_contact::ContactError;
use stickslip_report::folder::FolderError;
use thiserror::Error;

use super::SceneArguments;
use super::console::Console;
use super::experiment::{Kind, kind_of};
use super::failure::{CommandError, Failure};
use super::folder::{Owner, prepare};
use super::located::locate;
use crate::diagnostic::{SceneError, SceneProblem};
use crate::output;
use crate::results::LoadValue;
use crate::run::{Progress, RunError, loads_reached, quoted, run as solve};
use crate::scene::Scene;

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
    Output(#[from] output::OutputError),
}

/// Solves the scene. The folder is made first, so that a long run does not end in front of a closed door.
pub(super) fn run(arguments: &RunArguments, console: Console) -> Result<(), Failure> {
    if kind_of(&arguments.scene.scene) == Some(Kind::Experiment) {
        let path = arguments.scene.scene.display().to_string();
        return Err(CommandError::ExperimentGiven { path }.into());
    }
    let scene = arguments.scene.read()?;
    let folder = prepare(&arguments.folder(), arguments.force, Owner::Run, console)
        .map_err(KeepError::from)?;
    let bar = bar(&scene, console);
    let solved = solve(&scene, &mut |progress| show(&bar, progress));
    bar.finish_and_clear();
    let results = solved.map_err(|error| located(&scene, &error))?;
    let path = output::write(&results, folder, scene.output.figures).map_err(KeepError::from)?;
    // As large as the results of a long history: made for those who read it only.
    let summary = console.json.then(|| output::summary_json(&results));
    console.result(
        || {
            format!(
                "{}\nresults in {}\n",
                output::summary_table(&results, Console::width()),
                path.display()
            )
        },
        &summary,
    )
}

impl RunArguments {
    fn folder(&self) -> PathBuf {
        let default = || {
            let stem = self
                .scene
                .scene
                .file_stem()
                .unwrap_or_default()
                .to_string_lossy();
            PathBuf::from(format!("{stem}-results"))
        };
        self.output.clone().unwrap_or_else(default)
    }
}

fn bar(scene: &Scene, console: Console) -> ProgressBar {
    if console.quiet
        || console.json
        || scene.steps() < LONG_HISTORY
        || !std::io::stderr().is_terminal()
    {
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

/// The names of `bodies`. A model numbers its bodies in the order of their names.
fn names<'a>(scene: &'a Scene, bodies: &[usize]) -> Vec<&'a str> {
    let all: Vec<&String> = scene.bodies.keys().collect();
    let own = bodies.iter().filter_map(|&body| all.get(body));
    own.map(|name| name.as_str()).collect()
}

/// Indices of the loads that act on `bodies`; all where these are all bodies.
fn loads_on(scene: &Scene, bodies: &[usize]) -> Vec<usize> {
    let names = names(scene, bodies);
    let loads = scene.loads.iter().enumerate();
    loads
        .filter(|(_, load)| bodies.is_empty() || names.contains(&load.kind.body()))
        .map(|(index, _)| index)
        .collect()
}

/// Indices of the supports that move on `bodies`; all where these are all bodies.
fn drives_on(scene: &Scene, bodies: &[usize]) -> Vec<usize> {
    let names = names(scene, bodies);
    let moving = (scene.supports.iter().enumerate()).filter(|(_, held)| held.displacement != 0.0);
    moving
        .filter(|(_, held)| bodies.is_empty() || names.contains(&held.on.body.as_str()))
        .map(|(index, _)| index)
        .collect()
}

/// The key of what drives a history that came to an end for `bodies`: its load or all loads, or where it has none the support that moves.
fn key_of_drive(scene: &Scene, bodies: &[usize]) -> String {
    let loads = loads_on(scene, bodies);
    match (&loads[..], &drives_on(scene, bodies)[..]) {
        ([only], _) => format!("loads.{only}"),
        ([], [only]) => format!("supports.{only}"),
        ([], [_, ..]) => "supports".to_owned(),
        _ => "loads".to_owned(),
    }
}

/// ", for 'pin' and 'plate'", if these are not all bodies.
fn among(scene: &Scene, bodies: &[usize]) -> String {
    let quoted = quoted(names(scene, bodies).into_iter());
    if quoted.is_empty() {
        quoted
    } else {
        format!(", for {quoted}")
    }
}

/// The error in words, with the load that a history reached.
fn message(scene: &Scene, error: &RunError) -> String {
    let RunError::Contact(ContactError::StepFailed {
        step,
        reached,
        bodies,
        cause,
    }) = error
    else {
        return error.to_string();
    };
    let reached_loads = loads_reached(scene, *step, *reached);
    let acting = loads_on(scene, bodies);
    let loads: Vec<&LoadValue> = acting.iter().map(|&index| &reached_loads[index]).collect();
    if loads.is_empty() {
        return error.to_string();
    }
    let value = |load: &&LoadValue| {
        let unit = if load.unit == "1" { "" } else { &load.unit };
        let text = format!("{} {} {unit}", load.name, output::short(load.value));
        text.trim_end().to_owned()
    };
    let loads: Vec<String> = loads.iter().map(value).collect();
    format!(
        "load step {} was not solved beyond {}, {reached:.4} of its increment{}{}: {cause}",
        step + 1,
        loads.join(", "),
        among(scene, bodies),
        if cause.is_unresolved() {
            " and is unresolved"
        } else {
            ""
        }
    )
}

/// The error at the key of the scene that it is about.
pub(super) fn located(scene: &Scene, error: &RunError) -> SceneError {
    let (key, remedy) = match error {
        RunError::Model(error) => return locate(scene, error),
        RunError::Body { body, .. } => (
            format!("bodies.{body}"),
            "check the body's supports: it must not be able to move as a whole without contact",
        ),
        RunError::Contact(ContactError::StepFailed { cause, bodies, .. })
            if cause.is_proved_impossible() =>
        {
            (
                key_of_drive(scene, bodies),
                "no contact force can balance this load: let its line of action pass through the contact (beside it, it turns the body), add \
                 friction or a support against the motion, or turn the load",
            )
        }
        RunError::Contact(ContactError::StepFailed { bodies, .. }) => (
            key_of_drive(scene, bodies),
            "take smaller steps (--set analysis.substeps=4) or another solver (--set analysis.solver=pivoting)",
        ),
        RunError::Contact(_) => (
            "loads".to_owned(),
            "take smaller steps (--set analysis.substeps=4) or another solver (--set analysis.solver=pivoting)",
        ),
        RunError::Failure { .. } => (
            "failure".to_owned(),
            "ask with other criteria or without failure.envelopes, or check the strengths of the plies",
        ),
        RunError::Progressive { .. } => (
            "failure.progressive".to_owned(),
            "take smaller increments, a coarser mesh, or hold the bodies so that no load moves them freely",
        ),
        _ => ("mesh".to_owned(), "change the mesh settings"),
    };
    let problem = SceneProblem::Model {
        message: message(scene, error),
        remedy: remedy.to_owned(),
    };
    scene.error_at(&key, problem)
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::key_of_drive;
    use crate::scene::{Format, Scene};

    /// Two cylinders on blocks: one is loaded, the other, the second of its supports, is driven.
    #[test]
    fn the_key_is_that_of_what_drives_the_bodies() {
        let body = |name: &str, shape: &str| {
            format!("[bodies.{name}]\nmaterial = \"metal\"\nthickness = \"1 mm\"\nshape.{shape}\n")
        };
        let block = "block = { half_length = \"12 mm\", depth = \"12 mm\" }";
        let roller =
            "cylinder = { radius = \"50 mm\", half_length = \"12 mm\", depth = \"12 mm\" }";
        let contact = |first: &str, second: &str| {
            format!(
                "[[contacts]]\nfirst = \"{first}.contact\"\nsecond = \"{second}.contact\"\nfriction.coulomb = {{ mu = 0.4 }}\n"
            )
        };
        let support = |on: &str, fix: &str, more: &str| {
            format!("[[supports]]\non = \"{on}\"\nfix = [{fix}]\n{more}")
        };
        let text = [
            "version = 1\n[materials.metal.isotropic]\nyoung = \"70 GPa\"\npoisson = 0.33\n",
            &body("block", block),
            &body("roller", roller),
            &body("slab", block),
            &body("wheel", roller),
            "[mesh]\nspacing = \"1 mm\"\n",
            &contact("roller", "block"),
            &contact("wheel", "slab"),
            &support("block.bottom", "\"x\", \"y\"", ""),
            &support("slab.bottom", "\"x\", \"y\"", ""),
            &support("wheel.top", "\"x\"", ""),
            &support("wheel.top", "\"y\"", "displacement = \"-0.01 mm\"\n"),
            "[[platens]]\non = \"roller.top\"\nfree = [\"x\", \"y\"]\n",
            "[[loads]]\non = \"roller.top\"\nforce = { direction = [0, -1], steps = [\"300 N\"] }\n",
        ]
        .concat();
        let nothing: [&str; 0] = [];
        let scene =
            Scene::from_text(&text, Format::Toml, "lines.toml", Path::new("."), &nothing).unwrap();
        // Bodies are numbered by name: block, roller, slab, wheel.
        assert_eq!(key_of_drive(&scene, &[0, 1]), "loads.0");
        assert_eq!(key_of_drive(&scene, &[2, 3]), "supports.3");
        assert_eq!(key_of_drive(&scene, &[]), "loads.0");
    }
}
