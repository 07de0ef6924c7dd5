//! Where round bodies stand: each in the hole that holds it.
//!
//! ```text
//! centre(second) = centre(first) + c_first − c_second + max(c, 0) a,     c = R_first − R_second
//! ```
//!
//! c are the centres of the circles, each seen from that of its body. A body that no hole holds stands at its own position. One with clearance starts where it
//! touches in the direction a in which loads drive it, one with interference concentric with what holds it. All slices of a fastener start at the smallest c
//! among them, so that they have one axis.

mod axis;

use stickslip_fem_core::mesh::Point;

use crate::Scene;
use crate::schema::{Contact, SetRef};
use crate::shape::Curve;

/// Radii `[mm]` of the two circles of a round contact.
pub fn radii(scene: &Scene, contact: &Contact) -> Option<[f64; 2]> {
    let circle = |set: &SetRef| scene.bodies.get(&set.body)?.shape.circle(&set.set);
    Some([circle(&contact.first)?, circle(&contact.second)?])
}

/// The round contact in which a hole holds `body`.
pub fn holder<'a>(scene: &'a Scene, body: &str) -> Option<&'a Contact> {
    scene
        .contacts
        .iter()
        .find(|contact| contact.second.body == body && radii(scene, contact).is_some())
}

/// Centre of the second circle of a round contact, seen from that of the first `[mm]`.
pub fn offset(scene: &Scene, contact: &Contact) -> Point {
    let own = &contact.second.body;
    let fastener = (scene.fasteners.iter()).find(|fastener| fastener.slices.contains(own));
    let beside = |other: &&Contact| match fastener {
        Some(fastener) => fastener.slices.contains(&other.second.body),
        None => other.name == contact.name,
    };
    let clearances = scene.contacts.iter().filter(beside);
    let clearances = clearances.filter_map(|other| radii(scene, other));
    let least = clearances
        .map(|[hole, inner]| hole - inner)
        .reduce(f64::min);
    let away = least.unwrap_or_default().max(0.0);
    let along = if let Some(fastener) = fastener {
        // One axis for all slices, which plates push either way.
        let slices = |body: &str| fastener.slices.iter().any(|slice| slice == body);
        axis::ahead(axis::of(scene, &slices, &|_| false))
    } else {
        let inner = |body: &str| holders(scene, body).any(|holder| holder == own);
        let outer = |body: &str| holders(scene, &contact.first.body).any(|own| own == body);
        axis::of(scene, &inner, &outer)
    };
    along.map(|part| away * part)
}

/// `body`, the body whose hole holds it, and so on.
fn holders<'a>(scene: &'a Scene, body: &'a str) -> impl Iterator<Item = &'a str> {
    let next = |body: &&'a str| Some(holder(scene, body)?.first.body.as_str());
    // A checked scene has no circular chain.
    std::iter::successors(Some(body), next).take(scene.contacts.len() + 1)
}

/// Centre of `body` `[mm]`.
pub fn centre(scene: &Scene, body: &str) -> Point {
    let (mut sum, mut inner) = ([0.0; 2], body);
    // A checked scene has no circular chain, so every contact is passed at most once.
    for _ in &scene.contacts {
        let Some(contact) = holder(scene, inner) else {
            break;
        };
        let aside = offset(scene, contact);
        let [hole, own] =
            [&contact.first, &contact.second].map(|on| within(scene, &on.body, &on.set));
        sum = [0, 1].map(|axis| sum[axis] + (hole[axis] - own[axis] + aside[axis]));
        inner = &contact.first.body;
    }
    let position = scene
        .bodies
        .get(inner)
        .map_or([0.0; 2], |body| body.position);
    [0, 1].map(|axis| sum[axis] + position[axis])
}

/// The middle `[mm]` of the bodies that no hole holds, if the scene says itself where the points of each of them are; otherwise the origin, about which the
/// others stand.
pub fn middle(scene: &Scene) -> Point {
    let free = scene
        .bodies
        .iter()
        .filter(|(name, _)| holder(scene, name).is_none());
    let mut extent: Option<[Point; 2]> = None;
    for (_, body) in free {
        if !body.shape.is_placed() {
            return [0.0; 2];
        }
        let at = |corner: Point| [0, 1].map(|axis| corner[axis] + body.position[axis]);
        let [low, high] = body.shape.bounds().map(at);
        let [least, most] = extent.unwrap_or([low, high]);
        extent = Some([
            [0, 1].map(|axis| least[axis].min(low[axis])),
            [0, 1].map(|axis| most[axis].max(high[axis])),
        ]);
    }
    let [low, high] = extent.unwrap_or_default();
    [0, 1].map(|axis| f64::midpoint(low[axis], high[axis]))
}

/// `scene` about its [`middle`] `[mm]`, which is returned as well: numbers there are relative to the size of its bodies, wherever these stand.
pub fn centred(scene: &Scene) -> (Scene, Point) {
    let middle = middle(scene);
    let mut centred = scene.clone();
    for body in centred.bodies.values_mut() {
        let by = [0, 1].map(|axis| body.position[axis] - middle[axis]);
        if let Some(moved) = body.shape.moved(by) {
            (body.shape, body.position) = (moved, [0.0; 2]);
        }
    }
    (centred, middle)
}

/// Centre of the closed circle `edge` of `body` `[mm]`.
pub fn circle_centre(scene: &Scene, body: &str, edge: &str) -> Point {
    let (centre, within) = (centre(scene, body), within(scene, body, edge));
    [0, 1].map(|axis| centre[axis] + within[axis])
}

/// Centre of the closed circle `edge`, seen from that of its body `[mm]`.
fn within(scene: &Scene, body: &str, edge: &str) -> Point {
    let body = scene.bodies.get(body);
    match body.and_then(|body| Some(body.shape.edge(edge)?.curve)) {
        Some(Curve::Circle { centre, .. }) => centre,
        _ => [0.0; 2],
    }
}
