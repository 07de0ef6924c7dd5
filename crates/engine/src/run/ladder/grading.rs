//! Nodes graded towards the places where contact changes, the ends of contact, of stick and of slip, and finer within a small contact.
//!
//! ```text
//! h_k(θ) = min(widest, fine + GROWTH d, coarse w/WIDE + GROWTH c),     h(θ) = min(coarse, h_1, h_2, …),     n = ∫ dθ/h(θ)
//! ```
//!
//! d is the distance of θ from the nearest place where the status changes at the end of load step k or of the one before, c that from a contact that extends over w. Places of
//! earlier steps, from which slip came that stays, count with twice the spacing for every step since. A place is known to the interval of nodes between which the status changes, so that is its extent.
//!
//! Angles of all nodes divide the integral into equal parts; each load step takes those that are as far apart as h_k lets them.

use std::f64::consts::{PI, TAU};

use super::numbers::Numbers;

/// Growth of the spacing per length.
const GROWTH: f64 = 0.4;
/// Extent of contact that coarse nodes resolve as wanted `[rad]`.
const WIDE: f64 = 2.0;
/// Steps of the integral per fine spacing.
const POINTS: f64 = 4.0;

/// How nodes are graded in a history.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grading {
    /// Spacing of nodes where nothing touches, and the largest one of all nodes `[rad]`.
    widest: f64,
    coarse: f64,
    /// Where nodes are closer, in each load step.
    steps: Vec<Vec<Place>>,
}

impl Grading {
    /// That of the model `rung` after the places of `level`, a coarser one, and their images if `mirrored`; `widest` is the spacing of the first model `[rad]`. Spacings are from rung to
    /// rung a quarter of it near places and half of it elsewhere, for errors fall with the root of the one and the square of the other.
    pub(super) fn new(level: &Numbers, rung: usize, widest: f64, mirrored: bool) -> Self {
        let [fine, coarse] = [4.0, 2.0_f64].map(|ratio| widest / ratio.powi(rung as i32));
        let own: Vec<StepPlaces> = (0..level.steps.len())
            .map(|step| StepPlaces::of(level, step, coarse))
            .collect();
        let places = |step: usize| {
            let mut places: Vec<Place> = Vec::new();
            let since = |before: &usize| (step - before).saturating_sub(1);
            for before in (0..=step).rev().take_while(|before| since(before) < 32) {
                let spacing = fine * f64::from(1_u32 << since(&before));
                if spacing >= coarse {
                    break;
                }
                let changes = own[before].changes.iter();
                places.extend(changes.map(|&ends| Place::between(ends, spacing)));
                if before + 1 >= step {
                    places.extend(&own[before].contacts);
                }
            }
            if mirrored {
                let images: Vec<Place> = places.iter().map(Place::mirrored).collect();
                places.extend(images);
            }
            places
        };
        Self {
            widest,
            coarse,
            steps: (0..own.len()).map(places).collect(),
        }
    }

    /// Angles of all nodes from 0 to π of a half model, or all around.
    pub(super) fn angles(&self, half: bool) -> Vec<f64> {
        let places: Vec<Place> = self.steps.iter().flatten().copied().collect();
        angles(half, |angle| spacing(&places, angle, self.coarse))
    }

    /// The nodes of load step `step` among those at `angles`, ascending, of a half circle or all around.
    pub(super) fn chosen(&self, step: usize, angles: &[f64], half: bool) -> Vec<usize> {
        let wanted: Vec<f64> = angles
            .iter()
            .map(|&angle| spacing(&self.steps[step], angle, self.widest))
            .collect();
        let count = angles.len();
        let last = if half { count - 1 } else { count };
        let place = |k: usize| angles[k % count] + if k < count { 0.0 } else { TAU };
        let fits = |from: usize, to: usize| {
            place(to) - place(from) <= wanted[from].min(wanted[to % count])
        };
        let (mut at, mut chosen) = (0, vec![0]);
        while at < last {
            let next = (at + 2..=last).take_while(|&to| fits(at, to)).last();
            at = next.unwrap_or(at + 1);
            chosen.push(at);
        }
        if !half {
            chosen.pop();
        }
        chosen
    }
}

/// Distance of nodes at `angle`, closer at `places`, elsewhere `widest`.
fn spacing(places: &[Place], angle: f64, widest: f64) -> f64 {
    let own = places.iter();
    own.map(|place| place.spacing + GROWTH * place.distance(angle))
        .fold(widest, f64::min)
}

/// Angles from 0 to π of a `half` model, or all around, at the distances `spacing`.
fn angles(half: bool, spacing: impl Fn(f64) -> f64) -> Vec<f64> {
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
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    middle: f64,
    reach: f64,
    spacing: f64,
}

impl Place {
    fn between([from, to]: [f64; 2], spacing: f64) -> Self {
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

/// Where contact changes and where there is contact at the end of a load step.
struct StepPlaces {
    /// Angles between which the status changes.
    changes: Vec<[f64; 2]>,
    contacts: Vec<Place>,
}

impl StepPlaces {
    /// Those of `level`, where an extended contact wants the spacing `coarse`.
    fn of(level: &Numbers, step: usize, coarse: f64) -> Self {
        let (mut changes, mut contacts) = (Vec::new(), Vec::new());
        let edges = level.own[step].iter().zip(&level.steps[step]);
        for (geometry, results) in edges.filter(|(geometry, _)| geometry.contact) {
            let at = |k: usize| geometry.parameter[k % geometry.parameter.len()];
            let rows = &results.rows;
            let count = rows.len();
            let last = if geometry.half { count - 1 } else { count };
            let ends = (0..last).filter(|k| rows[*k].status != rows[(k + 1) % count].status);
            changes.extend(ends.map(|k| [at(k), at(k + 1)]));
            // Contact all around, or in several pieces, has no extent.
            let extent = results.contact_half_extent;
            let spacing = coarse * extent.map_or(1.0, |extent| (2.0 * extent / WIDE).min(1.0));
            let touching: Vec<bool> = rows.iter().map(|row| row.status.touches()).collect();
            let mut from = 0;
            for run in touching.chunk_by(|one, other| one == other) {
                let to = from + run.len();
                if run[0] && run.len() == count && !geometry.half {
                    contacts.push(Place {
                        middle: 0.0,
                        reach: PI,
                        spacing,
                    });
                } else if run[0] {
                    contacts.push(Place::between([at(from), at(to.min(last))], spacing));
                }
                from = to;
            }
        }
        Self { changes, contacts }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREE: f64 = PI / 180.0;

    /// Ends of contact at 40° in the first step and at 80° in the second, known to a tenth of a degree.
    fn grading() -> Grading {
        let end = |at: f64| Place::between([at * DEGREE, (at + 0.1) * DEGREE], 0.1 * DEGREE);
        let contact = |to: f64| Place::between([0.0, to * DEGREE], 0.75 * DEGREE);
        Grading {
            widest: 6.0 * DEGREE,
            coarse: 0.75 * DEGREE,
            steps: vec![
                vec![end(40.0), contact(40.0)],
                vec![end(80.0), contact(80.0)],
            ],
        }
    }

    #[test]
    fn steps_have_the_spacing_that_they_want() {
        let grading = grading();
        for half in [true, false] {
            let angles = grading.angles(half);
            for (step, places) in grading.steps.iter().enumerate() {
                let chosen = grading.chosen(step, &angles, half);
                assert!(5 * chosen.len() < 4 * angles.len());
                assert_eq!(chosen[0], 0);
                assert!(!half || chosen[chosen.len() - 1] == angles.len() - 1);
                for pair in chosen.windows(2) {
                    let [from, to] = [angles[pair[0]], angles[pair[1]]];
                    let wanted = [from, to].map(|at| spacing(places, at, grading.widest));
                    // Where all nodes stand as far apart as wanted they may do so by rounding more.
                    let most = 1.05 * wanted[0].min(wanted[1]);
                    assert!(to - from <= most || pair[1] == pair[0] + 1);
                }
            }
        }
    }

    #[test]
    fn places_keep_their_spacing() {
        let grading = grading();
        let angles = grading.angles(true);
        for (step, at) in [(0, 40.05), (1, 80.05)] {
            let chosen = grading.chosen(step, &angles, true);
            let near = chosen.windows(2).filter(|pair| {
                let middle = 0.5 * (angles[pair[0]] + angles[pair[1]]);
                (middle - at * DEGREE).abs() < 0.05 * DEGREE
            });
            for pair in near {
                assert!(angles[pair[1]] - angles[pair[0]] < 0.11 * DEGREE);
            }
        }
    }
}
