//! Problems made of what is at hand where they are found.

use std::io;

use super::{SceneProblem, nearest};

impl SceneProblem {
    /// Two settings that contradict each other.
    pub fn conflict(message: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self::Conflict {
            message: message.into(),
            remedy: remedy.into(),
        }
    }

    /// A value of another kind than the one that is `expected`.
    pub fn wrong_kind(expected: impl Into<String>, found: impl Into<String>) -> Self {
        Self::WrongKind {
            expected: expected.into(),
            found: found.into(),
        }
    }

    /// A choice `found` that is not among the `known` ones.
    pub fn unknown_name<'a>(
        what: &str,
        found: &str,
        known: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let known = owned(known);
        Self::UnknownName {
            what: what.to_owned(),
            found: found.to_owned(),
            nearest: nearest_of(found, &known),
            known,
        }
    }

    /// A key that is not among the `known` ones.
    pub fn unknown_key<'a>(key: &str, known: impl IntoIterator<Item = &'a str>) -> Self {
        let known = owned(known);
        Self::UnknownKey {
            key: key.to_owned(),
            nearest: nearest_of(key, &known),
            known,
        }
    }

    /// A name of something that is not among the `known` ones.
    pub fn undefined(what: &'static str, name: &str, known: Vec<String>) -> Self {
        Self::Undefined {
            what,
            name: name.to_owned(),
            nearest: nearest_of(name, &known),
            known,
        }
    }

    /// A table that holds the entries `found` and not exactly one of the `choices`.
    pub fn one_of<'a>(
        table: &str,
        choices: impl Into<String>,
        found: impl IntoIterator<Item = &'a str>,
    ) -> Self {
        let found: Vec<&str> = found.into_iter().collect();
        Self::OneOf {
            table: table.to_owned(),
            choices: choices.into(),
            found: match found.as_slice() {
                [] => "none".to_owned(),
                found => found.join(", "),
            },
        }
    }

    /// A `value` of the key `key`, given in full, that is not what is `allowed`.
    pub fn out_of_range(key: &str, value: &str, allowed: impl Into<String>) -> Self {
        Self::OutOfRange {
            key: short(key),
            value: value.to_owned(),
            allowed: allowed.into(),
        }
    }

    /// A file that cannot be read.
    pub fn unreadable(path: String, error: &io::Error) -> Self {
        let cause = error.to_string();
        Self::Unreadable { path, cause }
    }
}

fn owned<'a>(names: impl IntoIterator<Item = &'a str>) -> Vec<String> {
    names.into_iter().map(str::to_owned).collect()
}

fn nearest_of(name: &str, known: &[String]) -> Option<String> {
    nearest(name, known.iter().map(String::as_str)).map(str::to_owned)
}

/// The last name of a key, with the index of a list entry: `angles[2]`.
fn short(key: &str) -> String {
    let (rest, last) = key.rsplit_once('.').unwrap_or(("", key));
    match last.parse::<usize>() {
        Ok(index) if !rest.is_empty() => format!("{}[{index}]", short(rest)),
        _ => last.to_owned(),
    }
}
