//! Displacements from a table.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::data::{DataError, Field, Measurement, Rows, Unit, YAxis};

use super::{Measured, Reading, Scope, range, rotation, scatter};
use crate::error::ExperimentError;
use crate::finding::{FieldFinding, Finding, TableFinding, Worst};
use stickslip_experiment::TableSource;
use stickslip_scene::limits::Content;
use stickslip_scene::units::{Dimension, Expected, parse};

/// Scatter of less than this part of the range is no measurement's: a hundredth of a fringe of a thousand fringes.
const CALCULATED: f64 = 1e-5;
/// Part of the hole's radius by which a place may be inside of it and still be meant to be at its edge.
const ON_EDGE: f64 = 0.05;
/// Part of the valid places that may be inside of the hole as strays.
const STRAY: f64 = 0.01;

/// A table as its source says, its origin moved to the body's, masked where it shows no specimen and where places do not go with their
/// neighbours.
pub(super) fn read(scope: &Scope<'_>, source: &TableSource) -> Result<Reading, ExperimentError> {
    let bytes = scope.bytes(&source.file, Content::Table)?;
    let name = source.file.display().to_string();
    let (mut measurement, rows) =
        Measurement::read_rows(&bytes[..], &name, &source.format, &source.reading)
            .map_err(|cause| scope.data(cause))?;
    let mut findings = Vec::new();
    for unit in &rows.units {
        findings.extend(against_scale(scope, source, &name, unit)?);
    }
    let shift = origin(source);
    for place in &mut measurement.places {
        *place = [place[0] - shift[0], place[1] - shift[1]];
    }
    findings.extend(inside_hole(scope, &name, &measurement));
    mask_specimen(scope, &name, &mut measurement)?;
    // Rounding to a step is an error that is uniform in it.
    let rounding = rows.step.map(|step| step / 12.0_f64.sqrt());
    let floor = rounding.map(|rounding| source.deviation.unwrap_or(rounding));
    measurement.deviation = [0, 1].map(|c| floor[c].max(rounding[c]));
    let mut found = Measured::new(scope.state, measurement);
    found.floor = floor;
    found.found(findings);
    mask_outliers(scope, &name, &rows, &mut found)?;
    match source.deviation {
        Some(deviation) => found.measurement.deviation = [deviation; 2],
        None => {
            scatters(scope, rounding, &mut found.measurement)?;
        }
    }
    let before = found.measurement.deviation;
    let data = std::mem::take(&mut found.measurement);
    let (data, turned) = rotation::of_material(scope, data);
    found.measurement = data;
    found.found(turned.and_then(|own| own.finding()));
    found.rotations.extend(turned);
    if source.deviation.is_none() {
        // Once more in the frame of the specimen, so that what is found does not depend on the rotation. A component without any scatter
        // gets none by the other one's.
        let without = before.map(|deviation| deviation == 0.0);
        let scatters = scatters(scope, rounding, &mut found.measurement)?;
        for c in (0..2).filter(|&c| without[c]) {
            found.measurement.deviation[c] = 0.0;
        }
        for field in Field::BOTH {
            found_deviation(field, scatters[field.component()], &mut found);
        }
    }
    Ok(Reading::Scattered(Box::new(found)))
}

/// The body's origin `[mm]` in the table's axes, y upright.
fn origin(source: &TableSource) -> Point {
    let scale = source.reading.scale.unwrap_or(1.0);
    let upright = source.reading.y_axis == YAxis::Up;
    let down = if upright { 1.0 } else { -1.0 };
    [scale * source.origin[0], down * scale * source.origin[1]]
}

/// Masks what shows no specimen.
fn mask_specimen(
    scope: &Scope<'_>,
    name: &str,
    measurement: &mut Measurement,
) -> Result<(), ExperimentError> {
    let places = measurement.places.clone();
    for field in Field::BOTH {
        measurement.mask(field, |k| {
            !(scope.shows(places[k]) && scope.is_away(places[k], 0.0))
        });
    }
    if measurement.count(Field::U) + measurement.count(Field::V) > 0 {
        return Ok(());
    }
    Err(scope.data(DataError::AllMasked {
        file: name.to_owned(),
        rows: measurement.places.len(),
        remedy: "all its points lie in the hole or under a mask: check scale, origin and y_axis",
    }))
}

/// Compares a unit that the table states with the scale that the experiment states; a finding where it is no length.
fn against_scale(
    scope: &Scope<'_>,
    source: &TableSource,
    name: &str,
    found: &Unit,
) -> Result<Option<Finding>, ExperimentError> {
    let reading = &source.reading;
    let (key, stated) = match (found.of_place, reading.displacement_scale) {
        (false, Some(scale)) => ("displacement_scale", scale),
        _ => ("scale", reading.scale.unwrap_or(1.0)),
    };
    let Unit {
        line, column, unit, ..
    } = found;
    let length = Expected::one(Dimension::Length);
    let Ok((value, _)) = parse(&format!("1 {}", unit.replace('μ', "µ")), &length) else {
        return Ok(Some(Finding::Table(TableFinding::UnitNotCompared {
            file: name.to_owned(),
            line: *line,
            column: column.clone(),
            unit: unit.clone(),
            key,
        })));
    };
    if (value - stated).abs() <= 1e-9 * stated {
        return Ok(None);
    }
    Err(ExperimentError::Missing {
        key: format!("{}.{key}", scope.key),
        what: format!(
            "state '{}': line {line} of '{name}' says that column '{column}' is in {unit}, and {key} says that one unit of it is {}",
            scope.name(),
            scope.experiment.display.length.show(stated)
        ),
        remedy: format!(
            "state {} = \"1 {unit}\", or begin that line with # if it is wrong",
            if found.of_place {
                "scale"
            } else {
                "displacement_scale"
            }
        ),
    })
}

/// Valid places that lie well inside of the hole, where there are more than stray ones: the mark of a wrong origin.
fn inside_hole(scope: &Scope<'_>, name: &str, data: &Measurement) -> Option<Finding> {
    let hole = scope.experiment.specimen.hole;
    let valid = (0..data.places.len()).filter(|&k| data.valid[0][k] || data.valid[1][k]);
    let depths: Vec<(f64, Point)> = valid
        .map(|k| data.places[k])
        .map(|place| (hole.radius - hole.from_centre(place), place))
        .collect();
    let inside = depths
        .iter()
        .filter(|(depth, _)| *depth > ON_EDGE * hole.radius);
    let count = inside.clone().count();
    let &(depth, deepest) = inside.max_by(|a, b| a.0.total_cmp(&b.0))?;
    if count as f64 <= STRAY * depths.len() as f64 {
        return None;
    }
    Some(Finding::Table(TableFinding::InsideHole {
        file: name.to_owned(),
        count,
        places: depths.len(),
        deepest,
        depth,
    }))
}

/// Masks places that do not go with their neighbours: of both components, for what spoils one spoils mostly the other.
fn mask_outliers(
    scope: &Scope<'_>,
    name: &str,
    rows: &Rows,
    found: &mut Measured,
) -> Result<(), ExperimentError> {
    let Some(threshold) = scope.experiment.reduce.outliers else {
        return Ok(());
    };
    let data = &mut found.measurement;
    let outliers = data
        .outliers(threshold)
        .map_err(|cause| scope.data(cause))?;
    let Some(worst) = (outliers.iter()).max_by(|a, b| a.ratio.total_cmp(&b.ratio)) else {
        return Ok(());
    };
    let places = data.places.len();
    let mut bad: Vec<usize> = outliers.iter().map(|one| one.place).collect();
    bad.dedup();
    let mut marks = vec![false; places];
    for &place in &bad {
        marks[place] = true;
    }
    let worst = Worst {
        line: rows.lines[worst.place],
        field: worst.field.name(),
        value: worst.value,
        expected: worst.expected,
    };
    for field in Field::BOTH {
        data.mask(field, |k| marks[k]);
    }
    let outliers = TableFinding::Outliers {
        file: name.to_owned(),
        count: bad.len(),
        places,
        worst,
    };
    found.found([Finding::Table(outliers)]);
    found.outliers = bad;
    Ok(())
}

/// Sets the standard deviation `[mm]` that errors of each component have by the scatter of neighbours, and at least by what rounds its
/// digits; the scatter.
fn scatters(
    scope: &Scope<'_>,
    rounding: [f64; 2],
    data: &mut Measurement,
) -> Result<[f64; 2], ExperimentError> {
    let mut scatters = [0.0; 2];
    for field in Field::BOTH {
        let c = field.component();
        if data.count(field) == 0 {
            data.deviation[c] = 0.0;
            continue;
        }
        scatters[c] = scatter::deviation(data, field).map_err(|cause| ExperimentError::Missing {
            key: scope.key.clone(),
            what: format!(
                "state '{}': no standard deviation is stated, and it cannot be estimated from the scatter of neighbours: {cause}",
                scope.name()
            ),
            remedy: "state it: deviation = \"0.5 um\"".to_owned(),
        })?;
        data.deviation[c] = scatters[c].max(rounding[c]);
    }
    Ok(scatters)
}

/// Findings on the standard deviation of a component whose neighbours scatter by `scatter` `[mm]`.
fn found_deviation(field: Field, scatter: f64, found: &mut Measured) {
    if found.measurement.count(field) == 0 {
        return;
    }
    let deviation = found.measurement.deviation[field.component()];
    let range = range(&found.measurement, field);
    let field = field.name();
    let calculated = (deviation < CALCULATED * range).then(|| FieldFinding::AsCalculated {
        field,
        deviation,
        of_range: deviation / range,
    });
    let estimated = FieldFinding::Deviation {
        field,
        deviation,
        by_digits: deviation > scatter,
    };
    let both = calculated.into_iter().chain([estimated]);
    found.found(both.map(Finding::Field));
}
