//! Compares the direction in which the edge bears with the stated one.
//!
//! ```text
//! F_p = ∫ p e_r dθ,   F = ∫ (p e_r − τ e_θ) dθ   over the edge in sight
//! ```
//!
//! Of a contact that is wholly in sight F has the direction of the bearing point, and so has F_p where friction is alike on both sides. Of
//! one that the region cuts, pressure that does not grow away from the bearing point leaves F_p between there and the middle of the
//! contact in sight, which a pressure that is the same all over has. Friction, a pin that is softer than the hole, and laminates move it a
//! little; the direction nearer to the stated one counts.

use std::f64::consts::{PI, TAU};
use std::ops::Range;

use super::Analysed;
use super::edge::CONTACT;
use stickslip_engine::results::wrapped;

/// Angle by which friction, pin and material may move the direction, beside three standard deviations `[rad]`.
const ALLOWED: [f64; 2] = [12.0 * PI / 180.0, 3.0];
/// Largest angle between the bearing point and an end of contact `[rad]`.
const WIDEST: f64 = 110.0 * PI / 180.0;

/// What of an edge's contact is in sight.
#[derive(Clone, Debug)]
pub(super) struct Sight {
    /// Places that can be trusted.
    pub(super) places: Range<usize>,
    /// First and last of them in contact `[rad]`.
    pub(super) contact: [f64; 2],
    /// Whether contact ends there.
    pub(super) ends: [bool; 2],
}

/// The direction of the force on an edge against the bearing point that is stated or assumed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BearingCheck {
    /// The bearing point that slip zones are counted from `[rad]`.
    pub bearing: f64,
    /// Direction of the pressure's force on the edge in sight `[rad]`, or of the force with its shear where that is nearer.
    pub direction: f64,
    /// Its standard deviation `[rad]`.
    pub deviation: f64,
    /// Angle by which it lies beyond what the bearing point can make of the contact in sight `[rad]`.
    pub beyond: f64,
    /// Whether all of the contact is in sight, so that it bears in this direction.
    pub is_whole: bool,
}

impl BearingCheck {
    /// Whether neither noise nor friction explains the direction.
    pub fn fails(&self) -> bool {
        self.beyond > ALLOWED[0] + ALLOWED[1] * self.deviation
    }
}

impl Analysed {
    /// What is in sight; `None` without contact, and where noise may hide the greater part of it.
    pub(super) fn sight(&self) -> Option<Sight> {
        let places = self.inner();
        let (_, peak) = self.clear_contact()?;
        let [deviation, _] = self.deviations();
        let pressure = &self.tractions.pressure;
        let bears = |k: &usize| pressure[*k] > (CONTACT[0] * deviation[*k]).max(CONTACT[1] * peak);
        let first = places.clone().find(bears)?;
        let last = places.clone().rev().find(bears)?;
        Some(Sight {
            contact: [first, last].map(|k| self.angle[k]),
            ends: [first > places.start, last + 1 < places.end],
            places,
        })
    }

    /// Angle that stands for each of `places` in a sum over the edge `[rad]`.
    pub(super) fn widths(&self, places: &Range<usize>) -> Vec<f64> {
        let at = |k: usize| self.angle[k.clamp(places.start, places.end - 1)];
        places
            .clone()
            .map(|k| 0.5 * (at(k + 1) - at(k.saturating_sub(1))))
            .collect()
    }

    /// Compares the direction of the force on the edge with the bearing point that is `stated` `[rad]`, or else assumed; `None` where the contact
    /// does not show.
    pub fn bearing_check(&self, stated: Option<f64>) -> Option<BearingCheck> {
        let sight = self.sight()?;
        let bearing = self.bearing(&self.contact()?, stated);
        let range = sight.range(&self.angle, bearing);
        let is_whole = sight.ends == [true; 2];
        let checks = [0.0, 1.0].map(|shear| {
            let [direction, deviation] = self.direction(&sight.places, shear);
            let off = wrapped(direction - bearing);
            BearingCheck {
                bearing,
                direction,
                deviation,
                beyond: (range[0] - off).max(off - range[1]).max(0.0),
                is_whole,
            }
        });
        let beyond = |own: &BearingCheck| own.beyond - ALLOWED[1] * own.deviation;
        checks
            .into_iter()
            .min_by(|a, b| beyond(a).total_cmp(&beyond(b)))
    }

    /// Direction of ∫(p e_r − s τ e_θ) dθ over `places`, s being `shear`, and its standard deviation `[rad]`.
    fn direction(&self, places: &Range<usize>, shear: f64) -> [f64; 2] {
        let n = self.angle.len();
        let widths = self.widths(places);
        let each = || places.clone().zip(&widths);
        let force = self.force(each().map(|(k, width)| (k, *width)), shear);
        let direction = force[1].atan2(force[0]);
        let size = force[0].hypot(force[1]);
        let rows: Vec<(usize, f64)> = each()
            .flat_map(|(k, width)| {
                let (s, c) = (self.angle[k] - direction).sin_cos();
                [(k, width * s), (n + k, -shear * width * c)]
            })
            .collect();
        [direction, self.deviation_of(&rows) / size]
    }

    /// Sum of (p e_r − s τ e_θ) Δθ over places and their angles Δθ, s being `shear`.
    pub(super) fn force(&self, places: impl Iterator<Item = (usize, f64)>, shear: f64) -> [f64; 2] {
        let own = &self.tractions;
        places.fold([0.0, 0.0], |[x, y], (k, width)| {
            let (s, c) = self.angle[k].sin_cos();
            let [p, t] = [own.pressure[k], shear * own.shear[k]].map(|stress| stress * width);
            [x + p * c + t * s, y + p * s - t * c]
        })
    }

    /// Standard deviation of a sum of tractions: of pressures, then of shears.
    pub(super) fn deviation_of(&self, row: &[(usize, f64)]) -> f64 {
        let all = 2 * self.angle.len();
        let covariance = &self.tractions.covariance;
        let of = |(i, a): &(usize, f64)| -> f64 {
            let sum: f64 = row.iter().map(|(j, b)| b * covariance[i * all + j]).sum();
            a * sum
        };
        row.iter().map(of).sum::<f64>().max(0.0).sqrt()
    }
}

impl Sight {
    /// Angle from the bearing point, by whole turns the nearest to the middle of what is in sight.
    pub(super) fn turned(&self, angle: &[f64], bearing: f64) -> impl Fn(f64) -> f64 + use<> {
        let middle = 0.5 * (angle[self.places.start] + angle[self.places.end - 1]);
        let nearest = middle - wrapped(middle - bearing);
        move |at| at - nearest
    }

    /// Directions from the bearing point that a contact can have which bears there `[rad]`.
    fn range(&self, angle: &[f64], bearing: f64) -> [f64; 2] {
        let from = self.turned(angle, bearing);
        let [first, last] = self.contact.map(from);
        // Contact goes as far on either side.
        let half = match self.ends {
            [true, true] => return [0.0; 2],
            [false, true] => last,
            [true, false] => -first,
            [false, false] if last - first > TAU - WIDEST => return [0.0; 2],
            [false, false] => WIDEST,
        };
        let half = half.min(WIDEST);
        let (first, last) = (first.max(-half), last.min(half));
        // Contact ends before the bearing point, or begins beyond its reach.
        if first > last {
            return [0.0; 2];
        }
        let middle = 0.5 * (first + last);
        [middle.min(0.0), middle.max(0.0)]
    }
}
