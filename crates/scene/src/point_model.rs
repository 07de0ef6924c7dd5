//! Point models of a scene, with units.
//!
//! The registry of point models says which parameter is a stress, so each quantity becomes a number in base units and the model's
//! parameters read the rest. A model of another crate needs nothing else to be used in a scene.

use std::sync::Arc;

use serde_json::{Map, Value};
use stickslip_friction::LawInfo;
use stickslip_laminate::progressive::{PointModelParameters, point_models};

use super::document::{Document, Part, child};
use super::friction::{self, Choice};
use crate::diagnostic::{Finding, LaminateProblem};

/// Reads the table `table` that stands at `key`: the name of a model with its parameters.
pub(super) fn read(
    document: &Document,
    key: &str,
    table: &Value,
) -> Result<Arc<dyn PointModelParameters>, Box<Finding>> {
    let choice = Choice {
        what: "point model",
        owner: "model",
        example: "{ ply_discount = { fibre = 0.01, matrix = 0.1 } }",
        known: point_models().map(|info| (info.name, info)).collect(),
    };
    let (info, given) = choice.of(document, key, table)?;
    let key = child(key, info.name);
    let described_as = LawInfo {
        name: info.name,
        summary: info.summary,
        parameters: info.parameters,
    };
    let plain = friction::parameters(document, &key, &described_as, given)?;
    let tagged = Value::Object(Map::from_iter([(info.name.to_owned(), plain)]));
    let read: Result<Box<dyn PointModelParameters>, _> = serde_json::from_value(tagged);
    read.map(Arc::from).map_err(|error| {
        let message = error.to_string();
        // At the parameter that the message names, if there is one.
        let named = given
            .keys()
            .find(|name| message.contains(&format!("{name} = ")));
        let place = named.map_or_else(|| key.clone(), |name| child(&key, name));
        let model = info.name.to_owned();
        let problem = LaminateProblem::PointModel { model, message };
        Box::new(document.finding(&place, Part::Value, problem.into()))
    })
}
