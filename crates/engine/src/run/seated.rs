//! Bodies by series that sit in their holes otherwise from load step to load step.
//!
//! On the deformed geometry the nodes of a pin should stand where those of its hole face them ([`Faced`](super::seats::Faced)), closer than nodes are to each other. Slip moves these places from load
//! step to load step, so each step has a pin with nodes of its own. They are the same pin: what it was displaced by is read between the nodes of the step before, and what a step presses
//! on it is put on the nodes of the model when the step is done.

use std::sync::Arc;

use stickslip_contact::StepRecord;
use stickslip_fem_core::parallel;
use stickslip_scene::schema::KinematicsChoice;

use super::assembled::Assembled;
use super::error::RunError;
use super::solved::{Operator, Seated};
use crate::model::{Model, ModelError, Seat};
use crate::results::EdgeGeometry;

/// Bodies that sit in two load steps alike but for so much of the smallest distance of nodes have one operator in both.
const ALIKE: f64 = 0.1;
/// Most ways in which bodies sit in a history; of longer ones load steps are alike that sit farther from each other.
const MOST: usize = 32;

/// How the second body of every contact sits, where that is known.
type Seats = [Option<Seat>];

impl Seated {
    /// Those of load steps with the seats `steps`; `None` of a step that sits as `model` does, whose seats are `seats`. Where gaps do not follow the displacement there are none. `build` makes the
    /// model with other seats.
    ///
    /// # Errors
    /// [`RunError::Model`].
    pub fn of_steps(
        model: &Model,
        assembled: &Assembled,
        (steps, seats): (&[Vec<Option<Seat>>], &Seats),
        build: impl Fn(&Seats) -> Result<Model, ModelError> + Sync + Send,
    ) -> Result<Vec<Option<Arc<Self>>>, RunError> {
        if model.request.analysis.kinematics != Some(KinematicsChoice::DeformedGaps) {
            return Ok(Vec::new());
        }
        let near = |pair| {
            let edge = model.edge_of(pair);
            edge.map_or(f64::INFINITY, |edge| ALIKE * smallest(&edge.geometry))
        };
        let mut near: Vec<f64> = (0..seats.len()).map(near).collect();
        let (unlike, which) = loop {
            let (unlike, which) = grouped(seats, steps, &near);
            if unlike.len() <= MOST {
                break (unlike, which);
            }
            for near in &mut near {
                *near *= 2.0;
            }
        };
        let made = parallel::map(&unlike[1..], |seats| -> Result<_, RunError> {
            let own = build(seats)?;
            let operators = assembled.operators.iter().zip(&own.bodies);
            let operators = operators.map(|(operator, body)| match &body.series {
                Some(series) => Operator::Series(Arc::clone(series)),
                None => operator.clone(),
            });
            Ok(Arc::new(Self {
                operators: operators.collect(),
                facings: own.facings,
            }))
        });
        let made: Vec<Arc<Self>> = made.into_iter().collect::<Result<_, _>>()?;
        let own = |index: usize| index.checked_sub(1).map(|index| Arc::clone(&made[index]));
        Ok(which.into_iter().map(own).collect())
    }

    /// Puts the forces of `record` that act on these bodies on the nodes of `operators`, those of the model.
    pub(super) fn put_on_nodes_of(&self, operators: &[Operator], record: &mut StepRecord) {
        let Some(on_bodies) = record.on_bodies.as_mut().map(Arc::make_mut) else {
            return;
        };
        let bodies = operators.iter().zip(&self.operators);
        for (forces, (own, other)) in on_bodies.iter_mut().zip(bodies) {
            let nodes = [own, other].map(|body| body.series()?.circle_nodes());
            if let [Some(own), Some(other)] = nodes
                && own != other
            {
                *forces = own.spread(other, forces);
            }
        }
    }
}

/// The seats that differ among `seats`, which come first, and `steps`, by more than the angles `near` of each pair; and the index among them of those of every step.
fn grouped<'a>(
    seats: &'a Seats,
    steps: &'a [Vec<Option<Seat>>],
    near: &[f64],
) -> (Vec<&'a Seats>, Vec<usize>) {
    let mut unlike = vec![seats];
    let mut which = Vec::with_capacity(steps.len());
    for step in steps {
        let known = unlike.iter().position(|seats| are_alike(seats, step, near));
        which.push(known.unwrap_or(unlike.len()));
        if known.is_none() {
            unlike.push(step);
        }
    }
    (unlike, which)
}

/// Whether bodies sit alike, up to the angles `near` of each pair.
fn are_alike(one: &Seats, other: &Seats, near: &[f64]) -> bool {
    let mut both = one.iter().zip(other).zip(near);
    both.all(|((one, other), near)| match (one, other) {
        (Some(one), Some(other)) => one.apart(other) <= *near,
        (one, other) => one.is_none() && other.is_none(),
    })
}

/// The smallest distance of nodes along an edge `[rad or mm]`.
fn smallest(geometry: &EdgeGeometry) -> f64 {
    let gaps = geometry.parameter.windows(2).map(|pair| pair[1] - pair[0]);
    gaps.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A pin that is turned by `turn` in its hole.
    fn turned(turn: f64) -> Vec<Option<Seat>> {
        let angles: Vec<f64> = (0..90).map(|k| 0.07 * f64::from(k)).collect();
        vec![Some(Seat::new(&angles, |k| angles[k] + turn, true)), None]
    }

    #[test]
    fn load_steps_that_sit_alike_share_their_bodies() {
        let (model, steps) = (turned(0.0), [1e-5, 2e-3, 2.01e-3, 0.0, 5e-3].map(turned));
        let (unlike, which) = grouped(&model, &steps, &[1e-4, f64::INFINITY]);
        assert_eq!((unlike.len(), which), (3, vec![0, 1, 1, 0, 2]));
        // One without a pin that bears sits as none of the others.
        let none = [vec![None, None]];
        assert_eq!(grouped(&model, &none, &[1e-4, f64::INFINITY]).1, [1]);
    }
}
