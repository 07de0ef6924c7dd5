//! Bearing and bypass loads of plates, as tables and in `summary.json`.

use std::collections::BTreeMap;

use serde::Serialize;
use stickslip_report::table::Table;
use stickslip_results::{PlateRows, Results, RowForces};
use stickslip_scene::units::Unit;
use stickslip_text::significant;

use super::quantity::Quantity;

/// One table for each plate, one row per load step and row of fasteners.
pub(super) fn tables(results: &Results) -> Vec<Table> {
    let plates = results.plates_with_rows();
    plates.iter().map(|plate| table(results, plate)).collect()
}

fn table(results: &Results, plate: &PlateRows) -> Table {
    let (length, force) = (results.units.length, results.units.force);
    let (of_length, of_force) = (length.name, force.name);
    let headings = format!(
        "step | at x [{of_length}] | fasteners | incoming [{of_force}] | bearing [{of_force}] | bypass [{of_force}] | unbalanced [{of_force}]"
    );
    let caption = format!(
        "Bearing and bypass along x in '{}': incoming = bearing + bypass, tension is positive",
        results.bodies[plate.body].name
    );
    let mut table = Table::headed(caption, &headings);
    for step in 0..results.steps.len() {
        let forces = results.row_forces(plate, step);
        let scale = largest(&forces);
        for (place, ((x, _), own)) in plate.rows.iter().zip(&forces).enumerate() {
            let shown = |value: f64| significant(force.from_base(rounded(value, scale)), 5);
            table.push([
                if place == 0 {
                    (step + 1).to_string()
                } else {
                    String::new()
                },
                significant(length.from_base(*x), 5),
                contacts(results, plate, place).join(", "),
                shown(own.incoming()),
                shown(own.bearing()),
                shown(own.bypass()),
                significant(force.from_base(own.unbalanced()), 1),
            ]);
        }
    }
    table
}

/// The largest section force of a step.
fn largest(forces: &[RowForces]) -> f64 {
    forces
        .iter()
        .fold(0.0, |most, own| most.max(own.incoming().abs()))
}

/// Zero where `value` is rounding beside `scale`.
fn rounded(value: f64, scale: f64) -> f64 {
    const ROUNDING: f64 = 1e-8;
    if value.abs() <= ROUNDING * scale {
        0.0
    } else {
        value
    }
}

/// Names of the contacts in the row `place`.
fn contacts<'a>(results: &'a Results, plate: &PlateRows, place: usize) -> Vec<&'a str> {
    let own = plate.rows[place].1.iter();
    own.map(|&contact| results.edges[contact].name.as_str())
        .collect()
}

/// A row of fasteners at the end of a load step in `summary.json`.
#[derive(Debug, Serialize)]
pub(super) struct Entry<'a> {
    x: Quantity,
    contacts: Vec<&'a str>,
    incoming: Quantity,
    bearing: Quantity,
    bypass: Quantity,
    unbalanced: Quantity,
}

/// The rows of `plates` at the end of the step with the index `step`, by the names of the plates.
pub(super) fn entries<'a>(
    results: &'a Results,
    plates: &[PlateRows],
    step: usize,
) -> BTreeMap<&'a str, Vec<Entry<'a>>> {
    let (length, force) = (results.units.length, results.units.force);
    let of = |unit: &Unit, value: f64| Quantity::of(unit, value);
    let entry = |plate: &PlateRows| -> Vec<Entry<'a>> {
        let forces = results.row_forces(plate, step);
        let scale = largest(&forces);
        let rows = plate.rows.iter().zip(&forces).enumerate();
        rows.map(|(place, ((x, _), own))| Entry {
            x: of(length, *x),
            contacts: contacts(results, plate, place),
            incoming: of(force, rounded(own.incoming(), scale)),
            bearing: of(force, rounded(own.bearing(), scale)),
            bypass: of(force, rounded(own.bypass(), scale)),
            unbalanced: of(force, own.unbalanced()),
        })
        .collect()
    };
    let named = |plate: &PlateRows| (results.bodies[plate.body].name.as_str(), entry(plate));
    plates.iter().map(named).collect()
}
