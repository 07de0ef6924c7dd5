//! Random scenes: conditions from what is written of each answer, and relations to answers of the same scene seen another way.

mod answer;
mod balance;
mod bound;
mod checks;
mod conditions;
mod display;
mod random;
mod relations;
mod replay;
mod sample;
mod shrink;
mod spelling;
mod sweeps;
mod transform;

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use serde_json::Value;

use super::trial::{Counts, Failure, Kind, Trial};
use super::{draw, quantity};
use checks::{Check, checks};
use draw::Draw;
pub(super) use replay::replay;
use sample::{NoAnswer, Sample, Verdict, solve};

/// Time and questions that shrinking a failure may take.
const SHRINKING: (Duration, usize) = (Duration::from_secs(60), 400);

/// The kind of trial.
pub(super) struct Scenes {
    /// Whether failures are made smaller.
    pub(super) shrinks: bool,
}

impl Kind for Scenes {
    fn name(&self) -> &'static str {
        "scenes"
    }

    fn quick(&self) -> Range<u64> {
        0..60
    }

    fn checks(&self) -> Vec<(&'static str, &'static str)> {
        checks().map(|check| (check.name, check.demands)).collect()
    }

    fn trial(&self, seed: u64) -> Trial {
        let scene = random::scene(seed);
        let solved = catch_unwind(AssertUnwindSafe(|| solve(&scene)));
        let sample = match solved {
            Ok(Ok(sample)) => sample,
            Ok(Err(NoAnswer::Refused(_))) => return counted("refused"),
            Ok(Err(NoAnswer::Impossible(_))) => return counted("proved impossible"),
            Ok(Err(NoAnswer::Unsolved(_))) => return counted("not solved"),
            Err(_) => return panicked(seed, &scene, "panic"),
        };
        let mut trial = counted("solved");
        features(&sample, &mut trial.counts);
        let mut draw = Draw::new(seed, 2);
        for check in checks() {
            // Drawn for every check, so that the choice of one does not hang on others.
            if draw.chance(check.share) {
                self.make(check, seed, &sample, &mut trial);
            }
        }
        trial
    }
}

impl Scenes {
    fn make(&self, check: &Check, seed: u64, sample: &Sample, trial: &mut Trial) {
        let verdict = catch_unwind(AssertUnwindSafe(|| (check.verdict)(sample)));
        let verdict = verdict.unwrap_or_else(|_| Verdict::Fails("panic".into()));
        let tally = trial.counts.check(check.name);
        match verdict {
            Verdict::Beside => {}
            Verdict::Holds => tally.held += 1,
            Verdict::Declared(_) => tally.declared += 1,
            Verdict::Unanswered(_) => tally.unanswered += 1,
            Verdict::Fails(found) => {
                tally.failed += 1;
                let (scene, found) = if self.shrinks {
                    shrunk(check, &sample.value, found)
                } else {
                    (sample.value.clone(), found)
                };
                trial
                    .failures
                    .push(failure(seed, check.name, &found, &scene));
            }
        }
    }
}

fn counted(outcome: &str) -> Trial {
    Trial {
        counts: Counts::of(outcome),
        failures: Vec::new(),
    }
}

fn panicked(seed: u64, scene: &Value, found: &str) -> Trial {
    Trial {
        counts: Counts::of("panic"),
        failures: vec![failure(seed, "panic", found, scene)],
    }
}

/// The smallest scene found in which `check` fails, and what it finds there.
fn shrunk(check: &Check, scene: &Value, found: String) -> (Value, String) {
    let mut last = found;
    let mut fails = |candidate: &Value| {
        let verdict = catch_unwind(AssertUnwindSafe(|| {
            solve(candidate).map(|sample| (check.verdict)(&sample))
        }));
        match verdict {
            Ok(Ok(Verdict::Fails(found))) => {
                last = found;
                true
            }
            _ => false,
        }
    };
    let (time, tries) = SHRINKING;
    let small = shrink::shrink(scene, time, tries, &mut fails);
    (small, last)
}

/// The case as TOML, with the check that fails in its title.
fn failure(seed: u64, check: &str, found: &str, scene: &Value) -> Failure {
    let mut scene = scene.clone();
    scene["title"] = format!("{check}: {found}").into();
    scene["description"] = format!("seed {seed}").into();
    let text = spelling::toml(&scene).unwrap_or_else(|_| scene.to_string());
    Failure {
        seed,
        check: check.to_owned(),
        found: found.to_owned(),
        extension: "toml",
        case: text.into_bytes(),
    }
}

/// Counts what the scene holds.
fn features(sample: &Sample, counts: &mut Counts) {
    let mut held = vec![format!(
        "model {}",
        if sample.is_half() { "half" } else { "whole" }
    )];
    let scene = &sample.value;
    held.push(format!(
        "solver {}",
        scene["analysis"]["solver"].as_str().unwrap_or("auto")
    ));
    held.push(format!(
        "plane {}",
        scene["analysis"]["plane"].as_str().unwrap_or("stress")
    ));
    held.push(format!(
        "element {}",
        scene["mesh"]["element"].as_str().unwrap_or("Q8")
    ));
    held.push(format!("contacts {}", sample.scene.contacts.len()));
    for (list, what) in [("contacts", "friction"), ("materials", "material")] {
        let entries: Vec<&Value> = match &scene[list] {
            Value::Array(entries) => entries.iter().collect(),
            Value::Object(entries) => entries.values().collect(),
            _ => Vec::new(),
        };
        for entry in entries {
            let table = if list == "contacts" {
                &entry["friction"]
            } else {
                entry
            };
            held.extend(
                table
                    .as_object()
                    .into_iter()
                    .flatten()
                    .map(|(name, _)| format!("{what} {name}")),
            );
            for key in ["gap", "projection"] {
                held.extend(
                    entry
                        .get(key)
                        .and_then(Value::as_str)
                        .map(|value| format!("{key} {value}")),
                );
            }
            if entry.get("interference").is_some() {
                held.push("interference".into());
            }
        }
    }
    for (_, body) in quantity::table(scene, "bodies") {
        held.extend(
            body["shape"]
                .as_object()
                .into_iter()
                .flatten()
                .map(|(name, _)| format!("shape {name}")),
        );
        for key in ["rigid", "mesh"] {
            if body.get(key).is_some() {
                held.push(format!("body {key}"));
            }
        }
    }
    for load in quantity::list(scene, "loads") {
        let kinds = load
            .as_object()
            .into_iter()
            .flatten()
            .filter(|(_, part)| part.is_object());
        held.extend(kinds.map(|(name, _)| format!("load {name}")));
    }
    for key in ["failure", "platens"] {
        if scene.get(key).is_some() {
            held.push(key.into());
        }
    }
    held.sort();
    held.dedup();
    for feature in held {
        *counts.features.entry(feature).or_default() += 1;
    }
}

#[cfg(test)]
mod tests;
