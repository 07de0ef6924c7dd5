//! The counts of all kinds: kept as JSON beside the documents, and shown as a page.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use stickslip_report::folder::write_atomic;

use super::open::OPEN;
use super::trial::{Counts, Kind};
use crate::publish::Trouble;

/// Counts by kind, with the seeds that they come from.
#[derive(Debug, Default, Serialize, Deserialize)]
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

impl Record {
    /// The record that lies beside the documents; an empty one if there is none.
    pub(super) fn kept() -> Result<Self, Trouble> {
        match std::fs::read(docs().join("torture.json")) {
            Ok(bytes) => Ok(serde_json::from_slice(&bytes)?),
            Err(error) if error.kind() == std::io::ErrorKind::NotFound => Ok(Self::default()),
            Err(error) => Err(error.into()),
        }
    }

    /// Puts the run of a kind in the place of its last one.
    pub(super) fn put(&mut self, kind: &str, run: Run) {
        self.0.insert(kind.to_owned(), run);
    }

    /// Writes record and page beside the documents.
    pub(super) fn write(&self, kinds: &[Box<dyn Kind>]) -> Result<(), Trouble> {
        let text = serde_json::to_string_pretty(self)? + "\n";
        write_atomic(&docs().join("torture.json"), text.as_bytes())?;
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
            for open in OPEN {
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
            checks,
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
        text += "\n| check | demands; tolerance relative to the largest of its kind | held | declared | no second answer | failed |\n";
        text += "| --- | --- | --: | --: | --: | --: |\n";
        for (name, demands) in kind.checks() {
            let tally = checks.get(name).copied().unwrap_or_default();
            let _ = writeln!(
                text,
                "| {name} | {demands} | {} | {} | {} | {} |",
                tally.held, tally.declared, tally.unanswered, tally.failed
            );
        }
        text
    }
}
