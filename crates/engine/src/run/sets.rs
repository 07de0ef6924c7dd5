//! Displacements of loaded sets and reactions of held ones, from what is recovered of their bodies.

use stickslip_contact::StepRecord;
use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::mesh::Point;
use stickslip_fem_core::{CondensedBody, InterfaceOperator};

use super::solved::{Operator, Solved};
use crate::model::{Mean, Measure, Model, ModelSet};
use crate::results::{SetKind, SetMotion};
use crate::series::SeriesBody;

/// Part of the largest displacements of a body's sets that rounding leaves of others. What does not move has no stiffness.
const ROUNDING: f64 = 1e-12;

/// What of a body at the end of a load step its sets are found by.
struct Moved<'a> {
    /// Index of the body.
    body: usize,
    /// Displacement `[mm]` of a node of its mesh with its rigid motion.
    at: &'a dyn Fn(usize) -> [f64; 2],
    /// The same at a place; those of elements have none.
    at_place: &'a dyn Fn(Point) -> [f64; 2],
    /// Reaction `[N]` of its supports at a node of its mesh.
    reaction: &'a dyn Fn(usize) -> [f64; 2],
    /// Reaction `[N]` of what holds it as a whole.
    whole: [f64; 2],
}

/// A weighted mean of displacements along a direction.
struct MeanDisplacement {
    /// `[mm]`
    mean: f64,
    /// The same of their sizes `[mm]`.
    size: f64,
}

impl MeanDisplacement {
    /// The mean, zero up to `least`.
    fn beyond(&self, least: f64) -> f64 {
        if self.mean.abs() > least {
            self.mean
        } else {
            0.0
        }
    }
}

impl Moved<'_> {
    /// Puts the sets of the body into `sets`, those of all sets of `model` at the end of the step of `record`.
    fn put(&self, model: &Model, record: &StepRecord, sets: &mut [Option<SetMotion>]) {
        let own = model.sets.iter().zip(sets);
        let own = own.filter(|(own, _)| own.set.body == self.body);
        let mut own: Vec<_> = own
            .map(|(own, found)| (own, found, self.mean(&own.measure)))
            .collect();
        let size = own.iter().filter_map(|(_, _, mean)| mean.as_ref());
        let least = ROUNDING * size.map(|mean| mean.size).fold(0.0, f64::max);
        for (own, found, mean) in &mut own {
            // Stiff springs carry forces by displacements that are small beside others.
            let moved = match (&own.measure, mean) {
                (Measure::Springs { .. }, Some(mean)) => mean.mean,
                (_, mean) => mean.as_ref().map_or(0.0, |mean| mean.beyond(least)),
            };
            **found = Some(self.motion(record, own, moved));
        }
    }

    /// Mean displacement of what is loaded or on springs; `None` of what is held, which has a given one.
    fn mean(&self, measure: &Measure) -> Option<MeanDisplacement> {
        let parts: Vec<f64> = match measure {
            Measure::Load {
                mean: Mean::Places(places),
                ..
            } => {
                let along = |&(place, weight)| part((self.at_place)(place), weight);
                places.iter().map(along).collect()
            }
            Measure::Load {
                mean: Mean::Nodes(weights),
                ..
            }
            | Measure::Springs { weights, .. } => {
                let along = |&(node, weight)| part((self.at)(node), weight);
                weights.iter().map(along).collect()
            }
            Measure::Held { .. } => return None,
        };
        Some(MeanDisplacement {
            mean: parts.iter().sum(),
            size: parts.iter().copied().map(f64::abs).sum(),
        })
    }

    /// The motion of `set`, whose mean displacement is `moved` where it is not given.
    fn motion(&self, record: &StepRecord, set: &ModelSet, moved: f64) -> SetMotion {
        match &set.measure {
            Measure::Load { .. } => SetMotion {
                force: force(set, record),
                displacement: moved,
            },
            Measure::Springs { stiffness, .. } => SetMotion {
                force: -stiffness * moved,
                displacement: moved,
            },
            Measure::Held {
                nodes,
                along,
                displacement,
            } => {
                let force = nodes.as_ref().map_or_else(
                    || part(self.whole, *along),
                    |nodes| {
                        let parts = nodes.iter();
                        parts
                            .map(|&(node, own)| part((self.reaction)(node), own))
                            .sum()
                    },
                );
                SetMotion {
                    force,
                    displacement: *displacement,
                }
            }
        }
    }
}

fn part([x, y]: [f64; 2], along: [f64; 2]) -> f64 {
    along[0] * x + along[1] * y
}

/// Force `[N]` of the load on `set`, zero of what is held.
fn force(set: &ModelSet, record: &StepRecord) -> f64 {
    match set.measure {
        Measure::Load { case, force, .. } => {
            let multiplier = record.state.multipliers.get(case);
            force * multiplier.copied().unwrap_or_default()
        }
        Measure::Held { .. } | Measure::Springs { .. } => 0.0,
    }
}

/// What holds the body `index` as a whole `[N]`, a rigid one or one by series: against the contact `forces` on it and its loads.
fn whole_reaction(model: &Model, index: usize, record: &StepRecord, forces: &[f64]) -> [f64; 2] {
    let share = if model.half { 0.5 } else { 1.0 };
    let own = model.sets.iter().filter(|set| set.set.body == index);
    let loads = own.fold([0.0; 2], |[x, y], set| match set.set.kind {
        SetKind::Force { direction } => {
            let force = share * force(set, record);
            [x + force * direction[0], y + force * direction[1]]
        }
        SetKind::Pressure | SetKind::Held { .. } => [x, y],
    });
    let sum = |axis: usize| forces.iter().skip(axis).step_by(2).sum::<f64>();
    [0, 1].map(|axis| -sum(axis) - loads[axis])
}

/// Finds the sets of the rigid body `index` in the step of `record`, in which its rigid motions have the amounts `motions`.
pub(super) fn of_rigid(
    model: &Model,
    solved: &Solved,
    (index, record): (usize, &StepRecord),
    motions: &[f64],
    sets: &mut [Option<SetMotion>],
) {
    let Operator::Rigid(body) = &solved.operators[index] else {
        return;
    };
    let moved = [0, 1].map(|axis| {
        let modes = body.modes().row_iter().nth(axis);
        let row = modes.map(|row| row.iter().zip(motions).map(|(r, a)| r * a).sum());
        row.unwrap_or(0.0)
    });
    let forces = solved.forces_on_body(record, index);
    Moved {
        body: index,
        at: &|_| moved,
        at_place: &|_| moved,
        reaction: &|_| [0.0; 2],
        whole: whole_reaction(model, index, record, &forces),
    }
    .put(model, record, sets);
}

/// Finds the sets of a body of elements from its index and the amounts of its rigid motions, in the step of a record under its loads, from the displacements that
/// strain it and the unbalanced nodal forces, x and y of each node in turn.
pub(super) fn of_elastic(
    model: &Model,
    (index, body, motions): (usize, &CondensedBody, &[f64]),
    (record, state): (&StepRecord, &BodyLoad<'_>),
    [u, residual]: [&[f64]; 2],
    sets: &mut [Option<SetMotion>],
) {
    let rigid = body.rigid_displacements(motions);
    let at = |node: usize, axis: usize| u[2 * node + axis] + rigid[2 * node + axis];
    Moved {
        body: index,
        at: &|node| [at(node, 0), at(node, 1)],
        at_place: &|_| [0.0; 2],
        reaction: &|node| [residual[2 * node], residual[2 * node + 1]],
        whole: body.section_reaction(state),
    }
    .put(model, record, sets);
}

/// Finds the sets of a body by series from its index and the amounts of its rigid motions, in the step of a record under its contact forces; of a half-plane none.
pub(super) fn of_series(
    model: &Model,
    (index, body, motions): (usize, &SeriesBody, &[f64]),
    (record, forces): (&StepRecord, &[f64]),
    sets: &mut [Option<SetMotion>],
) {
    let (Some(own), None) = (model.bodies[index].elastic(), body.line_nodes()) else {
        return;
    };
    let Some(field) = body.strained(record, forces) else {
        return;
    };
    let places = own.mesh().nodes();
    let at = |place: Point| {
        let strained = field.displacement(place).unwrap_or_default();
        let rigid = body.rigid_displacements(motions, &[place]);
        [0, 1].map(|axis| strained[axis] + rigid[axis])
    };
    Moved {
        body: index,
        at: &|node| at(places[node]),
        at_place: &at,
        reaction: &|_| [0.0; 2],
        whole: whole_reaction(model, index, record, forces),
    }
    .put(model, record, sets);
}
