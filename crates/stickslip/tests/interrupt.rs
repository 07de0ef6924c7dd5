//! Ctrl-C, SIGTERM and SIGHUP during a run.
#![cfg(unix)]

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use tempfile::TempDir;

/// A run of some seconds into `output`.
fn long_run(output: &Path, further: &[&str]) -> Child {
    let scene =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-loaded-aluminium.toml");
    Command::new(env!("CARGO_BIN_EXE_stickslip"))
        .arg("run")
        .arg(scene)
        .args(["--set", "mesh.spacing=0.3 deg", "--output"])
        .arg(output)
        .args(further)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap()
}

fn entries(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    entries.map(|entry| entry.unwrap().path()).collect()
}

/// Sends `signal` to `run` as soon as there are more than `before` entries in `folder`.
fn interrupt(mut run: Child, signal: &str, folder: &Path, before: usize) -> (Option<i32>, String) {
    let start = Instant::now();
    while entries(folder).len() <= before {
        assert!(start.elapsed() < Duration::from_secs(60));
        assert_eq!(run.try_wait().unwrap(), None);
        std::thread::sleep(Duration::from_millis(1));
    }
    let sent = Command::new("kill")
        .args(["-s", signal, &run.id().to_string()])
        .status()
        .unwrap();
    assert!(sent.success());
    let output = run.wait_with_output().unwrap();
    assert!(output.stdout.is_empty());
    (
        output.status.code(),
        String::from_utf8(output.stderr).unwrap(),
    )
}

fn leaves_nothing(signal: &str) {
    let folder = TempDir::new().unwrap();
    let run = long_run(&folder.path().join("results"), &[]);
    let (code, message) = interrupt(run, signal, folder.path(), 0);
    assert_eq!(code, Some(130), "{message}");
    assert!(
        message.contains("interrupted; nothing was written"),
        "{message}"
    );
    assert_eq!(entries(folder.path()), Vec::<PathBuf>::new());
}

#[test]
fn an_interrupted_run_leaves_nothing() {
    leaves_nothing("INT");
}

#[test]
fn a_terminated_run_leaves_nothing() {
    leaves_nothing("TERM");
}

#[test]
fn a_run_whose_terminal_closes_leaves_nothing() {
    leaves_nothing("HUP");
}

#[test]
fn an_interrupted_replacement_leaves_the_old_results() {
    const OLD: &str = r#"{"format": "stickslip-summary"}"#;
    let folder = TempDir::new().unwrap();
    let old = folder.path().join("results");
    fs::create_dir(&old).unwrap();
    fs::write(old.join("summary.json"), OLD).unwrap();
    let run = long_run(&old, &["--force", "--json"]);
    let (code, message) = interrupt(run, "INT", folder.path(), 1);
    assert_eq!(code, Some(130), "{message}");
    let value: serde_json::Value = serde_json::from_str(&message).unwrap();
    assert_eq!(value["errors"][0]["code"], "run::interrupted");
    assert_eq!(entries(folder.path()), std::slice::from_ref(&old));
    assert_eq!(fs::read_to_string(old.join("summary.json")).unwrap(), OLD);
}
