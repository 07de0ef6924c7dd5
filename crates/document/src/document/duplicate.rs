//! Keys that are given twice, with the lines of both.

use std::ops::Range;
use std::sync::Arc;

use toml::de::{DeTable, DeValue};

use super::{Document, child};
use crate::diagnostic::{Finding, SceneError, SceneProblem};

impl Document {
    /// The key at `second` stands in its table already: the text is read again with that key renamed, which shows its table.
    pub(super) fn duplicate_toml(&self, second: Range<usize>) -> SceneError {
        let text = &self.source.text;
        // A run of one letter that is longer than the text is nowhere in it.
        let stand_in = "x".repeat(text.len() + 1);
        let renamed = match (text.get(..second.start), text.get(second.end..)) {
            (Some(before), Some(after)) => format!("{before}{stand_in}{after}"),
            _ => String::new(),
        };
        let (table, _) = DeTable::parse_recoverable(&renamed);
        let name = text.get(second.clone()).unwrap_or_default();
        let name = name.trim_matches(['"', '\'']);
        match first_of(table.get_ref(), "", &stand_in, name) {
            Some((path, first)) => self.duplicate(path, Some(&first), Some(second)),
            None => self.duplicate(name.to_owned(), None, Some(second)),
        }
    }

    pub(super) fn duplicate(
        &self,
        key: String,
        first: Option<&Range<usize>>,
        second: Option<Range<usize>>,
    ) -> SceneError {
        let line = |span: Option<&Range<usize>>| {
            let before = self.source.text.get(..span?.start)?;
            Some(before.matches('\n').count() + 1)
        };
        let problem = SceneProblem::DuplicateKey {
            key: key.rsplit('.').next().unwrap_or_default().to_owned(),
            lines: line(first).zip(line(second.as_ref())),
        };
        let finding = Finding {
            problem,
            key,
            source: Arc::clone(&self.source),
            span: second,
        };
        SceneError::new(finding, [])
    }
}

/// Path and place of key `name` in the table that holds the key `beside`.
fn first_of(
    table: &DeTable<'_>,
    path: &str,
    beside: &str,
    name: &str,
) -> Option<(String, Range<usize>)> {
    if table.keys().any(|key| key.get_ref() == beside) {
        let (key, _) = table.iter().find(|(key, _)| key.get_ref() == name)?;
        return Some((child(path, name), key.span()));
    }
    table.iter().find_map(|(key, value)| {
        first_in(value.get_ref(), &child(path, key.get_ref()), beside, name)
    })
}

fn first_in(
    value: &DeValue<'_>,
    path: &str,
    beside: &str,
    name: &str,
) -> Option<(String, Range<usize>)> {
    match value {
        DeValue::Table(table) => first_of(table, path, beside, name),
        DeValue::Array(values) => values.iter().enumerate().find_map(|(index, value)| {
            first_in(value.get_ref(), &child(path, index), beside, name)
        }),
        _ => None,
    }
}
