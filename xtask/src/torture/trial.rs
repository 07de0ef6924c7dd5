//! What a kind of trial is, and what one trial leaves behind.

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;
use std::sync::LazyLock;

use serde::{Deserialize, Serialize};

use crate::publish::compiled_in;

/// A check, as `checks.toml` has it.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Demand {
    pub(crate) name: String,
    /// What it demands, for the page.
    pub(crate) demands: String,
    /// In what part of the trials it is made.
    #[serde(default = "always")]
    pub(crate) share: f64,
    /// How often a statement is to hold; nothing where nothing is promised.
    pub(crate) promise: Option<f64>,
}

fn always() -> f64 {
    1.0
}

/// The checks of the kind of trial of that name, in the order of the page.
pub(crate) fn demands(kind: &str) -> &'static [Demand] {
    static ALL: LazyLock<BTreeMap<String, Vec<Demand>>> =
        LazyLock::new(|| compiled_in(toml::from_str(include_str!("checks.toml"))));
    ALL.get(kind).map_or(&[], Vec::as_slice)
}

/// A kind of trial: draws something from a seed, tries it, and counts.
pub(crate) trait Kind: Sync {
    /// Name on the command line, in the record and of the folder of failures.
    fn name(&self) -> &'static str;

    /// Seeds of a run with `--quick`.
    fn quick(&self) -> Range<u64>;

    /// What keeps this kind from being tried on this machine.
    fn lacks(&self) -> Option<String> {
        None
    }

    /// The checks of a run as a table of Markdown.
    fn table(&self, counts: &Counts) -> String {
        let mut text = "\n| check | demands; tolerance relative to the largest of its kind | held | declared | no second answer | failed |\n"
            .to_owned();
        text += "| --- | --- | --: | --: | --: | --: |\n";
        for Demand { name, demands, .. } in demands(self.name()) {
            let tally = counts.tally(name);
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {name} | {demands} | {} | {} | {} | {} |",
                tally.held, tally.declared, tally.unanswered, tally.failed
            );
        }
        text
    }

    /// What the counts of a whole run do not hold, in a line each.
    fn broken(&self, _counts: &Counts) -> Vec<String> {
        Vec::new()
    }

    /// Tries what `seed` draws. Equal seeds give equal trials, on any thread.
    fn trial(&self, seed: u64) -> Trial;
}

/// How often a check was made, and how it came out.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Tally {
    /// It held.
    pub(crate) held: u64,
    /// It did not hold, and the results say why it need not.
    pub(crate) declared: u64,
    /// There was nothing to compare with, because a second answer that may be missing was.
    pub(crate) unanswered: u64,
    /// It did not hold.
    pub(crate) failed: u64,
}

impl Tally {
    fn add(&mut self, other: &Self) {
        self.held += other.held;
        self.declared += other.declared;
        self.unanswered += other.unanswered;
        self.failed += other.failed;
    }
}

/// What has been counted in some trials of a kind.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize)]
pub(crate) struct Counts {
    /// Trials.
    pub(crate) trials: u64,
    /// What became of them, such as "solved".
    pub(crate) outcomes: BTreeMap<String, u64>,
    /// What they held, such as "friction slip_power".
    pub(crate) features: BTreeMap<String, u64>,
    /// Checks by name.
    pub(crate) checks: BTreeMap<String, Tally>,
}

impl Counts {
    /// Counts one trial that ended as `outcome`.
    pub(crate) fn of(outcome: impl Into<String>) -> Self {
        let mut counts = Self {
            trials: 1,
            ..Self::default()
        };
        counts.outcomes.insert(outcome.into(), 1);
        counts
    }

    /// The tally of `check`.
    pub(crate) fn tally(&self, check: &str) -> Tally {
        self.checks.get(check).copied().unwrap_or_default()
    }

    /// Counts trials that hold `feature`.
    pub(crate) fn feature(&mut self, feature: impl Into<String>) {
        *self.features.entry(feature.into()).or_default() += 1;
    }

    /// The tally of `check`, to be added to.
    pub(crate) fn check(&mut self, check: &str) -> &mut Tally {
        self.checks.entry(check.to_owned()).or_default()
    }

    /// Adds the counts of further trials.
    pub(crate) fn add(&mut self, other: &Self) {
        self.trials += other.trials;
        for (sum, more) in [
            (&mut self.outcomes, &other.outcomes),
            (&mut self.features, &other.features),
        ] {
            for (name, count) in more {
                *sum.entry(name.clone()).or_default() += count;
            }
        }
        for (name, tally) in &other.checks {
            self.check(name).add(tally);
        }
    }
}

/// A check that did not hold.
#[derive(Clone, Debug)]
pub(crate) struct Failure {
    /// Seed of the trial.
    pub(crate) seed: u64,
    /// Name of the check.
    pub(crate) check: String,
    /// What was found, in one line.
    pub(crate) found: String,
    /// Ending of the file that holds the case, such as "toml".
    pub(crate) extension: &'static str,
    /// The case, as small as it could be made.
    pub(crate) case: Vec<u8>,
}

/// One trial.
#[derive(Clone, Debug, Default)]
pub(crate) struct Trial {
    /// What was counted.
    pub(crate) counts: Counts,
    /// What did not hold.
    pub(crate) failures: Vec<Failure>,
}

impl Trial {
    /// A trial that ended as `outcome`.
    pub(crate) fn of(outcome: impl Into<String>) -> Self {
        Self {
            counts: Counts::of(outcome),
            failures: Vec::new(),
        }
    }
}
