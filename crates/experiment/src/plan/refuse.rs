//! Errors at keys of the file, and what is checked wherever it is given.

use std::fmt;

use crate::Area;
use crate::format::{MaskFormat, PlaceFormat};
use stickslip_scene::diagnostic::{SceneError, SceneProblem};
use stickslip_scene::document::{Document, Part};
use stickslip_scene::units::{PerLength, Quantity};

/// Makes errors at keys of the file.
#[derive(Clone, Copy)]
pub(super) struct Refuse<'a>(pub(super) &'a Document);

impl Refuse<'_> {
    pub(super) fn at(self, key: &str, problem: SceneProblem) -> SceneError {
        self.0.error(key, Part::Value, problem)
    }

    pub(super) fn conflict(
        self,
        key: &str,
        message: impl Into<String>,
        remedy: impl Into<String>,
    ) -> SceneError {
        self.at(key, SceneProblem::conflict(message, remedy))
    }

    /// A name of something that is not among the `known` ones.
    pub(super) fn undefined(
        self,
        what: &'static str,
        key: &str,
        name: &str,
        known: impl Iterator<Item = String>,
    ) -> SceneError {
        self.at(key, SceneProblem::undefined(what, name, known.collect()))
    }

    pub(super) fn missing(self, table: &str, key: &str, example: &str) -> SceneError {
        let problem = SceneProblem::MissingKey {
            key: key.to_owned(),
            table: if table.is_empty() {
                "the experiment".to_owned()
            } else {
                table.to_owned()
            },
            example: example.to_owned(),
        };
        self.0.error(table, Part::Key, problem)
    }

    pub(super) fn out_of_range(
        self,
        key: &str,
        value: &dyn fmt::Display,
        allowed: &str,
    ) -> SceneError {
        self.at(
            key,
            SceneProblem::out_of_range(key, &value.to_string(), allowed),
        )
    }

    /// Lower left and upper right corner.
    pub(super) fn window(
        self,
        key: &str,
        given: &[PlaceFormat; 2],
    ) -> Result<[[f64; 2]; 2], SceneError> {
        let [low, high] = [place(&given[0]), place(&given[1])];
        if low[0] < high[0] && low[1] < high[1] {
            return Ok([low, high]);
        }
        Err(self.conflict(
            key,
            "the window's first corner is not to the lower left of its second",
            "give the lower left and then the upper right corner",
        ))
    }

    pub(super) fn areas(self, key: &str, given: &[MaskFormat]) -> Result<Vec<Area>, SceneError> {
        let each = given.iter().enumerate();
        each.map(|(index, area)| self.area(&format!("{key}.{index}"), area))
            .collect()
    }

    fn area(self, key: &str, given: &MaskFormat) -> Result<Area, SceneError> {
        match (&given.centre, &given.radius, &given.window) {
            (Some(centre), Some(radius), None) => Ok(Area::Disc {
                centre: place(centre),
                radius: radius.value(),
            }),
            (None, None, Some(window)) => {
                Ok(Area::Window(self.window(&format!("{key}.window"), window)?))
            }
            _ => Err(self.conflict(
                key,
                "this is neither a disc nor a window",
                "give { centre = [\"0 mm\", \"0 mm\"], radius = \"1 mm\" } or { window = [[\"0 mm\", \"0 mm\"], [\"1 mm\", \"1 mm\"]] }",
            )),
        }
    }
}

/// A place in base units.
pub(super) fn place(given: &PlaceFormat) -> [f64; 2] {
    [given[0].value(), given[1].value()]
}

/// A gradient of orders in base units.
pub(super) fn gradient(given: &[Quantity<PerLength>; 2]) -> [f64; 2] {
    [given[0].value(), given[1].value()]
}
