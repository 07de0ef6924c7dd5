//! States and where their data come from.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use stickslip_hybrid::data::{self, LineReading, Reading, Track, YAxis};
use stickslip_hybrid::moire::Grating;

use super::read::{Refuse, gradient, place};
use super::{Direction, Fringes, LineSource, PictureSource, Source, Specimen, State, TableSource};
use crate::diagnostic::SceneError;
use crate::experiment::format::{
    AxisFormat, ColumnsFormat, DirectionFormat, FilesFormat, LinesFormat, PicturesFormat,
    PresetFormat, SourceFormat, StateFormat, TableFormat, TrackFormat,
};
use crate::experiment::history::History;

/// Standard deviation of fringe orders that are read to a quarter of a fringe: uniform in ±¼, ¼/√3.
const QUARTER_FRINGE: f64 = 0.144_337_567_297_406_44;
/// Longest name of a state, which is a part of file names.
const LONGEST_NAME: usize = 64;

/// What states are read with.
#[derive(Clone, Copy)]
pub(super) struct Scope<'a> {
    pub(super) refuse: Refuse<'a>,
    pub(super) specimen: &'a Specimen,
    pub(super) grating: Option<&'a Grating>,
    pub(super) fringes: Option<&'a Fringes>,
    pub(super) folder: &'a Path,
}

/// One of the ways to give data.
struct Ways<'a> {
    step: Option<usize>,
    table: Option<&'a TableFormat>,
    pictures: Option<&'a PicturesFormat>,
    lines: Option<&'a LinesFormat>,
}

impl<'a> From<&'a SourceFormat> for Ways<'a> {
    fn from(given: &'a SourceFormat) -> Self {
        Self {
            step: given.step,
            table: given.table.as_ref(),
            pictures: given.pictures.as_ref(),
            lines: given.lines.as_ref(),
        }
    }
}

impl Scope<'_> {
    /// The states; without any, all load steps of the scene.
    pub(super) fn states(&self, given: &[StateFormat]) -> Result<Vec<State>, SceneError> {
        let history = self
            .specimen
            .scene
            .as_ref()
            .map(|own| History::of(&own.scene));
        if given.is_empty() {
            let Some(history) = history.filter(|_| self.fringes.is_some()) else {
                let example = "[[states]] name = \"up\", table = { file = \"up.csv\", scale = \"1 mm\", y_axis = \"up\" }";
                return Err(self.refuse.missing("", "states", example));
            };
            self.needs_grating()?;
            return Ok((0..history.steps())
                .map(|step| history.state(step))
                .collect());
        }
        let mut states: Vec<State> = Vec::new();
        for (index, state) in given.iter().enumerate() {
            let key = format!("states.{index}");
            self.check_name(&key, &state.name, &states)?;
            let ways = Ways {
                step: state.step,
                table: state.table.as_ref(),
                pictures: state.pictures.as_ref(),
                lines: state.lines.as_ref(),
            };
            let source = self.source(&key, &ways)?;
            let other = |name: &str, given: &Option<SourceFormat>| {
                let given = given.as_ref();
                given
                    .map(|given| self.source(&format!("{key}.{name}"), &given.into()))
                    .transpose()
            };
            let (null, back) = (other("null", &state.null)?, other("back", &state.back)?);
            self.check_null(&key, &source, null.as_ref())?;
            let load = match (&state.load, &source, &history) {
                (Some(load), _, _) => Some(load.value()),
                (None, Source::Step(step), Some(history)) => history.load(*step),
                _ => None,
            };
            let direction = match (state.direction, &source, &history) {
                (Some(DirectionFormat::Loading), _, _) => Direction::Loading,
                (Some(DirectionFormat::Unloading), _, _) => Direction::Unloading,
                (None, Source::Step(step), Some(history)) => history.direction(*step),
                _ => falling(&states, load),
            };
            states.push(State {
                name: state.name.clone(),
                direction,
                load,
                source,
                null,
                back,
            });
        }
        Ok(states)
    }

    fn check_name(&self, key: &str, name: &str, before: &[State]) -> Result<(), SceneError> {
        let plain = |c: char| c.is_alphanumeric() || "-_.+".contains(c);
        let place = format!("{key}.name");
        if name.is_empty() || name.len() > LONGEST_NAME || !name.chars().all(plain) {
            return Err(self.refuse.conflict(
                &place,
                format!("'{name}' is no name of a state, which is a part of file names"),
                format!("take letters, digits, '-', '_', '+' and '.', {LONGEST_NAME} at most"),
            ));
        }
        if before.iter().any(|state| state.name == name) {
            return Err(self.refuse.conflict(
                &place,
                format!("there are two states '{name}'"),
                "give each state a name of its own",
            ));
        }
        Ok(())
    }

    fn source(&self, key: &str, ways: &Ways<'_>) -> Result<Source, SceneError> {
        match (ways.step, ways.table, ways.pictures, ways.lines) {
            (Some(step), None, None, None) => self.step(&format!("{key}.step"), step),
            (None, Some(table), None, None) => self.table(&format!("{key}.table"), table),
            (None, None, Some(pictures), None) => {
                self.pictures(&format!("{key}.pictures"), pictures)
            }
            (None, None, None, Some(lines)) => self.lines(&format!("{key}.lines"), lines),
            _ => Err(self.refuse.conflict(
                key,
                "exactly one of step, table, pictures and lines says where the data come from",
                "keep one, for example table = { file = \"up.csv\", scale = \"1 mm\", y_axis = \"up\" }",
            )),
        }
    }

    fn step(&self, key: &str, step: usize) -> Result<Source, SceneError> {
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
        let allowed = format!("from 1 to {steps}, the load steps of the scene");
        self.refuse
            .within(key, step, (1..=steps).contains(&step), &allowed)?;
        Ok(Source::Step(step - 1))
    }

    fn table(&self, key: &str, given: &TableFormat) -> Result<Source, SceneError> {
        let preset = match given.preset {
            PresetFormat::Plain => data::Format::plain(),
            PresetFormat::Dice => data::Format::dice(),
            PresetFormat::Mudic => data::Format::mudic(),
        };
        if preset.pixels && given.origin.is_none() {
            return Err(self.refuse.missing(
                key,
                "origin",
                "origin = [512, 384], the pixel at which the body's origin is seen",
            ));
        }
        let [line, order] = [&given.columns.line, &given.columns.order];
        if line.is_some() || order.is_some() {
            return Err(self.refuse.conflict(
                &format!("{key}.columns"),
                "'line' and 'order' are columns of fringe lines, not of displacements",
                "name x, y, u, v or flag",
            ));
        }
        let scale = self
            .refuse
            .positive(&format!("{key}.scale"), &given.scale)?;
        let displacement_scale = given
            .displacement_scale
            .as_ref()
            .map(|scale| {
                self.refuse
                    .positive(&format!("{key}.displacement_scale"), scale)
            })
            .transpose()?;
        let deviation = given
            .deviation
            .as_ref()
            .map(|deviation| self.refuse.positive(&format!("{key}.deviation"), deviation))
            .transpose()?;
        Ok(Source::Table(TableSource {
            file: self.folder.join(&given.file),
            format: renamed(preset, &given.columns),
            reading: Reading {
                scale: Some(scale),
                displacement_scale,
                y_axis: y_axis(given.y_axis),
                reversed: given.reversed,
                deviation: [0.0; 2],
            },
            origin: given.origin.unwrap_or_default(),
            deviation,
        }))
    }

    fn pictures(&self, key: &str, given: &PicturesFormat) -> Result<Source, SceneError> {
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
                return Err(self.refuse.out_of_range(&place, "[0, 0]", allowed));
            }
        }
        if let Some(dark) = given.dark {
            let place = format!("{key}.dark");
            let fits = (0.0..1.0).contains(&dark);
            self.refuse.within(
                &place,
                dark,
                fits,
                "at least 0 and less than 1, a part of full scale",
            )?;
        }
        Ok(Source::Pictures(PictureSource {
            files,
            pixel: self
                .refuse
                .positive(&format!("{key}.pixel"), &given.pixel)?,
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

    fn lines(&self, key: &str, given: &LinesFormat) -> Result<Source, SceneError> {
        self.needs_grating()?;
        let names = &given.columns;
        if names.u.is_some() || names.v.is_some() || names.flag.is_some() {
            return Err(self.refuse.conflict(
                &format!("{key}.columns"),
                "'u', 'v' and 'flag' are columns of displacements, not of fringe lines",
                "name line, x, y or order",
            ));
        }
        let scale = self
            .refuse
            .positive(&format!("{key}.scale"), &given.scale)?;
        let tolerance = match &given.tolerance {
            Some(tolerance) => self
                .refuse
                .not_negative(&format!("{key}.tolerance"), tolerance)?,
            None => f64::INFINITY,
        };
        let deviation = given.deviation.unwrap_or(QUARTER_FRINGE);
        self.refuse.within(
            &format!("{key}.deviation"),
            deviation,
            deviation > 0.0,
            "greater than 0, in fringes",
        )?;
        let column = |name: &Option<String>, default: &str| {
            name.clone().unwrap_or_else(|| default.to_owned())
        };
        let reading = |reversed: bool| LineReading {
            columns: [
                column(&names.line, "line"),
                column(&names.x, "x"),
                column(&names.y, "y"),
                column(&names.order, "order"),
            ],
            scale,
            y_axis: y_axis(given.y_axis),
            reversed,
            tolerance,
            track: match &given.track {
                TrackFormat::Straight => Track::Straight,
                TrackFormat::Drawn => Track::Drawn,
                TrackFormat::Circle(circle) => Track::Circle {
                    centre: place(&circle.centre),
                    closed: circle.closed,
                },
            },
            tracks: BTreeMap::new(),
        };
        Ok(Source::Lines(LineSource {
            files: [self.folder.join(&given.u), self.folder.join(&given.v)],
            reading: given.reversed.map(reading),
            deviation,
        }))
    }

    /// Kinds of data that cannot be subtracted from each other; and pictures whose carrier nothing tells.
    fn check_null(
        &self,
        key: &str,
        source: &Source,
        null: Option<&Source>,
    ) -> Result<(), SceneError> {
        let is_lines = |source: &Source| matches!(source, Source::Lines(_));
        if null.is_some_and(|null| is_lines(null) != is_lines(source)) {
            return Err(self.refuse.conflict(
                &format!("{key}.null"),
                "fringe lines and full fields cannot be subtracted from each other",
                "give the null field in the same form as the state",
            ));
        }
        if let (Source::Pictures(pictures), None) = (source, null)
            && pictures.carrier.is_none()
            && pictures.files.iter().any(|files| files.len() == 1)
        {
            return Err(self.refuse.conflict(
                &format!("{key}.pictures"),
                "nothing tells the carrier's part of the fringes from the plate's mean strain",
                "give the carrier = { u = [\"12 1/mm\", \"0 1/mm\"], v = [\"0 1/mm\", \"12 1/mm\"] }, or null = { pictures = … } of the \
                 initial load with the same carrier",
            ));
        }
        Ok(())
    }

    fn needs_grating(&self) -> Result<(), SceneError> {
        match self.grating {
            Some(_) => Ok(()),
            None => {
                let example = "[grating] frequency = \"2400 1/mm\"";
                Err(self.refuse.missing("", "grating", example))
            }
        }
    }
}

fn y_axis(given: AxisFormat) -> YAxis {
    match given {
        AxisFormat::Up => YAxis::Up,
        AxisFormat::Down => YAxis::Down,
    }
}

/// A load below that of the state before is falling.
fn falling(before: &[State], load: Option<f64>) -> Direction {
    match (before.last().and_then(|state| state.load), load) {
        (Some(before), Some(load)) if load < before => Direction::Unloading,
        _ => Direction::Loading,
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
