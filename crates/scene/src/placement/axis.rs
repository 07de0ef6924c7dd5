//! The axis along which loads drive what a hole holds.

use crate::Scene;
use crate::schema::{Contact, LoadKind, Support};

/// Sine of the angle to an axis of the plane below which a direction lies along it.
const ALONG: f64 = 1e-12;

/// The unit vector, with x > 0 or along +y, of the axis along which the second body of a round contact moves in its hole, so that it starts
/// where it touches: that of the forces on the bodies `inner`, otherwise on the hole's, otherwise on all, in the first step in which they do not
/// cancel out; the same of displacements where no force has a direction; otherwise x.
pub(super) fn of(scene: &Scene, contact: &Contact, inner: &dyn Fn(&str) -> bool) -> [f64; 2] {
    let hole = contact.first.body.as_str();
    let groups: [&dyn Fn(&str) -> bool; 3] = [inner, &|body| body == hole, &|_| true];
    let forces = |on: &&dyn Fn(&str) -> bool| force(scene, *on);
    let motions = |on: &&dyn Fn(&str) -> bool| motion(&scene.supports, *on);
    let found = groups.iter().find_map(forces);
    let [x, y] = found
        .or_else(|| groups.iter().find_map(motions))
        .unwrap_or([1.0, 0.0]);
    if y.abs() < ALONG {
        [1.0, 0.0]
    } else if x.abs() < ALONG {
        [0.0, 1.0]
    } else {
        [x.abs(), y * x.signum()]
    }
}

/// The direction of the sum of forces on the bodies `on` in the first step that has one.
fn force(scene: &Scene, on: &dyn Fn(&str) -> bool) -> Option<[f64; 2]> {
    let loads = scene.loads.iter().filter(|load| on(load.kind.body()));
    let directed = loads.filter_map(|load| match &load.kind {
        LoadKind::Force {
            direction, steps, ..
        }
        | LoadKind::Bearing {
            direction, steps, ..
        } => Some((*direction, steps)),
        LoadKind::Pressure { .. }
        | LoadKind::PolarTraction { .. }
        | LoadKind::Temperature { .. } => None,
    });
    let directed: Vec<([f64; 2], &Vec<f64>)> = directed.collect();
    (0..scene.steps()).find_map(|step| {
        let parts = directed.iter();
        let parts = parts.map(|(direction, steps)| direction.map(|part| part * steps[step]));
        resultant(parts)
    })
}

/// The direction of the sum of displacements of supports of the bodies `on`.
fn motion(supports: &[Support], on: &dyn Fn(&str) -> bool) -> Option<[f64; 2]> {
    let own = supports.iter().filter(|support| on(&support.on.body));
    resultant(own.flat_map(|support| {
        let directions = support.hold.directions().into_iter();
        directions.map(|direction| direction.map(|part| part * support.displacement))
    }))
}

/// The direction of a sum; `None` where its parts cancel out.
fn resultant(parts: impl Iterator<Item = [f64; 2]>) -> Option<[f64; 2]> {
    let (mut sum, mut whole) = ([0.0; 2], 0.0);
    for [x, y] in parts {
        sum = [sum[0] + x, sum[1] + y];
        whole += f64::hypot(x, y);
    }
    let size = f64::hypot(sum[0], sum[1]);
    (size > 1e-9 * whole).then(|| sum.map(|part| part / size))
}
