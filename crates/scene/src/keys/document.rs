//! The tables of keys in `docs/scene-format.md`.

use std::fmt::Write as _;

use thiserror::Error;

use super::tables;
use crate::declaration::{Key, Table};
use crate::document::child;

const START: &str = "<!-- keys of ";
const END: &str = "<!-- end of keys -->";

/// Why a document cannot take the tables of keys.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
#[non_exhaustive]
pub enum DocumentError {
    /// A place without a table.
    #[error("there is no table of keys '{0}', or it is placed twice")]
    NoTable(String),
    /// A place without its end.
    #[error("'{END}' is missing after '{0}'")]
    NoEnd(String),
    /// Tables without a place.
    #[error("the document does not place {}", .0.join(", "))]
    NotPlaced(Vec<&'static str>),
}

/// `text` with the tables of keys as they are declared, each between `<!-- keys of PATH -->` and `<!-- end of keys -->`.
///
/// # Errors
/// [`DocumentError`]: a table that `text` does not place, or a place without a table or an end.
pub fn document(text: &str) -> Result<String, DocumentError> {
    let mut missing: Vec<Table> = tables().collect();
    let mut parts = text.split_inclusive('\n');
    let mut written = String::new();
    while let Some(line) = parts.next() {
        written.push_str(line);
        let Some(path) = line
            .strip_prefix(START)
            .and_then(|rest| rest.split(" -->").next())
        else {
            continue;
        };
        let place = missing.iter().position(|table| title(table) == path);
        let place = place.ok_or_else(|| DocumentError::NoTable(path.to_owned()))?;
        written.push_str(&rows(&missing.remove(place)));
        let end = parts.find(|line| line.trim_end() == END);
        written.push_str(end.ok_or_else(|| DocumentError::NoEnd(path.to_owned()))?);
    }
    let titles: Vec<_> = missing.iter().map(title).collect();
    if titles.is_empty() {
        Ok(written)
    } else {
        Err(DocumentError::NotPlaced(titles))
    }
}

fn title(table: &Table) -> &'static str {
    if table.path.is_empty() {
        "the scene"
    } else {
        table.path
    }
}

fn rows(table: &Table) -> String {
    let mut text =
        "\n| key | type | default | meaning | example |\n| --- | --- | --- | --- | --- |\n"
            .to_owned();
    for key in table.keys {
        let cells = [
            key.type_text(),
            key.default.to_owned(),
            key.meaning.to_owned(),
            example(table, key),
        ];
        let cells = cells.map(|cell| cell.replace('|', "\\|"));
        // Writing into a string does not fail.
        let _ = writeln!(text, "| `{}` | {} |", key.name, cells.join(" | "));
    }
    if let Some(exclusive) = table.exclusive {
        let amount = if exclusive.optional {
            "At most"
        } else {
            "Exactly"
        };
        let names = exclusive.names().join("`, `");
        let _ = writeln!(text, "\n{amount} one of `{names}` is given.");
    }
    text + "\n"
}

/// The example of a key, or a link to its own table.
fn example(table: &Table, key: &Key) -> String {
    let own = child(table.path, key.name);
    let named = child(&own, "NAME");
    let below = tables().find(|table| table.path == own || table.path == named);
    match (below, key.assignment()) {
        (Some(below), _) => format!("[below](#{})", below.path.replace('.', "").to_lowercase()),
        (None, Some(assignment)) => format!("`{assignment}`"),
        (None, None) => String::new(),
    }
}
