//! Study 6: bad meshes, and where in an element contact ends.

mod block;

use stickslip_fem_core::mesh::ElementKind;

use super::context::{Context, ELEMENTS, Found};
use super::history::Stages;
use super::methods::methods;
use super::outcome::Outcome;
use super::row::Row;
use crate::publish::TaskError;
use crate::study::record::fields;
use block::{Block, Defect, Indenter};

const PLATE: &str = "uniform pressure";
const CYLINDER: &str = "peak pressure";
const BAD: &str = "Q8, cylinder pressed and pushed with friction 0.3";
/// What is moved, in the order of the table; the names of cases begin with these.
const ASPECT: &str = "aspect ratio";
const DISTORTION: &str = "distortion";
const MID_SIDE: &str = "mid-side position";
const END: &str = "end of contact";
const OSCILLATION: &str = "oscillation";
/// Meshes of the map of solvers, with their labels.
const MESHES: [(&str, Defect); 6] = [
    ("regular", Defect::None),
    ("aspect 10²", Defect::Aspect(1e2)),
    ("aspect 10⁴", Defect::Aspect(1e4)),
    ("distorted 0.15", Defect::Distorted(0.15)),
    ("distorted 0.25", Defect::Distorted(0.25)),
    ("mid-side 0.3", Defect::MidSide(0.3)),
];

/// What is moved, by how much, and the mesh with that.
type Job = (&'static str, f64, ElementKind, Defect);

fn jobs(context: &Context) -> Vec<Job> {
    let aspects: &[f64] = context.sized(
        &[1.0, 1e2, 1e4],
        &[1.0, 3.0, 10.0, 30.0, 1e2, 3e2, 1e3, 3e3, 1e4],
    );
    let shares: &[f64] = context.sized(
        &[0.0, 0.3, 0.6],
        &[0.0, 0.1, 0.2, 0.3, 0.4, 0.45, 0.5, 0.55, 0.6],
    );
    let places: &[f64] = context.sized(
        &[0.5, 0.3, 0.25],
        &[0.5, 0.45, 0.4, 0.35, 0.3, 0.28, 0.26, 0.251, 0.25],
    );
    let mut jobs = Vec::new();
    for kind in ELEMENTS {
        let mut vary = |case, values: &[f64], defect: fn(f64) -> Defect| {
            jobs.extend(
                values
                    .iter()
                    .map(|&value| (case, value, kind, defect(value))),
            );
        };
        vary(ASPECT, aspects, Defect::Aspect);
        vary(DISTORTION, shares, Defect::Distorted);
        if kind.order() == 2 {
            vary(MID_SIDE, places, Defect::MidSide);
        }
    }
    jobs
}

pub(super) fn run(context: &Context) -> Result<Found, TaskError> {
    let cells = context.sized(20, 40);
    let nominal = 0.4;
    let fine = Block {
        cells: 4 * cells,
        kind: ElementKind::Q9,
        defect: Defect::None,
    };
    let peak = fine.press(&[Indenter::cylinder(nominal)], 0.0)?[0].peak;
    let mut rows = context.rows_of(&jobs(context), |&(case, value, kind, defect)| {
        let block = Block {
            cells,
            kind,
            defect,
        };
        let plate = block.press(&[Indenter::plate()], 0.0);
        let plate = plate.map(|found| found[0].deviation);
        let cylinder = block.press(&[Indenter::cylinder(nominal)], 0.0);
        let cylinder = cylinder.map(|found| (found[0].peak / peak - 1.0).abs());
        Ok(vec![
            row(format!("{case}: {PLATE}"), value, kind, plate),
            row(format!("{case}: {CYLINDER}"), value, kind, cylinder),
        ])
    })?;
    rows.extend(ends(context, cells, &fine)?);
    let order = [ASPECT, DISTORTION, MID_SIDE, END, OSCILLATION];
    rows.sort_by_key(|row| order.iter().position(|case| row.case.starts_with(case)));
    mark_refused(&mut rows);
    let solvers = solvers(context, cells)?;
    let own = Found::of("mesh", Vec::new()).and("", "value", &rows);
    Ok(Found {
        rows: solvers,
        suffix: "-solvers",
        ..own
    })
}

/// Contact that ends at every position within an element: the load moves it over one cell and a half.
fn ends(context: &Context, cells: usize, fine: &Block) -> Result<Vec<Row>, TaskError> {
    let count = context.sized(4, 24);
    let width = 2.0 / cells as f64;
    let inner = (0.4 / width).floor();
    let positions: Vec<f64> = (0..=count)
        .map(|k| inner + 1.5 * f64::from(k) / f64::from(count))
        .collect();
    let loads: Vec<Indenter> = positions
        .iter()
        .map(|&position| Indenter::cylinder(position * width))
        .collect();
    let exact = fine.press(&loads, 0.0)?;
    context.rows_of(&ELEMENTS, |&kind| {
        let own = Block {
            cells,
            kind,
            defect: Defect::None,
        }
        .press(&loads, 0.0)?;
        let mut rows = Vec::new();
        for ((&position, own), exact) in positions.iter().zip(&own).zip(&exact) {
            let error = (own.peak / exact.peak - 1.0).abs();
            rows.push(row(format!("{END}: {CYLINDER}"), position, kind, Ok(error)));
            if kind.order() == 2 {
                let case = format!("{OSCILLATION}: {CYLINDER}");
                rows.push(row(case, position, kind, Ok(own.oscillation)));
            }
        }
        Ok(rows)
    })
}

/// Every contact solver on bad meshes.
fn solvers(context: &Context, cells: usize) -> Result<Vec<Row>, TaskError> {
    let indices: Vec<usize> = (0..MESHES.len()).collect();
    context.rows_of(&indices, |&index| {
        let (name, defect) = MESHES[index];
        let block = Block {
            cells,
            kind: ElementKind::Q8,
            defect,
        };
        let (problem, loads) = block.problem(&Indenter::cylinder(0.4).pushed(), 0.3)?;
        let mut rows = Stages::follow(&problem, &loads).rows(BAD, index as f64, &methods());
        for row in &mut rows {
            row.more.extend(fields([("mesh_name", name.into())]));
        }
        Ok(rows)
    })
}

fn row(case: String, value: f64, kind: ElementKind, found: Result<f64, TaskError>) -> Row {
    let row = |error| Row::of_error(case, value, kind.name(), error);
    match found {
        Ok(error) if error < 1e-7 => Row {
            outcome: Outcome::Solved,
            ..row(Some(error))
        },
        Ok(error) => row(Some(error)),
        Err(error) => Row {
            outcome: Outcome::Refused,
            note: error.to_string(),
            ..row(None)
        },
    }
}

/// Puts refused meshes above all errors of their case, for the charts.
fn mark_refused(rows: &mut [Row]) {
    let errors: Vec<(String, f64)> = (rows.iter())
        .filter_map(|row| Some((row.case.clone(), row.error?)))
        .collect();
    let refused = rows
        .iter_mut()
        .filter(|row| row.outcome == Outcome::Refused);
    for row in refused {
        let own = errors.iter().filter(|(case, _)| *case == row.case);
        let top = own.fold(f64::MIN_POSITIVE, |top, (_, error)| top.max(*error));
        row.more
            .extend(fields([("refused_at", (10.0 * top).into())]));
    }
}
