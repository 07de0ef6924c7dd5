//! From an experiment and its measured fields to fitted laws.

use std::sync::Arc;

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::calibrate::{Correlation, Parameter, Settings};

use super::compare::fit_with_progress;
use super::scale::squares;
use super::shared_null::shared_nulls;
use super::{
    Candidate, Comparison, ContactModel, Discrepancy, Fit, Known, LawsError, Nuisance, Observation,
    Scale, Sensitivity, SharedNull, coarser, decimated, discrepancies, fit, sensitivity,
};
use crate::error::ExperimentError;
use crate::finding::{Finding, LeftOut, LeftOutReason, Located, ModelFinding};
use crate::measured::Measured;
use crate::truth::Truth;
use stickslip_engine::run::Progress;
use stickslip_experiment::history::History;
use stickslip_experiment::{Experiment, Source, State};

/// Places of a state that are compared with predictions.
const MOST_PLACES: usize = 1000;

/// Laws fitted to an experiment.
#[derive(Debug)]
pub struct LawStage {
    /// The fits.
    pub comparison: Comparison,
    /// What they were fitted to.
    pub observations: Vec<Observation>,
    /// Index of the state of each observation.
    pub states: Vec<usize>,
    /// How far each free parameter of each law moves the edge: index of the law, index of the parameter, its change, and the
    /// displacements in fringes of the experiment's grating, or of one of a line per mm.
    pub sensitivities: Vec<(usize, usize, Sensitivity)>,
    /// Nodes of the edge in contact.
    pub edge_nodes: usize,
    /// The longest slip path of any contact point by the best law, up to the last state `[mm]`.
    pub slipped: f64,
    /// By what the variance of each observation was multiplied.
    pub scales: Vec<Scale>,
    /// States that share a null field, whose errors are not independent of each other.
    pub shared_nulls: Vec<SharedNull>,
    /// How far the model is from the truth at the data of each observation, where that is known.
    pub discrepancies: Vec<Option<Discrepancy>>,
    /// States that could not be used, and why; load steps that were assumed; solves that failed.
    pub findings: Vec<ModelFinding>,
}

/// Fits the laws of `experiment` to its measured fields; `None` where it names none. Where a state was analysed around the edge or as a
/// whole plate, the residuals of that fit, which knows of no law, say how much its errors exceed their stated standard deviation, and its
/// variance is scaled so. `progress` hears of every fit of a law.
///
/// # Errors
/// [`ExperimentError`]: no scene, no state that is a load step of it, a parameter that a law does not have, solves that fail.
pub fn stage(
    experiment: &Experiment,
    fields: &[Measured],
    known: Known<'_>,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<LawStage>, ExperimentError> {
    if experiment.laws.is_empty() {
        return Ok(None);
    }
    let laws = candidates(experiment)?;
    let own = (experiment.specimen.model.as_ref()).ok_or_else(without_scene)?;
    let model = ContactModel::for_laws(own, &laws).map_err(failed)?;
    let Compared {
        observations,
        states,
        scales,
        mut findings,
    } = compared(experiment, &model, &History::of(&own.scene), fields, known)?;
    let confidence = experiment.identify.confidence;
    let settings = Settings {
        confidence,
        correlation: Correlation {
            squares: squares(&observations, &states, known),
            ..Correlation::NONE
        },
        ..Settings::default()
    };
    let coarser = ContactModel::for_laws(&coarser(own), &laws);
    let comparison = fitted(
        &model,
        coarser,
        &laws,
        &observations,
        &settings,
        &mut findings,
        progress,
    )
    .map_err(failed)?;
    findings.extend(ModelFinding::of_mesh(experiment));
    let discrepancies = match known.truth {
        Some(truth) => discrepancies_of(experiment, &model, truth, &observations, &states),
        None => Ok(vec![None; states.len()]),
    }
    .map_err(failed)?;
    let count = observations.iter().map(|own| own.step + 1).max();
    let slipped = slipped(&model, comparison.best(), count.unwrap_or(0)).map_err(failed)?;
    let sensitivities = sensitivities(experiment, &model, &comparison, &mut findings);
    Ok(Some(LawStage {
        shared_nulls: shared_nulls(experiment, &states, &observations, comparison.best()),
        comparison,
        observations,
        states,
        sensitivities,
        edge_nodes: model.edge().len(),
        slipped,
        scales,
        discrepancies,
        findings,
    }))
}

fn without_scene() -> ExperimentError {
    ExperimentError::Missing {
        key: "laws".to_owned(),
        what: "laws are fitted by contact solves, and there is no scene to solve".to_owned(),
        remedy: "give [specimen] scene = \"scene.toml\" and body = \"plate\"".to_owned(),
    }
}

fn failed(cause: LawsError) -> ExperimentError {
    ExperimentError::Laws {
        key: "laws".to_owned(),
        cause: Box::new(cause),
    }
}

/// The states that are load steps of the scene.
#[derive(Default)]
struct Compared {
    observations: Vec<Observation>,
    states: Vec<usize>,
    scales: Vec<Scale>,
    findings: Vec<ModelFinding>,
}

fn compared(
    experiment: &Experiment,
    model: &ContactModel,
    history: &History,
    fields: &[Measured],
    known: Known<'_>,
) -> Result<Compared, ExperimentError> {
    let mut all = Compared::default();
    let mut reasons = Vec::new();
    for measured in fields {
        let state = &experiment.states[measured.state];
        match observed(model, history, state, measured, known) {
            Ok(own) => {
                all.observations.push(own.observation);
                all.scales.push(own.scale);
                all.states.push(measured.state);
                all.findings.extend(own.assumed);
            }
            Err(reason) => {
                let left_out = LeftOut {
                    state: state.name.clone(),
                    reason,
                };
                reasons.push(left_out.to_string());
                all.findings.push(ModelFinding::LeftOutOfLaws(left_out));
            }
        }
    }
    if !all.observations.is_empty() {
        return Ok(all);
    }
    Err(ExperimentError::Missing {
        key: "states".to_owned(),
        what: format!("no state can be compared with the scene. {}", reasons.join(" ")),
        remedy: "tie a state to the scene with step = 1, or with the load of one of its steps and its direction".to_owned(),
    })
}

/// The laws fitted with the error of the model's mesh in their intervals, as a coarser one shows it; without it where there is none.
fn fitted(
    model: &ContactModel,
    coarser: Result<ContactModel, LawsError>,
    laws: &[Candidate],
    observations: &[Observation],
    settings: &Settings,
    findings: &mut Vec<ModelFinding>,
    progress: &mut dyn FnMut(Progress),
) -> Result<Comparison, LawsError> {
    let two_meshes = coarser
        .and_then(|own| fit_with_progress([model, &own], laws, observations, settings, progress));
    two_meshes.or_else(|cause| {
        // Where data or laws are at fault and not the coarser mesh, this says so.
        let found = fit(model, laws, observations, settings)?;
        findings.push(ModelFinding::WithoutMeshError {
            cause: cause.to_string(),
        });
        Ok(found)
    })
}

/// Those of synthetic states, whose data come from the truth.
fn discrepancies_of(
    experiment: &Experiment,
    model: &ContactModel,
    truth: &Truth,
    observations: &[Observation],
    states: &[usize],
) -> Result<Vec<Option<Discrepancy>>, LawsError> {
    let mut found = discrepancies(model, truth, observations)?;
    for (own, &state) in found.iter_mut().zip(states) {
        if !experiment.states[state].source.is_synthetic() {
            *own = None;
        }
    }
    Ok(found)
}

fn candidates(experiment: &Experiment) -> Result<Vec<Candidate>, ExperimentError> {
    let plans = experiment.laws.iter();
    plans
        .map(|plan| {
            let candidate = Candidate::new(plan);
            let table = plan.key.rsplit_once('.').map_or("laws", |(table, _)| table);
            if plan.free.is_empty() {
                return Err(ExperimentError::Missing {
                    key: table.to_owned(),
                    what: format!("law '{}' has no free parameter to fit", plan.name),
                    remedy: "name at least one with its range: free = { mu = [0.0, 1.0] }"
                        .to_owned(),
                });
            }
            candidate.map_err(|(key, problem)| ExperimentError::Law {
                key: format!("{table}.{key}"),
                problem,
            })
        })
        .collect()
}

/// A state as laws are fitted to it.
struct Observed {
    observation: Observation,
    scale: Scale,
    assumed: Option<ModelFinding>,
}

/// The displacements of a state, or why they cannot be compared.
fn observed(
    model: &ContactModel,
    history: &History<'_>,
    state: &State,
    measured: &Measured,
    known: Known<'_>,
) -> Result<Observed, LeftOutReason> {
    let tied = history.tied(state)?;
    let inside = model.inside(&measured.measurement.places);
    let mut data = measured.measurement.clone();
    for valid in &mut data.valid {
        valid
            .iter_mut()
            .zip(&inside)
            .for_each(|(valid, inside)| *valid &= inside);
    }
    let mut data = decimated(&data, MOST_PLACES);
    if data.places.is_empty() {
        return Err(LeftOutReason::OutsideOfScene);
    }
    let scale = Scale::of(measured.state, known);
    for deviation in &mut data.deviation {
        *deviation *= scale.factor.sqrt();
    }
    let carriers_unknown =
        |source: &Source| matches!(source, Source::Pictures(own) if own.carrier.is_none());
    let observation = Observation {
        null: tied.null,
        nuisance: if carriers_unknown(&state.source) && state.null.is_none() {
            Nuisance::Carriers
        } else {
            Nuisance::Rigid
        },
        ..Observation::of_measurement(&state.name, tied.step, &data)
    };
    Ok(Observed {
        observation,
        scale,
        assumed: ModelFinding::of_null(history, state, &tied),
    })
}

/// Each free parameter of each law moved up and down; changes that have no solution are left out, with a finding.
fn sensitivities(
    experiment: &Experiment,
    model: &ContactModel,
    comparison: &Comparison,
    findings: &mut Vec<ModelFinding>,
) -> Vec<(usize, usize, Sensitivity)> {
    let frequency = experiment
        .grating
        .map_or(1.0, |grating| grating.frequency());
    let mut rows = Vec::new();
    for (law, fit) in comparison.fits.iter().enumerate() {
        for (index, to) in changes(fit) {
            let from = fit.calibration.values();
            match sensitivity(model, &fit.law, &from, std::slice::from_ref(&to), frequency) {
                Ok(found) => rows.extend(found.into_iter().map(|own| (law, index, own))),
                Err(cause) => findings.push(ModelFinding::SensitivityUnknown {
                    law: fit.law.name.clone(),
                    parameter: fit.law.parameters[index].name.clone(),
                    value: to[index],
                    cause: cause.to_string(),
                }),
            }
        }
    }
    rows
}

/// Each parameter of a law changed to either side, as far as the law exists there.
fn changes(fit: &Fit) -> Vec<(usize, Vec<f64>)> {
    let from = fit.calibration.values();
    let mut all = Vec::new();
    for (index, parameter) in fit.law.parameters.iter().enumerate() {
        for up in [false, true] {
            let mut to = from.clone();
            to[index] = changed(parameter, from[index], up);
            if to != from && fit.law.law(&to).is_ok() {
                all.push((index, to));
            }
        }
    }
    all
}

/// The longest slip path `[mm]` of any contact point by the best law after `count` load steps.
fn slipped(model: &ContactModel, best: &Fit, count: usize) -> Result<f64, LawsError> {
    let law = best.law.law(&best.calibration.values())?;
    let states = model.states(Arc::from(law), count)?;
    let history = states.last().map_or(&[][..], |state| &state.history);
    Ok(history
        .iter()
        .fold(0.0, |most, own| own.slip_path().max(most)))
}

/// Twice and half of what is looked for by its order of magnitude, a part of the range more and less of other parameters, as far as zero.
fn changed(parameter: &Parameter, value: f64, up: bool) -> f64 {
    const PART: f64 = 0.05;
    let [low, high] = parameter.range;
    let step = PART * (high - low);
    match (parameter.logarithmic, up) {
        (true, true) => 2.0 * value,
        (true, false) => 0.5 * value,
        (false, true) => value + step,
        (false, false) if low >= 0.0 => (value - step).max(0.0),
        (false, false) => value - step,
    }
}

impl LawStage {
    /// All that a reader must know of the fits, their own verdict last.
    pub fn located(&self) -> impl Iterator<Item = Located> {
        let (comparison, best) = (&self.comparison, self.comparison.best());
        let drops = |fit: &Fit| fit.law.drops_without_length(&fit.calibration.values());
        let drop = (comparison.fits.iter().any(drops)).then_some(ModelFinding::DropWithoutLength);
        let unexplained = (!best.explains()).then(|| ModelFinding::NoLawExplains {
            law: best.law.name.clone(),
            chi_squared: best.calibration.chi_squared,
            degrees: best.calibration.degrees(),
            excess: best.calibration.excess(),
        });
        let all = drop.into_iter().chain(self.findings.iter().cloned());
        let all = all.chain(unexplained);
        all.map(|finding| Located::of_all(Finding::Model(finding)))
    }

    /// Place `[mm]` of the datum `datum` of `observation`, both indices from 0.
    pub fn place(&self, observation: usize, datum: usize) -> Point {
        let own = &self.observations[observation];
        own.places[own.components[datum].0]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_change_is_a_part_of_the_range_whatever_the_unit() {
        let small = Parameter::new("slip_scale", [0.0, 0.002]);
        assert!((changed(&small, 0.001, true) - 0.0011).abs() < 1e-15);
        assert!((changed(&small, 0.001, false) - 0.0009).abs() < 1e-15);
        assert!(changed(&small, 0.00005, false).abs() < 1e-15);
        let signed = Parameter::new("shift", [-1.0, 1.0]);
        assert!((changed(&signed, 0.0, false) + 0.1).abs() < 1e-15);
        let order = Parameter::new("slip_scale", [1e-4, 1e-1]).logarithmic();
        assert!((changed(&order, 0.002, true) - 0.004).abs() < 1e-15);
    }
}
