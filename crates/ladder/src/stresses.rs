//! Errors of the largest stresses of bodies: as those of loads of failure, k max(|v₂ − v₁|, r |v₁ − v₀|) with k = 4, the part by which the load path and the geometry leave the stresses
//! of the step, and what nodes have more in cells across the circles that are left out around places without a bound.

use super::failure::{left, part};
use stickslip_engine::results::{BodyStresses, Results, StressPeak};

/// Largest stresses inside of elements are off by so many times what loads of failure are.
const WIDER: f64 = 4.0 / 3.0;
/// Part of the largest stress of the history that rounding may leave.
const ROUNDING: f64 = 1e-12;

/// Puts errors into the largest stresses of `found`, by those of the coarser models `before`, the next finest first. `parts` are those by which load path and geometry leave a
/// stress of each step; `has_limit` says whether the stress at a place of a body has one.
pub(super) fn estimate_all(
    found: &mut Results,
    before: &[Results],
    parts: &[f64],
    has_limit: impl Fn(usize, [f64; 2]) -> bool,
) {
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
                let error = WIDER * left(peak.stress, &before)? + path + peak.beyond;
                let error = error.max(ROUNDING * largest);
                (error.is_finite() && has_limit(own.body, peak.at)).then_some(error)
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
