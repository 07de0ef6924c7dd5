//! The force that crosses the edge of a region.

use serde_json::{Value, json};
use stickslip_report::table::{Column, Table};

use super::Analysed;
use crate::experiment::plan::Experiment;
use crate::experiment::story::csv_table;
use crate::output::short;

const AXES: [&str; 2] = ["x", "y"];
/// Deviations, and part of the known force, by which stresses may miss it before it is told of, on top of what they and the forces on the
/// nodes differ by: neither mesh nor smoothing is in the deviation.
const ALLOWED: [f64; 2] = [3.0, 0.02];
/// The same, part of what the ends of the edge carry, where stresses are not trusted.
const ENDS: f64 = 0.5;

/// Forces on the edges of all states, by their nodes, and how well the stresses agree.
pub(super) fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.force;
    let is_known = |axis: &usize| {
        let mut all = analysed.iter();
        all.any(|found| found.checks.excess[*axis].is_some())
    };
    let known: Vec<usize> = (0..2).filter(is_known).collect();
    let mut columns = vec![
        Column::new("state", ""),
        Column::new("along x", unit.name),
        Column::new("±", unit.name),
        Column::new("along y", unit.name),
        Column::new("±", unit.name),
        Column::new("balance", "% of the force"),
    ];
    for &axis in &known {
        let what = format!("by stresses, over known: {}", AXES[axis]);
        columns.extend([Column::new(what, unit.name), Column::new("±", unit.name)]);
    }
    let mut table = Table::new(
        "Force on the region through its edge, with standard deviations",
        columns,
    );
    for found in analysed {
        let mut row = vec![experiment.states[found.state].name.clone()];
        for [force, deviation] in by_nodes(found) {
            row.extend([force, deviation].map(|value| short(unit.from_base(value))));
        }
        row.push(imbalance(found).map_or_else(String::new, |part| format!("{:.1}", 100.0 * part)));
        for &axis in &known {
            let excess = found.checks.excess[axis];
            let told = excess.map(|own| own.map(|value| short(unit.from_base(value))));
            row.extend(told.unwrap_or_default());
        }
        table.push(row);
    }
    let table = table.note(
        "By the forces that hold the edge's nodes, of the whole edge of a sector and not only where it is in contact. Balance: what these \
         and the integral of the edge's stresses differ by, a check of the mesh; the ends of the edge leave some per cent.",
    );
    if known.is_empty() {
        return table;
    }
    table.note(
        "Excess over known: the force by the edge's stresses less the one stated as edge_force; deviations hold the noise alone, not mesh and smoothing, some \
         per cent of the force; it is warned of beyond three deviations, 2 % of the force, the balance, and half of what \
         the ends of the edge carry, together.",
    )
}

/// Known forces that the stresses on the edge are not in balance with.
pub(super) fn doubts(experiment: &Experiment, found: &Analysed) -> Vec<String> {
    let known = experiment.states[found.state].edge_force;
    let size = known[0].unwrap_or(0.0).hypot(known[1].unwrap_or(0.0));
    let unit = experiment.display.force;
    let told = |axis: usize| {
        let [excess, deviation] = found.checks.excess[axis]?;
        let between = found.forces.values[axis] + found.forces.values[2 + axis];
        let ends = ENDS * found.checks.ends;
        let limit = ALLOWED[0] * deviation + ALLOWED[1] * size + between.abs() + ends;
        (excess.abs() > limit).then(|| {
            format!(
                "by its stresses the force on the edge along {} is {} {} off the stated edge_force, where {} are explained by noise, mesh and \
                 ends of the edge: check that the edge holds all of the contact and does not stand off from the hole, and scale, \
                 thickness and material.",
                AXES[axis],
                short(unit.from_base(excess.abs())),
                unit.name,
                short(unit.from_base(limit)),
            )
        })
    };
    (0..2).filter_map(told).collect()
}

/// Forces at the nodes that move as measured.
pub(super) fn csv(experiment: &Experiment, found: &Analysed) -> Vec<u8> {
    let (length, force) = (experiment.display.length, experiment.display.force);
    let header = [
        format!("x [{}]", length.name),
        format!("y [{}]", length.name),
        format!("force x [{}]", force.name),
        format!("force x deviation [{}]", force.name),
        format!("force y [{}]", force.name),
        format!("force y deviation [{}]", force.name),
        "inside".to_owned(),
    ];
    let rows = found.nodal_forces.iter().map(|own| {
        let [x, y] = own.place.map(|x| length.from_base(x));
        let [fx, fy] = own.force.map(|value| force.from_base(value));
        let [dx, dy] = own.deviation.map(|value| force.from_base(value));
        vec![x, y, fx, dx, fy, dy, f64::from(u8::from(own.inside))]
    });
    csv_table(&header, rows)
}

/// The same for the summary.
pub(super) fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let unit = experiment.display.force;
    let [x, y] = by_nodes(found).map(|own| own.map(|value| unit.from_base(value)));
    let excess = found
        .checks
        .excess
        .map(|own| own.map(|own| own.map(|value| unit.from_base(value))));
    json!({
        "unit": unit.name,
        "x": x[0],
        "x_deviation": x[1],
        "y": y[0],
        "y_deviation": y[1],
        "imbalance": imbalance(found),
        "excess_over_known": excess.map(|own| own.map(|own| own[0])),
        "excess_deviation": excess.map(|own| own.map(|own| own[1])),
    })
}

/// Force along x and y at the edge's nodes and its standard deviation `[N]`.
fn by_nodes(found: &Analysed) -> [[f64; 2]; 2] {
    let forces = &found.forces;
    let size = forces.values.len();
    [2, 3].map(|row| {
        let variance = forces.covariance[row * size + row];
        [forces.values[row], variance.max(0.0).sqrt()]
    })
}

/// Force on the edge by its stresses plus that by its nodes, over the latter; `None` where that is within its uncertainty. Where the edge
/// ends, its last nodes carry forces of the neighbouring edges too, so that some per cent remain on any mesh.
fn imbalance(found: &Analysed) -> Option<f64> {
    const BEYOND: f64 = 3.0;
    let values = &found.forces.values;
    let [[x, dx], [y, dy]] = by_nodes(found);
    let force = x.hypot(y);
    (force > BEYOND * dx.hypot(dy)).then(|| (values[0] + x).hypot(values[1] + y) / force)
}
