//! `cargo xtask same-answers`: results of this version beside those of an earlier one, to the last printed digit.
//!
//! The command of a baseline revision is built in a worktree of its own below `target/same-answers`. Both commands run every shipped
//! scene, sweep and experiment without pictures, and their `summary.json`, CSV tables and VTK files are compared. Keys, columns and files
//! that are new are listed; anything else that differs fails the task, unless `xtask/same-answers.toml` lists it with a reason.

mod baseline;
mod cases;
mod compare;
mod exceptions;
mod kinds;
mod numbers;

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Instant;

use clap::Args;

use crate::publish::{TaskError, root, this_command};
use cases::Case;
use compare::{Comparison, compare};
use exceptions::Exceptions;

/// The last commit before finer models of outlines halved all cells. What changed from where the workspace was cut (c294b76) to it stands in CHANGELOG.
const BASELINE: &str = "527d9d0c";

/// What to compare.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Revision to compare with.
    #[arg(long, value_name = "REV", default_value = BASELINE)]
    baseline: String,
    /// Results of the baseline that were made earlier, as --keep leaves them in its folder `baseline`
    #[arg(long, value_name = "DIR", conflicts_with = "baseline")]
    baseline_dir: Option<PathBuf>,
    /// Only these files; by default all below scenes but experiments that fit laws, which take minutes
    #[arg(long, value_name = "FILE", num_args = 1..)]
    scene: Vec<PathBuf>,
    /// Folder that keeps the results of both, in `baseline` and `new`; it must not exist
    #[arg(long, value_name = "DIR")]
    keep: Option<PathBuf>,
}

/// Runs and compares; fails if something differs that is not listed.
pub(crate) fn main(options: &Options) -> Result<bool, TaskError> {
    let root = root().canonicalize()?;
    let work = root.join("target/same-answers");
    fs::create_dir_all(&work)?;
    let mut exceptions = Exceptions::read(&root.join("xtask/same-answers.toml"))?;
    let cases = cases::all(&root, &work, &options.scene)?;

    let scratch = tempfile::tempdir_in(&work)?;
    let results = match &options.keep {
        Some(folder) => {
            fs::create_dir_all(folder.parent().unwrap_or(folder))?;
            fs::create_dir(folder)
                .map_err(|cause| format!("--keep {}: {cause}", folder.display()))?;
            folder.canonicalize()?
        }
        None => scratch.path().to_owned(),
    };
    let program = scratch.path().join(crate::COMMAND);
    this_command(&program)?;
    let before = match &options.baseline_dir {
        Some(_) => None,
        None => Some(baseline::build(&root, &work, &options.baseline)?),
    };
    let before_results = match &options.baseline_dir {
        Some(folder) => folder.canonicalize()?,
        None => results.join("baseline"),
    };

    println!("{HEAD}");
    let mut same = true;
    for case in &cases {
        let start = Instant::now();
        if let Some(before) = &before {
            run(before, &root, case, &before_results)?;
        }
        run(&program, &root, case, &results.join("new"))?;
        let name = case.name();
        let mut comparison = compare(
            &before_results.join(&name),
            &results.join("new").join(&name),
            exceptions.kinds(),
        )?;
        let listed = exceptions.take(&case.file, &mut comparison);
        same &= comparison.differences.is_empty();
        show(&name, &comparison, listed, start.elapsed().as_secs_f64());
    }
    for exception in exceptions.unused(&cases) {
        same = false;
        println!("listed, but the same: {exception}");
    }
    Ok(same)
}

/// Runs a case into its folder below `results`, and leaves a failure's message there as `error.txt`.
fn run(program: &Path, root: &Path, case: &Case, results: &Path) -> Result<(), TaskError> {
    let folder = results.join(case.name());
    if let Some(parent) = folder.parent() {
        fs::create_dir_all(parent)?;
    }
    let finished = Command::new(program)
        .current_dir(root)
        .args(case.arguments())
        .arg("--quiet")
        .arg("--output")
        .arg(&folder)
        .stdin(Stdio::null())
        .output()?;
    if !finished.status.success() {
        fs::create_dir_all(&folder)?;
        fs::write(folder.join(compare::FAILURE), finished.stderr)?;
    }
    Ok(())
}

const HEAD: &str =
    "case                                 values  reworded    new  listed  differences  seconds";
/// Most differences that are shown of a case.
const SHOWN: usize = 10;

/// Prints a line of the table, and what differs below it.
fn show(name: &str, found: &Comparison, listed: usize, seconds: f64) {
    let (added, differences) = (found.added.len(), found.differences.len());
    let (values, reworded) = (found.values, found.reworded);
    println!(
        "{name:<32} {values:>10} {reworded:>9} {added:>6} {listed:>7} {differences:>12} {seconds:>8.1}"
    );
    for place in &found.added {
        println!("    new: {place}");
    }
    for difference in found.differences.iter().take(SHOWN) {
        println!("    {difference}");
    }
    if differences > SHOWN {
        println!("    and {} more", differences - SHOWN);
    }
}
