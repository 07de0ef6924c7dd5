//! Errors of the largest stresses of bodies: as those of loads of failure, k max(|v₂ − v₁|, r |v₁ − v₀|) with k = 4 and with graded nodes 6, the part by which the load path and the geometry leave the stresses
//! of the step, and what nodes have more in cells across the circles that are left out around places without a bound.

use super::failure::{left, part};
use super::numbers::Numbers;
use stickslip_engine::model::Model;
use stickslip_engine::results::{BodyStresses, LoadValue, Results, Stated, StressPeak};
use stickslip_engine::run::{is_beside, is_unlimited};

/// Largest stresses of elements are off by so many times what loads of failure are.
const OF_ELEMENTS: f64 = 4.0 / 3.0;
/// The same where nodes are graded: few of them lie where a stress is largest.
const GRADED: f64 = 2.0;
/// Part of the largest stress of the history that rounding may leave.
const ROUNDING: f64 = 1e-12;

/// By what it is known whether a stress has a limit that finer models approach.
pub(super) struct Limits<'a> {
    pub(super) model: &'a Model,
    pub(super) numbers: &'a Numbers,
    /// Bodies of which finer models have some cells alone that are smaller.
    pub(super) uneven: &'a [usize],
    /// Whether nodes are graded.
    pub(super) is_graded: bool,
}

impl Limits<'_> {
    /// Whether the stress at the place `at` of `body` in scene coordinates has one in a step with `loads`.
    fn has_limit(&self, (step, loads): (usize, &[LoadValue]), body: usize, at: [f64; 2]) -> bool {
        let [x, y] = self.model.origin;
        let at = [at[0] - x, at[1] - y];
        let acts = |case: usize| loads.get(case).is_none_or(|load| load.value != 0.0);
        let is_open = self.uneven.contains(&body)
            || is_unlimited(self.model, body, at, acts)
            || self.is_beside_contact(step, body, at);
        !is_open
    }

    /// Whether `at` is beside a contact of `body` in which stress has no limit, or which rests on too few nodes.
    fn is_beside_contact(&self, step: usize, body: usize, at: [f64; 2]) -> bool {
        let mut edges = self.model.edges.iter().enumerate();
        edges.any(|(edge, own)| {
            let pair = own.pair.map(|pair| &self.model.pairs[pair]);
            let touches = pair.is_some_and(|pair| [pair.first, pair.second].contains(&body));
            let missing = self.numbers.missing[step][edge];
            let is_open = missing.concern(Stated::PeakHoop)
                || missing.concern(Stated::PeakPressure)
                || self.numbers.is_unresolved(step, edge);
            touches && is_open && is_beside(self.model, body, at, edge)
        })
    }
}

/// Puts errors into the largest stresses of `found`, by those of the coarser models `before`, the next finest first. `parts` are those by which load path and geometry leave a
/// stress of each step.
pub(super) fn estimate_all(
    found: &mut Results,
    before: &[Results],
    parts: &[f64],
    limits: &Limits<'_>,
) {
    let wider = if limits.is_graded {
        GRADED
    } else {
        OF_ELEMENTS
    };
    let all = found.steps.iter().flat_map(|step| &step.stresses);
    let largest = all.fold(0.0, |most: f64, own| most.max(own.von_mises.stress));
    for (step, record) in found.steps.iter_mut().enumerate() {
        for own in &mut record.stresses {
            let before: Vec<&BodyStresses> = (before.iter())
                .filter_map(|other| {
                    let mut all = other.steps.get(step)?.stresses.iter();
                    all.find(|other| other.body == own.body)
                })
                .collect();
            let error = |peak: &StressPeak, of: fn(&BodyStresses) -> StressPeak| {
                let before: Vec<f64> = before.iter().map(|other| of(other).stress).collect();
                let path = part(parts, step) * peak.stress.abs();
                let error = wider * left(peak.stress, &before)? + path + peak.beyond;
                let error = error.max(ROUNDING * largest);
                let has_limit = limits.has_limit((step, &record.loads), own.body, peak.at);
                (error.is_finite() && has_limit).then_some(error)
            };
            let errors = [
                error(&own.von_mises, |other| other.von_mises),
                error(&own.largest_principal, |other| other.largest_principal),
                error(&own.least_principal, |other| other.least_principal),
            ];
            let peaks = [
                &mut own.von_mises,
                &mut own.largest_principal,
                &mut own.least_principal,
            ];
            for (peak, error) in peaks.into_iter().zip(errors) {
                peak.error = error;
            }
        }
    }
}
