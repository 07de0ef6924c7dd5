//! What a reader must know of a scene's geometry and mesh before or after it is solved.

use stickslip_contact::zones::{Zone, ends_of_contact};

use crate::results::{EdgeGeometry, EdgeKind, wrapped};
use stickslip_scene::Scene;
use stickslip_scene::placement::radii;
use stickslip_scene::schema::{Contact, Division, Substance};

/// Clearance, as a part of the hole's radius, from which pairing points at equal angles is told.
const WIDE_CLEARANCE: f64 = 0.1;

/// Remarks on the scene as it stands.
pub(super) fn of_scene(scene: &Scene) -> Vec<String> {
    let contacts = scene.contacts.iter();
    let of_contact = |contact| {
        let wide = radii(scene, contact).and_then(|radii| wide(contact, radii));
        wide.into_iter().chain(uneven(scene, contact))
    };
    contacts.flat_map(of_contact).collect()
}

/// Bodies of different thickness press on each other over the first one's.
fn uneven(scene: &Scene, contact: &Contact) -> Option<String> {
    let thickness = |body: &str| match scene.bodies.get(body)?.substance {
        Substance::Elastic { thickness, .. } => Some(thickness),
        Substance::Rigid => None,
    };
    let first = thickness(&contact.first.body)?;
    let second = thickness(&contact.second.body)?;
    (first != second).then(|| {
        let show = |value: f64| scene.display.length.show(value);
        format!(
            "Contact '{}': '{}' is {} thick and '{}' {}. CPRESS and CSHEAR1 are forces over the first one's thickness, and each body \
             carries them evenly over its own.",
            contact.name,
            contact.first.body,
            show(first),
            contact.second.body,
            show(second)
        )
    })
}

/// Circles of very different radius touch along a part of each that is not equally long.
fn wide(contact: &Contact, [hole, inner]: [f64; 2]) -> Option<String> {
    let part = 1.0 - inner / hole;
    (part > WIDE_CLEARANCE).then(|| {
        format!(
            "Contact '{}': the clearance is {:.0} % of the hole's radius. Points are paired at equal angles on the two circles, so \
             away from θ = 0 their places along the contact differ by as much.",
            contact.name,
            100.0 * part
        )
    })
}

/// Says if an end of contact on `edge` lies beyond the mesh's fine zone in any load step, with the farthest one; `steps` holds
/// the contact's zones for each step. Contact all around has no end, and a mesh of equal spacing no limit.
pub(crate) fn beyond_fine_zone(
    scene: &Scene,
    edge: &EdgeGeometry,
    steps: &[&[Zone]],
) -> Option<String> {
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
    let show = |value: f64| match edge.kind {
        EdgeKind::Circle { .. } => format!("{:.1}°", value.to_degrees()),
        EdgeKind::Line => scene.display.length.show(value),
    };
    let both = ends(steps[step])
        .iter()
        .any(|other| (other + end).abs() <= 1e-6 * end.abs());
    let symbol = match edge.kind {
        EdgeKind::Circle { .. } => "θ",
        EdgeKind::Line => "x",
    };
    let at = if both {
        format!("±{}", show(end.abs()))
    } else {
        format!("{symbol} = {}", show(end))
    };
    Some(format!(
        "Contact '{}' ends at {at} in load step {}, beyond the fine part of its mesh, which ends at ±{}: stresses near that end are as \
         accurate as the coarser mesh there. mesh.fine_to moves the limit.",
        edge.name,
        step + 1,
        show(limit)
    ))
}
