//! Nodes graded towards the places where contact changes, the ends of contact, of stick and of slip, and finer within a small contact.
//!
//! ```text
//! h_k(θ) = min(widest, fine + GROWTH d, coarse w/WIDE + GROWTH c),     h(θ) = min(coarse, h_1, h_2, …),     n = ∫ dθ/h(θ)
//! ```
//!
//! d is the distance of θ from the nearest place where the status changes at the end of load step k or of the one before, c that from a contact that extends over w. Places of
//! earlier steps, from which slip came that stays, count with twice the spacing for every step since. A place is known to the interval of nodes between which the status changes, so that is its extent.
//!
//! Along a straight edge a contact of half extent a counts as one of 2 rad: lengths are a times angles, and nodes that nothing touches stand farther and farther apart.
//!
//! Angles of all nodes divide the integral into equal parts; each load step takes those that are as far apart as h_k lets them.

use std::f64::consts::{PI, TAU};

use super::numbers::Numbers;
use stickslip_engine::results::{EdgeGeometry, EdgeKind, EdgeResults};

/// Growth of the spacing per length.
const GROWTH: f64 = 0.4;
/// How many times closer than elsewhere nodes of the coarsest model stand near places on a circle.
const SHARP: f64 = 4.0;
/// Extent of contact that coarse nodes resolve as wanted `[rad]`.
const WIDE: f64 = 2.0;
/// Nodes that a contact along a straight edge must have before nodes are graded by it.
const FEWEST: usize = 12;
/// Parts of a straight edge as long as nodes far from contact are apart.
const LINE: f64 = 32.0;
/// Steps of the integral per fine spacing.
const POINTS: f64 = 4.0;

/// What nodes stand along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Domain {
    /// A circle from 0 to π.
    HalfCircle,
    /// A circle all around.
    Circle,
    /// A straight edge between two places `[mm]`.
    Line([f64; 2]),
}

impl Domain {
    /// That of a contact edge.
    pub(super) fn of(geometry: &EdgeGeometry) -> Self {
        match (geometry.kind, geometry.half, geometry.parameter.as_slice()) {
            (EdgeKind::Line | EdgeKind::Path, _, &[first, .., last]) => Self::Line([first, last]),
            (_, true, _) => Self::HalfCircle,
            (_, false, _) => Self::Circle,
        }
    }

    fn ends(self) -> [f64; 2] {
        match self {
            Self::HalfCircle => [0.0, PI],
            Self::Circle => [0.0, TAU],
            Self::Line(ends) => ends,
        }
    }

    fn is_line(self) -> bool {
        matches!(self, Self::Line(_))
    }
}

/// How nodes are graded in a history.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Grading {
    domain: Domain,
    /// Spacing of nodes where nothing touches, and the largest one of all nodes `[rad or mm]`.
    widest: f64,
    coarse: f64,
    /// Where nodes are closer, in each load step.
    steps: Vec<Vec<Place>>,
}

impl Grading {
    /// That of the model `rung` after the places of `level`, one that is no finer, and their images if `mirrored`; `widest` is the spacing of the first model `[rad]`. Spacings are from rung to
    /// rung a quarter near places and half elsewhere, for errors fall with the root of the one and the square of the other; on circles those near places are [`SHARP`] times smaller from the coarsest on.
    pub(super) fn new(
        level: &Numbers,
        domain: Domain,
        (rung, widest): (usize, f64),
        mirrored: bool,
    ) -> Self {
        let [fine, coarse] = [4.0, 2.0_f64].map(|ratio| widest / ratio.powi(rung as i32));
        let fine = if domain.is_line() { fine } else { fine / SHARP };
        let own: Vec<StepPlaces> = (0..level.steps.len())
            .map(|step| StepPlaces::of(level, domain, step, coarse))
            .collect();
        let places = |step: usize| {
            let mut places: Vec<Place> = Vec::new();
            let since = |before: &usize| (step - before).saturating_sub(1);
            for before in (0..=step).rev().take_while(|before| since(before) < 32) {
                let spacing = fine * f64::from(1_u32 << since(&before));
                if spacing >= coarse && since(&before) > 0 {
                    break;
                }
                let changes = own[before].changes.iter();
                let between = |(ends, scale): &([f64; 2], f64)| {
                    Place::between(domain, *ends, scale * spacing)
                };
                places.extend(changes.map(between));
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
        let limit = |limit: f64| match domain {
            Domain::Line([from, to]) => (to - from) / LINE,
            _ => limit,
        };
        Self {
            domain,
            widest: limit(widest),
            coarse: limit(coarse),
            steps: (0..own.len()).map(places).collect(),
        }
    }

    /// Whether every contact of `level` along a straight edge has nodes enough to be graded by.
    pub(super) fn resolves(level: &Numbers) -> bool {
        let touching = |results: &EdgeResults| {
            results
                .rows
                .iter()
                .filter(|row| row.status.touches())
                .count()
        };
        let edges = level.own.iter().flatten().zip(level.steps.iter().flatten());
        let mut lines = edges.filter(|(own, _)| own.contact && Domain::of(own).is_line());
        lines.all(|(_, results)| !(1..FEWEST).contains(&touching(results)))
    }

    /// Angles of all nodes from 0 to π of a half model, or all around; places along a straight edge.
    pub(super) fn angles(&self) -> Vec<f64> {
        let places: Vec<Place> = self.steps.iter().flatten().copied().collect();
        let all = |domain| angles(domain, |angle| spacing(&places, angle, self.coarse));
        match self.domain {
            // Loads to the left and to the right have equal nodes.
            Domain::Line([from, to]) if from < 0.0 => {
                let right = all(Domain::Line([0.0, to]));
                let left = right.iter().skip(1).rev().map(|place| -place);
                left.chain(right.iter().copied()).collect()
            }
            domain => all(domain),
        }
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

/// Angles or places all along `domain` at the distances `spacing`.
fn angles(domain: Domain, spacing: impl Fn(f64) -> f64) -> Vec<f64> {
    let [start, end] = domain.ends();
    // The integral, walked in steps of a part of the spacing itself.
    let mut walk = vec![[start, 0.0]];
    let (mut angle, mut count) = (start, 0.0);
    while angle < end {
        let width = spacing(angle);
        let step = (width / POINTS).min(end - angle);
        let middle = spacing(angle + 0.5 * step);
        angle += step;
        count += step / middle;
        if end - angle < 1e-12 * (end - start) {
            angle = end;
        }
        walk.push([angle, count]);
    }
    let parts = match domain {
        Domain::Circle => (0.5 * count).ceil() * 2.0,
        Domain::HalfCircle | Domain::Line(_) => count.ceil(),
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
    if domain == Domain::Circle {
        angles.pop();
    } else if let Some(last) = angles.last_mut() {
        *last = end;
    }
    angles
}

/// Angles where nodes are closer.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Place {
    middle: f64,
    reach: f64,
    spacing: f64,
    /// Whether angles go around.
    is_round: bool,
}

impl Place {
    fn between(domain: Domain, [from, to]: [f64; 2], spacing: f64) -> Self {
        let is_round = !domain.is_line();
        let width = if is_round {
            (to - from).rem_euclid(TAU)
        } else {
            to - from
        };
        Self {
            middle: from + 0.5 * width,
            reach: 0.5 * width,
            spacing,
            is_round,
        }
    }

    fn mirrored(&self) -> Self {
        Self {
            middle: -self.middle,
            ..*self
        }
    }

    fn distance(&self, angle: f64) -> f64 {
        let away = if self.is_round {
            let away = (angle - self.middle).rem_euclid(TAU);
            away.min(TAU - away)
        } else {
            (angle - self.middle).abs()
        };
        (away - self.reach).max(0.0)
    }
}

/// Where contact changes and where there is contact at the end of a load step.
struct StepPlaces {
    /// Angles between which the status changes, and the length of an angle of 1: along a straight edge the half extent of contact.
    changes: Vec<([f64; 2], f64)>,
    contacts: Vec<Place>,
}

impl StepPlaces {
    /// Those of `level`, where an extended contact wants the spacing `coarse`.
    fn of(level: &Numbers, domain: Domain, step: usize, coarse: f64) -> Self {
        let (mut changes, mut contacts) = (Vec::new(), Vec::new());
        let edges = level.own[step].iter().zip(&level.steps[step]);
        for (geometry, results) in edges.filter(|(geometry, _)| geometry.contact) {
            let at = |k: usize| geometry.parameter[k % geometry.parameter.len()];
            let rows = &results.rows;
            let count = rows.len();
            let last = if domain == Domain::Circle {
                count
            } else {
                count - 1
            };
            // Contact all around, or in several pieces, has no extent.
            let extent = results.contact_half_extent;
            let touching: Vec<bool> = rows.iter().map(|row| row.status.touches()).collect();
            let (scale, spacing) = if domain.is_line() {
                let reach = half_reach(&geometry.parameter, &touching);
                let scale = extent.unwrap_or(0.0).max(reach);
                (scale, coarse * 2.0 * scale / WIDE)
            } else {
                let part = extent.map_or(1.0, |extent| (2.0 * extent / WIDE).min(1.0));
                (1.0, coarse * part)
            };
            let ends = (0..last).filter(|k| rows[*k].status != rows[(k + 1) % count].status);
            changes.extend(ends.map(|k| ([at(k), at(k + 1)], scale)));
            let mut from = 0;
            for run in touching.chunk_by(|one, other| one == other) {
                let to = from + run.len();
                if run[0] && run.len() == count && domain == Domain::Circle {
                    contacts.push(Place {
                        middle: 0.0,
                        reach: PI,
                        spacing,
                        is_round: true,
                    });
                } else if run[0] {
                    contacts.push(Place::between(
                        domain,
                        [at(from), at(to.min(last))],
                        spacing,
                    ));
                }
                from = to;
            }
        }
        Self { changes, contacts }
    }
}

/// Half of the distance between the nodes that stand next to the first and to the last touching one, which contact cannot reach beyond.
fn half_reach(places: &[f64], touching: &[bool]) -> f64 {
    let first = touching.iter().position(|touches| *touches);
    let (Some(first), Some(last)) = (first, touching.iter().rposition(|touches| *touches)) else {
        return 0.0;
    };
    0.5 * (places[(last + 1).min(places.len() - 1)] - places[first.saturating_sub(1)])
}

#[cfg(test)]
mod tests {
    use super::*;

    const DEGREE: f64 = PI / 180.0;

    /// Ends of contact at 40° in the first step and at 80° in the second, known to a tenth of a degree.
    fn grading(domain: Domain) -> Grading {
        let between = |ends: [f64; 2], spacing| {
            Place::between(domain, ends.map(|at| at * DEGREE), spacing * DEGREE)
        };
        let end = |at: f64| between([at, at + 0.1], 0.1);
        let contact = |to: f64| between([0.0, to], 0.75);
        Grading {
            domain,
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
        for domain in [Domain::HalfCircle, Domain::Circle] {
            let half = domain == Domain::HalfCircle;
            let grading = grading(domain);
            let angles = grading.angles();
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
        let grading = grading(Domain::HalfCircle);
        let angles = grading.angles();
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
