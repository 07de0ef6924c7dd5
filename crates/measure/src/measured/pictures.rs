//! Pictures of a state: synthetic ones, or files.

use std::path::{Path, PathBuf};

use stickslip_fem_core::parallel;
use stickslip_hybrid::data::Field;
use stickslip_hybrid::fringe::{FringeError, PixelMap, decode, size};

use super::phase::{FieldInput, orders};
use super::{Reading, Scope};
use crate::error::ExperimentError;
use crate::synthesis::FieldPictures;
use stickslip_experiment::PictureSource;
use stickslip_scene::limits::Content;

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
        orders(scope, input).map_err(|cause| scope.fringes(field.name(), cause))
    };
    let (u, v) = parallel::join(|| of(Field::U), || of(Field::V));
    Ok(Reading::Pictures(Box::new([Some(u?), Some(v?)])))
}

/// Orders of picture files. `takes_off` is whether the carrier is taken off by what is known of it, not by a null field.
pub(super) fn read(
    scope: &Scope<'_>,
    source: &PictureSource,
    takes_off: bool,
) -> Result<Reading, ExperimentError> {
    let [u, v] = opened(scope, source)?;
    let decoded = |field: Field, files: Vec<Vec<u8>>| -> Result<Vec<PixelMap>, ExperimentError> {
        let names = source.files[field.component()].iter();
        names
            .zip(files)
            .map(|(name, bytes)| picture(scope, source, field, name, &bytes))
            .collect()
    };
    let (u, v) = parallel::join(|| decoded(Field::U, u), || decoded(Field::V, v));
    let (u, v) = (u?, v?);
    if takes_off && source.carrier.is_none() && [&u, &v].iter().any(|field| field.len() == 1) {
        return Err(untold(scope));
    }
    let of = |field: Field, pictures: Vec<PixelMap>| {
        if pictures.is_empty() {
            return Ok(None);
        }
        let c = field.component();
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
    let (u, v) = parallel::join(|| of(Field::U, u), || of(Field::V, v));
    Ok(Reading::Pictures(Box::new([u?, v?])))
}

/// The files of both fields as they are, whose pictures fit into the memory.
fn opened(scope: &Scope<'_>, source: &PictureSource) -> Result<[Vec<Vec<u8>>; 2], ExperimentError> {
    let mut files = [Vec::new(), Vec::new()];
    let mut pixels = 0.0;
    for field in Field::BOTH {
        let c = field.component();
        for file in &source.files[c] {
            let bytes = scope.bytes(file, Content::Picture)?;
            let own = [file.clone()];
            let size =
                size(&bytes).map_err(|cause| failed(scope, field, &own, cause, String::new()))?;
            pixels += size[0] as f64 * size[1] as f64;
            let fits = scope.experiment.limits().check_pixels(pixels);
            fits.map_err(|cause| ExperimentError::Memory {
                key: scope.key.clone(),
                what: format!(
                    "the picture '{}' has {} x {} pixels",
                    file.display(),
                    size[0],
                    size[1]
                ),
                cause,
            })?;
            files[c].push(bytes);
        }
    }
    Ok(files)
}

/// Pictures whose carrier is unknown.
fn untold(scope: &Scope<'_>) -> ExperimentError {
    ExperimentError::Missing {
        key: scope.key.clone(),
        what: format!(
            "state '{}': nothing distinguishes the carrier's part of the fringes from the plate's mean strain",
            scope.name()
        ),
        remedy: "give the carrier = { u = [\"12 1/mm\", \"0 1/mm\"], v = [\"0 1/mm\", \"12 1/mm\"] }, or null = { pictures = … } of the \
                 initial load with the same carrier"
            .to_owned(),
    }
}

fn picture(
    scope: &Scope<'_>,
    source: &PictureSource,
    field: Field,
    file: &Path,
    bytes: &[u8],
) -> Result<PixelMap, ExperimentError> {
    let down = if source.upright { -1.0 } else { 1.0 };
    let step = [source.pixel, down * source.pixel];
    let first = [0, 1].map(|axis| source.top_left[axis] + 0.5 * step[axis]);
    let placed = decode(bytes).and_then(|raster| raster.placed(first, step, source.dark));
    let files = [file.to_owned()];
    placed.map_err(|cause| failed(scope, field, &files, cause, String::new()))
}

/// The carrier that a picture has where the one that was stated is not found, as text.
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
            let [x, y] = found.field.carrier;
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
        field: field.name(),
        file: format!(", {}", names.join(", ")),
        hint,
        key: scope.key.clone(),
        cause: Box::new(cause),
    }
}
