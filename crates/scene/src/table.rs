//! Tables of stresses over the angle, as text with commas.
//!
//! The first line that is not a comment (`#`) or empty names the columns; other columns are skipped.

use std::io::ErrorKind;
use std::path::Path;

use crate::host::Host;
use crate::limits::Content;

/// Why a table cannot be used, as text that names the line.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct TableError {
    pub(super) cause: String,
    pub(super) remedy: String,
}

impl TableError {
    fn new(cause: impl Into<String>, remedy: impl Into<String>) -> Self {
        Self {
            cause: cause.into(),
            remedy: remedy.into(),
        }
    }
}

/// The named columns of the file.
pub(super) fn read<const N: usize>(
    path: &Path,
    columns: [&str; N],
    host: Host,
) -> Result<[Vec<f64>; N], TableError> {
    let text = host.read_text(path, Content::Table).map_err(|error| {
        let remedy = match error.kind() {
            ErrorKind::NotFound => {
                "paths of data files are relative to the folder of the scene file"
            }
            ErrorKind::FileTooLarge => "give fewer rows and no other columns, or free memory",
            _ => "give a text file with a line for each angle, which can be read",
        };
        TableError::new(format!("cannot be read: {error}"), remedy)
    })?;
    parse(&text, columns)
}

fn parse<const N: usize>(text: &str, columns: [&str; N]) -> Result<[Vec<f64>; N], TableError> {
    let mut lines = text
        .lines()
        .enumerate()
        .map(|(index, line)| (index + 1, line.trim_start_matches('\u{feff}').trim()))
        .filter(|(_, line)| !line.is_empty() && !line.starts_with('#'));
    let Some((_, header)) = lines.next() else {
        return Err(TableError::new(
            "has no line",
            "the first line names the columns",
        ));
    };
    let names: Vec<&str> = header
        .split(',')
        .map(|name| name.trim().trim_matches('"'))
        .collect();
    let mut places = [0; N];
    for (place, column) in places.iter_mut().zip(columns) {
        *place = names
            .iter()
            .position(|name| *name == column)
            .ok_or_else(|| {
                TableError::new(
                    format!("has no column '{column}'"),
                    format!(
                        "its columns are {}; name the one to use with theta, radial or shear",
                        names.join(", ")
                    ),
                )
            })?;
    }
    let mut values = [const { Vec::new() }; N];
    for (number, line) in lines {
        let cells: Vec<&str> = line.split(',').map(str::trim).collect();
        for ((list, place), column) in values.iter_mut().zip(places).zip(columns) {
            let cell = cells.get(place).copied().unwrap_or_default();
            match cell.parse::<f64>() {
                Ok(value) if value.is_finite() => list.push(value),
                _ => {
                    let cause = format!(
                        "line {number}: '{cell}' in column '{column}' is not a finite number"
                    );
                    return Err(TableError::new(cause, "give a number in every row"));
                }
            }
        }
    }
    Ok(values)
}

/// Angles in degrees over a half circle 0…180 (symmetric about the x axis) or a full one from 0.
pub(super) fn check_angles(degrees: &[f64]) -> Result<(), TableError> {
    let remedy =
        "give rows from 0 to 180 degrees (the other half follows by symmetry) or from 0 to 360";
    let increasing = degrees.windows(2).all(|pair| pair[0] < pair[1]);
    match degrees {
        [] | [_] => Err(TableError::new(
            format!("has {} rows", degrees.len()),
            remedy,
        )),
        _ if !increasing => Err(TableError::new(
            "its angles do not increase from row to row",
            remedy,
        )),
        [first, .., last]
            if *first != 0.0 || !(*last == 180.0 || *last > 180.0 && *last <= 360.0) =>
        {
            Err(TableError::new(
                format!("its angles reach from {first} to {last} degrees"),
                remedy,
            ))
        }
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn angles_cover_half_or_all_of_the_circle() {
        assert!(
            check_angles(&[0.0, 90.0, 180.0]).is_ok() && check_angles(&[0.0, 180.0, 355.0]).is_ok()
        );
        for bad in [
            &[][..],
            &[0.0],
            &[0.0, 90.0],
            &[5.0, 180.0],
            &[0.0, 180.0, 90.0],
            &[0.0, 400.0],
        ] {
            assert!(check_angles(bad).is_err(), "{bad:?}");
        }
    }

    #[test]
    fn columns_are_found_by_name() {
        let text = "# a comment\n\nb, a,c\n1,2,x\n# between\n 3 , 4 ,y\n";
        assert_eq!(
            parse(text, ["a", "b"]).unwrap(),
            [vec![2.0, 4.0], vec![1.0, 3.0]]
        );
    }

    #[test]
    fn refusals_name_line_and_column() {
        let error = parse("a,b\n1,2\n1,nan\n", ["a", "b"]).unwrap_err();
        assert_eq!(
            error.cause,
            "line 3: 'nan' in column 'b' is not a finite number"
        );
        let error = parse("a,b\n1\n", ["a", "b"]).unwrap_err();
        assert_eq!(
            error.cause,
            "line 2: '' in column 'b' is not a finite number"
        );
        let error = parse("a,b\n", ["c"]).unwrap_err();
        assert_eq!(error.cause, "has no column 'c'");
        assert!(error.remedy.starts_with("its columns are a, b;"));
        assert_eq!(parse("# only\n", ["a"]).unwrap_err().cause, "has no line");
    }
}
