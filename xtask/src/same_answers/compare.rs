//! Two folders of results, value by value.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt;
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::kinds::Kinds;
use super::numbers::numbers;
use crate::publish::TaskError;

/// The file that holds the message of a case that failed.
pub(super) const FAILURE: &str = "error.txt";

const SUMMARY: &str = "summary.json";

/// Two values that are not the same.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Difference {
    /// File below the folder of results.
    pub(super) file: String,
    /// Keys and indices from 0, joined by dots; in a table the row from 0 and the column's name; nothing for a whole file.
    pub(super) place: String,
    was: String,
    is: String,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self {
            file,
            place,
            was,
            is,
        } = self;
        write!(f, "{file}: {place}: was {was}, is {is}")
    }
}

#[cfg(test)]
impl Difference {
    /// A difference at a place, for tests of others.
    pub(super) fn of(file: &str, place: &str) -> Self {
        let (file, place) = (file.to_owned(), place.to_owned());
        Self {
            file,
            place,
            was: String::new(),
            is: String::new(),
        }
    }
}

/// What two folders of results have in common, and what not.
#[derive(Debug, Default)]
pub(super) struct Comparison {
    /// Values that were compared.
    pub(super) values: usize,
    /// Texts for readers that are other words with the same numbers.
    pub(super) reworded: usize,
    /// Keys, columns and files that the baseline does not have.
    pub(super) added: BTreeSet<String>,
    pub(super) differences: Vec<Difference>,
}

/// Compares summaries, tables and VTK files of two folders.
pub(super) fn compare(was: &Path, is: &Path, kinds: &Kinds) -> Result<Comparison, TaskError> {
    let mut compared = Comparison::default();
    let (old, new) = (files(was, "")?, files(is, "")?);
    if old.is_empty() {
        return Err(format!("{}: no results to compare with", was.display()).into());
    }
    for (name, bytes) in &old {
        let mut file = File {
            name,
            kinds,
            compared: &mut compared,
        };
        let Some(other) = new.get(name) else {
            file.differ("", "there", "gone");
            continue;
        };
        if name == SUMMARY {
            let read = |bytes: &[u8]| {
                serde_json::from_slice(bytes).map_err(|cause| format!("{name}: {cause}"))
            };
            let (was, is) = (read(bytes)?, read(other)?);
            file.json("", &was, &is);
        } else if has_ending(name, "csv") {
            file.table(bytes, other)?;
        } else if name == FAILURE {
            file.prose(
                "",
                &String::from_utf8_lossy(bytes),
                &String::from_utf8_lossy(other),
            );
        } else {
            file.equal("", &Bytes(bytes), &Bytes(other));
        }
    }
    let added = new.into_keys().filter(|name| !old.contains_key(name));
    compared.added.extend(added);
    Ok(compared)
}

/// What is compared of a folder, by the path below it.
fn files(folder: &Path, before: &str) -> Result<BTreeMap<String, Vec<u8>>, TaskError> {
    let mut found = BTreeMap::new();
    if !folder.is_dir() {
        return Ok(found);
    }
    for entry in fs::read_dir(folder)? {
        let entry = entry?;
        let name = format!("{before}{}", entry.file_name().to_string_lossy());
        if entry.path().is_dir() {
            found.extend(files(&entry.path(), &format!("{name}/"))?);
        } else if name == SUMMARY
            || name == FAILURE
            || ["csv", "vtu", "pvd"]
                .iter()
                .any(|ending| has_ending(&name, ending))
        {
            found.insert(name, fs::read(entry.path())?);
        }
    }
    Ok(found)
}

fn has_ending(name: &str, ending: &str) -> bool {
    Path::new(name)
        .extension()
        .is_some_and(|other| other == ending)
}

/// The content of a file, shown by its length.
#[derive(PartialEq)]
struct Bytes<'a>(&'a [u8]);

impl fmt::Display for Bytes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{} bytes", self.0.len())
    }
}

/// A file that is being compared.
struct File<'a> {
    name: &'a str,
    kinds: &'a Kinds,
    compared: &'a mut Comparison,
}

impl File<'_> {
    fn differ(&mut self, place: &str, was: impl fmt::Display, is: impl fmt::Display) {
        self.compared.differences.push(Difference {
            file: self.name.to_owned(),
            place: place.to_owned(),
            was: was.to_string(),
            is: is.to_string(),
        });
    }

    fn equal<T: PartialEq + fmt::Display>(&mut self, place: &str, was: &T, is: &T) {
        self.compared.values += 1;
        if was != is {
            self.differ(place, was, is);
        }
    }

    fn json(&mut self, place: &str, was: &Value, is: &Value) {
        match (was, is) {
            (Value::Object(was), Value::Object(is)) => {
                for (key, was) in was {
                    let inner = joined(place, key);
                    match is.get(key) {
                        _ if self.kinds.ignored.contains(key) => {}
                        Some(is) if self.kinds.prose.contains(key) && !was.is_number() => {
                            self.prose(&inner, &texts(was), &texts(is));
                        }
                        Some(is) => self.json(&inner, was, is),
                        None => self.differ(&inner, was, "gone"),
                    }
                }
                for key in is.keys().filter(|&key| !was.contains_key(key)) {
                    // Items of a list have the same keys: they are shown once.
                    let inner = joined(place, key);
                    let keys = inner
                        .split('.')
                        .map(|key| if is_index(key) { "*" } else { key });
                    let general = keys.collect::<Vec<_>>().join(".");
                    self.compared
                        .added
                        .insert(format!("{}: {general}", self.name));
                }
            }
            (Value::Array(was), Value::Array(is)) if was.len() == is.len() => {
                for (index, (was, is)) in was.iter().zip(is).enumerate() {
                    self.json(&joined(place, &index.to_string()), was, is);
                }
            }
            (Value::Array(was), Value::Array(is)) => {
                let length = |list: &[Value]| format!("a list of {}", list.len());
                self.differ(place, length(was), length(is));
            }
            (Value::Number(was), Value::Number(is)) => {
                self.equal(
                    place,
                    &was.as_f64().unwrap_or(f64::NAN),
                    &is.as_f64().unwrap_or(f64::NAN),
                );
            }
            (was, is) => self.equal(place, was, is),
        }
    }

    /// Compares texts for readers: words may change, numbers may not.
    fn prose(&mut self, place: &str, was: &str, is: &str) {
        self.compared.values += 1;
        if was == is {
            return;
        }
        let (old, new) = (numbers(was), numbers(is));
        if old == new {
            self.compared.reworded += 1;
        } else {
            self.differ(place, format!("{was:?}"), format!("{is:?}"));
        }
    }

    fn table(&mut self, was: &[u8], is: &[u8]) -> Result<(), TaskError> {
        let (was, is) = (Table::read(was)?, Table::read(is)?);
        for column in is
            .columns
            .iter()
            .filter(|column| !was.columns.contains(column))
        {
            self.compared
                .added
                .insert(format!("{}: column {column}", self.name));
        }
        if was.rows.len() != is.rows.len() {
            let rows = |table: &Table| format!("{} rows", table.rows.len());
            self.differ("", rows(&was), rows(&is));
            return Ok(());
        }
        for (index, column) in was.columns.iter().enumerate() {
            if self.kinds.ignored.contains(column) {
                continue;
            }
            let Some(other) = is.columns.iter().position(|name| name == column) else {
                self.differ(column, "a column", "gone");
                continue;
            };
            for (row, (was, is)) in was.rows.iter().zip(&is.rows).enumerate() {
                let place = joined(&row.to_string(), column);
                let (was, is) = (&was[index], &is[other]);
                if self.kinds.prose.contains(column) {
                    self.prose(&place, was, is);
                } else {
                    self.equal(&place, was, is);
                }
            }
        }
        Ok(())
    }
}

/// A table of texts with the same number of cells in each row.
struct Table {
    columns: Vec<String>,
    rows: Vec<Vec<String>>,
}

impl Table {
    fn read(bytes: &[u8]) -> Result<Self, TaskError> {
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .from_reader(bytes);
        let cells = |record: &csv::StringRecord| record.iter().map(str::to_owned).collect();
        let columns = cells(reader.headers()?);
        let rows = reader.records().map(|record| Ok(cells(&record?)));
        let rows: Result<_, csv::Error> = rows.collect();
        Ok(Self {
            columns,
            rows: rows?,
        })
    }
}

/// All texts in a value, in their order.
fn texts(value: &Value) -> String {
    match value {
        Value::Array(list) => list.iter().map(texts).collect::<Vec<_>>().join("\n"),
        Value::Object(table) => table.values().map(texts).collect::<Vec<_>>().join("\n"),
        Value::String(text) => text.clone(),
        other => other.to_string(),
    }
}

fn joined(place: &str, key: &str) -> String {
    if place.is_empty() {
        key.to_owned()
    } else {
        format!("{place}.{key}")
    }
}

fn is_index(key: &str) -> bool {
    key.chars().all(|c| c.is_ascii_digit())
}

#[cfg(test)]
mod tests {
    use std::fs;

    use super::{Comparison, Kinds, compare};

    fn compared(file: &str, was: &str, is: &str) -> Comparison {
        let folder = tempfile::tempdir().expect("a folder");
        let [old, new] = ["old", "new"].map(|name| folder.path().join(name));
        for (folder, text) in [(&old, was), (&new, is)] {
            fs::create_dir(folder).expect("a new folder");
            fs::write(folder.join(file), text).expect("a new file");
        }
        let kinds = Kinds {
            ignored: vec!["seconds".to_owned()],
            prose: vec!["notes".to_owned()],
        };
        compare(&old, &new, &kinds).expect("files that can be read")
    }

    fn shown(found: &Comparison) -> Vec<String> {
        found.differences.iter().map(ToString::to_string).collect()
    }

    #[test]
    fn numbers_differ_from_the_last_digit_on() {
        let found = compared(
            "summary.json",
            r#"{"a": [1.25, 2], "b": 3.0}"#,
            r#"{"a": [1.250000000001, 2], "b": 3}"#,
        );
        assert_eq!(found.values, 3);
        assert_eq!(
            shown(&found),
            ["summary.json: a.0: was 1.25, is 1.250000000001"]
        );
    }

    #[test]
    fn keys_may_come_and_not_go() {
        let found = compared(
            "summary.json",
            r#"{"a": [{"b": 1}], "seconds": 2}"#,
            r#"{"a": [{"b": 1, "c": 2}], "d": 3}"#,
        );
        assert!(found.differences.is_empty());
        assert_eq!(
            Vec::from_iter(found.added),
            ["summary.json: a.*.c", "summary.json: d"]
        );
        let found = compared("summary.json", r#"{"a": [1, 2], "b": 1}"#, r#"{"a": [1]}"#);
        assert_eq!(
            shown(&found),
            [
                "summary.json: a: was a list of 2, is a list of 1",
                "summary.json: b: was 1, is gone"
            ]
        );
    }

    #[test]
    fn words_may_change_and_their_numbers_not() {
        let was = r#"{"notes": ["12 of 40 points slip.", "Fine."]}"#;
        let found = compared(
            "summary.json",
            was,
            r#"{"notes": ["Of 40 points 12 slip."]}"#,
        );
        assert_eq!((found.reworded, found.differences.len()), (1, 0));
        let found = compared(
            "summary.json",
            was,
            r#"{"notes": ["13 of 40 points slip."]}"#,
        );
        assert_eq!((found.reworded, found.differences.len()), (0, 1));
        assert_eq!(
            compared("summary.json", r#"{"law": "a"}"#, r#"{"law": "b"}"#)
                .differences
                .len(),
            1
        );
    }

    #[test]
    fn tables_are_compared_by_their_columns() {
        let was = "x,seconds,y\n1,5,2.50\n2,6,3\n";
        let found = compared("t.csv", was, "x,y,z\n1,2.5,0\n2,3,0\n");
        assert_eq!(shown(&found), ["t.csv: 0.y: was 2.50, is 2.5"]);
        assert_eq!(Vec::from_iter(found.added), ["t.csv: column z"]);
        let found = compared("t.csv", was, "x,y\n1,2.50\n");
        assert_eq!(shown(&found), ["t.csv: : was 2 rows, is 1 rows"]);
    }

    #[test]
    fn fields_are_compared_by_their_bytes_and_pages_not_at_all() {
        assert_eq!(compared("a.vtu", "<a/>", "<b/>").differences.len(), 1);
        let folder = tempfile::tempdir().expect("a folder");
        fs::write(folder.path().join("report.html"), "").expect("a new file");
        let kinds = Kinds {
            ignored: Vec::new(),
            prose: Vec::new(),
        };
        assert!(compare(folder.path(), folder.path(), &kinds).is_err());
    }
}
