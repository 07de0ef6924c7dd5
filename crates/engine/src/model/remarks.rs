//! What a reader must know of a scene's geometry before it is solved.

use super::plan::{ContactPlan, Plan};
use crate::results::{ContactFinding, Finding, Quantity};

/// Clearance, as a part of the hole's radius, from which pairing points at equal angles is reported.
const WIDE_CLEARANCE: f64 = 0.1;

/// Findings on the scene as it stands.
pub(super) fn of_scene(plan: &Plan<'_>) -> Vec<Finding> {
    let of_contact = |contact: &ContactPlan<'_>| {
        let wide = contact.radii().and_then(wide);
        let found = wide.into_iter().chain(uneven(plan, contact));
        let found = found.map(|finding| Finding::about(&contact.of.name, finding));
        found.collect::<Vec<_>>()
    };
    plan.contacts.iter().flat_map(of_contact).collect()
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

/// Circles of very different radius touch along a part of each that is not equally long.
fn wide([hole, inner]: [f64; 2]) -> Option<ContactFinding> {
    let clearance = 1.0 - inner / hole;
    (clearance > WIDE_CLEARANCE).then_some(ContactFinding::WideClearance { clearance })
}
