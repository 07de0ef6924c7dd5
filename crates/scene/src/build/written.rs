//! A scene written with all its defaults, and its hash.

use std::collections::BTreeMap;

use serde_json::Value;

use crate::diagnostic::{SceneError, SceneProblem};
use crate::digest::sha256;
use crate::document::{Document, Part};
use crate::format::SceneFormat;
use crate::schema::{Body, Load, LoadKind};
use crate::units::{Dimension, Expected, parse};

pub(super) fn resolved(document: &Document, spelled: &SceneFormat) -> Result<String, SceneError> {
    toml::to_string(spelled).map_err(|error| {
        let message = format!("the scene cannot be written as TOML: {error}");
        document.error("", Part::Key, SceneProblem::Refused { message })
    })
}

pub(super) fn hash(
    spelled: &SceneFormat,
    bodies: &BTreeMap<String, Body>,
    loads: &[Load],
) -> String {
    // Serialising plain structs with text keys does not fail; a scene without a hash would be no error either.
    let value = serde_json::to_value(spelled).unwrap_or_default();
    let mut bytes = canonical(value).to_string().into_bytes();
    for load in loads {
        if let LoadKind::PolarTraction { table, .. } = &load.kind {
            let numbers = table.theta.iter().chain(&table.radial).chain(&table.shear);
            bytes.extend(numbers.flat_map(|number| number.to_le_bytes()));
        }
    }
    for body in bodies.values() {
        bytes.extend(body.shape.digest().unwrap_or_default().as_bytes());
    }
    sha256(bytes)
}

/// The value with every quantity in base units, without keys that are not given.
fn canonical(value: Value) -> Value {
    match value {
        Value::String(text) => match parse(&text, &Expected::any(&Dimension::ALL)) {
            Ok((number, dimension)) => {
                Value::String(format!("{number:e} {}", dimension.base_unit()))
            }
            Err(_) => Value::String(text),
        },
        Value::Array(list) => list.into_iter().map(canonical).collect(),
        Value::Object(map) => Value::Object(
            map.into_iter()
                .filter(|(_, value)| !value.is_null())
                .map(|(key, value)| (key, canonical(value)))
                .collect(),
        ),
        other => other,
    }
}
