//! What holds of every answer, whatever the numbers.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector, Matrix2, Rotation2};
use proptest::prelude::*;
use stickslip_contact::solver::{Step, StepFailure, StepSolution, Work};
use stickslip_contact::{
    Chain, ContactError, ContactPair, ContactPoint, ContactState, InterfaceProblem,
    InterfaceSolver, LoadHistory, Ramp, Status, StepRecord,
};
use stickslip_fem_core::{InterfaceOperator, RigidBody};
use stickslip_friction::{FrictionLaw, SlipPath, SlipPower, StaticDynamic, Transition};

use crate::given_body::GivenBody;
use crate::oracle::Conditions;
use crate::{Ground, coulomb, positive_definite, solve};

/// Matrices of order 8 at most and condition numbers below 100: two ways to one answer agree to this.
const ROUNDING: f64 = 1e-10;

/// The data of a small scene: a body of a few points on rigid ground under two load cases.
#[derive(Clone, Debug)]
struct Scene {
    compliance: DMatrix<f64>,
    responses: Vec<DVector<f64>>,
    angles: Vec<f64>,
    gaps: Vec<f64>,
    mu: f64,
    steps: Vec<Vec<f64>>,
}

impl Scene {
    /// Scenes whose friction is below the bound of uniqueness: the compliance is the unit matrix plus at most 0.3 in the
    /// norm, so with μ ≤ 0.4 normal and tangential motion couple less than either resists.
    fn any() -> impl Strategy<Value = Self> {
        (1..=4_usize).prop_flat_map(|count| {
            let size = 2 * count;
            let motion = prop::collection::vec(-1.0..1.0_f64, size);
            (
                prop::collection::vec(-1.0..1.0_f64, size * size),
                prop::collection::vec(motion, 2),
                prop::collection::vec(-3.0..3.0_f64, count),
                prop::collection::vec(0.0..0.3_f64, count),
                0.0..0.4_f64,
                prop::collection::vec(prop::collection::vec(-2.0..2.0_f64, 2), 1..6),
            )
                .prop_map(move |(entries, responses, angles, gaps, mu, steps)| {
                    let factor = DMatrix::from_row_slice(size, size, &entries);
                    let square = &factor * factor.transpose();
                    let compliance =
                        DMatrix::identity(size, size) + &square * (0.3 / square.trace().max(1.0));
                    let responses = responses.into_iter().map(DVector::from_vec).collect();
                    Self {
                        compliance,
                        responses,
                        angles,
                        gaps,
                        mu,
                        steps,
                    }
                })
        })
    }

    fn count(&self) -> usize {
        self.gaps.len()
    }

    fn problem_with(&self, law: Arc<dyn FrictionLaw>) -> InterfaceProblem {
        let body = GivenBody::held(self.compliance.clone(), self.responses.clone());
        let normals = self
            .angles
            .iter()
            .map(|angle| [angle.cos(), angle.sin()])
            .collect();
        Ground {
            normals,
            gaps: self.gaps.clone(),
            law,
        }
        .under(&body)
    }

    fn problem(&self) -> InterfaceProblem {
        self.problem_with(coulomb(self.mu))
    }

    fn follow(&self, substeps: usize) -> Vec<StepRecord> {
        follow(&self.problem(), &self.steps, substeps)
    }

    /// The scene under the orthogonal map `map` of the plane, which turns the angle of every normal by `turn`.
    fn mapped(&self, map: &Matrix2<f64>, turn: impl Fn(f64) -> f64) -> Self {
        let mut all = DMatrix::zeros(2 * self.count(), 2 * self.count());
        for k in 0..self.count() {
            all.fixed_view_mut::<2, 2>(2 * k, 2 * k).copy_from(map);
        }
        Self {
            compliance: &all * &self.compliance * all.transpose(),
            responses: self
                .responses
                .iter()
                .map(|response| &all * response)
                .collect(),
            angles: self.angles.iter().map(|&angle| turn(angle)).collect(),
            ..self.clone()
        }
    }
}

fn follow(problem: &InterfaceProblem, steps: &[Vec<f64>], substeps: usize) -> Vec<StepRecord> {
    let history = LoadHistory::new(steps.to_vec(), substeps, Ramp::Linear).unwrap();
    history.follow(problem, &Chain::default(), |_| {}).unwrap()
}

fn assert_close(left: &DVector<f64>, right: &DVector<f64>) {
    let scale = left.amax().max(1.0);
    assert!((left - right).amax() < ROUNDING * scale, "{left} {right}");
}

/// A held elastic body and a rigid one that floats on it, pressed into the wedge of normals around the x axis.
fn wedge(
    count: usize,
    entries: &[f64],
    tilts: &[f64],
    gap: f64,
    mu: f64,
) -> (InterfaceProblem, Vec<[f64; 2]>) {
    let compliance = positive_definite(2 * count, &entries[..4 * count * count], 0.5);
    let elastic = GivenBody::held(compliance, vec![DVector::zeros(2 * count); 2]);
    let places = elastic.points().to_vec();
    let rigid = RigidBody::sliding(places.clone(), [true, true], &[[1.0, 0.0], [0.0, 1.0]]);
    let points = (0..count)
        .map(|k| {
            let angle = if k % 2 == 0 { tilts[k] } else { -tilts[k] };
            ContactPoint {
                first: k,
                second: k,
                normal: [angle.cos(), angle.sin()],
                gap,
                area: 1.0,
                material_angle: 0.0,
            }
        })
        .collect();
    let pair = ContactPair {
        name: "wedge".into(),
        first: 0,
        second: 1,
        points,
        law: coulomb(mu),
    };
    (
        InterfaceProblem::new(&[&elastic, &rigid], vec![pair]).unwrap(),
        places,
    )
}

proptest! {
    #[test]
    fn every_step_meets_the_conditions(scene in Scene::any()) {
        let problem = scene.problem();
        let mut state = ContactState::unloaded(&problem);
        for (record, multipliers) in scene.follow(1).iter().zip(&scene.steps) {
            let conditions = Conditions::new(&problem, &state, multipliers);
            let trial = stickslip_contact::state::TrialState {
                forces: record.state.forces.clone(),
                motion: record.state.motion.clone(),
                rigid: record.state.rigid.clone(),
                status: record.state.status.clone(),
            };
            prop_assert!(conditions.violation(&trial) < ROUNDING);
            prop_assert!(record.residuals.largest() < ROUNDING);
            prop_assert!(record.audit.gap_work < ROUNDING);
            prop_assert_eq!(&record.state, &crate::commit(&state, &trial, multipliers));
            state = record.state.clone();
        }
    }

    /// The tilts of neighbours have opposite signs, so that the normals' cone holds the load (1, ±0.2).
    #[test]
    fn floating_bodies_are_in_balance_and_action_is_reaction(
        count in 2..=4_usize,
        entries in prop::collection::vec(-0.5..0.5_f64, 64),
        tilts in prop::collection::vec(0.3..0.8_f64, 4),
        gap in 0.0..0.5_f64,
        mu in 0.0..0.4_f64,
        across in -0.2..0.2_f64,
    ) {
        let (problem, places) = wedge(count, &entries, &tilts, gap, mu);
        let multipliers = [1.0, across];
        let records = follow(&problem, &[multipliers.to_vec()], 3);
        let (state, audit) = (&records[0].state, &records[0].audit);
        let first = problem.forces_on_body(0, count, &state.forces);
        let second = problem.forces_on_body(1, count, &state.forces);
        let (mut resultant, mut moment) = ([0.0; 2], 0.0);
        for k in 0..count {
            for i in 0..2 {
                prop_assert_eq!(first[2 * k + i], -second[2 * k + i]);
                resultant[i] += first[2 * k + i];
            }
            moment += places[k][0] * first[2 * k + 1] - places[k][1] * first[2 * k];
        }
        for i in 0..2 {
            prop_assert!((resultant[i] - multipliers[i]).abs() < ROUNDING);
            prop_assert!((audit.resultants[0][i] - resultant[i]).abs() < ROUNDING);
        }
        prop_assert!((audit.moments[0] - moment).abs() < ROUNDING);
        prop_assert!(audit.balance < ROUNDING);
    }

    #[test]
    fn turning_everything_turns_the_answer(scene in Scene::any(), turn in -3.0..3.0_f64) {
        let map = Rotation2::new(turn).into_inner();
        let turned = scene.mapped(&map, |angle| angle + turn);
        for (record, other) in scene.follow(2).iter().zip(turned.follow(2)) {
            assert_close(&record.state.forces, &other.state.forces);
            assert_close(&record.state.motion, &other.state.motion);
            let count = scene.count();
            let forces = scene.problem().forces_on_body(0, count, &record.state.forces);
            let others = turned.problem().forces_on_body(0, count, &other.state.forces);
            for k in 0..count {
                let expected = map * nalgebra::Vector2::new(forces[2 * k], forces[2 * k + 1]);
                prop_assert!((expected[0] - others[2 * k]).abs() < 1e-9);
                prop_assert!((expected[1] - others[2 * k + 1]).abs() < 1e-9);
            }
        }
    }

    #[test]
    fn the_mirror_image_is_the_answer_in_the_mirror(scene in Scene::any()) {
        let mirror = Matrix2::new(1.0, 0.0, 0.0, -1.0);
        let mirrored = scene.mapped(&mirror, |angle| -angle);
        for (record, other) in scene.follow(2).iter().zip(mirrored.follow(2)) {
            let flip = |values: &DVector<f64>| {
                DVector::from_fn(values.len(), |i, _| if i % 2 == 0 { values[i] } else { -values[i] })
            };
            assert_close(&flip(&record.state.forces), &other.state.forces);
            assert_close(&flip(&record.state.motion), &other.state.motion);
            assert_close(&-&record.slip, &other.slip);
        }
    }

    #[test]
    fn loads_and_gaps_scale_forces_and_motions(scene in Scene::any(), factor in 0.01..100.0_f64) {
        let larger = Scene {
            gaps: scene.gaps.iter().map(|gap| factor * gap).collect(),
            steps: scene.steps.iter().map(|step| step.iter().map(|load| factor * load).collect()).collect(),
            ..scene.clone()
        };
        for (record, other) in scene.follow(2).iter().zip(larger.follow(2)) {
            assert_close(&record.state.forces, &(&other.state.forces / factor));
            assert_close(&record.state.motion, &(&other.state.motion / factor));
            prop_assert!((record.dissipation - other.dissipation / (factor * factor)).abs() < 1e-9);
        }
    }

    /// Millimetres or kilometres, newtons or giganewtons.
    #[test]
    fn units_do_not_matter(scene in Scene::any(), length in -9..6_i32, force in -9..9_i32) {
        let (length, force) = (10.0_f64.powi(length), 10.0_f64.powi(force));
        let other = Scene {
            compliance: &scene.compliance * (length / force),
            responses: scene.responses.iter().map(|response| response * length).collect(),
            gaps: scene.gaps.iter().map(|gap| gap * length).collect(),
            ..scene.clone()
        };
        for (record, other) in scene.follow(2).iter().zip(other.follow(2)) {
            assert_close(&record.state.forces, &(&other.state.forces / force));
            assert_close(&record.state.motion, &(&other.state.motion / length));
            prop_assert_eq!(&record.state.status, &other.state.status);
        }
    }

    /// Only the sum of the two compliances matters, whatever the order of the second body's points.
    #[test]
    fn two_elastic_bodies_are_as_one_that_gives_as_both(scene in Scene::any(), share in 0.1..0.9_f64) {
        let (count, size) = (scene.count(), 2 * scene.count());
        // Second body: the remaining share, its points numbered backwards, loaded with minus its share of the motion.
        let backwards = |i: usize| 2 * (count - 1 - i / 2) + i % 2;
        let first = GivenBody::held(
            &scene.compliance * share,
            scene.responses.iter().map(|response| response * share).collect(),
        );
        let second = GivenBody::held(
            DMatrix::from_fn(size, size, |i, j| scene.compliance[(backwards(i), backwards(j))] * (1.0 - share)),
            scene.responses.iter().map(|all| DVector::from_fn(size, |i, _| (share - 1.0) * all[backwards(i)])).collect(),
        );
        let points = (0..count)
            .map(|k| ContactPoint {
                first: k,
                second: count - 1 - k,
                normal: [scene.angles[k].cos(), scene.angles[k].sin()],
                gap: scene.gaps[k],
                area: 1.0,
                material_angle: 0.0,
            })
            .collect();
        let pair = ContactPair { name: "pair".into(), first: 0, second: 1, points, law: coulomb(scene.mu) };
        let problem = InterfaceProblem::new(&[&first, &second], vec![pair]).unwrap();
        for (record, other) in scene.follow(1).iter().zip(follow(&problem, &scene.steps, 1)) {
            assert_close(&record.state.forces, &other.state.forces);
            assert_close(&record.state.motion, &other.state.motion);
        }
    }

    #[test]
    fn without_friction_the_path_does_not_matter(scene in Scene::any()) {
        let scene = Scene { mu: 0.0, ..scene };
        let last = |steps: &[Vec<f64>], substeps| follow(&scene.problem(), steps, substeps).pop().unwrap();
        let direct = last(&scene.steps[scene.steps.len() - 1..], 1);
        let walked = last(&scene.steps, 5);
        assert_close(&direct.state.forces, &walked.state.forces);
        assert_close(&direct.state.motion, &walked.state.motion);
        prop_assert_eq!(walked.dissipation, 0.0);
    }

    /// Without gaps there is no length to compare the load with.
    #[test]
    fn proportional_load_without_gaps_is_homogeneous_of_degree_one(scene in Scene::any(), substeps in 2..8_usize) {
        let scene = Scene { gaps: vec![0.0; scene.count()], ..scene };
        let load = scene.steps[0].clone();
        let half: Vec<f64> = load.iter().map(|factor| 0.5 * factor).collect();
        let once = &follow(&scene.problem(), &[load.clone()], 1)[0].state;
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
                prop_assert!(record.dissipation >= -ROUNDING, "{}", record.dissipation);
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
                pivots: 0,
            };
            return Err(StepFailure {
                attempts: Vec::new(),
                work,
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
    let problem =
        Ground::along_x(vec![0.1], coulomb(0.3)).under(&GivenBody::held(compliance, responses));
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
    );
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
            approx::assert_abs_diff_eq!(record.dissipation, loss, epsilon = 1e-14);
        }
        assert_eq!(records[3].state.status, [Status::SlipPositive]);
        approx::assert_abs_diff_eq!(
            records[3].state.history[0].slip_path(),
            2.5,
            epsilon = 1e-14
        );
    }
}
