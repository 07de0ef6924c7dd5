//! Why measured data cannot be read or combined.

use thiserror::Error;

use crate::triangles::TriangulationError;

/// Why measured data cannot be read or combined.
#[derive(Clone, Debug, Error, PartialEq)]
#[non_exhaustive]
pub enum DataError {
    /// The reader failed.
    #[error("{file}: cannot be read: {cause}")]
    Unreadable {
        /// Name of the data.
        file: String,
        /// What the reader said.
        cause: String,
    },
    /// A line cannot be split into fields.
    #[error(
        "{file}: line {line} is no row of a table: {cause}; save the data as UTF-8 text with one point per line"
    )]
    Malformed {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// What is wrong.
        cause: String,
    },
    /// There is no header or no row below it.
    #[error(
        "{file}: there are no data; a line of column names and at least one row below it are needed"
    )]
    Empty {
        /// Name of the data.
        file: String,
    },
    /// A requested column does not exist.
    #[error(
        "{file}: line {line} names no column '{column}'; it has {available}; state which of them holds it"
    )]
    MissingColumn {
        /// Name of the data.
        file: String,
        /// Line of the header.
        line: u64,
        /// Requested name.
        column: String,
        /// Names that exist.
        available: String,
    },
    /// A requested column exists more than once.
    #[error("{file}: line {line} names column '{column}' {times} times; rename all but one")]
    RepeatedColumn {
        /// Name of the data.
        file: String,
        /// Line of the header.
        line: u64,
        /// Requested name.
        column: String,
        /// How often it is there.
        times: usize,
    },
    /// The first line holds numbers.
    #[error(
        "{file}: line {line} is '{numbers}', numbers where the names of columns belong; write a line above it that names its {}, such as '{}'",
        counted_columns(*columns), example_header(*columns, *delimiter)
    )]
    NoHeader {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// The line.
        numbers: String,
        /// Its fields.
        columns: usize,
        /// What parts them.
        delimiter: char,
    },
    /// A number with a comma in a table where that is not clear.
    #[error(
        "{file}: line {line}, column '{column}': '{value}' {what}; write all numbers of the table with decimal points"
    )]
    DecimalComma {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// Column.
        column: String,
        /// Text of the field.
        value: String,
        /// What is not clear.
        what: String,
    },
    /// A row of units where units are stated otherwise.
    #[error(
        "{file}: line {line} is a row of units ('{unit}'), and the scale is stated beside the table; begin the line with # so that it is a comment"
    )]
    Units {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// The first of them.
        unit: String,
    },
    /// A row is too short or too long.
    #[error(
        "{file}: line {line} has {fields} fields, the header has {columns}; {}",
        of_length(*fields, *columns, *all)
    )]
    RowLength {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// Fields in the row.
        fields: usize,
        /// Columns of the header.
        columns: usize,
        /// Whether all rows have as many.
        all: bool,
    },
    /// A field holds no usable number.
    #[error("{file}: line {line}, column '{column}': '{value}' {what}; {remedy}")]
    NotANumber {
        /// Name of the data.
        file: String,
        /// Line, counted from 1.
        line: u64,
        /// Column.
        column: String,
        /// Text of the field.
        value: String,
        /// What is wrong with it.
        what: &'static str,
        /// What to do.
        remedy: &'static str,
    },
    /// The numbers are in pixels and nothing says how long a pixel is.
    #[error(
        "{file}: the numbers are in pixels and no scale is given; state the length of one pixel"
    )]
    NoScale {
        /// Name of the data.
        file: String,
    },
    /// A stated number is out of range.
    #[error("{what} is {value}; {range}")]
    Setting {
        /// What was stated.
        what: &'static str,
        /// Its value, in the unit of what was stated.
        value: f64,
        /// What it may be.
        range: &'static str,
    },
    /// Two rows are at one place.
    #[error(
        "{file}: lines {first} and {second} are both at {}; keep one of them",
        at_both(places)
    )]
    DuplicatedPoint {
        /// Name of the data.
        file: String,
        /// Line of the first row.
        first: u64,
        /// Line of the second.
        second: u64,
        /// x and y of either row, in the table's own unit.
        places: [[f64; 2]; 2],
    },
    /// No displacement is valid.
    #[error("{file}: none of {rows} points has a valid displacement; {remedy}")]
    AllMasked {
        /// Name of the data.
        file: String,
        /// Rows, or points.
        rows: usize,
        /// What to look at.
        remedy: &'static str,
    },
    /// A fringe line is too short.
    #[error(
        "{file}: {}fringe line '{name}' has {}; 2 are needed to interpolate: give it another, or leave the line out",
        in_row(*row),
        counted(*centres)
    )]
    ShortLine {
        /// Name of the data.
        file: String,
        /// Line of its only centre in the file, counted from 1, if the data are one.
        row: Option<u64>,
        /// Name of the line.
        name: String,
        /// Fringe centres on it.
        centres: usize,
    },
    /// A fringe centre lies off its line.
    #[error(
        "{file}: {}the fringe centre ({}, {}) of order {order} lies {} off fringe line '{name}', more than the tolerance of {}, in the \
         table's own unit; correct it, or state another track",
        in_row(*row), place[0], place[1], rounded(*distance), rounded(*tolerance)
    )]
    OffLine {
        /// Name of the data.
        file: String,
        /// Line of its row in the file, counted from 1, if the data are one.
        row: Option<u64>,
        /// Name of the line.
        name: String,
        /// x and y in the table's own unit.
        place: [f64; 2],
        /// Its fringe order `[fringes]`, as it stands there.
        order: f64,
        /// Distance from the line in the table's own unit.
        distance: f64,
        /// What is allowed, in the table's own unit.
        tolerance: f64,
    },
    /// A drawn line turns back, so its centres are not in order along it.
    #[error(
        "{file}: {}fringe line '{name}' turns back by {angle:.0}° at its fringe centre ({}, {}); put the centres in order along the \
         line, or state a straight or circular track, on which they are sorted",
        in_row(*row), place[0], place[1]
    )]
    TurnsBack {
        /// Name of the data.
        file: String,
        /// Line of its row in the file, counted from 1, if the data are one.
        row: Option<u64>,
        /// Name of the line.
        name: String,
        /// x and y in the table's own unit.
        place: [f64; 2],
        /// Angle between the steps before and after it, degrees.
        angle: f64,
    },
    /// Two fringe centres are at one place of a line.
    #[error(
        "{file}: {}fringe line '{name}' has orders {} and {} at one place along it, {}; keep one of them",
        in_rows(*rows), orders[0], orders[1], at_one(places)
    )]
    RepeatedCentre {
        /// Name of the data.
        file: String,
        /// Lines of their rows in the file, counted from 1, if the data are one.
        rows: Option<[u64; 2]>,
        /// Name of the line.
        name: String,
        /// x and y of either in the table's own unit.
        places: [[f64; 2]; 2],
        /// Either order `[fringes]`, as it stands there.
        orders: [f64; 2],
    },
    /// A track is stated for a line that does not exist, or a line is needed that is not there.
    #[error("{file}: there is no line '{name}'; the lines are {available}")]
    NoSuchLine {
        /// Name of the data.
        file: String,
        /// Requested name.
        name: String,
        /// Names that exist.
        available: String,
    },
    /// Fields of two directions were combined.
    #[error(
        "fringe lines of the {first:?} and of the {second:?} field cannot be subtracted from each other"
    )]
    Fields {
        /// Field of the data.
        first: super::field::Field,
        /// Field subtracted.
        second: super::field::Field,
    },
    /// Two lines share no stretch.
    #[error("lines '{first}' and '{second}' share no stretch on which to compare them")]
    Apart {
        /// One line.
        first: String,
        /// The other.
        second: String,
    },
    /// A chosen line leaves the data.
    #[error(
        "line '{name}' leaves the data at ({x}, {y}); shorten it, or allow triangles with longer sides"
    )]
    NotCovered {
        /// Name of the line.
        name: String,
        /// Where `[length]`.
        x: f64,
        /// Where `[length]`.
        y: f64,
    },
    /// A measurement has lists of unequal lengths.
    #[error("a measurement has {places} places and {found} {what}; each place needs one")]
    Lengths {
        /// What is listed.
        what: &'static str,
        /// Places.
        places: usize,
        /// Entries.
        found: usize,
    },
    /// A place, or a valid displacement, is not finite.
    #[error("{what} {index} is ({}, {}); numbers must be finite", .values[0], .values[1])]
    NotFinite {
        /// What it is.
        what: &'static str,
        /// Its index.
        index: usize,
        /// Its numbers `[length]`.
        values: [f64; 2],
    },
    /// Points do not span a plane, or lie beyond what can be triangulated.
    #[error("the valid points of {} cannot be triangulated: {cause}", super::field::letter(*component))]
    Triangulation {
        /// Component, 0 for x and 1 for y.
        component: usize,
        /// What is wrong.
        #[source]
        cause: TriangulationError,
    },
}

fn counted_columns(columns: usize) -> String {
    match columns {
        1 => "column".to_owned(),
        _ => format!("{columns} columns"),
    }
}

/// A header of so many columns.
fn example_header(columns: usize, delimiter: char) -> String {
    let name = |k: usize| {
        let known = ["x", "y", "u", "v"].get(k);
        known.map_or_else(|| format!("c{}", k + 1), |name| (*name).to_owned())
    };
    let names: Vec<String> = (0..columns).map(name).collect();
    names.join(&delimiter.to_string())
}

/// What to do about rows of another length than the header.
fn of_length(fields: usize, columns: usize, all: bool) -> &'static str {
    match (all, fields > columns) {
        (true, true) if fields == 2 * columns => {
            "so have all rows: if commas are decimal ones, part columns by semicolons, and otherwise name every column in the header"
        }
        (true, true) => "so have all rows: name every column in the header",
        (true, false) => "so have all rows: remove the names of columns that are not there",
        (false, _) => "complete the row or remove it",
    }
}

fn in_row(row: Option<u64>) -> String {
    row.map_or_else(String::new, |row| format!("line {row}: "))
}

fn in_rows(rows: Option<[u64; 2]>) -> String {
    rows.map_or_else(String::new, |[first, second]| {
        format!("lines {first} and {second}: ")
    })
}

fn counted(centres: usize) -> String {
    match centres {
        0 => "no fringe centre".to_owned(),
        1 => "1 fringe centre".to_owned(),
        _ => format!("{centres} fringe centres"),
    }
}

/// Four significant digits of a length that was calculated.
fn rounded(length: f64) -> f64 {
    format!("{length:.3e}").parse().unwrap_or(length)
}

/// Two places, or the one that both are.
fn at_one([first, second]: &[[f64; 2]; 2]) -> String {
    let shown = |[x, y]: &[f64; 2]| format!("({x}, {y})");
    if first == second {
        shown(first)
    } else {
        format!("{} and {}", shown(first), shown(second))
    }
}

/// Places of two rows at one place; they differ where a table has them after the deformation.
fn at_both(places: &[[f64; 2]; 2]) -> String {
    let shown = at_one(places);
    if places[0] == places[1] {
        shown
    } else {
        format!("one place before the deformation, {shown} less their displacements")
    }
}
