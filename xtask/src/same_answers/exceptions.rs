//! The table of what may differ from the baseline, `xtask/same-answers.toml`.

use std::fmt;
use std::fs;
use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::cases::Case;
use super::compare::{Comparison, Difference};
use super::kinds::Kinds;
use crate::publish::TaskError;

/// Values that may differ.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Exception {
    /// The scene, from the root of the workspace.
    scene: PathBuf,
    /// A file of its results; all without it.
    file: Option<String>,
    /// A place in the file; `*` stands for one key or index, and all below the place belongs to it.
    place: String,
    reason: String,
    /// Differences that it explained.
    #[serde(skip)]
    uses: usize,
}

impl fmt::Display for Exception {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(
            f,
            "{}: {} ({})",
            self.scene.display(),
            self.place,
            self.reason
        )
    }
}

/// The table.
#[derive(Debug, Deserialize)]
pub(super) struct Exceptions {
    #[serde(flatten)]
    kinds: Kinds,
    #[serde(default, rename = "exception")]
    list: Vec<Exception>,
}

impl Exceptions {
    pub(super) fn read(path: &Path) -> Result<Self, TaskError> {
        Ok(toml::from_str(&fs::read_to_string(path)?)?)
    }

    pub(super) fn kinds(&self) -> &Kinds {
        &self.kinds
    }

    /// Takes the listed differences of a scene out of what was found, and counts them.
    pub(super) fn take(&mut self, scene: &Path, found: &mut Comparison) -> usize {
        let before = found.differences.len();
        found.differences.retain(|difference| {
            let listed = self
                .list
                .iter_mut()
                .find(|one| one.scene == scene && one.holds(difference));
            listed.map(|one| one.uses += 1).is_none()
        });
        before - found.differences.len()
    }

    /// Exceptions for scenes of `cases` that explained nothing.
    pub(super) fn unused(&self, cases: &[Case]) -> impl Iterator<Item = impl fmt::Display> {
        let compared = |one: &&Exception| cases.iter().any(|case| case.file == one.scene);
        self.list
            .iter()
            .filter(move |one| one.uses == 0)
            .filter(compared)
    }
}

impl Exception {
    fn holds(&self, difference: &Difference) -> bool {
        let mut keys = difference.place.split('.');
        self.file
            .as_ref()
            .is_none_or(|file| *file == difference.file)
            && self.place.split('.').all(|wanted| {
                keys.next()
                    .is_some_and(|key| wanted == "*" || wanted == key)
            })
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::{Comparison, Difference, Exceptions};

    #[test]
    fn listed_places_are_taken_out_and_others_stay() {
        let text = "ignored = []\nprose = []\n[[exception]]\nscene = \"scenes/a.toml\"\nplace = \"steps.*.b\"\nreason = \"r\"";
        let mut exceptions: Exceptions = toml::from_str(text).expect("a table");
        let found = || {
            let places = ["steps.0.b", "steps.12.b.value", "steps.0.c", "b"];
            let differences = places.map(|place| Difference::of("summary.json", place));
            Comparison {
                differences: differences.into(),
                ..Comparison::default()
            }
        };
        let mut other = found();
        assert_eq!(exceptions.take(Path::new("scenes/b.toml"), &mut other), 0);
        assert_eq!(exceptions.unused(&[]).count(), 0);
        let mut own = found();
        assert_eq!(exceptions.take(Path::new("scenes/a.toml"), &mut own), 2);
        let left: Vec<_> = own
            .differences
            .iter()
            .map(|one| one.place.as_str())
            .collect();
        assert_eq!(left, ["steps.0.c", "b"]);
    }
}
