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

use std::fmt::Write as _;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};

use super::trial::{Counts, Failure, Kind, Trial};
use crate::publish::Trouble;
use asked::{Outcome, Statement};
use data::Measurable;
use lab::Lab;

/// A statement that misses the truth by so many of its half widths is a failure of its own.
const FAR: f64 = 4.0;
/// What intervals of 95 % promise.
const PROMISE: f64 = 0.95;

/// A kind of statement.
struct Stated {
    name: &'static str,
    demands: &'static str,
    /// How often it is to hold; `None` where nothing is promised.
    promise: Option<f64>,
}

const fn of(name: &'static str, demands: &'static str) -> Stated {
    Stated {
        name,
        demands,
        promise: Some(PROMISE),
    }
}

const fn unpromised(name: &'static str, demands: &'static str) -> Stated {
    Stated {
        name,
        demands,
        promise: None,
    }
}

/// All kinds of statements.
const STATED: &[Stated] = &[
    of(
        "dynamic friction",
        "interval or bound of μd by all slip zones",
    ),
    of("friction of a zone", "the same by one zone"),
    of("static friction", "lower bound of μs"),
    of(
        "pressure",
        "1.96 deviations at a random place of the edge, squared those of noise and of 1 % of the largest hoop stress, an error of the mesh that no band holds; not where a warning says that a dilation stays in the stresses",
    ),
    of("shear", "the same"),
    of("hoop stress", "the same"),
    unpromised(
        "largest pressure",
        "the same at the place of the largest one, which is too large as a rule",
    ),
    unpromised("largest shear", "the same"),
    unpromised("largest hoop stress", "the same"),
    of("force", "the true force on the edge is not doubted"),
    of(
        "wrong force",
        "one that is wrong by a fifth is, or the check says that it is no evidence",
    ),
    of("bearing", "the true bearing point is not doubted"),
    unpromised(
        "wrong bearing",
        "one that is off by 30° to 180° is, where all of the contact is in sight",
    ),
    unpromised(
        "wrong bearing, contact cut",
        "the same where the region cuts the contact, of which half may bear at more than one place",
    ),
    of("load", "the true load is not doubted"),
    of("wrong load", "three times and a third of it are"),
    of(
        "dilation",
        "1.96 standard deviations of the picture's dilation",
    ),
    of(
        "rotation",
        "1.96 standard deviations of the specimen's rotation, where errors are independent, as they are stated for",
    ),
    of("law coulomb: mu", "interval or bound, where the law holds"),
    of("law static_dynamic: static", "the same"),
    of("law static_dynamic: dynamic", "the same"),
    of("law slip_power: static", "the same"),
    of("law slip_power: dynamic", "the same"),
    of("law slip_power: slip_scale", "the same"),
    of(
        "choice of law",
        "no law with more parameters than the true one is preferred, and that is not ruled out",
    ),
    unpromised(
        "law coulomb: mu, model wrong",
        "where clearance, load, modulus, dilation, scale or origin are a little wrong",
    ),
    unpromised("law static_dynamic: static, model wrong", "the same"),
    unpromised("law static_dynamic: dynamic, model wrong", "the same"),
    unpromised("law slip_power: static, model wrong", "the same"),
    unpromised("law slip_power: dynamic, model wrong", "the same"),
    unpromised("law slip_power: slip_scale, model wrong", "the same"),
];

/// The kind of trial.
pub(super) struct Experiments;

impl Kind for Experiments {
    fn name(&self) -> &'static str {
        "experiments"
    }

    fn quick(&self) -> Range<u64> {
        0..4
    }

    fn checks(&self) -> Vec<(&'static str, &'static str)> {
        (STATED.iter().map(|own| (own.name, own.demands))).collect()
    }

    fn trial(&self, seed: u64) -> Trial {
        let lab = Lab::new(seed);
        let asked = catch_unwind(AssertUnwindSafe(|| asked(&lab)));
        let mut trial = Trial {
            counts: Counts::of(match &asked {
                Ok(Ok(_)) => "analysed",
                Ok(Err(_)) => "refused",
                Err(_) => "panic",
            }),
            failures: Vec::new(),
        };
        for feature in &lab.features {
            *trial.counts.features.entry(feature.clone()).or_default() += 1;
        }
        let fails = |check: &str, found: String| failure(&lab, check, found);
        match asked {
            Ok(Ok(statements)) => {
                for Statement { check, outcome } in statements {
                    let tally = trial.counts.check(&check);
                    match outcome {
                        Outcome::Held => tally.held += 1,
                        Outcome::Unstated => tally.declared += 1,
                        Outcome::Missed(by, words) => {
                            tally.failed += 1;
                            let is_promised = (STATED.iter())
                                .any(|own| own.name == check && own.promise.is_some());
                            if by > FAR && is_promised {
                                trial.failures.push(fails(
                                    &check,
                                    format!("missed by {by:.1} half widths: {words}"),
                                ));
                            }
                        }
                    }
                }
            }
            // Every laboratory measures enough to be analysed.
            Ok(Err(trouble)) => trial.failures.push(fails("refused", trouble.to_string())),
            Err(_) => trial.failures.push(fails("panic", "panic".to_owned())),
        }
        trial
    }

    fn table(&self, counts: &Counts) -> String {
        let mut text = "\n| statement | what holds the truth | stated | held | missed | not identifiable | coverage, with its interval of 95 % |\n"
            .to_owned();
        text += "| --- | --- | --: | --: | --: | --: | --- |\n";
        for own in STATED {
            let tally = counts.checks.get(own.name).copied().unwrap_or_default();
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
        let broken = STATED.iter().filter_map(|own| {
            let tally = counts.checks.get(own.name).copied().unwrap_or_default();
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

fn asked(lab: &Lab) -> Result<Vec<Statement>, Trouble> {
    let folder = tempfile::tempdir()?;
    let data = Measurable::new(lab, folder.path())?;
    asked::statements(lab, &data)
}

fn failure(lab: &Lab, check: &str, found: String) -> Failure {
    let mut case = lab.told();
    case["found"] = format!("{check}: {found}").into();
    Failure {
        seed: lab.seed,
        check: check.to_owned(),
        found,
        extension: "json",
        case: format!("{case:#}\n").into_bytes(),
    }
}
