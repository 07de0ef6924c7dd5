//! What is mutated, from `targets.toml`.

use std::collections::BTreeMap;
use std::sync::LazyLock;

use serde::Deserialize;

use crate::publish::{compiled_in, listed, root};

/// A reader, the files that it reads, and which of them is mutated.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Target {
    pub(super) name: String,
    pub(super) reader: Reader,
    pub(super) form: Form,
    /// The file that is mutated.
    pub(super) mutated: String,
    originals: Vec<String>,
    #[serde(default)]
    beside: BTreeMap<String, String>,
}

/// Which command reads the main file.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Reader {
    Scene,
    Sweep,
    Experiment,
    /// Rows of a sweep that goes on.
    Rows,
    /// The list of the files of a folder.
    Owned,
}

/// How a file is mutated.
#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "snake_case")]
pub(super) enum Form {
    /// Its bytes and lines.
    Text,
    /// Its values, in a file of JSON.
    Tree,
    /// Its bytes.
    Binary,
    /// Its bytes and chunks.
    Png,
}

/// All targets.
pub(super) static TARGETS: LazyLock<Vec<Target>> =
    LazyLock::new(|| compiled_in(listed(include_str!("targets.toml"), "targets")));

/// A file of the corpus; nothing where the sources are not there.
fn file(name: &str) -> Vec<u8> {
    let root = root();
    let path = if name.contains('/') {
        root.join(name)
    } else {
        root.join("xtask/src/torture/readers/inputs").join(name)
    };
    std::fs::read(path).unwrap_or_default()
}

impl Target {
    /// The target of a seed: each in its turn.
    pub(super) fn of(seed: u64) -> &'static Self {
        &TARGETS[(seed % TARGETS.len() as u64) as usize]
    }

    /// The file that the command is given.
    pub(super) fn main(&self) -> &'static str {
        match self.form {
            Form::Tree => "main.json",
            _ => "main.toml",
        }
    }

    pub(super) fn extension(&self) -> &str {
        let parts = self.mutated.split_once('.');
        parts.map_or("txt", |(_, extension)| extension)
    }

    /// The files beside the mutated one.
    pub(super) fn files(&self) -> Vec<(&str, Vec<u8>)> {
        let files = self.beside.iter();
        files
            .map(|(name, path)| (name.as_str(), file(path)))
            .collect()
    }

    /// What is mutated, of which there may be several.
    pub(super) fn original(&self, choice: usize) -> Vec<u8> {
        file(&self.originals[choice % self.originals.len()])
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_target_has_something_to_mutate() {
        for target in &*TARGETS {
            assert!(target.original(0).len() > 100, "{}", target.name);
        }
    }
}
