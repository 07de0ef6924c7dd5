//! Rows as CSV: one line per case, written and flushed as it is solved, and read again to go on or to draw.
//!
//! | column | holds |
//! | --- | --- |
//! | `case` | number of the case, from 0 |
//! | one per axis | its value, in the unit that the heading names |
//! | `load` | largest load of the history; contact and hoop stress are those of its step |
//! | `peak_pressure`, `contact_half_angle` | of the joint's contact |
//! | `peak_hoop`, `peak_hoop_angle` | largest hoop stress on the hole, and where |
//! | `first_ply_load`, `first_ply`, `first_ply_criterion`, `first_ply_mode`, `first_ply_angle`, `first_ply_found` | the first ply to fail |
//! | `joint_load`, `joint_bearing_stress`, `joint_mode`, `joint_angle`, `joint_found` | failure on the characteristic curve |
//! | `seconds` | time of the case on its core |
//! | `outcome` | `solved`, or why not |
//!
//! `…_found` is `reached` where the history fails a ply, `projected` where its largest load was multiplied. What does not exist is
//! an empty cell.

use std::io::Write;

use stickslip_text::plain::{csv_cell, csv_text};

use super::row::{JointLoad, Measures, Outcome, PlyFailure, Row};
use super::{Sweep, SweepError};
use stickslip_engine::results::JointMode;

/// Outcome of a case that has numbers.
const SOLVED: &str = "solved";
/// Words for a failure that the history reaches, and for one beyond it.
const REACHED: &str = "reached";
const PROJECTED: &str = "projected";

const MODES: [JointMode; 5] = [
    JointMode::Bearing,
    JointMode::BearingAndShearOut,
    JointMode::ShearOut,
    JointMode::ShearOutAndNetTension,
    JointMode::NetTension,
];

/// Headings of the table of `sweep`.
pub fn headings(sweep: &Sweep) -> Vec<String> {
    let stress = sweep.scene.display.stress.name;
    let load = &sweep.load_unit;
    let mut headings = vec!["case".to_owned()];
    headings.extend(sweep.axes.iter().map(super::axis::Axis::heading));
    headings.extend([
        format!("load [{load}]"),
        format!("peak_pressure [{stress}]"),
        "contact_half_angle [deg]".to_owned(),
        format!("peak_hoop [{stress}]"),
        "peak_hoop_angle [deg]".to_owned(),
        format!("first_ply_load [{load}]"),
        "first_ply".to_owned(),
        "first_ply_criterion".to_owned(),
        "first_ply_mode".to_owned(),
        "first_ply_angle [deg]".to_owned(),
        "first_ply_found".to_owned(),
        format!("joint_load [{load}]"),
        format!("joint_bearing_stress [{stress}]"),
        "joint_mode".to_owned(),
        "joint_angle [deg]".to_owned(),
        "joint_found".to_owned(),
        "seconds".to_owned(),
        "outcome".to_owned(),
    ]);
    headings
}

/// The cells of a row.
pub fn cells(sweep: &Sweep, row: &Row) -> Vec<String> {
    let none = Measures::default();
    let measures = row.measures().unwrap_or(&none);
    let number = |value: Option<f64>| value.map_or_else(String::new, |value| value.to_string());
    let found = |reached: bool| if reached { REACHED } else { PROJECTED }.to_owned();
    let mut cells = vec![row.case.to_string()];
    let values = sweep.values_of(row.case);
    cells.extend(
        sweep
            .axes
            .iter()
            .zip(values)
            .map(|(axis, value)| axis.cell(value)),
    );
    cells.extend([
        number(measures.load),
        number(measures.peak_pressure),
        number(measures.contact_half_angle),
        number(measures.peak_hoop.map(|[most, _]| most)),
        number(measures.peak_hoop.map(|[_, place]| place)),
    ]);
    match &measures.first_ply {
        Some(first) => cells.extend([
            number(first.load),
            first.ply.clone(),
            first.criterion.clone(),
            first.mode.clone(),
            number(first.angle),
            found(first.reached),
        ]),
        None => cells.extend(std::iter::repeat_n(String::new(), 6)),
    }
    match &measures.joint {
        Some(joint) => cells.extend([
            number(joint.load),
            number(joint.bearing_stress),
            joint.mode.name().to_owned(),
            number(Some(joint.angle)),
            found(joint.reached),
        ]),
        None => cells.extend(std::iter::repeat_n(String::new(), 5)),
    }
    cells.push(format!("{:.4}", row.seconds));
    cells.push(match &row.outcome {
        Outcome::Solved(_) => SOLVED.to_owned(),
        Outcome::Unresolved(reason) => reason.clone(),
    });
    cells
}

/// Writes rows to `out`, each of them flushed.
#[derive(Debug)]
pub struct Writer<W: Write> {
    csv: csv::Writer<W>,
}

impl<W: Write> Writer<W> {
    /// A writer that goes on after the last row of a table.
    pub fn after_rows(out: W) -> Self {
        Self {
            csv: csv::Writer::from_writer(out),
        }
    }

    /// A writer that begins with the headings.
    ///
    /// # Errors
    /// [`SweepError::Write`].
    pub fn new(out: W, sweep: &Sweep) -> Result<Self, SweepError> {
        let mut writer = Self::after_rows(out);
        writer.put(&headings(sweep))?;
        Ok(writer)
    }

    /// Writes and flushes a row.
    ///
    /// # Errors
    /// [`SweepError::Write`].
    pub fn write(&mut self, sweep: &Sweep, row: &Row) -> Result<(), SweepError> {
        self.put(&cells(sweep, row))
    }

    fn put(&mut self, cells: &[String]) -> Result<(), SweepError> {
        let written = self
            .csv
            .write_record(cells.iter().map(|cell| csv_cell(cell).into_owned()))
            .and_then(|()| Ok(self.csv.flush()?));
        written.map_err(|cause| SweepError::Write { cause })
    }
}

/// The whole table of `rows`, by case.
///
/// # Errors
/// [`SweepError::Write`].
pub fn text(sweep: &Sweep, rows: &[Row]) -> Result<Vec<u8>, SweepError> {
    let mut bytes = Vec::new();
    let mut sorted: Vec<&Row> = rows.iter().collect();
    sorted.sort_by_key(|row| row.case);
    let mut writer = Writer::new(&mut bytes, sweep)?;
    for row in sorted {
        writer.write(sweep, row)?;
    }
    drop(writer);
    Ok(bytes)
}

/// The rows of the table `text` of `sweep`. A last line that was cut short in the middle is left out.
///
/// # Errors
/// [`SweepError::Other`] for other headings or values, [`SweepError::Row`] for a row that this program did not write.
pub fn read(sweep: &Sweep, text: &str) -> Result<Vec<Row>, SweepError> {
    // Whatever follows the last line break was being written when the program was ended.
    let complete = text.rfind('\n').map_or("", |end| &text[..=end]);
    let mut reader = csv::ReaderBuilder::new()
        .flexible(true)
        .has_headers(false)
        .from_reader(complete.as_bytes());
    let expected = headings(sweep);
    let mut rows: Vec<Row> = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let fail = |what: String| SweepError::Row {
            line: index as u64 + 1,
            what,
        };
        let record = record.map_err(|cause| fail(cause.to_string()))?;
        let found: Vec<&str> = record.iter().map(csv_text).collect();
        if index == 0 {
            if found
                .iter()
                .copied()
                .ne(expected.iter().map(String::as_str))
            {
                let what = "its columns are others".to_owned();
                return Err(SweepError::Other { what });
            }
            continue;
        }
        if record.len() != expected.len() {
            let what = format!("{} cells under {} headings", record.len(), expected.len());
            return Err(fail(what));
        }
        let row = row(sweep, &found).map_err(fail)?;
        let values = sweep.values_of(row.case);
        let mut own = sweep.axes.iter().zip(values).zip(&found[1..]);
        if let Some(((axis, value), found)) =
            own.find(|((axis, value), found)| axis.cell(*value) != **found)
        {
            let what = format!(
                "case {} has {} = {found}, here it is {}",
                row.case,
                axis.key.name(),
                axis.cell(value)
            );
            return Err(SweepError::Other { what });
        }
        if rows.iter().all(|other| other.case != row.case) {
            rows.push(row);
        }
    }
    Ok(rows)
}

/// A row from its cells, of which there are as many as headings.
fn row(sweep: &Sweep, cells: &[&str]) -> Result<Row, String> {
    let mut left = cells.iter().copied();
    let mut next = || left.next().unwrap_or_default();
    let case = whole(next())?;
    if case >= sweep.cases() {
        return Err(format!(
            "case {case} is none of the {} of this sweep",
            sweep.cases()
        ));
    }
    for _ in &sweep.axes {
        next();
    }
    let measures = Measures {
        load: number(next())?,
        peak_pressure: number(next())?,
        contact_half_angle: number(next())?,
        peak_hoop: pair(number(next())?, number(next())?),
        first_ply: {
            let load = number(next())?;
            let (ply, criterion, mode) = (next(), next(), next());
            let (angle, found) = (number(next())?, next());
            (!found.is_empty()).then(|| PlyFailure {
                load,
                ply: ply.to_owned(),
                criterion: criterion.to_owned(),
                mode: mode.to_owned(),
                angle,
                reached: found == REACHED,
            })
        },
        joint: {
            let (load, bearing_stress) = (number(next())?, number(next())?);
            let (mode, angle, found) = (next(), number(next())?, next());
            match MODES
                .into_iter()
                .find(|known| known.name() == mode)
                .zip(angle)
            {
                Some((mode, angle)) => Some(JointLoad {
                    load,
                    bearing_stress,
                    mode,
                    angle,
                    reached: found == REACHED,
                }),
                None if mode.is_empty() => None,
                None => return Err(format!("'{mode}' is no failure mode with an angle")),
            }
        },
    };
    let seconds = number(next())?.unwrap_or_default();
    let outcome = match next() {
        SOLVED => Outcome::Solved(Box::new(measures)),
        "" => return Err("there is no outcome".to_owned()),
        reason => Outcome::Unresolved(reason.to_owned()),
    };
    Ok(Row {
        case,
        seconds,
        outcome,
    })
}

fn whole(cell: &str) -> Result<usize, String> {
    cell.parse()
        .map_err(|_| format!("'{cell}' is no number of a case"))
}

/// A number, or none in an empty cell.
fn number(cell: &str) -> Result<Option<f64>, String> {
    if cell.is_empty() {
        return Ok(None);
    }
    let value = cell.parse::<f64>();
    value
        .map(Some)
        .map_err(|_| format!("'{cell}' is no number"))
}

fn pair(first: Option<f64>, second: Option<f64>) -> Option<[f64; 2]> {
    first.zip(second).map(|(first, second)| [first, second])
}
