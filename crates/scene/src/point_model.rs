//! Point models of a scene, with units.
//!
//! The registry of point models says which parameter is a stress, so each quantity becomes a number in base units and the model's
//! parameters read the rest. A model of another crate needs nothing else to be used in a scene.

use std::sync::Arc;

use serde_json::{Map, Value};
use stickslip_friction::LawInfo;
use stickslip_laminate::progressive::{PointModelParameters, point_models};

use super::document::{Document, Part, child};
use super::friction;
use super::read::described;
use crate::diagnostic::{Finding, LaminateProblem, SceneProblem, nearest};

/// Reads the table `table` that stands at `key`: the name of a model with its parameters.
pub(super) fn read(
    document: &Document,
    key: &str,
    table: &Value,
) -> Result<Arc<dyn PointModelParameters>, Box<Finding>> {
    let refused = |key: &str, part, problem| Box::new(document.finding(key, part, problem));
    let names = || point_models().map(|info| info.name);
    let wrong_kind = |key: &str, expected: &str, found: &Value| {
        let problem = SceneProblem::WrongKind {
            expected: expected.to_owned(),
            found: described(found),
        };
        refused(key, Part::Value, problem)
    };
    let Value::Object(map) = table else {
        let example =
            "a point model, for example { ply_discount = { fibre = 0.01, matrix = 0.1 } }";
        return Err(wrong_kind(key, example, table));
    };
    let mut entries = map.iter();
    let (Some((name, given)), None) = (entries.next(), entries.next()) else {
        let found: Vec<_> = map.keys().cloned().collect();
        let problem = SceneProblem::OneOf {
            table: key.to_owned(),
            choices: names().collect::<Vec<_>>().join(", "),
            found: if found.is_empty() {
                "none".to_owned()
            } else {
                found.join(", ")
            },
        };
        return Err(refused(key, Part::Key, problem));
    };
    let key = child(key, name);
    let Some(info) = point_models().find(|info| info.name == name) else {
        let problem = SceneProblem::UnknownName {
            what: "a point model".to_owned(),
            found: name.clone(),
            nearest: nearest(name, names()).map(str::to_owned),
            known: names().map(str::to_owned).collect(),
        };
        return Err(refused(&key, Part::Key, problem));
    };
    let Value::Object(given) = given else {
        return Err(wrong_kind(&key, "a table of the model's parameters", given));
    };
    let described_as = LawInfo {
        name: info.name,
        summary: info.summary,
        parameters: info.parameters,
    };
    let plain = friction::parameters(document, &key, &described_as, given)?;
    let tagged = Value::Object(Map::from_iter([(name.clone(), plain)]));
    let read: Result<Box<dyn PointModelParameters>, _> = serde_json::from_value(tagged);
    read.map(Arc::from).map_err(|error| {
        let message = error.to_string();
        // At the parameter that the message names, if there is one.
        let named = given
            .keys()
            .find(|name| message.contains(&format!("{name} = ")));
        let place = named.map_or_else(|| key.clone(), |name| child(&key, name));
        let model = name.clone();
        let problem = LaminateProblem::PointModel { model, message };
        refused(&place, Part::Value, problem.into())
    })
}
