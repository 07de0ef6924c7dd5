//! A scene as a tree of values that remember where they were written.
//!
//! TOML and JSON arrive at the same tree. A key is written as in `--set`: `contacts.0.friction.coulomb.mu`.

mod duplicate;

use std::collections::BTreeMap;
use std::ops::Range;
use std::sync::Arc;

use serde_json::{Map, Value};
use stickslip_text::plain::is_control;
use toml::de::{DeTable, DeValue};

use crate::diagnostic::{Finding, SceneError, SceneProblem, SourceText, offset_of};
use crate::host::Host;
pub use stickslip_text::dotted::child;
use stickslip_text::json;

/// The two spellings of a scene.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Format {
    /// TOML 1.0.
    Toml,
    /// JSON (RFC 8259).
    Json,
}

impl Format {
    /// JSON for names that end in `.json`, otherwise TOML.
    pub fn of_path(path: &std::path::Path) -> Self {
        match path.extension() {
            Some(extension) if extension.eq_ignore_ascii_case("json") => Self::Json,
            _ => Self::Toml,
        }
    }
}

/// Which part of an entry a problem is shown at.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Part {
    /// Its key.
    Key,
    /// Its value.
    Value,
}

/// Where an entry stands.
#[derive(Debug, Clone)]
pub struct Place {
    /// The text it stands in.
    pub source: Arc<SourceText>,
    /// Bytes of its key; list entries have none.
    pub key: Option<Range<usize>>,
    /// Bytes of its value.
    pub value: Range<usize>,
}

/// The tree and the places of its entries.
#[derive(Debug, Clone)]
pub struct Document {
    /// The text.
    pub source: Arc<SourceText>,
    /// All values.
    pub root: Value,
    /// Where each entry stands, by its key with dots.
    pub places: BTreeMap<String, Place>,
    /// Where the files that it names are, and what reading them may take.
    pub host: Host,
}

/// The part of a key before its last dot.
fn parent(key: &str) -> &str {
    key.rsplit_once('.').map_or("", |(parent, _)| parent)
}

impl Document {
    /// Reads a text; every number in it is finite.
    ///
    /// # Errors
    /// [`SceneError`] at the place that is neither TOML nor JSON.
    pub fn parse(source: SourceText, format: Format) -> Result<Self, SceneError> {
        let mut document = Self {
            source: Arc::new(source),
            root: Value::Null,
            places: BTreeMap::new(),
            host: Host::NONE,
        };
        match format {
            Format::Toml => document.read_toml()?,
            Format::Json => document.read_json()?,
        }
        Ok(document)
    }

    fn read_toml(&mut self) -> Result<(), SceneError> {
        let source = Arc::clone(&self.source);
        let table = DeTable::parse(&source.text).map_err(|error| {
            let cause = error.message().to_owned();
            match error.span() {
                Some(span) if cause == "duplicate key" => self.duplicate_toml(span),
                span => self.syntax("TOML", cause, span),
            }
        })?;
        self.root = self.toml_table(table.get_ref(), "")?;
        Ok(())
    }

    fn toml_table(&mut self, table: &DeTable<'_>, key: &str) -> Result<Value, SceneError> {
        let mut map = Map::new();
        for (name, value) in table {
            let key = child(key, name.get_ref());
            self.note(&key, Some(name.span()), value.span());
            map.insert(
                name.get_ref().to_string(),
                self.toml_value(value.get_ref(), &key)?,
            );
        }
        Ok(Value::Object(map))
    }

    fn toml_value(&mut self, value: &DeValue<'_>, key: &str) -> Result<Value, SceneError> {
        let number = |text: &str| {
            text.replace('_', "")
                .parse::<f64>()
                .ok()
                .and_then(serde_json::Number::from_f64)
        };
        Ok(match value {
            DeValue::String(text) => Value::String(text.to_string()),
            DeValue::Boolean(flag) => Value::Bool(*flag),
            DeValue::Integer(integer) => {
                match i64::from_str_radix(&integer.as_str().replace('_', ""), integer.radix()) {
                    Ok(integer) => integer.into(),
                    Err(_) => return Err(self.not_finite(key, integer.as_str())),
                }
            }
            DeValue::Float(float) => match number(float.as_str()) {
                Some(number) => Value::Number(number),
                None => return Err(self.not_finite(key, float.as_str())),
            },
            DeValue::Datetime(date) => {
                let found = format!("the date {date}");
                let expected = "a text, a number, a list or a table";
                let problem = SceneProblem::wrong_kind(expected, found);
                return Err(self.error(key, Part::Value, problem));
            }
            DeValue::Array(values) => {
                let mut list = Vec::with_capacity(values.len());
                for (index, value) in values.iter().enumerate() {
                    let key = child(key, index);
                    self.note(&key, None, value.span());
                    list.push(self.toml_value(value.get_ref(), &key)?);
                }
                Value::Array(list)
            }
            DeValue::Table(table) => self.toml_table(table, key)?,
        })
    }

    fn read_json(&mut self) -> Result<(), SceneError> {
        let source = Arc::clone(&self.source);
        let root = serde_json::from_str(&source.text).map_err(|error| {
            let at = offset_of(&source.text, error.line(), error.column());
            let cause = error.to_string();
            // serde_json ends its message with the position, which is shown anyway.
            let message = cause
                .rsplit_once(" at line ")
                .map_or(cause.as_str(), |(message, _)| message);
            self.syntax("JSON", message.to_owned(), Some(at..at))
        })?;
        for entry in json::entries(&source.text) {
            if let Some(first) = self.places.get(&entry.path) {
                let first = first.key.clone();
                return Err(self.duplicate(entry.path, first.as_ref(), entry.key));
            }
            self.note(&entry.path, entry.key, entry.value);
        }
        self.root = root;
        Ok(())
    }

    fn note(&mut self, key: &str, name: Option<Range<usize>>, value: Range<usize>) {
        let place = Place {
            source: Arc::clone(&self.source),
            key: name,
            value,
        };
        self.places.insert(key.to_owned(), place);
    }

    /// Refuses texts and keys with control characters, which would steer a terminal or spoil a page that shows them. Line breaks
    /// and tabs may stand in a `description`.
    ///
    /// # Errors
    /// [`SceneError`] at the first text with a control character.
    pub fn check_texts(&self) -> Result<(), SceneError> {
        let found = control_in(&self.root, "", true);
        found.map_or(Ok(()), |(key, part, letter)| {
            let problem = SceneProblem::ControlCharacter { letter };
            Err(self.error(&key, part, problem))
        })
    }

    fn syntax(
        &self,
        format: &'static str,
        cause: String,
        span: Option<Range<usize>>,
    ) -> SceneError {
        SceneError::in_text(SceneProblem::Syntax { format, cause }, &self.source, span)
    }

    fn not_finite(&self, key: &str, value: &str) -> SceneError {
        self.error(
            key,
            Part::Value,
            SceneProblem::NotFinite {
                value: value.to_owned(),
            },
        )
    }

    /// The value at a key.
    pub fn get(&self, key: &str) -> Option<&Value> {
        if key.is_empty() {
            return Some(&self.root);
        }
        key.split('.')
            .try_fold(&self.root, |value, segment| match value {
                Value::Object(map) => map.get(segment),
                Value::Array(list) => list.get(segment.parse::<usize>().ok()?),
                _ => None,
            })
    }

    /// The value at a key that is not empty, to be changed.
    pub fn get_mut(&mut self, key: &str) -> Option<&mut Value> {
        key.split('.')
            .try_fold(&mut self.root, |value, segment| match value {
                Value::Object(map) => map.get_mut(segment),
                Value::Array(list) => list.get_mut(segment.parse::<usize>().ok()?),
                _ => None,
            })
    }

    /// A problem at a key, or at the nearest table around it that was written somewhere.
    pub fn finding(&self, key: &str, part: Part, problem: SceneProblem) -> Finding {
        let mut written = key;
        let place = loop {
            match self.places.get(written) {
                Some(place) => break Some(place),
                None if written.is_empty() => break None,
                None => written = parent(written),
            }
        };
        let is_table = self.get(written).is_some_and(Value::is_object);
        let part = if written != key || is_table {
            Part::Key
        } else {
            part
        };
        let (source, span) = match place {
            Some(place) => {
                let key = place.key.clone().filter(|_| part == Part::Key);
                (&place.source, key.unwrap_or_else(|| place.value.clone()))
            }
            None => (&self.source, 0..0),
        };
        Finding {
            problem,
            key: key.to_owned(),
            source: Arc::clone(source),
            span: Some(span),
        }
    }

    /// Whether the entry `key` comes from an override.
    pub fn is_overridden(&self, key: &str) -> bool {
        let place = self.places.get(key);
        place.is_some_and(|place| !Arc::ptr_eq(&place.source, &self.source))
    }

    /// That `part` of the entry `key` has a `problem`, as an error of its own.
    pub fn error(&self, key: &str, part: Part, problem: SceneProblem) -> SceneError {
        SceneError::new(self.finding(key, part, problem), [])
    }
}

/// The first control character in a value or its keys, with the key.
fn control_in(value: &Value, key: &str, one_line: bool) -> Option<(String, Part, char)> {
    let find = |text: &str, one_line: bool| {
        let refused = |letter: char| is_control(letter) || (one_line && letter.is_control());
        text.chars().find(|letter| refused(*letter))
    };
    match value {
        Value::String(text) => {
            find(text, one_line).map(|letter| (key.to_owned(), Part::Value, letter))
        }
        Value::Array(list) => list
            .iter()
            .enumerate()
            .find_map(|(index, value)| control_in(value, &child(key, index), one_line)),
        Value::Object(map) => map.iter().find_map(|(name, value)| match find(name, true) {
            Some(letter) => Some((child(key, name), Part::Key, letter)),
            None => control_in(value, &child(key, name), name != "description"),
        }),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn toml(text: &str) -> Result<Document, SceneError> {
        Document::parse(
            SourceText {
                name: "a.toml".into(),
                text: text.into(),
            },
            Format::Toml,
        )
    }

    fn json(text: &str) -> Result<Document, SceneError> {
        Document::parse(
            SourceText {
                name: "a.json".into(),
                text: text.into(),
            },
            Format::Json,
        )
    }

    fn shown(document: &Document, key: &str, part: Part) -> String {
        let finding = document.finding(key, part, SceneProblem::MissingVersion { supported: 1 });
        finding.source.text[finding.span.unwrap()].to_owned()
    }

    #[test]
    fn both_spellings_give_the_same_tree_and_places() {
        let left = toml("a = 1\n[b.c]\nd = [\"x\", 2.5]\n[[e]]\nf = true\n[[e]]\nf = { g = -3 }\n");
        let right = json(
            r#"{"a": 1, "b": {"c": {"d": ["x", 2.5]}}, "e": [{"f": true}, {"f": {"g": -3}}]}"#,
        );
        let (left, right) = (left.unwrap(), right.unwrap());
        assert_eq!(left.root, right.root);
        let keys = |document: &Document| document.places.keys().cloned().collect::<Vec<_>>();
        assert_eq!(keys(&left), keys(&right));
        for document in [&left, &right] {
            assert_eq!(shown(document, "b.c.d.1", Part::Value), "2.5");
            assert_eq!(shown(document, "e.1.f.g", Part::Value), "-3");
            assert_eq!(shown(document, "e.1.f.g", Part::Key).trim_matches('"'), "g");
            // A key that is not there is shown at the table that lacks it.
            assert_eq!(
                shown(document, "b.c.missing", Part::Value).trim_matches('"'),
                "c"
            );
        }
    }

    #[test]
    fn numbers_that_are_none_are_refused_with_their_line() {
        for text in ["x = nan", "x = -inf", "x = 1e999"] {
            let error = toml(&format!("\n{text}\n")).unwrap_err().to_string();
            assert!(error.starts_with("a.toml:2:5: "), "{error}");
            assert!(error.ends_with("is not a finite number"), "{error}");
        }
    }

    #[test]
    fn broken_texts_are_shown_where_they_break() {
        let error = toml("a = 1\nb = = 2\n").unwrap_err().to_string();
        assert!(
            error.starts_with("a.toml:2:5: this is not valid TOML"),
            "{error}"
        );
        let error = json("{\n \"a\": 1,\n \"b\" 2}").unwrap_err().to_string();
        assert!(error.starts_with("a.json:3:"), "{error}");
        let error = toml("a = 1\na = 2\n").unwrap_err().to_string();
        assert!(error.starts_with("a.toml:2:1"), "{error}");
        let error = json("{\"a\": 1,\n \"a\": 2}").unwrap_err().to_string();
        assert_eq!(error, "a.json:2:2: the key 'a' is given twice");
        assert!(
            toml("a = 2026-01-01")
                .unwrap_err()
                .to_string()
                .contains("the date 2026-01-01")
        );
    }
}
