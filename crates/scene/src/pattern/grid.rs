//! Rows, columns and pitch of a pattern.

use serde::Deserialize;

use crate::diagnostic::{SceneError, SceneProblem};
use crate::document::{Document, Part, child};
use crate::read::Reader;
use crate::shape::pattern::{COPIES, MOST, PatternFormat};
use crate::units::{Length, Quantity};

/// Row and column of a copy, from 0.
pub(super) type Cell = [usize; 2];

/// How copies stand.
#[derive(Clone, Debug)]
pub(super) struct Grid {
    pub(super) rows: usize,
    pub(super) columns: usize,
    /// From one column to the next along x, and from one row to the next along y.
    pitch: Option<[Quantity<Length>; 2]>,
}

impl Grid {
    /// The pattern of the table `table`, if it has one, whose copies need places of their own if they are `placed` or the table has a position.
    pub(super) fn of(
        document: &Document,
        table: &str,
        placed: bool,
    ) -> Result<Option<Self>, SceneError> {
        let key = child(table, "pattern");
        let Some(written) = document.get(&key) else {
            return Ok(None);
        };
        let read = PatternFormat::deserialize(Reader::new(written, &key));
        let PatternFormat {
            rows,
            columns,
            pitch,
        } = read.map_err(|error| {
            let at = error.key.clone().unwrap_or_else(|| key.clone());
            document.error(&at, error.part, *error.problem)
        })?;
        for (name, count) in [("rows", rows), ("columns", columns)] {
            if let Some(count) = count.filter(|count| !(1..=MOST).contains(count)) {
                let problem = SceneProblem::OutOfRange {
                    key: name.to_owned(),
                    value: count.to_string(),
                    allowed: format!("1 to {MOST}"),
                };
                return Err(document.error(&child(&key, name), Part::Value, problem));
            }
        }
        let copies = rows.unwrap_or(1) * columns.unwrap_or(1);
        if copies > COPIES {
            let problem = SceneProblem::conflict(
                format!("the pattern has {copies} copies, and at most {COPIES} are written out"),
                "give fewer rows or columns",
            );
            return Err(document.error(&key, Part::Key, problem));
        }
        let stands = document.get(&child(table, "position")).is_some();
        if (placed || stands) && pitch.is_none() {
            let problem = SceneProblem::MissingKey {
                key: "pitch".to_owned(),
                table: format!("[{key}]"),
                example: r#"pitch = ["24 mm", "20 mm"]"#.to_owned(),
            };
            return Err(document.error(&key, Part::Key, problem));
        }
        let counts = [("columns", columns), ("rows", rows)].into_iter();
        for (part, (name, count)) in pitch.iter().flatten().zip(counts) {
            if part.value() == 0.0 && count.is_some_and(|count| count > 1) {
                let problem = SceneProblem::conflict(
                    format!("the pitch of its {name} is 0, so that copies stand in one place"),
                    format!("give another pitch, or leave {name} out"),
                );
                return Err(document.error(&child(&key, "pitch"), Part::Value, problem));
            }
        }
        Ok(Some(Self {
            rows: rows.unwrap_or(1),
            columns: columns.unwrap_or(1),
            pitch,
        }))
    }

    /// Its cells, row by row.
    pub(super) fn cells(&self) -> impl Iterator<Item = Cell> + use<> {
        let columns = self.columns;
        (0..self.rows).flat_map(move |row| (0..columns).map(move |column| [row, column]))
    }

    /// Steps along x and y to a cell, each with the pitch; none without one.
    pub(super) fn steps(&self, [row, column]: Cell) -> Vec<(usize, &Quantity<Length>)> {
        let pitch = self.pitch.iter().flatten();
        [column, row].into_iter().zip(pitch).collect()
    }
}

/// The name of a copy.
pub(super) fn named(name: &str, [row, column]: Cell) -> String {
    format!("{name}_{}_{}", row + 1, column + 1)
}
