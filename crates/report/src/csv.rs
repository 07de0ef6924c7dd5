//! CSV files: headings, rows of cells, and numbers as cells.

use crate::table::Columns;
use stickslip_text::plain::csv_cell;
use stickslip_text::tidy;

/// The headings in one line, `theta [deg] | layer | mode`.
pub fn headings(line: &str) -> Vec<String> {
    line.split(" | ").map(str::to_owned).collect()
}

/// The bytes of a table of texts.
pub fn texts(rows: impl IntoIterator<Item = Vec<String>>) -> Vec<u8> {
    let lines = rows.into_iter().map(|row| line(&row));
    lines.collect::<String>().into_bytes()
}

/// The bytes of a table with a row for each item.
pub fn columns<T: Copy>(columns: &Columns<'_, T>, items: impl IntoIterator<Item = T>) -> Vec<u8> {
    let rows = items.into_iter().map(|item| columns.cells(item));
    texts(std::iter::once(columns.header()).chain(rows))
}

/// The bytes of a table of numbers with all their digits, in the units of their headings; NaN is left empty.
pub fn numbers(headings: Vec<String>, rows: impl IntoIterator<Item = Vec<f64>>) -> Vec<u8> {
    let cell = |value: f64| {
        if value.is_finite() {
            value.to_string()
        } else {
            String::new()
        }
    };
    let rows = rows.into_iter();
    let rows = rows.map(|row| row.into_iter().map(cell).collect());
    texts(std::iter::once(headings).chain(rows))
}

fn line(cells: &[String]) -> String {
    let quoted = |cell: &String| {
        let plain = csv_cell(cell);
        if plain.contains(['"', ',', '\n']) {
            format!("\"{}\"", plain.replace('"', "\"\""))
        } else {
            plain.into_owned()
        }
    };
    cells.iter().map(quoted).collect::<Vec<_>>().join(",") + "\n"
}

/// A number, in any unit, for a program: up to twelve significant digits, empty where there is none.
pub fn number(value: f64) -> String {
    match tidy(value) {
        None => String::new(),
        Some(0.0) => "0".into(),
        Some(value) if (1e-4..1e12).contains(&value.abs()) => value.to_string(),
        Some(value) => format!("{value:e}"),
    }
}
