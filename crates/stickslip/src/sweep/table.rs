//! Rows as CSV: one line per case, written and flushed as it is solved, and read again to go on or to draw.
//!
//! | column | holds |
//! | --- | --- |
//! | `case` | number of the case, from 0 |
//! | one per axis | its value, in the unit that the heading names |
//! | `load` | largest load of the history; contact and hoop stress are those of its step |
//! | `peak_pressure`, `contact_half_angle` | of the joint's contact |
//! | `peak_hoop`, `peak_hoop_angle` | largest hoop stress on the hole, and where |
//! | `stick_half_angle`, `bearing_stress`, `load_share` | of the joint's contact; the share where several contacts act on the plate |
//! | `peak_pressure_error`, …, `load_share_error`, `first_ply_load_error`, `joint_load_error` | estimated errors, each beside its number, where cases find their own model for an accuracy |
//! | `first_ply_load`, `first_ply`, `first_ply_criterion`, `first_ply_mode`, `first_ply_angle`, `first_ply_found` | the first ply to fail |
//! | `joint_load`, `joint_bearing_stress`, `joint_mode`, `joint_angle`, `joint_found` | failure on the characteristic curve |
//! | `seconds` | time of the case on its core |
//! | `outcome` | `solved`, or why not |
//! | `findings` | kinds of the findings of its run, `none` where there are no findings |
//!
//! `…_found` is `reached` where the history fails a ply, `projected` where its largest load was multiplied. What does not exist is
//! an empty cell. Tables of versions without `findings` are read too.

mod cells;

use std::io::Write;

use stickslip_report::table::Columns;
use stickslip_text::plain::{csv_cell, csv_text};

use super::row::{JointLoad, Measures, Outcome, PlyFailure, Row};
use super::{RowError, Sweep, SweepError};
use cells::{Cells, REACHED, whole};

/// Outcome of a case that has numbers.
const SOLVED: &str = "solved";
/// Cell of a case without findings; an empty cell says that they are not known.
const NO_FINDINGS: &str = "none";
/// Stands between kinds of findings.
const SEPARATOR: &str = "; ";
/// Word for a failure beyond the history.
const PROJECTED: &str = "projected";

/// Headings of the table of `sweep`.
pub fn headings(sweep: &Sweep) -> Vec<String> {
    columns(sweep).header()
}

/// The cells of a row.
pub fn cells(sweep: &Sweep, row: &Row) -> Vec<String> {
    columns(sweep).cells(row)
}

/// The columns of the table: those of a case, of its contact, its first ply and its joint, and what came of it.
fn columns(sweep: &Sweep) -> Columns<'_, &Row> {
    let mut columns = Columns::<&Row>::new().with("case", "", |row| row.case.to_string());
    for (index, axis) in sweep.axes.iter().enumerate() {
        columns = columns.with(axis.heading(), "", move |row| {
            axis.cell(sweep.values_of(row.case)[index])
        });
    }
    columns
        .and([
            contact_columns(sweep),
            first_ply_columns(sweep),
            joint_columns(sweep),
        ])
        .with("seconds", "", |row| format!("{:.4}", row.seconds))
        .with("outcome", "", |row| match &row.outcome {
            Outcome::Solved(_) => SOLVED.to_owned(),
            Outcome::Unresolved(reason) => reason.clone(),
        })
        .with("findings", "", |row| {
            let kinds = row.measures().and_then(|own| own.findings.as_deref());
            kinds.map_or_else(String::new, findings_cell)
        })
}

fn findings_cell(kinds: &[String]) -> String {
    if kinds.is_empty() {
        NO_FINDINGS.to_owned()
    } else {
        kinds.join(SEPARATOR)
    }
}

fn findings_of(cell: &str) -> Option<Vec<String>> {
    let kinds = cell.split(SEPARATOR).filter(|kind| *kind != NO_FINDINGS);
    (!cell.is_empty()).then(|| kinds.map(str::to_owned).collect())
}

/// A number as a cell, empty where there is none.
fn shown(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| value.to_string())
}

fn found(reached: bool) -> String {
    if reached { REACHED } else { PROJECTED }.to_owned()
}

/// A number of a case.
type Number = fn(&Measures) -> Option<f64>;

fn contact_columns(sweep: &Sweep) -> Columns<'_, &Row> {
    let stress = sweep.scene.display.stress.name;
    let number = |value: Number| move |row: &Row| shown(row.measures().and_then(value));
    let columns = Columns::new().with("load", &sweep.load_unit, number(|own| own.load));
    let quantities: [(&str, &str, Number, Number); 7] = [
        (
            "peak_pressure",
            stress,
            |own| own.peak_pressure,
            |own| own.errors.peak_pressure,
        ),
        (
            "contact_half_angle",
            "deg",
            |own| own.contact_half_angle,
            |own| own.errors.contact_half_angle,
        ),
        (
            "peak_hoop",
            stress,
            |own| Some(own.peak_hoop?[0]),
            |own| own.errors.peak_hoop,
        ),
        (
            "peak_hoop_angle",
            "deg",
            |own| Some(own.peak_hoop?[1]),
            |own| own.errors.peak_hoop_angle,
        ),
        (
            "stick_half_angle",
            "deg",
            |own| own.stick_half_angle,
            |own| own.errors.stick_half_angle,
        ),
        (
            "bearing_stress",
            stress,
            |own| own.bearing_stress,
            |own| own.errors.bearing_stress,
        ),
        (
            "load_share",
            "-",
            |own| own.load_share,
            |own| own.errors.load_share,
        ),
    ];
    quantities
        .into_iter()
        .fold(columns, |columns, (name, unit, value, error)| {
            let columns = columns.with(name, unit, number(value));
            if sweep.states_errors() {
                columns.with(format!("{name}_error"), unit, number(error))
            } else {
                columns
            }
        })
}

/// The column of a load's error behind `columns`, where cases state errors.
fn with_error<'a>(
    columns: Columns<'a, &'a Row>,
    sweep: &'a Sweep,
    name: &str,
    cell: impl Fn(&'a Row) -> String + 'a,
) -> Columns<'a, &'a Row> {
    if sweep.states_errors() {
        columns.with(name, &sweep.load_unit, cell)
    } else {
        columns
    }
}

fn first_ply_columns(sweep: &Sweep) -> Columns<'_, &Row> {
    let cell = |cell: fn(&PlyFailure) -> String| {
        move |row: &Row| {
            let first = row.measures().and_then(|own| own.first_ply.as_ref());
            first.map_or_else(String::new, cell)
        }
    };
    let load = Columns::new().with(
        "first_ply_load",
        &sweep.load_unit,
        cell(|first| shown(first.load)),
    );
    let error = cell(|first| shown(first.load_error));
    with_error(load, sweep, "first_ply_load_error", error)
        .with("first_ply", "", cell(|first| first.ply.clone()))
        .with(
            "first_ply_criterion",
            "",
            cell(|first| first.criterion.clone()),
        )
        .with("first_ply_mode", "", cell(|first| first.mode.clone()))
        .with("first_ply_angle", "deg", cell(|first| shown(first.angle)))
        .with("first_ply_found", "", cell(|first| found(first.reached)))
}

fn joint_columns(sweep: &Sweep) -> Columns<'_, &Row> {
    let stress = sweep.scene.display.stress.name;
    let cell = |cell: fn(&JointLoad) -> String| {
        move |row: &Row| row.joint().map_or_else(String::new, cell)
    };
    let load = Columns::new().with(
        "joint_load",
        &sweep.load_unit,
        cell(|joint| shown(joint.load)),
    );
    let error = cell(|joint| shown(joint.load_error));
    with_error(load, sweep, "joint_load_error", error)
        .with(
            "joint_bearing_stress",
            stress,
            cell(|joint| shown(joint.bearing_stress)),
        )
        .with("joint_mode", "", cell(|joint| joint.mode.name().to_owned()))
        .with("joint_angle", "deg", cell(|joint| shown(Some(joint.angle))))
        .with("joint_found", "", cell(|joint| found(joint.reached)))
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
    let mut expected = headings(sweep);
    let mut rows: Vec<Row> = Vec::new();
    for (index, record) in reader.records().enumerate() {
        let fail = |cause: RowError| SweepError::Row {
            line: index as u64 + 1,
            cause,
        };
        let record = record.map_err(|cause| fail(cause.into()))?;
        let found: Vec<&str> = record.iter().map(csv_text).collect();
        if index == 0 {
            // Earlier versions had no findings, the last column.
            expected.truncate(found.len().max(expected.len() - 1));
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
            return Err(fail(RowError::Cells {
                cells: record.len(),
                headings: expected.len(),
            }));
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
fn row(sweep: &Sweep, cells: &[&str]) -> Result<Row, RowError> {
    let mut cells = Cells(cells.iter());
    let case = whole(cells.next())?;
    if case >= sweep.cases() {
        let cases = sweep.cases();
        return Err(RowError::Case { case, cases });
    }
    for _ in &sweep.axes {
        cells.next();
    }
    let mut measures = cells.contact(sweep.states_errors())?;
    measures.first_ply = cells.first_ply(sweep.states_errors())?;
    measures.joint = cells.joint(sweep.states_errors())?;
    let seconds = cells.number()?.unwrap_or_default();
    let outcome = cells.next();
    measures.findings = findings_of(cells.next());
    let outcome = match outcome {
        SOLVED => Outcome::Solved(Box::new(measures)),
        "" => return Err(RowError::Outcome),
        reason => Outcome::Unresolved(reason.to_owned()),
    };
    Ok(Row {
        case,
        seconds,
        outcome,
    })
}
