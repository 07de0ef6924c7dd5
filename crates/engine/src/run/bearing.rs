//! Where an edge bears in every load step, and quantities measured from there.
//!
//! ```text
//! circle   θ_b = direction of the contact force on the first body, R = ∫(p e_r + λ_t e_t) dA
//! line     x_b = ∫p x dA / ∫p dA
//! ```
//!
//! The edge's frame takes θ_b of the step with the largest |R|; of equal ones the first.

use std::f64::consts::{PI, TAU};

use stickslip_contact::Status;
use stickslip_contact::zones::Zone;

use crate::model::ModelEdge;
use crate::results::{
    BearingSource, ContactFrame, EdgeGeometry, EdgeKind, EdgeResults, EdgeRow, wrapped,
};

/// Forces up to this part of the largest of the history, and places up to this part of the contact, are rounding.
const ROUNDING: f64 = 1e-9;
/// A place within this part of the edge's length of a node has that node's value.
const NEAR: f64 = 1e-6;

/// Puts the bearing point of every step of `edge` into `steps`, and what is measured from it; returns the edge's frame. Where nothing bears, that is the place
/// `start` on a line.
pub(super) fn find(edge: &ModelEdge, start: f64, steps: &mut [EdgeResults]) -> ContactFrame {
    let geometry = &edge.geometry;
    if geometry.contact {
        let points = match geometry.kind {
            EdgeKind::Circle { .. } => directions(steps),
            EdgeKind::Line | EdgeKind::Path => centres(edge, steps),
        };
        for (step, point) in steps.iter_mut().zip(points) {
            step.bearing = point;
        }
    }
    let frame = frame(geometry, steps);
    let geometry = EdgeGeometry {
        frame,
        ..geometry.clone()
    };
    for step in steps {
        let at = step.bearing.or(frame.bearing);
        let is_stressed = step.rows.iter().any(|row| row.sigma_tangential != 0.0);
        let peak = |value: fn(&EdgeRow) -> f64| largest(&geometry, &step.rows, value);
        step.peak_pressure = (step.contact_half_extent).and_then(|_| peak(|row| row.pressure));
        step.peak_hoop = is_stressed
            .then(|| peak(|row| row.sigma_tangential))
            .flatten();
        step.stick_half_extent = step
            .stick_half_extent
            .and_then(|_| stick_around(&geometry, &step.zones, at));
        step.contact_half_extent = step
            .contact_half_extent
            .filter(|_| geometry.contact && reaches(&geometry, &step.zones, at));
        step.slip_lengths = (geometry.contact)
            .then(|| step.lengths_of_slip(&geometry))
            .flatten();
        step.friction_force = friction_force(edge, &step.rows, at);
        step.hoop_at_bearing_point = interpolated(
            &geometry,
            &step.rows,
            geometry.reference(step.bearing, start),
            |row| row.sigma_tangential,
        );
    }
    frame
}

fn size([x, y]: [f64; 2]) -> f64 {
    x.hypot(y)
}

/// Direction of the contact force in every step `[rad]`; components that are rounding beside the pressures are zero.
fn directions(steps: &[EdgeResults]) -> Vec<Option<f64>> {
    let least = steps.iter().map(|step| step.normal_force);
    let least = ROUNDING * least.fold(0.0, f64::max);
    let direction = |step: &EdgeResults| {
        let [x, y] = step
            .resultant
            .map(|force| if force.abs() > least { force } else { 0.0 });
        (size([x, y]) > 0.0).then(|| y.atan2(x))
    };
    steps.iter().map(direction).collect()
}

/// Centre of pressure of a line in every step `[mm]`, of a half on its line of symmetry.
fn centres(edge: &ModelEdge, steps: &[EdgeResults]) -> Vec<Option<f64>> {
    let places = || edge.geometry.parameter.iter().zip(&edge.areas);
    let centre = |step: &EdgeResults| {
        let sum = |weight: &dyn Fn(f64) -> f64| -> f64 {
            let rows = step.rows.iter().zip(places());
            rows.map(|(row, (&at, area))| row.pressure * area * weight(at))
                .sum()
        };
        let (force, moment, spread) = (sum(&|_| 1.0), sum(&|at| at), sum(&f64::abs));
        (force > 0.0).then(|| {
            if edge.geometry.half || moment.abs() <= ROUNDING * spread {
                0.0
            } else {
                moment / force
            }
        })
    };
    steps.iter().map(centre).collect()
}

fn frame(geometry: &EdgeGeometry, steps: &[EdgeResults]) -> ContactFrame {
    let largest = steps.iter().map(|step| size(step.resultant));
    let largest = largest.fold(0.0, f64::max);
    let peak = steps.iter().position(|step| {
        step.bearing.is_some() && size(step.resultant) >= largest * (1.0 - ROUNDING)
    });
    peak.map_or(geometry.frame, |step| {
        let bearing = steps[step].bearing;
        let behind = bearing.is_some_and(|theta| theta.abs() > 0.5 * PI);
        ContactFrame {
            bearing,
            found: BearingSource::Contact { step },
            clockwise: geometry.half && geometry.closed().is_some() && behind,
        }
    })
}

/// Whether `place` lies in `zone` of an edge that may be closed.
fn holds(geometry: &EdgeGeometry, zone: &Zone, place: f64) -> bool {
    let within = |at: f64| zone.start <= at && at <= zone.end;
    match geometry.closed() {
        Some(length) => within(place) || within(place + length) || within(place - length),
        None => within(place),
    }
}

/// Half of the length of the stick zone around the bearing point `at`.
fn stick_around(geometry: &EdgeGeometry, zones: &[Zone], at: Option<f64>) -> Option<f64> {
    let mut sticking = zones.iter().filter(|zone| zone.status == Status::Stick);
    let Some(at) = at else {
        let whole = geometry.closed().map(|length| length * (1.0 - ROUNDING));
        let around = |zone: &&Zone| whole.is_some_and(|whole| zone.length() >= whole);
        return sticking.find(around).map(|zone| 0.5 * zone.length());
    };
    let middle = sticking.find(|zone| holds(geometry, zone, at));
    Some(middle.map_or(0.0, |zone| 0.5 * zone.length()))
}

/// Whether the bearing point `at` lies within what contact reaches over, gaps between its parts included.
fn reaches(geometry: &EdgeGeometry, zones: &[Zone], at: Option<f64>) -> bool {
    let touching = || zones.iter().filter(|zone| zone.status.touches());
    match (geometry.closed(), at) {
        (Some(_), None) => zones.iter().all(|zone| zone.status.touches()),
        (Some(_), Some(at)) => {
            let open = zones.iter().filter(|zone| !zone.status.touches());
            let opening = open.max_by(|a, b| a.length().total_cmp(&b.length()));
            let touches = touching().any(|zone| holds(geometry, zone, at));
            touches || !opening.is_some_and(|zone| holds(geometry, zone, at))
        }
        // Pressures have their centre between the ends of contact.
        (None, _) => touching().next().is_some(),
    }
}

/// Friction force of the modelled part, with sign. On a circle ∫ q dA with q = −λ_t sgn(sin(θ − θ_b)), positive where friction pulls the
/// first body towards the bearing point; on a line the force on the first body along +x, which is against e_t. A half stands for both
/// sides: around a hole both pull the same way, on a line their forces cancel.
fn friction_force(edge: &ModelEdge, rows: &[EdgeRow], bearing: Option<f64>) -> f64 {
    let half = edge.geometry.half;
    let (side, both): (Box<dyn Fn(f64) -> f64>, f64) = match (edge.geometry.kind, bearing) {
        (EdgeKind::Line | EdgeKind::Path, _) => (Box::new(|_| 1.0), if half { 0.0 } else { 1.0 }),
        (EdgeKind::Circle { .. }, None) => return 0.0,
        (EdgeKind::Circle { .. }, Some(from)) => {
            let side = move |at: f64| {
                let away = wrapped(at - from);
                let end = away == 0.0 || away > PI - ROUNDING;
                if end { 0.0 } else { away.signum() }
            };
            (Box::new(side), if half { 2.0 } else { 1.0 })
        }
    };
    let friction = rows.iter().zip(&edge.areas).zip(&edge.geometry.parameter);
    both * friction
        .map(|((row, area), &at)| -side(at) * row.shear * area)
        .sum::<f64>()
}

/// A quantity at a place, linear between nodes.
fn interpolated(
    geometry: &EdgeGeometry,
    rows: &[EdgeRow],
    at: f64,
    value: impl Fn(&EdgeRow) -> f64,
) -> Option<f64> {
    let away = |place: f64| match geometry.closed() {
        Some(_) => wrapped(place - at),
        None => place - at,
    };
    let nearest = |side: &dyn Fn(f64) -> bool| {
        let places = geometry.parameter.iter().map(|&place| away(place));
        let found = places.enumerate().filter(|&(_, away)| side(away));
        found.min_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))
    };
    let length = geometry
        .parameter
        .iter()
        .fold(0.0_f64, |most, at| most.max(at.abs()));
    let (node, apart) = nearest(&|_| true)?;
    let other = nearest(&|away| away * apart < 0.0);
    match other {
        Some((next, beyond)) if apart.abs() > NEAR * length => {
            let part = apart / (apart - beyond);
            Some(value(&rows[node]) * (1.0 - part) + value(&rows[next]) * part)
        }
        _ => Some(value(&rows[node])),
    }
}

/// The largest value of a quantity and its place. Of values that are equal but for rounding, as on both sides of a symmetric edge, the
/// one nearest to the bearing point on the positive side has the place.
fn largest(
    geometry: &EdgeGeometry,
    rows: &[EdgeRow],
    value: impl Fn(&EdgeRow) -> f64,
) -> Option<(f64, f64)> {
    // Solvers promise 1e-10 of the largest force; the traction of a node may be less by its small area.
    const ROUNDING: f64 = 1e-7;
    let most = rows.iter().map(&value).reduce(f64::max)?;
    let size = geometry.closed().unwrap_or_else(|| {
        let places = geometry.parameter.iter();
        places.fold(0.0, |size: f64, place| size.max(place.abs()))
    });
    let high = rows.iter().zip(&geometry.parameter);
    let places = high.filter(|(row, _)| value(row) >= most - ROUNDING * most.abs());
    let nearer = |&a: &f64, &b: &f64| {
        let (a, b) = (geometry.seen(a), geometry.seen(b));
        let apart = a.abs() - b.abs();
        if apart.abs() > ROUNDING * size {
            apart.total_cmp(&0.0)
        } else {
            b.total_cmp(&a)
        }
    };
    let place = places.map(|(_, place)| *place).min_by(nearer)?;
    // A closed walk starts at −π, which is π.
    let far = |length: f64| place < -0.5 * length * (1.0 - ROUNDING);
    let place = match geometry.closed() {
        Some(length) if far(length) => place + TAU,
        _ => place,
    };
    Some((most, place))
}
