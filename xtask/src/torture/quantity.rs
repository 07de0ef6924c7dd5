//! Quantities in scenes as JSON: written in base units, read, and changed everywhere by their unit.

use std::fmt::Display;

use serde_json::Value;

/// `value` in mm.
pub(super) fn mm(value: f64) -> Value {
    text(value, "mm")
}

/// `value` in MPa.
pub(super) fn mpa(value: f64) -> Value {
    text(value, "MPa")
}

/// `value` in degrees.
pub(super) fn deg(value: f64) -> Value {
    text(value, "deg")
}

/// `value` with `unit`.
pub(super) fn text(value: f64, unit: &str) -> Value {
    Value::String(spelled(value, unit))
}

fn spelled(value: f64, unit: &str) -> String {
    if value == 0.0 || (1e-4..1e7).contains(&value.abs()) {
        format!("{value} {unit}")
    } else {
        format!("{value:e} {unit}")
    }
}

/// Number and unit of a quantity; `None` for any other text.
pub(super) fn split(text: &str) -> Option<(f64, &str)> {
    let (number, unit) = text.split_once(' ')?;
    let known = ["mm", "N", "MPa", "deg", "K", "1/K", "kJ/m2"];
    let unit = known.contains(&unit).then_some(unit)?;
    Some((number.parse().ok()?, unit))
}

/// Number of the quantity at `pointer`, in its unit.
pub(super) fn number(scene: &Value, pointer: &str) -> Option<f64> {
    split(scene.pointer(pointer)?.as_str()?).map(|(number, _)| number)
}

/// Replaces each quantity (number, unit) below `value` by what `change` makes of it.
pub(super) fn change(value: &mut Value, change_one: &dyn Fn(f64, &str) -> Option<Value>) {
    match value {
        Value::String(text) => {
            if let Some(changed) = split(text).and_then(|(number, unit)| change_one(number, unit)) {
                *value = changed;
            }
        }
        Value::Array(list) => list.iter_mut().for_each(|entry| change(entry, change_one)),
        Value::Object(map) => map.values_mut().for_each(|entry| change(entry, change_one)),
        Value::Null | Value::Bool(_) | Value::Number(_) => {}
    }
}

/// Entries of the list `name` of a scene.
pub(super) fn list<'a>(scene: &'a Value, name: &str) -> impl Iterator<Item = &'a Value> {
    scene
        .get(name)
        .and_then(Value::as_array)
        .into_iter()
        .flatten()
}

/// Entries of the list `name` of a scene, to be changed.
pub(super) fn list_mut<'a>(
    scene: &'a mut Value,
    name: &str,
) -> impl Iterator<Item = &'a mut Value> {
    let list = scene.get_mut(name).and_then(Value::as_array_mut);
    list.into_iter().flatten()
}

/// Names and entries of the table `name` of a scene.
pub(super) fn table<'a>(
    scene: &'a Value,
    name: &str,
) -> impl Iterator<Item = (&'a String, &'a Value)> {
    scene
        .get(name)
        .and_then(Value::as_object)
        .into_iter()
        .flatten()
}

/// Paths of everything in a value, outer ones first.
pub(super) fn paths(value: &Value) -> Vec<String> {
    fn walk(value: &Value, path: &str, found: &mut Vec<String>) {
        let mut below = |key: &dyn Display, entry: &Value| {
            let here = format!("{path}/{key}");
            found.push(here.clone());
            walk(entry, &here, found);
        };
        match value {
            Value::Object(map) => map.iter().for_each(|(key, entry)| below(key, entry)),
            Value::Array(list) => {
                (list.iter().enumerate()).for_each(|(index, entry)| below(&index, entry));
            }
            _ => {}
        }
    }
    let mut found = Vec::new();
    walk(value, "", &mut found);
    found
}

/// Paths of the histories of loads.
pub(super) fn histories(scene: &Value) -> Vec<String> {
    let mut found = paths(scene);
    found.retain(|path| path.starts_with("/loads/") && path.ends_with("/steps"));
    found
}

/// The scene with each history of loads changed.
pub(super) fn with_histories(scene: &Value, change: impl Fn(&mut Vec<Value>)) -> Value {
    let mut changed = scene.clone();
    for path in histories(scene) {
        let steps = changed.pointer_mut(&path).and_then(Value::as_array_mut);
        steps.into_iter().for_each(&change);
    }
    changed
}
