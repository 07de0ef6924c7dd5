//! The force that crosses the edge of a region.

use serde_json::{Value, json};
use stickslip_report::table::Table;

use crate::findings::why;
use stickslip_experiment::Experiment;
use stickslip_measure::analysed::{Analysed, ForceCheck, LoadCheck};
use stickslip_report::csv;
use stickslip_text::short;

const AXES: [&str; 2] = ["x", "y"];

/// Forces on the edges of all states, by their nodes, and how well the stresses agree.
pub(super) fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.force;
    let is_known = |axis: &usize| {
        let mut all = analysed.iter();
        all.any(|found| found.checks.force[*axis].is_some())
    };
    let known: Vec<usize> = (0..2).filter(is_known).collect();
    let mut headings = format!(
        "state | along x [{0}] | ± [{0}] | along y [{0}] | ± [{0}] | balance [% of the force]",
        unit.name
    );
    for &axis in &known {
        let excess = format!(
            " | over known: {} [{1}] | ± [{1}] | explained [{1}]",
            AXES[axis], unit.name
        );
        headings += &excess;
    }
    let loads: Vec<_> = (analysed.iter())
        .map(|found| found.load_check(experiment).ok())
        .collect();
    let by_load = loads.iter().any(Option::is_some);
    if by_load {
        headings += " | over load";
    }
    let caption = "Force on the region through its edge, with standard deviations";
    let mut table = Table::headed(caption, &headings);
    for (found, load) in analysed.iter().zip(&loads) {
        let mut row = vec![experiment.states[found.state].name.clone()];
        for [force, deviation] in by_nodes(found) {
            row.extend([force, deviation].map(|value| short(unit.from_base(value))));
        }
        row.push(imbalance(found).map_or_else(String::new, |part| format!("{:.1}", 100.0 * part)));
        for &axis in &known {
            let compared = found.checks.force[axis].map(|own| {
                [own.excess, own.deviation, own.explained].map(|value| short(unit.from_base(value)))
            });
            row.extend(compared.unwrap_or_default());
        }
        if by_load {
            let ratio = |own: LoadCheck| format!("{:.3}", own.force / own.load);
            row.push(load.map_or_else(String::new, ratio));
        }
        table.push(row);
    }
    if by_load {
        table = table.with_notes(include_str!("by_load.txt"));
    }
    let table = table.with_notes(include_str!("by_nodes.txt"));
    if known.is_empty() {
        return table;
    }
    table.with_notes(include_str!("over_known.txt"))
}

/// Forces at the nodes that move as measured.
pub(super) fn csv(experiment: &Experiment, found: &Analysed) -> Vec<u8> {
    let (length, force) = (experiment.display.length, experiment.display.force);
    let headings = csv::headings(&format!(
        "x [{0}] | y [{0}] | force x [{1}] | force x deviation [{1}] | force y [{1}] | force y deviation [{1}] | inside",
        length.name, force.name
    ));
    let rows = found.nodal_forces.iter().map(|own| {
        let [x, y] = own.place.map(|x| length.from_base(x));
        let [fx, fy] = own.force.map(|value| force.from_base(value));
        let [dx, dy] = own.deviation.map(|value| force.from_base(value));
        vec![x, y, fx, dx, fy, dy, f64::from(own.inside)]
    });
    csv::numbers(headings, rows)
}

/// The same for the summary.
pub(super) fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let unit = experiment.display.force;
    let [x, y] = by_nodes(found).map(|own| own.map(|value| unit.from_base(value)));
    let checks = found.checks.force;
    let each = |value: fn(&ForceCheck) -> f64| {
        let own = |check: Option<ForceCheck>| check.map(|own| unit.from_base(value(&own)));
        checks.map(own)
    };
    let load = found.load_check(experiment);
    json!({
        "unit": unit.name,
        "by_load": load.as_ref().ok().map(|own| json!({
            "force": unit.from_base(own.force),
            "deviation": unit.from_base(own.deviation),
            "load": unit.from_base(own.load),
            "ratio": own.force / own.load,
        })),
        "load_not_checked": load.as_ref().err().map(|reason| why(*reason)),
        "x": x[0],
        "x_deviation": x[1],
        "y": y[0],
        "y_deviation": y[1],
        "imbalance": imbalance(found),
        "excess_over_known": each(|own| own.excess),
        "excess_deviation": each(|own| own.deviation),
        "excess_explained": each(|own| own.explained),
        "is_evidence": checks.map(|own| own.map(|own| own.is_evidence())),
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
