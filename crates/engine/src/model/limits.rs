//! What a scene can say and this model cannot do: refused by name rather than left out.

use super::ModelError;
use super::plan::{Placed, Plan};
use stickslip_scene::schema::{Hold, LoadKind, SetRef};
use stickslip_scene::shape::Role;

/// Refuses what the model would otherwise ignore.
pub(super) fn check(plan: &Plan<'_>) -> Result<(), ModelError> {
    rigid_bodies(plan)?;
    held_holes(plan)?;
    let mut edges = plan.edges.iter().enumerate();
    edges.try_for_each(|(index, edge)| reported(plan, index, edge))
}

fn refuse(key: String, what: String) -> Result<(), ModelError> {
    Err(ModelError::Unsupported { key, what })
}

fn rigid_bodies(plan: &Plan<'_>) -> Result<(), ModelError> {
    let name = |body: usize| plan.bodies[body].name;
    for support in &plan.supports {
        let skew = matches!(support.of.hold, Hold::Direction(_));
        if plan.is_rigid(support.body) && (skew || support.of.displacement != 0.0) {
            let what = format!(
                "the rigid body '{}' can be held along x and y only, without displacement; give it an elastic material, or load it by a force",
                name(support.body)
            );
            return refuse(format!("supports.{}", support.of.index), what);
        }
    }
    for (index, load) in plan.loads.iter().enumerate() {
        let is_force = matches!(load.of.kind, LoadKind::Force { .. });
        if !is_force && plan.is_rigid(load.body) {
            let what = format!(
                "the rigid body '{}' takes forces only, not load '{}'",
                name(load.body),
                load.of.name
            );
            return refuse(format!("loads.{index}"), what);
        }
    }
    let mut platens = plan.platens.iter();
    match platens.position(|platen| plan.is_rigid(platen.body)) {
        Some(index) => refuse(
            format!("platens.{index}"),
            "a rigid body needs no platen".into(),
        ),
        None => Ok(()),
    }
}

/// An assumed pressure and a pin do not share a hole.
fn held_holes(plan: &Plan<'_>) -> Result<(), ModelError> {
    for (index, load) in plan.loads.iter().enumerate() {
        let LoadKind::Bearing { on, .. } = &load.of.kind else {
            continue;
        };
        let mut contacts = plan.contacts.iter().map(|contact| contact.of);
        if let Some(contact) = contacts.find(|contact| contact.first == *on) {
            let what = format!(
                "{on} is held by {} in contact '{}', and the bearing load '{}' stands for a pin; keep one of the two",
                contact.second, contact.name, load.of.name
            );
            return refuse(format!("loads.{index}"), what);
        }
    }
    Ok(())
}

fn reported(plan: &Plan<'_>, index: usize, edge: &Placed<'_, SetRef>) -> Result<(), ModelError> {
    let (key, on) = (format!("edges.{index}"), edge.of);
    let mut contacts = plan.contacts.iter().map(|contact| contact.of);
    if let Some(contact) = contacts.find(|contact| contact.second == *on) {
        let what = format!(
            "{on} is the second edge of contact '{}', whose tractions are reported on {}",
            contact.name, contact.first
        );
        return refuse(key, what);
    }
    let is_open = edge.edge.as_ref().is_some_and(|own| own.role == Role::Free);
    let mut contacts = plan.contacts.iter().map(|contact| contact.of);
    if let Some(contact) = contacts.find(|contact| is_open && contact.first == *on) {
        let what = format!(
            "contact '{}' reports the part of {on} that faces {}; remove this entry, or give the rest of the edge a name of its own and report that",
            contact.name, contact.second
        );
        return refuse(key, what);
    }
    if plan.is_rigid(edge.body) {
        let what = format!("{on} belongs to a rigid body, which has no stresses");
        return refuse(key, what);
    }
    let has_axis = plan.bodies[edge.body].shape.mirror().is_some();
    let own = edge.edge.as_ref().filter(|own| !own.is_reportable());
    if own.is_some_and(|_| has_axis) {
        let what = format!(
            "{on} does not run along x; of a shape with an axis circles and edges along x are reported; draw the body as shape.outline"
        );
        return refuse(key, what);
    }
    if own.is_some_and(|own| own.curve.path().is_none()) {
        let what = format!(
            "{on} is neither a circle nor an open edge of known lines, arcs and splines; give its parts names of their own"
        );
        return refuse(key, what);
    }
    Ok(())
}
