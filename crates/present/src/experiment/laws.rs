//! Fitted laws on the page.

mod figures;
mod files;
mod passage;

use stickslip_hybrid::calibrate::Estimate;
use stickslip_hybrid::identify::Bounds;
use stickslip_report::table::{Column, Table};

use crate::experiment::story::Story;
use stickslip_measure::laws::{Fit, LawStage, Scale, ScaleSource, SharedNull};
use stickslip_scene::experiment::Experiment;
use stickslip_text::short;

/// Stands in place of an interval where χ² rejects the model.
const REJECTED: &str = "no interval: the model is rejected";

/// Reports the fitted laws.
pub fn tell(experiment: &Experiment, stage: &LawStage, story: &mut Story) {
    let comparison = &stage.comparison;
    let best = comparison.best();
    story.section("Friction laws fitted by contact solves");
    story.text(format!(
        "Each law was put into the contact of the scene, its load history solved, and the displacements compared with {} measured ones of \
         {} states; of each state {} is free and not compared. Bodies are condensed once: a history with what is seen of it takes {} ms by itself on {} \
         nodes of the edge. The interval of a parameter is where χ² stays within its limit when all other parameters follow. Where χ² \
         rejects a model there is none: no interval of the noise holds the errors of a model.",
        comparison.data,
        stage.observations.len(),
        free_motion(stage),
        short(1e3 * comparison.evaluation_seconds),
        stage.edge_nodes,
    ));
    story.text(scaled(experiment, stage));
    story.text(correlated(stage));
    for own in &stage.shared_nulls {
        story.text(sharing(experiment, own));
    }
    story.text(mesh_error(experiment, stage));
    if let Some(words) = meshed(experiment, stage) {
        story.text(words);
    }
    story.table(laws(stage));
    story.table(parameters(experiment, stage));
    pictures(experiment, stage, story);
    if !stage.sensitivities.is_empty() {
        story.table(sensitivities(experiment, stage));
    }
    story.report(experiment, stage.located());
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
        files::csv(experiment, stage),
    );
    for (observation, &state) in stage.states.iter().enumerate() {
        let name = &experiment.states[state].name;
        story.file(
            format!("law-fit-{name}.csv"),
            "measured and predicted displacements",
            files::fit_csv(experiment, stage, observation),
        );
    }
    story.entry("laws", files::entry(experiment, stage));
}

/// Profiles, residuals, predictions and the passage.
fn pictures(experiment: &Experiment, stage: &LawStage, story: &mut Story) {
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
    if let Some(figure) = passage::figure(experiment, stage) {
        story.figure(
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

/// By what the variances of the states were multiplied.
fn scaled(experiment: &Experiment, stage: &LawStage) -> String {
    let stated = |scale: &Scale| scale.source == ScaleSource::Stated;
    if stage.scales.iter().all(stated) {
        return "No fit says by how much the errors of the data exceed their deviation: it is taken as stated.".to_owned();
    }
    let each = stage.states.iter().zip(&stage.scales);
    let each: Vec<String> = each
        .map(|(&state, scale)| {
            format!(
                "{} in state '{}', by {}",
                short(scale.factor),
                experiment.states[state].name,
                scale.source.words()
            )
        })
        .collect();
    format!(
        "The variance of the data was multiplied by what fits that know of no friction law say of their deviation: {}.",
        each.join("; ")
    )
}

/// How many independent data the data count as.
fn correlated(stage: &LawStage) -> String {
    let own = &stage.comparison.best().calibration;
    let inflation = own.correlation.inflation;
    if inflation <= 1.0 {
        return "Residuals of neighbouring data do not go together: data count in full.".to_owned();
    }
    format!(
        "Residuals of neighbouring data go together, or exceed their deviation: {} data count as {} independent ones in criteria, and \
         intervals are wider by the factor {}.",
        own.data,
        own.effective_data().round(),
        short(inflation.sqrt()),
    )
}

/// What the errors of one null field do to several states.
fn sharing(experiment: &Experiment, own: &SharedNull) -> String {
    let names = own
        .states
        .iter()
        .map(|&state| &experiment.states[state].name);
    let names: Vec<String> = names.map(|name| format!("'{name}'")).collect();
    if own.data == 0 {
        return format!(
            "States {} have one null field, whose errors are in all of them, but no places in common at which these would show. The fit \
             takes states for independent of each other; how much that does to intervals is not known.",
            names.join(", ")
        );
    }
    format!(
        "States {} have one null field, whose errors are in all of them: at {} common data what the best law leaves correlates by {}. The \
         fit takes states for independent of each other. That makes intervals too narrow by a factor of {} at most, for a parameter that \
         moves all of these states alike, and too wide for one that moves them oppositely.",
        names.join(", "),
        own.data,
        short(own.correlation),
        short(own.too_narrow()),
    )
}

/// Whether intervals hold the error of the model's mesh, and how much of it the data show.
fn mesh_error(experiment: &Experiment, stage: &LawStage) -> String {
    let Some(own) = &stage.comparison.mesh_error else {
        return "Intervals hold the errors of the data alone, not that of the model's mesh."
            .to_owned();
    };
    let (scale, unit) = figures::scale(experiment);
    let each = stage.states.iter().zip(&own.states);
    let each: Vec<String> = each
        .map(|(&state, own)| {
            format!(
                "{} ± {} times {} {unit} rms in state '{}'",
                short(own.amount.value),
                short(own.amount.deviation),
                short(scale * own.rms),
                experiment.states[state].name,
            )
        })
        .collect();
    format!(
        "Intervals hold the error of the model's mesh so far as it has the shape of the difference to a mesh twice as coarse, solved with \
         '{}': its amount is free in each state, normal about zero with a deviation of once that difference, and the same for all laws. \
         The data show, beside the best law, {}.",
        own.law,
        each.join("; ")
    )
}

/// What the model's mesh makes of the true friction, where that is known.
fn meshed(experiment: &Experiment, stage: &LawStage) -> Option<String> {
    let (scale, unit) = figures::scale(experiment);
    let each = stage
        .states
        .iter()
        .zip(&stage.discrepancies)
        .zip(&stage.observations);
    let each: Vec<String> = each
        .filter_map(|((&state, own), observation)| {
            let own = own.as_ref()?;
            Some(format!(
                "{} {unit} rms and {} {unit} at most in state '{}', χ² = {} of {} data",
                short(scale * own.rms),
                short(scale * own.largest),
                experiment.states[state].name,
                short(own.chi_squared),
                observation.values.len(),
            ))
        })
        .collect();
    (!each.is_empty()).then(|| {
        format!(
            "The data are synthetic, so that the error of the model's own mesh is known: with the friction of the scene its displacements \
             differ from the truth's by {}.",
            each.join("; ")
        )
    })
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
        Column::new("AICc above the best law's", ""),
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
        "A law whose AICc is less than 2 above that of the best is as good; from 10 it has next to no support (Burnham & Anderson 2002). BIC \
         counts further parameters more heavily. A law with more parameters is not preferred for displacements that a mesh twice as coarse \
         does not show.",
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
            let bounds = fit.bounds(index);
            let value = match bounds {
                Some(Bounds::Nothing) => "–".to_owned(),
                _ => short(factor * own.value),
            };
            table.push(vec![
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

fn words(experiment: &Experiment, fit: &Fit, index: usize, own: &Estimate) -> String {
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
    let mut columns = ["law", "parameter", "from", "to"]
        .map(|name| Column::new(name, ""))
        .to_vec();
    for &state in &stage.states {
        columns.push(Column::new(&experiment.states[state].name, unit));
    }
    let mut table = Table::new("How far the edge moves with a parameter", columns);
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
