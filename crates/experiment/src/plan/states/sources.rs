//! Load steps, tables, pictures and lines that data come from.

use std::collections::BTreeMap;
use std::path::PathBuf;

use stickslip_hybrid::data::{self, LineReading, Reading, Track, YAxis};

use super::super::refuse::{gradient, place};
use super::Scope;
use crate::format::{
    AxisFormat, ColumnsFormat, FilesFormat, LinesFormat, PicturesFormat, PresetFormat, TableFormat,
    TrackFormat,
};
use crate::{LineSource, PictureSource, Source, TableSource};
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::units::{Length, Quantity};

/// Standard deviation of fringe orders that are read to a quarter of a fringe: uniform in ±¼, ¼/√3.
const QUARTER_FRINGE: f64 = 0.144_337_567_297_406_44;

impl Scope<'_> {
    pub(super) fn step(&self, key: &str, step: usize) -> Result<Source, SceneError> {
        let Some(own) = &self.specimen.scene else {
            let example = "scene = \"scene.toml\"";
            return Err(self.refuse.missing("specimen", "scene", example));
        };
        if self.fringes.is_none() {
            let example = "[fringes] window = [[\"-2 mm\", \"-2 mm\"], [\"20 mm\", \"20 mm\"]], pixel = \"0.02 mm\"";
            return Err(self.refuse.missing("", "fringes", example));
        }
        self.needs_grating()?;
        let steps = own.scene.steps();
        if !(1..=steps).contains(&step) {
            let allowed = format!("from 1 to {steps}, the load steps of the scene");
            return Err(self.refuse.out_of_range(key, &step, &allowed));
        }
        Ok(Source::Step(step - 1))
    }

    pub(super) fn table(&self, key: &str, given: &TableFormat) -> Result<Source, SceneError> {
        let preset = match given.preset {
            PresetFormat::Plain => data::Format::plain(),
            PresetFormat::Dice => data::Format::dice(),
            PresetFormat::Mudic => data::Format::mudic(),
        };
        if preset.pixels && given.origin.is_none() {
            return Err(self.refuse.missing(
                key,
                "origin",
                "`origin = [512, 384]`, the pixel at which the body's origin is seen",
            ));
        }
        let [line, order] = [&given.columns.line, &given.columns.order];
        if line.is_some() || order.is_some() {
            let message = "'line' and 'order' are columns of fringe lines, not of displacements";
            let remedy = "name x, y, u, v or flag";
            return Err(self
                .refuse
                .conflict(&format!("{key}.columns"), message, remedy));
        }
        let format = renamed(preset, &given.columns);
        self.check_columns(key, &format)?;
        let length = |given: &Option<Quantity<Length>>| given.as_ref().map(Quantity::value);
        Ok(Source::Table(TableSource {
            file: self.folder.join(&given.file),
            format,
            reading: Reading {
                scale: Some(given.scale.value()),
                displacement_scale: length(&given.displacement_scale),
                y_axis: y_axis(given.y_axis),
                reversed: given.reversed,
                deviation: [0.0; 2],
            },
            origin: given.origin.unwrap_or_default(),
            deviation: length(&given.deviation),
        }))
    }

    pub(super) fn pictures(&self, key: &str, given: &PicturesFormat) -> Result<Source, SceneError> {
        self.needs_grating()?;
        let files = [&given.u, &given.v].map(|files| self.files(files.as_ref()));
        if files.iter().all(Vec::is_empty) {
            return Err(self
                .refuse
                .missing(key, "u", "u = \"up-u.png\", v = \"up-v.png\""));
        }
        let rising = given
            .rising
            .as_ref()
            .map_or([[1.0, 0.0], [0.0, 1.0]], |both| [both.u, both.v]);
        for (name, direction) in ["u", "v"].into_iter().zip(rising) {
            if direction[0].hypot(direction[1]) == 0.0 {
                let place = format!("{key}.rising.{name}");
                let allowed = "a direction, such as [1, 0]";
                return Err(self.refuse.out_of_range(&place, &"[0, 0]", allowed));
            }
        }
        Ok(Source::Pictures(PictureSource {
            files,
            pixel: given.pixel.value(),
            top_left: place(&given.top_left),
            upright: given.y_axis == AxisFormat::Up,
            carrier: given
                .carrier
                .as_ref()
                .map(|both| [gradient(&both.u), gradient(&both.v)]),
            rising,
            dark: given.dark,
        }))
    }

    fn files(&self, given: Option<&FilesFormat>) -> Vec<PathBuf> {
        match given {
            None => Vec::new(),
            Some(FilesFormat::One(name)) => vec![self.folder.join(name)],
            Some(FilesFormat::Four(names)) => {
                names.iter().map(|name| self.folder.join(name)).collect()
            }
        }
    }

    pub(super) fn lines(&self, key: &str, given: &LinesFormat) -> Result<Source, SceneError> {
        self.needs_grating()?;
        let names = &given.columns;
        if names.u.is_some() || names.v.is_some() || names.flag.is_some() {
            let message = "'u', 'v' and 'flag' are columns of displacements, not of fringe lines";
            let remedy = "name line, x, y or order";
            return Err(self
                .refuse
                .conflict(&format!("{key}.columns"), message, remedy));
        }
        let tolerance = given.tolerance.as_ref();
        let column = |name: &Option<String>, default: &str| {
            name.clone().unwrap_or_else(|| default.to_owned())
        };
        let reading = |reversed: bool, tracks: &BTreeMap<String, TrackFormat>| LineReading {
            columns: [
                column(&names.line, "line"),
                column(&names.x, "x"),
                column(&names.y, "y"),
                column(&names.order, "order"),
            ],
            scale: given.scale.value(),
            y_axis: y_axis(given.y_axis),
            reversed,
            tolerance: tolerance.map_or(f64::INFINITY, Quantity::value),
            track: track(&given.track),
            tracks: tracks
                .iter()
                .map(|(line, own)| (line.clone(), track(own)))
                .collect(),
        };
        Ok(Source::Lines(LineSource {
            files: [self.folder.join(&given.u), self.folder.join(&given.v)],
            reading: [
                reading(given.reversed[0], &given.tracks.u),
                reading(given.reversed[1], &given.tracks.v),
            ],
            deviation: given.deviation.unwrap_or(QUARTER_FRINGE),
        }))
    }

    pub(super) fn needs_grating(&self) -> Result<(), SceneError> {
        if self.grating.is_some() {
            return Ok(());
        }
        let example = "[grating] frequency = \"2400 1/mm\"";
        Err(self.refuse.missing("", "grating", example))
    }

    /// Refuses a column that is named for two things; upper and lower case are the same to a table.
    fn check_columns(&self, key: &str, format: &data::Format) -> Result<(), SceneError> {
        let named = format
            .places
            .iter()
            .chain(format.displacements.iter().flatten());
        let names: Vec<String> = named.map(|name| name.trim().to_lowercase()).collect();
        let twice = names
            .iter()
            .enumerate()
            .find(|(k, name)| names[..*k].contains(name));
        match twice {
            Some((_, name)) => Err(self.refuse.conflict(
                &format!("{key}.columns"),
                format!("column '{name}' is named for two of x, y, u and v"),
                "name a column for each",
            )),
            None => Ok(()),
        }
    }
}

fn y_axis(given: AxisFormat) -> YAxis {
    match given {
        AxisFormat::Up => YAxis::Up,
        AxisFormat::Down => YAxis::Down,
    }
}

fn track(given: &TrackFormat) -> Track {
    match given {
        TrackFormat::Straight => Track::Straight,
        TrackFormat::Drawn => Track::Drawn,
        TrackFormat::Circle(circle) => Track::Circle {
            centre: place(&circle.centre),
            closed: circle.closed,
        },
    }
}

/// The preset with other column names.
fn renamed(mut format: data::Format, columns: &ColumnsFormat) -> data::Format {
    let places = [&columns.x, &columns.y];
    for (own, name) in format.places.iter_mut().zip(places) {
        if let Some(name) = name {
            own.clone_from(name);
        }
    }
    let displacements = [&columns.u, &columns.v];
    for (own, name) in format.displacements.iter_mut().zip(displacements) {
        if let Some(name) = name {
            *own = Some(name.clone());
        }
    }
    if let Some(flag) = &columns.flag {
        format.flag = Some(flag.clone());
    }
    format
}
