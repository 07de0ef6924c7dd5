//! Where load and displacement of a joint are read.

use nalgebra::DVector;
use stickslip_contact::{ContactPair, InterfaceProblem};

use crate::body::JointBody;
use crate::error::JointError;
use crate::state::BodyState;

/// The force that is called the joint's load.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Pull {
    /// The resultant of the contact forces on the first body of pair `pair`, along the unit vector `direction`.
    Contact {
        /// Index of the pair.
        pair: usize,
        /// Unit vector `[1]`.
        direction: [f64; 2],
    },
    /// The force of the driven supports of body `body` along their displacement: their work over the largest one of a node.
    Supports {
        /// Index of the body.
        body: usize,
    },
}

/// A place whose displacement is read.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Mark {
    /// A place that does not move, as a held rigid pin.
    Fixed,
    /// A mesh node of an elastic or progressive body, or a contact point of a rigid one.
    Node {
        /// Index of the body.
        body: usize,
        /// Index of the node.
        node: usize,
    },
}

/// How load and displacement are read: load = `multiple` × force, displacement = (u_first − u_second) · direction − `free_travel`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Gauge {
    /// The force.
    pub pull: Pull,
    /// Factor on the force `[1]`: 2 for one half of a symmetric joint.
    pub multiple: f64,
    /// Direction of the displacement, a unit vector `[1]`.
    pub direction: [f64; 2],
    /// The place that moves along `direction` as the joint gives.
    pub first: Mark,
    /// The place that it moves away from.
    pub second: Mark,
    /// What the pin moves before it can bear along `direction` `[length]`, so that displacements count from there.
    pub free_travel: f64,
}

impl Gauge {
    pub(crate) fn check(
        &self,
        bodies: &[JointBody],
        pairs: &[ContactPair],
    ) -> Result<(), JointError> {
        let missing = |what, index| Err(JointError::Gauge { what, index });
        match self.pull {
            Pull::Contact { pair, .. } if pair >= pairs.len() => return missing("pair", pair),
            Pull::Supports { body } if body >= bodies.len() => return missing("body", body),
            Pull::Contact { .. } | Pull::Supports { .. } => {}
        }
        for mark in [self.first, self.second] {
            if let Mark::Node { body, node } = mark {
                match bodies.get(body) {
                    None => return missing("body", body),
                    Some(known) if node >= known.node_count() => return missing("node", node),
                    Some(_) => {}
                }
            }
        }
        let number = |what, value: f64| {
            if value.is_finite() && value != 0.0 {
                Ok(())
            } else {
                Err(JointError::GaugeNumber { what, value })
            }
        };
        number("multiple", self.multiple)?;
        if !self.free_travel.is_finite() {
            let (what, value) = ("free travel", self.free_travel);
            return Err(JointError::GaugeNumber { what, value });
        }
        number("direction", self.direction[0].hypot(self.direction[1]))?;
        if let Pull::Contact { direction, .. } = self.pull {
            number("direction of the force", direction[0].hypot(direction[1]))?;
        }
        Ok(())
    }

    /// Load `[force]` and displacement `[length]` under contact forces `forces`, where driven supports move by `pulled_by` `[length]` at a multiplier of 1.
    pub(crate) fn read(
        &self,
        problem: &InterfaceProblem,
        forces: &DVector<f64>,
        bodies: &[BodyState],
        pulled_by: f64,
    ) -> [f64; 2] {
        let force = match self.pull {
            Pull::Contact { pair, direction } => {
                let points = problem.pair_points(pair);
                points
                    .map(|k| {
                        let actions = &problem.points()[k].actions;
                        let along =
                            |i: usize| actions[i][0] * direction[0] + actions[i][1] * direction[1];
                        along(0) * forces[2 * k] + along(1) * forces[2 * k + 1]
                    })
                    .sum()
            }
            Pull::Supports { body } => bodies[body].support_work / pulled_by,
        };
        let at = |mark: Mark| match mark {
            Mark::Fixed => 0.0,
            Mark::Node { body, node } => {
                let u = &bodies[body].displacements;
                u[2 * node] * self.direction[0] + u[2 * node + 1] * self.direction[1]
            }
        };
        let moved = at(self.first) - at(self.second);
        [self.multiple * force, moved - self.free_travel]
    }
}
