//! Which contact of the scene is the joint, and which criterion calls its mode.

use super::Scene;
use crate::sweep::format::JointFormat;
use stickslip_scene::diagnostic::{SceneError, SceneProblem, nearest};
use stickslip_scene::document::{Document, Part};

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
    let problem = SceneProblem::Conflict {
        message: "the scene asks for failure.progressive, which a sweep does not follow".to_owned(),
        remedy: "delete failure.progressive from the scene, or run its cases one by one: `stickslip run` with --set".to_owned(),
    };
    Err(document.error(key, Part::Value, problem))
}

/// Index of the joint's contact.
pub(super) fn contact(
    scene: &Scene,
    given: &JointFormat,
    document: &Document,
) -> Result<usize, SceneError> {
    let known = || scene.contacts.iter().map(|contact| contact.name.clone());
    let Some(name) = &given.contact else {
        return match scene.contacts.len() {
            1 => Ok(0),
            count => {
                let remedy = if count == 0 {
                    "take a scene in which a pin touches the hole of a plate".to_owned()
                } else {
                    let names: Vec<String> = known().collect();
                    format!("add [joint] with contact = one of {}", names.join(", "))
                };
                let problem = SceneProblem::Conflict {
                    message: format!("the scene has {count} contacts, and a joint is one"),
                    remedy,
                };
                Err(document.error("scene", Part::Value, problem))
            }
        };
    };
    let found = scene
        .contacts
        .iter()
        .position(|contact| contact.name == *name);
    found.ok_or_else(|| {
        let known: Vec<String> = known().collect();
        let problem = SceneProblem::UnknownName {
            what: "a contact of the scene".to_owned(),
            found: name.clone(),
            nearest: nearest(name, known.iter().map(String::as_str)).map(str::to_owned),
            known,
        };
        document.error("joint.contact", Part::Value, problem)
    })
}

/// Criterion of the characteristic curve: the one named, Yamada and Sun's where the scene asks for it, or the scene's first.
pub(super) fn criterion(
    scene: &Scene,
    given: &JointFormat,
    document: &Document,
) -> Result<Option<String>, SceneError> {
    let asked = scene.failure.as_ref();
    let known: Vec<&str> = asked.map_or_else(Vec::new, |failure| {
        failure
            .criteria
            .iter()
            .map(|criterion| criterion.name())
            .collect()
    });
    if let Some(name) = &given.criterion {
        if known.contains(&name.as_str()) {
            return Ok(Some(name.clone()));
        }
        let problem = SceneProblem::UnknownName {
            what: "a criterion that the scene's [failure] asks for".to_owned(),
            found: name.clone(),
            nearest: nearest(name, known.iter().copied()).map(str::to_owned),
            known: known.into_iter().map(str::to_owned).collect(),
        };
        return Err(document.error("joint.criterion", Part::Value, problem));
    }
    if asked.is_none_or(|failure| failure.characteristic.is_none()) {
        return Ok(None);
    }
    let fibres = known.iter().find(|name| **name == "yamada_sun");
    Ok(fibres.or(known.first()).map(|name| (*name).to_owned()))
}
