//! The estimated friction coefficient up to which a step has one solution, against enumeration.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{
    Chain, ContactState, Enumeration, InterfaceProblem, InterfaceSolver, SemismoothNewton, Status,
    solver::Step, uniqueness_bound,
};

use crate::discrete::{cases, data, problem};
use crate::random::generator;
use crate::{Ground, coulomb};
use stickslip_fem_core::GivenBody;

/// One point with K = [[k_t, k_c], [k_c, k_n]]: k_t/|k_c| (Klarbring 1990).
#[test]
fn one_point_has_the_exact_bound() {
    let mut checked = 0;
    for case in cases(&data(), "static_increment_cases") {
        let entry = |i: usize, j: usize| {
            let text = case["K_N_per_mm"][i][j].as_str().unwrap();
            let (a, b) = text.split_once('/').unwrap_or((text, "1"));
            a.parse::<f64>().unwrap() / b.parse::<f64>().unwrap()
        };
        let problem = problem(&case);
        if problem.points().len() != 1 {
            continue;
        }
        let bound = uniqueness_bound(&problem, &[Status::Stick]).unwrap();
        let exact = entry(0, 0) / entry(0, 1).abs();
        assert!(
            (bound / exact - 1.0).abs() < 1e-11 || bound == exact,
            "{bound} {exact}"
        );
        assert_eq!(uniqueness_bound(&problem, &[Status::Open]), None);
        checked += 1;
    }
    assert!(checked > 5);
}

/// Three points of a flat body whose tangential motion drags every point into the ground on one side.
fn flat(mu: f64) -> InterfaceProblem {
    let stiffness = DMatrix::from_fn(6, 6, |i, j| match (i / 2 == j / 2, i % 2 == j % 2) {
        (true, true) => 4.0,
        (true, false) => -2.0,
        (false, true) => -0.5,
        (false, false) => 0.0,
    });
    let compliance = stiffness.try_inverse().unwrap();
    let responses = (0..6).map(|i| compliance.column(i).into_owned()).collect();
    Ground::along_x(vec![0.0; 3], coulomb(mu))
        .under(&GivenBody::held(compliance, responses).unwrap())
}

/// Largest number of solutions over random loads and pasts.
fn most_solutions(mu: f64) -> usize {
    let problem = flat(mu);
    let mut draw = generator(7);
    (0..400)
        .map(|_| {
            let mut state = ContactState::unloaded(&problem);
            state.motion = DVector::from_fn(6, |i, _| if i % 2 == 1 { draw() } else { 0.0 });
            let loads: Vec<f64> = (0..6).map(|_| 2.0 * draw()).collect();
            let step = Step::new(&problem, &state, &loads);
            Enumeration::default()
                .solve(&step)
                .unwrap()
                .solutions
                .unwrap()
        })
        .max()
        .unwrap()
}

/// Below the estimate with all points touching there is one solution throughout, well above it there are several.
#[test]
fn several_points_are_unique_below_the_estimate() {
    let bound = uniqueness_bound(&flat(0.3), &[Status::Stick; 3]).unwrap();
    assert!(bound > 0.1 && bound < 10.0, "{bound}");
    assert_eq!(most_solutions(0.95 * bound), 1);
    assert!(most_solutions(2.0 * bound) > 1);
}

/// Far below the estimate the chain does what its first member does, and nothing more; beyond it, it counts the solutions and
/// takes the nearest to the last state.
#[test]
fn the_chain_counts_solutions_where_there_may_be_several() {
    let bound = uniqueness_bound(&flat(0.3), &[Status::Stick; 3]).unwrap();
    let (mut several, mut changed) = (0, 0);
    for (mu, counted) in [(0.5 * bound, false), (2.0 * bound, true)] {
        let problem = flat(mu);
        let mut draw = generator(7);
        for _ in 0..200 {
            let mut state = ContactState::unloaded(&problem);
            state.motion = DVector::from_fn(6, |i, _| if i % 2 == 1 { draw() } else { 0.0 });
            let loads: Vec<f64> = (0..6).map(|_| 2.0 * draw()).collect();
            let step = Step::new(&problem, &state, &loads);
            let found = Chain::default().solve(&step).unwrap();
            let all = Enumeration::default().solve(&step).unwrap();
            if counted && found.trial.status.iter().all(|status| status.touches()) {
                assert_eq!(found.solutions, all.solutions);
            }
            if found.solutions.is_some() {
                assert!((&found.trial.forces - &all.trial.forces).amax() < 1e-10);
                several += usize::from(found.solutions > Some(1));
                changed += usize::from(found.solver == "enumeration");
            }
            if !counted && let Ok(first) = SemismoothNewton::default().solve(&step) {
                assert_eq!((found.solutions, found.work), (None, first.work));
                assert!(found.attempts.is_empty());
            }
        }
    }
    assert!(several > 10 && changed > 0, "{several}, {changed}");
}

/// A body that floats along its normal spreads the tangential coupling by its balance.
#[test]
fn floating_bodies_are_bounded_by_their_balance() {
    let compliance = DMatrix::from_row_slice(
        4,
        4,
        &[
            2.0, 0.5, 0.3, 0.1, 0.5, 2.0, 0.1, 0.3, 0.3, 0.1, 2.0, -0.5, 0.1, 0.3, -0.5, 2.0,
        ],
    );
    let modes = DMatrix::from_row_slice(4, 1, &[1.0, 0.0, 1.0, 0.0]);
    let body = GivenBody::floating(
        compliance,
        modes,
        vec![DVector::zeros(4)],
        vec![DVector::from_element(1, -1.0)],
    )
    .unwrap();
    let problem = Ground::along_x(vec![0.0; 2], coulomb(0.3)).under(&body);
    // λ_n = (x, −x) with 1.7·2x = −(0.4 t₀ + 0.6 t₁)... by hand: A_nn λ_n + A_nt λ_t + α = 0 in both rows; their difference is
    // 2 (2 − 0.3) x + (0.5 − 0.1) t₀ + (0.1 + 0.5) t₁ = 0.
    let rows = [0.4_f64 / 3.4, 0.6 / 3.4];
    let exact = 1.0 / (rows[0] + rows[1]);
    let bound = uniqueness_bound(&problem, &[Status::Stick; 2]).unwrap();
    assert!((bound - exact).abs() < 1e-9, "{bound} {exact}");
    // One point alone is pressed by its load, whatever the friction.
    let alone = uniqueness_bound(&problem, &[Status::Stick, Status::Open]).unwrap();
    assert_eq!(alone, f64::INFINITY);
}
