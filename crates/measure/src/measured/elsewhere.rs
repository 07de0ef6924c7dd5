//! Data that were measured elsewhere, as text.

use stickslip_hybrid::data::{Measurement, NullField};

use super::Scope;
use crate::ends::ends;
use crate::error::ExperimentError;
use stickslip_text::short;

/// A null field that was measured elsewhere.
pub(super) fn elsewhere(
    scope: &Scope<'_>,
    own: &Measurement,
    null: &Measurement,
    how: NullField,
) -> ExperimentError {
    let length = scope.experiment.display.length;
    let (places, remedy) = match how {
        NullField::SamePlaces { tolerance } => (
            format!(
                "within common_places = {} of each other: the nearest are {} apart",
                length.show(tolerance),
                length.show(nearest(own, null))
            ),
            "leave common_places out, so that the null field is interpolated, or make it larger if places are the same",
        ),
        NullField::Interpolated { .. } => (
            format!(
                "inside of those of the null field: the state's are {}, the null field's {}",
                extent(scope, own),
                extent(scope, null)
            ),
            "check scale, origin and y_axis of both tables; longest_side must be more than the distance of neighbours",
        ),
    };
    ExperimentError::Missing {
        key: format!("{}.null", scope.key),
        what: format!("state '{}': no valid places {places}", scope.name()),
        remedy: remedy.to_owned(),
    }
}

/// Distance of the nearest places of some of `own` and all of `null` `[mm]`.
fn nearest(own: &Measurement, null: &Measurement) -> f64 {
    const SOME: usize = 500;
    let stride = own.places.len().div_ceil(SOME).max(1);
    let some = own.places.iter().step_by(stride);
    let distances = some.flat_map(|[x, y]| {
        let others = null.places.iter();
        others.map(move |other| (other[0] - x).hypot(other[1] - y))
    });
    distances.fold(f64::INFINITY, f64::min)
}

/// The rectangle of valid places as text.
pub(super) fn extent(scope: &Scope<'_>, data: &Measurement) -> String {
    let valid = |k: &usize| data.valid[0][*k] || data.valid[1][*k];
    let unit = scope.experiment.display.length;
    let [x, y] = [0, 1].map(|axis| {
        let valid = (0..data.places.len()).filter(valid);
        let bounds = ends(valid.map(|k| data.places[k][axis]));
        let [low, high] = bounds.map(|value| short(unit.from_base(value)));
        format!("{low} … {high} {}", unit.name)
    });
    format!("at x = {x}, y = {y}")
}
