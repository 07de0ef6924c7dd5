//! Whether a joint still holds without what its failed plies are left with.
//!
//! ```text
//! K(r) u = f + Bᵀ λ  with contact,      K(r): failed plies keep the part r of what their model leaves them
//! holds       f · u and the force of driven supports stay of their size as r → 0
//! severed     f · u grows like 1/r, the force of driven supports falls like r
//! ```
//!
//! A model leaves failed plies some stiffness so that equations can be solved. A joint that bears its load by it alone has no load path:
//! what it bears grows with the displacement for ever, and is a number about the factors that the model was given. Whether it does is a
//! limit, which knows neither the size of the cells nor that of the factors; one solve at a very small r finds it. Material that is crushed is
//! pressed together and keeps what its model leaves it, so bearing severs nothing.

use nalgebra::DVector;
use stickslip_contact::InterfaceSolver;
use stickslip_fem_core::body::internal_forces;
use stickslip_fem_core::material::apply;
use stickslip_fem_core::points::strains;

use super::{IncrementSettings, Linear, Part, Solving};
use crate::body::{JointBody, ProgressiveBody, Response};
use crate::joint::Joint;
use crate::operator::Factors;
use crate::state::{BodyState, JointState};

/// r.
const PART: f64 = 1e-5;
/// By how much the work of the loads grows, or the force of driven supports falls, where a joint is severed: nine tenths of its stiffness
/// are then what failed plies are left with. The work grows by 1/r times the part of it that failed rows have, so the choice of the factor matters
/// only while a last shred is sound.
const FACTOR: f64 = 10.0;
/// Largest principal stress, as a part of the magnitude of the smallest, up to which a point is pressed together.
const PRESSED: f64 = 0.5;

impl Joint {
    /// Whether the joint in the equilibrium `state` holds by what failed plies are left with; false where contact finds no
    /// solution without it. Counts its factorisations in `factors`.
    pub(crate) fn is_severed(
        &self,
        state: &JointState,
        solver: &dyn InterfaceSolver,
        factors: &mut Factors,
    ) -> bool {
        let mut starting = Vec::with_capacity(self.bodies.len());
        for (body, state) in self.bodies.iter().zip(&state.bodies) {
            let response = body.progressive().map(|body| weakened(body, state));
            if response.as_ref().is_some_and(Option::is_none) {
                return false;
            }
            starting.push(response.flatten());
        }
        let settings = IncrementSettings {
            quickly: false,
            burst: usize::MAX,
            peak: f64::INFINITY,
            sound: f64::INFINITY,
        };
        let mut solving = Solving::new(self, state, &starting, &state.multipliers, settings);
        // The joint's own factors are those of the next iterations.
        let mut own = Factors::new(self.bodies.len());
        let solved = solving.linearised(solver, &mut own, None);
        factors.factorisations += own.factorisations;
        solved.is_ok_and(|linear| solving.has_lost(&linear))
    }
}

impl Solving<'_> {
    /// Whether the work of the loads, or the force of driven supports, has left the size that it has at the start.
    fn has_lost(&self, linear: &Linear) -> bool {
        let start = self.start.bodies.iter();
        let start: Vec<&[f64]> = start.map(|body| body.displacements.as_slice()).collect();
        let end: Vec<&[f64]> = linear.displacements.iter().map(Vec::as_slice).collect();
        let before = self.work_of_loads(linear, &start, &self.start.contact.rigid);
        let after = self.work_of_loads(linear, &end, &linear.solution.trial.rigid);
        let (mut driven, mut held) = (0.0, 0.0);
        for (index, motion) in self.joint.support_motion.iter().enumerate() {
            if let Some(motion) = motion {
                let drive = self.joint.drive(index, self.multipliers);
                let internal = self.weakened_forces(index, end[index]);
                driven += drive * self.start.bodies[index].support_work;
                held += drive * self.support_work(linear, index, motion, &internal);
            }
        }
        after > FACTOR * (before.abs() + driven.abs()) || (driven > 0.0 && FACTOR * held < driven)
    }

    /// Work of the loads at their present size along the displacements `moved` of the bodies and the rigid motions `rigid`.
    fn work_of_loads(&self, linear: &Linear, moved: &[&[f64]], rigid: &DVector<f64>) -> f64 {
        let rigid_loads = linear.problem.mode_load(self.multipliers);
        let of_body = |(index, body): (usize, &JointBody)| -> f64 {
            if let JointBody::Rigid(_) = body {
                let modes = linear.problem.body_modes(index);
                return modes.map(|mode| rigid_loads[mode] * rigid[mode]).sum();
            }
            let loads = self.joint.nodal_loads(index, self.multipliers);
            loads.iter().zip(moved[index]).map(|(f, u)| f * u).sum()
        };
        self.joint.bodies.iter().enumerate().map(of_body).sum()
    }

    /// Nodal forces `[force]` of body `index` under the displacements `moved`, its plies weakened.
    fn weakened_forces(&self, index: usize, moved: &[f64]) -> Vec<f64> {
        match (&self.parts[index], self.joint.bodies[index].elements()) {
            (Part::History(working), _) => {
                let strain = strains(working.body.body().mesh(), moved);
                let tangents = working.response.tangents.iter();
                let stress: Vec<[f64; 3]> = (tangents.zip(&strain))
                    .map(|(tangent, strain)| apply(tangent, *strain))
                    .collect();
                working.body.internal_forces(&stress)
            }
            (Part::Linear(_), Some((body, _))) => internal_forces(body, moved),
            (Part::Linear(_), None) => Vec::new(),
        }
    }
}

/// A body whose failed plies keep next to nothing, save where they are pressed together; `None` where its model has no such plies.
fn weakened(body: &ProgressiveBody, state: &BodyState) -> Option<Response> {
    let tangents = (state.points.iter().zip(&state.stress).enumerate())
        .map(|(point, (own, stress))| {
            let part = if is_pressed(*stress) { 1.0 } else { PART };
            body.model(point).weakened_stiffness(own, part)
        })
        .collect::<Option<Vec<_>>>()?;
    let nothing = vec![[0.0; 3]; tangents.len()];
    Some(Response {
        strain: nothing.clone(),
        stress: nothing,
        tangents,
        trial: Vec::new(),
    })
}

/// Whether the stress (xx, yy, xy) presses together more than it pulls apart.
fn is_pressed([xx, yy, xy]: [f64; 3]) -> bool {
    let (mean, radius) = (f64::midpoint(xx, yy), (0.5 * (xx - yy)).hypot(xy));
    mean - radius < 0.0 && mean + radius <= PRESSED * (radius - mean)
}
