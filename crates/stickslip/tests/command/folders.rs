//! What `--force` replaces, and what it never does.

use std::fs;
use std::path::Path;

use super::{SCENE, fails, folder_with, succeeds};

const RUN: [&str; 8] = [
    "run",
    "pin.toml",
    "--set",
    "output.figures=false",
    "--set",
    "mesh.spacing=15 deg",
    "--output",
    "results",
];

fn forced(path: &Path) -> String {
    fails(path, &[&RUN[..], &["--force"]].concat())
}

#[test]
fn files_of_others_are_named_and_kept() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    let results = path.join("results");
    fs::create_dir_all(results.join(".git")).unwrap();
    fs::write(results.join("summary.json"), "{}").unwrap();
    fs::write(results.join("thesis.odt"), "years").unwrap();
    fs::write(results.join(".git/config"), "[core]").unwrap();
    let message = forced(path);
    for name in ["'thesis.odt'", "'.git/'", "'summary.json'"] {
        assert!(message.contains(name), "{name}: {message}");
    }
    assert_eq!(fs::read(results.join("thesis.odt")).unwrap(), b"years");
    assert!(results.join(".git/config").is_file());
    // The same beside results of this program.
    fs::remove_file(results.join("summary.json")).unwrap();
    fs::rename(&results, path.join("mine")).unwrap();
    succeeds(path, &RUN);
    fs::rename(path.join("mine/thesis.odt"), results.join("thesis.odt")).unwrap();
    let message = forced(path);
    assert!(
        message.contains("'thesis.odt'") && !message.contains("summary.json"),
        "{message}"
    );
    fs::remove_file(results.join("thesis.odt")).unwrap();
    succeeds(path, &[&RUN[..], &["--force"]].concat());
}

#[test]
fn results_of_another_command_are_kept_with_its_name() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "e.toml"]);
    let reduce = ["reduce", "e.toml", "--output", "results", "--force"];
    succeeds(path, &reduce);
    // A deeper command of the same chain repeats it.
    let region =
        "region.sector={ angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [12, 4] }";
    let hybrid = [
        "hybrid", "e.toml", "--output", "results", "--force", "--set", region,
    ];
    succeeds(path, &hybrid);
    for with_list in [true, false] {
        let before = fs::read(path.join("results/summary.json")).unwrap();
        let message = forced(path);
        assert!(message.contains("`stickslip reduce`"), "{message}");
        assert_eq!(fs::read(path.join("results/summary.json")).unwrap(), before);
        if with_list {
            fs::remove_file(path.join("results/.stickslip-files")).unwrap();
        }
    }
    fs::remove_dir_all(path.join("results")).unwrap();
    succeeds(path, &RUN);
    let message = fails(path, &reduce);
    assert!(message.contains("results of `stickslip run`"), "{message}");
}

#[test]
fn results_of_older_versions_are_known_by_their_names() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    succeeds(path, &RUN);
    let results = path.join("results");
    fs::remove_file(results.join(".stickslip-files")).unwrap();
    fs::write(results.join("figures.txt"), "mine").unwrap();
    let message = forced(path);
    assert!(message.contains("'figures.txt'"), "{message}");
    fs::remove_file(results.join("figures.txt")).unwrap();
    succeeds(path, &[&RUN[..], &["--force"]].concat());
    assert!(results.join(".stickslip-files").is_file());
}

/// The figures and all tables of an older folder bear names that are known, too.
#[test]
fn every_file_of_a_run_has_a_known_name() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    let all = [
        "run",
        "pin.toml",
        "--set",
        "mesh.spacing=15 deg",
        "--output",
        "results",
    ];
    succeeds(path, &all);
    fs::remove_file(path.join("results/.stickslip-files")).unwrap();
    succeeds(path, &[&all[..], &["--force"]].concat());
}
