//! What coarser models say of the failure of plies and of the largest stresses of bodies.

use stickslip_contact::InterfaceSolver;
use stickslip_engine::model::ModelBody;
use stickslip_engine::results::Results;
use stickslip_engine::run::results_without_audit;
use stickslip_scene::schema::FieldOutput;

use super::level::Level;

/// Displacements of all steps together, beyond which largest stresses of coarser models are not asked for: 0.8 GB.
const MOST: usize = 100_000_000;

/// What is asked of coarser models.
#[derive(Clone, Copy)]
pub(super) struct Asked {
    /// The failure of plies.
    pub(super) failure: bool,
    /// The largest stresses of bodies.
    pub(super) stresses: bool,
}

/// The results of the last two of `levels`, the finer first; of joints that are followed to their end without failure.
pub(super) fn before(
    levels: Vec<Level>,
    solver: &dyn InterfaceSolver,
    asked: Asked,
) -> Vec<Results> {
    if !asked.failure && !asked.stresses {
        return Vec::new();
    }
    let results = |level: Level| of_level(level, solver, asked);
    let last = levels.into_iter().rev().take(2);
    last.map_while(results).collect()
}

fn unknowns(body: &ModelBody) -> usize {
    body.elastic().map_or(0, |own| 2 * own.mesh().nodes().len())
}

fn of_level(mut level: Level, solver: &dyn InterfaceSolver, asked: Asked) -> Option<Results> {
    let request = &mut level.model.request;
    if !asked.stresses {
        request.fields = FieldOutput::None;
    }
    let followed = (request.failure.iter())
        .flat_map(|failure| &failure.bodies)
        .any(|body| body.progressive.is_some());
    if followed || !asked.failure {
        request.failure = None;
    }
    let mut bodies = Vec::new();
    if let Some(failure) = &mut request.failure {
        failure.settings.envelopes = None;
        bodies.extend(failure.bodies.iter().map(|body| body.body));
    }
    let all = level.model.bodies.iter().enumerate();
    let values: usize = all.clone().map(|(_, body)| unknowns(body)).sum();
    let is_small = values * level.solved.records.len() <= MOST;
    let elastic = all.filter(|(_, body)| asked.stresses && is_small && body.elastic().is_some());
    bodies.extend(elastic.map(|(index, _)| index));
    bodies.sort_unstable();
    bodies.dedup();
    if bodies.is_empty() {
        return None;
    }
    let mut found = results_without_audit(&level.model, solver, level.solved, &bodies).ok()?;
    for step in &mut found.steps {
        step.fields.clear();
    }
    Some(found)
}
