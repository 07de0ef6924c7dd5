//! Which contact of the scene is the joint, and which criterion calls its mode.

use super::Scene;
use super::problem::{conflict, unknown};
use crate::sweep::format::JointFormat;
use stickslip_scene::diagnostic::SceneError;
use stickslip_scene::document::Document;

/// Refuses a scene whose joint would have to be followed: a sweep solves contact and asks plies, and follows no failure.
pub(super) fn follows_nothing(
    scene: &Scene,
    document: &Document,
    key: &str,
) -> Result<(), SceneError> {
    let asked = scene.failure.as_ref();
    if asked.is_none_or(|failure| failure.progressive.is_none()) {
        return Ok(());
    }
    Err(conflict(
        document,
        key,
        "the scene asks for failure.progressive, which a sweep does not follow",
        "delete failure.progressive from the scene, or run its cases one by one: `stickslip run` with --set",
    ))
}

/// Index of the joint's contact.
pub(super) fn contact(
    scene: &Scene,
    given: &JointFormat,
    document: &Document,
) -> Result<usize, SceneError> {
    let known: Vec<&str> = scene.contacts.iter().map(|own| own.name.as_str()).collect();
    if let Some(name) = &given.contact {
        let found = known.iter().position(|own| own == name);
        let what = "a contact of the scene";
        return found.ok_or_else(|| unknown(document, "joint.contact", what, name, known));
    }
    let remedy = match known.len() {
        1 => return Ok(0),
        0 => "take a scene in which a pin touches the hole of a plate".to_owned(),
        _ => format!("add [joint] with contact = one of {}", known.join(", ")),
    };
    let message = format!("the scene has {} contacts, and a joint is one", known.len());
    Err(conflict(document, "scene", message, remedy))
}

/// Criterion of the characteristic curve: the one named, else the scene's first of ultimate failure, else its first.
pub(super) fn criterion(
    scene: &Scene,
    given: &JointFormat,
    document: &Document,
) -> Result<Option<String>, SceneError> {
    let asked = scene.failure.as_ref();
    let criteria = || asked.iter().flat_map(|failure| &failure.criteria);
    let known: Vec<&str> = criteria().map(|criterion| criterion.name()).collect();
    if let Some(name) = &given.criterion {
        if known.contains(&name.as_str()) {
            return Ok(Some(name.clone()));
        }
        let what = "a criterion that the scene's [failure] asks for";
        return Err(unknown(document, "joint.criterion", what, name, known));
    }
    if asked.is_none_or(|failure| failure.characteristic.is_none()) {
        return Ok(None);
    }
    let ultimate = criteria().find(|criterion| criterion.is_ultimate());
    let chosen = ultimate.or_else(|| criteria().next());
    Ok(chosen.map(|criterion| criterion.name().to_owned()))
}
