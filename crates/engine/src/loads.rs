//! The loads of a history in display units, and what they act on.

use std::collections::BTreeSet;

use crate::model::{self, Model};
use crate::results::{LoadValue, ResultPart};
use stickslip_scene::Scene;
use stickslip_scene::schema::{Hold, Load, LoadKind, Ramp, Substance};

/// The loads at the end of the step `step`.
pub(crate) fn at_step(scene: &Scene, step: usize) -> Vec<LoadValue> {
    scene
        .loads
        .iter()
        .map(|load| {
            let value = load.kind.steps().get(step).copied().unwrap_or(0.0);
            shown_load(scene, load, value)
        })
        .collect()
}

/// The independent parts of `model`, with the loads of `scene` that act on each.
pub(crate) fn parts(scene: &Scene, model: &Model) -> Vec<ResultPart> {
    let groups = model::parts(model).into_iter();
    let part = |group: stickslip_contact::interface::Group| {
        let edges = model.edges.iter().enumerate();
        let own_edges = edges.filter(|(_, edge)| match edge.pair {
            Some(pair) => group.pairs.contains(&pair),
            None => group.bodies.contains(&edge.body),
        });
        let own_loads = scene.loads.iter().enumerate().filter(|(_, load)| {
            let named = |&&body: &&usize| model.bodies[body].name == load.kind.body();
            group.bodies.iter().any(|body| named(&body))
        });
        ResultPart {
            edges: own_edges.map(|(index, _)| index).collect(),
            loads: own_loads.map(|(index, _)| index).collect(),
            bodies: group.bodies,
        }
    };
    groups.map(part).collect()
}

/// Names of the bodies in the independent part of `scene` that holds its contact with the index `contact`, before there is a model.
pub(crate) fn linked_by(scene: &Scene, contact: usize) -> BTreeSet<&str> {
    let pairs: Vec<[&str; 2]> = (scene.contacts.iter())
        .map(|contact| [&contact.first.body, &contact.second.body].map(String::as_str))
        .collect();
    let mut linked: BTreeSet<&str> = pairs.get(contact).into_iter().flatten().copied().collect();
    loop {
        let passes = |name: &&str| linked.contains(*name) && !is_held(scene, name);
        let reached = pairs.iter().filter(|ends| ends.iter().any(passes));
        let further: BTreeSet<&str> = reached.flatten().copied().collect();
        if further.is_subset(&linked) {
            return linked;
        }
        linked.extend(further);
    }
}

/// Whether `body` is rigid and held along both axes, so that nothing acts on one contact through it to another.
fn is_held(scene: &Scene, body: &str) -> bool {
    let rigid = (scene.bodies.get(body)).is_some_and(|body| body.substance == Substance::Rigid);
    let own = scene.supports.iter().filter(|held| held.on.body == body);
    let held = own.fold([false; 2], |held, support| match support.hold {
        Hold::Axes(axes) => [held[0] || axes.x, held[1] || axes.y],
        Hold::Direction(_) => [true; 2],
    });
    rigid && held == [true; 2]
}

/// The value of a load in display units.
fn shown_load(scene: &Scene, load: &Load, value: f64) -> LoadValue {
    let display = &scene.display;
    let (value, unit) = match load.kind {
        LoadKind::Force { .. } | LoadKind::Bearing { .. } => {
            (display.force.from_base(value), display.force.name)
        }
        LoadKind::Pressure { .. } => (display.stress.from_base(value), display.stress.name),
        LoadKind::PolarTraction { .. } => (value, "1"),
        LoadKind::Temperature { .. } => (value, "K"),
    };
    LoadValue {
        name: load.name.clone(),
        value,
        unit: unit.to_owned(),
    }
}

/// The loads where the history of `scene` came to an end, at the part `reached` of its step `step`.
pub fn loads_reached(scene: &Scene, step: usize, reached: f64) -> Vec<LoadValue> {
    let quadratic = step == 0 && scene.analysis.ramp == Ramp::Quadratic;
    let part = if quadratic {
        reached * reached
    } else {
        reached
    };
    let value = |load: &Load| {
        let at = |step: Option<usize>| step.and_then(|step| load.kind.steps().get(step).copied());
        let from = at(step.checked_sub(1)).unwrap_or(0.0);
        let to = at(Some(step)).unwrap_or(0.0);
        shown_load(scene, load, from + part * (to - from))
    };
    scene.loads.iter().map(value).collect()
}
