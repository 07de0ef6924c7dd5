//! Pictures of a state: synthetic ones, or files.

use std::path::{Path, PathBuf};

use stickslip_hybrid::data::Field;
use stickslip_hybrid::fringe::{FringeError, PixelMap, decode};

use super::phase::{FieldInput, orders};
use super::{Reading, Scope};
use crate::experiment::error::ExperimentError;
use crate::experiment::plan::PictureSource;
use crate::experiment::synthesis::{FieldPictures, field_name};

/// Orders of synthetic pictures.
pub(super) fn synthetic(
    scope: &Scope<'_>,
    pictures: Option<&[FieldPictures; 2]>,
) -> Result<Reading, ExperimentError> {
    let (Some(pictures), Some(fringes)) = (pictures, &scope.experiment.fringes) else {
        return Err(ExperimentError::Missing {
            key: scope.key.clone(),
            what: format!("state '{}' has no synthetic pictures", scope.name()),
            remedy: "give the specimen a scene, and add [fringes]".to_owned(),
        });
    };
    let of = |field: Field| {
        let carrier = fringes.carrier[field.component()];
        let input = FieldInput {
            pictures: pictures[field.component()].pictures.clone(),
            carrier: Some(carrier).filter(|carrier| *carrier != [0.0; 2] || fringes.four),
            rising: [[1.0, 0.0], [0.0, 1.0]][field.component()],
        };
        orders(scope, input).map_err(|cause| scope.fringes(field_name(field), cause))
    };
    let (u, v) = rayon::join(|| of(Field::U), || of(Field::V));
    Ok(Reading::Pictures(Box::new([Some(u?), Some(v?)])))
}

/// Orders of picture files.
pub(super) fn read(scope: &Scope<'_>, source: &PictureSource) -> Result<Reading, ExperimentError> {
    let of = |field: Field| {
        let c = field.component();
        if source.files[c].is_empty() {
            return Ok(None);
        }
        let pictures = source.files[c].iter();
        let pictures = pictures.map(|file| picture(scope, source, field, file));
        let pictures: Vec<PixelMap> = pictures.collect::<Result<_, _>>()?;
        let carrier = source.carrier.map(|carriers| carriers[c]);
        let rising = source.rising[c];
        let input = FieldInput {
            pictures: pictures.clone(),
            carrier,
            rising,
        };
        orders(scope, input).map(Some).map_err(|cause| {
            let hint = match carrier {
                Some(stated) => other_carrier(scope, pictures, stated, rising),
                None => String::new(),
            };
            failed(scope, field, &source.files[c], cause, hint)
        })
    };
    let (u, v) = rayon::join(|| of(Field::U), || of(Field::V));
    Ok(Reading::Pictures(Box::new([u?, v?])))
}

fn picture(
    scope: &Scope<'_>,
    source: &PictureSource,
    field: Field,
    file: &Path,
) -> Result<PixelMap, ExperimentError> {
    let bytes = scope.bytes(file)?;
    let down = if source.upright { -1.0 } else { 1.0 };
    let step = [source.pixel, down * source.pixel];
    let first = [0, 1].map(|axis| source.top_left[axis] + 0.5 * step[axis]);
    let placed = decode(&bytes).and_then(|raster| raster.placed(first, step, source.dark));
    let files = [file.to_owned()];
    placed.map_err(|cause| failed(scope, field, &files, cause, String::new()))
}

/// The carrier that a picture has where the one that was stated is not found, in words.
fn other_carrier(
    scope: &Scope<'_>,
    pictures: Vec<PixelMap>,
    stated: [f64; 2],
    rising: [f64; 2],
) -> String {
    if pictures.len() != 1 {
        return String::new();
    }
    let input = FieldInput {
        pictures,
        carrier: None,
        rising,
    };
    orders(scope, input).map_or_else(
        |_| String::new(),
        |found| {
            let [x, y] = found.carrier;
            format!(
                ". The carrier stated is ({}, {}) fringes/mm; the picture's strongest fringes have ({x:.2}, {y:.2}), the plate's strain included",
                stated[0], stated[1]
            )
        },
    )
}

fn failed(
    scope: &Scope<'_>,
    field: Field,
    files: &[PathBuf],
    cause: FringeError,
    hint: String,
) -> ExperimentError {
    let names: Vec<String> = (files.iter())
        .map(|file| format!("'{}'", file.display()))
        .collect();
    ExperimentError::Fringes {
        state: scope.name(),
        field: field_name(field),
        file: format!(", {}", names.join(", ")),
        hint,
        key: scope.key.clone(),
        cause: Box::new(cause),
    }
}
