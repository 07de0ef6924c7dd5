//! CSV files: rows of cells, and numbers as cells.

use stickslip_text::plain::csv_cell;
use stickslip_text::tidy;

use super::OutputError;

/// A file's name and bytes.
pub(super) type File = (String, Vec<u8>);

/// The bytes of the CSV file with the name `file`.
pub(super) fn write(
    file: &str,
    rows: impl IntoIterator<Item = Vec<String>>,
) -> Result<Vec<u8>, OutputError> {
    let fail = |cause: csv::Error| OutputError::Csv {
        file: file.to_owned(),
        cause,
    };
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        let cells = row.iter().map(|cell| csv_cell(cell).into_owned());
        writer.write_record(cells).map_err(fail)?;
    }
    writer
        .into_inner()
        .map_err(|cause| fail(cause.into_error().into()))
}

/// A number for a program: up to twelve significant digits, empty where there is none.
pub(super) fn number(value: f64) -> String {
    match tidy(value) {
        None => String::new(),
        Some(0.0) => "0".into(),
        Some(value) if (1e-4..1e12).contains(&value.abs()) => value.to_string(),
        Some(value) => format!("{value:e}"),
    }
}
