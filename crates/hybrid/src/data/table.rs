//! Tables of text: delimiters, comments, header, units, numbers with their line.
//!
//! | as other programs write it | how it is read |
//! | --- | --- |
//! | a delimiter at the end of the header or of rows | an empty last field without a name is dropped |
//! | blanks around quotes, `1, "2"` | as without them |
//! | `1,5;2,0` | decimal commas, where no number of the table has a decimal point and one of them cannot be thousands |
//! | a row of units below the header, `[mm];[mm]` | kept beside the columns, not as data |
//! | numbers where names belong | refused: the table has no header |

use std::io::Read;

use super::DataError;

/// A table with named columns.
pub(super) struct Table {
    file: String,
    header: Vec<String>,
    header_line: u64,
    units: Option<(u64, Vec<String>)>,
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
        let (delimiter, rows) = split(text.trim_start_matches('\u{feff}'), file)?;
        let mut rows = rows.into_iter();
        let empty = || DataError::Empty { file: file.into() };
        let (header_line, mut header) = rows.next().ok_or_else(empty)?;
        let filled = header.iter().rposition(|name| !name.is_empty());
        header.truncate(filled.map_or(0, |last| last + 1));
        if !header.is_empty() && header.iter().all(|name| is_number(name)) {
            return Err(DataError::NoHeader {
                file: file.into(),
                line: header_line,
                numbers: header.join(&delimiter.to_string()),
                columns: header.len(),
                delimiter,
            });
        }
        let mut table = Self {
            file: file.into(),
            units: None,
            header_line,
            rows: rows.collect(),
            header,
        };
        if table.rows.is_empty() {
            return Err(empty());
        }
        table.fit_rows()?;
        if is_units(&table.rows[0].1) {
            table.units = Some(table.rows.remove(0));
            if table.rows.is_empty() {
                return Err(empty());
            }
        }
        table.point_decimals()?;
        Ok(table)
    }

    /// Gives every row as many fields as the header, where nothing but empty ones is beyond it.
    fn fit_rows(&mut self) -> Result<(), DataError> {
        let columns = self.header.len();
        let own = |row: &[String]| {
            let filled = row.iter().rposition(|field| !field.is_empty());
            row.len()
                .min(columns)
                .max(filled.map_or(0, |last| last + 1))
        };
        let fields = own(&self.rows[0].1);
        let same = self.rows.len() > 1 && self.rows.iter().all(|(_, row)| own(row) == fields);
        for (line, row) in &mut self.rows {
            let fields = own(row);
            if fields != columns {
                return Err(DataError::RowLength {
                    file: self.file.clone(),
                    line: *line,
                    fields,
                    columns,
                    all: same,
                });
            }
            row.truncate(columns);
        }
        Ok(())
    }

    /// Writes numbers that have decimal commas with points.
    fn point_decimals(&mut self) -> Result<(), DataError> {
        let fields = || {
            let rows = self.rows.iter().enumerate();
            rows.flat_map(|(row, (_, fields))| (0..fields.len()).map(move |column| (row, column)))
        };
        let text = |(row, column): (usize, usize)| self.rows[row].1[column].as_str();
        let Some(comma) = fields().find(|&at| pointed(text(at)).is_some()) else {
            return Ok(());
        };
        let refuse = |what: String| DataError::DecimalComma {
            file: self.file.clone(),
            line: self.rows[comma.0].0,
            column: self.header[comma.1].clone(),
            value: text(comma).into(),
            what,
        };
        let point = fields().find(|&at| text(at).contains('.') && is_number(text(at)));
        if let Some(point) = point {
            return Err(refuse(format!(
                "has a decimal comma, and '{}' in line {} a decimal point",
                text(point),
                self.rows[point.0].0
            )));
        }
        if fields()
            .filter_map(|at| pointed(text(at)))
            .all(|own| may_be_thousands(&own))
        {
            return Err(refuse(
                "may have a decimal comma or thousands set apart, as all its like in this table"
                    .to_owned(),
            ));
        }
        for field in self.rows.iter_mut().flat_map(|(_, fields)| fields) {
            if let Some(own) = pointed(field) {
                *field = own;
            }
        }
        Ok(())
    }

    /// Rows below the header.
    pub(super) fn len(&self) -> usize {
        self.rows.len()
    }

    /// Line of a row in the file, counted from 1.
    pub(super) fn line(&self, row: usize) -> u64 {
        self.rows[row].0
    }

    /// Text of a field, with a decimal point.
    pub(super) fn text(&self, row: usize, column: usize) -> &str {
        &self.rows[row].1[column]
    }

    /// Name of a column.
    pub(super) fn name(&self, column: usize) -> &str {
        &self.header[column]
    }

    /// Line of the row of units, if there is one, and the unit of a column without brackets.
    pub(super) fn unit(&self, column: usize) -> Option<(u64, &str)> {
        let (line, units) = self.units.as_ref()?;
        Some((*line, bare(&units[column]).unwrap_or(&units[column])))
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
                "write a number with a decimal point, or NaN where nothing was measured; begin the line with # if it is no data",
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

    /// The error that a row of units is not read here.
    pub(super) fn refuse_units(&self, line: u64, unit: &str) -> DataError {
        DataError::Units {
            file: self.file.clone(),
            line,
            unit: unit.into(),
        }
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

/// Whether a field is a number; a name such as `inf` is not a number.
fn is_number(text: &str) -> bool {
    text.contains(|c: char| c.is_ascii_digit()) && text.parse::<f64>().is_ok()
}

/// A number with one comma, with a point in its place.
fn pointed(text: &str) -> Option<String> {
    if !text.contains(',') || text.contains('.') {
        return None;
    }
    Some(text.replacen(',', ".", 1)).filter(|own| is_number(own))
}

/// Whether what stood for a number with a comma may be whole thousands, such as 12,500.
fn may_be_thousands(pointed: &str) -> bool {
    let (whole, decimals) = pointed.split_once('.').unwrap_or((pointed, ""));
    let whole = whole.trim_start_matches(['+', '-']);
    decimals.len() == 3 && (1..=3).contains(&whole.len()) && !whole.starts_with('0')
}

/// A text without its brackets.
fn bare(text: &str) -> Option<&str> {
    let pairs = [('[', ']'), ('(', ')')];
    let inside = |(open, close)| Some(text.strip_prefix(open)?.strip_suffix(close)?.trim());
    pairs.into_iter().find_map(inside)
}

/// Whether a row holds units: something in brackets or a known name in each field that is not empty.
fn is_units(row: &[String]) -> bool {
    const NAMES: [&str; 20] = [
        "nm", "um", "µm", "μm", "mm", "cm", "dm", "m", "in", "inch", "mil", "ft", "px", "pix",
        "pixel", "pixels", "deg", "rad", "-", "%",
    ];
    let mut filled = row.iter().filter(|field| !field.is_empty()).peekable();
    let is_unit = |field: &String| {
        bare(field).is_some_and(|own| !is_number(own))
            || NAMES.contains(&field.to_lowercase().as_str())
    };
    filled.peek().is_some() && filled.all(is_unit)
}

/// Lines with something on them, each with its number and its fields.
type Lines = Vec<(u64, Vec<String>)>;

/// The delimiter of a table, a blank where there is none, and its lines.
fn split(text: &str, file: &str) -> Result<(char, Lines), DataError> {
    let mut lines = (1..)
        .zip(text.lines())
        .filter(|(_, line)| !line.trim().is_empty() && !line.trim_start().starts_with(['*', '#']))
        .peekable();
    let delimiter = lines.peek().and_then(|(_, header)| {
        ['\t', ';', ',']
            .into_iter()
            .find(|&delimiter| header.contains(delimiter))
    });
    let delimiter = delimiter.unwrap_or(' ');
    let rows = lines.map(|(number, line)| {
        let fields = fields(line, delimiter).map_err(|cause| DataError::Malformed {
            file: file.into(),
            line: number,
            cause,
        })?;
        Ok((number, fields))
    });
    Ok((delimiter, rows.collect::<Result<_, DataError>>()?))
}

/// Fields of one line; quotes are taken off. Any run of blanks is one delimiter where blanks part the fields.
fn fields(line: &str, delimiter: char) -> Result<Vec<String>, String> {
    // Making a reader takes longer than reading a line, and numbers are seldom quoted.
    if !line.contains('"') {
        return Ok(match delimiter {
            ' ' => line.split_whitespace().map(String::from).collect(),
            _ => line
                .split(delimiter)
                .map(|field| field.trim().into())
                .collect(),
        });
    }
    let tidied = without_blanks_at_fields(line.trim(), delimiter);
    let mut reader = csv::ReaderBuilder::new()
        .delimiter(delimiter as u8)
        .has_headers(false)
        .trim(csv::Trim::All)
        .from_reader(tidied.as_bytes());
    match reader.records().next() {
        Some(Ok(record)) => Ok(record.iter().map(String::from).collect()),
        Some(Err(cause)) => Err(cause.to_string()),
        None => Err("it has no fields".into()),
    }
}

/// A line without the blanks that begin its fields, behind which a quote would be one of the text.
fn without_blanks_at_fields(line: &str, delimiter: char) -> String {
    let (mut quoted, mut begins) = (false, true);
    line.chars()
        .filter(|&c| {
            if c == '"' {
                quoted = !quoted;
            }
            let is_delimiter = c == delimiter && delimiter != ' ';
            let blank = begins && !quoted && !is_delimiter && (c == ' ' || c == '\t');
            begins = !quoted && (c == delimiter || blank);
            !blank
        })
        .collect()
}
