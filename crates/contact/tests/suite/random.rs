//! Random small problems against all their solutions.
//!
//! A supported body has a solution whatever μ (theory: the map from friction bounds to friction bounds has a bounded range),
//! and generically an odd number of them; a floating body may have none.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use stickslip_contact::solver::FailureCause;
use stickslip_contact::state::TrialState;
use stickslip_contact::{Chain, ContactState, InterfaceProblem, InterfaceSolver, Pivoting};

use crate::given_body::GivenBody;
use crate::oracle::{Conditions, Enumeration};
use crate::{Ground, commit, coulomb, positive_definite, solve};

/// Violation that the oracle allows a solution: the solvers accept 1e-10 of their own scales, which may be smaller or larger
/// than the oracle's by the committed forces and motions, at most some tens of the new ones here.
const TOLERANCE: f64 = 1e-8;

/// Numbers between −1 and 1 (SplitMix64; Steele, Lea & Flood 2014).
fn generator(mut seed: u64) -> impl FnMut() -> f64 {
    move || {
        seed = seed.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut bits = seed;
        bits = (bits ^ (bits >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        bits = (bits ^ (bits >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        bits ^= bits >> 31;
        (bits >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}

/// A body of `count` points on rigid ground with two load cases, and `modes` rigid motions.
fn problem(draw: &mut impl FnMut() -> f64, count: usize, modes: usize) -> InterfaceProblem {
    let size = 2 * count;
    let entries: Vec<f64> = (0..size * size).map(|_| draw()).collect();
    let compliance = positive_definite(size, &entries, 0.02 * draw().abs() + 1e-3);
    let responses = (0..2).map(|_| DVector::from_fn(size, |_, _| 2.0 * draw())).collect();
    let motions = DMatrix::from_fn(size, modes, |_, _| draw());
    let mode_loads = (0..2).map(|_| DVector::from_fn(modes, |_, _| draw())).collect();
    let body = GivenBody::floating(compliance, motions, responses, mode_loads);
    let normals = (0..count)
        .map(|_| {
            let angle = std::f64::consts::PI * draw();
            [angle.cos(), angle.sin()]
        })
        .collect();
    let gaps = (0..count).map(|_| if draw() > 0.5 { 0.0 } else { 0.5 * draw() + 0.25 }).collect();
    let chosen = draw();
    let mu = if chosen > 0.9 { 0.0 } else { 1.5 * (1.0 + draw()) };
    let law = coulomb(mu);
    Ground { normals, gaps, law }.under(&body)
}

/// A committed state to start from: after a random number of steps, each the first solution that there is.
fn committed(draw: &mut impl FnMut() -> f64, problem: &InterfaceProblem) -> ContactState {
    let mut state = ContactState::unloaded(problem);
    for _ in 0..((draw() + 1.0) * 1.5) as usize {
        let multipliers = [draw(), draw()];
        let all = Conditions::new(problem, &state, &multipliers).enumerate();
        if let Some(trial) = all.solutions.first() {
            state = commit(&state, trial, &multipliers);
        }
    }
    state
}

fn is_listed(trial: &TrialState, all: &Enumeration) -> bool {
    let scale = trial.forces.amax().max(1.0);
    all.solutions.iter().any(|known| (&known.forces - &trial.forces).amax() < 1e-6 * scale)
}

#[derive(Debug, Default)]
struct Tally {
    solved: usize,
    multiple: usize,
    even: usize,
    without_solution: usize,
    failures: Vec<String>,
}

impl Tally {
    fn try_supported(&mut self, seed: u64, solvers: &[&dyn InterfaceSolver]) {
        let mut draw = generator(seed);
        let count = 1 + ((draw() + 1.0) * 2.0) as usize % 4;
        let problem = problem(&mut draw, count, 0);
        let state = committed(&mut draw, &problem);
        let multipliers = [2.0 * draw(), 2.0 * draw()];
        let conditions = Conditions::new(&problem, &state, &multipliers);
        let all = conditions.enumerate();
        self.multiple += usize::from(all.solutions.len() > 1);
        self.even += usize::from(!all.borderline && all.solutions.len() % 2 == 0);
        for solver in solvers {
            match solve(*solver, &problem, &state, &multipliers) {
                Ok(solution) => {
                    let violation = conditions.violation(&solution.trial);
                    assert!(violation < TOLERANCE, "seed {seed}, {}: {violation}", solution.solver);
                    assert!(all.borderline || is_listed(&solution.trial, &all), "seed {seed}: {solution:?}");
                    self.solved += 1;
                }
                Err(failure) => self.failures.push(format!(
                    "seed {seed}, {count} points, {} of {}: {failure}",
                    solver.name(),
                    all.solutions.len()
                )),
            }
        }
    }

    fn try_floating(&mut self, seed: u64, modes: usize) {
        let mut draw = generator(seed);
        let count = modes + ((draw() + 1.0) * 2.0) as usize % (5 - modes);
        let problem = problem(&mut draw, count, modes);
        let state = committed(&mut draw, &problem);
        let multipliers = [draw(), draw()];
        let conditions = Conditions::new(&problem, &state, &multipliers);
        let all = conditions.enumerate();
        self.without_solution += usize::from(all.solutions.is_empty());
        match solve(&Chain::default(), &problem, &state, &multipliers) {
            Ok(solution) => {
                let violation = conditions.violation(&solution.trial);
                assert!(violation < TOLERANCE, "seed {seed}, {}: {violation}", solution.solver);
                assert!(
                    all.borderline || all.singular || is_listed(&solution.trial, &all),
                    "seed {seed}: {solution:?}"
                );
                self.solved += 1;
            }
            Err(failure) => {
                let proved = failure.attempts.iter().any(|(_, cause)| {
                    matches!(cause, FailureCause::Unbalanced { proved: true, .. })
                });
                assert_eq!(proved, failure.is_proved_impossible());
                assert!(!proved || all.solutions.is_empty(), "seed {seed}: {failure}");
                if !all.solutions.is_empty() {
                    self.failures.push(format!("seed {seed}, {count} points: {failure}"));
                }
            }
        }
    }
}

#[test]
fn every_supported_problem_is_solved() {
    let mut tally = Tally::default();
    let (chain, status_first, pivoting) = (Chain::default(), Chain::status_first(), Pivoting::default());
    for seed in 0..4000 {
        tally.try_supported(seed, &[&chain, &status_first, &pivoting]);
    }
    println!("{} {} {} {}", tally.solved, tally.multiple, tally.even, tally.failures.len());
    for f in tally.failures.iter().take(20) { println!("{f}"); }
    assert!(tally.failures.is_empty());
}

#[test]
fn floating_problems_are_solved_where_there_is_a_solution() {
    for modes in 1..=2 {
    let mut tally = Tally::default();
    for seed in 0..2000 {
        tally.try_floating(seed, modes);
    }
    println!("{} {} {} {}", tally.solved, tally.without_solution, tally.even, tally.failures.len());
    for f in tally.failures.iter().take(20) { println!("{f}"); }
    }
    assert!(false);
}
