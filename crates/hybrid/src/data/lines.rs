//! Digitised fringe centres along lines from a table.

use std::collections::BTreeMap;
use std::io::Read;

use stickslip_fem_core::mesh::Point;

use super::centres::{Origin, Written};
use super::field::Field;
use super::format::{LENGTH, not_negative, positive};
use super::table::Table;
use super::{DataError, FringeLine, Track, YAxis};

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

/// Part of the median spacing along a track that its centres may be off it. An order changes by one from centre to centre, so that half of
/// a spacing may be half a fringe, twice of what one is misread by.
const OFF_TRACK: f64 = 0.5;

/// A line whose fringe centres lie farther off its track than half of their median spacing along it: perhaps it has another one.
#[derive(Clone, Debug, PartialEq)]
pub struct OffTrack {
    /// Name of the line.
    pub name: String,
    /// Line of the farthest centre in the file, counted from 1.
    pub row: u64,
    /// Its x and y in the table's own unit.
    pub place: [f64; 2],
    /// Its distance from the track `[length]`.
    pub distance: f64,
    /// Median spacing of the centres along the track `[length]`.
    pub spacing: f64,
    /// Centres that are so far off, and all of the line.
    pub centres: [usize; 2],
}

impl OffTrack {
    fn of(line: &FringeLine, placed: &[(Point, f64)], written: &[Written]) -> Option<Self> {
        let spacing = line.spacing();
        let distances: Vec<f64> = placed.iter().map(|&(place, _)| line.off(place)).collect();
        let count = distances
            .iter()
            .filter(|distance| **distance > OFF_TRACK * spacing)
            .count();
        let farthest =
            (0..distances.len()).max_by(|&a, &b| distances[a].total_cmp(&distances[b]))?;
        (count > 0).then(|| Self {
            name: line.name().to_owned(),
            row: written[farthest].row.unwrap_or_default(),
            place: written[farthest].place,
            distance: distances[farthest],
            spacing,
            centres: [count, distances.len()],
        })
    }
}

/// Centres of one line: place `[length]` and order in the body's frame, and as they were written.
#[derive(Default)]
struct Centres {
    placed: Vec<(Point, f64)>,
    written: Vec<Written>,
}

/// Fringe centres of one field along lines.
#[derive(Clone, Debug, PartialEq)]
pub struct FringeLines {
    /// Which displacement they show.
    pub field: Field,
    /// The lines, each with a name of its own.
    pub lines: Vec<FringeLine>,
}

/// Names of the lines in the order of their first rows, and the centres of each.
type Gathered<'a> = (Vec<&'a str>, BTreeMap<&'a str, Centres>);

fn gathered<'a>(
    table: &'a Table,
    field: Field,
    reading: &LineReading,
    scale: f64,
) -> Result<Gathered<'a>, DataError> {
    let [line, x, y, order] = &reading.columns;
    let line = table.column(line)?;
    if let Some((line, unit)) = table.unit(table.column(x)?) {
        return Err(table.refuse_units(line, unit));
    }
    let [x, y, order] = [table.column(x)?, table.column(y)?, table.column(order)?];
    let down = reading.y_axis.sign();
    let along = if field == Field::V { down } else { 1.0 };
    let counts = if reading.reversed { -along } else { along };
    let mut names: Vec<&str> = Vec::new();
    let mut centres: BTreeMap<&str, Centres> = BTreeMap::new();
    for row in 0..table.len() {
        let label = table.text(row, line);
        let written = Written {
            row: Some(table.line(row)),
            place: [table.required(row, x)?, table.required(row, y)?],
            order: table.required(row, order)?,
        };
        let place = [scale * written.place[0], scale * down * written.place[1]];
        let list = centres.entry(label).or_default();
        if list.written.is_empty() {
            names.push(label);
        }
        list.placed.push((place, counts * written.order));
        list.written.push(written);
    }
    Ok((names, centres))
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
        Self::read_with_doubts(reader, name, field, reading).map(|(lines, _)| lines)
    }

    /// As [`read`](Self::read), with the lines whose centres lie off their track where no tolerance is stated (it is infinite).
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_with_doubts(
        reader: impl Read,
        name: &str,
        field: Field,
        reading: &LineReading,
    ) -> Result<(Self, Vec<OffTrack>), DataError> {
        let scale = positive("the scale", reading.scale)?;
        not_negative("the tolerance of fringe lines", reading.tolerance, LENGTH)?;
        let table = Table::read(reader, name)?;
        let (names, centres) = gathered(&table, field, reading, scale)?;
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
        let (mut lines, mut doubts) = (Vec::new(), Vec::new());
        for label in names {
            let Centres { placed, written } = &centres[label];
            let origin = Origin {
                file: name,
                name: label,
                centres: written,
                scale,
                tolerance: reading.tolerance,
            };
            let track = *reading.tracks.get(label).unwrap_or(&reading.track);
            let line = FringeLine::along(&origin, track, placed)?;
            if reading.tolerance == f64::INFINITY {
                doubts.extend(OffTrack::of(&line, placed, written));
            }
            lines.push(line);
        }
        Ok((Self { field, lines }, doubts))
    }

    /// The line called `name`.
    pub fn line(&self, name: &str) -> Option<&FringeLine> {
        self.lines.iter().find(|line| line.name() == name)
    }
}
