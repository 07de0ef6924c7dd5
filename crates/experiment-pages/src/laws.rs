//! Fitted laws on the page.

mod figures;
mod files;
mod transition;

use stickslip_hybrid::calibrate::Estimate;
use stickslip_hybrid::identify::Bounds;
use stickslip_report::context;
use stickslip_report::prose::{Prose, Value};
use stickslip_report::table::{Column, Table};

use crate::report::ExperimentReport;
use stickslip_experiment::Experiment;
use stickslip_measure::laws::{Fit, LawStage, Scale, ScaleSource};
use stickslip_text::short;

/// Stands in place of an interval where χ² rejects the model.
const REJECTED: &str = "no interval: the model is rejected";

/// Reports the fitted laws.
pub fn report(experiment: &Experiment, stage: &LawStage, report: &mut ExperimentReport) {
    let comparison = &stage.comparison;
    let best = comparison.best();
    report.section("Friction laws fitted by contact solves");
    report.prose(introduction(experiment, stage));
    report.table(laws(stage));
    report.table(parameters(experiment, stage));
    pictures(experiment, stage, report);
    if !stage.sensitivities.is_empty() {
        report.table(sensitivities(experiment, stage));
    }
    report.findings(experiment, stage.located());
    report.answer(
        "Friction law",
        format!("{}: {}", best.law.name, best.describe()),
    );
    for (index, own) in best.calibration.estimates.iter().enumerate() {
        let name = format!("{} of {}", own.name, best.law.name);
        report.answer(&name, describe_parameter(experiment, best, index, own));
    }
    report.file(
        "laws.csv",
        "the fitted laws and their parameters",
        files::csv(experiment, stage),
    );
    for (observation, &state) in stage.states.iter().enumerate() {
        let name = &experiment.states[state].name;
        report.file(
            format!("law-fit-{name}.csv"),
            "measured and predicted displacements",
            files::fit_csv(experiment, stage, observation),
        );
    }
    report.entry("laws", files::entry(experiment, stage));
}

/// Profiles, residuals, predictions and the transition.
fn pictures(experiment: &Experiment, stage: &LawStage, report: &mut ExperimentReport) {
    report.figure(
        "law-profiles",
        "How much χ² grows when one parameter is held at a value and all others follow; the data rule out what lies above the line.",
        figures::profiles(experiment, stage),
    );
    report.figure(
        "law-residuals",
        "What each law leaves of the measured displacements within 0.3 radii of the edge, means over 5°: a law that does not hold leaves \
         waves.",
        figures::residuals(experiment, stage),
    );
    report.figure(
        "law-predictions",
        "Measured displacements within 0.3 radii of the edge and those of the best law, means over 5°.",
        figures::predictions(experiment, stage),
    );
    if let Some(figure) = transition::figure(experiment, stage) {
        report.figure(
            "law-passage",
            &format!(
                "The coefficient of a slipping point along its slip path, as far as the best law lets a point slip; dashed: {} %, by the \
                 covariance of the parameters.",
                short(100.0 * experiment.identify.confidence)
            ),
            figure,
        );
    }
}

/// How laws are compared, and what their intervals hold.
fn introduction(experiment: &Experiment, stage: &LawStage) -> Prose {
    let comparison = &stage.comparison;
    let best = &comparison.best().calibration;
    let inflation = best.correlation.inflation;
    let mesh_law = comparison.mesh_error.as_ref().map(|own| own.law.clone());
    Prose::new(
        include_str!("laws/text.jinja"),
        context! {
            data => comparison.data,
            states => stage.observations.len(),
            free_motion => free_motion(stage),
            milliseconds => short(1e3 * comparison.evaluation_seconds),
            edge_nodes => stage.edge_nodes,
            scales => scales(experiment, stage),
            inflation => (inflation > 1.0).then(|| short(inflation.sqrt())),
            fitted_data => best.data,
            effective_data => best.effective_data().round().to_string(),
            shared_nulls => shared_nulls(experiment, stage),
            mesh_law,
            mesh_error => mesh_error(experiment, stage),
            discrepancies => discrepancies(experiment, stage),
        },
    )
}

/// By what the variances of the states were multiplied; nothing where all are as stated.
fn scales(experiment: &Experiment, stage: &LawStage) -> Vec<Value> {
    let stated = |scale: &Scale| scale.source == ScaleSource::Stated;
    if stage.scales.iter().all(stated) {
        return Vec::new();
    }
    let each = stage.states.iter().zip(&stage.scales);
    each.map(|(&state, scale)| {
        context! {
            factor => short(scale.factor),
            state => &experiment.states[state].name,
            source => scale.source.describe(),
        }
    })
    .collect()
}

/// What the errors of null fields do to the states that share one.
fn shared_nulls(experiment: &Experiment, stage: &LawStage) -> Vec<Value> {
    let name = |&state: &usize| format!("'{}'", experiment.states[state].name);
    let each = stage.shared_nulls.iter().map(|own| {
        context! {
            states => own.states.iter().map(name).collect::<Vec<_>>().join(", "),
            data => own.data,
            correlation => short(own.correlation),
            too_narrow => short(own.too_narrow()),
        }
    });
    each.collect()
}

/// How much of the error of the model's mesh the data show, if intervals hold it.
fn mesh_error(experiment: &Experiment, stage: &LawStage) -> Option<String> {
    let own = stage.comparison.mesh_error.as_ref()?;
    let (scale, unit) = figures::scale(experiment);
    let each = stage.states.iter().zip(&own.states);
    let each = each.map(|(&state, own)| {
        format!(
            "{} ± {} times {} {unit} rms in state '{}'",
            short(own.amount.value),
            short(own.amount.deviation),
            short(scale * own.rms),
            experiment.states[state].name,
        )
    });
    Some(each.collect::<Vec<_>>().join("; "))
}

/// What the model's mesh makes of the true friction in the states where that is known.
fn discrepancies(experiment: &Experiment, stage: &LawStage) -> String {
    let (scale, unit) = figures::scale(experiment);
    let each = stage
        .states
        .iter()
        .zip(&stage.discrepancies)
        .zip(&stage.observations);
    let each = each.filter_map(|((&state, own), observation)| {
        let own = own.as_ref()?;
        Some(format!(
            "{} {unit} rms and {} {unit} at most in state '{}', χ² = {} of {} data",
            short(scale * own.rms),
            short(scale * own.largest),
            experiment.states[state].name,
            short(own.chi_squared),
            observation.values.len(),
        ))
    });
    each.collect::<Vec<_>>().join("; ")
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
    let headings = "law | free parameters | χ² | χ² per degree of freedom | AICc above the best law's | BIC above the least | solves | \
                    verdict";
    let rows = stage.comparison.fits.iter().map(|fit| {
        let own = &fit.calibration;
        let solves = match own.refusals {
            0 => own.evaluations.to_string(),
            some => format!("{} ({some} without solution)", own.evaluations),
        };
        [
            fit.law.name.clone(),
            own.estimates.len().to_string(),
            short(own.chi_squared),
            format!("{:.3}", own.reduced()),
            format!("{:.1}", fit.distance),
            format!("{:.1}", fit.bic_distance),
            solves,
            fit.describe(),
        ]
    });
    let table = Table::headed("Laws compared", headings).with_rows(rows);
    table.with_notes(include_str!("laws/verdicts.txt"))
}

fn parameters(experiment: &Experiment, stage: &LawStage) -> Table {
    let percent = short(100.0 * experiment.identify.confidence);
    let caption = format!("Parameters, with intervals of {percent} %");
    let headings = "law | parameter | unit | best fit | interval | looked for from | to";
    let mut table = Table::headed(caption, headings);
    for fit in &stage.comparison.fits {
        for (index, own) in fit.calibration.estimates.iter().enumerate() {
            let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
            let [low, high] = fit.law.parameters[index]
                .range
                .map(|value| short(factor * value));
            let bounds = fit.bounds(index);
            let value = match bounds {
                Some(Bounds::Nothing) => "–".to_owned(),
                _ => short(factor * own.value),
            };
            table.push([
                fit.law.name.clone(),
                own.name.clone(),
                unit.to_owned(),
                value,
                bounds.map_or_else(|| REJECTED.to_owned(), |own| interval(own, factor)),
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

fn describe_parameter(experiment: &Experiment, fit: &Fit, index: usize, own: &Estimate) -> String {
    let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
    let text = match fit.bounds(index) {
        None => format!("{} {unit} at best; {REJECTED}", short(factor * own.value)),
        Some(bounds @ Bounds::Between(..)) => {
            let interval = interval(bounds, factor);
            format!("{} ({interval}) {unit}", short(factor * own.value))
        }
        Some(bounds) => format!("{} {unit}", interval(bounds, factor)),
    };
    text.trim_end().to_owned()
}

fn sensitivities(experiment: &Experiment, stage: &LawStage) -> Table {
    let (_, unit) = figures::scale(experiment);
    let factor = match experiment.grating {
        Some(_) => 1.0,
        None => experiment.display.length.from_base(1.0),
    };
    let caption = "How far the edge moves with a parameter";
    let mut table = Table::headed(caption, "law | parameter | from | to");
    let states = stage.states.iter();
    let states = states.map(|&state| Column::new(&experiment.states[state].name, unit));
    table.columns.extend(states);
    for (law, index, own) in &stage.sensitivities {
        let fit = &stage.comparison.fits[*law];
        let (scale, _) = figures::unit(experiment, fit.law.dimensions[*index]);
        let estimate = &fit.calibration.estimates[*index];
        let mut row = vec![
            fit.law.name.clone(),
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
        "Largest change of a displacement along the edge, less the rigid motion that fits best, all other parameters at their best fit.",
    )
}
