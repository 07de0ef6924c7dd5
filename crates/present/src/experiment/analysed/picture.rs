//! What the pictures may have added to the displacements of states, on the page and in the summary.

use serde_json::{Value, json};
use stickslip_measure::analysed::{Analysed, PictureMotion};
use stickslip_report::table::{Column, Table};
use stickslip_scene::experiment::Experiment;
use stickslip_text::short;

/// What may have been added to each state.
pub(super) fn table(experiment: &Experiment, analysed: &[Analysed]) -> Table {
    let unit = experiment.display.stress;
    let mut table = Table::new(
        "What the pictures may have added",
        vec![
            Column::new("state", ""),
            Column::new("motion", ""),
            Column::new("amount", "1e-6"),
            Column::new("±", "1e-6"),
            Column::new("pressure by it", unit.name),
            Column::new("taken off", ""),
        ],
    );
    for found in analysed {
        for own in &found.picture {
            let told = |value: f64| short(1e6 * value);
            let [amount, deviation] = own.amount.map_or_else(
                || ["not separable".to_owned(), String::new()],
                |amount| amount.map(told),
            );
            let pressure = own.amount.map(|[amount, _]| amount.abs() * own.pressure);
            table.push(vec![
                experiment.states[found.state].name.clone(),
                own.motion.name().to_owned(),
                amount,
                deviation,
                pressure.map_or_else(String::new, |pressure| short(unit.from_base(pressure))),
                if own.taken_off { "yes" } else { "no" }.to_owned(),
            ]);
        }
    }
    table.note(
        "A specimen that comes nearer to the camera, or tilts towards it, is seen larger: a strain at the distance of the hole's radius, with \
         its standard deviation by noise and smoothing. The region itself takes it for a load; the tractions on the edge clear of contact, \
         which are none, say how much it is, as far as mesh and material are right. [reduce] free = [\"dilation\", \"tilt\"] takes it off and \
         adds its uncertainty to all bands.",
    )
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
