//! What a reader must know of a scene's geometry and mesh before or after it is solved.

use stickslip_contact::zones::{Zone, ends_of_contact};

use crate::results::{ContactFinding, EdgeGeometry, EdgeKind, Finding, Quantity, wrapped};
use stickslip_scene::Scene;
use stickslip_scene::placement::radii;
use stickslip_scene::schema::{Contact, Division, Substance};

/// Clearance, as a part of the hole's radius, from which pairing points at equal angles is reported.
const WIDE_CLEARANCE: f64 = 0.1;

/// Findings on the scene as it stands.
pub(super) fn of_scene(scene: &Scene) -> Vec<Finding> {
    let contacts = scene.contacts.iter();
    let of_contact = |contact: &Contact| {
        let wide = radii(scene, contact).and_then(wide);
        let found = wide.into_iter().chain(uneven(scene, contact));
        let found = found.map(|finding| Finding::about(&contact.name, finding));
        found.collect::<Vec<_>>()
    };
    contacts.flat_map(of_contact).collect()
}

/// Bodies of different thickness press on each other over the first one's.
fn uneven(scene: &Scene, contact: &Contact) -> Option<ContactFinding> {
    let thickness = |body: &str| match scene.bodies.get(body)?.substance {
        Substance::Elastic { thickness, .. } => Some(thickness),
        Substance::Rigid => None,
    };
    let first = thickness(&contact.first.body)?;
    let second = thickness(&contact.second.body)?;
    (first != second).then(|| ContactFinding::UnequalThickness {
        bodies: [&contact.first, &contact.second].map(|edge| edge.body.clone()),
        thickness: [first, second].map(Quantity::Length),
    })
}

/// Circles of very different radius touch along a part of each that is not equally long.
fn wide([hole, inner]: [f64; 2]) -> Option<ContactFinding> {
    let clearance = 1.0 - inner / hole;
    (clearance > WIDE_CLEARANCE).then_some(ContactFinding::WideClearance { clearance })
}

/// The farthest end of contact on `edge` in any load step, if it lies beyond the mesh's fine zone; `steps` holds the contact's zones for
/// each step. Contact all around has no end, and a mesh of equal spacing no limit.
pub(crate) fn beyond_fine_zone(
    scene: &Scene,
    edge: &EdgeGeometry,
    steps: &[&[Zone]],
) -> Option<Finding> {
    let (Division::Angular(grading) | Division::Linear(grading)) =
        scene.mesh_of(&edge.body).division
    else {
        return None;
    };
    // Where the equal spacing ends: an angle [rad] or a length [mm].
    let shape = scene.bodies.get(&edge.body)?.shape;
    let limit = shape.fine_to(grading.fine_to)?;
    let place = |end: f64| match edge.kind {
        EdgeKind::Circle { .. } => wrapped(end),
        EdgeKind::Line => end,
    };
    let ends = |zones: &[Zone]| -> Vec<f64> {
        let ends = ends_of_contact(zones, edge.closed());
        ends.into_iter().map(place).collect()
    };
    let farther = |a: &f64, b: &f64| a.abs().total_cmp(&b.abs());
    let farthest = |zones: &&[Zone]| ends(zones).into_iter().max_by(farther);
    let by_step = steps.iter().map(farthest).enumerate();
    let (step, end) = by_step
        .filter_map(|(step, end)| Some((step, end?)))
        .max_by(|a, b| farther(&a.1, &b.1).then(b.0.cmp(&a.0)))?;
    // An end on the limit to rounding is not beyond it.
    if end.abs() <= limit * (1.0 + 1e-9) {
        return None;
    }
    let both_ends = ends(steps[step])
        .iter()
        .any(|other| (other + end).abs() <= 1e-6 * end.abs());
    let quantity = match edge.kind {
        EdgeKind::Circle { .. } => Quantity::Angle,
        EdgeKind::Line => Quantity::Length,
    };
    let found = ContactFinding::BeyondFineMesh {
        step: step + 1,
        end: quantity(end),
        both_ends,
        limit: quantity(limit),
    };
    Some(Finding::about(&edge.name, found))
}
