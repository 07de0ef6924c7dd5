//! What stays of a solved linearisation: the loss of plies that fail, or the state that is accepted.

use stickslip_contact::StepRecord;
use stickslip_contact::solver::Step;
use stickslip_fem_core::body::internal_forces;

use super::solve::with_correction;
use super::{Accepted, Linear, Part, Solving};
use crate::body::{JointBody, Response};
use crate::damage::{PlyEvent, event, newly_flowing};
use crate::energy::Equilibrium;
use crate::error::Halt;
use crate::state::{BodyState, Energy, JointState};

impl Solving<'_> {
    /// Keeps the loss of the plies that fail, `failed` by body, as pairs of point and layer.
    pub(super) fn redistribute(
        &mut self,
        linear: &Linear,
        responses: Vec<Response>,
        failed: &[Vec<(usize, usize)>],
    ) -> Result<(), Halt> {
        let failures = failed.iter().map(Vec::len).sum();
        if self.passes == 0 && failures > self.settings.burst {
            return Err(Halt::Burst { failures });
        }
        if self.passes >= self.joint.options.passes {
            let passes = self.passes;
            return Err(Halt::Cascade { passes });
        }
        let predicted: Vec<Vec<[f64; 3]>> = (self.histories().zip(&responses))
            .map(|(working, response)| working.predicted(response))
            .collect();
        let stresses: Vec<&[[f64; 3]]> = predicted.iter().map(Vec::as_slice).collect();
        self.reckon(linear, &stresses);
        let [load, displacement] = self.read(linear);
        self.check_first(load)?;
        self.check_peak(load)?;
        let found: Vec<PlyEvent> = (self.events_of(&responses, failed))
            .map(|event| PlyEvent {
                load,
                displacement,
                pass: self.passes,
                ..event
            })
            .collect();
        self.events.extend(found);
        self.take(responses);
        let mut released = 0.0;
        let mut predicted = predicted.iter();
        for part in &mut self.parts {
            if let Part::History(working) = part
                && let Some(predicted) = predicted.next()
            {
                released += (working.pass_start).fail(working.body, &working.response, predicted);
                working.base = Some(working.response.trial.clone());
            }
        }
        self.released += released;
        self.passes += 1;
        Ok(())
    }

    fn events_of<'s>(
        &'s self,
        responses: &'s [Response],
        changed: &'s [Vec<(usize, usize)>],
    ) -> impl Iterator<Item = PlyEvent> + 's {
        let bodies = self.histories().zip(responses).zip(changed);
        bodies.flat_map(|((working, response), changed)| {
            changed.iter().map(move |&(point, layer)| {
                let states = (&working.base()[point], &response.trial[point]);
                event((working.index, working.body), (point, layer), states)
            })
        })
    }

    /// Adds the work of the loads up to here, where the bodies with a history have the stresses `stresses`.
    fn reckon(&mut self, linear: &Linear, stresses: &[&[[f64; 3]]]) {
        let mut stresses = stresses.iter();
        let bodies = (self.joint.bodies.iter().enumerate()).map(|(index, body)| BodyState {
            displacements: linear.displacements[index].clone(),
            support_work: match (&self.joint.support_motion[index], body) {
                (Some(motion), JointBody::Progressive(body)) => {
                    let stress = stresses.next().copied().unwrap_or_default();
                    self.support_work(linear, index, motion, &body.internal_forces(stress))
                }
                (None, JointBody::Progressive(_)) => {
                    stresses.next();
                    0.0
                }
                (Some(motion), JointBody::Elastic(body)) => {
                    let internal = internal_forces(body.body(), &linear.displacements[index]);
                    self.support_work(linear, index, motion, &internal)
                }
                (None, JointBody::Elastic(_)) | (_, JointBody::Rigid(_)) => 0.0,
            },
            ..BodyState::default()
        });
        let equilibrium = Equilibrium {
            bodies: bodies.collect(),
            multipliers: self.multipliers.to_vec(),
            rigid: linear.solution.trial.rigid.clone(),
        };
        self.external += self
            .equilibrium
            .work(self.joint, &linear.problem, &equilibrium);
        self.equilibrium = equilibrium;
    }

    /// Work `[force·length]` of the supports on their displacements `motion` at a multiplier of 1.
    pub(super) fn support_work(
        &self,
        linear: &Linear,
        index: usize,
        motion: &[f64],
        internal: &[f64],
    ) -> f64 {
        let applied = self.applied_forces(linear, index);
        let reactions = internal.iter().zip(&applied).map(|(i, a)| i - a);
        reactions.zip(motion).map(|(force, u)| force * u).sum()
    }

    /// Load and displacement at the equilibrium.
    pub(super) fn read(&self, linear: &Linear) -> [f64; 2] {
        let forces = &linear.solution.trial.forces;
        (self.joint.gauge).read(
            &linear.problem,
            forces,
            &self.equilibrium.bodies,
            self.joint.pulled_by,
        )
    }

    /// Makes the solved linearisation the end of the increment.
    pub(super) fn accept(mut self, linear: Linear) -> Accepted {
        let stresses: Vec<Vec<[f64; 3]>> = (self.histories())
            .map(|working| working.response.stress.clone())
            .collect();
        let stresses: Vec<&[[f64; 3]]> = stresses.iter().map(Vec::as_slice).collect();
        self.reckon(&linear, &stresses);
        let [load, displacement] = self.read(&linear);
        let flowing = self.flowing(load, displacement);
        self.events.extend(flowing);
        let jumps = self
            .histories()
            .map(|working| (working.pass_start).released_by_jump(working.body, &working.response));
        self.released += jumps.sum::<f64>();

        let multipliers = with_correction(self.multipliers);
        let step = Step::new(&linear.problem, self.origin(), &multipliers);
        let contact = StepRecord {
            work: self.work,
            ..StepRecord::of(&step, linear.solution)
        };
        let energy = self.energy(contact.dissipation());
        let mut bodies = self.equilibrium.bodies;
        for part in self.parts {
            if let Part::History(working) = part {
                let before = self.start.bodies[working.index].largest_force;
                let body = &mut bodies[working.index];
                body.largest_force = before.max(working.largest_force);
                body.points = working.response.trial;
                body.stress = working.response.stress;
            }
        }
        Accepted {
            state: JointState {
                multipliers: self.multipliers.to_vec(),
                contact: contact.state.clone(),
                bodies,
                energy,
            },
            contact,
            load,
            displacement,
            events: self.events,
            passes: self.passes,
            residuals: self.residuals,
            severed: false,
        }
    }

    /// Plies that began to flow.
    fn flowing(&self, load: f64, displacement: f64) -> Vec<PlyEvent> {
        let mut events = Vec::new();
        for working in self.histories() {
            let body = (working.index, working.body);
            for (point, layer) in newly_flowing(working.start, &working.response.trial) {
                let state = &working.response.trial[point];
                events.push(PlyEvent {
                    load,
                    displacement,
                    pass: self.passes,
                    ..event(body, (point, layer), (state, state))
                });
            }
        }
        events
    }

    fn energy(&self, friction: f64) -> Energy {
        let before = self.start.energy;
        let mut energy = Energy {
            external: before.external + self.external,
            friction: before.friction + friction,
            released: before.released + self.released,
            stored: 0.0,
            dissipated: 0.0,
        };
        for working in self.histories() {
            let [stored, dissipated] = working.body.energies(&working.response.trial);
            energy.stored += stored;
            energy.dissipated += dissipated;
        }
        for (body, state) in self.joint.bodies.iter().zip(&self.equilibrium.bodies) {
            if let JointBody::Elastic(body) = body {
                let u = &state.displacements;
                let forces = internal_forces(body.body(), u);
                energy.stored += 0.5 * forces.iter().zip(u).map(|(f, u)| f * u).sum::<f64>();
            }
        }
        energy
    }
}
