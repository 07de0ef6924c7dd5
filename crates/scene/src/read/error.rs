//! What goes wrong while reading, in the words of a person.

use std::fmt;

use serde::de::{self, Unexpected};
use serde_json::Value;

use crate::diagnostic::{SceneProblem, nearest};
use crate::document::{Part, child};
use crate::examples::example;
use crate::units::{Expected, parse};

/// A problem, and its key, which an enclosing table adds.
#[derive(Debug)]
pub struct ReadError {
    pub problem: Box<SceneProblem>,
    pub key: Option<String>,
    pub part: Part,
}

impl ReadError {
    pub(super) fn new(problem: SceneProblem, part: Part) -> Self {
        Self {
            problem: Box::new(problem),
            key: None,
            part,
        }
    }

    pub(super) fn at(mut self, key: &str) -> Self {
        if self.key.is_none() {
            // Serde knows the name of a missing key, but not that of the table.
            if let SceneProblem::MissingKey {
                table,
                example: line,
                key: missing,
            } = self.problem.as_mut()
            {
                key.clone_into(table);
                *line = example(&child(key, missing));
            }
            self.key = Some(key.to_owned());
        }
        self
    }
}

impl fmt::Display for ReadError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        self.problem.fmt(formatter)
    }
}

impl std::error::Error for ReadError {}

fn owned(words: &[&str]) -> Vec<String> {
    words.iter().map(|word| (*word).to_owned()).collect()
}

impl de::Error for ReadError {
    fn custom<T: fmt::Display>(message: T) -> Self {
        Self::new(
            SceneProblem::Refused {
                message: message.to_string(),
            },
            Part::Value,
        )
    }

    fn invalid_type(found: Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        let found = in_words(found);
        let expected = wanted(&expected.to_string());
        Self::new(SceneProblem::WrongKind { expected, found }, Part::Value)
    }

    fn invalid_value(found: Unexpected<'_>, expected: &dyn de::Expected) -> Self {
        Self::invalid_type(found, expected)
    }

    fn invalid_length(length: usize, expected: &dyn de::Expected) -> Self {
        let values = if length == 1 { "value" } else { "values" };
        let found = format!("a list of {length} {values}");
        let expected = wanted(&expected.to_string());
        Self::new(SceneProblem::WrongKind { expected, found }, Part::Value)
    }

    fn unknown_field(field: &str, known: &'static [&'static str]) -> Self {
        let problem = SceneProblem::UnknownKey {
            key: field.to_owned(),
            nearest: nearest(field, known.iter().copied()).map(str::to_owned),
            known: owned(known),
        };
        Self::new(problem, Part::Key)
    }

    fn unknown_variant(variant: &str, known: &'static [&'static str]) -> Self {
        let problem = SceneProblem::UnknownName {
            what: "one of the choices".to_owned(),
            found: variant.to_owned(),
            nearest: nearest(variant, known.iter().copied()).map(str::to_owned),
            known: owned(known),
        };
        Self::new(problem, Part::Value)
    }

    fn missing_field(field: &'static str) -> Self {
        let problem = SceneProblem::MissingKey {
            key: field.to_owned(),
            table: String::new(),
            example: String::new(),
        };
        Self::new(problem, Part::Key)
    }
}

const TABLE: &str = "a table, such as { key = value }";

/// Serde's names of what it wants, as a person would say them.
fn wanted(expected: &str) -> String {
    match expected {
        "f64" => "a number",
        "u64" | "usize" => "a whole number, at least 0",
        "a string" => "a text in quotes",
        "a boolean" => "true or false",
        "a sequence" => "a list",
        "a map" => TABLE,
        other if other.starts_with("struct ") => TABLE,
        other => {
            let length = other.strip_prefix("an array of length ");
            return length.map_or_else(
                || other.to_owned(),
                |length| format!("a list of {length} values"),
            );
        }
    }
    .to_owned()
}

fn in_words(found: Unexpected<'_>) -> String {
    match found {
        Unexpected::Str(text) => format!("the text \"{text}\""),
        Unexpected::Bool(flag) => format!("{flag}"),
        Unexpected::Unsigned(number) => format!("the number {number}"),
        Unexpected::Signed(number) => format!("the number {number}"),
        Unexpected::Float(number) => format!("the number {number}"),
        Unexpected::Seq => "a list".to_owned(),
        Unexpected::Map => "a table".to_owned(),
        Unexpected::Unit | Unexpected::Option => "nothing".to_owned(),
        other => other.to_string(),
    }
}

/// Reads the quantity `value`, a text with its unit, in base units.
///
/// # Errors
/// A value of another kind, no unit, an unknown one, or one of a dimension that is not `expected`.
pub fn quantity(value: &Value, expected: &Expected) -> Result<f64, Box<SceneProblem>> {
    let text = match value {
        Value::String(text) => text.clone(),
        Value::Number(number) => number.to_string(),
        other => {
            let expected = format!("{expected} with its unit in quotes");
            let problem = SceneProblem::wrong_kind(expected, described(other));
            return Err(Box::new(problem));
        }
    };
    match parse(&text, expected) {
        Ok((number, _)) => Ok(number),
        Err(error) => Err(Box::new(error.into())),
    }
}

/// The value as a person would call it.
pub(crate) fn described(value: &Value) -> String {
    match value {
        Value::Null => in_words(Unexpected::Unit),
        Value::Bool(flag) => in_words(Unexpected::Bool(*flag)),
        Value::Number(number) => format!("the number {number}"),
        Value::String(text) => in_words(Unexpected::Str(text)),
        Value::Array(_) => in_words(Unexpected::Seq),
        Value::Object(_) => in_words(Unexpected::Map),
    }
}
