//! Fringe centres along lines.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{DataError, Field, FringeLines};

use super::combine::grating;
use super::{Measured, Reading, Scope};
use crate::experiment::error::ExperimentError;
use crate::experiment::plan::LineSource;

/// The fringe lines of both fields.
pub(super) fn read(scope: &Scope<'_>, source: &LineSource) -> Result<Reading, ExperimentError> {
    let of = |field: Field| {
        let file = &source.files[field.component()];
        let bytes = scope.bytes(file)?;
        let name = file.display().to_string();
        let reading = &source.reading[field.component()];
        FringeLines::read(&bytes[..], &name, field, reading).map_err(|cause| scope.data(cause))
    };
    Ok(Reading::Lines(
        [of(Field::U)?, of(Field::V)?],
        source.deviation,
    ))
}

/// Places of a component's own centres carry that component alone.
pub(super) fn fringe_lines(
    scope: &Scope<'_>,
    measured: &mut Measured,
    lines: [FringeLines; 2],
    deviation: f64,
) -> Result<(), ExperimentError> {
    let grating = grating(scope)?;
    measured.floor = [grating.displacement(deviation); 2];
    let field = &mut measured.measurement;
    field.deviation = measured.floor;
    let mut seen: Vec<Point> = Vec::new();
    for own in &lines {
        let c = own.field.component();
        for line in &own.lines {
            for (&place, &order) in line.places().iter().zip(line.orders()) {
                let valid = scope.shows(place) && scope.is_away(place, 0.0);
                seen.push(place);
                field.places.push(place);
                for axis in 0..2 {
                    let mine = axis == c && valid;
                    let value = grating.displacement(order);
                    field.displacements[axis].push(if mine { value } else { f64::NAN });
                    field.valid[axis].push(mine);
                }
            }
        }
    }
    if field.valid.iter().flatten().all(|valid| !valid) {
        return Err(scope.data(DataError::AllMasked {
            file: "fringe lines".to_owned(),
            rows: seen.len(),
            remedy: "all centres lie in the hole or under a mask: check scale and y_axis",
        }));
    }
    measured.lines = Some(lines);
    Ok(())
}

/// Fringe lines with those of the null field taken off.
pub(super) fn less_null(
    scope: &Scope<'_>,
    measured: &mut Measured,
    lines: &[FringeLines; 2],
    null: &[FringeLines; 2],
) -> Result<[FringeLines; 2], ExperimentError> {
    let mut less = |k: usize| -> Result<FringeLines, ExperimentError> {
        let found = lines[k]
            .minus(&null[k])
            .map_err(|cause| scope.data(cause))?;
        if !found.left_out.is_empty() {
            let (line, place) = &found.left_out[0];
            measured.remarks.push(format!(
                "{} fringe centres lie beyond the null field's lines and are left out, the first of line '{line}' at ({}, {}) mm",
                found.left_out.len(),
                place[0],
                place[1]
            ));
        }
        Ok(found.lines)
    };
    Ok([less(0)?, less(1)?])
}
