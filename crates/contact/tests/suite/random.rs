//! Random small problems against all their solutions.
//!
//! A supported body has a solution whatever μ (theory: the map from friction bounds to friction bounds has a bounded range),
//! and generically an odd number of them; a floating body may have none.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use stickslip_contact::solver::{FailureCause, StepFailure};
use stickslip_contact::state::TrialState;
use stickslip_contact::{Chain, ContactState, InterfaceProblem, InterfaceSolver, Pivoting};

use crate::oracle::{Conditions, Enumeration};
use crate::{Ground, commit, coulomb, positive_definite, solve};
use stickslip_fem_core::GivenBody;

/// Violation that the oracle allows a solution: the solvers accept 1e-10 of their own scales, which may be smaller or larger
/// than the oracle's by the committed forces and motions, at most some tens of the new ones here.
const TOLERANCE: f64 = 1e-8;

/// Numbers between −1 and 1 (SplitMix64; Steele, Lea & Flood 2014).
pub(crate) fn generator(mut seed: u64) -> impl FnMut() -> f64 {
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
    let responses = (0..2)
        .map(|_| DVector::from_fn(size, |_, _| 2.0 * draw()))
        .collect();
    let motions = DMatrix::from_fn(size, modes, |_, _| draw());
    let mode_loads = (0..2)
        .map(|_| DVector::from_fn(modes, |_, _| draw()))
        .collect();
    let body = GivenBody::floating(compliance, motions, responses, mode_loads).unwrap();
    let normals = (0..count)
        .map(|_| {
            let angle = std::f64::consts::PI * draw();
            [angle.cos(), angle.sin()]
        })
        .collect();
    let gaps = (0..count)
        .map(|_| {
            if draw() > 0.5 {
                0.0
            } else {
                0.5 * draw() + 0.25
            }
        })
        .collect();
    let chosen = draw();
    let mu = if chosen > 0.9 {
        0.0
    } else {
        1.5 * (1.0 + draw())
    };
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

/// One random step from a random past.
#[derive(Debug)]
pub(crate) struct RandomStep {
    pub(crate) problem: InterfaceProblem,
    pub(crate) committed: ContactState,
    pub(crate) multipliers: [f64; 2],
}

impl RandomStep {
    pub(crate) fn new(draw: &mut impl FnMut() -> f64, modes: usize) -> Self {
        let least = modes.max(1);
        let count = (least + (f64::midpoint(draw(), 1.0) * (5 - least) as f64) as usize).min(4);
        let problem = problem(draw, count, modes);
        let committed = committed(draw, &problem);
        let scale = if modes == 0 { 2.0 } else { 1.0 };
        let multipliers = [scale * draw(), scale * draw()];
        Self {
            problem,
            committed,
            multipliers,
        }
    }

    pub(crate) fn conditions(&self) -> Conditions<'_> {
        Conditions::new(&self.problem, &self.committed, &self.multipliers)
    }
}

fn is_listed(trial: &TrialState, all: &Enumeration) -> bool {
    let scale = trial.forces.amax().max(1.0);
    all.solutions
        .iter()
        .any(|known| (&known.forces - &trial.forces).amax() < 1e-6 * scale)
}

/// Solves the step and checks the answer against the conditions and the list of all solutions.
fn check(
    step: &RandomStep,
    solver: &dyn InterfaceSolver,
    all: &Enumeration,
) -> Result<&'static str, StepFailure> {
    let solution = solve(solver, &step.problem, &step.committed, &step.multipliers)?;
    let violation = step.conditions().violation(&solution.trial);
    assert!(
        violation < TOLERANCE,
        "{}: {violation} {step:?}",
        solution.solver
    );
    let complete = !all.borderline && !all.singular;
    assert!(
        !complete || is_listed(&solution.trial, all),
        "{solution:?} {step:?}"
    );
    let tried = |name: &str| solution.attempts.iter().any(|(solver, _)| *solver == name);
    assert!(
        step.problem.modes().ncols() > 0 || !tried("pivoting"),
        "pivoting solves supported bodies: {:?}",
        solution.attempts
    );
    Ok(solution.solver)
}

/// Checks that a failure claims no more than is true.
fn check_failure(failure: &StepFailure, all: &Enumeration) {
    for (_, cause) in &failure.attempts {
        if let FailureCause::Unbalanced { proved: true, .. }
        | FailureCause::NoSolution { proved: true, .. } = cause
        {
            assert!(all.solutions.is_empty(), "{failure}");
        }
    }
}

#[test]
fn every_supported_step_is_solved_and_has_an_odd_number_of_solutions() {
    let solvers: [&dyn InterfaceSolver; 3] = [
        &Chain::default(),
        &Chain::status_first(),
        &Pivoting::default(),
    ];
    let (mut several, mut by_pivoting) = (0, 0);
    for seed in 0..3000 {
        let step = RandomStep::new(&mut generator(seed), 0);
        let all = step.conditions().enumerate();
        assert!(
            all.borderline || all.solutions.len() % 2 == 1,
            "seed {seed}: {}",
            all.solutions.len()
        );
        several += usize::from(all.solutions.len() > 1);
        for solver in solvers {
            let found = check(&step, solver, &all)
                .unwrap_or_else(|failure| panic!("seed {seed}: {failure}"));
            by_pivoting += usize::from(solver.name() == "chain" && found == "pivoting");
        }
    }
    // The loop reaches what it is for: several solutions, and steps on which the faster solvers fail.
    assert!(several > 30 && by_pivoting > 30, "{several}, {by_pivoting}");
}

#[test]
fn floating_steps_are_solved_exactly_where_there_is_a_solution() {
    for modes in 1..=3 {
        let (mut solved, mut unsolvable) = (0, 0);
        for seed in 0..1000 {
            let step = RandomStep::new(&mut generator(seed), modes);
            let all = step.conditions().enumerate();
            match check(&step, &Chain::default(), &all) {
                Ok(_) => solved += 1,
                Err(failure) => {
                    check_failure(&failure, &all);
                    assert!(all.solutions.is_empty(), "seed {seed}: {failure}");
                    unsolvable += 1;
                }
            }
        }
        assert!(
            solved > 100 && unsolvable > 100,
            "{modes} motions: {solved}, {unsolvable}"
        );
    }
}

/// Far beyond enumeration, where only the theory says that there is a solution.
fn follow_larger(seed: u64, solver: &dyn InterfaceSolver) {
    let mut draw = generator(seed);
    let count = 5 + (seed as usize % 6) * 5;
    let problem = problem(&mut draw, count, 0);
    let mut state = ContactState::unloaded(&problem);
    for _ in 0..3 {
        let multipliers = [draw(), draw()];
        let found = solve(solver, &problem, &state, &multipliers);
        let solution =
            found.unwrap_or_else(|failure| panic!("seed {seed}, {count} points: {failure}"));
        let violation = Conditions::new(&problem, &state, &multipliers).violation(&solution.trial);
        assert!(
            violation < TOLERANCE,
            "seed {seed}, {count} points: {violation}"
        );
        state = commit(&state, &solution.trial, &multipliers);
    }
}

#[test]
fn larger_supported_steps_are_solved_by_pivoting_alone() {
    for seed in 0..60 {
        follow_larger(seed, &Pivoting::default());
    }
}

#[test]
fn larger_supported_steps_are_solved_by_the_chain() {
    for seed in 0..120 {
        follow_larger(seed, &Chain::default());
    }
}

/// Points that repeat one another leave ties in every ratio test of pivoting, and z₀ ends at zero by rounding.
#[test]
fn repeated_points_are_solved_by_pivoting() {
    let tied: [&[f64]; 2] = [
        &[1.0, 0.0, 1.0, -0.5, 0.5, -1.0, 0.0, 0.5],
        &[0.678, -0.182, 0.258, -0.2, -0.2, 0.837, 0.988, -0.086],
    ];
    for numbers in tied {
        let mut numbers = numbers.iter().copied().cycle();
        let step = RandomStep::new(&mut || numbers.next().unwrap(), 0);
        check(&step, &Pivoting::default(), &step.conditions().enumerate()).unwrap();
    }
}

proptest! {
    /// Shrinking sets numbers to zero, so that these also meet coinciding gaps, no load, and ties everywhere.
    #[test]
    fn supported_steps(numbers in prop::collection::vec(-1.0..1.0_f64, 1..160)) {
        let mut numbers = numbers.into_iter().cycle();
        let step = RandomStep::new(&mut || numbers.next().unwrap(), 0);
        let all = step.conditions().enumerate();
        check(&step, &Chain::default(), &all).unwrap();
        check(&step, &Pivoting::default(), &all).unwrap();
    }

    #[test]
    fn floating_steps(numbers in prop::collection::vec(-1.0..1.0_f64, 1..160), modes in 1..=2_usize) {
        let mut numbers = numbers.into_iter().cycle();
        let step = RandomStep::new(&mut || numbers.next().unwrap(), modes);
        let all = step.conditions().enumerate();
        if let Err(failure) = check(&step, &Chain::default(), &all) {
            check_failure(&failure, &all);
            prop_assert!(all.borderline || all.singular || all.solutions.is_empty(), "{failure}");
        }
    }

    /// Numbers on a coarse grid: exact ties, zero gaps, zero loads and bounds that are just reached are common.
    #[test]
    fn degenerate_steps(numbers in prop::collection::vec((-2..=2_i8).prop_map(|k| f64::from(k) / 2.0), 1..160)) {
        let mut numbers = numbers.into_iter().cycle();
        let step = RandomStep::new(&mut || numbers.next().unwrap(), 0);
        let all = step.conditions().enumerate();
        check(&step, &Chain::default(), &all).unwrap();
        check(&step, &Pivoting::default(), &all).unwrap();
    }
}

/// A tie between a slip that begins and one that does not, on which pivoting went round.
#[test]
fn a_tie_of_statuses_is_solved() {
    let numbers = [
        0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.5, 0.0, 0.5, 1.0, -0.5,
        -0.5, 0.5, 0.0, -1.0, -1.0, -1.0, 0.5, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0,
        0.0, 0.0, 0.0, 0.0, 0.0, -1.0, -1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0,
        0.0, 0.0, 0.0, 0.0, -0.5, 0.0, 0.0, 0.0, 1.0, 1.0, 0.0, 0.0, 0.0, 0.0, -1.0, 0.0, -1.0,
        -1.0,
    ];
    let mut numbers = numbers.into_iter().cycle();
    let step = RandomStep::new(&mut || numbers.next().unwrap(), 0);
    let all = step.conditions().enumerate();
    check(&step, &Chain::default(), &all).unwrap();
    check(&step, &Pivoting::default(), &all).unwrap();
}

/// Of 300 points a part is pivoted first. That of these seeds ends on a ray with the first covering vector, where all points have a solution.
#[test]
fn a_ray_of_a_part_is_not_the_end() {
    let pivoting = Pivoting {
        covers: 1,
        ..Pivoting::default()
    };
    for seed in [8, 17, 23, 24] {
        let mut draw = generator(seed);
        let problem = problem(&mut draw, 300, 2);
        let start = ContactState::unloaded(&problem);
        let found = solve(&pivoting, &problem, &start, &[draw(), draw()]);
        assert!(found.is_ok(), "{seed}: {}", found.unwrap_err());
    }
}
