//! What limits the trust in an answer: rounding, a mesh too coarse for the contact, other answers of equal right.

use std::collections::BTreeSet;

use stickslip_contact::history::{Difference, Missing};
use stickslip_contact::{ContactPair, ContactPoint, Stencil, StepRecord};

use super::Solved;
use super::remarks::{quoted, steps_where};
use crate::model::Model;
use crate::results::{EdgeGeometry, EdgeResults, StepResults};

/// Relative imbalance that ordinary rounding does not reach.
const BALANCED: f64 = 1e-8;

/// Remarks on the load steps `steps` of `model`.
pub(super) fn of_steps(model: &Model, steps: &[StepResults]) -> Vec<String> {
    let edges = model.edges.iter().enumerate();
    (cut_back(steps).into_iter())
        .chain(other_solver(steps))
        .chain(no_other_solver(steps))
        .chain(unbalanced(steps))
        .chain(edges.filter_map(|(index, edge)| unresolved(&edge.geometry, index, steps)))
        .collect()
}

/// Says where the increment was cut back, and what that changed.
fn cut_back(steps: &[StepResults]) -> Option<String> {
    let which = steps_where(steps, |step| step.cutbacks > 0)?;
    let told = format!("The increment was cut back in load step {which}.");
    let finer = |step: &StepResults| step.notes.otherwise.finer;
    let Some((step, most)) = largest(steps, finer) else {
        // Without friction no answer depends on the path.
        let rubs = steps
            .iter()
            .any(|step| step.cutbacks > 0 && step.notes.friction > 0.0);
        let unknown = " Whether that changed the answer is not known: smaller equal increments were not solved.";
        return Some(if rubs { told + unknown } else { told });
    };
    if !most.is_distinct() {
        return Some(told + &in_slip(steps));
    }
    Some(format!(
        "{told} The answer depends on the path: in {} equal increments the largest pressure of load step {step} changes by {}, \
         tractions by up to {} of it.",
        most.increments,
        percent(most.peak_pressure),
        percent(most.traction),
    ))
}

/// What smaller increments change where tractions stay.
fn in_slip(steps: &[StepResults]) -> String {
    let size = |difference: &Difference| difference.slip.max(difference.dissipation.abs());
    match largest_by(steps, |step| step.notes.otherwise.finer, size) {
        Some((step, most)) if most.differs_in_slip() => format!(
            " Smaller increments give the same tractions. Slip counts from the increment in which a point closes: in {} equal increments CSLIP1 of \
             load step {step} changes by up to {} of its largest, the work of friction by {}.",
            most.increments,
            percent(most.slip),
            percent(most.dissipation),
        ),
        _ => " That changed nothing: smaller increments give the same answer.".to_owned(),
    }
}

/// Says where another solver finds another answer.
fn other_solver(steps: &[StepResults]) -> Option<String> {
    let other = |step: &StepResults| step.notes.otherwise.other_solver;
    let which = steps_where(steps, |step| {
        other(step).is_some_and(|other| other.is_distinct())
    })?;
    let (step, most) = largest(steps, other)?;
    Some(format!(
        "The answer depends on the solver in load step {which}: from the same state before the step, {} finds another one that meets \
         all contact conditions. In load step {step} its largest pressure differs by {}, tractions by up to {} of it.",
        most.solver,
        percent(most.peak_pressure),
        percent(most.traction),
    ))
}

/// Says where another solver should have been asked and gave no answer.
fn no_other_solver(steps: &[StepResults]) -> Option<String> {
    let missing =
        |why: Missing| steps_where(steps, |step| step.notes.otherwise.missing == Some(why));
    let dear = missing(Missing::Effort).map(|which| {
        format!(
            "load step {which} would take more work than comparisons of a history may, 1e9 operations"
        )
    });
    let unsolved = missing(Missing::Answer)
        .map(|which| format!("the other solver did not solve load step {which}"));
    let reasons: Vec<String> = dear.into_iter().chain(unsolved).collect();
    (!reasons.is_empty()).then(|| {
        format!(
            "Whether another solver finds another answer is not known where friction, cut-back or loose contact allow one: {}.",
            reasons.join("; ")
        )
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

/// A part in percent with two digits.
fn percent(part: f64) -> String {
    let value = 100.0 * part;
    let size = value.abs();
    let digits = if size > 0.0 && size < 10.0 {
        (1.0 - size.log10().floor()).clamp(0.0, 8.0) as usize
    } else {
        0
    };
    format!("{value:.digits$} %")
}

/// Says where rounding shows in the balance of forces.
fn unbalanced(steps: &[StepResults]) -> Option<String> {
    let which = steps_where(steps, |step| {
        step.balance_residual.is_nan() || step.balance_residual > BALANCED
    })?;
    let worst = steps
        .iter()
        .fold(0.0_f64, |worst, step| worst.max(step.balance_residual));
    Some(format!(
        "Forces balance to {worst:.1e} of the load only in load step {which}, where {BALANCED:.0e} is usual: rounding has taken digits \
         from the results, which may be off by thirty times that part. Cells many times longer than wide, bodies many times longer \
         than their contact, and thermal strains far above those of the load cause it."
    ))
}

/// Says where contact on an edge reaches over too few nodes.
fn unresolved(geometry: &EdgeGeometry, index: usize, steps: &[StepResults]) -> Option<String> {
    let edge = |step: &StepResults| -> Option<usize> {
        let edge: &EdgeResults = &step.edges[index];
        edge.fewest_contact_nodes(geometry)
            .filter(|_| edge.is_resolved(geometry) == Some(false))
    };
    let which = steps_where(steps, |step| edge(step).is_some())?;
    let fewest = steps.iter().filter_map(edge).min()?;
    let nodes = if fewest == 1 { "node" } else { "nodes" };
    Some(format!(
        "The mesh does not resolve contact '{}' in load step {which}: it touches along less than two element edges, at fewest at {fewest} \
         {nodes}. Its peak pressure, half-width and stresses nearby depend on the mesh; its resultant holds. Reduce mesh.spacing.",
        geometry.name
    ))
}

/// How many times stiffer than the second a finer first body is from which on its pressures are no longer unique node by node.
const STIFFER: f64 = 10.0;

/// Says where a mortar projection has more pressures than the body that gives can follow: those between are resisted by the stiff first
/// body alone, and what is left over by the coarse second one multiplied by how much stiffer that is.
pub(super) fn of_ripples(model: &Model, solved: &Solved) -> Vec<String> {
    let note = |pair: &ContactPair| {
        let nodes = |side: fn(&ContactPoint) -> &Stencil| -> BTreeSet<usize> {
            let terms = pair.points.iter().flat_map(|point| side(point).terms());
            terms.map(|term| term.node).collect()
        };
        let sides = [nodes(|point| &point.first), nodes(|point| &point.second)];
        let gives = |body: usize, nodes: &BTreeSet<usize>| {
            let compliance = solved.operators[body].interface().compliance()?;
            let give = |&node: &usize| {
                let [x, y] = [2 * node, 2 * node + 1].map(|i| compliance[(i, i)]);
                x + y
            };
            Some(nodes.iter().map(give).sum::<f64>() / nodes.len() as f64)
        };
        let stiffer = gives(pair.second, &sides[1])? / gives(pair.first, &sides[0])?;
        let [finer, coarser] = sides.map(|nodes| nodes.len());
        (finer > coarser && stiffer > STIFFER).then(|| {
            let [first, second] = [pair.first, pair.second].map(|body| &model.bodies[body].name);
            format!(
                "Contact '{}' has {finer} nodes of '{first}' on {coarser} of '{second}', which gives {stiffer:.0} times as much and \
                 cannot follow so many: pressures node by node are not unique and may open every other one. Their means over cells of \
                 '{second}' and the resultant hold. Give '{first}' a mesh no finer than that of '{second}' along the contact.",
                pair.name
            )
        })
    };
    model.pairs.iter().filter_map(note).collect()
}

/// Says where contact leaves open gaps undetermined.
pub(super) fn of_looseness(model: &Model, records: &[StepRecord]) -> Vec<String> {
    let note = |index: usize| {
        let which = steps_where(records, |record| record.loose.contains(&index))?;
        let pair = &model.pairs[index];
        let bodies = [pair.first, pair.second].map(|body| &*model.bodies[body].name);
        Some(format!(
            "In an increment of load step {which} contact '{}' touches at too few points, or at none, to hold {} against a rigid \
             motion that changes no force: COPEN, displacements and what closes next are one of many answers of equal right, and so is what \
             follows from them.",
            pair.name,
            quoted(bodies.into_iter())
        ))
    };
    (0..model.pairs.len()).filter_map(note).collect()
}

/// Says where friction leaves slip undetermined.
pub(super) fn of_sliding(model: &Model, records: &[StepRecord]) -> Vec<String> {
    let note = |index: usize| {
        let which = steps_where(records, |record| record.sliding.contains(&index))?;
        let pair = &model.pairs[index];
        let bodies = [pair.first, pair.second].map(|body| &*model.bodies[body].name);
        Some(format!(
            "In an increment of load step {which} no point of contact '{}' sticks that would hold {} against a rigid motion along it, and \
             slip in a range has the same friction: CSLIP1 on '{}' and displacements are one of many answers of equal right, and so is what follows \
             from them.",
            pair.name,
            quoted(bodies.into_iter()),
            pair.name
        ))
    };
    (0..model.pairs.len()).filter_map(note).collect()
}

/// Says where contact parts and bears elsewhere within one increment.
pub(super) fn of_parting(records: &[StepRecord]) -> Option<String> {
    let rubs = |record: &StepRecord| record.parted && record.coefficient > 0.0;
    let which = steps_where(records, rubs)?;
    Some(format!(
        "In an increment of load step {which} contact parts and bears elsewhere: what the bodies travel in between counts as slip, and friction has \
         the direction of that way. Give a step without load in between (steps = [\"1 kN\", \"0 N\", \"-1 kN\"]), from which only the way under \
         force counts."
    ))
}
