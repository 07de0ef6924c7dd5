//! Quantities in scenes as JSON: written in base units, read, and changed everywhere by their unit.

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
