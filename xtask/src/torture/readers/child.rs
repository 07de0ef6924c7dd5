//! The process that reads a batch of mutants.

use std::fs;
use std::io::Write as _;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::Path;
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use clap::Args;
use stickslip::diagnostic::SceneError;
use stickslip::experiment::Experiment;
use stickslip::experiment::check::check;
use stickslip::folder::{LIST, Overwrite, ResultFolder};
use stickslip::host::HOST;
use stickslip::limits::Limits;
use stickslip::model::Model;
use stickslip::scene::Scene;
use stickslip::scene::host::Host;
use stickslip::sweep::{Sweep, table};

use super::corpus::{Reader, Target};
use super::mutant;
use crate::publish::TaskError;

/// What a mutant may take: the longest time, and the memory of its models \[byte\], which keeps meshes small.
const LONGEST: Duration = Duration::from_secs(10);
const HOST_OF_MUTANTS: Host = Host {
    limits: Limits {
        memory: 250_000_000,
    },
    ..HOST
};

/// Mutants of a seed, the last one excluded.
#[derive(Debug, Args)]
pub(crate) struct Batch {
    seed: u64,
    first: usize,
    end: usize,
}

/// Where the last panic was.
static PANIC: Mutex<String> = Mutex::new(String::new());

/// Reads the mutants, and says so before and after each.
pub(crate) fn main(batch: &Batch) -> Result<bool, TaskError> {
    std::panic::set_hook(Box::new(|info| {
        let place = info.location().map(ToString::to_string);
        *PANIC.lock().unwrap_or_else(PoisonError::into_inner) = place.unwrap_or_default();
    }));
    let target = Target::of(batch.seed);
    let folder = tempfile::tempdir()?;
    for (name, bytes) in target.files() {
        fs::write(folder.path().join(name), bytes)?;
    }
    let mut out = std::io::stdout().lock();
    for index in batch.first..batch.end {
        let bytes = mutant::of(target, batch.seed, index);
        fs::write(folder.path().join(&target.mutated), &bytes)?;
        writeln!(out, "begin {index}")?;
        out.flush()?;
        let start = Instant::now();
        // What an error says is made where it is asked for, and may panic as well.
        let read = catch_unwind(AssertUnwindSafe(|| read(target, folder.path())));
        let (outcome, found) = match read {
            Err(_) => {
                let place = PANIC.lock().unwrap_or_else(PoisonError::into_inner);
                ("panic", place.clone())
            }
            Ok(_) if start.elapsed() > LONGEST => ("slow", format!("{:?}", start.elapsed())),
            Ok(Read::Whole) => ("read", String::new()),
            Ok(Read::Refused) => ("refused", String::new()),
            Ok(Read::Unclear(found)) => ("unclear", found),
        };
        writeln!(out, "end {index} {outcome} {}", found.escape_debug())?;
        out.flush()?;
    }
    Ok(true)
}

/// What became of a mutant.
enum Read {
    Whole,
    /// With an error that says what it should.
    Refused,
    Unclear(String),
}

/// Reads as the command does, and builds what the command would before it solves.
fn read(target: &Target, folder: &Path) -> Read {
    let of = |outcome: Result<(), SceneError>| match outcome {
        Ok(()) => Read::Whole,
        Err(error) => lacks(target, &error).map_or(Read::Refused, Read::Unclear),
    };
    match target.reader {
        Reader::Scene => of(scene(&folder.join(target.main()))),
        Reader::Sweep => of(sweep(&folder.join(target.main()))),
        Reader::Experiment => of(experiment(&folder.join(target.main()))),
        Reader::Rows => rows(folder),
        Reader::Owned => owned(folder),
    }
}

const NONE: [&str; 0] = [];

fn scene(path: &Path) -> Result<(), SceneError> {
    let scene = Scene::from_file(path, &NONE, HOST_OF_MUTANTS)?;
    // The command gives errors of the model a place by rules that are tested there.
    let _ = Model::build(&scene);
    Ok(())
}

fn sweep(path: &Path) -> Result<(), SceneError> {
    let sweep = Sweep::from_file(path, &NONE, HOST_OF_MUTANTS)?;
    let _ = Model::build(&sweep.scene);
    Ok(())
}

fn experiment(path: &Path) -> Result<(), SceneError> {
    let experiment = Experiment::from_file(path, &NONE, HOST_OF_MUTANTS)?;
    check(&experiment).map_err(|error| error.located(&experiment))?;
    Ok(())
}

/// The table that a sweep goes on with.
fn rows(folder: &Path) -> Read {
    let Ok(sweep) = Sweep::from_file(&folder.join("main.toml"), &NONE, HOST_OF_MUTANTS) else {
        return Read::Unclear("the sweep itself is refused".to_owned());
    };
    let bytes = fs::read(folder.join("cases.csv")).unwrap_or_default();
    let Ok(text) = String::from_utf8(bytes) else {
        return Read::Refused;
    };
    match table::read(&sweep, &text) {
        Ok(rows) if rows.iter().all(|row| row.case < sweep.cases()) => Read::Whole,
        Ok(_) => Read::Unclear("a row of no case was read".to_owned()),
        // The command prints it as printable text.
        Err(error) if error.to_string().contains("table") => Read::Refused,
        Err(error) => Read::Unclear(error.to_string()),
    }
}

/// The list of a folder's files, by which it may be replaced: somebody else's file stays, whatever the list says.
fn owned(folder: &Path) -> Read {
    const OTHERS: [&str; 2] = ["notes.txt", "deep/notes.txt"];
    let list = fs::read(folder.join("list")).unwrap_or_default();
    let said = String::from_utf8_lossy(&list).into_owned();
    let target = folder.join("results");
    let replaced = || -> Result<(), TaskError> {
        fs::create_dir_all(target.join("deep"))?;
        for name in ["summary.json", "steps.csv"].into_iter().chain(OTHERS) {
            fs::write(target.join(name), "{}")?;
        }
        fs::write(target.join(LIST), &list)?;
        let force = Overwrite::Force(|_| None);
        ResultFolder::create(&target, force)?.finish("{}")?;
        Ok(())
    };
    let outcome = replaced();
    let lost = |name: &str| !target.join(name).exists() && !said.lines().any(|line| line == name);
    let found = OTHERS.into_iter().find(|name| lost(name));
    let left = fs::remove_dir_all(&target);
    match (found, outcome, left) {
        (Some(name), ..) => Read::Unclear(format!("{name} is lost")),
        (None, Ok(()), Ok(())) => Read::Whole,
        (None, Err(error), Ok(())) if error.to_string().contains("results") => Read::Refused,
        (None, outcome, left) => Read::Unclear(format!("{outcome:?} {left:?}")),
    }
}

fn has_controls(text: &str) -> bool {
    text.chars()
        .any(|letter| letter.is_control() && letter != '\n' && letter != '\t')
}

/// What an error should say and does not.
fn lacks(target: &Target, error: &SceneError) -> Option<String> {
    let text = error.render(100, false);
    if has_controls(&text) {
        return Some(format!("control characters: {text}"));
    }
    for finding in error.findings() {
        let said = finding.summary();
        let what = if said.message.trim().is_empty() {
            "no message"
        } else if said.help.as_deref().unwrap_or_default().trim().is_empty() {
            "no remedy"
        } else if said.source.as_deref().unwrap_or_default().is_empty() {
            "no file"
        } else if said.line.is_none() && !said.message.contains(target.main()) {
            "no line"
        } else {
            continue;
        };
        return Some(format!("{what}: {}", said.message));
    }
    None
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::torture::readers::corpus::TARGETS;

    #[test]
    fn what_is_mutated_is_read_itself() {
        // The folder of the list holds files of others, and is refused.
        let targets = TARGETS.iter();
        for target in targets.filter(|target| target.reader != Reader::Owned) {
            for choice in 0..4 {
                let folder = tempfile::tempdir().unwrap();
                let mut files = target.files();
                files.push((target.mutated.as_str(), mutant::unchanged(target, choice)));
                for (name, bytes) in files {
                    fs::write(folder.path().join(name), bytes).unwrap();
                }
                let found = read(target, folder.path());
                assert!(matches!(found, Read::Whole), "{}", target.name);
                let path = folder.path().join(target.main());
                let scene = match target.reader {
                    Reader::Scene => Scene::from_file(&path, &NONE, HOST_OF_MUTANTS).unwrap(),
                    Reader::Sweep => {
                        let sweep = Sweep::from_file(&path, &NONE, HOST_OF_MUTANTS);
                        sweep.unwrap().scene
                    }
                    _ => continue,
                };
                Model::build(&scene).unwrap();
            }
        }
    }
}
