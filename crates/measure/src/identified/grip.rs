//! The lower bound of static friction, from places that stick.
//!
//! ```text
//! μ_s ≥ s τ/p wherever the edge sticks;     bound = max over stretches W of  min over k in W of (s τ_k/p_k − q σ_k)
//! ```
//!
//! Where slip ends the shear bends sharply, and both cells and smoothing overshoot beside such a bend, on the side that slips, by several
//! per cent and over up to 2.7 times the angle that the edge resolves (the response of the smoothing's kernel to a step,
//! 1 − ½ e^(−x) cos x, overshoots over a width of π where its reach is 3π/4, which is two such angles). Such a place lies where static
//! friction would show. So places within [`MARGIN`] resolved angles of a slip zone are left out, as they are of the zone itself, and a
//! ratio counts only if it is exceeded all along a stretch of [`STRETCH`] resolved angles, which is wider than an overshoot. q is the
//! quantile of the largest of all errors together, because the largest of many ratios has the largest of many errors.

use std::collections::BTreeMap;
use std::ops::Range;

use stickslip_hybrid::identify::{IdentifyError, Tractions, simultaneous_quantile};

use super::zone::SlipZone;
use crate::analysed::Analysed;
use stickslip_experiment::Identify;

/// Resolved angles at either end of a slip zone whose stresses cannot be trusted: tractions and their derivatives jump there.
pub(super) const MARGIN: f64 = 2.0;
/// Resolved angles along which a ratio must be exceeded.
const STRETCH: f64 = 4.0;

/// A stretch that sticks at ratios which need static friction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grip {
    /// Index of the state.
    pub state: usize,
    /// First and last angle of the stretch `[rad]`.
    pub angles: [f64; 2],
    /// The least τ/p along it `[1]`, in the direction of friction of the zone beside it.
    pub ratio: f64,
    /// μ_s is at least this `[1]`.
    pub at_least: f64,
}

/// Places of a state that may show static friction, beside one of its slip zones.
struct Candidates<'a> {
    state: usize,
    angle: &'a [f64],
    resolution: f64,
    tractions: &'a Tractions,
    sign: f64,
    places: Range<usize>,
}

/// The stretch that asks for the greatest static coefficient; `None` where no slip zone leaves one wide enough.
///
/// # Errors
/// [`IdentifyError::Covariance`] for ratios without scatter.
pub(super) fn grip(
    plan: &Identify,
    analysed: &[Analysed],
    zones: &[SlipZone],
) -> Result<Option<Grip>, IdentifyError> {
    let beside = zones.iter().filter_map(|zone| {
        let found = analysed.iter().find(|found| found.state == zone.state)?;
        Candidates::beside(found, zone)
    });
    greatest(&beside.collect::<Vec<_>>(), plan.confidence, plan.seed)
}

/// Tractions of a state, and the places asked for with the sign of their shear.
type Asked<'a> = (&'a Tractions, Vec<(usize, f64)>);

/// The stretch of `all` with the greatest bound, by errors that stay below theirs together with the probability `confidence`.
fn greatest(
    all: &[Candidates<'_>],
    confidence: f64,
    seed: u64,
) -> Result<Option<Grip>, IdentifyError> {
    let mut states: BTreeMap<usize, Asked<'_>> = BTreeMap::new();
    for own in all.iter().filter(|own| own.stretches().next().is_some()) {
        let places = own.places.clone().map(|place| (place, own.sign));
        let (_, of_state) = (states.entry(own.state)).or_insert((own.tractions, Vec::new()));
        of_state.extend(places);
    }
    let covariances = states.values().map(|(data, own)| covariance(data, own));
    let covariances: Vec<Vec<f64>> = covariances.collect();
    let quantile = simultaneous_quantile(&covariances, confidence, seed)?;
    let grips = all.iter().flat_map(|own| {
        own.stretches()
            .map(move |stretch| own.exceeded(stretch, quantile))
    });
    Ok(grips.max_by(|a, b| a.at_least.total_cmp(&b.at_least)))
}

impl<'a> Candidates<'a> {
    /// What lies inside of `zone`, clear of where slip may end.
    fn beside(found: &'a Analysed, zone: &SlipZone) -> Option<Self> {
        let (angle, inside) = (&found.angle, &zone.inside);
        if inside.is_empty() {
            return None;
        }
        let margin = MARGIN * found.resolution * (1.0 - 1e-6);
        let places = if inside.start >= zone.places.end {
            let first = angle[inside.start] + margin;
            angle.partition_point(|a| *a < first).min(inside.end)..inside.end
        } else {
            let last = angle[inside.end - 1] - margin;
            inside.start..angle.partition_point(|a| *a <= last).max(inside.start)
        };
        Some(Self {
            state: found.state,
            angle,
            resolution: found.resolution,
            tractions: &found.tractions,
            sign: if zone.positive { 1.0 } else { -1.0 },
            places,
        })
    }

    /// The shortest stretches that are wide enough, one from each place that has one.
    fn stretches(&self) -> impl Iterator<Item = Range<usize>> + '_ {
        let (angle, width) = (self.angle, STRETCH * self.resolution * (1.0 - 1e-6));
        self.places.clone().filter_map(move |first| {
            let last = angle.partition_point(|a| *a < angle[first] + width);
            (last < self.places.end).then_some(first..last + 1)
        })
    }

    /// What is exceeded all along a stretch, where all errors stay below `quantile` standard deviations.
    fn exceeded(&self, stretch: Range<usize>, quantile: f64) -> Grip {
        let angles = [stretch.start, stretch.end - 1].map(|place| self.angle[place]);
        let least = |of: &dyn Fn(f64, f64) -> f64| {
            let each = stretch.clone().map(|place| {
                let (ratio, deviation) = self.tractions.ratio(place);
                of(self.sign * ratio, deviation)
            });
            each.fold(f64::INFINITY, f64::min)
        };
        Grip {
            state: self.state,
            angles,
            ratio: least(&|ratio, _| ratio),
            at_least: least(&|ratio, deviation| ratio - quantile * deviation),
        }
    }
}

/// Covariance of the ratios s τ/p at `places`, each with its direction s of friction, to first order; row by row.
fn covariance(data: &Tractions, places: &[(usize, f64)]) -> Vec<f64> {
    let n = data.pressure.len();
    let entry = |i: usize, j: usize| data.covariance[i * 2 * n + j];
    let ratio = |place: usize| data.shear[place] / data.pressure[place];
    let pair = |&(i, a): &(usize, f64), &(j, b): &(usize, f64)| {
        let (first, second) = (ratio(i), ratio(j));
        let sum = entry(n + i, n + j) - second * entry(n + i, j) - first * entry(i, n + j)
            + first * second * entry(i, j);
        a * b * sum / (data.pressure[i] * data.pressure[j])
    };
    (places.iter())
        .flat_map(|first| places.iter().map(move |second| pair(first, second)))
        .collect()
}

#[cfg(test)]
mod tests {
    use rand::rngs::StdRng;
    use rand::{RngExt, SeedableRng};

    use super::*;

    const PLACES: usize = 41;
    /// Of 1° at places half a degree apart.
    const RESOLUTION: f64 = 1.0;

    fn bound(ratio: impl Fn(f64) -> f64, noise: f64, seed: u64) -> f64 {
        let mut random = StdRng::seed_from_u64(seed);
        let mut normal = || (0..12).map(|_| random.random::<f64>()).sum::<f64>() - 6.0;
        let angle: Vec<f64> = (0..PLACES).map(|k| 0.5 * k as f64).collect();
        let pressure = vec![100.0; PLACES];
        // Errors of neighbours are correlated: each is the mean of two.
        let errors: Vec<f64> = (0..=PLACES).map(|_| noise * normal()).collect();
        let shear = (angle.iter().zip(errors.windows(2)))
            .map(|(&angle, own)| 100.0 * ratio(angle) + (own[0] + own[1]) / 2.0_f64.sqrt())
            .collect();
        let size = 2 * PLACES;
        let entry = |i: usize, j: usize| match i.abs_diff(j) {
            _ if i.min(j) < PLACES && i != j => 0.0,
            0 if i < PLACES => 1e-6,
            0 => noise * noise,
            1 => 0.5 * noise * noise,
            _ => 0.0,
        };
        let tractions = Tractions {
            pressure,
            shear,
            covariance: (0..size * size)
                .map(|at| entry(at / size, at % size))
                .collect(),
        };
        let own = Candidates {
            state: 0,
            angle: &angle,
            resolution: RESOLUTION,
            tractions: &tractions,
            sign: 1.0,
            places: 0..PLACES,
        };
        greatest(&[own], 0.95, seed).unwrap().unwrap().at_least
    }

    #[test]
    fn a_stretch_that_sticks_at_a_larger_ratio_bounds_static_friction() {
        let found = bound(
            |angle| {
                if (5.0..12.0).contains(&angle) {
                    0.3
                } else {
                    0.2
                }
            },
            0.5,
            1,
        );
        assert!((0.25..0.3).contains(&found), "{found}");
    }

    #[test]
    fn what_is_no_wider_than_an_overshoot_bounds_nothing() {
        let lobe = |angle: f64| {
            let inside = (8.0..10.7).contains(&angle);
            0.2 + if inside { 0.02 } else { 0.0 }
        };
        let found = bound(lobe, 0.1, 1);
        assert!(found < 0.2, "{found}");
    }

    #[test]
    fn the_bound_holds_where_all_places_stick_at_the_coefficient() {
        let wrong = (1..=200).filter(|&seed| bound(|_| 0.2, 0.5, seed) > 0.2);
        assert!(wrong.count() <= 10);
    }
}
