//! Slip that nodes are too few to show.
//!
//! A change ΔQ of the force along a line contact under the normal force P makes the ends of contact slip, by Cattaneo and Mindlin over a width of a ΔQ/2μP. Where hardly a node
//! slips all models agree on a contact that sticks, and the stress at its trailing edge is off by
//!
//! ```text
//! 2 μ p₀ √(ΔQ/μP),     after a reversal √2 times that
//! ```

use stickslip_contact::Status;

use super::numbers::{Numbers, Table};
use stickslip_engine::results::{EdgeKind, Errors, Stated};

/// Fewer nodes that slip do not resolve it.
const FEWEST: usize = 4;
/// Part of the normal force up to which a change of the force along the contact is rounding.
const ROUNDING: f64 = 1e-9;
/// Times p₀ √(μ ΔQ/P).
const REVERSED: f64 = 3.0;

/// Widens in `errors` that of the peak stress of `level` where slip does not show; `friction` is what an edge holds under a pressure, as a part of it.
pub(super) fn widen(errors: &mut Table, level: &Numbers, friction: impl Fn(usize, f64) -> f64) {
    let lines = level.geometries.iter().enumerate();
    for (edge, _) in lines.filter(|(_, own)| own.contact && own.kind == EdgeKind::Line) {
        let (mut before, mut kept) = (0.0, 0.0);
        for (errors, step) in errors.iter_mut().zip(&level.steps) {
            let results = &step[edge];
            let (peak, normal) = (
                results.peak_pressure.map_or(0.0, |(peak, _)| peak),
                results.normal_force.abs(),
            );
            let change = (results.resultant[0] - before).abs();
            before = results.resultant[0];
            let slips = |status| matches!(status, Status::SlipPositive | Status::SlipNegative);
            let slipping = results.rows.iter().filter(|row| slips(row.status)).count();
            if change > ROUNDING * normal && normal > 0.0 {
                kept = if slipping < FEWEST {
                    REVERSED * peak * (friction(edge, peak) * change / normal).sqrt()
                } else {
                    0.0
                };
            }
            let own = errors[edge].clone();
            errors[edge] = Errors::of(|stated| match stated {
                Stated::PeakHoop => Some(own.get(stated)?.max(kept)),
                _ => own.get(stated),
            });
        }
    }
}
