//! What a reader must know of the solution: where an answer was not unique, where the history was cut back, where contact lies.

use stickslip_contact::freedom::{self, free_bodies};
use stickslip_contact::interface::Part;
use stickslip_contact::uniqueness::NEAR_BOUND;
use stickslip_contact::zones::{Zone, ends_of_contact};

use super::solved::Solved;
use super::whole_motion::free_motions;
use crate::model::{EdgeEnd, Measure, Model, ModelEdge, ReentrantCorner};
use crate::results::{
    BearingSource, ContactFinding, EdgeGeometry, EdgeKind, EdgeResults, FailedSolver, Finding,
    FreeBody, FreeMotion, FurtherSolvers, Quantity, StatusCycle, StepResults, UniquenessBound,
    wrapped,
};
use crate::series::is_isotropic;

/// Angle `[rad]` by which the bearing point of a round contact may move in a history before it is reported.
const WANDERS: f64 = 5.0 * std::f64::consts::PI / 180.0;
/// Largest angle `[rad]` by which seated nodes count as apart.
const SEATED: f64 = 0.1;
/// The same on a line, as a part of the widest half of the contact.
const WANDERS_PART: f64 = 0.1;

/// Findings on the load steps.
pub(super) fn of_steps(
    model: &Model,
    edges: &[EdgeGeometry],
    steps: &[StepResults],
) -> Vec<Finding> {
    let mut findings: Vec<Finding> = doubtful(steps)
        .into_iter()
        .chain(recovered(steps))
        .chain(several(steps))
        .chain(near_bound(steps))
        .collect();
    for (index, edge) in edges.iter().enumerate() {
        let own: Vec<&EdgeResults> = steps.iter().map(|step| &step.edges[index]).collect();
        if edge.contact {
            let zones: Vec<&[Zone]> = own.iter().map(|step| &*step.zones).collect();
            let ModelEdge { fine_to, turn, .. } = model.edges[index];
            findings.extend(beyond_fine_zone(fine_to, turn, edge, &zones));
            findings.extend(at_ends(&model.edges[index], &own));
            findings.extend(wanders(edge, &own));
        } else {
            findings.extend(at_reentrant_corners(model, index, &own));
        }
    }
    findings
}

fn doubtful(steps: &[StepResults]) -> Option<Finding> {
    let points = steps.iter().map(|step| step.doubtful).max()?;
    let steps = steps_where(steps, |step| step.doubtful > 0)?;
    Some(Finding::PointsInDoubt { steps, points })
}

/// The solvers that failed before a step was solved.
fn recovered(steps: &[StepResults]) -> Option<Finding> {
    let which = steps_where(steps, |step| !step.notes.recovery.is_empty())?;
    let mut failed: Vec<FailedSolver> = Vec::new();
    for entry in steps.iter().flat_map(|step| &step.notes.recovery.failures) {
        let same =
            |other: &&mut FailedSolver| (other.solver, other.reason) == (entry.solver, entry.kind);
        match failed.iter_mut().find(same) {
            Some(other) => other.count += entry.count,
            None => failed.push(FailedSolver {
                solver: entry.solver,
                reason: entry.kind,
                count: entry.count,
            }),
        }
    }
    let mut cycles = (steps.iter()).filter_map(|step| step.notes.recovery.first_cycle.as_ref());
    Some(Finding::FurtherSolvers(FurtherSolvers {
        steps: which,
        failed,
        cycle: cycles.next().map(|cycle| StatusCycle {
            period: cycle.period,
            points: cycle.points.len(),
        }),
    }))
}

fn several(steps: &[StepResults]) -> Option<Finding> {
    let solutions = steps.iter().filter_map(|step| step.notes.solutions).max()?;
    let steps = steps_where(steps, |step| step.notes.solutions > Some(1))?;
    Some(Finding::SeveralSolutions { steps, solutions })
}

/// Where friction comes near the estimated bound of uniqueness.
fn near_bound(steps: &[StepResults]) -> Option<Finding> {
    // Independent contacts have each their own such step.
    let (index, estimate) = steps
        .iter()
        .enumerate()
        .filter_map(|(index, step)| Some((index, step.notes.uniqueness?)))
        .max_by(|&(a, bound), &(b, other)| {
            let nearness = |step: usize, bound: f64| steps[step].notes.friction / bound;
            nearness(a, bound).total_cmp(&nearness(b, other))
        })?;
    let notes = &steps[index].notes;
    let bound = UniquenessBound {
        step: index + 1,
        friction: notes.friction,
        estimate,
        solutions: notes.solutions,
        other_solver_asked: notes.otherwise.other_solver.is_some(),
    };
    let is_far = bound.friction <= NEAR_BOUND * estimate;
    (!is_far).then_some(Finding::NearUniquenessBound(bound))
}

/// Where the bearing point of a contact moves along its edge in the history.
fn wanders(edge: &EdgeGeometry, steps: &[&EdgeResults]) -> Option<Finding> {
    let (from, BearingSource::Contact { step }) = (edge.frame.bearing?, edge.frame.found) else {
        return None;
    };
    let widest = steps.iter().filter_map(|step| step.contact_half_extent);
    let widest = widest.fold(0.0, f64::max);
    let least = match edge.kind {
        EdgeKind::Circle { .. } => WANDERS,
        EdgeKind::Line | EdgeKind::Path => WANDERS_PART * widest,
    };
    let away = |at: f64| match edge.kind {
        EdgeKind::Circle { .. } => wrapped(at - from).abs(),
        EdgeKind::Line | EdgeKind::Path => (at - from).abs(),
    };
    let points = steps.iter().map(|step| step.bearing).enumerate();
    let points = points.filter_map(|(step, at)| Some((step, at?)));
    let (farthest, at) =
        points.max_by(|a, b| away(a.1).total_cmp(&away(b.1)).then(b.0.cmp(&a.0)))?;
    let place = |at: f64| match edge.kind {
        EdgeKind::Circle { .. } => Quantity::Angle(wrapped(at)),
        EdgeKind::Line => Quantity::Length(at),
        EdgeKind::Path => Quantity::Along(at),
    };
    (away(at) > least).then(|| {
        let found = ContactFinding::BearingPointWanders {
            step: farthest + 1,
            at: place(at),
            largest_step: step + 1,
            largest_at: place(from),
        };
        Finding::about(&edge.name, found)
    })
}

/// Where the largest stress along an edge without contact has no limit, because it is at a re-entrant corner: a finding for each angle.
fn at_reentrant_corners(model: &Model, edge: usize, steps: &[&EdgeResults]) -> Vec<Finding> {
    let own = &model.edges[edge];
    let body = &model.bodies[own.geometry.body];
    let corners: Vec<Option<ReentrantCorner>> = (steps.iter())
        .map(|results| own.corner_at_peak((&body.singular, &body.corners), results))
        .collect();
    let mut different: Vec<ReentrantCorner> = Vec::new();
    for corner in corners.iter().flatten() {
        if !different.contains(corner) {
            different.push(*corner);
        }
    }
    let finding = |corner: ReentrantCorner| {
        Some(Finding::NoLimitAtReentrantCorner {
            edge: own.geometry.name.clone(),
            steps: steps_where(&corners, |own| *own == Some(corner))?,
            angle: corner.angle.to_degrees(),
            exponent: has_free_sides(model, edge, corner).then(|| corner.exponent()),
        })
    };
    different.into_iter().filter_map(finding).collect()
}

/// Whether the body of `edge` is isotropic, and nothing touches the sides of its `corner` or springs on them.
fn has_free_sides(model: &Model, edge: usize, corner: ReentrantCorner) -> bool {
    let index = model.edges[edge].geometry.body;
    let Some(elastic) = model.bodies[index].elastic() else {
        return false;
    };
    let touches = |own: &ModelEdge| {
        let second = own.geometry.second.iter();
        let mut second = second.filter(|own| own.body == index);
        let first = own.geometry.body == index && own.nodes.contains(&corner.node);
        own.pair.is_some() && (first || second.any(|own| own.nodes.contains(&corner.node)))
    };
    let springs = model.sets.iter().filter(|set| set.set.body == index);
    let mut springs = springs.filter_map(|set| match &set.measure {
        Measure::Springs { weights, .. } => Some(weights),
        Measure::Load { .. } | Measure::Held { .. } => None,
    });
    let mut materials = elastic.materials().iter();
    materials.all(|own| is_isotropic(&own.stiffness()))
        && !model.edges.iter().any(touches)
        && !springs.any(|weights| weights.iter().any(|(node, _)| *node == corner.node))
}

/// Contact at an end of `edge` where it faces nothing further.
fn at_ends(edge: &ModelEdge, steps: &[&EdgeResults]) -> impl Iterator<Item = Finding> {
    let geometry = &edge.geometry;
    let last = geometry.parameter.len().saturating_sub(1);
    let place = |end: usize| Quantity::Along(geometry.parameter[end * last]);
    let goes_on = |end: &usize, results: &EdgeResults| {
        let row = results.rows.get(end * last);
        edge.ends[*end] == EdgeEnd::GoesOn && row.is_some_and(|row| row.status.touches())
    };
    let beyond = steps.iter().zip(1..).find_map(|(results, step)| {
        let end = [0, 1].into_iter().find(|end| goes_on(end, results))?;
        Some(ContactFinding::BeyondFacing {
            step,
            at: place(end),
        })
    });
    let presses = |end: usize, results: &EdgeResults| edge.corners_that_press(&results.rows)[end];
    let any_end = |results: &&EdgeResults| (0..2).any(|end| presses(end, results));
    let corner = steps_where(steps, any_end).map(|pressed| {
        let ends = (0..2).filter(|&end| steps.iter().any(|results| presses(end, results)));
        ContactFinding::NoLimitAtCorner {
            steps: pressed,
            at: ends.map(place).collect(),
        }
    });
    let found = beyond.into_iter().chain(corner);
    found.map(|found| Finding::about(&geometry.name, found))
}

/// The farthest end of contact on `edge` in any load step, if it lies beyond the `limit` of the mesh's fine zone; `steps` holds the
/// contact's zones for each step, and places on a circle count from `turn`. Contact all around has no end, and a mesh of equal spacing no limit.
fn beyond_fine_zone(
    limit: Option<f64>,
    turn: f64,
    edge: &EdgeGeometry,
    steps: &[&[Zone]],
) -> Option<Finding> {
    let limit = limit?;
    let place = |end: f64| match edge.kind {
        EdgeKind::Circle { .. } => wrapped(end - turn),
        EdgeKind::Line | EdgeKind::Path => end,
    };
    let ends = |zones: &[Zone]| -> Vec<f64> {
        let ends = ends_of_contact(zones, edge.closed());
        ends.into_iter().map(place).collect()
    };
    let farther = |a: &f64, b: &f64| a.abs().total_cmp(&b.abs());
    let farthest = |zones: &&[Zone]| ends(zones).into_iter().max_by(farther);
    let by_step = steps.iter().map(farthest).enumerate();
    let (step, end) = by_step
        .filter_map(|(step, end)| Some((step, end?)))
        .max_by(|a, b| farther(&a.1, &b.1).then(b.0.cmp(&a.0)))?;
    // An end on the limit to rounding is not beyond it.
    if end.abs() <= limit * (1.0 + 1e-9) {
        return None;
    }
    let both_ends = ends(steps[step])
        .iter()
        .any(|other| (other + end).abs() <= 1e-6 * end.abs());
    let quantity = match edge.kind {
        EdgeKind::Circle { .. } => Quantity::Angle,
        EdgeKind::Line => Quantity::Length,
        EdgeKind::Path => Quantity::Along,
    };
    let found = ContactFinding::BeyondFineMesh {
        step: step + 1,
        end: quantity(end),
        both_ends,
        limit: quantity(limit),
    };
    Some(Finding::about(&edge.name, found))
}

/// Whether reserve factors multiply interference too.
pub(super) fn of_reserve(model: &Model) -> Option<Finding> {
    let contacts = model.pairs.iter().zip(&model.contacts);
    let pressed = contacts.filter(|(_, contact)| contact.interference);
    let contacts: Vec<String> = pressed.map(|(pair, _)| pair.name.clone()).collect();
    let concerned = model.request.failure.is_some() && !contacts.is_empty();
    concerned.then_some(Finding::ReserveWithInterference { contacts })
}

/// The largest angle by which a body of `part` is seated `[rad]`, of one far smaller than its hole no more than contact may miss.
pub(super) fn seated(model: &Model, part: &Part) -> f64 {
    let bodies = part.group().bodies.iter();
    bodies.fold(0.0, |most: f64, &body| {
        most.max(model.bodies[body].seated.min(SEATED))
    })
}

/// Which bodies move as a whole without resistance, so that where they stand is not unique.
pub(super) fn of_freedom(model: &Model, solved: &Solved) -> Vec<Finding> {
    let of_part = |part: &Part| {
        let (bodies, pairs) = (&part.group().bodies, &part.group().pairs);
        let body_name = |free: &freedom::FreeBody| model.bodies[bodies[free.body]].name.clone();
        let (slipping, together): (Vec<_>, Vec<_>) =
            (free_bodies(part.problem(), seated(model, part)).into_iter())
                .partition(|free| !free.slipping.is_empty());
        let slips = |free: &freedom::FreeBody| {
            let contacts = free.slipping.iter();
            Finding::FreeBody(FreeBody {
                body: body_name(free),
                motion: if free.turns {
                    FreeMotion::Rotation
                } else {
                    FreeMotion::Translation
                },
                contacts: contacts
                    .map(|&pair| model.pairs[pairs[pair]].name.clone())
                    .collect(),
            })
        };
        let together = (!together.is_empty()).then(|| Finding::FreeTogether {
            bodies: together.iter().map(body_name).collect(),
            motions: {
                let own: Vec<usize> = together.iter().map(|free| bodies[free.body]).collect();
                free_motions(&solved.operators, part, &own, seated(model, part))
            },
        });
        let findings: Vec<Finding> = slipping.iter().map(slips).chain(together).collect();
        findings
    };
    let parts = solved.interface.parts().iter();
    parts.flat_map(of_part).collect()
}

/// The numbers of the steps that are so, counted from 1; `None` if none is.
pub(super) fn steps_where<T>(steps: &[T], is_so: impl Fn(&T) -> bool) -> Option<Vec<usize>> {
    let which: Vec<usize> = (0..steps.len())
        .filter(|&k| is_so(&steps[k]))
        .map(|k| k + 1)
        .collect();
    (!which.is_empty()).then_some(which)
}
