//! Fringe centres along lines.

use stickslip_hybrid::data::{Field, FringeLines};

use super::{Reading, Scope};
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
