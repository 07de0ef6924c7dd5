//! Names that an override has mistyped.

use serde_json::Value;

use crate::diagnostic::SceneProblem;
use crate::document::{Document, child};

/// Tables of named things, and what each of their entries is.
const NAMED: [(&str, &str); 3] = [
    ("bodies", "body"),
    ("materials", "material"),
    ("plies", "ply"),
];

/// A mistyped name in an override makes an entry of its own, which then lacks what such an entry needs: says so of a `problem` at `key`,
/// if it is of that kind.
pub(crate) fn mistyped(document: &Document, key: &str, problem: SceneProblem) -> SceneProblem {
    let mut segments = key.split('.');
    let (Some(table), Some(name)) = (segments.next(), segments.next()) else {
        return problem;
    };
    let kind = NAMED.iter().find(|(named, _)| *named == table);
    let lacks = matches!(
        problem,
        SceneProblem::MissingKey { .. } | SceneProblem::OneOf { .. }
    );
    let (Some((_, what)), true, true) = (kind, lacks, document.is_overridden(&child(table, name)))
    else {
        return problem;
    };
    let Some(Value::Object(entries)) = document.get(table) else {
        return problem;
    };
    let known: Vec<String> = (entries.keys())
        .filter(|other| !document.is_overridden(&child(table, other)))
        .cloned()
        .collect();
    if known.is_empty() {
        return problem;
    }
    SceneProblem::undefined(what, name, known)
}
