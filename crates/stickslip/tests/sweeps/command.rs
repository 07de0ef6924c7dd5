//! `stickslip joint`.

use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};
use stickslip::host::HOST;

use tempfile::TempDir;

use super::{COARSE, SWEEP, folder_with, scenes};

fn joint(folder: &Path, further: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .current_dir(folder)
        .args(["joint", "sweep.toml", "--output", "out", "--set", COARSE])
        .args(further)
        .output()
        .unwrap()
}

fn words(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}

fn lines(folder: &Path) -> usize {
    let table = fs::read_to_string(folder.join("out/cases.csv")).unwrap();
    table.lines().count()
}

#[test]
fn a_sweep_makes_a_folder_and_is_gone_on_with() {
    let folder = folder_with(SWEEP);
    let path = folder.path();
    let output = joint(path, &["--jobs", "2"]);
    assert!(output.status.success(), "{}", words(&output.stderr));
    let said = words(&output.stdout);
    assert!(
        said.contains("Six joints") && said.contains("6 cases in"),
        "{said}"
    );
    for file in [
        "sweep.json",
        "summary.json",
        "report.html",
        "figures/modes.png",
        "figures/loads.svg",
    ] {
        assert!(path.join("out").join(file).is_file(), "{file}");
    }
    let whole = fs::read_to_string(path.join("out/cases.csv")).unwrap();
    assert_eq!(lines(path), 7);
    // Without --resume nothing is touched.
    let refused = joint(path, &[]);
    assert_eq!(refused.status.code(), Some(1));
    assert!(
        words(&refused.stderr).contains("--resume"),
        "{}",
        words(&refused.stderr)
    );
    // As a killed sweep leaves it: two rows and a part of the third.
    let ends: Vec<usize> = whole.match_indices('\n').map(|(at, _)| at).collect();
    fs::write(path.join("out/cases.csv"), &whole[..ends[2] + 30]).unwrap();
    let resumed = joint(path, &["--resume", "--json"]);
    assert!(resumed.status.success(), "{}", words(&resumed.stderr));
    let summary: serde_json::Value = serde_json::from_slice(&resumed.stdout).unwrap();
    assert_eq!(
        (&summary["solved"], &summary["solved_in_this_run"]),
        (&6.into(), &4.into())
    );
    let counts = summary["findings"].as_object().unwrap();
    let again = fs::read_to_string(path.join("out/cases.csv")).unwrap();
    for (kind, count) in counts {
        assert_eq!(
            again.matches(kind.as_str()).count() as u64,
            count.as_u64().unwrap()
        );
    }
    assert_eq!(
        counts.is_empty(),
        !said.contains("warning: Findings in"),
        "{said}"
    );
    let untimed = |table: &str| -> Vec<String> {
        let cells = |line: &str| {
            let mut cells: Vec<&str> = line.split(',').collect();
            cells.remove(cells.len() - 3);
            cells.join(",")
        };
        table.lines().map(cells).collect()
    };
    assert_eq!(untimed(&again), untimed(&whole));
    // Another mesh is another sweep.
    let other = joint(path, &["--resume", "--set", "mesh.spacing=5 deg"]);
    assert_eq!(other.status.code(), Some(1));
    assert!(
        words(&other.stderr).contains("another sweep"),
        "{}",
        words(&other.stderr)
    );
    assert_eq!(lines(path), 7);
}

#[test]
fn a_folder_of_something_else_is_left_alone() {
    let folder = folder_with(SWEEP);
    fs::create_dir(folder.path().join("out")).unwrap();
    fs::write(folder.path().join("out/thesis.txt"), "mine").unwrap();
    for further in [&[] as &[&str], &["--resume"]] {
        let output = joint(folder.path(), further);
        assert_eq!(output.status.code(), Some(1));
        assert!(
            words(&output.stderr).contains("no sweep"),
            "{}",
            words(&output.stderr)
        );
    }
}

#[test]
fn a_sweep_without_any_answer_fails() {
    let text = SWEEP
        .replace("e_over_d", "w_over_d")
        .replace("[2, 4, 5]", "[1.15]");
    let folder = folder_with(&text);
    let output = joint(folder.path(), &[]);
    assert_eq!(output.status.code(), Some(1));
    let said = words(&output.stderr);
    assert!(said.contains("none of the 2 cases has an answer"), "{said}");
    assert_eq!(lines(folder.path()), 3);
}

#[test]
fn every_sweep_of_the_repository_reads() {
    let mut count = 0;
    for entry in fs::read_dir(scenes()).unwrap() {
        let path = entry.unwrap().path();
        let text = fs::read_to_string(&path).unwrap();
        if text.contains("[[axes]]") {
            stickslip::sweep::Sweep::from_file(&path, &[] as &[&str], HOST).unwrap();
            count += 1;
        }
    }
    assert!(count >= 2);
}

#[cfg(unix)]
#[test]
fn an_interrupted_sweep_keeps_what_is_finished() {
    let folder = TempDir::new().unwrap();
    let out = folder.path().join("out");
    let mut sweep = Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .arg("joint")
        .arg(scenes().join("thousand.toml"))
        .args(["--set", "mesh.spacing=6 deg", "--output"])
        .arg(&out)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let start = Instant::now();
    let rows =
        || fs::read_to_string(out.join("cases.csv")).map_or(0, |table| table.lines().count());
    while rows() < 5 {
        assert!(start.elapsed() < Duration::from_secs(120));
        assert_eq!(sweep.try_wait().unwrap(), None);
        std::thread::sleep(Duration::from_millis(5));
    }
    let sent = Command::new("kill")
        .args(["-s", "INT", &sweep.id().to_string()])
        .status();
    assert!(sent.unwrap().success());
    let output = sweep.wait_with_output().unwrap();
    let said = words(&output.stderr);
    assert_eq!(output.status.code(), Some(130), "{said}");
    assert!(said.contains("of 1000 cases are in"), "{said}");
    assert!(rows() >= 5 && rows() < 1001);
    assert!(out.join("report.html").is_file());
}
