//! What a scene can say and this model cannot do: refused by name rather than left out.

use super::ModelError;
use stickslip_scene::Scene;
use stickslip_scene::schema::{Hold, LoadKind, SetRef, Substance};

/// Refuses what the model would otherwise ignore.
pub(super) fn check(scene: &Scene) -> Result<(), ModelError> {
    rigid_bodies(scene)?;
    held_holes(scene)?;
    scene
        .edges
        .iter()
        .enumerate()
        .try_for_each(|(index, edge)| reported(scene, index, edge))
}

fn refuse(key: String, what: String) -> Result<(), ModelError> {
    Err(ModelError::Unsupported { key, what })
}

fn is_rigid(scene: &Scene, body: &str) -> bool {
    scene
        .bodies
        .get(body)
        .is_some_and(|body| body.substance == Substance::Rigid)
}

fn rigid_bodies(scene: &Scene) -> Result<(), ModelError> {
    for (index, support) in scene.supports.iter().enumerate() {
        let skew = matches!(support.hold, Hold::Direction(_));
        if is_rigid(scene, &support.on.body) && (skew || support.displacement != 0.0) {
            let what = format!(
                "the rigid body '{}' can be held along x and y only, without displacement; give it an elastic material, or load it by a force",
                support.on.body
            );
            return refuse(format!("supports.{index}"), what);
        }
    }
    for (index, load) in scene.loads.iter().enumerate() {
        let body = match &load.kind {
            LoadKind::Force { .. } => continue,
            LoadKind::Bearing { on, .. }
            | LoadKind::Pressure { on, .. }
            | LoadKind::PolarTraction { on, .. } => &on.body,
            LoadKind::Temperature { body, .. } => body,
        };
        if is_rigid(scene, body) {
            let what = format!(
                "the rigid body '{body}' takes forces only, not load '{}'",
                load.name
            );
            return refuse(format!("loads.{index}"), what);
        }
    }
    let platen = scene
        .platens
        .iter()
        .position(|platen| is_rigid(scene, &platen.on.body));
    match platen {
        Some(index) => refuse(
            format!("platens.{index}"),
            "a rigid body needs no platen".into(),
        ),
        None => Ok(()),
    }
}

/// An assumed pressure and a pin do not share a hole.
fn held_holes(scene: &Scene) -> Result<(), ModelError> {
    for (index, load) in scene.loads.iter().enumerate() {
        let LoadKind::Bearing { on, .. } = &load.kind else {
            continue;
        };
        let mut contacts = scene.contacts.iter();
        if let Some(contact) = contacts.find(|contact| contact.first == *on) {
            let what = format!(
                "{on} is held by {} in contact '{}', and the bearing load '{}' stands for a pin; keep one of the two",
                contact.second, contact.name, load.name
            );
            return refuse(format!("loads.{index}"), what);
        }
    }
    Ok(())
}

fn reported(scene: &Scene, index: usize, edge: &SetRef) -> Result<(), ModelError> {
    let key = format!("edges.{index}");
    if let Some(contact) = scene
        .contacts
        .iter()
        .find(|contact| contact.second == *edge)
    {
        let what = format!(
            "{edge} is the second edge of contact '{}', whose tractions are reported on {}",
            contact.name, contact.first
        );
        return refuse(key, what);
    }
    if is_rigid(scene, &edge.body) {
        return refuse(
            key,
            format!("{edge} belongs to a rigid body, which has no stresses"),
        );
    }
    let shape = scene.bodies.get(&edge.body).map(|body| body.shape);
    let own = shape.and_then(|shape| shape.edge(&edge.set));
    if own.is_some_and(|own| own.level(0).is_some()) {
        return refuse(
            key,
            format!("{edge} runs along y; only circles and edges along x are reported"),
        );
    }
    Ok(())
}
