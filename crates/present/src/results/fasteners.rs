//! What fasteners hand on, as tables and in `summary.json`.

use serde::Serialize;
use stickslip_report::table::Table;
use stickslip_results::{Fastener, FastenerStep, LayerStep, Results};
use stickslip_scene::schema::DisplayUnits;
use stickslip_scene::units::Unit;
use stickslip_text::significant;

use super::display::{energy, energy_unit};
use super::quantity::{Quantity, Vector};

/// One table for each fastener, one row per load step and layer.
pub(super) fn tables(results: &Results) -> Vec<Table> {
    let fasteners = results.fasteners.iter().enumerate();
    fasteners
        .map(|(index, fastener)| table(results, index, fastener))
        .collect()
}

fn table(results: &Results, index: usize, fastener: &Fastener) -> Table {
    let DisplayUnits { length, force, .. } = results.units;
    let (of_force, of_length) = (force.name, length.name);
    let headings = format!(
        "step | plate | force x [{of_force}] | force y [{of_force}] | displacement x [{of_length}] | displacement y [{of_length}] | tilting moment [{}]",
        energy_unit(results.units)
    );
    let shown = |unit: &Unit, value: f64| significant(unit.from_base(value), 5);
    let caption = format!("Fastener '{}': forces of the plates on it", fastener.name);
    let mut table = Table::headed(caption, &headings);
    for (number, step) in (1..).zip(&results.steps) {
        let FastenerStep { layers, tilting } = &step.fasteners[index];
        let moment = energy(results.units, tilting[0].hypot(tilting[1]));
        for (place, (layer, at)) in layers.iter().zip(&fastener.layers).enumerate() {
            let of_step = |text: String| if place == 0 { text } else { String::new() };
            let [force_x, force_y] = layer.force.map(|part| shown(force, part));
            let [moved_x, moved_y] = layer.displacement.map(|part| shown(length, part));
            table.push([
                of_step(number.to_string()),
                results.bodies[at.plate].name.clone(),
                force_x,
                force_y,
                moved_x,
                moved_y,
                of_step(significant(moment, 4)),
            ]);
        }
    }
    table
}

/// A fastener in `summary.json`.
#[derive(Debug, Serialize)]
pub(super) struct Entry<'a> {
    name: &'a str,
    layers: Vec<LayerEntry<'a>>,
}

#[derive(Debug, Serialize)]
struct LayerEntry<'a> {
    slice: &'a str,
    plate: &'a str,
    height: Quantity,
}

/// The fasteners of `results`.
pub(super) fn entries(results: &Results) -> Vec<Entry<'_>> {
    let name = |body: usize| results.bodies[body].name.as_str();
    let entry = |fastener: &'_ Fastener| -> Vec<LayerEntry<'_>> {
        let layers = fastener.layers.iter();
        layers
            .map(|layer| LayerEntry {
                slice: name(layer.slice),
                plate: name(layer.plate),
                height: Quantity::of(results.units.length, layer.height),
            })
            .collect()
    };
    let all = results.fasteners.iter();
    all.map(|fastener| Entry {
        name: &fastener.name,
        layers: entry(fastener),
    })
    .collect()
}

/// A fastener at the end of a load step in `summary.json`.
#[derive(Debug, Serialize)]
pub(super) struct StepEntry {
    layers: Vec<LayerStepEntry>,
    tilting_moment: Quantity,
}

#[derive(Debug, Serialize)]
struct LayerStepEntry {
    force: Vector,
    moment: Quantity,
    shear: Vector,
    displacement: Vector,
}

/// A fastener at the end of a load step in `units`.
pub(super) fn step_entry(step: &FastenerStep, units: DisplayUnits) -> StepEntry {
    let DisplayUnits { length, force, .. } = units;
    let moment = |value: f64| Quantity::new(energy(units, value), energy_unit(units));
    let layer = |own: &LayerStep| LayerStepEntry {
        force: Vector::of(force, own.force),
        moment: moment(own.moment),
        shear: Vector::of(force, own.shear),
        displacement: Vector::of(length, own.displacement),
    };
    let [x, y] = step.tilting;
    StepEntry {
        layers: step.layers.iter().map(layer).collect(),
        tilting_moment: moment(x.hypot(y)),
    }
}
