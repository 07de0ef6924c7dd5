//! The error that is largest beside what is asked.

use stickslip_engine::results::{EdgeResults, Stated};
use stickslip_scene::schema::Accuracy;

use super::numbers::{Numbers, Table, balanced_friction};

/// Numbers below this part of the largest of their history are measured by it.
const SMALL: f64 = 1e-3;
/// A relative error beside its bound.
#[derive(Clone, Copy)]
pub(super) struct Worst {
    error: f64,
    stated: Stated,
    /// The error over its bound.
    pub(super) part: f64,
}

impl Worst {
    pub(super) fn named(self) -> (f64, Stated) {
        (self.error, self.stated)
    }
}

/// The relative error that is largest beside its bound of `accuracy`; of contacts, or where there are none of all edges.
pub(super) fn worst(level: &Numbers, errors: &Table, accuracy: Accuracy) -> Option<Worst> {
    let steps = 0..level.steps.len();
    let all = steps.filter_map(|step| worst_of_step(level, errors, accuracy, step));
    all.max_by(|one, other| one.part.total_cmp(&other.part))
}

/// The same of the load step `step`. Stresses are measured by the larger of themselves and of the peak pressure, beside which σ_t may vanish, friction and stick by
/// the largest of their history, and friction by no less than what may balance itself.
pub(super) fn worst_of_step(
    level: &Numbers,
    errors: &Table,
    accuracy: Accuracy,
    step: usize,
) -> Option<Worst> {
    let touches = level.geometries.iter().any(|geometry| geometry.contact);
    let edges = level.geometries.iter().enumerate();
    let edges = edges.filter(|(_, geometry)| geometry.contact || !touches);
    let numbers = edges.flat_map(|(edge, _)| Stated::ALL.map(|stated| (edge, stated)));
    let part = |(edge, stated): (usize, Stated)| {
        let bound = stated.bound(accuracy)?;
        let error = errors.get(step)?.get(edge)?.get(stated)?;
        let size = |results: &EdgeResults| stated.value(results).map_or(0.0, f64::abs);
        let history = level.steps.iter().map(|step| size(&step[edge]));
        let largest = history.fold(0.0, f64::max);
        let own = &level.steps[step][edge];
        let scale = match stated {
            Stated::FrictionForce => {
                let held = level
                    .steps
                    .iter()
                    .map(|step| balanced_friction(&step[edge]));
                held.fold(largest, f64::max)
            }
            Stated::StickExtent => largest,
            Stated::PeakHoop | Stated::HoopAtBearing => {
                let pressure = Stated::PeakPressure.value(own).unwrap_or(0.0);
                size(own).max(SMALL * largest).max(pressure)
            }
            _ => size(own).max(SMALL * largest),
        };
        (scale > 0.0).then(|| Worst {
            error: error / scale,
            stated,
            part: error / scale / bound,
        })
    };
    let parts = numbers.filter_map(part);
    parts.max_by(|one, other| one.part.total_cmp(&other.part))
}
