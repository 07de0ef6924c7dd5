//! Tests of the contact solvers, from outside the crate.

mod audit;
mod contract;
mod deformed;
mod discrete;
mod family;
mod freedom;
mod growth;
mod histories;
mod invariants;
mod laws;
mod loose;
mod oracle;
mod otherwise;
mod pairs;
mod parts;
mod peaks;
mod proofs;
mod random;
mod recovery;
mod rigid;
mod scaling;
mod scene;
mod unique;
mod units;
mod work;
mod zones;

use std::sync::Arc;

use nalgebra::DMatrix;
use stickslip_contact::{
    ContactPair, ContactPoint, ContactState, InterfaceProblem, InterfaceSolver,
    solver::{Step, StepFailure, StepSolution},
    state::TrialState,
};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};
use stickslip_friction::{Coulomb, FrictionLaw};

/// Points against a rigid ground that cannot move, all of unit area.
struct Ground {
    normals: Vec<[f64; 2]>,
    gaps: Vec<f64>,
    law: Arc<dyn FrictionLaw>,
}

impl Ground {
    /// Normals along x, tangents along y: contact components are the body's own.
    fn along_x(gaps: Vec<f64>, law: Arc<dyn FrictionLaw>) -> Self {
        Self {
            normals: vec![[1.0, 0.0]; gaps.len()],
            gaps,
            law,
        }
    }

    /// The problem of `body` on this ground.
    fn under(&self, body: &GivenBody) -> InterfaceProblem {
        let points = (self.normals.iter().zip(&self.gaps))
            .enumerate()
            .map(|(k, (&normal, &gap))| ContactPoint {
                first: k.into(),
                second: k.into(),
                normal,
                gap,
                area: 1.0,
                material_angle: 0.0,
            })
            .collect();
        let held = RigidBody::held(body.points().to_vec(), body.load_cases());
        let pair = ContactPair {
            name: "ground".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points,
            law: self.law.clone(),
        };
        InterfaceProblem::new(&[body, &held], vec![pair]).unwrap()
    }
}

fn coulomb(mu: f64) -> Arc<dyn FrictionLaw> {
    Arc::new(Coulomb::new(mu).unwrap())
}

fn solve(
    solver: &dyn InterfaceSolver,
    problem: &InterfaceProblem,
    committed: &ContactState,
    multipliers: &[f64],
) -> Result<StepSolution, StepFailure> {
    solver.solve(&Step::new(problem, committed, multipliers))
}

/// The committed state after a step: histories advance by the slip increments.
fn commit(committed: &ContactState, trial: &TrialState, multipliers: &[f64]) -> ContactState {
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

/// A symmetric positive definite matrix B Bᵀ + ε I from the entries of B, row by row.
fn positive_definite(size: usize, entries: &[f64], epsilon: f64) -> DMatrix<f64> {
    let factor = DMatrix::from_row_slice(size, size, entries);
    &factor * factor.transpose() + DMatrix::identity(size, size) * epsilon
}
