//! Load histories: where the path matters and where it does not, cut-back, and the work that friction takes.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use stickslip_contact::solver::{Step, StepFailure, StepSolution, Work};
use stickslip_contact::zones::carries_friction;
use stickslip_contact::{
    Chain, ContactError, ContactState, InterfaceSolver, LoadHistory, Ramp, Status,
};
use stickslip_friction::{FrictionLaw, SlipPath, SlipPower, StaticDynamic, Transition};

use crate::scene::{ROUNDING, Scene, assert_close, follow};
use crate::{Ground, coulomb, solve};
use stickslip_fem_core::GivenBody;

proptest! {
    #[test]
    fn without_friction_the_path_does_not_matter(scene in Scene::any()) {
        let scene = Scene { mu: 0.0, ..scene };
        let last = |steps: &[Vec<f64>], substeps| follow(&scene.problem(), steps, substeps).pop().unwrap();
        let direct = last(&scene.steps[scene.steps.len() - 1..], 1);
        let walked = last(&scene.steps, 5);
        assert_close(&direct.state.forces, &walked.state.forces);
        assert_close(&direct.state.motion, &walked.state.motion);
        prop_assert_eq!(walked.dissipation(), 0.0);
    }

    /// Without gaps there is no length to compare the load with.
    #[test]
    fn proportional_load_without_gaps_is_homogeneous_of_degree_one(scene in Scene::any(), substeps in 2..8_usize) {
        let scene = Scene { gaps: vec![0.0; scene.count()], ..scene };
        let load = scene.steps[0].clone();
        let half: Vec<f64> = load.iter().map(|factor| 0.5 * factor).collect();
        let once = &follow(&scene.problem(), std::slice::from_ref(&load), 1)[0].state;
        let slowly = &follow(&scene.problem(), &[half, load], substeps);
        assert_close(&once.forces, &slowly[1].state.forces);
        assert_close(&once.motion, &slowly[1].state.motion);
        assert_close(&once.forces, &(2.0 * &slowly[0].state.forces));
        assert_close(&once.motion, &(2.0 * &slowly[0].state.motion));
    }

    #[test]
    fn friction_never_gives_work_back(scene in Scene::any(), substeps in 1..4_usize) {
        let laws: [Arc<dyn FrictionLaw>; 5] = [
            coulomb(scene.mu),
            Arc::new(StaticDynamic::new(1.2 * scene.mu, scene.mu, Transition::Lagged).unwrap()),
            Arc::new(StaticDynamic::new(1.2 * scene.mu, scene.mu, Transition::Drop).unwrap()),
            Arc::new(SlipPower::new(scene.mu, 0.5 * scene.mu, 0.5, 1.0, SlipPath::Committed).unwrap()),
            Arc::new(SlipPower::new(scene.mu, 0.5 * scene.mu, 0.5, 1.0, SlipPath::Current).unwrap()),
        ];
        for law in laws {
            for record in follow(&scene.problem_with(law), &scene.steps, substeps) {
                prop_assert!(record.dissipation() >= -ROUNDING, "{}", record.dissipation());
                for (k, status) in record.state.status.iter().enumerate() {
                    prop_assert!(record.state.history[k].slip_path() >= record.slip[k].abs() - ROUNDING);
                    prop_assert_eq!(record.state.history[k].status(), status.without_direction());
                }
            }
        }
    }

    #[test]
    fn solving_twice_gives_the_same_bits(scene in Scene::any()) {
        let problem = scene.problem();
        let records = scene.follow(1);
        let (state, load) = (&records[0].state, scene.steps.last().unwrap());
        let before = state.clone();
        let first = solve(&Chain::default(), &problem, state, load).unwrap();
        let second = solve(&Chain::default(), &problem, state, load).unwrap();
        prop_assert_eq!(&first.trial, &second.trial);
        prop_assert_eq!(first.work, second.work);
        prop_assert_eq!(&before, state);
    }

    /// Each step is divided for itself: in two and three increments as the histories that have two and three in all.
    #[test]
    fn steps_are_divided_each_for_itself(scene in Scene::any()) {
        let problem = scene.problem();
        let count = scene.steps.len();
        let substeps: Vec<usize> = (0..count).map(|step| 2 + step % 2).collect();
        let history = LoadHistory::divided(scene.steps.clone(), substeps.clone(), Ramp::Linear).unwrap();
        let records = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
        prop_assert_eq!(&records[0].state, &scene.follow(2)[0].state);
        for (record, substeps) in records.iter().zip(&substeps) {
            prop_assert!(record.increments >= *substeps);
        }
        let refused = LoadHistory::divided(scene.steps.clone(), vec![1; count + 1], Ramp::Linear);
        prop_assert!(refused.is_err());
        let mut none = substeps;
        none[count - 1] = 0;
        let refused = LoadHistory::divided(scene.steps.clone(), none, Ramp::Linear);
        prop_assert!(refused.unwrap_err().to_string().contains("0 sub-steps"));
    }

    /// An increment that fails is as if it had never been tried.
    #[test]
    fn cut_back_reaches_the_target_by_accepted_increments_alone(scene in Scene::any()) {
        let problem = scene.problem();
        let reluctant = Reluctant { calls: AtomicUsize::new(0) };
        let history = LoadHistory::new(scene.steps.clone(), 1, Ramp::Linear).unwrap();
        let records = history.follow(&problem, &reluctant, |_| {}).unwrap();
        let slowly = scene.follow(4);
        for ((record, other), target) in records.iter().zip(&slowly).zip(&scene.steps) {
            prop_assert_eq!(&record.state.multipliers, target);
            prop_assert_eq!(&record.state, &other.state);
            prop_assert_eq!((record.cutbacks, record.increments), (2, 4));
            prop_assert_eq!(record.work.solves, other.work.solves + 2);
        }
    }
}

/// A solver that refuses the first two attempts at every load step, so that its increment is cut in four.
#[derive(Debug)]
struct Reluctant {
    calls: AtomicUsize,
}

impl InterfaceSolver for Reluctant {
    fn name(&self) -> &'static str {
        "reluctant"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        // Two refusals and four increments make one load step.
        if self.calls.fetch_add(1, Ordering::Relaxed) % 6 < 2 {
            let work = Work {
                solves: 1,
                ..Work::default()
            };
            return Err(StepFailure {
                attempts: Vec::new(),
                work,
                best: None,
            });
        }
        Chain::default().solve(step)
    }
}

/// Refuses everything after a number of increments.
#[derive(Debug)]
struct Tiring {
    left: AtomicUsize,
}

impl InterfaceSolver for Tiring {
    fn name(&self) -> &'static str {
        "tiring"
    }

    fn solve(&self, step: &Step<'_>) -> Result<StepSolution, StepFailure> {
        if self.left.load(Ordering::Relaxed) == 0 {
            return Err(StepFailure {
                attempts: Vec::new(),
                work: Work::default(),
                best: None,
            });
        }
        self.left.fetch_sub(1, Ordering::Relaxed);
        Chain::default().solve(step)
    }
}

#[test]
fn a_failing_step_leaves_the_steps_before_it_untouched() {
    let compliance = DMatrix::from_row_slice(2, 2, &[1.0, 0.2, 0.2, 0.5]);
    let responses = vec![
        DVector::from_vec(vec![-1.0, 0.3]),
        DVector::from_vec(vec![0.1, 1.0]),
    ];
    let problem = Ground::along_x(vec![0.1], coulomb(0.3))
        .under(&GivenBody::held(compliance, responses).unwrap());
    let steps = vec![vec![1.0, 0.0], vec![1.0, 0.5], vec![0.5, -0.5]];
    let mut seen = Vec::new();
    let tiring = Tiring {
        left: AtomicUsize::new(6 + 1),
    };
    let history = LoadHistory::new(steps.clone(), 3, Ramp::Linear).unwrap();
    let error = history
        .follow(&problem, &tiring, |record| seen.push(record.state.clone()))
        .unwrap_err();
    let ContactError::StepFailed {
        step: 2, reached, ..
    } = error
    else {
        panic!("{error}")
    };
    approx::assert_abs_diff_eq!(reached, 1.0 / 3.0, epsilon = 1e-15);
    let complete: Vec<ContactState> = follow(&problem, &steps[..2], 3)
        .into_iter()
        .map(|record| record.state)
        .collect();
    assert_eq!(seen, complete);
}

/// One point, k_t = k_n = 1 without coupling, pressed by 1 and pulled to and fro by ±1 with μ = 1/2: the loop's corners are
/// Δs = ±1/2 from rest, so each later leg slips by 1 at the force 1/2.
#[test]
fn dissipation_of_a_closed_loop_is_its_area() {
    let body = GivenBody::held(
        DMatrix::identity(2, 2),
        vec![
            DVector::from_vec(vec![-1.0, 0.0]),
            DVector::from_vec(vec![0.0, 1.0]),
        ],
    )
    .unwrap();
    let problem = Ground::along_x(vec![0.0], coulomb(0.5)).under(&body);
    let steps: Vec<Vec<f64>> = [0.0, 1.0, -1.0, 1.0]
        .iter()
        .map(|pull| vec![1.0, *pull])
        .collect();
    for substeps in [1, 2, 7] {
        let records = follow(&problem, &steps, substeps);
        for (record, (slip, loss)) in
            records
                .iter()
                .zip([(0.0, 0.0), (0.5, 0.25), (-1.0, 0.5), (1.0, 0.5)])
        {
            approx::assert_abs_diff_eq!(record.slip[0], slip, epsilon = 1e-14);
            approx::assert_abs_diff_eq!(record.dissipation(), loss, epsilon = 1e-14);
        }
        assert_eq!(records[3].state.status, [Status::SlipPositive]);
        approx::assert_abs_diff_eq!(
            records[3].state.history[0].slip_path(),
            2.5,
            epsilon = 1e-14
        );
    }
}

/// Two points pressed by 1 and moved along by 1 and −1, then by what is below rounding: without friction each slips the way it
/// moves, and keeps to that of the point before it where it does not move at all. Nothing can stick.
#[test]
fn without_friction_points_slip_the_way_they_move() {
    let motion = |values: [f64; 4]| DVector::from_vec(values.to_vec());
    let body = GivenBody::held(
        DMatrix::identity(4, 4),
        vec![
            motion([-1.0, 0.0, -1.0, 0.0]),
            motion([0.0, -1.0, 0.0, 1.0]),
        ],
    )
    .unwrap();
    let problem = Ground::along_x(vec![0.0; 2], coulomb(0.0)).under(&body);
    let steps = vec![vec![1.0, 1.0], vec![1.0, 1.0 + 1e-14], vec![1.0, -1.0]];
    let records = follow(&problem, &steps, 1);
    let (minus, plus) = (Status::SlipNegative, Status::SlipPositive);
    assert_eq!(records[0].state.status, [minus, plus]);
    assert_eq!(records[1].state.status, [minus, minus]);
    assert_eq!(records[2].state.status, [plus, minus]);
    for (record, slip) in records.iter().zip([1.0, 0.0, -2.0]) {
        approx::assert_abs_diff_eq!(record.slip[1], slip, epsilon = 1e-13);
        assert_eq!(record.dissipation(), 0.0);
        assert!(!carries_friction(problem.contacts(), &record.state, 0));
    }
    let rough = Ground::along_x(vec![0.0; 2], coulomb(0.1)).under(&body);
    assert!(carries_friction(rough.contacts(), &records[0].state, 0));
    assert!(!carries_friction(
        rough.contacts(),
        &ContactState::unloaded(&rough),
        0
    ));
}
