//! The whole plate in each state of an experiment.

use super::{WholeError, WholePlate, WholeSolution};
use crate::analysed::Analysed;
use crate::error::ExperimentError;
use crate::finding::ModelFinding;
use crate::measured::Measured;
use stickslip_experiment::Experiment;
use stickslip_experiment::history::History;

/// The whole plate in one state.
#[derive(Clone, Debug, PartialEq)]
pub struct WholeState {
    /// Index of the state in the experiment.
    pub state: usize,
    /// What follows from its data and its load.
    pub solution: WholeSolution,
}

impl WholeState {
    /// Its edge as that of a region, so that slip zones are found in the same way.
    pub fn edge(&self) -> Analysed {
        let own = &self.solution;
        Analysed {
            state: self.state,
            angle: own.angle.clone(),
            resolution: own.resolution,
            tractions: own.tractions.clone(),
            hoop: own.hoop.iter().map(|hoop| hoop[0]).collect(),
            hoop_deviation: own.hoop.iter().map(|hoop| hoop[1]).collect(),
            bias: own.bias.clone(),
            scale: own.scale,
            ..Analysed::default()
        }
    }
}

/// The whole plate in all states of `experiment`, where its file asks for it, and findings on states that are no load steps of the
/// scene, and on load steps that were assumed.
///
/// # Errors
/// [`ExperimentError`]: no scene, a plate that is not free, data that do not cover the hole.
pub fn stage(
    experiment: &Experiment,
    fields: &[Measured],
) -> Result<(Vec<WholeState>, Vec<ModelFinding>), ExperimentError> {
    let (mut states, mut findings) = (Vec::new(), Vec::new());
    let Some(region) = experiment
        .region
        .as_ref()
        .filter(|region| region.whole_plate)
    else {
        return Ok((states, findings));
    };
    let Some(own) = &experiment.specimen.model else {
        return Err(ExperimentError::Missing {
            key: "region.whole_plate".to_owned(),
            what: "the whole plate is that of a scene, and none is given".to_owned(),
            remedy: "give [specimen] scene = \"scene.toml\" and body = \"plate\"".to_owned(),
        });
    };
    let failed = |cause: WholeError| ExperimentError::Whole {
        key: "region.whole_plate".to_owned(),
        cause: Box::new(cause),
    };
    if experiment.laws.is_empty() {
        // Where laws are fitted, it is reported there.
        findings.extend(ModelFinding::of_mesh(experiment));
    }
    let plate = WholePlate::new(own).map_err(failed)?;
    let history = History::of(&own.scene);
    for measured in fields {
        let state = &experiment.states[measured.state];
        match history.tied(state) {
            Ok(tied) => {
                let solution = plate
                    .analyse(measured, tied.step, tied.null, region.smoothing)
                    .map_err(failed)?;
                findings.extend(ModelFinding::of_null(&history, state, &tied));
                states.push(WholeState {
                    state: measured.state,
                    solution,
                });
            }
            Err(reason) => findings.push(ModelFinding::NoWholePlate {
                state: state.name.clone(),
                reason,
            }),
        }
    }
    Ok((states, findings))
}
