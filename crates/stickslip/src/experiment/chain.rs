//! The chain of stages, to the depth that a command asks for.

use std::path::Path;

use super::analysed;
use super::error::ExperimentError;
use super::gallery::Gallery;
use super::identified::{self, Told};
use super::laws::{self, Known};
use super::measured::{self, Measured};
use super::plan::{Experiment, Source};
use super::story::Story;
use super::synthesis::{Camera, Shots};
use super::truth::Truth;
use super::whole;
use crate::run::Progress;

/// How far a command goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Depth {
    /// Synthetic fringe pictures.
    Fringes,
    /// Measured fields.
    Reduce,
    /// Edge stresses.
    Hybrid,
    /// Friction.
    Identify,
}

/// Goes through the stages of `experiment` and tells of them. Files of the story that name others do so from `folder`, where it will be
/// written.
///
/// # Errors
/// [`ExperimentError`] of the stage that fails.
pub fn tell(
    experiment: &Experiment,
    depth: Depth,
    folder: &Path,
    progress: &mut dyn FnMut(Progress),
) -> Result<Story, ExperimentError> {
    let mut story = Story::new(experiment);
    let truth = truth(experiment, progress)?;
    if truth.is_none() && depth == Depth::Fringes {
        return Err(ExperimentError::Missing {
            key: "states".to_owned(),
            what: "no state has synthetic pictures to make".to_owned(),
            remedy: "give a state the load step of a scene, step = 1; measured states are read by `stickslip reduce`".to_owned(),
        });
    }
    let stage = Stage {
        experiment,
        depth,
        folder,
    };
    let fields = measured(&stage, truth.as_ref(), &mut story, progress)?;
    if depth < Depth::Hybrid {
        return Ok(story);
    }
    progress(Progress::Phase("hybrid analysis"));
    let analysed = analysed::all(experiment, &fields)?;
    analysed::tell(experiment, &analysed, truth.as_ref(), &mut story);
    let (plates, warnings) = whole::stage(experiment, &fields)?;
    whole::tell(experiment, &plates, &warnings, &mut story)?;
    if depth == Depth::Identify {
        progress(Progress::Phase("friction"));
        let identified = identified::identify(experiment, &analysed)?;
        let coarser = identified::on_half_the_cells(experiment, &fields);
        let identified = identified.beside(coarser.as_ref().ok().and_then(Option::as_ref));
        let asked = experiment.laws.is_empty().then_some(&identified.dynamic);
        let moves = asked.and_then(|fit| identified::moves(experiment, fit.as_ref()));
        let told = Told {
            experiment,
            analysed: &analysed,
            identified: &identified,
            coarser: &coarser,
            truth: truth.as_ref(),
            moves: &moves,
        };
        identified::tell(&told, &mut story);
        progress(Progress::Phase("friction laws"));
        let known = Known {
            analysed: &analysed,
            plates: &plates,
            truth: truth.as_ref(),
        };
        if let Some(stage) = laws::stage(experiment, &fields, known, progress)? {
            laws::tell(experiment, &stage, &mut story);
        }
    }
    Ok(story)
}

/// The solved scene, if any state is synthetic.
fn truth(
    experiment: &Experiment,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<Truth>, ExperimentError> {
    let is_synthetic = |source: &Source| matches!(source, Source::Step(_));
    let asked = experiment.states.iter().any(|state| {
        is_synthetic(&state.source)
            || state.null.as_ref().is_some_and(is_synthetic)
            || state.back.as_ref().is_some_and(is_synthetic)
    });
    match &experiment.specimen.scene {
        Some(own) if asked => Truth::solve(own, progress).map(Some),
        _ => Ok(None),
    }
}

/// What is gone through, how far, and where its results will be.
struct Stage<'a> {
    experiment: &'a Experiment,
    depth: Depth,
    folder: &'a Path,
}

/// Pictures and measured fields, state by state, so that only one state's pictures are held at a time.
fn measured(
    &Stage {
        experiment,
        depth,
        folder,
    }: &Stage<'_>,
    truth: Option<&Truth>,
    story: &mut Story,
    progress: &mut dyn FnMut(Progress),
) -> Result<Vec<Measured>, ExperimentError> {
    let camera = truth
        .map(|truth| Camera::new(experiment, truth))
        .transpose()?;
    let mut gallery = Gallery::new(experiment);
    let mut fields = Vec::new();
    progress(Progress::Phase("states"));
    for state in 0..experiment.states.len() {
        let shots = match &camera {
            Some(camera) => camera.shots(state)?,
            None => Shots::default(),
        };
        if let Some(camera) = &camera {
            gallery.add(camera, state, &shots, story)?;
        }
        if depth >= Depth::Reduce {
            fields.push(measured::state(experiment, state, &shots)?);
        }
        progress(Progress::Step {
            done: state + 1,
            total: experiment.states.len(),
        });
    }
    if let Some(camera) = &camera {
        gallery.tell(camera, folder, story);
    }
    if depth >= Depth::Reduce {
        for words in &experiment.without_effect {
            story.warn(words);
        }
        measured::tell(experiment, &fields, story);
    }
    Ok(fields)
}
