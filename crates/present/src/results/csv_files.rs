//! Tables as CSV files: one per step and edge, and one of all steps. Headings carry the units: `CPRESS [psi]`.

use stickslip_contact::Status;
use stickslip_report::table::Columns;

use super::display::EdgeView;
use super::names::{FileNames, step_name};
use super::quantities::csv_columns;
use super::{FileNote, OutputError, failure, sets};
use crate::PutFile;
use stickslip_report::csv::{self, number};
use stickslip_results::{EdgeKind, EdgeRow, Results, RowErrors, Stated, StepResults};

/// Hands all CSV files to `put`, one after the other, because those of a long history are many; what they hold.
pub(super) fn files(results: &Results, put: &PutFile<'_>) -> Result<Vec<FileNote>, OutputError> {
    put("steps.csv", &steps(results))?;
    let mut notes = vec![FileNote::new(
        "steps.csv",
        "one row per load step: loads, extents, peaks, residuals",
    )];
    let mut names = FileNames::default();
    for edge in EdgeView::all(results) {
        let name = names.unique(&format!("edge-{}", edge.geometry.name));
        for step in 0..results.steps.len() {
            let file = format!("{}.csv", step_name(&name, step, results));
            put(&file, &edge_table(&edge, step))?;
        }
        let pattern = format!("{name}-step-*.csv");
        let what = if edge.geometry.contact {
            "tractions, gap, slip, status and stresses along the contact edge, one file per load step"
        } else {
            "stresses along the edge, one file per load step"
        };
        notes.push(FileNote::new(pattern, what));
    }
    let (tables, about) = failure::csv_files::files(results);
    for (name, bytes) in tables {
        put(&name, &bytes)?;
    }
    notes.extend(about);
    Ok(notes)
}

/// A node of an edge: its place, its row and the errors of that.
type Node<'a> = (f64, &'a EdgeRow, Option<&'a RowErrors>);

fn edge_table(edge: &EdgeView<'_>, step: usize) -> Vec<u8> {
    let own = edge.step(step);
    let places = edge.geometry.parameter.iter().copied();
    let rows = places.zip(&own.rows).enumerate();
    let nodes = rows.map(|(k, (place, row))| (place, row, own.row_errors.get(k)));
    csv::columns(&edge_columns(*edge, !own.row_errors.is_empty()), nodes)
}

fn edge_columns(edge: EdgeView<'_>, states_errors: bool) -> Columns<'_, Node<'_>> {
    let units = edge.units();
    let (in_stress, in_length) = (units.stress.name, units.length.name);
    let stress = |name: &str, value: fn(&EdgeRow) -> f64| {
        Columns::new().with(name, in_stress, move |(_, row, _): Node<'_>| {
            number(units.stress.from_base(value(row)))
        })
    };
    let with_error = |name: &str, value, error: fn(&RowErrors) -> f64| {
        let column = stress(name, value);
        if !states_errors {
            return column;
        }
        let name = format!("{name}_error");
        column.with(name, in_stress, move |(_, _, errors): Node<'_>| {
            errors.map_or(String::new(), |errors| {
                number(units.stress.from_base(error(errors)))
            })
        })
    };
    let length = |value: fn(&EdgeRow) -> f64| {
        move |(_, row, _): Node<'_>| number(units.length.from_base(value(row)))
    };
    let (place, names) = match edge.geometry.kind {
        EdgeKind::Circle { .. } => ("theta", ["sigma_r", "sigma_theta", "tau_rtheta"]),
        EdgeKind::Line => ("x", ["sigma_yy", "sigma_xx", "tau_xy"]),
        EdgeKind::Path => ("s", ["sigma_n", "sigma_s", "tau_ns"]),
    };
    // From +x, as the mesh and the field files have it.
    let mut columns = Columns::new().with(place, edge.place_unit(), move |(at, ..): Node<'_>| {
        number(edge.length(at))
    });
    if edge.geometry.contact {
        columns = columns
            .and([
                with_error("CPRESS", |row| row.pressure, |errors| errors.pressure),
                with_error("CSHEAR1", |row| row.shear, |errors| errors.shear),
            ])
            .with("COPEN", in_length, length(|row| row.gap))
            .with("CSLIP1", in_length, length(|row| row.slip))
            .with("CSTATUS", "", |(_, row, _)| status(row.status).into());
    }
    columns.and([
        stress(names[0], |row| row.sigma_normal),
        with_error(
            names[1],
            |row| row.sigma_tangential,
            |errors| errors.sigma_tangential,
        ),
        stress(names[2], |row| row.tau),
    ])
}

fn status(status: Status) -> &'static str {
    match status {
        Status::Open => "open",
        Status::Stick => "stick",
        Status::SlipPositive => "slip+",
        Status::SlipNegative => "slip-",
    }
}

/// Columns of the steps' table.
type StepColumns<'a> = Columns<'a, usize>;

fn steps(results: &Results) -> Vec<u8> {
    let mut columns = Columns::new().with("step", "", |step: usize| (step + 1).to_string());
    let loads = results.steps.first().map_or(&[][..], |step| &step.loads);
    for (index, load) in loads.iter().enumerate() {
        let name = format!("load {}", load.name);
        columns = columns.with(name, &load.unit, move |step: usize| {
            let load = results.steps[step].loads.get(index);
            number(load.map_or(f64::NAN, |load| load.value))
        });
    }
    let main = results.main_edge();
    let edges = EdgeView::all(results).into_iter().map(|edge| {
        if main == Some(edge.index()) {
            edge_quantities(edge, "")
        } else {
            edge_quantities(edge, &format!("{}: ", edge.geometry.name))
        }
    });
    let columns = columns.and(edges).and([
        sets::csv_columns(results),
        reserve_factors(results),
        work_quantities(results),
    ]);
    csv::columns(&columns, 0..results.steps.len())
}

fn edge_quantities<'a>(edge: EdgeView<'a>, prefix: &str) -> StepColumns<'a> {
    let columns = csv_columns(edge, prefix);
    if !edge.geometry.contact {
        return columns;
    }
    let force = edge.units().force;
    let axes = ["x", "y"].into_iter().enumerate();
    axes.fold(columns, |columns, (axis, name)| {
        let name = format!("{prefix}resultant_{name}");
        let error = format!("{name}_error");
        let columns = columns.with(name, force.name, move |step| {
            number(force.from_base(edge.step(step).resultant[axis]))
        });
        if edge.results().ladder.is_none() {
            return columns;
        }
        let stated = [Stated::ResultantX, Stated::ResultantY][axis];
        columns.with(error, force.name, move |step| {
            let error = edge.step(step).errors.get(stated);
            error.map_or(String::new(), |error| number(force.from_base(error)))
        })
    })
}

/// The reserve factor of every laminated body by each criterion.
fn reserve_factors(results: &Results) -> StepColumns<'_> {
    let mut columns = Columns::new();
    for failure in &results.failure {
        let body = &results.bodies[failure.body].name;
        for (k, criterion) in failure.criteria.iter().enumerate() {
            let name = format!("{body}: reserve_factor {criterion}");
            columns = columns.with(name, "-", move |step: usize| {
                number(failure.steps[step][k].reserve_factor)
            });
        }
    }
    columns
}

fn work_quantities(results: &Results) -> StepColumns<'_> {
    let step = |index: usize| &results.steps[index];
    let count = |of: fn(&StepResults) -> usize| move |k| of(step(k)).to_string();
    let residual = |of: fn(&StepResults) -> f64| move |k| number(of(step(k)));
    Columns::new()
        .with("iterations", "", count(|step| step.work.solves))
        .with("pivots", "", count(|step| step.work.pivots))
        .with("increments", "", count(|step| step.increments))
        .with("cutbacks", "", count(|step| step.cutbacks))
        .with("points_in_doubt", "", count(|step| step.doubtful))
        .with(
            "balance_residual",
            "",
            residual(|step| step.balance_residual),
        )
        .with(
            "complementarity_residual",
            "",
            residual(|step| step.residuals.complementarity),
        )
        .with("cone_violation", "", residual(|step| step.residuals.cone))
}
