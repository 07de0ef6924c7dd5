//! Small contact problems given by their numbers, and all their solutions.
//!
//! ```text
//! K u = F + λ,   g = g₀ + u_n ≥ 0,   λ_n ≥ 0,   g λ_n = 0,   |λ_t| ≤ μ λ_n,   λ_t = −μ λ_n sign Δs where Δs ≠ 0
//! ```
//!
//! One step of so few points can be solved by trying all 4ⁿ combinations of statuses, so that a solver's answer can be held
//! against everything there is. Nothing in here uses a contact solver.

mod conditions;
mod one_node;
mod published;
mod punch;
mod random;

use std::sync::Arc;

use stickslip_contact::solver::Step;
use stickslip_contact::state::TrialState;
use stickslip_contact::{
    ContactError, ContactPair, ContactPoint, ContactState, InterfaceProblem, Status,
};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};
use stickslip_friction::FrictionLaw;

pub use conditions::Enumeration;
pub use one_node::{one_node, one_node_bound, wedged};
pub use published::{Published, published};
pub use punch::{flat_punch, flat_punch_under};
pub use random::random;

use conditions::Conditions;

/// One increment of a small contact problem.
#[derive(Clone, Debug)]
pub struct Discrete {
    /// What it is.
    pub name: String,
    /// Its bodies and points.
    pub problem: InterfaceProblem,
    /// The last accepted state.
    pub committed: ContactState,
    /// Load multipliers at the end of the increment `[1]`.
    pub multipliers: Vec<f64>,
    /// Whether all bodies are supported: then the increment has a solution, whatever the friction.
    pub coercive: bool,
    /// Solutions that are known apart from any solver.
    pub solutions: Option<Known>,
}

/// Known solutions of an increment.
#[derive(Clone, Debug, PartialEq)]
pub struct Known {
    /// Whether these are all there are; if so and there are none, the increment has no solution.
    pub complete: bool,
    /// The solutions.
    pub states: Vec<TrialState>,
}

impl Discrete {
    /// The increment as solvers see it.
    pub fn step(&self) -> Step<'_> {
        Step::new(&self.problem, &self.committed, &self.multipliers)
    }

    /// Largest violation `[1]` of the equations and of the contact conditions by `trial`, relative to the largest force and length
    /// in play: computed from the problem alone, not from the residuals of the solvers. Infinite for a trial that is not
    /// finite.
    pub fn check(&self, trial: &TrialState) -> f64 {
        self.conditions().violation(trial)
    }

    /// Of `states` the nearest to the last accepted state: that whose statuses differ from it at the fewest points, and of equal
    /// ones that which has moved least.
    pub fn nearest<'s>(&self, states: &'s [TrialState]) -> Option<&'s TrialState> {
        let distance = |state: &TrialState| {
            let pairs = state.status.iter().zip(&self.committed.status);
            let changes = pairs.filter(|(new, old)| new != old).count();
            (changes, (&state.motion - &self.committed.motion).amax())
        };
        states.iter().min_by(|a, b| {
            let (a, b) = (distance(a), distance(b));
            a.0.cmp(&b.0).then(a.1.total_cmp(&b.1))
        })
    }

    /// Whether no load is left at the end of the increment.
    pub fn is_unloaded(&self) -> bool {
        let (motion, force) = (
            self.problem.load_motion(&self.multipliers),
            self.problem.mode_load(&self.multipliers),
        );
        motion.iter().chain(force.iter()).all(|&load| load == 0.0)
    }

    fn conditions(&self) -> Conditions<'_> {
        Conditions::new(&self.problem, &self.committed, &self.multipliers)
    }

    /// The same problem after `trial` was accepted, under the next load, of the `multipliers` `[1]`.
    #[must_use]
    pub fn next(&self, trial: &TrialState, multipliers: Vec<f64>) -> Self {
        Self {
            name: self.name.clone(),
            problem: self.problem.clone(),
            committed: commit(&self.committed, trial, &self.multipliers),
            multipliers,
            coercive: self.coercive,
            solutions: None,
        }
    }
}

/// All solutions of an increment whose friction bound is proportional to pressure, by trying all 4ⁿ combinations of statuses.
pub fn enumerate(discrete: &Discrete) -> Enumeration {
    discrete.conditions().enumerate()
}

/// The state after `trial` was accepted: histories advance by the slip increments. `multipliers` `[1]` are those of the step.
pub fn commit(committed: &ContactState, trial: &TrialState, multipliers: &[f64]) -> ContactState {
    let history = (0..trial.status.len())
        .map(|k| {
            let increment = trial.motion[2 * k + 1] - committed.tangential_displacement(k);
            committed.history[k].commit(trial.status[k].without_direction(), increment)
        })
        .collect();
    ContactState {
        forces: trial.forces.clone(),
        motion: trial.motion.clone(),
        rigid: trial.rigid.clone(),
        status: trial.status.clone(),
        history,
        multipliers: multipliers.to_vec(),
    }
}

/// `body` against rigid ground: its points, one after the other, with the ground's unit normals into the body, gaps `[length]`
/// and areas `[length²]`.
///
/// # Errors
/// As [`InterfaceProblem::new`].
pub fn on_ground(
    body: &GivenBody,
    points: &[GroundPoint],
    law: Arc<dyn FrictionLaw>,
) -> Result<InterfaceProblem, ContactError> {
    let ground = RigidBody::held(body.points().to_vec(), body.load_cases());
    let points = points
        .iter()
        .enumerate()
        .map(|(k, point)| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal: point.normal,
            gap: point.gap,
            area: point.area,
            material_angle: 0.0,
        })
        .collect();
    let pair = ContactPair {
        name: "ground".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law,
    };
    InterfaceProblem::new(&[body, &ground], vec![pair])
}

/// What the ground is like under one point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GroundPoint {
    /// Unit normal from the ground into the body `[1]`.
    pub normal: [f64; 2],
    /// Initial gap `[length]`.
    pub gap: f64,
    /// Contact area `[length²]`.
    pub area: f64,
}

impl GroundPoint {
    /// A normal along x, so that contact components (n, t) are the body's own (x, y), and an area of 1.
    fn along_x(gap: f64) -> Self {
        Self {
            normal: [1.0, 0.0],
            gap,
            area: 1.0,
        }
    }
}

const STATUSES: [Status; 4] = [
    Status::Open,
    Status::Stick,
    Status::SlipPositive,
    Status::SlipNegative,
];
