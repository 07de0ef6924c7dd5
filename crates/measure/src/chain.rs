//! The chain of stages, to the depth that a command asks for.

use stickslip_engine::run::Progress;
use stickslip_experiment::{Experiment, Source};

use crate::analysed::{self, Analysed};
use crate::error::ExperimentError;
use crate::finding::{Finding, FrictionFinding, Located, ModelFinding};
use crate::identified::{self, Coarser, Identified};
use crate::laws::{self, Known, LawStage, LawsError};
use crate::measured::{self, Measured};
use crate::synthesis::{Camera, Shots};
use crate::truth::Truth;
use crate::whole::{self, WholeState};

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

/// What the stages found, to the depth that was asked for.
#[derive(Debug)]
pub struct Outcome {
    /// The solved scene, where any state is synthetic.
    pub truth: Option<Truth>,
    /// Measured fields, state by state; empty at [`Depth::Fringes`].
    pub fields: Vec<Measured>,
    /// Edge stresses, from [`Depth::Hybrid`] on.
    pub edges: Option<Edges>,
    /// Friction, at [`Depth::Identify`].
    pub friction: Option<Friction>,
}

/// Edge stresses of all states.
#[derive(Debug)]
pub struct Edges {
    /// By the region, state by state.
    pub analysed: Vec<Analysed>,
    /// By the whole plate, for the states that are load steps of the scene.
    pub plates: Vec<WholeState>,
    /// Friction by the whole plate; `None` without such states.
    pub plate_friction: Option<Identified>,
    /// States that are no load steps of the scene, and load steps that were assumed.
    pub plate_findings: Vec<ModelFinding>,
}

/// Friction of all states.
#[derive(Debug)]
pub struct Friction {
    /// Slip zones and their coefficient.
    pub identified: Identified,
    /// The same on half of the cells.
    pub coarser: Result<Option<Coarser>, ExperimentError>,
    /// How far static friction moves the edge `[fringes]`, where no law is fitted that would show it.
    pub moves: Option<Result<f64, LawsError>>,
    /// Friction laws fitted by contact solves, where there are any.
    pub laws: Option<LawStage>,
}

impl Friction {
    /// What makes friction by the edges `analysed` doubtful, or leaves it without a zone. Laws have [findings](LawStage::located) of their own.
    pub fn findings(&self, experiment: &Experiment, analysed: &[Analysed]) -> Vec<Located> {
        let bearings = analysed
            .iter()
            .filter_map(|found| found.bearing_finding(experiment));
        let coarser = self.coarser.as_ref().ok().and_then(Option::as_ref);
        let moves = match &self.moves {
            Some(Err(cause)) => Some(FrictionFinding::MovesUnknown {
                cause: cause.to_string(),
            }),
            _ => None,
        };
        let own = (self.identified.doubts(coarser).into_iter())
            .chain(moves)
            .chain(self.identified.findings.iter().cloned());
        let own = own.map(|finding| Located::of_all(Finding::Friction(finding)));
        bearings.chain(own).collect()
    }
}

/// Takes the synthetic pictures as they are made, so that only one state's are held at a time.
pub trait Album {
    /// The pictures of the state with the index `state`.
    ///
    /// # Errors
    /// [`ExperimentError::Fringes`] for pictures that cannot be kept.
    fn add(
        &mut self,
        camera: &Camera<'_>,
        state: usize,
        shots: &Shots,
    ) -> Result<(), ExperimentError>;

    /// All states have been added.
    fn complete(&mut self, camera: &Camera<'_>);
}

/// Goes through the stages of `experiment` down to `depth`; synthetic pictures go to `album`.
///
/// # Errors
/// [`ExperimentError`] of the stage that fails.
pub fn run(
    experiment: &Experiment,
    depth: Depth,
    album: &mut dyn Album,
    progress: &mut dyn FnMut(Progress),
) -> Result<Outcome, ExperimentError> {
    let truth = truth(experiment, progress)?;
    if truth.is_none() && depth == Depth::Fringes {
        return Err(ExperimentError::Missing {
            key: "states".to_owned(),
            what: "no state has synthetic pictures to make".to_owned(),
            remedy: "give a state the load step of a scene, step = 1; measured states are read by `stickslip reduce`".to_owned(),
        });
    }
    let fields = measured(experiment, depth, truth.as_ref(), album, progress)?;
    let mut outcome = Outcome {
        truth,
        fields,
        edges: None,
        friction: None,
    };
    if depth >= Depth::Hybrid {
        progress(Progress::Phase("hybrid analysis"));
        outcome.edges = Some(edges(experiment, &outcome.fields)?);
    }
    if let (Depth::Identify, Some(edges)) = (depth, &outcome.edges) {
        let truth = outcome.truth.as_ref();
        outcome.friction = Some(friction(
            experiment,
            &outcome.fields,
            edges,
            truth,
            progress,
        )?);
    }
    Ok(outcome)
}

/// The solved scene, if any state is synthetic.
fn truth(
    experiment: &Experiment,
    progress: &mut dyn FnMut(Progress),
) -> Result<Option<Truth>, ExperimentError> {
    let asked = experiment.states.iter().any(|state| {
        let others = state.null.iter().chain(&state.back);
        others.chain([&state.source]).any(Source::is_synthetic)
    });
    match &experiment.specimen.scene {
        Some(own) if asked => Truth::solve(own, progress).map(Some),
        _ => Ok(None),
    }
}

/// Pictures and measured fields, state by state.
fn measured(
    experiment: &Experiment,
    depth: Depth,
    truth: Option<&Truth>,
    album: &mut dyn Album,
    progress: &mut dyn FnMut(Progress),
) -> Result<Vec<Measured>, ExperimentError> {
    let camera = truth
        .map(|truth| Camera::new(experiment, truth))
        .transpose()?;
    let mut fields = Vec::new();
    progress(Progress::Phase("states"));
    for state in 0..experiment.states.len() {
        let shots = match &camera {
            Some(camera) => camera.shots(state)?,
            None => Shots::default(),
        };
        if let Some(camera) = &camera {
            album.add(camera, state, &shots)?;
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
        album.complete(camera);
    }
    Ok(fields)
}

fn edges(experiment: &Experiment, fields: &[Measured]) -> Result<Edges, ExperimentError> {
    let analysed = analysed::all(experiment, fields)?;
    let (plates, plate_findings) = whole::stage(experiment, fields)?;
    let plate_edges: Vec<Analysed> = plates.iter().map(WholeState::edge).collect();
    let plate_friction = (!plates.is_empty())
        .then(|| identified::identify(experiment, &plate_edges))
        .transpose()?;
    Ok(Edges {
        analysed,
        plates,
        plate_friction,
        plate_findings,
    })
}

fn friction(
    experiment: &Experiment,
    fields: &[Measured],
    edges: &Edges,
    truth: Option<&Truth>,
    progress: &mut dyn FnMut(Progress),
) -> Result<Friction, ExperimentError> {
    progress(Progress::Phase("friction"));
    let identified = identified::identify(experiment, &edges.analysed)?;
    let coarser = identified::on_half_the_cells(experiment, fields);
    let identified = identified.beside(coarser.as_ref().ok().and_then(Option::as_ref));
    let asked = experiment.laws.is_empty().then_some(&identified.dynamic);
    let moves = asked.and_then(|fit| identified::moves(experiment, fit.as_ref()));
    progress(Progress::Phase("friction laws"));
    let known = Known {
        analysed: &edges.analysed,
        plates: &edges.plates,
        truth,
    };
    let laws = laws::stage(experiment, fields, known, progress)?;
    Ok(Friction {
        identified,
        coarser,
        moves,
        laws,
    })
}
