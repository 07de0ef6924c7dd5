//! The force that crosses the edge of a region.

use serde_json::{Value, json};
use stickslip_report::table::{Column, Table};

use super::Analysed;
use crate::experiment::plan::Experiment;
use crate::output::short;

/// Forces on the edges of all states, by their nodes, and how well the stresses agree.
pub(super) fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.force;
    let columns = vec![
        Column::new("state", ""),
        Column::new("along x", unit.name),
        Column::new("±", unit.name),
        Column::new("along y", unit.name),
        Column::new("±", unit.name),
        Column::new("balance", "% of the force"),
    ];
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
        table.push(row);
    }
    table.note(
        "By the forces that hold the edge's nodes, of the whole edge of a sector and not only where it is in contact. Balance: what these \
         and the integral of the edge's stresses differ by, a check of the mesh; the ends of the edge leave some per cent.",
    )
}

/// The same for the summary.
pub(super) fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let unit = experiment.display.force;
    let [x, y] = by_nodes(found).map(|own| own.map(|value| unit.from_base(value)));
    json!({ "unit": unit.name, "x": x[0], "x_deviation": x[1], "y": y[0], "y_deviation": y[1], "imbalance": imbalance(found) })
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
