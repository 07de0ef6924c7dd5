//! What is left of loads and places of failure.
//!
//! A number v is compared with that of the models before, `k max(|v₂ − v₁|, r |v₁ − v₀|)`, for failure begins where stress has a cusp. To that comes the part by which the load path and the
//! geometry leave the peak stress and pressure of the step. Where a whole body is its own mirror image, so are its weakest places, of which models take either: places are compared up to
//! that.

use super::numbers::{Numbers, Table};
use stickslip_engine::results::{
    BodyFailure, Errors, FailurePoint, FirstPly, JointFailure, PointErrors, Results, Stated,
};

/// k of the module's equation.
const FACTOR: f64 = 3.0;
/// r of the module's equation.
const RATE: f64 = 0.5;

/// What an error is found by.
#[derive(Clone, Copy)]
struct Known<'a> {
    /// Those of [`parts`].
    parts: &'a [f64],
    /// The coordinate by whose sign a whole body and its mirror image differ; `None` where it is not its own.
    mirror: Option<usize>,
}

/// Puts errors into `found`, the failure of bodies of the finest model, by that of the coarser ones `before`, the next finest first. `parts` are those of [`parts`], and `mirror` is the
/// coordinate by whose sign a whole body and its mirror image differ; `None` where it is not its own.
pub(super) fn estimate_all(
    found: &mut [BodyFailure],
    before: &[Results],
    parts: &[f64],
    mirror: impl Fn(usize) -> Option<usize>,
) {
    for (index, own) in found.iter_mut().enumerate() {
        let before = before.iter().filter_map(|all| all.failure.get(index));
        let before: Vec<_> = before.collect();
        let mirror = mirror(own.body);
        estimate(own, &before, Known { parts, mirror });
    }
}

fn estimate(own: &mut BodyFailure, before: &[&BodyFailure], known: Known<'_>) {
    if !before.is_empty() {
        of_body(own, before, known);
    }
}

/// By which part of itself a stress of each step is off at most, because of the errors `left` of the load path and of the geometry, and of two models of the division.
pub(super) fn parts(numbers: &Numbers, left: &Table) -> Vec<f64> {
    let steps = numbers.steps.iter().zip(left);
    let part = |(step, errors): (&Vec<_>, &Vec<_>)| {
        let edges = step.iter().zip(errors).zip(&numbers.geometries);
        let contacts = edges.filter(|(_, geometry)| geometry.contact);
        let parts = contacts.flat_map(|((edge, errors), _): ((&_, &Errors), _)| {
            let peaks = [Stated::PeakPressure, Stated::PeakHoop];
            let sizes = peaks.map(|stated| stated.value(edge).map_or(0.0, f64::abs));
            let size = sizes[0].max(sizes[1]);
            peaks.map(|stated| Some(errors.get(stated)? / size))
        });
        let parts = parts.flatten().filter(|part| part.is_finite());
        parts.fold(0.0, f64::max)
    };
    steps.map(part).collect()
}

fn of_body(own: &mut BodyFailure, before: &[&BodyFailure], known: Known<'_>) {
    for step in 0..own.steps.len() {
        for (k, point) in own.steps[step].iter_mut().enumerate() {
            let before: Vec<&FailurePoint> = (before.iter())
                .filter_map(|other| other.steps.get(step)?.get(k))
                .collect();
            point.errors = of_point(point, &before, part(known.parts, step), known.mirror);
        }
    }
    of_firsts(&mut own.first_ply, before, known, |other| {
        Some(&other.first_ply)
    });
    let Some(characteristic) = &mut own.characteristic else {
        return;
    };
    for (k, joint) in characteristic.curve.iter_mut().enumerate() {
        let Some(JointFailure { first, .. }) = joint else {
            continue;
        };
        let before: Vec<&FirstPly> = (before.iter())
            .filter_map(|other| Some(&other.characteristic.as_ref()?.curve.get(k)?.as_ref()?.first))
            .collect();
        of_first(first, &before, known);
    }
    of_firsts(&mut characteristic.net_section, before, known, |other| {
        Some(&other.characteristic.as_ref()?.net_section)
    });
    of_firsts(&mut characteristic.bearing_point, before, known, |other| {
        Some(&other.characteristic.as_ref()?.bearing_point)
    });
}

fn of_firsts(
    own: &mut [Option<FirstPly>],
    before: &[&BodyFailure],
    known: Known<'_>,
    of: impl Fn(&BodyFailure) -> Option<&Vec<Option<FirstPly>>>,
) {
    for (k, first) in own.iter_mut().enumerate() {
        let Some(first) = first else {
            continue;
        };
        let before: Vec<&FirstPly> = (before.iter())
            .filter_map(|other| of(other)?.get(k)?.as_ref())
            .collect();
        of_first(first, &before, known);
    }
}

fn of_first(own: &mut FirstPly, before: &[&FirstPly], known: Known<'_>) {
    let load = |first: &FirstPly| Some(first.load.as_ref()?.value);
    own.load_error = load(own).and_then(|value| {
        let before: Vec<f64> = before.iter().filter_map(|first| load(first)).collect();
        Some(left(value, &before)? + part(known.parts, own.step) * value.abs())
    });
    let points: Vec<&FailurePoint> = before.iter().map(|first| &first.at).collect();
    // Index and reserve factor are one there.
    own.at.errors = of_point(&own.at, &points, 0.0, known.mirror).map(|errors| PointErrors {
        index: None,
        reserve_factor: None,
        ..errors
    });
}

fn of_point(
    own: &FailurePoint,
    before: &[&FailurePoint],
    part: f64,
    mirror: Option<usize>,
) -> Option<PointErrors> {
    let number = |value: fn(&FailurePoint) -> f64, power: f64| {
        let before: Vec<f64> = before.iter().map(|point| value(point)).collect();
        let error = left(value(own), &before)? + power * part * value(own).abs();
        error.is_finite().then_some(error)
    };
    let apart = |one: &FailurePoint, other: &FailurePoint| {
        let away = |at: [f64; 2]| {
            let [x, y] = [0, 1].map(|axis| one.position[axis] - at[axis]);
            x.hypot(y)
        };
        let direct = away(other.position);
        mirror.map_or(direct, |across| {
            let mut image = other.position;
            image[across] *= -1.0;
            direct.min(away(image))
        })
    };
    let mut chain = vec![own];
    chain.extend(before);
    let apart: Vec<f64> = chain
        .windows(2)
        .map(|pair| apart(pair[0], pair[1]))
        .collect();
    Some(PointErrors {
        // Of most criteria it grows with the square of stress.
        index: number(|point| point.index, 2.0),
        reserve_factor: number(|point| point.reserve_factor, 1.0),
        place: size(&apart)?,
    })
}

/// What the division leaves of a number, by those of coarser models; `None` without one.
pub(super) fn left(value: f64, before: &[f64]) -> Option<f64> {
    let mut chain = vec![value];
    chain.extend(before);
    let changes: Vec<f64> = chain
        .windows(2)
        .map(|pair| (pair[0] - pair[1]).abs())
        .collect();
    size(&changes)
}

fn size(changes: &[f64]) -> Option<f64> {
    let before = changes.get(1).copied().unwrap_or(0.0);
    Some(FACTOR * changes.first()?.max(RATE * before))
}

pub(super) fn part(parts: &[f64], step: usize) -> f64 {
    parts.get(step).copied().unwrap_or(0.0)
}
