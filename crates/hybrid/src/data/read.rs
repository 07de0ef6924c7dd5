//! Displacements at scattered places from a table.

use std::collections::BTreeMap;
use std::io::Read;

use stickslip_fem_core::mesh::Point;

use super::format::{LENGTH, positive};
use super::table::Table;
use super::{DataError, Field, Format, Measurement, Places, Reading};
use crate::order_statistics::above;

impl Measurement {
    /// Reads a table of displacements; `name` is what errors call it.
    ///
    /// Columns are parted by tabs, semicolons, commas or blanks, whichever the header uses; lines that start with `*` or `#` are
    /// comments. Decimal commas are read where the table has no decimal point, and a row of units below the header is kept in
    /// [`Rows::units`]. A component is masked where it is empty or NaN, both where the flag column is negative, empty or NaN. A point
    /// that has neither a displacement nor a place is left out. In a deformed state a point with a masked component has no
    /// reference place; it is kept masked, at the place that the known components give.
    ///
    /// # Errors
    /// [`DataError`] with file, line, column and value: columns that are missing or repeated, no scale, a field that is no number,
    /// a displacement without a place, two points at one place, no data, no valid data, settings out of range.
    pub fn read(
        reader: impl Read,
        name: &str,
        format: &Format,
        reading: &Reading,
    ) -> Result<Self, DataError> {
        Self::read_rows(reader, name, format, reading).map(|(measurement, _)| measurement)
    }

    /// As [`read`](Self::read), with what the table's rows say besides.
    ///
    /// # Errors
    /// As [`read`](Self::read).
    pub fn read_rows(
        reader: impl Read,
        name: &str,
        format: &Format,
        reading: &Reading,
    ) -> Result<(Self, Rows), DataError> {
        let scales = scales(name, format, reading)?;
        let table = Table::read(reader, name)?;
        let columns = Columns::of(&table, format)?;
        let mut measurement = Self {
            deviation: reading.deviation,
            ..Self::default()
        };
        let mut rows = Rows {
            units: columns.units(&table),
            ..Rows::default()
        };
        let mut steps = [Vec::new(), Vec::new()];
        let mut seen = BTreeMap::new();
        for row in 0..table.len() {
            let raw = columns.row(&table, row)?;
            let Some((place, values)) = columns.convert(&table, row, raw, scales, format.moved)?
            else {
                continue;
            };
            // Adding zero makes −0 and 0 one place.
            let key = place.map(|x| (x + 0.0).to_bits());
            // A row with a place in the body has one in the table.
            let own = raw.0.map(Option::unwrap_or_default);
            if let Some((first, other)) = seen.insert(key, (table.line(row), own)) {
                return Err(DataError::DuplicatedPoint {
                    file: name.into(),
                    first,
                    second: table.line(row),
                    places: [other, own],
                });
            }
            measurement.push(place, values);
            rows.lines.push(table.line(row));
            for c in 0..2 {
                if let (Some(column), Some(_)) = (columns.displacements[c], values[c]) {
                    steps[c].extend(last_digit(table.text(row, column)));
                }
            }
        }
        for (c, steps) in steps.into_iter().enumerate() {
            // Round numbers lack digits that others have, and small ones may have more than others.
            let tenth = above(steps, 0.1).unwrap_or(0.0);
            rows.step[c] = scales.displacements[c].abs() * tenth;
        }
        if measurement.valid.iter().flatten().any(|&valid| valid) {
            Ok((measurement, rows))
        } else {
            Err(DataError::AllMasked {
                file: name.into(),
                rows: table.len(),
                remedy: "look at the flag column and at the displacements, or name other columns",
            })
        }
    }

    /// Whether the lists fit each other, and places and valid displacements are finite.
    ///
    /// # Errors
    /// [`DataError::Lengths`] or [`DataError::NotFinite`].
    pub fn check(&self) -> Result<(), DataError> {
        let places = self.places.len();
        for c in 0..2 {
            for (what, found) in [
                ("displacements", self.displacements[c].len()),
                ("marks of validity", self.valid[c].len()),
            ] {
                if found != places {
                    return Err(DataError::Lengths {
                        what,
                        places,
                        found,
                    });
                }
            }
        }
        for (index, &place) in self.places.iter().enumerate() {
            let valid = [0, 1].map(|c: usize| {
                if self.valid[c][index] {
                    self.displacements[c][index]
                } else {
                    0.0
                }
            });
            for (what, values) in [("measured place", place), ("measured displacement", valid)] {
                if !values.iter().all(|value| value.is_finite()) {
                    return Err(DataError::NotFinite {
                        what,
                        index,
                        values,
                    });
                }
            }
        }
        Ok(())
    }

    /// Adds a place `[length]` with its displacements `[length]`; a component that is `None` is masked there.
    pub fn push(&mut self, place: Point, displacements: [Option<f64>; 2]) {
        self.places.push(place);
        for (c, value) in displacements.into_iter().enumerate() {
            self.displacements[c].push(value.unwrap_or(f64::NAN));
            self.valid[c].push(value.is_some());
        }
    }

    /// How many places have a valid displacement of a field.
    pub fn count(&self, field: Field) -> usize {
        self.valid[field.component()]
            .iter()
            .filter(|&&valid| valid)
            .count()
    }
}

/// What the rows of a table say besides displacements.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rows {
    /// Line of each place in the file, counted from 1.
    pub lines: Vec<u64>,
    /// What one step of the last digit is `[length]`, to which displacements x and y are rounded; of numbers that are not zero, one in ten
    /// has a finer one. 0 where all are zero.
    pub step: [f64; 2],
    /// Units that a row below the header states for the columns in use.
    pub units: Vec<Unit>,
}

/// The unit that a table states for a column.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Unit {
    /// Line in the file, counted from 1.
    pub line: u64,
    /// Name of the column.
    pub column: String,
    /// Its unit as it is written, without brackets.
    pub unit: String,
    /// Whether it is a place's, and not a displacement's.
    pub of_place: bool,
}

/// What one step of a number's last digit is; nothing of zero, whose digits say little.
fn last_digit(text: &str) -> Option<f64> {
    let value: f64 = text.parse().ok().filter(|value| *value != 0.0)?;
    let (digits, power) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    let decimals = digits.split_once('.').map_or(0, |(_, after)| after.len());
    let power: i32 = power.parse().ok()?;
    let step = 10.0_f64.powi(power.saturating_sub(decimals.try_into().ok()?));
    Some(step.max(f64::EPSILON * value.abs()))
}

/// The same question to two things.
fn both<T, R, E>(pair: &[T; 2], ask: impl Fn(&T) -> Result<R, E>) -> Result<[R; 2], E> {
    Ok([ask(&pair[0])?, ask(&pair[1])?])
}

/// Signed factors of places and of displacements.
#[derive(Clone, Copy)]
struct Scales {
    places: [f64; 2],
    displacements: [f64; 2],
}

fn scales(name: &str, format: &Format, reading: &Reading) -> Result<Scales, DataError> {
    let scale = match reading.scale {
        Some(scale) => positive("the scale", scale)?,
        None if format.pixels => return Err(DataError::NoScale { file: name.into() }),
        None => 1.0,
    };
    let other = reading.displacement_scale.map_or(Ok(scale), |value| {
        positive("the scale of displacements", value)
    })?;
    for value in reading.deviation {
        if !(value.is_finite() && value >= 0.0) {
            return Err(DataError::Setting {
                what: "the standard deviation",
                value,
                range: LENGTH,
            });
        }
    }
    let sign = reading.y_axis.sign();
    let turned = reading
        .reversed
        .map(|reversed| if reversed { -other } else { other });
    Ok(Scales {
        places: [scale, sign * scale],
        displacements: [turned[0], sign * turned[1]],
    })
}

/// Indices of the columns in use.
struct Columns {
    places: [usize; 2],
    displacements: [Option<usize>; 2],
    flag: Option<usize>,
}

/// A place and a displacement in the body's frame.
type Converted = (Point, [Option<f64>; 2]);

/// Numbers of a row as they are: place, displacement.
type Raw = ([Option<f64>; 2], [Option<f64>; 2]);

impl Columns {
    fn of(table: &Table, format: &Format) -> Result<Self, DataError> {
        let stated = |column: &Option<String>| {
            let name = column.as_ref();
            name.map(|name| table.column(name)).transpose()
        };
        Ok(Self {
            places: both(&format.places, |name| table.column(name))?,
            displacements: both(&format.displacements, stated)?,
            flag: stated(&format.flag)?,
        })
    }

    /// Units of places and displacements.
    fn units(&self, table: &Table) -> Vec<Unit> {
        let places = self.places.iter().map(|&column| (column, true));
        let displacements = self.displacements.iter().flatten();
        let all = places.chain(displacements.map(|&column| (column, false)));
        let unit = |(column, of_place)| {
            let (line, unit) = table.unit(column)?;
            Some(Unit {
                line,
                column: table.name(column).to_owned(),
                unit: unit.to_owned(),
                of_place,
            })
        };
        all.filter_map(unit).collect()
    }

    fn row(&self, table: &Table, row: usize) -> Result<Raw, DataError> {
        let place = both(&self.places, |&column| table.number(row, column))?;
        let displacement = both(&self.displacements, |column| {
            column.map_or(Ok(None), |column| table.number(row, column))
        })?;
        let failed = match self.flag {
            Some(column) => table.number(row, column)?.is_none_or(|flag| flag < 0.0),
            None => false,
        };
        Ok((place, if failed { [None; 2] } else { displacement }))
    }

    /// Place and displacement in the body's frame; nothing for a row without either.
    fn convert(
        &self,
        table: &Table,
        row: usize,
        (place, displacement): Raw,
        scales: Scales,
        moved: Places,
    ) -> Result<Option<Converted>, DataError> {
        let ([Some(x), Some(y)], known) = (place, displacement) else {
            let column = self.places[usize::from(place[0].is_some())];
            return if displacement == [None; 2] {
                Ok(None)
            } else {
                Err(table.refuse(
                    row,
                    column,
                    "is no place for a displacement",
                    "give the place, or NaN for the displacement",
                ))
            };
        };
        let mut point = [x * scales.places[0], y * scales.places[1]];
        let values: [Option<f64>; 2] =
            std::array::from_fn(|c| known[c].map(|u| u * scales.displacements[c]));
        if moved == Places::Deformed {
            for c in 0..2 {
                point[c] -= values[c].unwrap_or(0.0);
            }
        }
        for c in 0..2 {
            if !(point[c].is_finite() && values[c].is_none_or(f64::is_finite)) {
                return Err(table.refuse(
                    row,
                    self.places[c],
                    "or its displacement overflows with the scale",
                    "state a smaller scale",
                ));
            }
        }
        Ok(Some((point, values)))
    }
}
