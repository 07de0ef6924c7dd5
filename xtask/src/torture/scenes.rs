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

use std::collections::BTreeSet;
use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Duration;

use serde_json::Value;

use super::trial::{Failure, Kind, Trial};
use super::{draw, quantity, trial};
use checks::{Check, checks};
use draw::Draw;
pub(super) use replay::replay;
use sample::{Sample, Verdict, solve};

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

    fn trial(&self, seed: u64) -> Trial {
        let scene = random::scene(seed);
        let solved = catch_unwind(AssertUnwindSafe(|| solve(&scene)));
        let sample = match solved {
            Ok(Ok(sample)) => sample,
            Ok(Err(none)) => return Trial::of(none.outcome()),
            Err(_) => {
                return Trial {
                    failures: vec![failure(seed, "panic", "panic", &scene)],
                    ..Trial::of("panic")
                };
            }
        };
        let mut trial = Trial::of("solved");
        for feature in features(&sample) {
            trial.counts.feature(feature);
        }
        let mut draw = Draw::new(seed, 2);
        for check in checks() {
            // Drawn for every check, so that the choice of one does not hang on others.
            if draw.chance(check.share) {
                self.make(&check, seed, &sample, &mut trial);
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

/// What the scene holds.
fn features(sample: &Sample) -> BTreeSet<String> {
    let scene = &sample.value;
    let chosen = |pointer: &str, default: &str| {
        let own = scene.pointer(pointer).and_then(Value::as_str);
        own.unwrap_or(default).to_owned()
    };
    let mut held = BTreeSet::from([
        format!("model {}", if sample.is_half() { "half" } else { "whole" }),
        format!("solver {}", chosen("/analysis/solver", "auto")),
        format!("plane {}", chosen("/analysis/plane", "stress")),
        format!("element {}", chosen("/mesh/element", "Q8")),
        format!("contacts {}", sample.scene.contacts.len()),
    ]);
    let named = |what: &str, table: &Value| -> Vec<String> {
        let keys = table.as_object().into_iter().flatten();
        keys.map(|(key, _)| format!("{what} {key}")).collect()
    };
    for contact in quantity::list(scene, "contacts") {
        held.extend(named("friction", &contact["friction"]));
        for key in ["gap", "projection"] {
            held.extend(contact[key].as_str().map(|value| format!("{key} {value}")));
        }
        held.extend(contact.get("interference").map(|_| "interference".into()));
    }
    for (_, material) in quantity::table(scene, "materials") {
        held.extend(named("material", material));
    }
    for (_, body) in quantity::table(scene, "bodies") {
        held.extend(named("shape", &body["shape"]));
        let own = ["rigid", "mesh"]
            .into_iter()
            .filter(|key| body.get(key).is_some());
        held.extend(own.map(|key| format!("body {key}")));
    }
    for load in quantity::list(scene, "loads") {
        let keys = load.as_object().into_iter().flatten();
        let kinds = keys.filter(|(_, part)| part.is_object());
        held.extend(kinds.map(|(name, _)| format!("load {name}")));
    }
    let own = ["failure", "platens"]
        .into_iter()
        .filter(|key| scene.get(key).is_some());
    held.extend(own.map(str::to_owned));
    held
}

#[cfg(test)]
mod tests;
