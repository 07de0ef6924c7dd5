//! `[[laws]]`: friction laws to fit, in the grammar of scenes.

use serde_json::Value;

use super::refuse::Refuse;
use crate::format::LawFormat;
use crate::{Candidate, FreeParameter, LawPlan, Specimen};
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::document::child;
use stickslip_scene::open::law as read_law;
use stickslip_scene::schema::Material;
use stickslip_scene::units::{Dimension, Expected, parse};

pub(super) fn read(
    refuse: Refuse<'_>,
    given: &[LawFormat],
    specimen: &Specimen,
) -> Result<Vec<LawPlan>, SceneError> {
    let mut laws: Vec<LawPlan> = Vec::new();
    for (index, law) in given.iter().enumerate() {
        let table = format!("laws.{index}");
        let key = child(&table, "friction");
        let plies = match &specimen.material {
            Material::Laminate(sheet) => Some(sheet.ply_fractions()),
            _ => None,
        };
        let read = read_law(refuse.0, &key, &law.friction, plies)
            .map_err(|finding| SceneError::new(*finding, []))?;
        let kind = law.friction.as_object().and_then(|map| map.keys().next());
        let name = law
            .name
            .clone()
            .or_else(|| kind.cloned())
            .unwrap_or_default();
        if laws.iter().any(|other| other.name == name) {
            let message = format!("there are two laws '{name}'");
            let remedy = "give each a name of its own: name = \"…\"";
            return Err(refuse.conflict(&table, message, remedy));
        }
        let mut free = Vec::new();
        for (parameter, bounds) in &law.free {
            let place = format!("{table}.free.{parameter}");
            for (end, value) in bounds.iter().enumerate() {
                Candidate::check_end(read.as_ref(), parameter, value)
                    .map_err(|problem| refuse.at(&format!("{place}.{end}"), *problem))?;
            }
            let [low, high] = [0, 1].map(|k| number(&bounds[k]));
            match (low, high) {
                (Some(low), Some(high)) if low < high => free.push(FreeParameter {
                    name: parameter.clone(),
                    bounds: [low, high],
                }),
                _ => {
                    let message = format!("'{parameter}' is free without a valid range");
                    let remedy = "give the least and the greatest value, with units where the parameter has one: [0.0, 1.0]";
                    return Err(refuse.conflict(&place, message, remedy));
                }
            }
        }
        laws.push(LawPlan {
            name,
            key,
            friction: law.friction.clone(),
            law: read,
            free,
        });
    }
    Ok(laws)
}

/// A number, or a quantity in base units.
fn number(value: &Value) -> Option<f64> {
    match value {
        Value::Number(number) => number.as_f64(),
        Value::String(text) => parse(text, &Expected::any(&Dimension::ALL))
            .ok()
            .map(|(value, _)| value),
        _ => None,
    }
}
