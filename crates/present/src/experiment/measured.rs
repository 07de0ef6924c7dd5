//! Measured fields on the page, as tables, and in the summary.

mod figures;
mod signs;

use serde_json::{Value, json};
use stickslip_hybrid::data::Field;
use stickslip_report::table::{Column, Table};

use crate::experiment::gallery::caption;
use crate::experiment::story::{Story, csv_table};
pub(super) use signs::signs;
use stickslip_measure::measured::{Measured, repeated};
use stickslip_scene::experiment::{Experiment, Method, Source, State};
use stickslip_text::{counted, short, significant};

/// Tells of the measured fields of all states.
pub(crate) fn tell(experiment: &Experiment, fields: &[Measured], story: &mut Story) {
    story.section("Measured fields");
    story.text(
        "Displacements of the specimen, less the null field where one was given. Pictures do not tell whole orders or the motion of the \
         plate as a whole: U and V are known up to a constant, and so kept; no stress depends on it.",
    );
    story.text(settings(experiment));
    story.table(table(experiment, fields));
    story.report(experiment, repeated(experiment, fields));
    if fields.iter().any(|measured| !measured.rotations.is_empty()) {
        story.table(rotations(experiment, fields));
    }
    for measured in fields {
        one(experiment, measured, story);
    }
    if fields.iter().any(|measured| !measured.symmetry.is_empty()) {
        story.table(symmetry(experiment, fields));
    }
    let valid: usize = fields
        .iter()
        .map(|measured| {
            Field::BOTH
                .map(|field| measured.measurement.count(field))
                .iter()
                .sum::<usize>()
        })
        .sum();
    story.answer(
        "Measured fields",
        format!("{}, {valid} displacements", counted(fields.len(), "state")),
    );
    for (names, words) in signs(experiment) {
        story.answer(&format!("Signs of {names}"), words);
    }
    story.entry(
        "measured",
        fields
            .iter()
            .map(|measured| entry(experiment, measured))
            .collect(),
    );
}

/// How fields are made, defaults included.
fn settings(experiment: &Experiment) -> String {
    let reduce = &experiment.reduce;
    let length = experiment.display.length;
    let method = match reduce.method {
        Method::Fit => "a fit of the region's boundary to all data".to_owned(),
        Method::Linear => "linear interpolation on triangles".to_owned(),
        Method::Polynomial { order, neighbours } => {
            format!("local polynomials of order {order} over {neighbours} neighbours")
        }
        Method::Lines { .. } => "linear interpolation between fringe centres".to_owned(),
    };
    let pictured = |state: &State| matches!(state.source, Source::Step(_) | Source::Pictures(_));
    let margin = match reduce.margin {
        Some(margin) => format!("{} beyond its edge", length.show(margin)),
        None if experiment.states.iter().any(pictured) => {
            "what a phase of fringes with a carrier resolves beyond its edge".to_owned()
        }
        None => "nothing beyond its edge".to_owned(),
    };
    let mut words = format!(
        "Masked: the hole, {margin}, and {} further areas. Displacements of nodes by {method}.",
        reduce.mask.len()
    );
    if experiment.states.iter().any(State::has_table) {
        let outliers = match reduce.outliers {
            Some(threshold) => format!(
                " Places of tables are masked as outliers where U or V is off a plane through its neighbours by more than {threshold} \
                 times what is usual there ([reduce] outliers)."
            ),
            None => " No outliers are looked for.".to_owned(),
        };
        words.push_str(&outliers);
    }
    if experiment.states.iter().any(pictured) {
        let pictures = format!(
            " Pictures: a band of {} around the carrier, fringes below {} of their median amplitude masked.",
            reduce.band, reduce.least_modulation
        );
        words.push_str(&pictures);
    }
    words
}

fn one(experiment: &Experiment, measured: &Measured, story: &mut Story) {
    let name = &experiment.states[measured.state].name;
    let what = caption(experiment, measured.state);
    if let Some(figure) = figures::phase(experiment, measured) {
        let of_null = measured
            .pictures
            .iter()
            .flatten()
            .any(|field| field.of_null);
        let whose = if of_null { " of the null field" } else { "" };
        let text = format!(
            "Phase of the fringes{whose} less the carrier, {what}. Where loops of pixels do not close, orders depend on the path."
        );
        story.figure(&format!("phase-{name}"), &text, figure);
    }
    if let Some(figure) = figures::orders(experiment, measured) {
        let text = format!("Fringe orders without carrier, {what}; each field up to a constant.");
        story.figure(&format!("orders-{name}"), &text, figure);
    } else {
        let text = format!("Measured displacements, {what}.");
        let figure = figures::data(experiment, measured);
        story.figure(&format!("data-{name}"), &text, figure);
    }
    story.report(experiment, measured.located(experiment));
    story.file(
        format!("measured-{name}.csv"),
        "measured displacements; empty where masked",
        csv(experiment, measured),
    );
}

fn csv(experiment: &Experiment, measured: &Measured) -> Vec<u8> {
    let unit = experiment.display.length;
    let header = ["x", "y", "u", "v"].map(|name| format!("{name} [{}]", unit.name));
    let data = &measured.measurement;
    let rows = (0..data.places.len()).map(|k| {
        let value = |c: usize| {
            if data.valid[c][k] {
                data.displacements[c][k]
            } else {
                f64::NAN
            }
        };
        let [x, y] = data.places[k];
        [x, y, value(0), value(1)]
            .map(|x| unit.from_base(x))
            .to_vec()
    });
    csv_table(&header, rows)
}

fn table(experiment: &Experiment, fields: &[Measured]) -> Table {
    let length = experiment.display.length;
    let columns = vec![
        Column::new("state", ""),
        Column::new("field", ""),
        Column::new("places", ""),
        Column::new("masked", ""),
        Column::new("as outliers", ""),
        Column::new("least", length.name),
        Column::new("greatest", length.name),
        Column::new("deviation", length.name),
        Column::new("deviation", "fringes"),
        Column::new("open loops", ""),
        Column::new("jumps", ""),
    ];
    let mut table = Table::new("What was measured", columns);
    for measured in fields {
        for field in Field::BOTH {
            table.push(row(experiment, measured, field));
        }
    }
    table
}

fn row(experiment: &Experiment, measured: &Measured, field: Field) -> Vec<String> {
    let unit = experiment.display.length;
    let c = field.component();
    let data = &measured.measurement;
    let values = || {
        (0..data.places.len())
            .filter(|&k| data.valid[c][k])
            .map(|k| data.displacements[c][k])
    };
    let count = data.count(field);
    let shown = |value: f64| {
        if count == 0 {
            String::new()
        } else {
            short(unit.from_base(value))
        }
    };
    let deviation = data.deviation[c];
    let fringes = experiment.grating.map(|grating| grating.order(deviation));
    let picture = measured.pictures[c].as_ref();
    let number = |count: Option<usize>| count.map_or_else(String::new, |count| count.to_string());
    vec![
        experiment.states[measured.state].name.clone(),
        field.name().to_owned(),
        data.places.len().to_string(),
        (data.places.len() - count).to_string(),
        number(is_table(experiment, measured).then_some(measured.outliers.len())),
        shown(values().fold(f64::INFINITY, f64::min)),
        shown(values().fold(f64::NEG_INFINITY, f64::max)),
        shown(deviation),
        fringes.map_or_else(String::new, |fringes| format!("{fringes:.4}")),
        number(picture.map(|picture| picture.residues.len())),
        number(picture.map(|picture| picture.cuts.len())),
    ]
}

fn rotations(experiment: &Experiment, fields: &[Measured]) -> Table {
    let columns = vec![
        Column::new("state", ""),
        Column::new("field", ""),
        Column::new("rotation", "deg"),
        Column::new("±", "deg"),
        Column::new("masked for it", ""),
    ];
    let mut table = Table::new("Rotations that were taken off", columns);
    for measured in fields {
        for own in &measured.rotations {
            let [angle, deviation] = own.degrees();
            table.push(vec![
                experiment.states[measured.state].name.clone(),
                if own.of_null { "null" } else { "state" }.to_owned(),
                short(angle),
                significant(deviation, 2),
                own.masked.to_string(),
            ]);
        }
    }
    table.note(
        "Counter-clockwise against the reference picture, about the middle of the hole, as finite rotations: displacements are those in the \
         frame of the specimen. The rotation is the mean one of the field; the part of it that loads make, of the order of the strains, is in no \
         stress. Its standard deviation moves stresses by less than that part of them, and no band holds it.",
    )
}

fn is_table(experiment: &Experiment, measured: &Measured) -> bool {
    matches!(experiment.states[measured.state].source, Source::Table(_))
}

fn symmetry(experiment: &Experiment, fields: &[Measured]) -> Table {
    let length = experiment.display.length;
    let columns = vec![
        Column::new("state", ""),
        Column::new("field", ""),
        Column::new("largest difference", "fringes"),
        Column::new("at x", length.name),
        Column::new("y", length.name),
        Column::new("places", ""),
        Column::new("symmetric", ""),
    ];
    let mut table = Table::new("Front against back", columns);
    for measured in fields {
        for (field, found) in &measured.symmetry {
            table.push(vec![
                experiment.states[measured.state].name.clone(),
                field.name().to_owned(),
                format!("{:.3}", found.largest),
                short(length.from_base(found.place[0])),
                short(length.from_base(found.place[1])),
                found.compared.to_string(),
                if found.symmetric { "yes" } else { "no" }.to_owned(),
            ]);
        }
    }
    table
}

fn entry(experiment: &Experiment, measured: &Measured) -> Value {
    let unit = experiment.display.length;
    let data = &measured.measurement;
    let field = |field: Field| {
        let c = field.component();
        let picture = measured.pictures[c].as_ref();
        let symmetry = measured.symmetry.iter().find(|(own, _)| *own == field);
        json!({
            "places": data.places.len(),
            "valid": data.count(field),
            "deviation": unit.from_base(data.deviation[c]),
            "open_loops": picture.map(|picture| picture.residues.len()),
            "jumps": picture.map(|picture| picture.cuts.len()),
            "carrier_per_mm": picture.map(|picture| picture.carrier),
            "symmetry_fringes": symmetry.map(|(_, found)| found.largest),
            "symmetric": symmetry.map(|(_, found)| found.symmetric),
        })
    };
    let rotations: Vec<Value> = (measured.rotations.iter())
        .map(|own| {
            let [angle, deviation] = own.degrees();
            json!({
                "of": if own.of_null { "null" } else { "state" },
                "degrees": angle,
                "deviation_degrees": deviation,
                "masked": own.masked,
            })
        })
        .collect();
    json!({
        "state": experiment.states[measured.state].name,
        "length_unit": unit.name,
        "rotations": rotations,
        "outliers": is_table(experiment, measured).then_some(measured.outliers.len()),
        "u": field(Field::U),
        "v": field(Field::V),
    })
}
