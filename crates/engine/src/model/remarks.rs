//! What a reader must know of a scene's geometry before it is solved.

use stickslip_scene::schema::{Load, LoadKind, SetRef};

use super::plan::{ContactPlan, Placed, Plan};
use crate::results::{ContactFinding, Finding, Quantity};

/// Clearance, as a part of the hole's radius, from which pairing points at equal angles is reported.
const WIDE_CLEARANCE: f64 = 0.1;
/// Part of the hole's radius by which coordinates of files are rounded.
const NOWHERE: f64 = 1e-4;

/// Findings on the scene as it stands.
pub(super) fn of_scene(plan: &Plan<'_>) -> Vec<Finding> {
    let of_contact = |contact: &ContactPlan<'_>| {
        let wide = contact.radii().and_then(wide);
        let found = wide.into_iter().chain(fitted(plan, contact));
        let found = found.chain(uneven(plan, contact));
        let found = found.map(|finding| Finding::about(&contact.of.name, finding));
        found.collect::<Vec<_>>()
    };
    let of_file = plan.bodies.iter().filter_map(|body| {
        let notes = body.shape.notes().to_vec();
        let body = body.name.to_owned();
        (!notes.is_empty()).then_some(Finding::MeshFile { body, notes })
    });
    let contacts = plan.contacts.iter().flat_map(of_contact);
    contacts
        .chain(of_file)
        .chain(plan.contacts.iter().filter_map(|own| carried(plan, own)))
        .chain(loaded_at_points(plan))
        .collect()
}

/// A second body whose coordinates put it somewhere else than in the hole that holds it: farther from the middle than its clearance.
fn carried(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<Finding> {
    let body = &plan.bodies[contact.sides[1].body];
    let [hole, inner] = contact.radii().filter(|_| body.shape.is_placed())?;
    let distance = body.centre[0].hypot(body.centre[1]);
    (distance > 2.0 * (hole - inner).abs() + NOWHERE * hole).then(|| Finding::MovedIntoHole {
        body: body.name.to_owned(),
        hole: contact.of.first.to_string(),
        distance: Quantity::Length(distance),
    })
}

/// Elastic bodies that a force acts on at a point.
fn loaded_at_points(plan: &Plan<'_>) -> Option<Finding> {
    let at_point = |load: &&Placed<'_, Load>| {
        let body = &plan.bodies[load.body];
        let is_point = matches!(&load.of.kind, LoadKind::Force { on, .. }
            if load.edge.is_none() && !body.shape.is_area(&on.set));
        is_point && body.elastic.is_some()
    };
    let loads = plan.loads.iter().filter(at_point);
    let loads: Vec<String> = loads.map(|load| load.of.name.clone()).collect();
    (!loads.is_empty()).then_some(Finding::PointLoads { loads })
}

/// Bodies of different thickness press on each other over the first one's.
fn uneven(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Option<ContactFinding> {
    let bodies = [0, 1].map(|side| &plan.bodies[contact.sides[side].body]);
    let first = bodies[0].elastic?.thickness;
    let second = bodies[1].elastic?.thickness;
    let apart = (first - second).abs();
    (apart > 1e-9 * first).then(|| ContactFinding::UnequalThickness {
        bodies: bodies.map(|body| body.name.to_owned()),
        thickness: [first, second].map(Quantity::Length),
    })
}

/// Circles whose radius is only that of the best one through nodes that are off it, or is another one than theirs.
fn fitted(plan: &Plan<'_>, contact: &ContactPlan<'_>) -> Vec<ContactFinding> {
    let Some([hole, inner]) = contact.radii() else {
        return Vec::new();
    };
    let clearance = hole - inner;
    let of_side = |side: &Placed<'_, SetRef>| {
        let fit = plan.bodies[side.body].shape.fit(&side.of.set)?;
        let edge = side.of.to_string();
        let scatter = if fit.counts(fit.scatter, 0.0) {
            fit.scatter
        } else {
            0.0
        };
        let off = Quantity::Length(scatter);
        match fit.given {
            None => fit
                .counts(scatter, clearance)
                .then_some(ContactFinding::FittedRadius {
                    edge,
                    off,
                    clearance: Quantity::Length(clearance),
                }),
            Some(given) => {
                let apart = (given - fit.fitted).abs();
                let is_other = apart > scatter && fit.counts(apart, clearance);
                is_other.then_some(ContactFinding::OtherRadius {
                    edge,
                    given: Quantity::Length(given),
                    fitted: Quantity::Length(fit.fitted),
                    off,
                })
            }
        }
    };
    contact.sides.iter().filter_map(of_side).collect()
}

/// Circles of very different radius touch along a part of each that is not equally long.
fn wide([hole, inner]: [f64; 2]) -> Option<ContactFinding> {
    let clearance = 1.0 - inner / hole;
    (clearance > WIDE_CLEARANCE).then_some(ContactFinding::WideClearance { clearance })
}
