//! Fitted laws in files and in the summary.

use serde_json::{Value, json};
use stickslip_hybrid::calibrate::Estimate;
use stickslip_hybrid::identify::Bounds;

use super::figures;
use stickslip_experiment::Experiment;
use stickslip_measure::laws::{Discrepancy, Fit, LawStage, MeshError, SharedNull};
use stickslip_report::csv;

pub(super) fn csv(experiment: &Experiment, stage: &LawStage) -> Vec<u8> {
    let headings = "law | parameter | unit | best | low | high | deviation | chi_squared | degrees_of_freedom | AICc | BIC";
    let mut rows = vec![csv::headings(headings)];
    for fit in &stage.comparison.fits {
        let calibration = &fit.calibration;
        for (index, own) in calibration.estimates.iter().enumerate() {
            let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
            let scaled = |value: Option<f64>| number(value.map(|value| factor * value));
            let [low, high] = fit
                .bounds(index)
                .map_or([None; 2], Bounds::ends)
                .map(scaled);
            rows.push(vec![
                fit.law.name.clone(),
                own.name.clone(),
                unit.to_owned(),
                format!("{}", factor * own.value),
                low,
                high,
                scaled(own.deviation.filter(|_| fit.explains())),
                format!("{}", calibration.chi_squared),
                calibration.degrees().to_string(),
                format!("{}", calibration.aicc()),
                format!("{}", calibration.bic()),
            ]);
        }
    }
    csv::texts(rows)
}

fn number(value: Option<f64>) -> String {
    value.map_or_else(String::new, |value| format!("{value}"))
}

pub(super) fn fit_csv(experiment: &Experiment, stage: &LawStage, observation: usize) -> Vec<u8> {
    let unit = experiment.display.length;
    let mut header: Vec<String> = ["x", "y"]
        .map(|name| format!("{name} [{}]", unit.name))
        .into();
    header.push("component (0: u, 1: v)".to_owned());
    header.push(format!("measured [{}]", unit.name));
    let names = stage.comparison.fits.iter().map(|fit| &fit.law.name);
    header.extend(names.map(|name| format!("{name} [{}]", unit.name)));
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
    csv::numbers(header, rows)
}

pub(super) fn entry(experiment: &Experiment, stage: &LawStage) -> Value {
    let comparison = &stage.comparison;
    let laws = comparison.fits.iter().map(|fit| law(experiment, fit));
    let discrepancies = stage.discrepancies.iter();
    let shared = stage.shared_nulls.iter();
    let mesh = comparison.mesh_error.as_ref();
    json!({
        "best": comparison.best().law.name,
        "data": comparison.data,
        "effective_data": comparison.best().calibration.effective_data(),
        "variance_scales": stage.scales.iter().map(|own| own.factor).collect::<Vec<_>>(),
        "variance_scales_by": stage.scales.iter().map(|own| own.source.describe()).collect::<Vec<_>>(),
        "shared_nulls": shared.map(|own| shared_null(experiment, own)).collect::<Vec<_>>(),
        "longest_slip_path": experiment.display.length.from_base(stage.slipped),
        "bounds_hold_mesh_error": mesh.is_some(),
        "mesh_error": mesh.map(|own| mesh_error(experiment, stage, own)),
        "mesh_discrepancies": discrepancies.map(|own| discrepancy(experiment, own.as_ref())).collect::<Vec<_>>(),
        "confidence": experiment.identify.confidence,
        "fits": laws.collect::<Vec<_>>(),
    })
}

fn law(experiment: &Experiment, fit: &Fit) -> Value {
    let own = &fit.calibration;
    let parameter = |(index, estimate): (usize, &Estimate)| {
        let (factor, unit) = figures::unit(experiment, fit.law.dimensions[index]);
        let [low, high] = fit
            .bounds(index)
            .map_or([None; 2], Bounds::ends)
            .map(|end| end.map(|end| factor * end));
        json!({
            "name": estimate.name,
            "unit": unit,
            "best": factor * estimate.value,
            "low": low,
            "high": high,
            "identifiable": fit.bounds(index).unwrap_or(estimate.bounds) != Bounds::Nothing,
            "by_mesh": fit.by_mesh.get(index).map(|own| factor * own),
        })
    };
    json!({
        "name": fit.law.name,
        "law": fit.law.kind,
        "parameters": own.estimates.iter().enumerate().map(parameter).collect::<Vec<_>>(),
        "chi_squared": own.chi_squared,
        "degrees_of_freedom": own.degrees(),
        "rejected": !fit.explains(),
        "aicc": own.aicc(),
        "bic": own.bic(),
        "solves": own.evaluations,
        "refused": own.refusals,
        "first_refusal": own.first_refusal,
        "verdict": fit.describe(),
    })
}

fn discrepancy(experiment: &Experiment, own: Option<&Discrepancy>) -> Value {
    let length = experiment.display.length;
    own.map_or(Value::Null, |own| {
        json!({
            "rms": length.from_base(own.rms),
            "largest": length.from_base(own.largest),
            "chi_squared": own.chi_squared,
        })
    })
}

fn mesh_error(experiment: &Experiment, stage: &LawStage, own: &MeshError) -> Value {
    let states = stage.states.iter().zip(&own.states).map(|(&state, own)| {
        json!({
            "state": experiment.states[state].name,
            "rms": experiment.display.length.from_base(own.rms),
            "amount": own.amount.value,
            "deviation": own.amount.deviation,
        })
    });
    json!({ "law": own.law, "states": states.collect::<Vec<_>>() })
}

fn shared_null(experiment: &Experiment, own: &SharedNull) -> Value {
    let name = |&state: &usize| experiment.states[state].name.as_str();
    json!({
        "states": own.states.iter().map(name).collect::<Vec<_>>(),
        "data": own.data,
        "correlation": own.correlation,
    })
}
