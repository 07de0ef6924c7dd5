//! Tables as CSV files: one per step and edge, and one of all steps. Headings carry the units: `CPRESS [psi]`.

use stickslip_contact::Status;

use super::cells::{number, write};
use super::display::EdgeView;
use super::names::{FileNames, step_name};
use super::quantities::csv_columns;
use super::{FileNote, OutputError, failure};
use crate::PutFile;
use stickslip_engine::results::{EdgeRow, Results};

/// Hands all CSV files to `put`, one after the other, because those of a long history are many; what they hold.
pub(super) fn files(results: &Results, put: &PutFile<'_>) -> Result<Vec<FileNote>, OutputError> {
    put("steps.csv", &steps(results)?)?;
    let mut notes = vec![FileNote::new(
        "steps.csv",
        "one row per load step: loads, extents, peaks, residuals",
    )];
    let mut names = FileNames::default();
    for edge in EdgeView::all(results) {
        let name = names.unique(&format!("edge-{}", edge.geometry.name));
        for step in 0..results.steps.len() {
            let file = format!("{}.csv", step_name(&name, step, results));
            put(&file, &edge_table(&edge, step)?)?;
        }
        let pattern = format!("{name}-step-*.csv");
        let what = if edge.geometry.contact {
            "tractions, gap, slip, status and stresses along the contact edge, one file per load step"
        } else {
            "stresses along the edge, one file per load step"
        };
        notes.push(FileNote::new(pattern, what));
    }
    let (tables, about) = failure::csv_files::files(results)?;
    for (name, bytes) in tables {
        put(&name, &bytes)?;
    }
    notes.extend(about);
    Ok(notes)
}

/// A column of an edge's table: heading and the cell of a row.
type EdgeColumn<'a> = (String, Box<dyn Fn(&EdgeRow) -> String + 'a>);

fn edge_table(edge: &EdgeView<'_>, step: usize) -> Result<Vec<u8>, OutputError> {
    let place = if edge.is_circle() { "theta" } else { "x" };
    let columns = edge_columns(edge);
    let mut header = vec![format!("{place} [{}]", edge.place_unit())];
    header.extend(columns.iter().map(|(name, _)| name.clone()));
    let row = |(parameter, row): (&f64, &EdgeRow)| {
        // From +x, as the mesh and the field files have it.
        let mut cells = vec![number(edge.length(*parameter))];
        cells.extend(columns.iter().map(|(_, cell)| cell(row)));
        cells
    };
    let rows = edge
        .geometry
        .parameter
        .iter()
        .zip(&edge.step(step).rows)
        .map(row);
    write(&edge.geometry.name, std::iter::once(header).chain(rows))
}

fn edge_columns<'a>(edge: &EdgeView<'a>) -> Vec<EdgeColumn<'a>> {
    let units = edge.units();
    let stress = |name: &str, value: fn(&EdgeRow) -> f64| -> EdgeColumn<'a> {
        let cell = move |row: &EdgeRow| number(units.stress.from_base(value(row)));
        (format!("{name} [{}]", units.stress.name), Box::new(cell))
    };
    let length = |name: &str, value: fn(&EdgeRow) -> f64| -> EdgeColumn<'a> {
        let cell = move |row: &EdgeRow| number(units.length.from_base(value(row)));
        (format!("{name} [{}]", units.length.name), Box::new(cell))
    };
    let mut columns = Vec::new();
    if edge.geometry.contact {
        columns.push(stress("CPRESS", |row| row.pressure));
        columns.push(stress("CSHEAR1", |row| row.shear));
        columns.push(length("COPEN", |row| row.gap));
        columns.push(length("CSLIP1", |row| row.slip));
        columns.push(("CSTATUS".into(), Box::new(|row| status(row.status).into())));
    }
    let names = if edge.is_circle() {
        ["sigma_r", "sigma_theta", "tau_rtheta"]
    } else {
        ["sigma_yy", "sigma_xx", "tau_xy"]
    };
    columns.push(stress(names[0], |row| row.sigma_normal));
    columns.push(stress(names[1], |row| row.sigma_tangential));
    columns.push(stress(names[2], |row| row.tau));
    columns
}

fn status(status: Status) -> &'static str {
    match status {
        Status::Open => "open",
        Status::Stick => "stick",
        Status::SlipPositive => "slip+",
        Status::SlipNegative => "slip-",
    }
}

/// A column of the steps' table: heading and the cell of a step.
type StepColumn<'a> = (String, Box<dyn Fn(usize) -> String + 'a>);

fn steps(results: &Results) -> Result<Vec<u8>, OutputError> {
    let mut columns: Vec<StepColumn<'_>> =
        vec![("step".into(), Box::new(|step| (step + 1).to_string()))];
    let loads = results.steps.first().map_or(&[][..], |step| &step.loads);
    for (index, load) in loads.iter().enumerate() {
        let heading = format!("load {} [{}]", load.name, load.unit);
        let value = move |step: usize| {
            results.steps[step]
                .loads
                .get(index)
                .map_or(f64::NAN, |load| load.value)
        };
        columns.push((heading, Box::new(move |step| number(value(step)))));
    }
    let main = EdgeView::main(results).map(|edge| &edge.geometry.name);
    for edge in EdgeView::all(results) {
        let is_main = main.is_some_and(|main| *main == edge.geometry.name);
        let prefix = if is_main {
            String::new()
        } else {
            format!("{}: ", edge.geometry.name)
        };
        columns.extend(edge_quantities(edge, &prefix));
    }
    columns.extend(reserve_factors(results));
    columns.extend(work_quantities(results));
    let header = columns.iter().map(|(name, _)| name.clone()).collect();
    let rows =
        (0..results.steps.len()).map(|step| columns.iter().map(|(_, cell)| cell(step)).collect());
    write("steps.csv", std::iter::once(header).chain(rows))
}

fn edge_quantities<'a>(edge: EdgeView<'a>, prefix: &str) -> Vec<StepColumn<'a>> {
    let declared = csv_columns(edge).map(|column| {
        let heading = format!("{prefix}{} [{}]", column.heading, column.unit);
        (heading, column.cell)
    });
    let mut columns: Vec<StepColumn<'a>> = declared.collect();
    if edge.geometry.contact {
        let force = edge.units().force;
        for (axis, name) in ["x", "y"].into_iter().enumerate() {
            let heading = format!("{prefix}resultant_{name} [{}]", force.name);
            let cell = move |k: usize| number(force.from_base(edge.step(k).resultant[axis]));
            columns.push((heading, Box::new(cell)));
        }
    }
    columns
}

/// The reserve factor of every laminated body by each criterion.
fn reserve_factors(results: &Results) -> Vec<StepColumn<'_>> {
    let mut columns: Vec<StepColumn<'_>> = Vec::new();
    for failure in &results.failure {
        let name = &results.bodies[failure.body].name;
        for (k, criterion) in failure.criteria.iter().enumerate() {
            let heading = format!("{name}: reserve_factor {criterion} [-]");
            let cell = move |step: usize| number(failure.steps[step][k].reserve_factor);
            columns.push((heading, Box::new(cell)));
        }
    }
    columns
}

fn work_quantities(results: &Results) -> Vec<StepColumn<'_>> {
    let step = |index: usize| &results.steps[index];
    vec![
        (
            "iterations".into(),
            Box::new(move |k| step(k).work.solves.to_string()),
        ),
        (
            "pivots".into(),
            Box::new(move |k| step(k).work.pivots.to_string()),
        ),
        (
            "increments".into(),
            Box::new(move |k| step(k).increments.to_string()),
        ),
        (
            "cutbacks".into(),
            Box::new(move |k| step(k).cutbacks.to_string()),
        ),
        (
            "points_in_doubt".into(),
            Box::new(move |k| step(k).doubtful.to_string()),
        ),
        (
            "balance_residual".into(),
            Box::new(move |k| number(step(k).balance_residual)),
        ),
        (
            "complementarity_residual".into(),
            Box::new(move |k| number(step(k).residuals.complementarity)),
        ),
        (
            "cone_violation".into(),
            Box::new(move |k| number(step(k).residuals.cone)),
        ),
    ]
}
