//! What is reported of a step is that of the state that is kept, and shows what is wrong with it.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::solver::{InterfaceSolver, Residuals, Step, StepFailure, StepSolution};
use stickslip_contact::{
    Chain, ContactPair, ContactPoint, InterfaceProblem, LoadHistory, Ramp, StepRecord,
};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::coulomb;

/// Solves as the chain does, then changes force `row` by the factor 1 + `error` or, where it is zero, by `error`.
#[derive(Debug)]
struct Wrong {
    row: usize,
    error: f64,
}

impl InterfaceSolver for Wrong {
    fn name(&self) -> &'static str {
        "wrong"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let mut solution = Chain::default().solve(step)?;
        let force = &mut solution.trial.forces[self.row];
        *force += self.error * if *force == 0.0 { 1.0 } else { *force };
        Ok(solution)
    }
}

/// Two rigid blocks on held elastic points that know nothing of each other; load cases push each against its point along x.
fn blocks(mu: f64) -> InterfaceProblem {
    let compliance = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 0.5]));
    let grounds =
        [0, 1].map(|_| GivenBody::held(compliance.clone(), vec![DVector::zeros(2); 2]).unwrap());
    let block = |forces| RigidBody::sliding(vec![[0.0, 0.0]], [true, false], forces);
    let first = block(&[[1.0, 0.0], [0.0, 0.0]]);
    let second = block(&[[0.0, 0.0], [1.0, 0.0]]);
    let pair = |ground: usize| ContactPair {
        name: "block".into(),
        origin: [0.0; 2],
        first: ground,
        second: ground + 2,
        points: vec![ContactPoint {
            first: 0.into(),
            second: 0.into(),
            normal: [1.0, 0.0],
            gap: 0.0,
            area: 1.0,
            material_angle: 0.0,
        }],
        law: coulomb(mu),
    };
    let bodies: [&dyn InterfaceOperator; 4] = [&grounds[0], &grounds[1], &first, &second];
    InterfaceProblem::new(&bodies, vec![pair(0), pair(1)]).unwrap()
}

fn follow(wrong: &Wrong, mu: f64, steps: Vec<Vec<f64>>) -> Vec<StepRecord> {
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    history.follow(&blocks(mu), wrong, |_| {}).unwrap()
}

#[test]
fn a_small_error_in_a_force_shows_in_the_balance() {
    let right = Wrong { row: 0, error: 0.0 };
    let steps = || vec![vec![1e3, 1e-4], vec![1e-2, 1e-4]];
    for record in follow(&right, 0.3, steps()) {
        assert!(record.audit.balance() < 1e-13);
    }
    // In the large joint, where it is pushed hard and softly; in the small one beside it.
    for (row, step) in [(0, 0), (0, 1), (2, 0), (2, 1)] {
        let record = &follow(&Wrong { row, error: 1e-6 }, 0.3, steps())[step];
        assert!(
            record.audit.balance() > 1e-10,
            "{row} {step} {:?}",
            record.audit
        );
    }
}

/// Without friction a point that touches slips, whatever status the solver gave it; a shear that was hidden under the bound of
/// a sticking point is then one beyond it.
#[test]
fn residuals_are_those_of_the_state_that_is_kept() {
    let wrong = Wrong {
        row: 1,
        error: 1e-3,
    };
    let record = &follow(&wrong, 0.0, vec![vec![1.0, 1.0]])[0];
    let Residuals { cone, .. } = record.residuals;
    assert!((cone - 1e-3).abs() < 1e-12, "{cone}");
}
