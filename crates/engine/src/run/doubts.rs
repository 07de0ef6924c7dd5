//! What limits the trust in an answer: rounding, a mesh too coarse for the contact, other answers of equal right.

use std::collections::BTreeSet;

use stickslip_contact::history::{Difference, Missing, Otherwise};
use stickslip_contact::solver::Residuals;
use stickslip_contact::{ContactPair, ContactPoint, Stencil, StepRecord};

use super::remarks::steps_where;
use super::solved::Solved;
use crate::model::{Model, ModelEdge};
use crate::results::{
    CoarseLoadPath, ContactFinding, CutBackEffect, EdgeGeometry, EdgeResults, Finding, Quantity,
    SolverDependence, StepResults,
};

/// Part of the largest pressure by which more increments may change tractions without a finding.
const COARSE: f64 = 0.01;
/// Part of the work of friction in a step by which more increments may change it without a finding.
const COARSE_WORK: f64 = 0.05;
/// Part of the largest work of friction in a step of the history below which that of another does not matter.
const LITTLE_WORK: f64 = 0.01;
/// Relative imbalance that ordinary rounding does not reach.
const BALANCED: f64 = 1e-8;

/// Findings on the load steps `steps` of `model`.
pub(super) fn of_steps(model: &Model, steps: &[StepResults]) -> Vec<Finding> {
    let edges = model.edges.iter().enumerate();
    (cut_back(steps).into_iter())
        .chain(coarse_path(steps))
        .chain(path_unchecked(steps))
        .chain(other_solver(steps))
        .chain(no_other_solver(steps))
        .chain(unbalanced(steps))
        .chain(
            edges
                .clone()
                .filter_map(|(index, edge)| unresolved(&edge.geometry, index, steps)),
        )
        .chain(edges.filter_map(|(index, edge)| unresolved_peak(edge, index, steps)))
        .collect()
}

/// Contacts between half-planes, with how far they reach.
pub(super) fn of_outlines(
    model: &Model,
    edges: &[EdgeGeometry],
    steps: &[StepResults],
) -> Vec<Finding> {
    let of_edge = |(index, geometry): (usize, &EdgeGeometry)| {
        let pair = &model.pairs[model.edges[index].pair?];
        let sizes =
            [pair.first, pair.second].map(|body| model.bodies[body].series.as_ref()?.outline());
        let size = sizes.into_iter().flatten().reduce(f64::min)?;
        let reach = |step: &StepResults| {
            let rows = step.edges[index].rows.iter().zip(&geometry.parameter);
            let touching = rows.filter(|(row, _)| row.status.touches());
            touching.fold(0.0_f64, |most, (_, place)| most.max(place.abs()))
        };
        let farthest = steps
            .iter()
            .map(reach)
            .zip(1..)
            .filter(|(reach, _)| *reach > 0.0);
        let (reach, step) = farthest.reduce(|most, own| if own.0 > most.0 { own } else { most })?;
        let found = ContactFinding::OutlineLeftOut {
            step,
            reach: Quantity::Length(reach),
            size: Quantity::Length(size),
            radius: radius(pair, &geometry.parameter, reach).map(Quantity::Length),
        };
        Some(Finding::about(&geometry.name, found))
    };
    edges.iter().enumerate().filter_map(of_edge).collect()
}

/// Radius of curvature `[mm]` of the edges of `pair` against each other, by the gap x²/2R of its point at ±`reach` among those at `places`.
fn radius(pair: &ContactPair, places: &[f64], reach: f64) -> Option<f64> {
    let gaps = || pair.points.iter().map(|point| point.gap);
    let least = gaps().fold(f64::INFINITY, f64::min);
    let away = |place: &f64| (place.abs() - reach).abs();
    let both = gaps().zip(places);
    let (gap, place) = both.min_by(|one, other| away(one.1).total_cmp(&away(other.1)))?;
    let rise = gap - least;
    (rise > 0.0).then(|| 0.5 * place * place / rise)
}

/// Where an answer is not verified.
pub(super) fn of_verification(records: &[StepRecord]) -> Option<Finding> {
    let steps = steps_where(records, |record| !record.verified)?;
    let (solvers, residual) = unverified(records)?;
    Some(Finding::Unverified {
        steps,
        solvers,
        residual,
    })
}

/// The solvers of answers that are not verified, and the largest residual that they leave.
pub(super) fn unverified<'a>(
    records: impl IntoIterator<Item = &'a StepRecord>,
) -> Option<(Vec<&'static str>, f64)> {
    let mut solvers: Vec<&'static str> = Vec::new();
    let mut worst = Residuals::default();
    for record in records.into_iter().filter(|record| !record.verified) {
        worst = worst.worse(record.residuals);
        for solver in &record.solvers {
            if !solvers.contains(solver) {
                solvers.push(solver);
            }
        }
    }
    (!solvers.is_empty()).then(|| (solvers, worst.largest()))
}

/// Where the increment was cut back, and what that changed.
fn cut_back(steps: &[StepResults]) -> Option<Finding> {
    let which = steps_where(steps, |step| step.cutbacks > 0)?;
    let finer = |step: &StepResults| step.notes.otherwise.finer;
    let effect = match largest(steps, finer) {
        Some((step, most)) if most.is_distinct() => CutBackEffect::Tractions {
            step,
            increments: most.increments,
            peak_pressure_change: most.peak_pressure,
            traction_change: most.traction,
        },
        Some(_) => in_slip(steps),
        None => {
            let rubs = |step: &StepResults| step.cutbacks > 0 && step.notes.friction > 0.0;
            if steps.iter().any(rubs) {
                CutBackEffect::Unknown
            } else {
                CutBackEffect::Frictionless
            }
        }
    };
    Some(Finding::CutBack {
        steps: which,
        effect,
    })
}

/// Where more increments change tractions by more than a part of the largest pressure, or the work of friction by more than a larger part of it.
fn coarse_path(steps: &[StepResults]) -> Option<Finding> {
    let finer = |step: &StepResults| step.notes.otherwise.path;
    let all = steps.iter().filter_map(finer);
    let little = LITTLE_WORK * all.map(|finer| finer.work).fold(0.0, f64::max);
    let that_works = |step: &StepResults| finer(step).filter(|finer| finer.work > little);
    let which = steps_where(steps, |step| {
        let traction = finer(step).map_or(0.0, |finer| finer.traction);
        let work = that_works(step).map_or(0.0, |finer| finer.dissipation.abs());
        traction > COARSE || work > COARSE_WORK
    })?;
    let (step, most) = match largest(steps, finer)? {
        by_traction @ (_, most) if most.traction > COARSE => by_traction,
        _ => largest_by(steps, that_works, |finer| finer.dissipation.abs())?,
    };
    Some(Finding::CoarseLoadPath(CoarseLoadPath {
        steps: which,
        step,
        increments: most.increments,
        traction_change: most.traction,
        dissipation_change: most.dissipation,
    }))
}

fn path_unchecked(steps: &[StepResults]) -> Option<Finding> {
    let steps = steps_where(steps, |step| step.notes.otherwise.path_missing.is_some())?;
    Some(Finding::LoadPathUnchecked { steps })
}

/// What smaller increments change where tractions stay.
fn in_slip(steps: &[StepResults]) -> CutBackEffect {
    let size = |difference: &Difference| difference.slip.max(difference.dissipation.abs());
    match largest_by(steps, |step| step.notes.otherwise.finer, size) {
        Some((step, most)) if most.differs_in_slip() => CutBackEffect::Slip {
            step,
            increments: most.increments,
            slip_change: most.slip,
            dissipation_change: most.dissipation,
        },
        _ => CutBackEffect::Nothing,
    }
}

/// Where another solver finds another answer.
fn other_solver(steps: &[StepResults]) -> Option<Finding> {
    let other = |step: &StepResults| step.notes.otherwise.other_solver;
    let which = steps_where(steps, |step| {
        other(step).is_some_and(|other| other.is_distinct())
    })?;
    let (step, most) = largest(steps, other)?;
    Some(Finding::SolverDependent(SolverDependence {
        steps: which,
        step,
        solver: most.solver,
        peak_pressure_change: most.peak_pressure,
        traction_change: most.traction,
    }))
}

/// Where another solver should have been asked and gave no answer.
fn no_other_solver(steps: &[StepResults]) -> Option<Finding> {
    let [too_dear, unsolved] = [Missing::Effort, Missing::Answer]
        .map(|why| steps_where(steps, |step| step.notes.otherwise.missing == Some(why)));
    (too_dear.is_some() || unsolved.is_some()).then(|| Finding::NoOtherSolver {
        too_dear: too_dear.unwrap_or_default(),
        limit: Otherwise::EFFORT,
        unsolved: unsolved.unwrap_or_default(),
    })
}

/// The step, counted from 1, in which tractions differ most, and its difference.
fn largest(
    steps: &[StepResults],
    of: impl Fn(&StepResults) -> Option<Difference>,
) -> Option<(usize, Difference)> {
    largest_by(steps, of, |difference| difference.traction)
}

fn largest_by(
    steps: &[StepResults],
    of: impl Fn(&StepResults) -> Option<Difference>,
    size: impl Fn(&Difference) -> f64,
) -> Option<(usize, Difference)> {
    let all = steps.iter().enumerate();
    let known = all.filter_map(|(index, step)| Some((index + 1, of(step)?)));
    known.max_by(|a, b| size(&a.1).total_cmp(&size(&b.1)).then(b.0.cmp(&a.0)))
}

/// Where rounding shows in the balance of forces.
fn unbalanced(steps: &[StepResults]) -> Option<Finding> {
    let which = steps_where(steps, |step| {
        step.balance_residual.is_nan() || step.balance_residual > BALANCED
    })?;
    let residuals = steps.iter().map(|step| step.balance_residual);
    Some(Finding::Unbalanced {
        steps: which,
        residual: residuals.fold(0.0, f64::max),
        usual: BALANCED,
    })
}

/// Where contact on an edge reaches over too few nodes.
fn unresolved(geometry: &EdgeGeometry, index: usize, steps: &[StepResults]) -> Option<Finding> {
    let edge = |step: &StepResults| -> Option<usize> {
        let edge: &EdgeResults = &step.edges[index];
        edge.fewest_contact_nodes(geometry)
            .filter(|_| edge.is_resolved(geometry) == Some(false))
    };
    let nodes = steps.iter().filter_map(edge).min()?;
    let steps = steps_where(steps, |step| edge(step).is_some())?;
    let found = ContactFinding::Unresolved { steps, nodes };
    Some(Finding::about(&geometry.name, found))
}

/// Where the largest pressure of a contact that is resolved rests on too few nodes; at corners that press it has no limit.
fn unresolved_peak(edge: &ModelEdge, index: usize, steps: &[StepResults]) -> Option<Finding> {
    let geometry = &edge.geometry;
    let few = |step: &StepResults| -> Option<usize> {
        let own = &step.edges[index];
        let is_corner = edge.corners_that_press(&own.rows).contains(&true);
        let is_judged = !is_corner && own.is_resolved(geometry) == Some(true);
        own.nodes_of_peak(geometry)
            .filter(|_| is_judged && own.has_sharp_peak(geometry))
    };
    let nodes = steps.iter().filter_map(few).min()?;
    let steps = steps_where(steps, |step| few(step).is_some())?;
    let found = ContactFinding::PeakUnresolved { steps, nodes };
    Some(Finding::about(&geometry.name, found))
}

/// How many times stiffer than the second a finer first body is from which on its pressures are no longer unique node by node.
const STIFFER: f64 = 10.0;

/// Where a mortar projection has more pressures than the body that gives can follow: those between are resisted by the stiff first
/// body alone, and what is left over by the coarse second one multiplied by how much stiffer that is.
pub(super) fn of_ripples(model: &Model, solved: &Solved) -> Vec<Finding> {
    let finding = |pair: &ContactPair| {
        let nodes = |side: fn(&ContactPoint) -> &Stencil| -> BTreeSet<usize> {
            let terms = pair.points.iter().flat_map(|point| side(point).terms());
            terms.map(|term| term.node).collect()
        };
        let sides = [nodes(|point| &point.first), nodes(|point| &point.second)];
        let gives = |body: usize, nodes: &BTreeSet<usize>| {
            let own = solved.operators[body].interface().give_of_each()?;
            let give = |&node: &usize| own[2 * node] + own[2 * node + 1];
            Some(nodes.iter().map(give).sum::<f64>() / nodes.len() as f64)
        };
        // What a body gives on springs is their motion, not its own.
        let is_sprung = |body: usize| {
            model.bodies[body]
                .elastic()
                .is_some_and(|body| body.is_sprung())
        };
        if is_sprung(pair.first) || is_sprung(pair.second) {
            return None;
        }
        let stiffer = gives(pair.second, &sides[1])? / gives(pair.first, &sides[0])?;
        let nodes = sides.map(|nodes| nodes.len());
        (nodes[0] > nodes[1] && stiffer > STIFFER).then(|| {
            let found = ContactFinding::RipplingPressures {
                bodies: bodies_of(model, pair),
                nodes,
                stiffness_ratio: stiffer,
            };
            Finding::about(&pair.name, found)
        })
    };
    model.pairs.iter().filter_map(finding).collect()
}

/// Names of the first and the second body of `pair`.
fn bodies_of(model: &Model, pair: &ContactPair) -> [String; 2] {
    [pair.first, pair.second].map(|body| model.bodies[body].name.clone())
}

/// Where contact leaves open gaps undetermined, and where friction leaves slip undetermined.
pub(super) fn of_looseness(model: &Model, records: &[StepRecord]) -> Vec<Finding> {
    let pairs = || model.pairs.iter().enumerate();
    let loose = pairs().filter_map(|(index, pair)| {
        let steps = steps_where(records, |record| record.loose.contains(&index))?;
        let bodies = bodies_of(model, pair);
        let found = ContactFinding::GapsUndetermined { bodies, steps };
        Some(Finding::about(&pair.name, found))
    });
    let sliding = pairs().filter_map(|(index, pair)| {
        let steps = steps_where(records, |record| record.sliding.contains(&index))?;
        let bodies = bodies_of(model, pair);
        let found = ContactFinding::SlipUndetermined { bodies, steps };
        Some(Finding::about(&pair.name, found))
    });
    loose.chain(sliding).collect()
}

/// Where contact parts and bears elsewhere within one increment.
pub(super) fn of_parting(records: &[StepRecord]) -> Option<Finding> {
    let rubs = |record: &StepRecord| record.parted && record.coefficient > 0.0;
    let steps = steps_where(records, rubs)?;
    Some(Finding::ContactParts { steps })
}
