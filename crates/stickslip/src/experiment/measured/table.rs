//! Displacements from a table.

use stickslip_hybrid::data::{DataError, Field, Measurement};

use super::{Reading, Scope, scatter};
use crate::experiment::error::ExperimentError;
use crate::experiment::plan::TableSource;
use crate::experiment::synthesis::field_name;

/// A table as its source says, its origin moved to the body's, masked where it shows no specimen.
pub(super) fn read(scope: &Scope<'_>, source: &TableSource) -> Result<Reading, ExperimentError> {
    let bytes = scope.bytes(&source.file)?;
    let name = source.file.display().to_string();
    let mut measurement = Measurement::read(&bytes[..], &name, &source.format, &source.reading)
        .map_err(|cause| scope.data(cause))?;
    let scale = source.reading.scale.unwrap_or(1.0);
    let upright = source.reading.y_axis == stickslip_hybrid::data::YAxis::Up;
    let down = if upright { 1.0 } else { -1.0 };
    let shift = [scale * source.origin[0], down * scale * source.origin[1]];
    for place in &mut measurement.places {
        *place = [place[0] - shift[0], place[1] - shift[1]];
    }
    let places = measurement.places.clone();
    for field in Field::BOTH {
        measurement.mask(field, |k| {
            !(scope.shows(places[k]) && scope.is_away(places[k], 0.0))
        });
    }
    if measurement.count(Field::U) + measurement.count(Field::V) == 0 {
        return Err(scope.data(DataError::AllMasked {
            file: name,
            rows: measurement.places.len(),
            remedy: "all its points lie in the hole or under a mask: check scale, origin and y_axis",
        }));
    }
    let mut remarks = Vec::new();
    for field in Field::BOTH {
        measurement.deviation[field.component()] = match source.deviation {
            Some(deviation) => deviation,
            None => estimated(scope, &measurement, field, &mut remarks)?,
        };
    }
    Ok(Reading::Scattered {
        measurement,
        remarks,
    })
}

fn estimated(
    scope: &Scope<'_>,
    measurement: &Measurement,
    field: Field,
    remarks: &mut Vec<String>,
) -> Result<f64, ExperimentError> {
    if measurement.count(field) == 0 {
        return Ok(0.0);
    }
    let found = scatter::deviation(measurement, field);
    let deviation = found.map_err(|cause| ExperimentError::Reduction {
        state: scope.name(),
        key: scope.key.clone(),
        cause: Box::new(cause),
    })?;
    let length = scope.experiment.display.length;
    remarks.push(format!(
        "deviation of {} estimated from the scatter of neighbours: {}",
        field_name(field),
        length.show(deviation)
    ));
    Ok(deviation)
}
