//! The null field taken off, displacements from orders.

use stickslip_hybrid::data::{DataError, Field, Measurement, NullField};
use stickslip_hybrid::fringe::{FringeError, PixelMap, Plane, measurement};

use super::elsewhere::elsewhere;
use super::lines::{fringe_lines, less_null};
use super::phase::Unwound;
use super::rotation::{self, TakenOff};
use super::{Measured, PictureField, Reading, Scope};
use crate::error::ExperimentError;
use crate::finding::{Apart, Finding, Part, PictureFinding};
use stickslip_experiment::Source;

/// A state's field from its reading and that of its null field.
pub(super) fn combined(
    scope: &Scope<'_>,
    own: Reading,
    null: Option<Reading>,
) -> Result<Measured, ExperimentError> {
    let mut measured = Measured::new(scope.state, Measurement::default());
    match (own, null) {
        (Reading::Pictures(fields), Some(Reading::Pictures(null))) => {
            pictures(scope, &mut measured, *fields, Some(&null))?;
        }
        (Reading::Pictures(fields), None) => {
            pictures(scope, &mut measured, *fields, None)?;
        }
        (Reading::Lines(own), None) => {
            measured.found(own.findings);
            fringe_lines(scope, &mut measured, own.lines, own.deviation)?;
        }
        (Reading::Lines(own), Some(Reading::Lines(null))) => {
            measured.found(own.findings);
            measured.found_in(Part::NullField, null.findings);
            let lines = less_null(scope, &mut measured, &own.lines, &null.lines)?;
            let deviation = own.deviation.hypot(null.deviation);
            fringe_lines(scope, &mut measured, lines, deviation)?;
        }
        (own, null) => {
            let is_pictured = matches!(own, Reading::Pictures(_));
            measured.measurement = scattered(scope, &mut measured, own, false)?;
            if let Some(null) = null {
                let null = scattered(scope, &mut measured, null, true)?;
                measured.measurement = minus(scope, &measured.measurement, &null)?;
                if is_pictured {
                    measured.found([Finding::Picture(PictureFinding::MapsBeforeNullField)]);
                }
            }
        }
    }
    Ok(measured)
}

/// Displacements at places of any reading, with what was met on the way to them; `of_null` where they are those of the null field.
fn scattered(
    scope: &Scope<'_>,
    measured: &mut Measured,
    reading: Reading,
    of_null: bool,
) -> Result<Measurement, ExperimentError> {
    let own = match reading {
        Reading::Scattered(own) => *own,
        other => combined(scope, other, None)?,
    };
    let mut pictures = own.pictures;
    for (floor, own) in measured.floor.iter_mut().zip(own.floor) {
        *floor = floor.hypot(own);
    }
    if !of_null {
        measured.outliers = own.outliers;
    }
    let rotations = own.rotations.into_iter();
    (measured.rotations).extend(rotations.map(|own| TakenOff { of_null, ..own }));
    let part = if of_null {
        Part::NullField
    } else {
        Part::State
    };
    measured.found_in(part, own.findings.into_iter().map(|(_, finding)| finding));
    if pictures.iter().any(Option::is_some) {
        for field in pictures.iter_mut().flatten() {
            field.of_null = of_null;
        }
        measured.pictures = pictures;
    }
    Ok(own.measurement)
}

fn minus(
    scope: &Scope<'_>,
    own: &Measurement,
    null: &Measurement,
) -> Result<Measurement, ExperimentError> {
    let how = match scope.experiment.reduce.common_places {
        Some(tolerance) => NullField::SamePlaces { tolerance },
        None => NullField::Interpolated {
            longest_side: scope.longest_side(),
        },
    };
    for field in Field::BOTH {
        if own.count(field) > 0 && null.count(field) == 0 {
            return Err(lacking(scope, field, NOT_MEASURED));
        }
    }
    let difference = own.minus(null, how).map_err(|cause| match cause {
        DataError::AllMasked { .. } => elsewhere(scope, own, null, how),
        cause => scope.data(cause),
    })?;
    for field in Field::BOTH {
        if own.count(field) > 0 && difference.count(field) == 0 {
            return Err(lacking(scope, field, " where the state has one"));
        }
    }
    Ok(difference)
}

/// What [`lacking`] adds where a component was not measured at all.
const NOT_MEASURED: &str = "";

/// A null field without a component of the state, which would keep the initial load or vanish unseen.
fn lacking(scope: &Scope<'_>, field: Field, where_: &str) -> ExperimentError {
    let name = field.name();
    let null = scope.experiment.states[scope.state].null.as_ref();
    let files = null.map_or_else(Vec::new, Source::files);
    let files: Vec<String> = (files.iter())
        .map(|file| format!("'{}'", file.display()))
        .collect();
    let of = if files.is_empty() {
        String::new()
    } else {
        format!(" ({})", files.join(", "))
    };
    ExperimentError::Missing {
        key: format!("{}.null", scope.key),
        what: format!(
            "state '{}': the null field has no {name}{where_}{of}, so the initial load cannot be taken off the state's {name}",
            scope.name()
        ),
        remedy: format!(
            "give the {name} of the initial load too, at the places of the state, or leave {name} out of the state"
        ),
    }
}

fn pictures(
    scope: &Scope<'_>,
    measured: &mut Measured,
    fields: [Option<Unwound>; 2],
    null: Option<&[Option<Unwound>; 2]>,
) -> Result<(), ExperimentError> {
    for (field, own) in Field::BOTH.into_iter().zip(fields) {
        let Some(own) = own else { continue };
        let null = match null.map(|null| null[field.component()].as_ref()) {
            Some(None) => return Err(lacking(scope, field, NOT_MEASURED)),
            Some(null) => null,
            None => None,
        };
        report_unwound(measured, field, &own, null.is_some());
        let found = match null {
            Some(null) => less(own.field, &null.field),
            None => Ok(own.field),
        };
        let found = found.map_err(|cause| scope.fringes(field.name(), cause))?;
        measured.pictures[field.component()] = Some(found);
    }
    report_unwrapping(measured);
    let stride = stride(scope, measured);
    let maps = measured.pictures.each_ref();
    let orders = maps.map(|field| field.as_ref().map(|field| &field.orders));
    let deviations = maps.map(|field| field.as_ref().map_or(0.0, |field| field.deviation));
    let frequency = scope.grating()?.frequency();
    let data = measurement(orders, frequency, deviations, stride)
        .map_err(|cause| scope.fringes("U or V", cause))?;
    let (data, taken) = rotation::of_picture(scope, data);
    measured.measurement = data;
    measured.found(taken.and_then(|own| own.finding()));
    measured.rotations.extend(taken);
    measured.found([Finding::Picture(PictureFinding::Stride { pixels: stride })]);
    Ok(())
}

/// Most displacements that are taken of a picture whose pixels are all independent, where nothing else is stated.
const PLENTY: f64 = 50_000.0;

/// Every how many pixels a displacement is taken: those stated, or as many as errors depend on each other over; more where that leaves
/// every pixel.
fn stride(scope: &Scope<'_>, measured: &Measured) -> usize {
    let of_field = |field: &PictureField| {
        let step = field.orders.frame().step();
        let pixel = step[0].abs().min(step[1].abs());
        match (field.resolution / pixel - 1e-9).ceil() as usize {
            0 | 1 => (field.orders.present().count() as f64 / PLENTY)
                .sqrt()
                .ceil()
                .max(1.0) as usize,
            stride => stride,
        }
    };
    let own = measured.pictures.iter().flatten().map(of_field).max();
    scope.experiment.reduce.stride.or(own).unwrap_or(1)
}

/// A field with its null field taken off.
fn less(mut own: PictureField, null: &PictureField) -> Result<PictureField, FringeError> {
    own.orders = difference(&own, null)?;
    own.deviation = own.deviation.hypot(null.deviation);
    own.resolution = own.resolution.max(null.resolution);
    own.residues.extend(&null.residues);
    own.cuts.extend(&null.cuts);
    Ok(own)
}

/// N − N₀ pixel by pixel; both have the same carrier, whatever part of it was taken off either.
fn difference(own: &PictureField, null: &PictureField) -> Result<PixelMap, FringeError> {
    let frame = *own.orders.frame();
    if frame != *null.orders.frame() {
        let frames = (frame, *null.orders.frame());
        return Err(FringeError::Frames(Box::new(frames)));
    }
    let plane = Plane {
        gradient: [0, 1].map(|axis| null.carrier[axis] - own.carrier[axis]),
        constant: 0.0,
    };
    let both = own.orders.values().iter().zip(null.orders.values());
    let values = both
        .enumerate()
        .map(|(pixel, (own, null))| own - null - plane.at(frame.place(pixel)));
    PixelMap::with_gaps(frame, values.collect())
}

/// What is reported of a field, whose carrier does not matter where a null field with the same takes it off.
fn report_unwound(measured: &mut Measured, field: Field, found: &Unwound, has_null: bool) {
    let name = field.name();
    let is_found = !found.known && !has_null;
    let carrier = is_found.then_some(PictureFinding::CarrierFound {
        field: name,
        carrier_per_mm: found.field.carrier,
    });
    let apart = (found.apart > 0).then_some(PictureFinding::PixelsApart {
        field: name,
        pixels: found.apart,
    });
    measured.found(carrier.into_iter().chain(apart).map(Finding::Picture));
}

/// One finding for both fields: what is wrong with one picture is mostly wrong with the other.
fn report_unwrapping(measured: &mut Measured) {
    let fields = Field::BOTH.into_iter().zip(&measured.pictures);
    let open: Vec<Apart> = fields
        .filter_map(|(field, found)| {
            let found = found.as_ref()?;
            let (loops, jumps) = (found.residues.len(), found.cuts.len());
            (loops + jumps > 0).then_some(Apart {
                field: field.name(),
                loops,
                jumps,
            })
        })
        .collect();
    if !open.is_empty() {
        measured.found([Finding::Picture(PictureFinding::Unwrapping {
            fields: open,
        })]);
    }
}
