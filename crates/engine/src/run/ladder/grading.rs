//! Nodes graded towards the places where contact changes: the ends of contact, of stick and of slip, at the end of every load step.
//!
//! ```text
//! h(θ) = min(coarse, fine + GROWTH · distance of θ from the nearest place),     n = ∫ dθ/h(θ)
//! ```
//!
//! A place is known to the interval of nodes between which the status changes, so that is its extent. Angles divide the integral into equal parts.

use std::f64::consts::{PI, TAU};

use super::models::Level;

/// Growth of the spacing per length.
const GROWTH: f64 = 0.4;
/// Steps of the integral per fine spacing.
const POINTS: f64 = 4.0;

/// Angles from 0 to π of a half model, or all around; `fine` and `coarse` are spacings `[rad]`, places are those of `level`.
pub(super) fn angles(level: &Level, half: bool, [fine, coarse]: [f64; 2]) -> Vec<f64> {
    let places = places(level);
    let spacing = |angle: f64| {
        let away = places.iter().map(|place| place.distance(angle));
        coarse.min(fine + GROWTH * away.fold(f64::INFINITY, f64::min))
    };
    let end = if half { PI } else { TAU };
    // The integral, walked in steps of a part of the spacing itself.
    let mut walk = vec![[0.0, 0.0]];
    let (mut angle, mut count) = (0.0, 0.0);
    while angle < end {
        let width = spacing(angle);
        let step = (width / POINTS).min(end - angle);
        let middle = spacing(angle + 0.5 * step);
        angle += step;
        count += step / middle;
        if end - angle < 1e-12 {
            angle = end;
        }
        walk.push([angle, count]);
    }
    let parts = if half {
        count.ceil()
    } else {
        (0.5 * count).ceil() * 2.0
    };
    let mut at = 0;
    let own = (0..=parts as usize).map(|k| {
        let wanted = count * k as f64 / parts;
        while at + 2 < walk.len() && walk[at + 1][1] < wanted {
            at += 1;
        }
        let ([a, from], [b, to]) = (walk[at], walk[at + 1]);
        a + (b - a) * (wanted - from) / (to - from)
    });
    let mut angles: Vec<f64> = own.collect();
    if half {
        if let Some(last) = angles.last_mut() {
            *last = PI;
        }
    } else {
        angles.pop();
    }
    angles
}

/// Angles between which a status changes.
struct Place {
    middle: f64,
    reach: f64,
}

impl Place {
    fn distance(&self, angle: f64) -> f64 {
        let away = (angle - self.middle).rem_euclid(TAU);
        (away.min(TAU - away) - self.reach).max(0.0)
    }
}

fn places(level: &Level) -> Vec<Place> {
    let mut places = Vec::new();
    for (edge, geometry) in level.geometries.iter().enumerate() {
        if !geometry.contact {
            continue;
        }
        for step in &level.steps {
            let rows = &step[edge].rows;
            let count = rows.len();
            let last = if geometry.half { count - 1 } else { count };
            for k in 0..last {
                let next = (k + 1) % count;
                if rows[k].status == rows[next].status {
                    continue;
                }
                let from = geometry.parameter[k];
                let width = (geometry.parameter[next] - from).rem_euclid(TAU);
                places.push(Place {
                    middle: from + 0.5 * width,
                    reach: 0.5 * width,
                });
            }
        }
    }
    places
}
