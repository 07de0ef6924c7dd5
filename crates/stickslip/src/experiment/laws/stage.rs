//! From an experiment and its measured fields to fitted laws.

use stickslip_fem_core::mesh::Point;
use stickslip_hybrid::calibrate::Settings;

use super::{
    Candidate, Comparison, ContactModel, LawsError, Nuisance, Observation, Sensitivity, decimated,
    fit, sensitivity,
};
use crate::experiment::error::ExperimentError;
use crate::experiment::history::History;
use crate::experiment::measured::Measured;
use crate::experiment::plan::{Experiment, Source, State};

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
    /// How far each free parameter of the best law moves the edge: its index, its change, and the displacements in fringes of the
    /// experiment's grating, or of one of a line per mm.
    pub sensitivities: Vec<(usize, Sensitivity)>,
    /// Nodes of the edge in contact.
    pub edge_nodes: usize,
    /// States that could not be used, and why.
    pub warnings: Vec<String>,
}

/// Fits the laws of `experiment` to its measured fields; `None` where it names none.
///
/// # Errors
/// [`ExperimentError`]: no scene, no state that is a load step of it, a parameter that a law does not have, solves that fail.
pub fn stage(
    experiment: &Experiment,
    fields: &[Measured],
) -> Result<Option<LawStage>, ExperimentError> {
    if experiment.laws.is_empty() {
        return Ok(None);
    }
    let laws = candidates(experiment)?;
    let Some(own) = &experiment.specimen.scene else {
        return Err(ExperimentError::Missing {
            key: "laws".to_owned(),
            what: "laws are fitted by contact solves, and there is no scene to solve".to_owned(),
            remedy: "give [specimen] scene = \"scene.toml\" and body = \"plate\"".to_owned(),
        });
    };
    let failed = |cause| ExperimentError::Laws {
        key: "laws".to_owned(),
        cause: Box::new(cause),
    };
    let model = ContactModel::new(own).map_err(failed)?;
    let history = History::of(&own.scene);
    let (mut observations, mut states, mut warnings) = (Vec::new(), Vec::new(), Vec::new());
    for measured in fields {
        let state = &experiment.states[measured.state];
        match observed(&model, &history, state, measured) {
            Ok(observation) => {
                observations.push(observation);
                states.push(measured.state);
            }
            Err(reason) => warnings.push(format!(
                "State '{}' is not among the data of the laws: {reason}.",
                state.name
            )),
        }
    }
    if observations.is_empty() {
        return Err(ExperimentError::Missing {
            key: "states".to_owned(),
            what: format!("no state can be compared with the scene. {}", warnings.join(" ")),
            remedy: "tie a state to the scene with step = 1, or with the load of one of its steps and its direction".to_owned(),
        });
    }
    let settings = Settings {
        confidence: experiment.identify.confidence,
        ..Settings::default()
    };
    let comparison = fit(&model, &laws, &observations, &settings).map_err(failed)?;
    let sensitivities = sensitivities(experiment, &model, &comparison).map_err(failed)?;
    Ok(Some(LawStage {
        comparison,
        observations,
        states,
        sensitivities,
        edge_nodes: model.edge().len(),
        warnings,
    }))
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

/// The displacements of a state, or in words why they cannot be compared.
fn observed(
    model: &ContactModel,
    history: &History<'_>,
    state: &State,
    measured: &Measured,
) -> Result<Observation, String> {
    let (step, null) = history.tied(state)?;
    let inside = model.inside(&measured.measurement.places);
    let mut data = measured.measurement.clone();
    for valid in &mut data.valid {
        valid
            .iter_mut()
            .zip(&inside)
            .for_each(|(valid, inside)| *valid &= inside);
    }
    let data = decimated(&data, MOST_PLACES);
    if data.places.is_empty() {
        return Err("none of its places lies in the specimen of the scene".to_owned());
    }
    let carriers_unknown =
        |source: &Source| matches!(source, Source::Pictures(own) if own.carrier.is_none());
    Ok(Observation {
        null,
        nuisance: if carriers_unknown(&state.source) && state.null.is_none() {
            Nuisance::Carriers
        } else {
            Nuisance::Rigid
        },
        ..Observation::of_measurement(&state.name, step, &data)
    })
}

/// Each free parameter of the best law moved up and down.
fn sensitivities(
    experiment: &Experiment,
    model: &ContactModel,
    comparison: &Comparison,
) -> Result<Vec<(usize, Sensitivity)>, LawsError> {
    let frequency = experiment
        .grating
        .map_or(1.0, |grating| grating.frequency());
    let best = comparison.best();
    let from = best.calibration.values();
    let mut changes = Vec::new();
    for (index, parameter) in best.law.parameters.iter().enumerate() {
        for up in [false, true] {
            let mut to = from.clone();
            to[index] = changed(from[index], parameter.logarithmic, up);
            if best.law.law(&to).is_ok() {
                changes.push((index, to));
            }
        }
    }
    let to: Vec<Vec<f64>> = changes.iter().map(|(_, to)| to.clone()).collect();
    let found = sensitivity(model, &best.law, &from, &to, frequency)?;
    Ok(changes
        .into_iter()
        .map(|(index, _)| index)
        .zip(found)
        .collect())
}

/// Twice and half of what is looked for by its order of magnitude, 0.05 more and less of other parameters.
fn changed(value: f64, logarithmic: bool, up: bool) -> f64 {
    const STEP: f64 = 0.05;
    match (logarithmic, up) {
        (true, true) => 2.0 * value,
        (true, false) => 0.5 * value,
        (false, true) => value + STEP,
        (false, false) => (value - STEP).max(0.0),
    }
}

impl LawStage {
    /// Place `[mm]` of a datum of an observation.
    pub fn place(&self, observation: usize, datum: usize) -> Point {
        let own = &self.observations[observation];
        own.places[own.components[datum].0]
    }
}
