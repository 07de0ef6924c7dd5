//! The direction in which loads drive what a hole holds.

use crate::Scene;
use crate::schema::{LoadKind, Support};

/// Sine of the angle to an axis of the plane below which a direction lies along it.
const ALONG: f64 = 1e-12;

/// Bodies, by name.
type Bodies<'a> = &'a dyn Fn(&str) -> bool;

/// The unit vector along which the bodies `inner` move in a hole of the bodies `outer`, so that they start where they touch: that of the forces on `inner`,
/// otherwise against those on `outer`, in the first step in which they do not cancel out; the same of displacements where no force on either has a
/// direction. Where only other bodies are driven it is the axis of all forces, or of all displacements, with x > 0 or along +y, and x without any.
pub(super) fn of(scene: &Scene, inner: Bodies<'_>, outer: Bodies<'_>) -> [f64; 2] {
    let forces = |on: Bodies<'_>| force(scene, on);
    let motions = |on: Bodies<'_>| motion(&scene.supports, on);
    let own = |of: &dyn Fn(Bodies<'_>) -> Option<[f64; 2]>| {
        of(inner).or_else(|| of(outer).map(|push| push.map(|part| -part)))
    };
    let all = |of: &dyn Fn(Bodies<'_>) -> Option<[f64; 2]>| of(&|_| true).map(ahead);
    let found = own(&forces).or_else(|| own(&motions));
    let found = found.or_else(|| all(&forces)).or_else(|| all(&motions));
    let [x, y] = found.unwrap_or([1.0, 0.0]);
    if y.abs() < ALONG {
        [x.signum(), 0.0]
    } else if x.abs() < ALONG {
        [0.0, y.signum()]
    } else {
        [x, y]
    }
}

/// The direction along the same axis with x > 0, or along +y.
pub(super) fn ahead([x, y]: [f64; 2]) -> [f64; 2] {
    if x.abs() < ALONG {
        [0.0, y.abs()]
    } else {
        [x.abs(), y * x.signum()]
    }
}

/// The direction of the sum of forces on the bodies `on` in the first step that has one.
fn force(scene: &Scene, on: Bodies<'_>) -> Option<[f64; 2]> {
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
fn motion(supports: &[Support], on: Bodies<'_>) -> Option<[f64; 2]> {
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
