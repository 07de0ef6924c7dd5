//! What can be wrong with a sweep, as errors at its keys.

use stickslip_scene::diagnostic::{SceneError, SceneProblem, nearest};
use stickslip_scene::document::{Document, Part};

/// Values that do not go together.
pub(super) fn conflict(
    document: &Document,
    key: &str,
    message: impl Into<String>,
    remedy: impl Into<String>,
) -> SceneError {
    let problem = SceneProblem::Conflict {
        message: message.into(),
        remedy: remedy.into(),
    };
    document.error(key, Part::Value, problem)
}

/// A name that is not among `known`.
pub(super) fn unknown<'a>(
    document: &Document,
    key: &str,
    what: &str,
    found: &str,
    known: impl IntoIterator<Item = &'a str>,
) -> SceneError {
    let known: Vec<&str> = known.into_iter().collect();
    let problem = SceneProblem::UnknownName {
        what: what.to_owned(),
        found: found.to_owned(),
        nearest: nearest(found, known.iter().copied()).map(str::to_owned),
        known: known.into_iter().map(str::to_owned).collect(),
    };
    document.error(key, Part::Value, problem)
}
