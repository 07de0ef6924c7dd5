//! States and where their data come from.

mod sources;

use std::path::Path;

use stickslip_hybrid::moire::Grating;

use super::read::Refuse;
use super::{Direction, Fringes, Source, Specimen, State};
use crate::diagnostic::SceneError;
use crate::experiment::format::{
    DirectionFormat, ForceFormat, LinesFormat, PicturesFormat, SourceFormat, StateFormat,
    TableFormat,
};
use crate::experiment::history::History;
use crate::units::Quantity;

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
                edge_force: self.edge_force(&key, state.edge_force.as_ref())?,
                source,
                null,
                back,
            });
        }
        Ok(states)
    }

    /// Known components of the force through the edge; a table of it must name one.
    fn edge_force(
        &self,
        key: &str,
        given: Option<&ForceFormat>,
    ) -> Result<[Option<f64>; 2], SceneError> {
        let force = given.map_or([None; 2], |given| {
            [&given.x, &given.y].map(|force| force.as_ref().map(Quantity::value))
        });
        if given.is_some() && force == [None; 2] {
            return Err(self.refuse.conflict(
                &format!("{key}.edge_force"),
                "edge_force names no component",
                "write edge_force = { x = \"5516 N\" }, y in place of x or beside it; or leave edge_force out",
            ));
        }
        Ok(force)
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

    /// Kinds of data that cannot be subtracted from each other.
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
        Ok(())
    }
}

/// A load below that of the state before is falling.
fn falling(before: &[State], load: Option<f64>) -> Direction {
    match (before.last().and_then(|state| state.load), load) {
        (Some(before), Some(load)) if load < before => Direction::Unloading,
        _ => Direction::Loading,
    }
}
