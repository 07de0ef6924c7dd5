//! Sweeps as their users meet them: files, errors with line and remedy, tables that are gone on with, the command.

mod command;
mod refusals;
mod rows;

use std::fs;
use std::num::NonZeroUsize;
use std::path::{Path, PathBuf};
use std::sync::atomic::AtomicBool;

use stickslip::host::HOST;
use stickslip::sweep::Sweep;
use stickslip::sweep::row::Row;
use tempfile::TempDir;

/// A sweep of six quick cases beside a copy of the base scene.
const SWEEP: &str = r#"version = 1
title = "Six joints"
scene = "joint.toml"
[[axes]]
key = "e_over_d"
values = [2, 4, 5]
[[axes]]
key = "mu"
values = [0, 0.3]
"#;
const COARSE: &str = "mesh.spacing=6 deg";

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/sweeps")
}

/// A folder with the base scene `joint.toml` and `text` as `sweep.toml`.
fn folder_with(text: &str) -> TempDir {
    let folder = TempDir::new().unwrap();
    let base = scenes().join("pinned-joint.toml");
    fs::copy(base, folder.path().join("joint.toml")).unwrap();
    fs::write(folder.path().join("sweep.toml"), text).unwrap();
    folder
}

fn read(folder: &TempDir) -> Sweep {
    Sweep::from_file(&folder.path().join("sweep.toml"), &[COARSE], HOST).unwrap()
}

fn solved(sweep: &Sweep, cases: &[usize]) -> Vec<Row> {
    let mut rows = Vec::new();
    let stop = AtomicBool::new(false);
    stickslip::sweep::engine::run(sweep, cases, NonZeroUsize::MIN, &stop, &mut |row| {
        rows.push(row);
        Ok(())
    })
    .unwrap();
    rows
}
