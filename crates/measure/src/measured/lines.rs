//! Fringe centres along lines.

use stickslip_hybrid::data::{DataError, Field, FringeLines, OffTrack};

use super::field::Measured;
use super::reading::{Digitised, Reading};
use super::rotation::of_lines;
use super::scope::Scope;
use crate::error::ExperimentError;
use crate::finding::{Finding, LineFinding};
use stickslip_experiment::LineSource;
use stickslip_scene::limits::Content;

/// The fringe lines of both fields.
pub(super) fn read(scope: &Scope<'_>, source: &LineSource) -> Result<Reading, ExperimentError> {
    let mut findings = Vec::new();
    let mut of = |field: Field| -> Result<FringeLines, ExperimentError> {
        let file = &source.files[field.component()];
        let bytes = scope.bytes(file, Content::Table)?;
        let name = file.display().to_string();
        let reading = &source.reading[field.component()];
        let (lines, doubts) = FringeLines::read_with_doubts(&bytes[..], &name, field, reading)
            .map_err(|cause| refused(scope, field, cause))?;
        findings.extend(doubts.iter().map(|own| off_track(&name, own)));
        Ok(lines)
    };
    let lines = [of(Field::U)?, of(Field::V)?];
    Ok(Reading::Lines(Digitised {
        lines,
        deviation: source.deviation,
        findings,
    }))
}

/// The error at the key of the lines, or at the tracks that name a line which is not there.
fn refused(scope: &Scope<'_>, field: Field, cause: DataError) -> ExperimentError {
    let tracks = matches!(cause, DataError::NoSuchLine { .. });
    let name = field.name().to_lowercase();
    let own = Scope {
        key: if tracks {
            format!("{}.tracks.{name}", scope.key)
        } else {
            scope.key.clone()
        },
        ..scope.clone()
    };
    own.data(cause)
}

/// Centres that lie so far off the track of their line that it may be another one.
fn off_track(file: &str, found: &OffTrack) -> Finding {
    let [count, centres] = found.centres;
    Finding::Line(LineFinding::OffTrack {
        file: file.to_owned(),
        line: found.row,
        centre: found.place,
        distance: found.distance,
        fringe_line: found.name.clone(),
        count,
        centres,
        spacing: found.spacing,
    })
}

/// Places of a component's own centres carry that component alone.
pub(super) fn fringe_lines(
    scope: &Scope<'_>,
    measured: &mut Measured,
    lines: [FringeLines; 2],
    deviation: f64,
) -> Result<(), ExperimentError> {
    let grating = scope.grating()?;
    measured.floor = [grating.displacement(deviation); 2];
    let field = &mut measured.measurement;
    field.deviation = measured.floor;
    for own in &lines {
        let c = own.field.component();
        for line in &own.lines {
            for (&place, &order) in line.places().iter().zip(line.orders()) {
                let valid = scope.shows(place) && scope.is_away(place, 0.0);
                let value = Some(grating.displacement(order));
                field.push(
                    place,
                    [0, 1].map(|axis| value.filter(|_| axis == c && valid)),
                );
            }
        }
    }
    if field.valid.iter().flatten().all(|valid| !valid) {
        return Err(scope.data(DataError::AllMasked {
            file: "fringe lines".to_owned(),
            rows: field.places.len(),
            remedy: "all centres lie in the hole or under a mask: check scale and y_axis",
        }));
    }
    measured.found(of_lines(&measured.measurement));
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
            measured.found([Finding::Line(LineFinding::BeyondNullField {
                count: found.left_out.len(),
                fringe_line: line.clone(),
                place: *place,
            })]);
        }
        Ok(found.lines)
    };
    Ok([less(0)?, less(1)?])
}
