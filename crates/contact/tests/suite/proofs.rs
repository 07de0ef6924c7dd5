//! What may be called a proof that a step has no solution, and what may not.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::solver::FailureCause;
use stickslip_contact::{Chain, ContactState, Enumeration, InterfaceProblem};
use stickslip_friction::{FrictionLaw, PointStatus, StaticDynamic, Transition};

use crate::{Ground, coulomb, solve};
use stickslip_fem_core::GivenBody;

/// Two points that are pressed by 1 into the ground and drawn along it by 1, which nothing but friction of 0.5 resists. Their
/// normal compliances differ by `difference`: at zero only the sum of their forces would be determined.
fn drawn(difference: f64) -> InterfaceProblem {
    let normal = 1.0 - difference;
    let compliance = DMatrix::from_row_slice(
        4,
        4,
        &[
            1.0, 0.0, normal, 0.0, 0.0, 1.0, 0.0, 0.0, normal, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0,
        ],
    );
    let modes = DMatrix::from_row_slice(4, 1, &[0.0, 1.0, 0.0, 1.0]);
    let pressed = DVector::from_vec(vec![-1.0, 0.0, -1.0, 0.0]);
    let body = GivenBody::floating(
        compliance,
        modes,
        vec![pressed],
        vec![DVector::from_element(1, 1.0)],
    )
    .unwrap();
    Ground::along_x(vec![0.0; 2], coulomb(0.5)).under(&body)
}

/// λ_n sums to 1 or a little more, so that friction holds 0.5 or a little more, whatever the statuses; the cones alone do not
/// say so. Where the matrix of two touching points is as good as singular, none of these solves is to be trusted.
#[test]
fn ill_conditioned_statuses_prove_nothing() {
    for (difference, trusted) in [(0.5, true), (1e-3, true), (1e-13, false)] {
        let problem = drawn(difference);
        let start = ContactState::unloaded(&problem);
        let failure = solve(&Enumeration::default(), &problem, &start, &[1.0]).unwrap_err();
        let [
            (
                _,
                FailureCause::NoSolution {
                    combinations,
                    proved,
                },
            ),
        ] = failure.attempts[..]
        else {
            panic!("{failure}");
        };
        assert_eq!((combinations, proved), (16, trusted), "{difference}");
        let failure = solve(&Chain::default(), &problem, &start, &[1.0]).unwrap_err();
        assert_eq!(failure.is_unresolved(), !trusted, "{failure}");
    }
}

/// One point of a body that floats along both directions; load cases press it into the ground and draw it along.
fn floating(law: Arc<dyn FrictionLaw>) -> InterfaceProblem {
    let modes = DMatrix::identity(2, 2);
    let loads = [[-1.0, 0.0], [0.0, 1.0]].map(|load| DVector::from_row_slice(&load));
    let responses = vec![DVector::zeros(2); 2];
    let body = GivenBody::floating(DMatrix::identity(2, 2), modes, responses, loads.to_vec());
    Ground::along_x(vec![0.0], law).under(&body.unwrap())
}

/// One point pressed by 1 that slipped in the last step: 0.1 holds it now, and 0.3 would if it had not slipped. A pull between
/// the two is not held from here, which is no proof that nothing could hold it; a pull beyond both is.
#[test]
fn what_a_point_remembers_is_no_proof() {
    let law = StaticDynamic::new(0.3, 0.1, Transition::Lagged).unwrap();
    let problem = floating(Arc::new(law));
    let mut state = ContactState::unloaded(&problem);
    state.history[0] = state.history[0].commit(PointStatus::Slip, 1.0);
    for (pull, impossible) in [(0.2, false), (0.31, true)] {
        let failure = solve(&Chain::default(), &problem, &state, &[1.0, pull]).unwrap_err();
        assert_eq!(failure.is_proved_impossible(), impossible, "{failure}");
    }
    state.history[0] = ContactState::unloaded(&problem).history[0];
    assert!(solve(&Chain::default(), &problem, &state, &[1.0, 0.2]).is_ok());
}

/// A law whose traction drops says nothing of its bound at other pressures: a pull beyond all of its friction is named as the
/// reason, and is no proof.
#[test]
fn a_law_that_does_not_promise_proportionality_gives_a_reason_and_no_proof() {
    let law = StaticDynamic::new(0.3, 0.1, Transition::Drop).unwrap();
    let problem = floating(Arc::new(law));
    let start = ContactState::unloaded(&problem);
    let failure = solve(&Chain::default(), &problem, &start, &[1.0, 0.31]).unwrap_err();
    let (first, cause) = &failure.attempts[0];
    assert_eq!(*first, "force balance");
    assert!(matches!(
        cause,
        FailureCause::Unbalanced { proved: false, .. }
    ));
    assert!(failure.is_unresolved());
    assert!(solve(&Chain::default(), &problem, &start, &[1.0, 0.29]).is_ok());
}
