//! States and where their data come from.

mod sources;

use std::path::Path;

use stickslip_hybrid::moire::Grating;

use super::refuse::Refuse;
use crate::format::{
    ForceFormat, LinesFormat, PicturesFormat, SourceFormat, StateFormat, TableFormat,
};
use crate::history::History;
use crate::{Direction, Fringes, Source, Specimen, State};
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::units::Quantity;

/// Longest name of a state, which is a part of file names.
const LONGEST_NAME: usize = 64;
/// A load and that of its step may differ by this part, for one of them may be rounded in another unit.
const ROUNDED: f64 = 5e-3;

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
            states.push(self.state(&key, state, &states, history.as_ref())?);
        }
        Ok(states)
    }

    /// One state; `before` are those that come before it.
    fn state(
        &self,
        key: &str,
        given: &StateFormat,
        before: &[State],
        history: Option<&History<'_>>,
    ) -> Result<State, SceneError> {
        self.check_name(key, &given.name, before)?;
        let ways = Ways {
            step: given.step,
            table: given.table.as_ref(),
            pictures: given.pictures.as_ref(),
            lines: given.lines.as_ref(),
        };
        let source = self.source(key, &ways)?;
        let other = |name: &str, given: &Option<SourceFormat>| {
            let given = given.as_ref();
            given
                .map(|given| self.source(&format!("{key}.{name}"), &given.into()))
                .transpose()
        };
        let (null, back) = (other("null", &given.null)?, other("back", &given.back)?);
        self.check_null(key, &source, null.as_ref())?;
        let own_step = match (&source, history) {
            (Source::Step(step), Some(history)) => Some((*step, history)),
            _ => None,
        };
        let load = self.load(key, given, own_step)?;
        let direction = self.direction(key, given, own_step)?;
        Ok(State {
            name: given.name.clone(),
            direction: direction.unwrap_or_else(|| falling(before, load)),
            load,
            edge_force: self.edge_force(key, given.edge_force.as_ref())?,
            source,
            null,
            back,
        })
    }

    /// The load `[N]`: that stated or that of the load step, which must not differ.
    fn load(
        &self,
        key: &str,
        state: &StateFormat,
        own_step: Option<(usize, &History<'_>)>,
    ) -> Result<Option<f64>, SceneError> {
        let own = own_step.and_then(|(step, history)| Some((step, history, history.load(step)?)));
        let Some(given) = &state.load else {
            return Ok(own.map(|(_, _, load)| load));
        };
        let load = given.value();
        let differs = |own: f64| (own - load).abs() > ROUNDED * own.abs().max(load.abs());
        match own {
            Some((step, history, own)) if differs(own) => Err(self.refuse.conflict(
                &format!("{key}.load"),
                format!(
                    "load is {}, and step {} of the scene has {}",
                    given.text(),
                    step + 1,
                    history.shown(own)
                ),
                "remove load, for that of the step holds; or name the step that has this load",
            )),
            _ => Ok(Some(load)),
        }
    }

    /// The direction that is stated or that of the load step, which must not differ; `None` where it follows from the loads.
    fn direction(
        &self,
        key: &str,
        state: &StateFormat,
        own_step: Option<(usize, &History<'_>)>,
    ) -> Result<Option<Direction>, SceneError> {
        let given = state.direction;
        let Some((step, own)) = own_step.map(|(step, history)| (step, history.direction(step)))
        else {
            return Ok(given);
        };
        match given {
            Some(given) if given != own => Err(self.refuse.conflict(
                &format!("{key}.direction"),
                format!(
                    "direction is {}, and step {} of the scene is reached in {}",
                    given.name(),
                    step + 1,
                    own.name()
                ),
                "remove direction, for that of the step holds; or name a step of this direction",
            )),
            _ => Ok(Some(own)),
        }
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
            let message = "edge_force names no component";
            let remedy = "write edge_force = { x = \"5516 N\" }, y in place of x or beside it; or leave edge_force out";
            return Err(self
                .refuse
                .conflict(&format!("{key}.edge_force"), message, remedy));
        }
        Ok(force)
    }

    fn check_name(&self, key: &str, name: &str, before: &[State]) -> Result<(), SceneError> {
        let plain = |c: char| c.is_alphanumeric() || "-_.+".contains(c);
        let place = format!("{key}.name");
        if name.is_empty() || name.len() > LONGEST_NAME || !name.chars().all(plain) {
            let message =
                format!("'{name}' is not a valid name of a state, which is a part of file names");
            let remedy =
                format!("take letters, digits, '-', '_', '+' and '.', {LONGEST_NAME} at most");
            return Err(self.refuse.conflict(&place, message, remedy));
        }
        if before.iter().any(|state| state.name == name) {
            let message = format!("there are two states '{name}'");
            let remedy = "give each state a name of its own";
            return Err(self.refuse.conflict(&place, message, remedy));
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
            let message = "fringe lines and full fields cannot be subtracted from each other";
            let remedy = "give the null field in the same form as the state";
            return Err(self
                .refuse
                .conflict(&format!("{key}.null"), message, remedy));
        }
        // Synthetic pictures of one step have different noise.
        if !source.is_synthetic() && null == Some(source) {
            let message =
                "the null field has the data of the state itself, and would leave nothing of it";
            let remedy = "name the files of the initial load, or remove null";
            return Err(self
                .refuse
                .conflict(&format!("{key}.null"), message, remedy));
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
