//! Rigid bodies that float: contact made, lost and made again, and loads that nothing can balance.

use approx::assert_abs_diff_eq;
use nalgebra::{DMatrix, DVector};
use stickslip_contact::solver::FailureCause;
use stickslip_contact::{
    Chain, ContactError, ContactPair, ContactPoint, ContactState, InterfaceProblem,
    InterfaceSolver, LoadHistory, Pivoting, Ramp, SemismoothNewton, Status, StatusIteration,
};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::{coulomb, solve};

/// A few operations on numbers of order one.
const EXACT: f64 = 1e-13;

/// Two points on a held elastic body of compliances 2 and 1 along x, 1/2 along y, and a rigid block against them that moves
/// where `free` says so; load cases push it along x and along y. The block's normals point along +x, into the body.
fn block(free: [bool; 2], gaps: [f64; 2], mu: f64) -> InterfaceProblem {
    let compliance = DMatrix::from_diagonal(&DVector::from_vec(vec![2.0, 0.5, 1.0, 0.5]));
    let elastic = GivenBody::held(compliance, vec![DVector::zeros(4); 2]).unwrap();
    let places = elastic.points().to_vec();
    let rigid = RigidBody::sliding(places, free, &[[1.0, 0.0], [0.0, 1.0]]);
    let points = (0..2).map(|k| point(k, [1.0, 0.0], gaps[k])).collect();
    let pair = ContactPair {
        name: "block".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: coulomb(mu),
    };
    InterfaceProblem::new(&[&elastic, &rigid], vec![pair]).unwrap()
}

fn point(index: usize, normal: [f64; 2], gap: f64) -> ContactPoint {
    ContactPoint {
        first: index.into(),
        second: index.into(),
        normal,
        gap,
        area: 1.0,
        material_angle: 0.0,
    }
}

fn every_solver() -> [Box<dyn InterfaceSolver>; 5] {
    [
        Box::new(Chain::default()),
        Box::new(Chain::status_first()),
        Box::new(StatusIteration::default()),
        Box::new(SemismoothNewton::default()),
        Box::new(Pivoting::default()),
    ]
}

/// Gaps 0.1 and 0.4. A push of 0.06 travels to 0.1 + 2·0.06 = 0.22 on the first point alone; one of 0.3 presses both:
/// λ₀ + λ₁ = 0.3, 0.1 + 2 λ₀ = 0.4 + λ₁, so λ₀ = 0.2, λ₁ = 0.1, and the block stands at 0.5.
#[test]
fn a_floating_block_is_brought_to_contact_by_its_load() {
    let problem = block([true, false], [0.1, 0.4], 0.3);
    for solver in every_solver() {
        let history =
            LoadHistory::new(vec![vec![0.06, 0.0], vec![0.3, 0.0]], 1, Ramp::Linear).unwrap();
        let records = history.follow(&problem, &*solver, |_| {}).unwrap();
        let [first, second] = [&records[0].state, &records[1].state];
        assert_eq!(first.status, [Status::Stick, Status::Open]);
        assert_abs_diff_eq!(first.rigid[0], 0.22, epsilon = EXACT);
        assert_abs_diff_eq!(first.gap(1), 0.18, epsilon = EXACT);
        assert_eq!(second.status, [Status::Stick; 2]);
        assert_abs_diff_eq!(second.normal_force(0), 0.2, epsilon = EXACT);
        assert_abs_diff_eq!(second.normal_force(1), 0.1, epsilon = EXACT);
        assert_abs_diff_eq!(second.rigid[0], 0.5, epsilon = EXACT);
        assert!(records.iter().all(|record| record.audit.balance() < EXACT));
    }
}

/// The push of 0.3 holds a pull along y of at most μ·0.3 = 0.09. Each point then sticks or slips; the block moves by the
/// give of the points.
#[test]
fn friction_alone_holds_a_block_along_the_contact() {
    let problem = block([true, true], [0.1, 0.4], 0.3);
    for solver in [&Chain::default(), &Chain::status_first()] {
        let history = LoadHistory::new(
            vec![vec![0.3, 0.0], vec![0.3, 0.07], vec![0.3, -0.07]],
            1,
            Ramp::Linear,
        )
        .unwrap();
        for (record, pull) in history
            .follow(&problem, solver, |_| {})
            .unwrap()
            .iter()
            .zip([0.0, 0.07, -0.07])
        {
            assert_abs_diff_eq!(record.audit.pairs[0].resultant[0], 0.3, epsilon = EXACT);
            assert_abs_diff_eq!(record.audit.pairs[0].resultant[1], pull, epsilon = EXACT);
            assert!(record.residuals.largest() < 1e-12);
        }
        // 0.035 on each point is more than μ λ₁ = 0.03: that point slips, the other carries 0.04 and gives by 0.02.
        let record = &history.follow(&problem, solver, |_| {}).unwrap()[1];
        assert_eq!(record.state.status, [Status::Stick, Status::SlipNegative]);
        assert_abs_diff_eq!(record.state.rigid[1], 0.02, epsilon = EXACT);
        assert_abs_diff_eq!(record.slip[1], 0.5 * 0.03 - 0.02, epsilon = EXACT);
    }
}

/// More than friction can hold: no solution, and a rigid motion that slides and lifts at the angle of friction proves it. The
/// history ends within the step, where the pull reaches 0.09.
#[test]
fn a_block_pulled_beyond_friction_is_not_held() {
    let problem = block([true, true], [0.1, 0.4], 0.3);
    let history = LoadHistory::new(vec![vec![0.3, 0.0], vec![0.3, 0.18]], 1, Ramp::Linear).unwrap();
    let error = history
        .follow(&problem, &Chain::default(), |_| {})
        .unwrap_err();
    let ContactError::StepFailed {
        step,
        reached,
        cause,
        ..
    } = error
    else {
        panic!("{error}")
    };
    assert_eq!(step, 1);
    // Increments were halved down to 1/1024 of the step.
    assert!(reached <= 0.5 && reached > 0.5 - 2.0 / 1024.0, "{reached}");
    assert!(cause.is_proved_impossible(), "{cause}");
}

/// Pulled off, from no contact or from full contact: the motion away from the body is named, and proves it.
#[test]
fn a_block_pulled_off_is_unbalanced_and_proved_so() {
    for free in [[true, false], [true, true]] {
        let problem = block(free, [0.1, 0.4], 0.3);
        let unloaded = ContactState::unloaded(&problem);
        let history = LoadHistory::new(vec![vec![0.3, 0.0]], 1, Ramp::Linear).unwrap();
        let pressed = history
            .follow(&problem, &Chain::default(), |_| {})
            .unwrap()
            .remove(0)
            .state;
        for state in [&unloaded, &pressed] {
            for solver in [&Chain::default(), &Chain::status_first()] {
                let failure = solve(solver, &problem, state, &[-0.1, 0.0]).unwrap_err();
                let (
                    _,
                    FailureCause::Unbalanced {
                        motion,
                        proved: true,
                        ..
                    },
                ) = failure.attempts.last().unwrap()
                else {
                    panic!("{failure}");
                };
                assert!(
                    motion[0] < 0.0 && motion[1..].iter().all(|along| along.abs() < EXACT),
                    "{motion:?}"
                );
                assert!(failure.is_proved_impossible());
                assert!(failure.to_string().contains("proved"));
            }
        }
    }
}

/// A load that passes from press to pull ends the history where it vanishes, at 3/4 of the step.
#[test]
fn a_pull_ends_the_history_where_the_load_vanishes() {
    let problem = block([true, false], [0.1, 0.4], 0.3);
    let history = LoadHistory::new(vec![vec![0.3, 0.0], vec![-0.1, 0.0]], 1, Ramp::Linear).unwrap();
    let error = history
        .follow(&problem, &Chain::default(), |_| {})
        .unwrap_err();
    let ContactError::StepFailed {
        step: 1,
        reached,
        cause,
        ..
    } = error
    else {
        panic!("{error}")
    };
    assert!(
        reached <= 0.75 && reached > 0.75 - 2.0 / 1024.0,
        "{reached}"
    );
    assert!(cause.is_proved_impossible());
}

/// Without friction a pull along the contact meets nothing: proved.
#[test]
fn a_frictionless_block_slides_off_along_the_contact() {
    let problem = block([true, true], [0.0, 0.0], 0.0);
    let failure = solve(
        &Chain::default(),
        &problem,
        &ContactState::unloaded(&problem),
        &[0.3, 0.1],
    )
    .unwrap_err();
    let (
        _,
        FailureCause::Unbalanced {
            motion,
            proved: true,
            ..
        },
    ) = failure.attempts.last().unwrap()
    else {
        panic!("{failure}");
    };
    assert!(motion[1] > 0.0 && motion[0].abs() < EXACT, "{motion:?}");
}

/// A pin of play 0.5 on either side between two elastic walls of compliance 1, pushed to and fro: contact on one wall is
/// lost altogether and made on the other.
#[test]
fn a_pin_between_walls_changes_sides() {
    let elastic = GivenBody::held(DMatrix::identity(4, 4), vec![DVector::zeros(4)]).unwrap();
    let places = elastic.points().to_vec();
    let pin = RigidBody::sliding(places, [true, false], &[[1.0, 0.0]]);
    let points = vec![point(0, [1.0, 0.0], 0.5), point(1, [-1.0, 0.0], 0.5)];
    let pair = ContactPair {
        name: "slot".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: coulomb(0.3),
    };
    let problem = InterfaceProblem::new(&[&elastic, &pin], vec![pair]).unwrap();
    let loads = [2.0, 0.0, -2.0, -1.0, 3.0];
    for solver in every_solver() {
        let history = LoadHistory::new(
            loads.iter().map(|&load| vec![load]).collect(),
            2,
            Ramp::Linear,
        )
        .unwrap();
        let records = history
            .follow(&problem, &*solver, |_| {})
            .unwrap_or_else(|error| panic!("{error}"));
        for (record, load) in records.iter().zip(loads) {
            let state = &record.state;
            assert_abs_diff_eq!(state.normal_force(0), load.max(0.0), epsilon = EXACT);
            assert_abs_diff_eq!(state.normal_force(1), (-load).max(0.0), epsilon = EXACT);
            if load != 0.0 {
                assert_abs_diff_eq!(state.rigid[0], load + 0.5 * load.signum(), epsilon = EXACT);
            }
        }
    }
}

/// A held body lifted off the ground and set down again elsewhere: slip counts from where it was set down, and the path that
/// it has slid before stays.
#[test]
fn contact_is_lost_altogether_and_made_again() {
    let body = GivenBody::held(
        DMatrix::identity(4, 4),
        vec![
            DVector::from_vec(vec![-1.0, 0.0, -1.0, 0.0]),
            DVector::from_vec(vec![0.0, 1.0, 0.0, 1.0]),
        ],
    )
    .unwrap();
    let problem = crate::Ground::along_x(vec![0.2; 2], coulomb(0.5)).under(&body);
    // (press, pull): down; slide to 1.5 − 0.5 = 1; up; across in the air; down at 4; a pull back that sticks.
    let loads = [
        [1.2, 0.0],
        [1.2, 1.5],
        [-1.0, 1.5],
        [-1.0, 4.0],
        [1.2, 4.0],
        [1.2, 3.8],
    ];
    for solver in every_solver() {
        let history = LoadHistory::new(
            loads.iter().map(|load| load.to_vec()).collect(),
            1,
            Ramp::Linear,
        )
        .unwrap();
        let records = history.follow(&problem, &*solver, |_| {}).unwrap();
        let expected = [
            (Status::Stick, 0.0, 0.0),
            (Status::SlipPositive, 1.0, -0.5),
            (Status::Open, 1.5, 0.0),
            (Status::Open, 4.0, 0.0),
            (Status::Stick, 4.0, 0.0),
            (Status::Stick, 4.0, 0.2),
        ];
        for (record, (status, displacement, force)) in records.iter().zip(expected) {
            for k in 0..2 {
                assert_eq!(record.state.status[k], status, "{}", solver.name());
                assert_abs_diff_eq!(
                    record.state.tangential_displacement(k),
                    displacement,
                    epsilon = EXACT
                );
                assert_abs_diff_eq!(record.state.tangential_force(k), force, epsilon = EXACT);
            }
        }
        assert_abs_diff_eq!(
            records[5].state.history[0].slip_path(),
            1.0,
            epsilon = EXACT
        );
    }
}

/// Loaded, and all but unloaded: what is out of balance is measured by a thousandth of the largest load of the history, not by
/// the step's own, of which rounding is a large part.
#[test]
fn the_balance_of_an_unloaded_step_has_a_floor_in_the_history() {
    let problem = block([true, false], [0.1, 0.4], 0.3);
    let steps = vec![vec![0.3, 0.0], vec![1e-12, 0.0]];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let mut seen = Vec::new();
    let records = history
        .follow(&problem, &Chain::default(), |record| {
            seen.push(record.audit.clone());
        })
        .unwrap();
    // The elastic body is held and has no balance of this kind.
    let [first, last] = [0, 1].map(|step: usize| &records[step].audit.bodies[0]);
    assert_eq!((records[0].audit.bodies.len(), first.body), (1, 1));
    assert_abs_diff_eq!(first.scale, 0.3, epsilon = EXACT);
    assert_eq!(first.relative, first.unbalanced / first.scale);
    assert!(last.scale < 1e-11);
    assert_eq!(last.relative, last.unbalanced / (1e-3 * first.scale));
    assert!(last.relative < EXACT);
    assert_eq!(seen[1], records[1].audit);

    // As a step is accepted, the largest load so far is known; at the end, that of all steps.
    let steps = vec![vec![1e-5, 0.0], vec![0.3, 0.0]];
    let history = LoadHistory::new(steps, 1, Ramp::Linear).unwrap();
    let records = history.follow(&problem, &Chain::default(), |_| {}).unwrap();
    let [first, second] = [0, 1].map(|step: usize| &records[step].audit.bodies[0]);
    assert_eq!(first.relative, first.unbalanced / (1e-3 * second.scale));
}

/// A pin that touches the hole of a plate at θ = 0, with the clearance c, is driven upwards by v < c; the plate may slide along x and
/// nothing pushes it. Nothing needs to be pressed: the plate makes way by c − √(c² − v²), but for the angles between the points.
#[test]
fn a_plate_makes_way_for_a_driven_pin_without_force() {
    let (count, clearance) = (72, 0.02);
    let angle = |k: usize| std::f64::consts::TAU * k as f64 / count as f64;
    let normal = |k: usize| [-angle(k).cos(), -angle(k).sin()];
    let upwards = DVector::from_fn(2 * count, |row, _| if row % 2 == 1 { 1.0 } else { 0.0 });
    let compliance = DMatrix::identity(2 * count, 2 * count);
    let pin = GivenBody::held(compliance, vec![upwards]).unwrap();
    let plate = RigidBody::sliding(pin.points().to_vec(), [true, false], &[[0.0; 2]]);
    let gap = |k: usize| clearance * (1.0 - angle(k).cos());
    let pair = ContactPair {
        origin: [0.0; 2],
        name: "joint".into(),
        first: 0,
        second: 1,
        points: (0..count).map(|k| point(k, normal(k), gap(k))).collect(),
        law: coulomb(0.2),
    };
    let problem = InterfaceProblem::new(&[&pin, &plate], vec![pair]).unwrap();
    let between_points = clearance * (angle(1) / 2.0).powi(2);
    for parts in [1, 4, 15] {
        let drive = (1..=parts).map(|k| vec![0.9 * clearance * f64::from(k) / f64::from(parts)]);
        let history = LoadHistory::new(drive.collect(), 1, Ramp::Linear).unwrap();
        for solver in [&Chain::default(), &Chain::status_first()] {
            for record in history.follow(&problem, solver, |_| {}).unwrap() {
                let v = record.state.multipliers[0];
                let way = clearance - (clearance * clearance - v * v).sqrt();
                assert_eq!(record.state.forces.amax(), 0.0);
                assert_eq!(record.slip.amax(), 0.0);
                assert!(
                    record
                        .state
                        .status
                        .iter()
                        .all(|&status| status == Status::Open)
                );
                assert_abs_diff_eq!(record.state.rigid[0], way, epsilon = 3.0 * between_points);
            }
        }
    }
}

/// A block between two walls that come nearer than it is wide makes no way: it is pressed from both sides.
#[test]
fn a_block_between_walls_that_close_is_pressed() {
    let places = vec![[0.0, 0.0], [0.0, 0.0]];
    let closing = DVector::from_vec(vec![1.0, 0.0, -1.0, 0.0]);
    let walls = GivenBody::held(DMatrix::identity(4, 4), vec![closing]).unwrap();
    let block = RigidBody::sliding(places, [true, true], &[[0.0; 2]]);
    let points = vec![point(0, [-1.0, 0.0], 0.1), point(1, [1.0, 0.0], 0.2)];
    let pair = ContactPair {
        name: "walls".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: coulomb(0.3),
    };
    let problem = InterfaceProblem::new(&[&walls, &block], vec![pair]).unwrap();
    let history = LoadHistory::new(vec![vec![0.12], vec![0.35]], 1, Ramp::Linear).unwrap();
    for solver in [&Chain::default(), &Chain::status_first()] {
        let records = history.follow(&problem, solver, |_| {}).unwrap();
        // Each wall may come by the mean gap 0.15.
        assert_eq!(records[0].state.forces.amax(), 0.0);
        for k in 0..2 {
            assert_abs_diff_eq!(records[1].state.normal_force(k), 0.2, epsilon = EXACT);
        }
        assert_abs_diff_eq!(records[1].state.rigid[0], 0.05, epsilon = EXACT);
    }
}
