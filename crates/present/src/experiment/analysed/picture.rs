//! What the pictures may have added to the displacements of states, on the page and in the summary.

use serde_json::{Value, json};
use stickslip_measure::analysed::{Analysed, PictureMotion};
use stickslip_report::table::{Column, Table};
use stickslip_scene::experiment::{Experiment, FreeMotion};
use stickslip_text::{short, significant};

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

/// What a reader must know of it.
pub(super) fn doubts(experiment: &Experiment, found: &Analysed) -> Vec<String> {
    let unit = experiment.display.stress;
    let open = found.picture.iter().filter(|own| own.amount.is_none());
    if experiment.reduce.free.is_empty() {
        return Vec::new();
    }
    open.map(|own| {
        format!(
            "the {} of the picture is declared free, and cannot be told from the load: no part of the region's edge is clear of contact beyond doubt, \
             or the tractions there are not those of such a motion, but of mesh, material or contact. It is not taken off; 1e-5 of it changes the \
             pressure by up to {} {}. Take a region whose edge goes on beyond the contact, and finer cells.",
            own.motion.name(),
            short(unit.from_base(1e-5 * own.pressure)),
            unit.name
        )
    })
    .collect()
}

/// A dilation that would explain tractions on the free edge, in words.
pub(super) fn explanation(found: &Analysed) -> String {
    let own = found
        .picture
        .iter()
        .find(|own| own.motion == FreeMotion::Dilation && !own.taken_off);
    let Some([amount, deviation]) = own.and_then(|own| own.amount) else {
        return String::new();
    };
    format!(
        " If the picture was dilated, by {} ± {}, [reduce] free = [\"dilation\"] takes that off.",
        short(amount),
        significant(deviation, 2)
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
