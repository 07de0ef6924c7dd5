//! All solvers of one step against each other, and against solutions that are known.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use serde_json::Value;
use stickslip_contact::solver::{
    Acceleration, FailureCause, Residuals, Step, StepFailure, StepSolution, Stop,
};
use stickslip_contact::{
    AugmentedLagrangian, Chain, ContactError, ContactState, Continuation, Enumeration, GaussSeidel,
    InterfaceProblem, InterfaceSolver, LoadHistory, Penalty, Pivoting, PrincipalPivoting, Ramp,
    SemismoothNewton, Status, StatusIteration, TrescaFixedPoint,
};

use crate::contract::Lazy;
use crate::discrete::{cases, check_increment, committed, data, load, starts};
use crate::random::{RandomStep, generator};
use crate::scene::Scene;
use crate::{Ground, coulomb, discrete, solve};
use stickslip_fem_core::GivenBody;

/// Largest residual of a verified solution.
const VERIFIED: f64 = 1e-10;
/// The oracle's scales may be smaller than the solvers' by the committed forces and motions, at most some tens of the new ones.
const ORACLE: f64 = 1e-8;

/// Solvers whose answers are exact to 1e-10 of the largest force.
fn exact_solvers() -> Vec<Box<dyn InterfaceSolver>> {
    vec![
        Box::new(StatusIteration::default()),
        Box::new(SemismoothNewton::default()),
        Box::new(TrescaFixedPoint::default()),
        Box::new(Pivoting::default()),
        Box::new(PrincipalPivoting::default()),
        Box::new(GaussSeidel::plain()),
        Box::new(GaussSeidel::default()),
        Box::new(AugmentedLagrangian::default()),
        Box::new(Continuation::default()),
        Box::new(Enumeration::default()),
        Box::new(Chain::default()),
    ]
}

/// What every failure of a single solver must say.
fn check_failure(failure: &StepFailure, solver: &dyn InterfaceSolver) {
    assert!(!failure.attempts.is_empty(), "{}", solver.name());
    if let Some(best) = &failure.best {
        assert!(
            best.residuals.largest() > VERIFIED,
            "{}: {failure}",
            solver.name()
        );
        assert!(failure.to_string().contains("the best state violates"));
    }
    let limited = matches!(failure.attempts[0].1, FailureCause::Limit(_));
    assert!(!limited || failure.best.is_some(), "{}", solver.name());
}

/// Whether `solution` is what it says to be.
fn check_claim(step: &Step<'_>, solution: &StepSolution) {
    assert_eq!(Residuals::of(step, &solution.trial), solution.residuals);
    let residual = solution.residuals.largest();
    match solution.stop {
        Stop::Verified => assert!(residual <= VERIFIED, "{}: {residual}", solution.solver),
        Stop::Tolerance => panic!("{}: no looser tolerance was given", solution.solver),
        Stop::Regularised => assert_eq!(solution.solver, "penalty"),
    }
    // A separated contact leaves no equations.
    let forceless = solution.trial.forces.amax() == 0.0;
    assert!(solution.work.operations > 0 || forceless || solution.solver == "no change");
}

fn coefficient(case: &Value) -> f64 {
    let text = case["mu"].as_str().unwrap();
    let (a, b) = text.split_once('/').unwrap_or((text, "1"));
    a.parse::<f64>().unwrap() / b.parse::<f64>().unwrap()
}

/// Every one of the exact problems from every start: solved as listed, or refused with a reason. Iterative answers carry
/// 1e-10 of the scale, which for these numbers of one or two digits is far from any other solution.
#[test]
fn exact_problems_are_solved_or_refused_with_a_reason() {
    for case in cases(&data(), "static_increment_cases") {
        let problem = discrete::problem(&case);
        let unique = case["number_of_solutions"] == 1 && coefficient(&case) <= 0.5;
        for start in starts(problem.points().len()) {
            let state = committed(&case, &problem, start);
            let step = Step::new(&problem, &state, &load(&case));
            for solver in exact_solvers() {
                match solver.solve(&step) {
                    Ok(solution) => {
                        check_claim(&step, &solution);
                        if solution.residuals.largest() < 1e-13 {
                            check_increment(&case, &problem, &state, &solution);
                        }
                    }
                    Err(failure) => {
                        check_failure(&failure, &*solver);
                        let may = solver.name() == "status iteration" || !unique;
                        assert!(may, "{}: {}: {failure}", case["name"], solver.name());
                    }
                }
            }
        }
    }
}

#[test]
fn enumeration_counts_the_solutions_and_takes_the_nearest() {
    for case in cases(&data(), "static_increment_cases") {
        let problem = discrete::problem(&case);
        let listed = case["number_of_solutions"].as_u64().unwrap() as usize;
        // At the critical coefficient there is a continuum, of which only the ends are listed.
        if case["name"].as_str().unwrap().starts_with("B2") {
            continue;
        }
        for solution in case["solutions"].as_array().unwrap() {
            let letters = solution["status"][0].as_str().unwrap();
            let start = discrete::statuses(letters);
            let state = committed(&case, &problem, start.clone());
            let found = solve(&Enumeration::default(), &problem, &state, &load(&case)).unwrap();
            assert_eq!(found.solutions, Some(listed), "{}", case["name"]);
            assert_eq!(found.trial.status, start, "{}", case["name"]);
        }
    }
}

proptest! {
    /// Below the bound of uniqueness all solvers agree. Iterations by sweeps or bounds stop at 1e-10 of the largest force,
    /// which condition numbers below 2 hardly enlarge.
    #[test]
    fn all_solvers_agree_at_small_friction(scene in Scene::any()) {
        let problem = scene.problem();
        let mut state = ContactState::unloaded(&problem);
        for multipliers in &scene.steps {
            let step = Step::new(&problem, &state, multipliers);
            let reference = Chain::default().solve(&step).unwrap();
            let scale = reference.trial.forces.amax().max(1.0);
            for solver in exact_solvers() {
                match solver.solve(&step) {
                    Ok(solution) => {
                        check_claim(&step, &solution);
                        let difference = (&solution.trial.forces - &reference.trial.forces).amax();
                        prop_assert!(difference <= 1e-8 * scale, "{}: {difference}", solver.name());
                    }
                    Err(failure) => {
                        check_failure(&failure, &*solver);
                        prop_assert_eq!(solver.name(), "status iteration", "{}", failure);
                    }
                }
            }
            state = crate::commit(&state, &reference.trial, multipliers);
        }
    }
}

/// Friction up to 3, several solutions, floating bodies, loads without balance: no solver gives a wrong answer, and some say
/// that they have none.
#[test]
fn no_solver_claims_what_is_not_so() {
    let mut refused = std::collections::BTreeMap::new();
    for modes in 0..=2 {
        for seed in 0..250 {
            let random = RandomStep::new(&mut generator(seed), modes);
            let all = random.conditions().enumerate();
            let step = Step::new(&random.problem, &random.committed, &random.multipliers);
            for solver in exact_solvers() {
                match solver.solve(&step) {
                    Ok(solution) => {
                        check_claim(&step, &solution);
                        let violation = random.conditions().violation(&solution.trial);
                        assert!(
                            violation < ORACLE,
                            "{} seed {seed}: {violation}",
                            solver.name()
                        );
                    }
                    Err(failure) => {
                        check_failure(&failure, &*solver);
                        *refused.entry(solver.name()).or_insert(0) +=
                            usize::from(!all.solutions.is_empty());
                    }
                }
            }
        }
    }
    for stalls in [
        "Tresca fixed point",
        "Gauss-Seidel",
        "principal pivoting",
        "status iteration",
    ] {
        assert!(refused[stalls] > 0, "{refused:?}");
    }
    assert_eq!(refused["chain"], 0, "{refused:?}");
    assert_eq!(refused["enumeration"], 0, "{refused:?}");
}

/// A block of `count` points on an elastic half plane: Boussinesq's and Flamant's kernels regularised at the distance of
/// the points, with the coupling of ν = 0 where tangential forces lift their surroundings to one side.
fn punch(count: usize, mu: f64) -> InterfaceProblem {
    let compliance = DMatrix::from_fn(2 * count, 2 * count, |i, j| {
        let distance = (i / 2) as f64 - (j / 2) as f64;
        let width = (count as f64).ln() + 2.0;
        match (i % 2, j % 2) {
            (0, 0) | (1, 1) => width - (distance * distance + 0.1).sqrt().ln(),
            (0, 1) => -0.45 * distance.signum() * f64::from(u8::from(distance != 0.0)),
            _ => 0.45 * distance.signum() * f64::from(u8::from(distance != 0.0)),
        }
    });
    let all = |n: f64, t: f64| DVector::from_fn(2 * count, |i, _| if i % 2 == 0 { n } else { t });
    let body = GivenBody::held(compliance, vec![all(-1.0, 0.0), all(0.0, 1.0)]).unwrap();
    Ground::along_x(vec![0.0; count], coulomb(mu)).under(&body)
}

fn pressed_and_pushed() -> [f64; 2] {
    [1.0, 0.15]
}

#[test]
fn larger_contacts_are_solved_by_all_and_acceleration_saves_sweeps() {
    let problem = punch(40, 0.3);
    let state = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &state, &pressed_and_pushed());
    let reference = SemismoothNewton::default().solve(&step).unwrap();
    let scale = reference.trial.forces.amax();
    let mut sweeps = Vec::new();
    for solver in exact_solvers() {
        let name = solver.name();
        if ["enumeration", "status iteration"].contains(&name) {
            continue;
        }
        let solution = solver
            .solve(&step)
            .unwrap_or_else(|failure| panic!("{name}: {failure}"));
        check_claim(&step, &solution);
        let difference = (&solution.trial.forces - &reference.trial.forces).amax();
        assert!(difference < 1e-7 * scale, "{name}: {difference}");
        if solution.work.sweeps > 0 {
            sweeps.push(solution.work.sweeps);
        }
    }
    let [plain, accelerated] = sweeps[..] else {
        panic!("{sweeps:?}")
    };
    assert!(3 * accelerated < 2 * plain, "{plain} {accelerated}");
}

/// Springs of stiffness k change the answer by 1/k to first order, and the residuals say so.
#[test]
fn penalty_errs_with_the_inverse_of_the_stiffness() {
    let problem = punch(12, 0.3);
    let state = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &state, &pressed_and_pushed());
    let exact = Chain::default().solve(&step).unwrap().trial.forces;
    let errors: Vec<[f64; 2]> = [1e3, 1e4, 1e5, 1e6]
        .into_iter()
        .map(|factor| {
            let solution = Penalty { factor }.solve(&step).unwrap();
            check_claim(&step, &solution);
            assert_eq!(solution.stop, Stop::Regularised);
            let error = (&solution.trial.forces - &exact).amax() / exact.amax();
            [error, solution.residuals.largest()]
        })
        .collect();
    for pair in errors.windows(2) {
        for k in 0..2 {
            let order = (pair[0][k] / pair[1][k]).log10();
            assert!((order - 1.0).abs() < 0.1, "{errors:?}");
        }
    }
}

#[test]
fn augmented_lagrangian_does_not_depend_on_its_springs() {
    let problem = punch(12, 0.3);
    let state = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &state, &pressed_and_pushed());
    let exact = Chain::default().solve(&step).unwrap().trial.forces;
    let mut updates = Vec::new();
    for factor in [10.0, 1e2, 1e3, 1e5] {
        let solver = AugmentedLagrangian {
            factor,
            limit: 1000,
            ..AugmentedLagrangian::default()
        };
        let solution = solver.solve(&step).unwrap();
        check_claim(&step, &solution);
        assert!((&solution.trial.forces - &exact).amax() < 1e-8 * exact.amax());
        updates.push(solution.work.updates);
    }
    assert!(updates.is_sorted_by(|a, b| a > b), "{updates:?}");
}

#[test]
fn looser_tolerances_are_named_as_such() {
    let problem = punch(12, 0.3);
    let state = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &state, &pressed_and_pushed());
    let tolerance = 1e-4;
    let solvers: [Box<dyn InterfaceSolver>; 3] = [
        Box::new(TrescaFixedPoint {
            limit: 100,
            tolerance,
        }),
        Box::new(GaussSeidel {
            acceleration: Acceleration::None,
            limit: 10_000,
            tolerance,
        }),
        Box::new(AugmentedLagrangian {
            factor: 100.0,
            tolerance,
            limit: 100,
        }),
    ];
    for solver in solvers {
        let solution = solver.solve(&step).unwrap();
        let residual = solution.residuals.largest();
        assert!(residual > VERIFIED && residual <= tolerance);
        assert_eq!(solution.stop, Stop::Tolerance, "{}", solver.name());
    }
}

/// A step that changes nothing is its last state, at no cost; so is one after all load is gone.
#[test]
fn nothing_changes_without_a_change_of_load() {
    let problem = punch(12, 0.3);
    let steps = vec![vec![1.0, 0.2], vec![1.0, 0.2], vec![0.0; 2], vec![0.0; 2]];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let records = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
    for pair in [1, 3] {
        let (before, after) = (&records[pair - 1].state, &records[pair].state);
        assert_eq!(before.forces, after.forces);
        assert_eq!(records[pair].work.solves, 0);
        assert_eq!(records[pair].solvers, ["no change"]);
        assert_eq!(records[pair].dissipation(), 0.0);
    }
    assert!(
        records[1]
            .state
            .status
            .iter()
            .all(|&status| status == Status::Stick)
    );
    assert_eq!(records[3].state.forces.amax(), 0.0);
}

/// Forces of a body that floats fade when its load is gone; whatever converges by relative measures must see that.
#[test]
fn a_floating_body_is_let_go_by_all() {
    let compliance = DMatrix::from_fn(6, 6, |i, j| match (i == j, i % 2 == j % 2) {
        (true, _) => 2.0,
        (_, true) => 0.5,
        (_, false) => 0.1,
    });
    let modes = DMatrix::from_fn(6, 1, |i, _| if i % 2 == 0 { 1.0 } else { 0.0 });
    let press = DVector::from_element(1, -1.0);
    let body =
        GivenBody::floating(compliance, modes, vec![DVector::zeros(6)], vec![press]).unwrap();
    for mu in [0.0, 0.3, 1.0] {
        let problem = Ground::along_x(vec![0.0, 0.1, 0.0], coulomb(mu)).under(&body);
        let start = ContactState::unloaded(&problem);
        let pressed = solve(&Chain::default(), &problem, &start, &[1.0]).unwrap();
        let state = crate::commit(&start, &pressed.trial, &[1.0]);
        for solver in exact_solvers() {
            let let_go = solve(solver.as_ref(), &problem, &state, &[0.0])
                .unwrap_or_else(|failure| panic!("{}, μ = {mu}: {failure}", solver.name()));
            assert!(let_go.trial.forces.amax() < 1e-9, "{}", solver.name());
        }
        // Where no member of a chain sees it, the chain does, before it tries the next one.
        let blind = Chain::new(vec![Box::new(Lazy), Box::new(Lazy)]);
        let let_go = solve(&blind, &problem, &state, &[0.0]).unwrap();
        assert_eq!(
            (let_go.solver, let_go.trial.forces.amax()),
            ("release", 0.0)
        );
        assert_eq!(let_go.attempts.len(), 1);
    }
}

/// One point that nothing solves: the reason of every solver, the name, and the size of what is left.
#[test]
fn what_is_not_solved_is_called_unresolved() {
    let problem = punch(3, 0.3);
    let hasty = Chain::new(vec![Box::new(TrescaFixedPoint {
        limit: 1,
        tolerance: 1e-10,
    })]);
    let history = LoadHistory::new(vec![vec![1.0, 0.2]], 1, Ramp::Linear).unwrap();
    let error = history.follow(&problem, &hasty, |_| {}).unwrap_err();
    let message = error.to_string();
    for part in [
        "unresolved",
        "Tresca fixed point",
        "not converged after 1",
        "the best state",
    ] {
        assert!(message.contains(part), "{message}");
    }
    let ContactError::StepFailed { cause, .. } = error else {
        panic!("{error}")
    };
    assert!(cause.is_unresolved() && cause.best.is_some());
}
