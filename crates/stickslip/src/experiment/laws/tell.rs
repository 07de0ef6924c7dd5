//! Fitted laws on the page, as tables, and in the summary.

use serde_json::{Value, json};
use stickslip_hybrid::calibrate::Estimate;
use stickslip_hybrid::identify::Bounds;
use stickslip_report::table::{Column, Table};

use super::{Fit, LawStage, figures};
use crate::experiment::plan::Experiment;
use crate::experiment::story::{Story, csv_table};
use crate::output::short;

/// Tells of the fitted laws.
pub fn tell(experiment: &Experiment, stage: &LawStage, story: &mut Story) {
    let comparison = &stage.comparison;
    let best = comparison.best();
    story.section("Friction laws fitted by contact solves");
    story.text(format!(
        "Each law was put into the contact of the scene, its load history solved, and the displacements compared with {} measured ones of \
         {} states; of each state {} is free and not compared. Bodies are condensed once: a history with what is seen of it takes {} ms by itself on {} \
         nodes of the edge. The interval of a parameter is where χ² stays within its limit when all other parameters follow.",
        comparison.data,
        stage.observations.len(),
        free_motion(stage),
        short(1e3 * comparison.evaluation_seconds),
        stage.edge_nodes,
    ));
    if stage.scales.iter().any(|scale| *scale > 1.0) {
        story.text(scaled(experiment, stage));
    }
    story.table(laws(stage));
    story.table(parameters(experiment, stage));
    story.figure(
        "law-profiles",
        "How much χ² grows when one parameter is held at a value and all others follow; the data rule out what lies above the line.",
        figures::profiles(experiment, stage),
    );
    story.figure(
        "law-residuals",
        "What each law leaves of the measured displacements within 0.3 radii of the edge, means over 5°: a law that does not hold leaves \
         waves.",
        figures::residuals(experiment, stage),
    );
    story.figure(
        "law-predictions",
        "Measured displacements within 0.3 radii of the edge and those of the best law, means over 5°.",
        figures::predictions(experiment, stage),
    );
    if !stage.sensitivities.is_empty() {
        story.table(sensitivities(experiment, stage));
    }
    if comparison
        .fits
        .iter()
        .any(|fit| fit.law.kind == "static_dynamic")
    {
        story.note(
            "The drop from static to dynamic friction has no length of its own: what the static coefficient does depends on the spacing of \
             the contact nodes, and its bounds move with the mesh.",
        );
    }
    for words in &stage.warnings {
        story.warn(words.clone());
    }
    if !best.explains() {
        story.warn(format!(
            "No law explains the data: that of the best, '{}', leaves χ² = {} of {} degrees of freedom, {} standard deviations too many. \
             Intervals are too narrow; look at the residuals near the edge.",
            best.law.name,
            short(best.calibration.chi_squared),
            best.calibration.degrees(),
            short(best.calibration.excess()),
        ));
    }
    story.answer(
        "Friction law",
        format!("{}: {}", best.law.name, best.words()),
    );
    for (index, own) in best.calibration.estimates.iter().enumerate() {
        let name = format!("{} of {}", own.name, best.law.name);
        story.answer(&name, words(experiment, best, index, own));
    }
    story.file(
        "laws.csv",
        "the fitted laws and their parameters",
        csv(experiment, stage),
    );
    for (observation, &state) in stage.states.iter().enumerate() {
        let name = &experiment.states[state].name;
        story.file(
            format!("law-fit-{name}.csv"),
            "measured and predicted displacements",
            fit_csv(experiment, stage, observation),
        );
    }
    story.entry("laws", entry(experiment, stage));
}

/// By what the variances of the states were multiplied.
fn scaled(experiment: &Experiment, stage: &LawStage) -> String {
    let each = stage.states.iter().zip(&stage.scales);
    let each: Vec<String> = each
        .map(|(&state, scale)| {
            format!(
                "{} in state '{}'",
                short(*scale),
                experiment.states[state].name
            )
        })
        .collect();
    format!(
        "The variance of the data was multiplied by what the residuals of the localized analysis, which knows of no friction law, say of \
         their deviation: {}.",
        each.join(", ")
    )
}

fn free_motion(stage: &LawStage) -> &'static str {
    let mut own = stage.observations.iter().map(|own| own.nuisance);
    let first = own.next().unwrap_or_default();
    if own.all(|other| other == first) {
        first.name()
    } else {
        "a rigid motion or a plane"
    }
}

fn laws(stage: &LawStage) -> Table {
    let columns = vec![
        Column::new("law", ""),
        Column::new("free parameters", ""),
        Column::new("χ²", ""),
        Column::new("χ² per degree of freedom", ""),
        Column::new("AICc above the least", ""),
        Column::new("BIC above the least", ""),
        Column::new("solves", ""),
        Column::new("verdict", ""),
    ];
    let mut table = Table::new("Laws compared", columns);
    for fit in &stage.comparison.fits {
        let own = &fit.calibration;
        let solves = match own.refusals {
            0 => own.evaluations.to_string(),
            some => format!("{} ({some} without solution)", own.evaluations),
        };
        table.push(vec![
            fit.law.name.clone(),
            own.estimates.len().to_string(),
            short(own.chi_squared),
            format!("{:.3}", own.reduced()),
            format!("{:.1}", fit.distance),
            format!("{:.1}", fit.bic_distance),
            solves,
            fit.words(),
        ]);
    }
    table.note(
        "A law whose AICc is less than 2 above the least is as good; from 10 it has next to no support (Burnham & Anderson 2002). BIC \
         counts further parameters more heavily.",
    )
}

fn parameters(experiment: &Experiment, stage: &LawStage) -> Table {
    let columns = [
        "law",
        "parameter",
        "unit",
        "best fit",
        "interval",
        "looked for from",
        "to",
    ];
    let columns = columns.map(|name| Column::new(name, "")).into();
    let percent = short(100.0 * experiment.identify.confidence);
    let mut table = Table::new(
        format!("Parameters, with intervals of {percent} %"),
        columns,
    );
    for fit in &stage.comparison.fits {
        for (index, own) in fit.calibration.estimates.iter().enumerate() {
            let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
            let range = fit.law.parameters[index]
                .range
                .map(|value| short(factor * value));
            let [low, high] = range;
            let value = match own.bounds {
                Bounds::Nothing => "–".to_owned(),
                _ => short(factor * own.value),
            };
            table.push(vec![
                fit.law.name.clone(),
                own.name.clone(),
                unit.to_owned(),
                value,
                interval(own.bounds, factor),
                low,
                high,
            ]);
        }
    }
    table
}

fn interval(bounds: Bounds, factor: f64) -> String {
    let shown = |value: f64| short(factor * value);
    match bounds {
        Bounds::Between(low, high) => format!("{} … {}", shown(low), shown(high)),
        Bounds::AtMost(high) => format!("at most {}", shown(high)),
        Bounds::AtLeast(low) => format!("at least {}", shown(low)),
        Bounds::Nothing => "not identifiable".to_owned(),
    }
}

fn words(experiment: &Experiment, fit: &Fit, index: usize, own: &Estimate) -> String {
    let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
    let interval = interval(own.bounds, factor);
    let text = match own.bounds {
        Bounds::Between(..) => format!("{} ({interval}) {unit}", short(factor * own.value)),
        _ => format!("{interval} {unit}"),
    };
    text.trim_end().to_owned()
}

fn sensitivities(experiment: &Experiment, stage: &LawStage) -> Table {
    let best = stage.comparison.best();
    let (_, unit) = figures::scale(experiment);
    let factor = match experiment.grating {
        Some(_) => 1.0,
        None => experiment.display.length.from_base(1.0),
    };
    let mut columns = vec![
        Column::new("parameter", ""),
        Column::new("from", ""),
        Column::new("to", ""),
    ];
    for &state in &stage.states {
        columns.push(Column::new(&experiment.states[state].name, unit));
    }
    let mut table = Table::new(
        format!(
            "How far the edge moves with a parameter of '{}'",
            best.law.name
        ),
        columns,
    );
    for (index, own) in &stage.sensitivities {
        let (scale, _) = figures::unit(experiment, best.law.dimensions[*index]);
        let estimate = &best.calibration.estimates[*index];
        let mut row = vec![
            estimate.name.clone(),
            short(scale * estimate.value),
            short(scale * own.values[*index]),
        ];
        let steps = stage
            .observations
            .iter()
            .map(|observation| observation.step);
        row.extend(steps.map(|step| short(factor * own.deformation[step])));
        table.push(row);
    }
    table.note(
        "Largest change of a displacement along the edge, less the rigid motion that fits best.",
    )
}

fn csv(experiment: &Experiment, stage: &LawStage) -> Vec<u8> {
    let header =
        "law,parameter,unit,best,low,high,deviation,chi_squared,degrees_of_freedom,AICc,BIC";
    let mut text = header.to_owned() + "\n";
    for fit in &stage.comparison.fits {
        let calibration = &fit.calibration;
        for (index, own) in calibration.estimates.iter().enumerate() {
            let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
            let [low, high] = ends(own.bounds).map(|end| number(end.map(|end| factor * end)));
            let cells = [
                format!("\"{}\"", fit.law.name.replace('"', "\"\"")),
                own.name.clone(),
                unit.to_owned(),
                format!("{}", factor * own.value),
                low,
                high,
                number(own.deviation.map(|own| factor * own)),
                format!("{}", calibration.chi_squared),
                calibration.degrees().to_string(),
                format!("{}", calibration.aicc()),
                format!("{}", calibration.bic()),
            ];
            text += &(cells.join(",") + "\n");
        }
    }
    text.into_bytes()
}

fn ends(bounds: Bounds) -> [Option<f64>; 2] {
    match bounds {
        Bounds::Between(low, high) => [Some(low), Some(high)],
        Bounds::AtMost(high) => [None, Some(high)],
        Bounds::AtLeast(low) => [Some(low), None],
        Bounds::Nothing => [None, None],
    }
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value}"))
}

fn fit_csv(experiment: &Experiment, stage: &LawStage, observation: usize) -> Vec<u8> {
    let unit = experiment.display.length;
    let mut header: Vec<String> = ["x", "y"]
        .map(|name| format!("{name} [{}]", unit.name))
        .into();
    header.push("component (0: u, 1: v)".to_owned());
    header.push(format!("measured [{}]", unit.name));
    let names = stage.comparison.fits.iter().map(|fit| &fit.law.name);
    header.extend(names.map(|name| format!("\"{} [{}]\"", name.replace('"', "\"\""), unit.name)));
    let own = &stage.observations[observation];
    let rows = own.values.iter().enumerate().map(|(datum, value)| {
        let [x, y] = stage.place(observation, datum);
        let mut row = vec![unit.from_base(x), unit.from_base(y)];
        row.push(own.components[datum].1 as f64);
        row.push(unit.from_base(*value));
        let fits = stage.comparison.fits.iter();
        row.extend(fits.map(|fit| unit.from_base(fit.states[observation].predicted[datum])));
        row
    });
    csv_table(&header, rows)
}

fn entry(experiment: &Experiment, stage: &LawStage) -> Value {
    let law = |fit: &Fit| {
        let own = &fit.calibration;
        let parameter = |(index, estimate): (usize, &Estimate)| {
            let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
            let [low, high] = ends(estimate.bounds).map(|end| end.map(|end| factor * end));
            json!({
                "name": estimate.name,
                "unit": unit,
                "best": factor * estimate.value,
                "low": low,
                "high": high,
                "identifiable": estimate.bounds != Bounds::Nothing,
            })
        };
        json!({
            "name": fit.law.name,
            "law": fit.law.kind,
            "parameters": own.estimates.iter().enumerate().map(parameter).collect::<Vec<_>>(),
            "chi_squared": own.chi_squared,
            "degrees_of_freedom": own.degrees(),
            "aicc": own.aicc(),
            "bic": own.bic(),
            "solves": own.evaluations,
            "refused": own.refusals,
            "first_refusal": own.first_refusal,
            "verdict": fit.words(),
        })
    };
    json!({
        "best": stage.comparison.best().law.name,
        "data": stage.comparison.data,
        "variance_scales": stage.scales,
        "confidence": experiment.identify.confidence,
        "fits": stage.comparison.fits.iter().map(law).collect::<Vec<_>>(),
    })
}
