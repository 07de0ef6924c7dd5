//! Mutated inputs of every reader: scenes, sweeps, experiments, tables, fringe lines, pictures and meshes.
//!
//! A seed is a batch of mutants of one reader's file, read one after another in a process of its own under a limit of memory and
//! of time. The process reports before and after each mutant, so that one which ends the process is known.

mod child;
mod corpus;
mod mutant;

use std::ops::Range;
use std::process::{Command, Stdio};

pub(crate) use child::{Batch, main as child};

use super::trial::{Counts, Demand, Failure, Kind, Trial, demands};
use corpus::{TARGETS, Target};

/// Mutants of a seed.
const BATCH: usize = 100;
/// What a batch may take: address space \[kB\] and processor time \[s\].
const MEMORY: u64 = 1_000_000;
const SECONDS: u64 = 300;

/// The kind of trial.
pub(super) struct Readers;

impl Kind for Readers {
    fn name(&self) -> &'static str {
        "readers"
    }

    fn quick(&self) -> Range<u64> {
        0..2 * TARGETS.len() as u64
    }

    fn trial(&self, seed: u64) -> Trial {
        let target = Target::of(seed);
        let mut trial = Trial::default();
        let mut first = 0;
        while first < BATCH {
            let said = batch(seed, first);
            first = count(&said, target, seed, first, &mut trial);
        }
        trial
    }
}

/// What a process said of the mutants from `first` on.
fn batch(seed: u64, first: usize) -> String {
    let limits = format!("ulimit -v {MEMORY}; ulimit -t {SECONDS}; exec \"$0\" \"$@\"");
    let program = std::env::current_exe().unwrap_or_default();
    let output = Command::new("sh")
        .args(["-c", &limits])
        .arg(program)
        .arg("torture-readers")
        .args([seed.to_string(), first.to_string(), BATCH.to_string()])
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .stderr(Stdio::null())
        .output();
    output.map_or_else(
        |cause| format!("begin {first}\nend {first} lost {cause}\n"),
        |output| String::from_utf8_lossy(&output.stdout).into_owned(),
    )
}

/// Counts what was said; the first mutant that nothing was said of.
fn count(said: &str, target: &'static Target, seed: u64, first: usize, trial: &mut Trial) -> usize {
    let mut next = first;
    let mut begun = false;
    for line in said.lines() {
        let mut words = line.splitn(4, ' ');
        match (words.next(), words.next(), words.next()) {
            (Some("begin"), Some(_), _) => begun = true,
            (Some("end"), Some(_), Some(outcome)) => {
                let found = words.next().unwrap_or_default();
                one(target, seed, next, outcome, found, trial);
                begun = false;
                next += 1;
            }
            _ => {}
        }
    }
    if next < BATCH {
        // Nothing was said of what ended the process; a process that did not begin is lost as a whole.
        let found = if begun {
            "the process was ended"
        } else {
            "the process did not begin"
        };
        one(target, seed, next, "ended", found, trial);
        next += 1;
    }
    next
}

/// Counts one mutant.
fn one(
    target: &'static Target,
    seed: u64,
    index: usize,
    outcome: &str,
    found: &str,
    trial: &mut Trial,
) {
    let check = match outcome {
        "panic" => Some("no panic"),
        "ended" | "lost" => Some("within limits"),
        "slow" => Some("in time"),
        "unclear" => Some("says where and what to do"),
        _ => None,
    };
    let mut counts = Counts::of(outcome);
    counts.feature(&target.name);
    for Demand { name, .. } in demands("readers") {
        let tally = counts.check(name);
        if check == Some(name) {
            tally.failed += 1;
        } else {
            tally.held += 1;
        }
    }
    trial.counts.add(&counts);
    if let Some(check) = check {
        trial.failures.push(Failure {
            seed,
            check: check.to_owned(),
            found: format!("{}, mutant {index}: {found}", target.name),
            extension: target.extension(),
            case: mutant::of(target, seed, index),
        });
    }
}
