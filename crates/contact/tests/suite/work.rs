//! Searches stop at stated work, and say so.

use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector};
use stickslip_contact::solver::{
    FailureCause, Residuals, Step, StepFailure, StepSolution, Unresolved, Work,
};
use stickslip_contact::{
    Chain, ContactError, ContactState, InterfaceProblem, InterfaceSolver, LoadHistory, Pivoting,
    Ramp, SemismoothNewton,
};
use stickslip_fem_core::GivenBody;

use crate::{Ground, coulomb, solve};

/// One point of a body that is pressed into the ground by a load of 1, held or floating.
fn pressed(floating: bool) -> InterfaceProblem {
    let compliance = DMatrix::identity(2, 2);
    let load = DVector::from_row_slice(&[-1.0, 0.0]);
    let body = if floating {
        let motions = DMatrix::identity(2, 2);
        GivenBody::floating(compliance, motions, vec![DVector::zeros(2)], vec![load])
    } else {
        GivenBody::held(compliance, vec![load])
    };
    Ground::along_x(vec![0.0], coulomb(0.3)).under(&body.unwrap())
}

#[test]
fn pivoting_names_the_work_that_it_was_given() {
    let problem = pressed(false);
    let start = ContactState::unloaded(&problem);
    assert!(solve(&Pivoting::default(), &problem, &start, &[1.0]).is_ok());
    let none = Pivoting {
        pivots_per_unknown: 0,
        ..Pivoting::default()
    };
    let failure = solve(&none, &problem, &start, &[1.0]).unwrap_err();
    let (_, cause) = &failure.attempts[0];
    assert!(
        matches!(cause, FailureCause::Effort { operations: 0, limit } if *limit == none.effort),
        "{failure}"
    );
    assert!(
        failure.to_string().contains("floating-point operations"),
        "{failure}"
    );
}

/// Of many points those that may touch are pivoted: the answer is Newton's, and a pivot costs a part of that of all.
#[test]
fn of_many_points_a_part_is_pivoted() {
    const COUNT: usize = 600;
    let x = |k: usize| k as f64 / COUNT as f64 - 0.5;
    let compliance = DMatrix::from_fn(2 * COUNT, 2 * COUNT, |i, j| {
        let near = (-20.0 * (x(i / 2) - x(j / 2)).abs()).exp();
        if i % 2 == j % 2 { near } else { 0.0 }
    });
    let pushed = DVector::from_fn(2 * COUNT, |i, _| {
        let [down, along] = [-1.0 + 30.0 * (x(i / 2) - 0.1).powi(2), 0.3];
        if i % 2 == 0 { down } else { along }
    });
    let held = GivenBody::held(compliance.clone(), vec![pushed.clone()]);
    let motions = DMatrix::from_fn(2 * COUNT, 2, |i, j| f64::from(u8::from(i % 2 == j)));
    let load = DVector::from_row_slice(&[-2.0, 0.4]);
    let floating = GivenBody::floating(compliance, motions, vec![pushed], vec![load]);
    for body in [held, floating].map(Result::unwrap) {
        let places = (0..COUNT).map(x).collect();
        let problem = Ground::along_x(places, coulomb(0.3)).under(&body);
        let start = ContactState::unloaded(&problem);
        let [pivoted, newton] = [
            solve(&Pivoting::default(), &problem, &start, &[1.0]),
            solve(&SemismoothNewton::default(), &problem, &start, &[1.0]),
        ]
        .map(Result::unwrap);
        let touching = pivoted.trial.status.iter().filter(|own| own.touches());
        assert!((100..400).contains(&touching.count()));
        assert_eq!(pivoted.trial.status, newton.trial.status);
        let off = (&pivoted.trial.forces - &newton.trial.forces).amax();
        assert!(off <= 1e-9 * newton.trial.forces.amax(), "{off:e}");
        let order = 3 * COUNT as u64;
        let whole = 2 * order * (order + 2) * pivoted.work.pivots as u64;
        let work = pivoted.work;
        // Statuses are found by pivoting: what confirms them has little to correct.
        assert!(work.solves <= 4 && work.operations < whole / 2, "{work:?}");
    }
}

/// Pivoting alone gets the proof that the chain makes, and is not begun.
#[test]
fn the_proof_comes_before_a_search_by_one_solver() {
    let problem = pressed(true);
    let start = ContactState::unloaded(&problem);
    let alone = Chain::alone(Box::new(Pivoting::default()));
    assert!(solve(&alone, &problem, &start, &[1.0]).is_ok());
    let failure = solve(&alone, &problem, &start, &[-1.0]).unwrap_err();
    assert!(failure.is_proved_impossible(), "{failure}");
    assert_eq!(failure.work, Work::default());
}

/// Fails at the cost of so many operations.
#[derive(Debug)]
struct Costly {
    operations: u64,
    calls: AtomicUsize,
}

impl InterfaceSolver for Costly {
    fn name(&self) -> &'static str {
        "costly"
    }

    fn solve(&self, _step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        self.calls.fetch_add(1, Ordering::Relaxed);
        let work = Work {
            operations: self.operations,
            ..Work::default()
        };
        Err(StepFailure::new(self.name(), FailureCause::Ray, work))
    }
}

#[test]
fn cut_back_ends_with_its_work_or_at_its_smallest_part() {
    let problem = pressed(false);
    for (operations, calls, named) in [
        (1, 11, None),
        (15_000_000_000, 3, Some([45_000_000_000, 30_000_000_000])),
        (9_000_000_000, 3, Some([27_000_000_000, 20_000_000_000])),
        (5_000_000_000, 5, Some([25_000_000_000, 20_000_000_000])),
    ] {
        let solver = Costly {
            operations,
            calls: AtomicUsize::new(0),
        };
        let history = LoadHistory::new(vec![vec![1.0]], 1, Ramp::Linear).unwrap();
        let failed = history.follow(&problem, &solver, |_| {}).unwrap_err();
        let ContactError::StepFailed { cause, .. } = failed else {
            panic!("{failed}");
        };
        assert_eq!(solver.calls.into_inner(), calls);
        let expected = named
            .map(|[operations, limit]| ("cut-back", FailureCause::Effort { operations, limit }));
        assert_eq!(cause.attempts.get(1), expected.as_ref(), "{cause}");
    }
}

/// Ends near a solution every time, at the cost of so many operations.
#[derive(Debug)]
struct Near {
    operations: u64,
}

impl InterfaceSolver for Near {
    fn name(&self) -> &'static str {
        "near"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        let solution = SemismoothNewton::default().solve(step)?;
        let work = Work {
            operations: self.operations,
            ..Work::default()
        };
        let failure = StepFailure::new(self.name(), FailureCause::Limit(1), work);
        Err(failure.with_best(Some(Box::new(Unresolved {
            solver: self.name(),
            trial: solution.trial,
            residuals: Residuals {
                cone: 1e-6,
                ..solution.residuals
            },
        }))))
    }
}

/// States that only come close may cost as much in a load step as refusals may, and where they end, the step has reached nothing.
#[test]
fn states_that_come_close_end_with_their_work() {
    let problem = pressed(false);
    let history = LoadHistory::new(vec![vec![1.0]], 16, Ramp::Linear).unwrap();
    let follow = |operations| history.follow(&problem, &Near { operations }, |_| {});
    let found = follow(1_000_000).unwrap();
    assert!(!found[0].verified && found[0].state.multipliers == [1.0]);
    let failed = follow(6_000_000_000).unwrap_err();
    assert!(
        matches!(failed, ContactError::StepFailed { reached: 0.0, .. }),
        "{failed}"
    );
}
