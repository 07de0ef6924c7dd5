//! What tasks share: options of studies, cases solved side by side, and the files that are written in the end.

use std::collections::BTreeMap;
use std::fmt::Debug;
use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitStatus};

use clap::Args;
use indicatif::{ProgressBar, ProgressStyle};
use rayon::prelude::*;
use serde::de::DeserializeOwned;
use stickslip::folder::{FolderError, SharedFolder, write_atomic};
use stickslip_report::raster::{DEFAULT_SCALE, to_png};
use stickslip_report::svg::Svg;

/// Why a task stopped; a task that ends says whether all was well.
pub(crate) type TaskError = Box<dyn std::error::Error + Send + Sync>;

/// The folder of the workspace.
pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("..")
}

/// How much of a study is wanted, and where.
#[derive(Debug, Args)]
pub(crate) struct Options {
    /// Few values on coarser meshes: at most a minute. Nothing is written unless a folder is named.
    #[arg(long)]
    pub(crate) quick: bool,
    /// Folder for tables and pictures; the study's own below docs for a full run.
    #[arg(long, value_name = "FOLDER")]
    pub(crate) output: Option<PathBuf>,
}

/// What was `read` of a text that is compiled in.
pub(crate) fn compiled_in<T, E: Debug>(read: Result<T, E>) -> T {
    // The texts are part of the program, and these tests read all four: `every_known_failure_has_seeds_and_a_reason`,
    // `mutants_are_the_same_every_time_and_differ`, `every_target_has_something_to_mutate`, `every_check_is_made`.
    read.expect("tests read every text that is compiled in")
}

/// The list under `key` of a TOML text.
pub(crate) fn listed<T: DeserializeOwned>(text: &str, key: &str) -> Result<Vec<T>, TaskError> {
    let mut all: BTreeMap<String, Vec<T>> = toml::from_str(text)?;
    let list = all.remove(key);
    list.ok_or_else(|| format!("there is no list '{key}'").into())
}

/// Makes this program the command, under its name.
pub(crate) fn this_command(path: &Path) -> io::Result<()> {
    let own = std::env::current_exe()?;
    #[cfg(unix)]
    return std::os::unix::fs::symlink(own, path);
    #[cfg(not(unix))]
    std::fs::copy(own, path).map(drop)
}

/// Builds the release of what `chosen` names in the workspace `tree`, with build products of its own.
pub(crate) fn cargo_build(tree: &Path, products: &Path, chosen: &[&str]) -> io::Result<ExitStatus> {
    let cargo = std::env::var_os("CARGO").unwrap_or_else(|| "cargo".into());
    Command::new(cargo)
        .current_dir(tree)
        .env("CARGO_TARGET_DIR", products)
        .args(["build", "--release", "--locked"])
        .args(chosen)
        .status()
}

/// A folder that a task writes its files into.
pub(crate) enum Published {
    /// The task's own, below `docs` or `target`: its files are replaced.
    Own(PathBuf),
    /// One that the user named: nothing is replaced but what a task has written there.
    Named(SharedFolder),
}

impl Published {
    /// The folder that was `named`, otherwise the task's `own`, if it writes one.
    pub(crate) fn open(
        named: Option<&Path>,
        own: Option<PathBuf>,
    ) -> Result<Option<Self>, FolderError> {
        match named {
            Some(path) => Ok(Some(Self::Named(SharedFolder::open(path, |_| false)?))),
            None => Ok(own.map(Self::Own)),
        }
    }

    /// Where it is.
    pub(crate) fn path(&self) -> PathBuf {
        match self {
            Self::Own(path) => path.clone(),
            Self::Named(folder) => folder.file(""),
        }
    }

    /// Writes a file whole or not at all.
    pub(crate) fn write(&mut self, name: &str, bytes: &[u8]) -> Result<(), FolderError> {
        match self {
            Self::Own(path) => {
                let unwritable = |cause| FolderError::Unwritable {
                    path: path.clone(),
                    cause,
                };
                std::fs::create_dir_all(&*path).map_err(unwritable)?;
                write_atomic(&path.join(name), bytes)
            }
            Self::Named(folder) => folder.write(name, bytes),
        }
    }

    /// Writes a picture as PNG, and in a folder that the user named as SVG too: pages show the PNG.
    pub(crate) fn write_picture(&mut self, name: &str, svg: &Svg) -> Result<(), TaskError> {
        self.write_scaled(name, svg, DEFAULT_SCALE)
    }

    /// Writes a picture as [`write_picture`](Self::write_picture) does, with `scale` pixels of the PNG to a pixel of the picture.
    pub(crate) fn write_scaled(
        &mut self,
        name: &str,
        svg: &Svg,
        scale: f64,
    ) -> Result<(), TaskError> {
        if matches!(self, Self::Named(_)) {
            self.write(&format!("{name}.svg"), svg.as_str().as_bytes())?;
        }
        let png = to_png(svg, scale)?;
        Ok(self.write(&format!("{name}.png"), &png)?)
    }
}

/// Solves `cases` on all cores with a bar of progress; the order of the results is that of the cases.
pub(crate) fn side_by_side<C: Sync, R: Send>(
    cases: &[C],
    solve: impl Fn(&C) -> Result<R, TaskError> + Sync,
) -> Result<Vec<R>, TaskError> {
    let progress = bar("{wide_bar} {pos}/{len} {elapsed}", cases.len() as u64);
    let results = cases
        .par_iter()
        .map(|case| {
            let result = solve(case);
            progress.inc(1);
            result
        })
        .collect();
    progress.finish_and_clear();
    results
}

/// A bar of progress on stderr, drawn by a template of `indicatif` that is known to parse.
pub(crate) fn bar(template: &str, length: u64) -> ProgressBar {
    let bar = ProgressBar::new(length);
    // Without a style the bar only looks plainer.
    match ProgressStyle::with_template(template) {
        Ok(style) => bar.with_style(style),
        Err(_) => bar,
    }
}
