//! `cargo xtask torture`: random cases, and conditions and relations that hold whatever the answer is.
//!
//! ```text
//! seed ──► Kind::trial ──► Counts, failures ──► files of small cases, a record, a page
//! ```

mod draw;
mod experiments;
mod open;
mod quantity;
pub(crate) mod readers;
mod record;
mod scenes;
mod trial;
mod writers;

use std::ops::Range;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::{Duration, Instant};

use clap::Args;
use stickslip::folder::write_atomic;

use crate::publish::{TaskError, bar};
use record::{Record, Run};
use trial::{Counts, Failure, Kind, Trial};

/// What is tried, how often and for how long.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Seeds to draw from, the last one excluded.
    #[arg(long, value_name = "A..B", value_parser = seeds)]
    seeds: Option<Range<u64>>,
    /// Begin no trial after this many minutes, shared by the kinds.
    #[arg(long, value_name = "M")]
    minutes: Option<f64>,
    /// The few seeds of the continuous check, without making failures smaller.
    #[arg(long)]
    quick: bool,
    /// One kind of trial alone.
    #[arg(long, value_name = "KIND")]
    only: Option<String>,
    /// Folder for failures.
    #[arg(long, value_name = "FOLDER", default_value = "target/torture")]
    output: PathBuf,
    /// Keep the counts in docs/torture and docs/torture.md; those of kinds that are not tried stay.
    #[arg(long)]
    write: bool,
    /// Write docs/torture.md from the counts that are kept, and try nothing.
    #[arg(long)]
    page: bool,
    /// Ask scenes that failed again, and nothing else.
    #[arg(long, value_name = "FILE", num_args = 1..)]
    replay: Vec<PathBuf>,
    /// Trials at a time; as many as there are cores.
    #[arg(long, value_name = "N")]
    jobs: Option<usize>,
}

/// Seeds of a run that names none.
const SEEDS: Range<u64> = 0..200;

fn seeds(text: &str) -> Result<Range<u64>, String> {
    let wrong = || format!("'{text}' is not of the form A..B, such as 0..200");
    let (first, end) = text.split_once("..").ok_or_else(wrong)?;
    let [first, end] = [first, end].map(|number| number.trim().parse::<u64>());
    match (first, end) {
        (Ok(first), Ok(end)) if first < end => Ok(first..end),
        _ => Err(wrong()),
    }
}

/// All kinds of trial; what is drawn, and which checks are made, is theirs.
fn kinds(options: &Options) -> Vec<Box<dyn Kind>> {
    vec![
        Box::new(scenes::Scenes {
            shrinks: !options.quick,
        }),
        Box::new(experiments::Experiments),
        Box::new(readers::Readers),
        Box::new(writers::Writers),
    ]
}

/// Runs the trials; fails where a check did.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    if !options.replay.is_empty() {
        return replay(&options.replay);
    }
    let all = kinds(options);
    if options.page {
        Record::kept(&all)?.write(&all)?;
        return Ok(true);
    }
    let all_kinds = all.iter().map(AsRef::as_ref);
    let wanted = |kind: &&dyn Kind| options.only.as_ref().is_none_or(|only| only == kind.name());
    let chosen: Vec<&dyn Kind> = all_kinds.filter(wanted).collect();
    if chosen.is_empty() {
        let names: Vec<&str> = all.iter().map(|kind| kind.name()).collect();
        let names = names.join(", ");
        return Err(format!("no kind of trial has this name; there are: {names}").into());
    }
    let mut clean = true;
    let mut runs = Vec::new();
    for kind in &chosen {
        if let Some(what) = kind.lacks() {
            eprintln!("{} are NOT TRIED: {what}", kind.name());
            // The continuous check goes on without, for machines that cannot.
            clean &= options.quick && options.only.is_none();
            continue;
        }
        let share = options
            .minutes
            .map(|minutes| Duration::from_secs_f64(60.0 * minutes / chosen.len() as f64));
        let (run, failures) = tried(*kind, options, share);
        print!("{}", run.markdown(*kind));
        clean &= keep(kind.name(), &failures, &options.output)?;
        for broken in kind.broken(&run.counts) {
            clean = false;
            eprintln!("FAILED {}: {broken}", kind.name());
        }
        runs.push((kind.name(), run));
    }
    if options.write {
        // Read now, because another process may have tried other kinds meanwhile.
        let mut record = Record::kept(&all)?;
        for (kind, run) in runs {
            record.put(kind, run);
        }
        record.write(&all)?;
    }
    Ok(clean)
}

fn replay(files: &[PathBuf]) -> Result<bool, TaskError> {
    let mut clean = true;
    for file in files {
        let (lines, holds) = scenes::replay(file)?;
        print!("{}\n{lines}", file.display());
        clean &= holds;
    }
    Ok(clean)
}

/// Tries the seeds of one kind, several at a time.
fn tried(kind: &dyn Kind, options: &Options, time: Option<Duration>) -> (Run, Vec<Failure>) {
    let seeds = match &options.seeds {
        Some(seeds) => seeds.clone(),
        None if options.quick => kind.quick(),
        None => SEEDS,
    };
    let start = Instant::now();
    let length = seeds.end - seeds.start;
    let progress =
        bar("{prefix} {wide_bar} {pos}/{len} {elapsed}", length).with_prefix(kind.name());
    let next = AtomicU64::new(seeds.start);
    let found = Mutex::new((Counts::default(), Vec::new()));
    let cores = || std::thread::available_parallelism().map_or(1, usize::from);
    // The time first: a seed that is taken is tried, so that the next run goes on after it.
    let taken = || {
        let in_time = time.is_none_or(|time| start.elapsed() <= time);
        let seed = in_time.then(|| next.fetch_add(1, Ordering::Relaxed));
        seed.filter(|seed| *seed < seeds.end)
    };
    let work = || {
        while let Some(seed) = taken() {
            let trial = alone(kind, seed);
            for failure in &trial.failures {
                // Seen at once also where no terminal shows a bar.
                progress.suspend(|| {
                    eprintln!("seed {seed}, {}: {}", failure.check, failure.found);
                });
            }
            progress.inc(1);
            let mut found = found.lock().unwrap_or_else(PoisonError::into_inner);
            found.0.add(&trial.counts);
            found.1.extend(trial.failures);
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..options.jobs.unwrap_or_else(cores) {
            scope.spawn(work);
        }
    });
    progress.finish_and_clear();
    let found = found.into_inner();
    let (counts, mut failures) = found.unwrap_or_else(PoisonError::into_inner);
    failures.sort_by(|a, b| (a.seed, &a.check).cmp(&(b.seed, &b.check)));
    let seeds = [seeds.start, next.into_inner().min(seeds.end)];
    (Run { seeds, counts }, failures)
}

/// A trial with one thread for itself: without a pool of its own, it would wait inside another one's parallel part.
fn alone(kind: &dyn Kind, seed: u64) -> Trial {
    match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
        Ok(pool) => pool.install(|| kind.trial(seed)),
        Err(_) => kind.trial(seed),
    }
}

/// Writes the failures of `kind` and names them; whether all of them are known.
fn keep(kind: &str, failures: &[Failure], folder: &Path) -> Result<bool, TaskError> {
    let mut clean = true;
    for failure in failures {
        std::fs::create_dir_all(folder)?;
        let Failure {
            seed, check, found, ..
        } = failure;
        let name = check.replace(' ', "-");
        let file = folder.join(format!("{kind}-{name}-{seed}.{}", failure.extension));
        write_atomic(&file, &failure.case)?;
        let known = open::is_known(kind, failure);
        clean &= known;
        let word = if known { "known" } else { "FAILED" };
        eprintln!(
            "{word} {kind} seed {seed}, {check}: {found}\n  {}",
            file.display()
        );
    }
    Ok(clean)
}

#[cfg(test)]
mod tests {
    use super::seeds;

    #[test]
    fn seeds_are_a_range() {
        assert_eq!(seeds("3..9"), Ok(3..9));
        for wrong in ["3", "9..3", "a..b", "-1..4"] {
            assert!(seeds(wrong).unwrap_err().contains("0..200"), "{wrong}");
        }
    }
}
