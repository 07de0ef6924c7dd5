//! The folder that a command writes, and which older folders are its own.

use std::path::{Path, PathBuf};

use serde_json::Value;

use super::console::Console;
use super::interrupt::guarded;
use crate::folder::{FolderError, Overwrite, ResultFolder, Results};

/// The commands whose results replace one another.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Owner {
    /// `run`.
    Run,
    /// The chain of experiments, of which a deeper command repeats the earlier ones.
    Experiment,
}

/// The folder for results: the `given` one, or by default that with the name of the file that they are made from and -results.
pub(super) fn results_folder(given: Option<&PathBuf>, file: &Path) -> PathBuf {
    let default = || {
        let stem = file.file_stem().unwrap_or_default().to_string_lossy();
        PathBuf::from(format!("{stem}-results"))
    };
    given.cloned().unwrap_or_else(default)
}

/// Makes the folder for the results of `owner`; what had to be put right of an earlier process is said.
pub(super) fn prepare(
    path: &Path,
    force: bool,
    owner: Owner,
    console: Console,
) -> Result<ResultFolder, FolderError> {
    let overwrite = match (force, owner) {
        (false, _) => Overwrite::Refuse,
        (true, Owner::Run) => Overwrite::Force(|summary| found(summary, Owner::Run)),
        (true, Owner::Experiment) => Overwrite::Force(|summary| found(summary, Owner::Experiment)),
    };
    let folder = guarded(console, || ResultFolder::create(path, overwrite))?;
    if folder.puts_back() {
        console.note(&format!(
            "an earlier replacement of '{}' was killed; the old results are back in their place",
            path.display()
        ));
    }
    Ok(folder)
}

/// Whose results a summary is of, by the format that it names, seen from `own`.
fn found(summary: &[u8], own: Owner) -> Option<Results> {
    const CHAIN: &str = "an experiment (`stickslip reduce`, `hybrid`, `identify` or `fringes`)";
    let summary: Value = serde_json::from_slice(summary).ok()?;
    Some(match (summary.get("format")?.as_str()?, own) {
        ("stickslip-summary", Owner::Run) => Results::Same(of_a_run),
        ("stickslip-summary", Owner::Experiment) => Results::Other("`stickslip run`"),
        ("stickslip-experiment-summary", Owner::Experiment) => Results::Same(of_an_experiment),
        ("stickslip-experiment-summary", Owner::Run) => Results::Other(CHAIN),
        ("stickslip-sweep-summary", _) => Results::Other("`stickslip joint`"),
        _ => return None,
    })
}

fn of_a_run(name: &str) -> bool {
    const FILES: [&str; 5] = [
        "summary.json",
        "report.html",
        "scene.toml",
        "steps.csv",
        "results.pvd",
    ];
    const TABLES: [&str; 8] = [
        "edge-",
        "failure-",
        "first-ply-",
        "characteristic-",
        "envelopes-",
        "plies-",
        "load-displacement-",
        "damage-",
    ];
    const FIGURES: [&str; 18] = [
        "sketch.",
        "sides-",
        "deformed-",
        "stresses-",
        "pressure-",
        "shear-",
        "hoop-",
        "map-",
        "extent-",
        "friction-",
        "ply-",
        "characteristic-",
        "envelope-normal-",
        "envelope-shear-",
        "load-displacement-",
        "edge-strains-",
        "damage-",
        "field-",
    ];
    FILES.contains(&name)
        || is_one_of(name, "", &TABLES, &[".csv"])
        || is_one_of(name, "fields/", &[""], &[".vtu"])
        || is_one_of(name, "meshes/", &[""], &[".msh", ".inp"])
        || is_one_of(name, "figures/", &FIGURES, &[".svg", ".png"])
}

fn of_an_experiment(name: &str) -> bool {
    const FILES: [&str; 6] = [
        "summary.json",
        "index.html",
        "laws.csv",
        "friction.csv",
        "gallery.png",
        "measured.toml",
    ];
    const TABLES: [&str; 5] = ["law-fit-", "edge-", "forces-", "whole-plate-", "measured-"];
    const FIGURES: [&str; 9] = [
        "law-",
        "friction.",
        "edge-",
        "misfit-",
        "fringes-",
        "whole-plate-",
        "phase-",
        "orders-",
        "data-",
    ];
    FILES.contains(&name)
        || is_one_of(name, "", &TABLES, &[".csv"])
        || is_one_of(name, "fringes/", &[""], &[".png", ".tiff"])
        || is_one_of(name, "figures/", &FIGURES, &[".svg", ".png"])
}

/// Which files a sweep of such a version consists of.
pub(super) fn of_a_sweep(name: &str) -> bool {
    const FIGURES: [&str; 7] = [
        "modes",
        "loads",
        "pressure-over-",
        "hoop-over-",
        "extent-over-",
        "stick-over-",
        "share-over-",
    ];
    ["sweep.json", "cases.csv", "report.html", "summary.json"].contains(&name)
        || is_one_of(name, "figures/", &FIGURES, &[".svg", ".png"])
}

/// Whether `name` is a file in `folder`, not deeper, that starts and ends with one of the given texts.
fn is_one_of(name: &str, folder: &str, starts: &[&str], ends: &[&str]) -> bool {
    name.strip_prefix(folder).is_some_and(|name| {
        !name.contains('/')
            && starts.iter().any(|start| name.starts_with(start))
            && ends.iter().any(|end| name.ends_with(end))
    })
}
