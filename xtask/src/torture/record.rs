//! The counts of all kinds: kept beside the documents, each kind in a file of its own, and shown together as a page.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use stickslip::folder::write_atomic;

use super::open::OPEN;
use super::trial::{Counts, Kind};
use crate::publish::TaskError;

/// Counts by kind, with the seeds that they come from.
#[derive(Debug, Default)]
pub(super) struct Record(BTreeMap<String, Run>);

/// One kind's run.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(super) struct Run {
    /// First seed, and the one after the last.
    pub(super) seeds: [u64; 2],
    pub(super) counts: Counts,
}

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../docs")
}

fn file_of(kind: &str) -> PathBuf {
    docs().join(format!("torture/{kind}.json"))
}

impl Record {
    /// The runs that lie beside the documents.
    pub(super) fn kept(kinds: &[Box<dyn Kind>]) -> Result<Self, TaskError> {
        let mut record = Self::default();
        for kind in kinds {
            match std::fs::read(file_of(kind.name())) {
                Ok(bytes) => {
                    let run = serde_json::from_slice(&bytes)?;
                    record.0.insert(kind.name().to_owned(), run);
                }
                Err(error) if error.kind() == std::io::ErrorKind::NotFound => {}
                Err(error) => return Err(error.into()),
            }
        }
        Ok(record)
    }

    /// Puts the run of a kind in the place of its last one, or adds it to that if its seeds are the next ones.
    pub(super) fn put(&mut self, kind: &str, run: Run) {
        match self.0.get_mut(kind) {
            Some(last) if last.seeds[1] == run.seeds[0] && run.seeds[0] > 0 => {
                last.seeds[1] = run.seeds[1];
                last.counts.add(&run.counts);
            }
            _ => drop(self.0.insert(kind.to_owned(), run)),
        }
    }

    /// Writes the runs, and a page of them all, beside the documents.
    pub(super) fn write(&self, kinds: &[Box<dyn Kind>]) -> Result<(), TaskError> {
        std::fs::create_dir_all(docs().join("torture"))?;
        for (kind, run) in &self.0 {
            let text = serde_json::to_string_pretty(run)? + "\n";
            write_atomic(&file_of(kind), text.as_bytes())?;
        }
        write_atomic(&docs().join("torture.md"), self.page(kinds).as_bytes())?;
        Ok(())
    }

    /// The page, in Markdown.
    fn page(&self, kinds: &[Box<dyn Kind>]) -> String {
        let mut page = include_str!("page.md").to_owned();
        for kind in kinds {
            let Some(run) = self.0.get(kind.name()) else {
                continue;
            };
            // Writing into a string does not fail.
            let _ = write!(
                page,
                "\n## {}\n\n{}",
                title(kind.name()),
                run.markdown(kind.as_ref())
            );
        }
        page += "\n## Open failures\n\n";
        if OPEN.is_empty() {
            page += "None.\n";
        } else {
            page += "| kind | check | seeds | reason |\n| --- | --- | --- | --- |\n";
            for open in &*OPEN {
                let seeds: Vec<String> = open.seeds.iter().map(u64::to_string).collect();
                let _ = writeln!(
                    page,
                    "| {} | {} | {} | {} |",
                    open.kind,
                    open.check,
                    seeds.join(", "),
                    open.reason
                );
            }
        }
        page
    }
}

fn title(kind: &str) -> String {
    let mut letters = kind.chars();
    letters.next().map_or_else(String::new, |first| {
        first.to_uppercase().chain(letters).collect()
    })
}

impl Run {
    /// Counts as Markdown.
    pub(super) fn markdown(&self, kind: &dyn Kind) -> String {
        let Counts {
            trials,
            outcomes,
            features,
            checks: _,
        } = &self.counts;
        let [first, end] = self.seeds;
        let list = |counts: &BTreeMap<String, u64>| -> String {
            let shown: Vec<String> = counts
                .iter()
                .map(|(name, count)| format!("{name} {count}"))
                .collect();
            shown.join(", ")
        };
        let mut text = format!(
            "{trials} trials of the seeds from {first} to below {end}: {}.\n",
            list(outcomes)
        );
        if !features.is_empty() {
            let _ = write!(text, "\nHeld by these: {}.\n", list(features));
        }
        text + &kind.table(&self.counts)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn run(seeds: [u64; 2], trials: u64) -> Run {
        let counts = Counts {
            trials,
            ..Counts::default()
        };
        Run { seeds, counts }
    }

    #[test]
    fn a_run_is_added_to_the_seeds_before_it_and_replaces_any_others() {
        let mut record = Record::default();
        record.put("other", run([0, 2], 2));
        for (seeds, trials, kept) in [
            ([0, 10], 10, ([0, 10], 10)),
            ([10, 30], 20, ([0, 30], 30)),
            ([0, 7], 7, ([0, 7], 7)),
        ] {
            record.put("kind", run(seeds, trials));
            let found = &record.0["kind"];
            assert_eq!((found.seeds, found.counts.trials), kept);
        }
        assert_eq!(record.0["other"].seeds, [0, 2]);
    }
}
