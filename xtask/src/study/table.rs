//! Tables of records: written as CSV, and read back.

use std::collections::BTreeMap;
use std::io::Read;

use toml::{Table, Value};

use super::TaskError;
use super::record::written;

/// The rows of each table by its name.
pub(crate) type Tables = BTreeMap<String, Vec<Table>>;

/// The rows of a table as CSV; each column is a key with the format of its numbers, `peak:.3`.
pub(crate) fn csv(rows: &[Table], columns: &[String]) -> Result<Vec<u8>, TaskError> {
    let parts: Vec<(&str, &str)> = (columns.iter())
        .map(|column| column.split_once(':').unwrap_or((column, "")))
        .collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(parts.iter().map(|(key, _)| key))?;
    for row in rows {
        writer.write_record(parts.iter().map(|(key, format)| {
            let value = row.get(*key);
            value.map_or_else(String::new, |value| written(value, format))
        }))?;
    }
    Ok(writer.into_inner()?)
}

/// The rows of CSV text. Empty cells have no key; what reads as a number or as true or false is one.
pub(crate) fn read(text: impl Read) -> Result<Vec<Table>, TaskError> {
    let value = |cell: &str| {
        let flag = cell.parse().map(Value::Boolean);
        let number = cell.parse().map(Value::Float);
        number.or(flag).unwrap_or_else(|_| cell.into())
    };
    let mut reader = csv::Reader::from_reader(text);
    let columns = reader.headers()?.clone();
    let mut rows = Vec::new();
    for row in reader.records() {
        let row = row?;
        let cells = columns
            .iter()
            .zip(&row)
            .filter(|(_, cell)| !cell.is_empty());
        rows.push(
            cells
                .map(|(key, cell)| (key.to_owned(), value(cell)))
                .collect(),
        );
    }
    Ok(rows)
}
