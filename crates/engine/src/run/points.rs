//! Sets whose displacement or force has no limit with finer cells: single points of elements give way by the more the smaller the cells are.

use stickslip_contact::freedom;
use stickslip_contact::interface::Part;

use super::solved::Solved;
use crate::model::{Mean, Measure, Model, ModelSet, parts};
use crate::results::{Finding, SetStated, StepResults};

/// Part of the largest force on any set up to which a force is none.
const ROUNDING: f64 = 1e-9;

/// Single points that are held, and that take a force in a step.
struct Points<'a> {
    model: &'a Model,
    /// Indices of their sets.
    held: Vec<usize>,
    /// The bodies of every part of the model.
    parts: Vec<Vec<usize>>,
}

impl<'a> Points<'a> {
    /// Those of `model`, whose sets take forces up to `forces`.
    fn of(model: &'a Model, forces: &[f64]) -> Self {
        let all = 0..model.sets.len();
        let largest = forces.iter().copied().fold(0.0, f64::max);
        let takes = |&set: &usize| {
            let own = &model.sets[set];
            let is_load = matches!(own.measure, Measure::Load { .. });
            !is_load && is_point(model, own) && forces[set] > ROUNDING * largest
        };
        Self {
            model,
            held: all.filter(takes).collect(),
            parts: parts(model).into_iter().map(|own| own.bodies).collect(),
        }
    }

    /// The sets of points that hold the part of the model with the body of `set`.
    fn of_part(&self, set: &ModelSet) -> impl Iterator<Item = &ModelSet> {
        let held = self.held.iter().map(|&held| &self.model.sets[held]);
        held.filter(move |held| self.are_linked(held, set))
    }

    fn are_linked(&self, one: &ModelSet, other: &ModelSet) -> bool {
        let both = [one, other].map(|own| own.set.body);
        let mut parts = self.parts.iter();
        both[0] == both[1] || parts.any(|part| both.iter().all(|body| part.contains(body)))
    }

    /// Whether another set shares the force of the point `held`, or a displacement is given, so that forces depend on how far the point gives way.
    fn shares(&self, held: &ModelSet) -> bool {
        let mut others = self
            .model
            .sets
            .iter()
            .filter(|own| self.are_linked(own, held));
        others.any(|other| match other.measure {
            Measure::Load { .. } => false,
            Measure::Held { displacement, .. } if displacement != 0.0 => true,
            Measure::Held { .. } | Measure::Springs { .. } => {
                let along = |axis: usize| other.set.along[axis] * held.set.along[axis];
                other.set.on != held.set.on && (along(0) + along(1)).abs() > ROUNDING
            }
        })
    }
}

/// Whether `set` is a single point of elements.
fn is_point(model: &Model, set: &ModelSet) -> bool {
    let body = &model.bodies[set.set.body];
    let nodes = match &set.measure {
        Measure::Load {
            mean: Mean::Nodes(nodes),
            ..
        } => nodes.len(),
        Measure::Load {
            mean: Mean::Places(places),
            ..
        } => places.len(),
        Measure::Springs { weights, .. } => weights.len(),
        Measure::Held { nodes, .. } => nodes.as_ref().map_or(0, Vec::len),
    };
    body.elastic().is_some() && body.series.is_none() && nodes == 1
}

/// The bodies that move as a whole without resistance, alone or together.
fn free_bodies(solved: &Solved) -> Vec<usize> {
    let parts = solved.interface.parts().iter();
    let of_part = |part: &Part| {
        let free = freedom::free_bodies(part.problem()).into_iter();
        let bodies: Vec<usize> = free.map(|own| part.group().bodies[own.body]).collect();
        bodies
    };
    parts.flat_map(of_part).collect()
}

/// Which numbers of the sets of `model` can have an error, in the order of [`SetStated::ALL`]: those that are not given, have a limit, and depend neither on the bodies
/// `uneven`, of which finer models have some cells alone that are smaller, nor on where bodies that nothing holds have been left under several loads. `forces` are the largest
/// ones `[N]` that sets take in the history `solved`.
pub fn numbers_with_errors(
    model: &Model,
    solved: &Solved,
    forces: &[f64],
    uneven: &[usize],
) -> Vec<[bool; 4]> {
    let points = Points::of(model, forces);
    let free = free_bodies(solved);
    let of_set = |own: &ModelSet| {
        let mut linked = points
            .parts
            .iter()
            .filter(|part| part.contains(&own.set.body));
        let is_uneven = |part: &Vec<usize>| uneven.iter().any(|body| part.contains(body));
        if uneven.contains(&own.set.body) || linked.any(is_uneven) {
            return [false; 4];
        }
        let is_load = matches!(own.measure, Measure::Load { .. });
        let hangs = points.of_part(own).next().is_some() || is_load && is_point(model, own);
        let shares = points.of_part(own).any(|held| points.shares(held));
        // One load alone does no work on a motion that nothing resists.
        let loads = model.sets.iter().filter(|other| {
            matches!(other.measure, Measure::Load { .. }) && points.are_linked(own, other)
        });
        let drifts = free.contains(&own.set.body) && loads.count() > 1;
        SetStated::ALL.map(|stated| match (&own.measure, stated) {
            (Measure::Load { .. }, SetStated::Force)
            | (Measure::Held { .. }, SetStated::Displacement)
            | (Measure::Springs { .. }, SetStated::Secant | SetStated::Tangent) => false,
            (_, SetStated::Force) | (Measure::Held { .. }, _) => !shares,
            _ => !hangs && !drifts,
        })
    };
    model.sets.iter().map(of_set).collect()
}

/// Largest force on each set in `steps` `[N]`.
fn largest_forces(model: &Model, steps: &[StepResults]) -> Vec<f64> {
    let force = |set: usize| {
        let motions = steps.iter().filter_map(|step| *step.sets.get(set)?);
        motions.fold(0.0, |most: f64, own| most.max(own.force.abs()))
    };
    (0..model.sets.len()).map(force).collect()
}

/// That displacements under loads hang on points, unless a finding says already that these share the load.
pub(super) fn finding(model: &Model, steps: &[StepResults]) -> Option<Finding> {
    let is_said = |own: &Finding| matches!(own, Finding::PointSupports { .. });
    if model.findings.iter().any(is_said) {
        return None;
    }
    let points = Points::of(model, &largest_forces(model, steps));
    let (mut bodies, mut loads) = (Vec::new(), Vec::new());
    for own in &model.sets {
        let hangs = points.of_part(own).next().is_some();
        if hangs && matches!(own.measure, Measure::Load { .. }) {
            loads.push(own.set.name.clone());
        }
    }
    for &held in &points.held {
        let name = &model.bodies[model.sets[held].set.body].name;
        if !bodies.contains(name) {
            bodies.push(name.clone());
        }
    }
    (!loads.is_empty()).then_some(Finding::PointDisplacements { bodies, loads })
}
