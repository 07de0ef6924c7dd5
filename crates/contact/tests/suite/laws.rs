//! Laws whose stick and slip bounds differ or are not proportional to pressure, against scalar solutions by hand.

mod pressure;

use std::sync::Arc;

use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector};
use stickslip_contact::{
    Chain, ContactState, Enumeration, InterfaceProblem, InterfaceSolver, LoadHistory, Pivoting,
    Ramp, SemismoothNewton, Status, StepRecord,
};
use stickslip_friction::{
    FrictionLaw, PressurePower, SlipPath, SlipPower, StaticDynamic, Transition,
};

use crate::oracle::Conditions;
use crate::{Ground, commit, solve};
use stickslip_fem_core::GivenBody;

/// A few operations on numbers of order one.
const EXACT: f64 = 1e-13;
/// Newton's method on the law stops at 1e-12 of the largest force.
const CONVERGED: f64 = 1e-11;

/// The body of stiffness `stiffness` (n₀, t₀, n₁, t₁, …) with a unit force on each dof as a load case, touching the ground.
fn problem(stiffness: &[&[f64]], law: Arc<dyn FrictionLaw>) -> InterfaceProblem {
    let size = stiffness.len();
    let compliance = DMatrix::from_fn(size, size, |i, j| stiffness[i][j])
        .try_inverse()
        .unwrap();
    let responses = (0..size)
        .map(|i| compliance.column(i).into_owned())
        .collect();
    Ground::along_x(vec![0.0; size / 2], law)
        .under(&GivenBody::held(compliance, responses).unwrap())
}

fn follow(
    problem: &InterfaceProblem,
    solver: &dyn InterfaceSolver,
    loads: &[&[f64]],
) -> Vec<StepRecord> {
    let steps = loads.iter().map(|load| load.to_vec()).collect();
    LoadHistory::new(steps, 1, Ramp::Linear)
        .unwrap()
        .follow(problem, solver, |_| {})
        .unwrap()
}

fn every_solver() -> [Box<dyn InterfaceSolver>; 4] {
    [
        Box::new(Chain::default()),
        Box::new(SemismoothNewton::default()),
        Box::new(Pivoting::default()),
        Box::new(Enumeration::default()),
    ]
}

/// Root of an increasing `function` between `low` and `high`.
fn root(function: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    assert!(function(low) < 0.0 && function(high) > 0.0);
    for _ in 0..200 {
        let middle = f64::midpoint(low, high);
        if function(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

/// Two points, k_n = 1, k_t = 1, coupled tangentially by a spring c = 2.
const COUPLED: [&[f64]; 4] = [
    &[1.0, 0.0, 0.0, 0.0],
    &[0.0, 3.0, 0.0, -2.0],
    &[0.0, 0.0, 1.0, 0.0],
    &[0.0, -2.0, 0.0, 3.0],
];

/// μs = 1/2, μd = 1/4; both points are pressed by 1. Point 0 is pulled by 0.6 > μs: it drops to 1/4 and slips by
/// (0.6 − 0.25)/3; the spring then pulls point 1 with 2·0.35/3 < 1/4.
#[test]
fn drop_of_one_point_loads_its_neighbour() {
    let law = Arc::new(StaticDynamic::new(0.5, 0.25, Transition::Drop).unwrap());
    let problem = problem(&COUPLED, law);
    for solver in every_solver() {
        let records = follow(
            &problem,
            &*solver,
            &[&[-1.0, 0.0, -1.0, 0.0], &[-1.0, 0.6, -1.0, 0.0]],
        );
        let state = &records[1].state;
        assert_eq!(
            state.status,
            [Status::SlipPositive, Status::Stick],
            "{}",
            solver.name()
        );
        assert_abs_diff_eq!(state.tangential_force(0), -0.25, epsilon = EXACT);
        assert_abs_diff_eq!(
            state.tangential_displacement(0),
            0.35 / 3.0,
            epsilon = EXACT
        );
        assert_abs_diff_eq!(state.tangential_force(1), -0.7 / 3.0, epsilon = EXACT);
        assert_eq!(records[1].doubtful, 0);
    }
}

/// The same with point 1 pulled by 0.2 of its own: 0.2 + 0.7/3 = 0.433 lies between μd and μs, so it may stick or slip. It
/// sticks if it stuck before, and is reported in doubt; having slipped, it cannot.
#[test]
fn the_committed_state_decides_between_stick_and_slip() {
    let law = Arc::new(StaticDynamic::new(0.5, 0.25, Transition::Drop).unwrap());
    let problem = problem(&COUPLED, law);
    let newton = SemismoothNewton::default();
    let load: &[f64] = &[-1.0, 0.6, -1.0, 0.2];
    let stuck = follow(&problem, &newton, &[&[-1.0, 0.0, -1.0, 0.0], load]);
    assert_eq!(stuck[1].state.status, [Status::SlipPositive, Status::Stick]);
    assert_abs_diff_eq!(
        stuck[1].state.tangential_force(1),
        -0.2 - 0.7 / 3.0,
        epsilon = EXACT
    );
    assert_eq!(stuck[1].doubtful, 1);

    let slipped = follow(&problem, &newton, &[&[-1.0, 0.55, -1.0, 0.55], load]);
    assert_eq!(slipped[0].state.status, [Status::SlipPositive; 2]);
    // Both slip by (0.55 − 0.25)/1, and stop at their displacement or go on at λ_t = −1/4.
    assert_abs_diff_eq!(
        slipped[0].state.tangential_displacement(1),
        0.3,
        epsilon = EXACT
    );
    for k in 0..2 {
        assert!(slipped[1].state.tangential_force(k).abs() <= 0.25 + EXACT);
    }
    assert_eq!(slipped[1].doubtful, 0);
}

/// One point: once it has slipped it holds only μd; after a step of rest it holds μs again.
#[test]
fn rest_restores_the_static_coefficient() {
    let law = Arc::new(StaticDynamic::new(0.5, 0.25, Transition::Drop).unwrap());
    let problem = problem(&[&[1.0, 0.0], &[0.0, 2.0]], law);
    for solver in every_solver() {
        let loads: [&[f64]; 5] = [
            &[-1.0, 0.6],
            &[-1.0, 0.8],
            &[-1.0, 0.7],
            &[-1.0, 1.0],
            &[-1.0, 1.1],
        ];
        let records = follow(&problem, &*solver, &loads);
        let displacements = [0.35 / 2.0, 0.55 / 2.0, 0.55 / 2.0, 0.55 / 2.0, 0.85 / 2.0];
        for (record, displacement) in records.iter().zip(displacements) {
            assert_abs_diff_eq!(
                record.state.tangential_displacement(0),
                displacement,
                epsilon = EXACT
            );
        }
        let doubtful: Vec<usize> = records.iter().map(|record| record.doubtful).collect();
        assert_eq!(doubtful, [0, 0, 0, 1, 0], "{}", solver.name());
    }
}

/// Lagged: the step in which slip begins is at μs, the next one at μd.
#[test]
fn lagged_transition_falls_one_step_later() {
    let law = Arc::new(StaticDynamic::new(0.5, 0.25, Transition::Lagged).unwrap());
    let problem = problem(&[&[1.0, 0.0], &[0.0, 2.0]], law);
    for solver in every_solver() {
        let records = follow(&problem, &*solver, &[&[-1.0, 0.6], &[-1.0, 0.6]]);
        for (record, coefficient) in records.iter().zip([0.5, 0.25]) {
            assert_abs_diff_eq!(
                record.state.tangential_force(0),
                -coefficient,
                epsilon = EXACT
            );
            assert_abs_diff_eq!(
                record.state.tangential_displacement(0),
                (0.6 - coefficient) / 2.0,
                epsilon = EXACT
            );
        }
    }
}

/// k_t Δs = F − μ(s) p with the path s before the step.
#[test]
fn committed_slip_path_weakens_from_step_to_step() {
    let law = SlipPower::new(0.5, 0.2, 0.1, 1.5, SlipPath::Committed).unwrap();
    let problem = problem(&[&[1.0, 0.0], &[0.0, 2.0]], Arc::new(law.clone()));
    for solver in every_solver() {
        let records = follow(
            &problem,
            &*solver,
            &[&[-1.0, 0.6], &[-1.0, 0.6], &[-1.0, -0.6]],
        );
        let first = (0.6 - 0.5) / 2.0;
        let second = (0.6 - law.coefficient(first).0) / 2.0;
        let third = f64::midpoint(-0.6, law.coefficient(second).0);
        for (record, displacement) in records.iter().zip([first, second, third]) {
            assert_abs_diff_eq!(
                record.state.tangential_displacement(0),
                displacement,
                epsilon = EXACT
            );
        }
        assert_abs_diff_eq!(
            records[2].state.history[0].slip_path(),
            2.0 * second - third,
            epsilon = EXACT
        );
    }
}

/// k_t Δs + μ(s + |Δs|) p = F: implicit in the slip. With p (μs − μd) m/s₀ = 0.9 < k_t = 2 the left side increases.
#[test]
fn current_slip_path_is_solved_implicitly() {
    let law = SlipPower::new(0.5, 0.2, 0.5, 1.5, SlipPath::Current).unwrap();
    let problem = problem(&[&[1.0, 0.0], &[0.0, 2.0]], Arc::new(law.clone()));
    let coefficient = |path: f64| law.coefficient(path).0;
    let first = root(|slip| 2.0 * slip + coefficient(slip) - 0.8, 0.0, 1.0);
    let second = root(
        |slip| 2.0 * (first + slip) + coefficient(first + slip) - 1.5,
        0.0,
        1.0,
    );
    let place = first + second;
    // Backwards from `place` to F = −1.5: the displacement is place − slip, the force +μ.
    let third = root(
        |slip| 2.0 * (slip - place) + coefficient(place + slip) - 1.5,
        0.0,
        3.0,
    );
    for solver in every_solver() {
        let records = follow(
            &problem,
            &*solver,
            &[&[-1.0, 0.8], &[-1.0, 1.5], &[-1.0, -1.5]],
        );
        let expected = [
            (first, -coefficient(first)),
            (place, -coefficient(place)),
            (place - third, coefficient(place + third)),
        ];
        for (record, (displacement, force)) in records.iter().zip(expected) {
            assert_abs_diff_eq!(
                record.state.tangential_displacement(0),
                displacement,
                epsilon = CONVERGED
            );
            assert_abs_diff_eq!(record.state.tangential_force(0), force, epsilon = CONVERGED);
        }
    }
}

/// Two coupled points, both slipping, each with its own implicit slip: the sum and the difference of the two rows by hand,
/// here by the symmetric load, for which both slip as one point of k_t = 1.
#[test]
fn current_slip_path_of_coupled_points() {
    let law = SlipPower::new(0.5, 0.2, 1.0, 1.0, SlipPath::Current).unwrap();
    let problem = problem(&COUPLED, Arc::new(law.clone()));
    let slip = root(|slip| slip + law.coefficient(slip).0 - 0.7, 0.0, 1.0);
    for solver in every_solver() {
        let records = follow(&problem, &*solver, &[&[-1.0, 0.7, -1.0, 0.7]]);
        for k in 0..2 {
            assert_abs_diff_eq!(
                records[0].state.tangential_displacement(k),
                slip,
                epsilon = CONVERGED
            );
        }
    }
}

/// p (μs − μd) m/s₀ = 6 > k_t = 2: beyond the static bound the force falls faster than the spring, and the point jumps to the
/// far branch, k_t Δs + μ(Δs) p = F with μ near μd.
#[test]
fn a_point_that_weakens_faster_than_its_spring_jumps() {
    let law = SlipPower::new(0.5, 0.2, 0.05, 1.0, SlipPath::Current).unwrap();
    let problem = problem(&[&[1.0, 0.0], &[0.0, 2.0]], Arc::new(law.clone()));
    let far = root(
        |slip| 2.0 * slip + law.coefficient(slip).0 - 0.51,
        0.05,
        1.0,
    );
    let stuck = follow(&problem, &Chain::default(), &[&[-1.0, 0.49], &[-1.0, 0.51]]);
    assert_eq!(stuck[0].state.status, [Status::Stick]);
    assert_abs_diff_eq!(
        stuck[1].state.tangential_displacement(0),
        far,
        epsilon = CONVERGED
    );
}

/// Opening and closing points under every law that is not linear: each accepted step meets the conditions of its law.
#[test]
fn nonlinear_laws_over_random_walks_of_load() {
    let laws: [Arc<dyn FrictionLaw>; 4] = [
        Arc::new(StaticDynamic::new(0.6, 0.3, Transition::Drop).unwrap()),
        Arc::new(SlipPower::new(0.6, 0.2, 0.2, 1.0, SlipPath::Current).unwrap()),
        Arc::new(PressurePower::new(0.4, 1.0, 0.7).unwrap()),
        Arc::new(PressurePower::new(0.4, 10.0, 0.3).unwrap()),
    ];
    let stiffness: [&[f64]; 6] = [
        &[4.0, -1.0, 0.5, 0.0, 0.3, 0.1],
        &[-1.0, 3.0, 0.2, -0.8, 0.0, 0.2],
        &[0.5, 0.2, 5.0, 1.0, -0.5, 0.0],
        &[0.0, -0.8, 1.0, 4.0, 0.2, -0.6],
        &[0.3, 0.0, -0.5, 0.2, 3.0, 0.7],
        &[0.1, 0.2, 0.0, -0.6, 0.7, 3.0],
    ];
    for law in laws {
        let problem = problem(&stiffness, law);
        for solver in every_solver() {
            let mut state = ContactState::unloaded(&problem);
            let mut touched = 0;
            for step in 0..60_u32 {
                // Incommensurate frequencies: the points open, close, stick and slip in ever new orders.
                let time = f64::from(step);
                let load: Vec<f64> = (0..6_u32)
                    .map(|i| {
                        (time * (0.37 + 0.11 * f64::from(i)) + f64::from(i)).sin()
                            - f64::from(1 - i % 2)
                    })
                    .collect();
                let name = solver.name();
                let solution = match solve(&*solver, &problem, &state, &load) {
                    Ok(solution) => solution,
                    // Newton alone may cycle; the chain may not.
                    Err(_) if name == "semismooth Newton" => break,
                    Err(failure) => panic!("step {step}: {failure}, {:?}", problem.law(0)),
                };
                let violation = Conditions::new(&problem, &state, &load).violation(&solution.trial);
                assert!(violation < 1e-9, "step {step} by {name}: {violation}");
                touched += solution
                    .trial
                    .status
                    .iter()
                    .filter(|status| status.touches())
                    .count();
                state = commit(&state, &solution.trial, &load);
            }
            assert!(
                solver.name() == "semismooth Newton" || (touched > 60 && touched < 170),
                "{touched}"
            );
        }
    }
}

/// A step from a state in which everything slipped: the vector forms of the state agree with the scalar ones.
#[test]
fn forces_and_motions_are_those_of_the_points() {
    let law = Arc::new(StaticDynamic::new(0.5, 0.5, Transition::Drop).unwrap());
    let problem = problem(&COUPLED, law);
    let records = follow(&problem, &Chain::default(), &[&[-1.0, 2.0, 1.0, 0.0]]);
    let state = &records[0].state;
    assert_eq!(state.status, [Status::SlipPositive, Status::Open]);
    // Point 1 is free: 3 u₁ = 2 u₀; point 0: 3 u₀ − 2 u₁ = 2 − 1/2, so u₀ = 0.9, u₁ = 0.6; it opens by 1.
    let expected = DVector::from_vec(vec![0.0, 0.9, 1.0, 0.6]);
    assert!((&state.motion - expected).amax() < EXACT);
    assert!((&state.forces - DVector::from_vec(vec![1.0, -0.5, 0.0, 0.0])).amax() < EXACT);
}
