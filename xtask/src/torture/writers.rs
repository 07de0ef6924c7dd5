//! Faults at the system calls of every writer: no room, failing devices, missing rights, and `kill -9`.
//!
//! A seed chooses a command and one of the system calls on files that it makes; `strace` injects a fault there. Whatever the fault,
//! results are the old ones or the new ones, files of others stay, and the same command succeeds afterwards and leaves nothing behind.

mod command;
mod fault;
mod files;
mod prepared;
mod said;

use said::said;
use std::path::Path;
use std::process::Output;
use std::sync::OnceLock;

use super::trial::{Demand, Failure, Kind, Trial, demands};
use command::{Old, WRITERS, Writer, run};
use fault::Fault;
use files::{Contents, contents, write_all};
use prepared::Prepared;

/// The kind of trial.
pub(super) struct Writers;

impl Kind for Writers {
    fn name(&self) -> &'static str {
        "writers"
    }

    fn quick(&self) -> std::ops::Range<u64> {
        0..2 * WRITERS.len() as u64
    }

    fn lacks(&self) -> Option<String> {
        fault::lacks()
    }

    fn trial(&self, seed: u64) -> Trial {
        let index = (seed % WRITERS.len() as u64) as usize;
        let writer = &WRITERS[index];
        let prepared = match prepared(index) {
            Ok(prepared) => prepared,
            Err(cause) => return untried(seed, writer, cause),
        };
        let fault = Fault::of(seed, &prepared.calls);
        match tried(writer, prepared, &fault) {
            Ok(found) => counted(seed, writer, &fault, &found),
            Err(cause) => untried(seed, writer, &cause.to_string()),
        }
    }
}

/// What a writer needs and makes, found once for all trials.
fn prepared(index: usize) -> Result<&'static Prepared, &'static str> {
    static ALL: [OnceLock<Result<Prepared, String>>; WRITERS.len()] =
        [const { OnceLock::new() }; WRITERS.len()];
    let prepared =
        ALL[index].get_or_init(|| Prepared::of(&WRITERS[index]).map_err(|cause| cause.to_string()));
    prepared.as_ref().map_err(String::as_str)
}

/// What became of a fault.
struct Found {
    outcome: &'static str,
    failed: Vec<(&'static str, String)>,
}

fn tried(writer: &Writer, prepared: &Prepared, fault: &Fault) -> std::io::Result<Found> {
    let home = tempfile::tempdir()?;
    write_all(home.path(), &prepared.before)?;
    let output = fault.injected(writer, home.path())?;
    let then = contents(home.path())?;
    let mut failed = Vec::new();
    let mut check = |name, outcome: Result<(), String>| {
        if let Err(what) = outcome {
            failed.push((name, what));
        }
    };
    let is_killed = fault.is_kill() && !output.status.success();
    let is_new = prepared.is_new(&then);
    check("old or new", prepared.old_or_new(writer, &then, is_killed));
    check("others", prepared.others(&then));
    if !is_killed {
        check("exit code", exit(prepared, &output, is_new, home.path()));
    }
    if writer.1 == Old::Nothing {
        for name in prepared.new.keys() {
            // What is not there need not be removed.
            let _ = std::fs::remove_file(home.path().join(name));
        }
    }
    let again = run(&writer.arguments(), home.path())?;
    let last = contents(home.path())?;
    let is_whole = again.status.success() && prepared.is_new(&last);
    let found = || format!("{:?} {} {:?}", again.status, said(&again), last.keys());
    check(
        "afterwards",
        is_whole
            .then_some(())
            .ok_or_else(found)
            .and_then(|()| prepared.others(&last)),
    );
    check("leftovers", leftovers(&last));
    let outcome = match (output.status.success(), is_killed) {
        (true, _) => "succeeded",
        (_, true) => "killed",
        _ => "refused",
    };
    Ok(Found { outcome, failed })
}

/// Whether a command that was not killed says rightly what it did.
fn exit(prepared: &Prepared, output: &Output, is_new: bool, home: &Path) -> Result<(), String> {
    let text = said(output);
    match output.status.code() {
        Some(0) if is_new => Ok(()),
        Some(0) => Err("0, and not all of the new results".to_owned()),
        Some(1) if prepared.names_a_file(&text, home) => Ok(()),
        Some(1) => Err(format!("no file is named: {text}")),
        _ => Err(format!("{}: {text}", output.status)),
    }
}

/// Hidden names that nobody should find.
fn leftovers(found: &Contents) -> Result<(), String> {
    let is_left = |part: &std::ffi::OsStr| {
        let part = part.to_string_lossy();
        part.starts_with('.') && (part.contains(".partial-") || part.contains(".old-"))
    };
    let left: Vec<&Path> = (found.keys())
        .map(std::path::PathBuf::as_path)
        .filter(|path| path.iter().any(is_left))
        .collect();
    if left.is_empty() {
        Ok(())
    } else {
        Err(format!("{left:?}"))
    }
}

fn counted(seed: u64, writer: &Writer, fault: &Fault, found: &Found) -> Trial {
    let mut trial = Trial::of(found.outcome);
    for feature in [writer.name(), &fault.call.name, fault.kind] {
        trial.counts.feature(feature);
    }
    let case = format!("{}, {fault}", writer.name());
    for Demand { name: check, .. } in demands("writers") {
        let tally = trial.counts.check(check);
        match found.failed.iter().find(|(failed, _)| failed == check) {
            None => tally.held += 1,
            Some((_, what)) => {
                tally.failed += 1;
                trial
                    .failures
                    .push(failure(seed, check, format!("{case}: {what}")));
            }
        }
    }
    trial
}

/// A fault that could not be tried is a failure: nothing is known of it.
fn untried(seed: u64, writer: &Writer, cause: &str) -> Trial {
    let mut trial = Trial::of("not tried");
    let check = "old or new";
    trial.counts.check(check).failed += 1;
    let what = format!("{} was not tried: {cause}", writer.name());
    trial.failures.push(failure(seed, check, what));
    trial
}

fn failure(seed: u64, check: &str, found: String) -> Failure {
    Failure {
        seed,
        check: check.to_owned(),
        case: format!(
            "{found}\n\ncargo xtask torture --only writers --seeds {seed}..{}\n",
            seed + 1
        )
        .into_bytes(),
        found,
        extension: "txt",
    }
}
