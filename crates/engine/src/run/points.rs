//! Sets whose displacement or force has no limit with finer cells: single points of elements give way by the more the smaller the cells are.

use nalgebra::DMatrix;
use stickslip_contact::freedom;
use stickslip_contact::interface::Part;
use stickslip_fem_core::mesh::Point;

use super::remarks::seated;
use super::solved::Solved;
use crate::model::{Mean, Measure, Model, ModelSet, parts};
use crate::results::{Finding, SetStated, StepResults};

/// Part of the largest force on any set up to which a force is none.
const ROUNDING: f64 = 1e-9;

/// Part of the size of a wrench from which it is independent of others.
const DEPENDENT: f64 = 1e-6;

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
        let shared = others.any(|other| match other.measure {
            Measure::Load { .. } => false,
            Measure::Held { displacement, .. } if displacement != 0.0 => true,
            Measure::Held { .. } | Measure::Springs { .. } => {
                let along = |axis: usize| other.set.along[axis] * held.set.along[axis];
                other.set.on != held.set.on && (along(0) + along(1)).abs() > ROUNDING
            }
        });
        shared && !self.is_determinate(held)
    }

    /// Whether equilibrium alone gives the forces on all that holds the part of `held`: points, that hold no motion twice, and none that is moved.
    fn is_determinate(&self, held: &ModelSet) -> bool {
        let mut wrenches = Vec::new();
        for own in &self.model.sets {
            if matches!(own.measure, Measure::Load { .. }) || !self.are_linked(own, held) {
                continue;
            }
            let Some([x, y]) = point(self.model, own) else {
                return false;
            };
            let [u, v] = own.set.along;
            let size = x.abs().max(y.abs()).max(f64::MIN_POSITIVE);
            let moved =
                matches!(own.measure, Measure::Held { displacement, .. } if displacement != 0.0);
            if moved || wrenches.len() == 3 {
                return false;
            }
            wrenches.push(([u, v], x * v - y * u, size));
        }
        let size = wrenches.iter().fold(0.0, |most: f64, own| most.max(own.2));
        let rows = wrenches
            .iter()
            .flat_map(|(force, moment, _)| [force[0], force[1], moment / size]);
        let rows = DMatrix::from_row_iterator(wrenches.len(), 3, rows);
        rows.rank(DEPENDENT) == wrenches.len()
    }
}

/// Where `set` is, if it is a single point of elements `[mm]`.
fn point(model: &Model, set: &ModelSet) -> Option<Point> {
    let body = &model.bodies[set.set.body];
    let nodes: Vec<usize> = match &set.measure {
        Measure::Load {
            mean: Mean::Nodes(nodes),
            ..
        }
        | Measure::Springs { weights: nodes, .. } => nodes.iter().map(|own| own.0).collect(),
        Measure::Held {
            nodes: Some(nodes), ..
        } => nodes.iter().map(|own| own.0).collect(),
        Measure::Load { .. } | Measure::Held { .. } => Vec::new(),
    };
    let elastic = body.elastic().filter(|_| body.series.is_none())?;
    let [node] = nodes[..] else {
        return None;
    };
    Some(elastic.mesh().nodes()[node])
}

/// Whether `set` is a single point of elements.
fn is_point(model: &Model, set: &ModelSet) -> bool {
    point(model, set).is_some()
}

/// The bodies that move as a whole without resistance, alone or together.
fn free_bodies(model: &Model, solved: &Solved) -> Vec<usize> {
    let parts = solved.interface.parts().iter();
    let of_part = |part: &Part| {
        let free = freedom::free_bodies(part.problem(), seated(model, part)).into_iter();
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
    let free = free_bodies(model, solved);
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

/// That displacements under loads hang on points, and that points share a load with other supports.
pub(super) fn findings(model: &Model, steps: &[StepResults]) -> Vec<Finding> {
    let points = Points::of(model, &largest_forces(model, steps));
    let mut loads = Vec::new();
    for own in &model.sets {
        let hangs = points.of_part(own).next().is_some();
        if hangs && matches!(own.measure, Measure::Load { .. }) {
            loads.push(own.set.name.clone());
        }
    }
    let bodies_of = |held: &mut dyn Iterator<Item = &ModelSet>| {
        let mut names: Vec<String> = Vec::new();
        for own in held {
            let name = &model.bodies[own.set.body].name;
            if !names.contains(name) {
                names.push(name.clone());
            }
        }
        names
    };
    let held = || points.held.iter().map(|&held| &model.sets[held]);
    let shared = bodies_of(&mut held().filter(|held| points.shares(held)));
    let shared = (!shared.is_empty()).then_some(Finding::PointSupports { bodies: shared });
    let bodies = bodies_of(&mut held());
    let hanging = (!loads.is_empty()).then_some(Finding::PointDisplacements { bodies, loads });
    shared.into_iter().chain(hanging).collect()
}
