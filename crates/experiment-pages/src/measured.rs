//! Measured fields on the page, as tables, and in the summary.

mod figures;
mod signs;

use serde_json::{Value, json};
use stickslip_hybrid::data::Field;
use stickslip_report::axis::ends;
use stickslip_report::context;
use stickslip_report::prose::Prose;
use stickslip_report::table::Table;

use crate::findings::yes_or_no;
use crate::gallery::caption;
use crate::report::ExperimentReport;
pub(super) use signs::signs;
use stickslip_experiment::{Experiment, Method, Source, State};
use stickslip_measure::measured::{Measured, repeated};
use stickslip_report::csv;
use stickslip_text::{counted, short, significant};

/// Reports the measured fields of all states.
pub(crate) fn report(experiment: &Experiment, fields: &[Measured], report: &mut ExperimentReport) {
    report.section("Measured fields");
    report.prose(introduction(experiment));
    report.table(table(experiment, fields));
    report.findings(experiment, repeated(experiment, fields));
    if fields.iter().any(|measured| !measured.rotations.is_empty()) {
        report.table(rotations(experiment, fields));
    }
    for measured in fields {
        one(experiment, measured, report);
    }
    if fields.iter().any(|measured| !measured.symmetry.is_empty()) {
        report.table(symmetry(experiment, fields));
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
    report.answer(
        "Measured fields",
        format!("{}, {valid} displacements", counted(fields.len(), "state")),
    );
    for (names, signs) in signs(experiment) {
        report.answer(&format!("Signs of {names}"), signs);
    }
    report.entry(
        "measured",
        fields
            .iter()
            .map(|measured| entry(experiment, measured))
            .collect(),
    );
}

/// What is measured, and how fields are made, defaults included.
fn introduction(experiment: &Experiment) -> Prose {
    let reduce = &experiment.reduce;
    let method = match reduce.method {
        Method::Fit => "a fit of the region's boundary to all data".to_owned(),
        Method::Linear => "linear interpolation on triangles".to_owned(),
        Method::Polynomial { order, neighbours } => {
            format!("local polynomials of order {order} over {neighbours} neighbours")
        }
        Method::Lines { .. } => "linear interpolation between fringe centres".to_owned(),
    };
    let pictured = |state: &State| matches!(state.source, Source::Step(_) | Source::Pictures(_));
    let pictures = experiment.states.iter().any(pictured);
    let margin = match reduce.margin {
        Some(margin) => experiment.display.length.show(margin),
        None if pictures => "what a phase of fringes with a carrier resolves".to_owned(),
        None => "nothing".to_owned(),
    };
    Prose::new(
        include_str!("measured/text.jinja"),
        context! {
            method,
            margin,
            areas => reduce.mask.len(),
            tables => experiment.states.iter().any(State::has_table),
            outliers => reduce.outliers.map(|threshold| threshold.to_string()),
            pictures,
            band => reduce.band.to_string(),
            modulation => reduce.least_modulation.to_string(),
        },
    )
}

fn one(experiment: &Experiment, measured: &Measured, report: &mut ExperimentReport) {
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
        report.figure(&format!("phase-{name}"), &text, figure);
    }
    if let Some(figure) = figures::orders(experiment, measured) {
        let text = format!("Fringe orders without carrier, {what}; each field up to a constant.");
        report.figure(&format!("orders-{name}"), &text, figure);
    } else {
        let text = format!("Measured displacements, {what}.");
        let figure = figures::data(experiment, measured);
        report.figure(&format!("data-{name}"), &text, figure);
    }
    report.findings(experiment, measured.located(experiment));
    report.file(
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
    csv::numbers(header.into(), rows)
}

fn table(experiment: &Experiment, fields: &[Measured]) -> Table {
    let length = experiment.display.length.name;
    let headings = format!(
        "state | field | places | masked | as outliers | least [{length}] | greatest [{length}] | deviation [{length}] | \
         deviation [fringes] | open loops | jumps"
    );
    let rows = fields.iter().flat_map(|measured| {
        let both = Field::BOTH.into_iter();
        both.map(|field| row(experiment, measured, field))
    });
    Table::headed("What was measured", &headings).with_rows(rows)
}

fn row(experiment: &Experiment, measured: &Measured, field: Field) -> [String; 11] {
    let unit = experiment.display.length;
    let c = field.component();
    let data = &measured.measurement;
    let places = data.places.len();
    let valid = (0..places).filter(|&k| data.valid[c][k]);
    let [least, greatest] = ends(valid.map(|k| data.displacements[c][k]));
    let count = data.count(field);
    let shown = |value: f64| match count {
        0 => String::new(),
        _ => short(unit.from_base(value)),
    };
    let deviation = data.deviation[c];
    let fringes = experiment.grating.map(|grating| grating.order(deviation));
    let picture = measured.pictures[c].as_ref();
    let number = |count: Option<usize>| count.map_or_else(String::new, |count| count.to_string());
    [
        experiment.states[measured.state].name.clone(),
        field.name().to_owned(),
        places.to_string(),
        (places - count).to_string(),
        number(is_table(experiment, measured).then_some(measured.outliers.len())),
        shown(least),
        shown(greatest),
        shown(deviation),
        fringes.map_or_else(String::new, |fringes| format!("{fringes:.4}")),
        number(picture.map(|picture| picture.residues.len())),
        number(picture.map(|picture| picture.cuts.len())),
    ]
}

fn rotations(experiment: &Experiment, fields: &[Measured]) -> Table {
    let headings = "state | field | rotation [deg] | ± [deg] | masked for it";
    let mut table = Table::headed("Rotations that were taken off", headings);
    for measured in fields {
        for own in &measured.rotations {
            let [angle, deviation] = own.degrees();
            table.push([
                experiment.states[measured.state].name.clone(),
                if own.of_null { "null" } else { "state" }.to_owned(),
                short(angle),
                significant(deviation, 2),
                own.masked.to_string(),
            ]);
        }
    }
    table.with_notes(include_str!("measured/rotations.txt"))
}

fn is_table(experiment: &Experiment, measured: &Measured) -> bool {
    matches!(experiment.states[measured.state].source, Source::Table(_))
}

fn symmetry(experiment: &Experiment, fields: &[Measured]) -> Table {
    let length = experiment.display.length;
    let headings = format!(
        "state | field | largest difference [fringes] | at x [{0}] | y [{0}] | places | symmetric",
        length.name
    );
    let mut table = Table::headed("Front against back", &headings);
    for measured in fields {
        for (field, found) in &measured.symmetry {
            let [x, y] = found.place.map(|x| short(length.from_base(x)));
            table.push([
                experiment.states[measured.state].name.clone(),
                field.name().to_owned(),
                format!("{:.3}", found.largest),
                x,
                y,
                found.compared.to_string(),
                yes_or_no(found.symmetric),
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
