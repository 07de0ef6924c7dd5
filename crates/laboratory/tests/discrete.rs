//! Problems whose answers are known, by every way of knowing them.

use stickslip_contact::state::TrialState;
use stickslip_contact::{Chain, InterfaceSolver, Status};
use stickslip_laboratory::discrete::{
    self, Discrete, Known, enumerate, flat_punch, one_node, one_node_bound, published, random,
    wedged,
};

/// Numbers of one or two digits, and matrices with condition numbers below 100.
const ROUNDING: f64 = 1e-12;

fn among(trial: &TrialState, states: &[TrialState]) -> bool {
    states.iter().any(|state| {
        (&state.forces - &trial.forces).amax() < ROUNDING
            && (&state.motion - &trial.motion).amax() < ROUNDING
    })
}

/// Both lists hold the same states.
fn agree(discrete: &Discrete, known: &Known) {
    let all = enumerate(discrete);
    assert_eq!(all.states.len(), known.states.len(), "{}", discrete.name);
    assert!(
        known.states.iter().all(|state| among(state, &all.states)),
        "{}",
        discrete.name
    );
}

#[test]
fn published_solutions_meet_the_conditions_and_are_found_by_enumeration() {
    let all = published().unwrap();
    assert_eq!(all.len(), 11 + 3 + 18);
    for case in &all {
        let known = case.discrete.solutions.as_ref().unwrap();
        for (state, statuses) in known.states.iter().zip(&case.statuses) {
            assert!(
                case.discrete.check(state) < ROUNDING,
                "{}",
                case.discrete.name
            );
            assert!(statuses.contains(&state.status));
        }
        agree(&case.discrete, known);
        assert!(!case.discrete.coercive || !known.states.is_empty());
    }
}

#[test]
fn one_node_has_its_closed_solutions() {
    let stiffness = [[1.0, -1.0], [-1.0, 2.0]];
    assert_eq!(one_node_bound(stiffness), 1.0);
    let mut several = 0;
    for mu in [0.0, 0.3, 0.9, 1.1, 1.7, 3.0] {
        for push in [-2.0, -0.4, 0.3, 1.25] {
            for press in [-1.0, 0.0, 0.7] {
                for (gap, previous) in [(0.0, 0.0), (0.2, -0.5), (0.0, 0.7)] {
                    let discrete = one_node(mu, stiffness, [push, press], gap, previous).unwrap();
                    let known = discrete.solutions.clone().unwrap();
                    assert!(known.complete);
                    agree(&discrete, &known);
                    assert!(mu > 1.0 || known.states.len() == 1);
                    several += usize::from(known.states.len() > 1);
                }
            }
        }
    }
    assert!(several > 3);
    let critical = one_node(1.0, stiffness, [1.0, -1.0], 0.0, 0.0).unwrap();
    assert!(one_node(-1.0, stiffness, [1.0, -1.0], 0.0, 0.0).is_err());
    let singular = one_node(1.0, [[1.0; 2]; 2], [1.0, -1.0], 0.0, 0.0);
    assert!(singular.unwrap_err().to_string().contains("singular"));
    assert!(!critical.solutions.unwrap().complete);
}

#[test]
fn a_node_without_load_stays_wedged_beyond_its_bound() {
    for mu in [0.0, 0.5, 1.4, 1.6, 2.5] {
        let discrete = wedged(mu).unwrap();
        let known = discrete.solutions.as_ref().unwrap();
        agree(&discrete, known);
        let held = known
            .states
            .iter()
            .any(|state| state.status == [Status::Stick]);
        assert_eq!(held, mu > 1.5, "{mu}");
        assert!(discrete.check(&known.states[0]) < ROUNDING);
    }
}

#[test]
fn a_wrong_answer_is_noticed() {
    let discrete = wedged(2.0).unwrap();
    let right = discrete.solutions.as_ref().unwrap().states[0].clone();
    let mut wrong = right.clone();
    wrong.forces[0] += 1e-3;
    assert!(discrete.check(&wrong) > 1e-4);
    let mut wrong = right.clone();
    wrong.status = vec![Status::SlipNegative];
    assert!(discrete.check(&wrong) > 1e-4);
    let mut wrong = right;
    wrong.forces[1] = f64::NAN;
    assert_eq!(discrete.check(&wrong), f64::INFINITY);
}

#[test]
fn the_punch_is_symmetric_and_sticks_or_slips_as_a_whole() {
    let solve = |mu: f64, multipliers: Vec<f64>| {
        let mut punch = flat_punch(9, mu).unwrap();
        punch.multipliers = multipliers;
        let solution = Chain::default().solve(&punch.step()).unwrap();
        assert!(punch.check(&solution.trial) < 1e-9);
        solution.trial
    };
    let pressed = solve(0.4, vec![1.0, 0.0]);
    for k in 0..9 {
        let (a, b) = (2 * k, 2 * (8 - k));
        let scale = pressed.forces.amax();
        assert!((pressed.forces[a] - pressed.forces[b]).abs() < 1e-12 * scale);
        assert!((pressed.forces[a + 1] + pressed.forces[b + 1]).abs() < 1e-12 * scale);
    }
    let slipping = |status: &Status| status.slip_sign() != 0.0;
    // The block spreads as it is pressed, so it takes a push beyond that to make both ends slip the same way.
    let pushed = solve(0.1, vec![1.0, 2.0]).status;
    assert!(slipping(&pushed[0]) && pushed.iter().all(|status| *status == pushed[0]));
    assert!(!solve(1.0, vec![1.0, 0.5]).status.iter().all(slipping));
    assert!(flat_punch(1, 0.3).is_err());
    assert!(flat_punch(5, -0.3).is_err());
}

#[test]
fn random_problems_are_deterministic_and_supported_ones_have_an_odd_number_of_solutions() {
    let (mut unsolvable, mut several) = (0, 0);
    for seed in 0..300 {
        let floating = (seed % 3) as usize;
        let discrete = random(seed, floating).unwrap();
        let again = random(seed, floating).unwrap();
        assert_eq!(discrete.multipliers, again.multipliers);
        assert_eq!(discrete.committed, again.committed);
        assert_eq!(discrete.problem.compliance(), again.problem.compliance());
        assert!(discrete.problem.points().len() <= 3);
        assert_eq!(discrete.problem.modes().ncols(), floating);
        let all = enumerate(&discrete);
        for state in &all.states {
            assert!(discrete.check(state) < 1e-9);
        }
        if floating == 0 && !all.borderline && !all.singular {
            assert_eq!(all.states.len() % 2, 1, "{seed}");
        }
        unsolvable += usize::from(all.states.is_empty());
        several += usize::from(all.states.len() > 1);
    }
    assert!(unsolvable > 10 && several > 10, "{unsolvable} {several}");
    assert!(random(0, 3).is_err());
}

#[test]
fn the_next_step_starts_where_the_last_one_ended() {
    let discrete = random(4, 0).unwrap();
    let first = enumerate(&discrete).states[0].clone();
    let next = discrete.next(&first, vec![0.5, -0.5]);
    assert_eq!(next.committed.forces, first.forces);
    assert_eq!(next.committed.multipliers, discrete.multipliers);
    assert_eq!(
        next.committed,
        discrete::commit(&discrete.committed, &first, &discrete.multipliers)
    );
}
