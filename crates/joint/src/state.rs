//! What is known of a joint at the end of an accepted increment.

use stickslip_contact::ContactState;
use stickslip_laminate::progressive::PointState;

use crate::body::JointBody;

/// A joint at the end of an accepted increment.
#[derive(Clone, Debug)]
pub struct JointState {
    /// Multipliers of the load cases `[1]`, one for each.
    pub multipliers: Vec<f64>,
    /// Contact. Its own multipliers have one entry more, that of the correction of linearised bodies.
    pub contact: ContactState,
    /// One entry per body.
    pub bodies: Vec<BodyState>,
    /// Energies since the start.
    pub energy: Energy,
}

/// A body at the end of an accepted increment.
#[derive(Clone, Debug, Default)]
pub struct BodyState {
    /// Displacements of all nodes `[length]`, interleaved; of the contact points of a rigid body.
    pub displacements: Vec<f64>,
    /// Work `[force·length]` of the driven supports on their displacements at a multiplier of 1.
    pub support_work: f64,
    /// Largest nodal force `[force]` so far, by which unbalanced forces are measured where little is left of the load.
    pub largest_force: f64,
    /// History of each quadrature point; empty unless the body has one.
    pub points: Vec<PointState>,
    /// Mean stress (xx, yy, xy) of each quadrature point `[stress]`; empty unless the body has a history.
    pub stress: Vec<[f64; 3]>,
}

/// Energies since the start `[force·length]`.
///
/// ```text
/// external = stored + dissipated + friction + released
/// ```
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Energy {
    /// Work of loads and driven supports, ∫ F du by the trapezoidal rule `[force·length]`.
    pub external: f64,
    /// Change of the elastic energy of all bodies `[force·length]`.
    pub stored: f64,
    /// What the points of the bodies dissipated `[force·length]`.
    pub dissipated: f64,
    /// What slip dissipated `[force·length]`.
    pub friction: f64,
    /// What was set free where plies lost stiffness at once, beyond what their model dissipates: in the joint it goes into waves `[force·length]`.
    pub released: f64,
}

impl Energy {
    /// What is missing in the balance, relative to the largest term `[1]`: the error of the trapezoidal rule where a curve bends.
    pub fn imbalance(&self) -> f64 {
        let parts = [self.stored, self.dissipated, self.friction, self.released];
        let sum: f64 = parts.iter().sum();
        let scale = parts
            .iter()
            .fold(self.external.abs(), |m, part| m.max(part.abs()));
        if scale > 0.0 {
            (self.external - sum) / scale
        } else {
            0.0
        }
    }
}

impl JointState {
    /// At rest, with `contact` unloaded.
    pub(crate) fn at_rest(bodies: &[JointBody], contact: ContactState, cases: usize) -> Self {
        let rest = |body: &JointBody| {
            let points: Vec<PointState> = body.progressive().map_or_else(Vec::new, |body| {
                (0..body.points().count())
                    .map(|point| body.rest(point).clone())
                    .collect()
            });
            BodyState {
                displacements: vec![0.0; 2 * body.node_count()],
                support_work: 0.0,
                largest_force: 0.0,
                stress: vec![[0.0; 3]; points.len()],
                points,
            }
        };
        Self {
            multipliers: vec![0.0; cases],
            contact,
            bodies: bodies.iter().map(rest).collect(),
            energy: Energy::default(),
        }
    }
}
