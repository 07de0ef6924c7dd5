//! Tables of text: delimiters, comments, header, numbers with their line.

use std::io::Read;

use super::DataError;

/// A table with named columns.
pub(super) struct Table {
    file: String,
    header: Vec<String>,
    header_line: u64,
    rows: Vec<(u64, Vec<String>)>,
}

impl Table {
    /// Reads a table. Lines that start with `*` or `#` are comments; the header's first delimiter among tab, semicolon and
    /// comma is the table's, and without any fields are parted by blanks.
    pub(super) fn read(mut reader: impl Read, file: &str) -> Result<Self, DataError> {
        let mut bytes = Vec::new();
        reader
            .read_to_end(&mut bytes)
            .map_err(|cause| DataError::Unreadable {
                file: file.into(),
                cause: cause.to_string(),
            })?;
        let text = std::str::from_utf8(&bytes).map_err(|cause| DataError::Malformed {
            file: file.into(),
            line: bytes[..cause.valid_up_to()]
                .split(|&byte| byte == b'\n')
                .count() as u64,
            cause: "it is not UTF-8 text".into(),
        })?;
        let mut rows = split(text.trim_start_matches('\u{feff}'), file)?.into_iter();
        let empty = || DataError::Empty { file: file.into() };
        let (header_line, header) = rows.next().ok_or_else(empty)?;
        let table = Self {
            file: file.into(),
            header,
            header_line,
            rows: rows.collect(),
        };
        if table.rows.is_empty() {
            return Err(empty());
        }
        for (line, row) in &table.rows {
            if row.len() != table.header.len() {
                return Err(DataError::RowLength {
                    file: file.into(),
                    line: *line,
                    fields: row.len(),
                    columns: table.header.len(),
                });
            }
        }
        Ok(table)
    }

    /// Rows below the header.
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Line of a row in the file, counted from 1.
    pub(super) fn line(&self, row: usize) -> u64 {
        self.rows[row].0
    }

    /// Text of a field.
    pub(super) fn text(&self, row: usize, column: usize) -> &str {
        &self.rows[row].1[column]
    }

    /// Index of the column called `name`; upper and lower case are one.
    pub(super) fn column(&self, name: &str) -> Result<usize, DataError> {
        let found: Vec<usize> = (0..self.header.len())
            .filter(|&k| self.header[k].to_lowercase() == name.trim().to_lowercase())
            .collect();
        match found[..] {
            [column] => Ok(column),
            [] => Err(DataError::MissingColumn {
                file: self.file.clone(),
                line: self.header_line,
                column: name.into(),
                available: self.header.join(", "),
            }),
            _ => Err(DataError::RepeatedColumn {
                file: self.file.clone(),
                line: self.header_line,
                column: name.into(),
                times: found.len(),
            }),
        }
    }

    /// The number in a field, or `None` where the field is empty or says NaN.
    pub(super) fn number(&self, row: usize, column: usize) -> Result<Option<f64>, DataError> {
        let text = self.text(row, column);
        match text.parse::<f64>() {
            Ok(value) if value.is_nan() => Ok(None),
            Ok(value) if value.is_finite() => Ok(Some(value)),
            Ok(_) => Err(self.refuse(
                row,
                column,
                "is not finite",
                "write NaN where nothing was measured",
            )),
            Err(_) if text.is_empty() => Ok(None),
            Err(_) => Err(self.refuse(
                row,
                column,
                "is not a number",
                "write a number with a decimal point, or NaN where nothing was measured",
            )),
        }
    }

    /// The number in a field that must hold one.
    pub(super) fn required(&self, row: usize, column: usize) -> Result<f64, DataError> {
        self.number(row, column)?.ok_or_else(|| {
            self.refuse(
                row,
                column,
                "is not a number",
                "a place and what was measured there are both needed",
            )
        })
    }

    /// The error that a field is of no use.
    pub(super) fn refuse(
        &self,
        row: usize,
        column: usize,
        what: &'static str,
        remedy: &'static str,
    ) -> DataError {
        DataError::NotANumber {
            file: self.file.clone(),
            line: self.line(row),
            column: self.header[column].clone(),
            value: self.text(row, column).into(),
            what,
            remedy,
        }
    }
}

/// Lines with something on them, each with its number and its fields.
fn split(text: &str, file: &str) -> Result<Vec<(u64, Vec<String>)>, DataError> {
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with(['*', '#']))
        .peekable();
    let delimiter = lines.peek().and_then(|(_, header)| {
        ['\t', ';', ',']
            .into_iter()
            .find(|&delimiter| header.contains(delimiter))
    });
    lines
        .map(|(number, line)| {
            let fields = match delimiter {
                None => line.split_whitespace().map(String::from).collect(),
                Some(delimiter) => {
                    fields(line, delimiter).map_err(|cause| DataError::Malformed {
                        file: file.into(),
                        line: number,
                        cause,
                    })?
                }
            };
            Ok((number, fields))
        })
        .collect()
}

/// Fields of one line; quotes are taken off.
fn fields(line: &str, delimiter: char) -> Result<Vec<String>, String> {
    // Making a reader takes longer than reading a line, and numbers are seldom quoted.
    if !line.contains('"') {
        return Ok(line
            .split(delimiter)
            .map(|field| field.trim().into())
            .collect());
    }
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter as u8)
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(line.as_bytes());
    match reader.records().next() {
        Some(Ok(record)) => Ok(record.iter().map(String::from).collect()),
        Some(Err(cause)) => Err(cause.to_string()),
        None => Err("it has no fields".into()),
    }
}
