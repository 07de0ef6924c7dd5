//! Digitised fringe centres along lines from a table.

use std::collections::BTreeMap;
use std::io::Read;

use super::read::positive;
use super::table::Table;
use super::{DataError, FringeLine, Track, YAxis};

/// Which displacement a fringe pattern shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Field {
    /// The component x.
    U,
    /// The component y.
    V,
}

impl Field {
    /// Both fields, U first.
    pub const BOTH: [Self; 2] = [Self::U, Self::V];

    /// Index of the component, 0 or 1.
    pub fn component(self) -> usize {
        match self {
            Self::U => 0,
            Self::V => 1,
        }
    }
}

/// What the numbers of a table of fringe centres are.
#[derive(Clone, Debug, PartialEq)]
pub struct LineReading {
    /// Columns of the line's name, of x, of y, and of the fringe order.
    pub columns: [String; 4],
    /// Length of one unit of the table's places `[length]`.
    pub scale: f64,
    /// Where the table's y axis points; down, orders of the V field change their sign.
    pub y_axis: YAxis,
    /// Whether orders count against the field's axis.
    pub reversed: bool,
    /// Largest distance of a fringe centre from a straight or circular track `[length]`.
    pub tolerance: f64,
    /// Track of lines that `tracks` does not name.
    pub track: Track,
    /// Tracks of lines by name, in the body's frame.
    pub tracks: BTreeMap<String, Track>,
}

impl LineReading {
    /// Columns `line`, `x`, `y`, `order` with the length of one unit and the tolerance `[length]`; y up, all lines straight.
    pub fn new(scale: f64, tolerance: f64) -> Self {
        Self {
            columns: ["line", "x", "y", "order"].map(String::from),
            scale,
            y_axis: YAxis::Up,
            reversed: false,
            tolerance,
            track: Track::Straight,
            tracks: BTreeMap::new(),
        }
    }
}

/// Fringe centres of one field along lines.
#[derive(Clone, Debug, PartialEq)]
pub struct FringeLines {
    /// Which displacement they show.
    pub field: Field,
    /// The lines, each with a name of its own.
    pub lines: Vec<FringeLine>,
}

impl FringeLines {
    /// Reads a table of fringe centres, one per row; `name` is what errors call it. Lines keep the order of their first rows.
    ///
    /// On straight and circular tracks rows may come in any order. Comments and delimiters are as for
    /// [`Measurement::read`](super::Measurement::read); nothing is masked here, a centre that was not seen is left out by whoever
    /// digitised.
    ///
    /// # Errors
    /// [`DataError`]: as for a measurement, and a line that is too short, a centre off its track or repeated, a drawn line that
    /// turns back, a track for a line that does not exist.
    pub fn read(
        reader: impl Read,
        name: &str,
        field: Field,
        reading: &LineReading,
    ) -> Result<Self, DataError> {
        let scale = positive("the scale", reading.scale)?;
        if reading.tolerance.is_nan() || reading.tolerance < 0.0 {
            return Err(DataError::Setting {
                what: "the tolerance of fringe lines",
                value: reading.tolerance,
                range: "it is a length, 0 or above",
            });
        }
        let table = Table::read(reader, name)?;
        let [line, x, y, order] = {
            let [line, x, y, order] = &reading.columns;
            [
                table.column(line)?,
                table.column(x)?,
                table.column(y)?,
                table.column(order)?,
            ]
        };
        let down = reading.y_axis.sign();
        let counts =
            if field == Field::V { down } else { 1.0 } * if reading.reversed { -1.0 } else { 1.0 };
        let mut names: Vec<&str> = Vec::new();
        let mut centres: BTreeMap<&str, Vec<_>> = BTreeMap::new();
        for row in 0..table.len() {
            let label = table.text(row, line);
            let place = [
                scale * table.required(row, x)?,
                scale * down * table.required(row, y)?,
            ];
            let order = counts * table.required(row, order)?;
            let list = centres.entry(label).or_default();
            if list.is_empty() {
                names.push(label);
            }
            list.push((place, order));
        }
        if let Some(unknown) = reading
            .tracks
            .keys()
            .find(|key| !centres.contains_key(key.as_str()))
        {
            return Err(DataError::NoSuchLine {
                file: name.into(),
                name: unknown.clone(),
                available: names.join(", "),
            });
        }
        let lines = names
            .iter()
            .map(|&label| {
                let track = *reading.tracks.get(label).unwrap_or(&reading.track);
                FringeLine::new(name, label, track, &centres[label], reading.tolerance)
            })
            .collect::<Result<_, _>>()?;
        Ok(Self { field, lines })
    }

    /// The line called `name`.
    pub fn line(&self, name: &str) -> Option<&FringeLine> {
        self.lines.iter().find(|line| line.name() == name)
    }
}
