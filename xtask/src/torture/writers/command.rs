//! The commands that write, and what they read.

use std::io;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::sync::OnceLock;

use tempfile::TempDir;

use crate::publish::this_command;

/// What is in the way of a writer.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Old {
    /// Results of the same command, replaced as a whole.
    Results,
    /// A sweep that ended after its first row.
    Rows,
    /// An empty folder.
    Nothing,
}

/// A command that writes into `out`: its arguments, and what is in its way.
#[derive(Debug)]
pub(super) struct Writer(&'static str, pub(super) Old);

pub(super) const WRITERS: [Writer; 7] = [
    Writer("run scene.toml --output out --force", Old::Results),
    Writer("fringes fringes.toml --output out --force", Old::Results),
    Writer("reduce experiment.toml --output out --force", Old::Results),
    Writer("hybrid experiment.toml --output out --force", Old::Results),
    Writer(
        "identify experiment.toml --output out --force",
        Old::Results,
    ),
    Writer("joint sweep.toml --output out --resume --jobs 1", Old::Rows),
    Writer("init experiment out/new.toml", Old::Nothing),
];

impl Writer {
    pub(super) fn arguments(&self) -> Vec<&'static str> {
        self.0.split(' ').collect()
    }

    pub(super) fn name(&self) -> &'static str {
        self.arguments()[0]
    }

    /// The file that it reads first.
    pub(super) fn reads(&self) -> &'static str {
        match self.1 {
            Old::Nothing => "out",
            _ => self.arguments()[1],
        }
    }
}

/// This program under the name of the command, as which it is the command.
pub(super) fn program() -> io::Result<PathBuf> {
    static FOLDER: OnceLock<Result<TempDir, String>> = OnceLock::new();
    let made = FOLDER.get_or_init(|| linked().map_err(|cause| cause.to_string()));
    match made {
        Ok(folder) => Ok(folder.path().join(crate::COMMAND)),
        Err(cause) => Err(io::Error::other(cause.clone())),
    }
}

fn linked() -> io::Result<TempDir> {
    let folder = tempfile::tempdir()?;
    this_command(&folder.path().join(crate::COMMAND))?;
    Ok(folder)
}

/// Runs the command with `arguments` in `folder`.
pub(super) fn run(arguments: &[&str], folder: &Path) -> io::Result<Output> {
    started(Command::new(program()?).args(arguments), folder)
}

/// Runs a process in `folder`, on one thread, so that the order of its system calls is the same every time.
pub(super) fn started(command: &mut Command, folder: &Path) -> io::Result<Output> {
    command
        .current_dir(folder)
        .env("RAYON_NUM_THREADS", "1")
        .stdin(Stdio::null())
        .output()
}
