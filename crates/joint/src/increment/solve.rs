//! One linearisation of all bodies, and what it leaves out of balance.

use nalgebra::DVector;
use stickslip_contact::history::travelled;
use stickslip_contact::solver::Step;
use stickslip_contact::state::TrialState;
use stickslip_contact::{InterfaceProblem, InterfaceSolver};
use stickslip_fem_core::InterfaceOperator;

use super::{Linear, Part, Solving};
use crate::body::{JointBody, Response};
use crate::error::Halt;
use crate::operator::{Factors, Operator, Widened};

impl<'a> Solving<'a> {
    /// Linearises all bodies about the present state and solves the contact between them.
    pub(super) fn linearised(
        &mut self,
        solver: &dyn InterfaceSolver,
        factors: &mut Factors,
        guess: Option<&TrialState>,
    ) -> Result<Linear, Halt> {
        let operators = self.operators(factors)?;
        let faces: Vec<_> = operators.iter().map(Operator::interface).collect();
        let problem = InterfaceProblem::new(&faces, self.joint.pairs.clone())?;
        let multipliers = with_correction(self.multipliers);
        if self.origin.is_none() {
            let from = with_correction(&self.start.multipliers);
            self.origin = travelled(&problem, &self.start.contact, [&from, &multipliers]);
        }
        let mut step = Step::new(&problem, self.origin(), &multipliers);
        if let Some(guess) = guess {
            step = step.near(guess);
        }
        let solution = if self.settings.quickly {
            solver.try_quickly(&step)
        } else {
            solver.solve(&step)
        };
        drop(step);
        let solution = solution.map_err(|failure| Halt::Contact(Box::new(failure)))?;
        self.work += solution.work;
        let displacements = self.moved(&problem, &operators, &solution.trial);
        Ok(Linear {
            problem,
            solution,
            displacements,
        })
    }

    pub(crate) fn operators(&self, factors: &mut Factors) -> Result<Vec<Operator<'a>>, Halt> {
        let mut operator = |part: &Part<'a>| {
            Ok(match part {
                Part::Linear(body) => Operator::Linear(Widened::new(*body)),
                Part::History(working) => {
                    let (index, response) = (working.index, &working.response);
                    let halt = |cause| Halt::Stiffness { body: index, cause };
                    let tangent = factors.get(index, working.body, &response.tangents);
                    let linearised = tangent
                        .and_then(|tangent| tangent.about(&response.strain, &response.stress));
                    Operator::Linearised(Box::new(linearised.map_err(halt)?))
                }
            })
        };
        self.parts.iter().map(&mut operator).collect()
    }

    /// Displacements of all bodies.
    fn moved(
        &self,
        problem: &InterfaceProblem,
        operators: &[Operator<'_>],
        trial: &TrialState,
    ) -> Vec<Vec<f64>> {
        let moved = |(index, body): (usize, &JointBody)| {
            let forces = problem.forces_on_body(index, body.contact_points(), &trial.forces);
            let motions =
                problem.motions_of_body(index, &trial.rigid, &trial.forces, self.multipliers);
            match (body, &operators[index]) {
                (_, Operator::Linearised(body)) => {
                    body.displacements(&forces, self.multipliers, &motions)
                }
                (JointBody::Elastic(body), _) => {
                    body.displacements(&forces, self.multipliers, &motions)
                }
                (_, Operator::Linear(body)) => {
                    let alpha = DVector::from_vec(motions);
                    (body.modes() * alpha).as_slice().to_vec()
                }
            }
        };
        self.joint.bodies.iter().enumerate().map(moved).collect()
    }

    /// Largest unbalanced nodal force of all bodies with a history, relative to the largest nodal force, or to a thousandth of the
    /// largest so far, or of those that plies exert on each other, or to those of a body that moves without strain but for rounding, where
    /// that is more.
    pub(super) fn residual(&mut self, linear: &Linear, responses: &[Response]) -> f64 {
        const FLOOR: f64 = 1e-3;
        let mut worst = 0.0;
        let mut scales = Vec::with_capacity(responses.len());
        for (working, response) in self.histories().zip(responses) {
            let internal = working.body.internal_forces(&response.stress);
            let applied = self.applied_forces(linear, working.index);
            let rest: Vec<f64> = internal.iter().zip(&applied).map(|(i, a)| i - a).collect();
            let scale = (internal.iter().chain(&applied)).fold(0.0, |m: f64, f| m.max(f.abs()));
            scales.push(scale);
            let before = self.start.bodies[working.index].largest_force;
            let travelling = (working.body)
                .force_of_rounding(&response.tangents, &linear.displacements[working.index]);
            let least = FLOOR * before.max(working.body.rest_force());
            let scale = scale.max(least).max(travelling);
            let unbalanced = working.body.structure().largest_on_unknowns(&rest);
            if unbalanced > worst * scale || unbalanced.is_nan() {
                worst = unbalanced / scale;
            }
        }
        let mut scales = scales.into_iter();
        for part in &mut self.parts {
            if let Part::History(working) = part
                && let Some(scale) = scales.next()
            {
                working.largest_force = scale;
            }
        }
        worst
    }

    /// Nodal forces of loads and contact on a body of finite elements, interleaved.
    pub(super) fn applied_forces(&self, linear: &Linear, index: usize) -> Vec<f64> {
        let mut forces = self.joint.nodal_loads(index, self.multipliers);
        let contact = self.contact_forces(linear, index);
        let nodes = self.joint.bodies[index].interface();
        for (force, &node) in contact.chunks_exact(2).zip(nodes) {
            forces[2 * node] += force[0];
            forces[2 * node + 1] += force[1];
        }
        forces
    }

    pub(super) fn contact_forces(&self, linear: &Linear, index: usize) -> Vec<f64> {
        let count = self.joint.bodies[index].contact_points();
        linear
            .problem
            .forces_on_body(index, count, &linear.solution.trial.forces)
    }
}

/// Multipliers of a problem with linearised bodies: the correction has 1.
pub(crate) fn with_correction(multipliers: &[f64]) -> Vec<f64> {
    multipliers.iter().copied().chain([1.0]).collect()
}
