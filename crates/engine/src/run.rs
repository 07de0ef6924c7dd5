//! Solves a scene: condense the bodies, follow the load history, recover what is reported.

mod assembled;
mod bearing;
mod blocks;
mod doubts;
mod edges;
mod error;
mod failure;
mod fasteners;
mod fields;
mod follow;
mod points;
mod progressive;
mod remarks;
mod reported;
mod seated;
pub mod seats;
mod sets;
mod shown;
mod solved;
mod stresses;
mod summary;
mod thinned;
mod whole_motion;

use stickslip_contact::history::Otherwise;
use stickslip_contact::interface::Group;
use stickslip_contact::{Contacts, InterfaceSolver, StepRecord};
use stickslip_fem_core::{InterfaceOperator, parallel};

pub use assembled::{Assembled, condense};
pub use error::{ProgressiveRunError, RunError};
pub use follow::{Progress, follow};
pub use points::numbers_with_errors;
pub use solved::{Operator, OwnNodes, Seated, Solved};
pub use stresses::{is_beside, is_unlimited};
pub use thinned::follow_thinned;
pub use whole_motion::{MovingBody, WholeMotion};

use crate::model::{self, Model};
use crate::results::{
    BodySummary, Choice, EdgeGeometry, EdgeResults, FastenerStep, Finding, LoadScale, ResultPart,
    Results, SetMotion, StepNotes, StepResults,
};
use crate::series::SeriesBody;
use stickslip_scene::Scene;
use stickslip_scene::schema::{FieldOutput, SolverChoice};

/// Runs `scene` on the one model that it describes with a contact solver of the caller's choice, [`solver`] of the scene's or another one, and reports to
/// `progress`. An accuracy that the scene asks for is left to `stickslip-ladder`.
///
/// # Errors
/// [`RunError`].
pub fn run_with(
    scene: &Scene,
    solver: &dyn InterfaceSolver,
    progress: &mut dyn FnMut(Progress),
) -> Result<Results, RunError> {
    progress(Progress::Phase("mesh"));
    let start = scene.host().seconds();
    let model = Model::build(scene)?;
    let mesh_seconds = scene.host().seconds() - start;
    let mut solved = solve(&model, solver, progress)?;
    solved.phases.insert(0, ("mesh", mesh_seconds));
    progress(Progress::Phase("stresses"));
    results(&model, solver, solved)
}

/// Condenses the bodies of `model` and follows its history with `solver`.
///
/// # Errors
/// [`RunError`].
pub fn solve(
    model: &Model,
    solver: &dyn InterfaceSolver,
    progress: &mut dyn FnMut(Progress),
) -> Result<Solved, RunError> {
    let Assembled {
        operators,
        interface,
        phases,
    } = Assembled::of(model, progress)?;
    let mut solved = follow(model, operators, interface, solver, progress)?;
    solved.phases.splice(0..0, phases);
    Ok(solved)
}

/// The solver of a choice.
pub fn solver(choice: SolverChoice) -> Box<dyn InterfaceSolver> {
    choice.make()
}

/// What is reported of the history `solved` of `model`: edges, balances and, where requested, fields.
///
/// # Errors
/// [`RunError::Stress`], [`RunError::Failure`], [`RunError::Progressive`], and [`RunError::Model`] if characteristic distances lead out of
/// their body.
pub fn results(
    model: &Model,
    solver: &dyn InterfaceSolver,
    mut solved: Solved,
) -> Result<Results, RunError> {
    let start = model.host.seconds();
    // Neither needs the other, and each has long parts for one thread.
    let (recovered, otherwise) = parallel::join(
        || fields::recover(model, &solved),
        || otherwise(model, solver, &solved),
    );
    let otherwise = otherwise?;
    solved
        .records
        .iter_mut()
        .for_each(|record| record.parts.clear());
    reported(model, solver, solved, recovered, &otherwise, start)
}

/// How each load step ends on other ways to it.
fn otherwise(
    model: &Model,
    solver: &dyn InterfaceSolver,
    solved: &Solved,
) -> Result<Vec<Otherwise>, RunError> {
    let faces: Vec<&dyn InterfaceOperator> =
        solved.operators.iter().map(Operator::interface).collect();
    let kinematics = model.kinematics(&faces)?;
    let (interface, records) = (&solved.interface, &solved.records);
    if let Some(own) = &solved.own {
        let (thinned, records) = (&own.thinned, &own.records);
        let found = thinned::with_wholes(
            model,
            (&faces, &kinematics),
            interface,
            &own.seated,
            |wholes| (model.history).thinned_otherwise(wholes, thinned, solver, records),
        );
        // Steps have nodes of their own only where contact points are nodes.
        return Ok(found?.transpose()?.unwrap_or_default());
    }
    Ok((model.history).walked_otherwise(interface, &kinematics, solver, records))
}

/// As [`results`], but displacements are recovered of `bodies` alone and no balance is audited but that of the interface problem:
/// enough for edges in contact and for the failure of these bodies, not for fields.
///
/// # Errors
/// As [`results`].
pub fn results_without_audit(
    model: &Model,
    solver: &dyn InterfaceSolver,
    mut solved: Solved,
    bodies: &[usize],
) -> Result<Results, RunError> {
    let start = model.host.seconds();
    for record in &mut solved.records {
        record.parts.clear();
    }
    let recovered = fields::recover_some(model, &solved, bodies);
    reported(model, solver, solved, recovered, &[], start)
}

/// What models are compared by.
#[derive(Debug)]
pub struct Comparable {
    /// The edges with their frames.
    pub geometries: Vec<EdgeGeometry>,
    /// Results of the edges at the end of every load step.
    pub edges: Vec<Vec<EdgeResults>>,
    /// Force and displacement of the model's sets at the end of every load step.
    pub sets: Vec<Vec<Option<SetMotion>>>,
}

/// The edges and sets of `model` at the end of every load step. Enough to compare models by; failure, fields and balances are those of [`results`].
///
/// # Errors
/// [`RunError::Stress`].
pub fn comparable(model: &Model, solved: &Solved) -> Result<Comparable, RunError> {
    let free = model.edges.iter().filter(|edge| edge.pair.is_none());
    let free: Vec<usize> = free.map(|edge| edge.geometry.body).collect();
    let recovered = fields::recover_with_sets(model, solved, &free);
    let (geometries, edges) = edges::all(model, solved, &recovered)?;
    Ok(Comparable {
        geometries,
        edges,
        sets: recovered.into_iter().map(|own| own.sets).collect(),
    })
}

/// Displacements of the body `index` `[mm]` at the end of every load step, x and y of each node in turn; empty for a rigid body.
pub fn displacements_of(model: &Model, solved: &Solved, index: usize) -> Vec<Vec<f64>> {
    let recovered = fields::recover_some(model, solved, &[index]);
    let own = |step: &fields::Recovered| shown::moved(model, &solved.operators, step, index);
    recovered.iter().map(own).collect()
}

fn reported(
    model: &Model,
    solver: &dyn InterfaceSolver,
    mut solved: Solved,
    mut recovered: Vec<fields::Recovered>,
    otherwise: &[Otherwise],
    start: f64,
) -> Result<Results, RunError> {
    let (geometries, edges) = edges::all(model, &solved, &recovered)?;
    let mut steps = steps(model, &solved, &recovered, edges);
    for (step, otherwise) in steps.iter_mut().zip(otherwise) {
        step.notes.otherwise = *otherwise;
    }
    let request = &model.request;
    let mut choices = model.choices.clone();
    choices.push(solver_choice(request.analysis.solver));
    let operators = solved.operators.iter();
    let mut results = Results {
        title: request.title.clone(),
        source: request.source.clone(),
        scene_hash: request.scene_hash.clone(),
        scene: request.scene.clone(),
        problem: model.problem.clone(),
        meshes: request.meshes,
        units: request.units,
        choices,
        blocks: blocks::error(&solved, &recovered),
        findings: findings(model, &solved, &geometries, &steps),
        bodies: bodies(model, &solved),
        factorisations: operators.filter_map(Operator::elastic).count(),
        edges: geometries,
        sets: model.sets.iter().map(|own| own.set.clone()).collect(),
        parts: parts(model),
        fasteners: fasteners::all(model),
        steps,
        failure: Vec::new(),
        phases: Vec::new(),
        ladder: None,
    };
    let scale = LoadScale::of(&results);
    for (step, unloading) in results.steps.iter_mut().zip(scale.unloading()) {
        step.unloading = unloading;
    }
    let with_fields = steps_with_fields(request.fields, &results);
    results.failure = failure::all(model, solver, &recovered, &results, &with_fields)?;
    for index in with_fields {
        fields::complete(model, &solved, &mut recovered[index], index);
        results.steps[index].fields =
            shown::with_stresses(model, &solved, &recovered[index], index)?;
    }
    stresses::put(model, &recovered, &mut results.steps)?;
    solved
        .phases
        .push(("stresses", model.host.seconds() - start));
    results.phases = solved.phases;
    for body in &mut results.bodies {
        if let Some(mesh) = &mut body.mesh {
            *mesh = model.placed(&body.name, mesh)?;
        }
    }
    results.place(model.origin);
    let yields = stresses::yields(model, &results.steps);
    results.findings.extend(yields);
    Ok(results)
}

/// The load steps with the results `edges` of their edges.
fn steps(
    model: &Model,
    solved: &Solved,
    recovered: &[fields::Recovered],
    edges: Vec<Vec<EdgeResults>>,
) -> Vec<StepResults> {
    let fastened = fasteners::of_steps(model, solved);
    let step = |(index, (edges, fasteners)): (usize, (Vec<EdgeResults>, Vec<FastenerStep>))| {
        let record = &solved.records[index];
        StepResults {
            unloading: false,
            loads: model.request.loads.at_step(index),
            edges,
            sets: recovered[index].sets.clone(),
            set_errors: Vec::new(),
            fasteners,
            work: record.work,
            solvers: record.solvers.clone(),
            increments: record.increments,
            cutbacks: record.cutbacks,
            doubtful: record.doubtful,
            notes: step_notes(record, solved.interface.contacts()),
            residuals: record.residuals,
            balance_residual: record.audit.balance().max(recovered[index].imbalance()),
            balance: recovered[index].balance.clone(),
            dissipation: record.dissipation() * if model.half { 2.0 } else { 1.0 },
            fields: Vec::new(),
            stresses: Vec::new(),
            seconds: solved.step_seconds[index],
        }
    };
    let all = edges.into_iter().zip(fastened).enumerate();
    all.map(step).collect()
}

fn findings(
    model: &Model,
    solved: &Solved,
    edges: &[EdgeGeometry],
    steps: &[StepResults],
) -> Vec<Finding> {
    let mut findings = model.findings.clone();
    findings.extend(remarks::of_steps(model, edges, steps));
    findings.extend(doubts::of_verification(&solved.records));
    findings.extend(doubts::of_steps(model, steps));
    findings.extend(remarks::of_freedom(model, solved));
    findings.extend(remarks::of_reserve(model));
    findings.extend(fasteners::eccentric(model, steps));
    findings.extend(doubts::of_looseness(model, &solved.records));
    findings.extend(doubts::of_parting(&solved.records));
    findings.extend(doubts::of_ripples(model, solved));
    findings.extend(seats::findings(model, solved));
    findings.extend(doubts::of_outlines(model, edges, steps));
    findings.extend(stresses::large_strains(model, edges, steps));
    findings.extend(points::findings(model, steps));
    findings
}

/// The independent parts of `model`, with the loads that act on each.
fn parts(model: &Model) -> Vec<ResultPart> {
    let part = |group: Group| {
        let edges = model.edges.iter().enumerate();
        let own_edges = edges.filter(|(_, edge)| match edge.pair {
            Some(pair) => group.pairs.contains(&pair),
            None => group.bodies.contains(&edge.geometry.body),
        });
        ResultPart {
            edges: own_edges.map(|(index, _)| index).collect(),
            loads: model.request.loads.acting_on(&group.bodies),
            bodies: group.bodies,
        }
    };
    model::parts(model).into_iter().map(part).collect()
}

fn step_notes(record: &StepRecord, contacts: &Contacts) -> StepNotes {
    let cycle = record.recovery.first_cycle.iter();
    let points = cycle.flat_map(|cycle| &cycle.points);
    StepNotes {
        cycle_places: points
            .map(|&point| contacts.points()[point].place.position)
            .collect(),
        recovery: record.recovery.clone(),
        solutions: record.solutions,
        friction: record.coefficient,
        uniqueness: record.uniqueness,
        ..StepNotes::default()
    }
}

fn steps_with_fields(output: FieldOutput, results: &Results) -> Vec<usize> {
    let count = results.steps.len();
    match output {
        FieldOutput::None => Vec::new(),
        FieldOutput::Peak => LoadScale::peak_steps(results),
        FieldOutput::Last => count.checked_sub(1).into_iter().collect(),
        FieldOutput::All => (0..count).collect(),
    }
}

fn solver_choice(choice: SolverChoice) -> Choice {
    let reason = match choice {
        SolverChoice::Auto => "the fastest method first, a safer one where it fails",
        _ => "the scene says so",
    };
    Choice {
        what: Choice::SOLVER.into(),
        value: choice.info().method.to_owned(),
        reason: reason.into(),
    }
}

fn bodies(model: &Model, solved: &Solved) -> Vec<BodySummary> {
    let bodies = model.bodies.iter().zip(&solved.operators);
    bodies
        .map(|(body, operator)| {
            let elastic = operator.elastic();
            let unknowns = operator.series().map_or(0, SeriesBody::unknowns);
            BodySummary {
                name: body.name.clone(),
                mesh: body.elastic().map(|own| own.mesh().clone()),
                dofs: elastic.map_or(unknowns, |condensed| condensed.structure().unknowns()),
                factor_entries: elastic
                    .map_or(0, |condensed| condensed.structure().factor_entries()),
                free_motions: operator.interface().modes().ncols(),
                yield_stress: body.yield_stress,
            }
        })
        .collect()
}
