//! Random experiments whose truth is known: how often what `identify` states of it holds.
//!
//! ```text
//! seed ──► Lab ──► truth on a finer mesh ──► files with errors ──► identify ──► statements ──► coverage by kind
//! ```
//!
//! One statement that misses is chance; a kind of statement that misses more often than it promises fails the run, and so does one that
//! misses by far.

mod asked;
mod coverage;
mod data;
mod lab;
mod parts;
mod truth;

use std::fmt::Write as _;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::trial::{Counts, Failure, Kind, Trial, demands};
use crate::publish::TaskError;
use asked::{Outcome, Statement};
use data::Measurable;
use lab::Lab;

/// A statement that misses the truth by so many of its half widths is a failure of its own.
const FAR: f64 = 4.0;
/// The kind of trial.
pub(super) struct Experiments;

impl Kind for Experiments {
    fn name(&self) -> &'static str {
        "experiments"
    }

    fn quick(&self) -> Range<u64> {
        0..4
    }

    fn trial(&self, seed: u64) -> Trial {
        let lab = Lab::new(seed);
        let asked = catch_unwind(AssertUnwindSafe(|| asked(&lab)));
        let mut trial = Trial::of(match &asked {
            Ok(Ok(_)) => "analysed",
            Ok(Err(_)) => "refused",
            Err(_) => "panic",
        });
        for feature in &lab.features {
            trial.counts.feature(feature);
        }
        let fails = |check: &str, found: String| failure(&lab, check, found);
        match asked {
            Ok(Ok(statements)) => {
                for Statement { check, outcome } in statements {
                    let tally = trial.counts.check(&check);
                    match outcome {
                        Outcome::Held => tally.held += 1,
                        Outcome::Unstated => tally.declared += 1,
                        Outcome::Missed(by, message) => {
                            tally.failed += 1;
                            let is_promised = (demands(self.name()).iter())
                                .any(|own| own.name == check && own.promise.is_some());
                            if by > FAR && is_promised {
                                trial.failures.push(fails(
                                    &check,
                                    format!("missed by {by:.1} half widths: {message}"),
                                ));
                            }
                        }
                    }
                }
            }
            // Every laboratory measures enough to be analysed.
            Ok(Err(error)) => trial.failures.push(fails("refused", error.to_string())),
            Err(_) => trial.failures.push(fails("panic", "panic".to_owned())),
        }
        trial
    }

    fn table(&self, counts: &Counts) -> String {
        let mut text = "\n| statement | what holds the truth | stated | held | missed | not identifiable | coverage, with its interval of 95 % |\n"
            .to_owned();
        text += "| --- | --- | --: | --: | --: | --: | --- |\n";
        for own in demands(self.name()) {
            let tally = counts.tally(&own.name);
            let [stated, held] = coverage::counts(tally);
            let covered = if stated == 0 {
                "–".to_owned()
            } else {
                let [low, high] = coverage::interval(held, stated).map(|p| 100.0 * p);
                let part = 100.0 * held as f64 / stated as f64;
                format!("{part:.1} % ({low:.1} … {high:.1})")
            };
            // Writing into a string does not fail.
            let _ = writeln!(
                text,
                "| {} | {} | {stated} | {held} | {} | {} | {covered} |",
                own.name, own.demands, tally.failed, tally.declared
            );
        }
        text
    }

    fn broken(&self, counts: &Counts) -> Vec<String> {
        let broken = demands(self.name()).iter().filter_map(|own| {
            let tally = counts.tally(&own.name);
            let [stated, held] = coverage::counts(tally);
            let promise = own.promise?;
            let chance = coverage::at_most(held, stated, promise);
            (chance < coverage::LEVEL).then(|| {
                format!(
                    "{}: {held} of {stated} hold, where {:.0} % are promised; by chance so few or fewer would once in {:.0}",
                    own.name,
                    100.0 * promise,
                    1.0 / chance
                )
            })
        });
        broken.collect()
    }
}

fn asked(lab: &Lab) -> Result<Vec<Statement>, TaskError> {
    let folder = tempfile::tempdir()?;
    let data = Measurable::new(lab, folder.path())?;
    asked::statements(lab, &data)
}

fn failure(lab: &Lab, check: &str, found: String) -> Failure {
    let mut case = lab.values();
    case["found"] = format!("{check}: {found}").into();
    Failure {
        seed: lab.seed,
        check: check.to_owned(),
        found,
        extension: "json",
        case: format!("{case:#}\n").into_bytes(),
    }
}
