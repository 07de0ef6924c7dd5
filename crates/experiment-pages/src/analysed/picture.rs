//! What the pictures may have added to the displacements of states, on the page and in the summary.

use serde_json::{Value, json};

use crate::findings::yes_or_no;
use stickslip_experiment::Experiment;
use stickslip_measure::analysed::{Analysed, PictureMotion};
use stickslip_report::table::Table;
use stickslip_text::short;

/// What may have been added to each state.
pub(super) fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.stress;
    let headings = format!(
        "state | motion | amount [1e-6] | ± [1e-6] | pressure by it [{}] | taken off",
        unit.name
    );
    let mut table = Table::headed("What the pictures may have added", &headings);
    for found in analysed {
        for own in &found.picture {
            let [amount, deviation] = own.amount.map_or_else(
                || ["not separable".to_owned(), String::new()],
                |amount| amount.map(|value| short(1e6 * value)),
            );
            let pressure = own.amount.map(|[amount, _]| amount.abs() * own.pressure);
            table.push([
                experiment.states[found.state].name.clone(),
                own.motion.name().to_owned(),
                amount,
                deviation,
                pressure.map_or_else(String::new, |pressure| short(unit.from_base(pressure))),
                yes_or_no(own.taken_off),
            ]);
        }
    }
    table.with_notes(include_str!("picture.txt"))
}

/// The same for the summary.
pub(super) fn entry(experiment: &Experiment, found: &Analysed) -> Value {
    let unit = experiment.display.stress;
    let one = |own: &PictureMotion| {
        json!({
            "name": own.motion.name(),
            "value": own.amount.map(|own| own[0]),
            "deviation": own.amount.map(|own| own[1]),
            "separable": own.amount.is_some(),
            "taken_off": own.taken_off,
            "pressure_per_unit": unit.from_base(own.pressure),
        })
    };
    found.picture.iter().map(one).collect()
}
