//! Nodes graded towards the places where contact changes, the ends of contact, of stick and of slip at the end of every load step, and finer within a small contact.
//!
//! ```text
//! h(θ) = min(coarse, fine + GROWTH d, coarse w/WIDE + GROWTH d),     n = ∫ dθ/h(θ)
//! ```
//!
//! d is the distance of θ from the nearest place, or from a contact that extends over w. A place is known to the interval of nodes between which the
//! status changes, so that is its extent. Angles divide the integral into equal parts.

use std::f64::consts::{PI, TAU};

use super::numbers::Numbers;

/// Growth of the spacing per length.
const GROWTH: f64 = 0.4;
/// Extent of contact that coarse nodes resolve as wanted `[rad]`.
const WIDE: f64 = 2.0;
/// Steps of the integral per fine spacing.
const POINTS: f64 = 4.0;

/// Spacings of nodes `[rad]` of the model `rung`, fine and coarse, where those of the first are `widest`: from rung to rung a quarter and half of it, for errors fall
/// with the root of the one and the square of the other.
pub(super) fn spacings(widest: f64, rung: usize) -> [f64; 2] {
    [4.0, 2.0_f64].map(|ratio| widest / ratio.powi(rung as i32))
}

/// Angles from 0 to π of a half model, or all around, there those of places and their images if `mirrored`; `fine` and `coarse` are spacings `[rad]`, places are
/// those of `level`.
pub(super) fn angles(
    level: &Numbers,
    half: bool,
    mirrored: bool,
    [fine, coarse]: [f64; 2],
) -> Vec<f64> {
    let mut places = places(level, fine, coarse);
    if mirrored {
        let images: Vec<Place> = places.iter().map(Place::mirrored).collect();
        places.extend(images);
    }
    let spacing = |angle: f64| {
        let own = places.iter();
        own.map(|place| place.spacing + GROWTH * place.distance(angle))
            .fold(coarse, f64::min)
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

/// Angles where nodes are closer.
struct Place {
    middle: f64,
    reach: f64,
    spacing: f64,
}

impl Place {
    fn between(from: f64, to: f64, spacing: f64) -> Self {
        let width = (to - from).rem_euclid(TAU);
        Self {
            middle: from + 0.5 * width,
            reach: 0.5 * width,
            spacing,
        }
    }

    fn mirrored(&self) -> Self {
        Self {
            middle: -self.middle,
            ..*self
        }
    }

    fn distance(&self, angle: f64) -> f64 {
        let away = (angle - self.middle).rem_euclid(TAU);
        (away.min(TAU - away) - self.reach).max(0.0)
    }
}

fn places(level: &Numbers, fine: f64, coarse: f64) -> Vec<Place> {
    let mut places = Vec::new();
    let contacts = level.geometries.iter().enumerate();
    for (edge, geometry) in contacts.filter(|(_, geometry)| geometry.contact) {
        let at = |k: usize| geometry.parameter[k % geometry.parameter.len()];
        for step in &level.steps {
            let rows = &step[edge].rows;
            let count = rows.len();
            let last = if geometry.half { count - 1 } else { count };
            let changes = (0..last).filter(|k| rows[*k].status != rows[(k + 1) % count].status);
            places.extend(changes.map(|k| Place::between(at(k), at(k + 1), fine)));
            let Some(extent) = step[edge].contact_half_extent else {
                continue;
            };
            let spacing = coarse * (2.0 * extent / WIDE).min(1.0);
            let touching: Vec<bool> = rows.iter().map(|row| row.status.touches()).collect();
            let mut from = 0;
            for run in touching.chunk_by(|one, other| one == other) {
                let to = from + run.len();
                if run[0] {
                    places.push(Place::between(at(from), at(to.min(last)), spacing));
                }
                from = to;
            }
        }
    }
    places
}
