//! States of an experiment, and where their data come from.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};
use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{self, LineReading, Reading};

/// Whether the load was growing or falling.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Direction {
    /// Growing.
    Loading,
    /// Falling.
    Unloading,
}

impl Direction {
    /// "loading" or "unloading".
    pub const fn name(self) -> &'static str {
        match self {
            Self::Loading => "loading",
            Self::Unloading => "unloading",
        }
    }
}

/// One state of the experiment.
#[derive(Clone, Debug, PartialEq)]
pub struct State {
    /// Its name, a part of file names.
    pub name: String,
    /// Whether the load was growing or falling.
    pub direction: Direction,
    /// Remote load `[N]`.
    pub load: Option<f64>,
    /// Known components along x and y of the force on the region through its edge `[N]`.
    pub edge_force: [Option<f64>; 2],
    /// Where its data come from.
    pub source: Source,
    /// The initial load's data, to be taken off.
    pub null: Option<Source>,
    /// Data of the back, for the check of symmetry.
    pub back: Option<Source>,
}

impl State {
    /// Whether any of its data are a table.
    pub fn has_table(&self) -> bool {
        let also = self.null.iter().chain(&self.back);
        (also.chain([&self.source])).any(|source| matches!(source, Source::Table(_)))
    }
}

/// Where data come from.
#[derive(Clone, Debug, PartialEq)]
pub enum Source {
    /// Synthetic pictures of this load step of the scene, counted from 0.
    Step(usize),
    /// A table of displacements.
    Table(TableSource),
    /// Fringe pictures.
    Pictures(PictureSource),
    /// Tables of fringe centres along lines.
    Lines(LineSource),
}

impl Source {
    /// Whether it is made from the solution of the scene.
    pub const fn is_synthetic(&self) -> bool {
        matches!(self, Self::Step(_))
    }

    /// The files that it is read from.
    pub fn files(&self) -> Vec<&Path> {
        match self {
            Self::Step(_) => Vec::new(),
            Self::Table(table) => vec![&table.file],
            Self::Pictures(pictures) => pictures
                .files
                .iter()
                .flatten()
                .map(PathBuf::as_path)
                .collect(),
            Self::Lines(lines) => lines.files.iter().map(PathBuf::as_path).collect(),
        }
    }
}

/// A table of displacements.
#[derive(Clone, Debug, PartialEq)]
pub struct TableSource {
    /// The file.
    pub file: PathBuf,
    /// Its columns.
    pub format: data::Format,
    /// What its numbers are; the standard deviation is that below.
    pub reading: Reading,
    /// Where the origin of the body's frame is, in the table's own unit.
    pub origin: [f64; 2],
    /// Standard deviation of either component `[mm]`; estimated from the scatter of neighbours where it is not stated.
    pub deviation: Option<f64>,
}

/// Fringe pictures of the two fields.
#[derive(Clone, Debug, PartialEq)]
pub struct PictureSource {
    /// Files of the U and of the V field: one, or four with shifted phase; none where a field was not measured.
    pub files: [Vec<PathBuf>; 2],
    /// Edge of a pixel `[mm]`.
    pub pixel: f64,
    /// Corner of the picture at its top and its left, in the body's frame `[mm]`.
    pub top_left: Point,
    /// Whether the body's y points up in the picture.
    pub upright: bool,
    /// Carriers of the two fields `[1/mm]`, where they are known.
    pub carrier: Option<[[f64; 2]; 2]>,
    /// Directions in which the orders of the two fields rise `[1]`, carrier included.
    pub rising: [[f64; 2]; 2],
    /// Pixels of at most this intensity `[intensity]` are missing.
    pub dark: Option<f64>,
}

/// Tables of fringe centres along lines.
#[derive(Clone, Debug, PartialEq)]
pub struct LineSource {
    /// Files of the U and of the V field.
    pub files: [PathBuf; 2],
    /// What the numbers of each are.
    pub reading: [LineReading; 2],
    /// Standard deviation of an order `[fringes]`.
    pub deviation: f64,
}
