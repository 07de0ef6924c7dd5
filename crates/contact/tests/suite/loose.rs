//! Where bodies come to lie that contact leaves undetermined.

use nalgebra::{DMatrix, DVector};
use proptest::prelude::*;
use stickslip_contact::solver::Step;
use stickslip_contact::state::TrialState;
use stickslip_contact::{
    ContactPair, ContactPoint, ContactState, Increment, InterfaceProblem, Status,
};
use stickslip_fem_core::{GivenBody, RigidBody};

use crate::coulomb;

/// Points around each hole.
const AROUND: usize = 12;
const CLEARANCE: f64 = 0.1;

/// [`disk`] with points all around.
fn between(areas: [f64; 2]) -> InterfaceProblem {
    let angle = |k: usize| k as f64 * std::f64::consts::TAU / AROUND as f64;
    disk((0..AROUND).map(angle), areas)
}

/// A rigid disk of radius 1 in two holes with a clearance, the first of them held, the second moved along x by load case 0 and along y by load case 1;
/// case 2 pushes the disk along x. The points of a hole lie at `angles` and count by `areas`.
fn disk(angles: impl Iterator<Item = f64>, areas: [f64; 2]) -> InterfaceProblem {
    let normals: Vec<[f64; 2]> = angles.map(|angle| [angle.cos(), angle.sin()]).collect();
    let size = 2 * normals.len();
    let turning = DMatrix::from_fn(size, 3, |row, motion| {
        let [x, y] = normals[row / 2];
        [[1.0, 0.0, -y], [0.0, 1.0, x]][row % 2][motion]
    });
    let still = || vec![DVector::zeros(size); 3];
    let push = DVector::from_row_slice(&[1.0, 0.0, 0.0]);
    let disk = GivenBody::floating(
        DMatrix::zeros(size, size),
        turning,
        still(),
        vec![DVector::zeros(3), DVector::zeros(3), push],
    );
    let held = RigidBody::held(normals.clone(), 3);
    let moved = [0, 1, 2].map(|along| DVector::from_fn(size, |row, _| f64::from(row % 2 == along)));
    let moved = GivenBody::held(DMatrix::zeros(size, size), moved.into());
    let pair = |second: usize, area: f64| ContactPair {
        name: "hole".into(),
        origin: [0.0; 2],
        first: second,
        second: 0,
        points: (normals.iter().enumerate())
            .map(|(k, &normal)| ContactPoint {
                first: k.into(),
                second: k.into(),
                normal,
                gap: CLEARANCE,
                area,
                material_angle: 0.0,
            })
            .collect(),
        law: coulomb(0.2),
    };
    let pairs = vec![pair(1, areas[0]), pair(2, areas[1])];
    InterfaceProblem::new(&[&disk.unwrap(), &held, &moved.unwrap()], pairs).unwrap()
}

/// Without forces, the disk at `place`: x, y and its turn.
fn at(step: &Step<'_>, place: [f64; 3]) -> TrialState {
    let forces = DVector::zeros(2 * step.count());
    let ones = DVector::from_element(3, 1.0);
    let units = step
        .problem
        .motions_of_body(0, &ones, &forces, step.multipliers());
    let rigid = DVector::from_fn(3, |motion, _| place[motion] / units[motion]);
    TrialState {
        motion: step.total_motion(step.motion(&forces, &rigid)),
        forces,
        rigid,
        status: vec![Status::Open; step.count()],
    }
}

fn gaps(state: &TrialState) -> impl Iterator<Item = f64> + '_ {
    state.motion.iter().step_by(2).copied()
}

/// Where the disk lies at the end of `step`, having been left at `place`.
fn taken(step: &Step<'_>, place: [f64; 3]) -> Vec<f64> {
    let state = Increment::accept(step, at(step, place)).state;
    let problem = step.problem;
    problem.motions_of_body(0, &state.rigid, &state.forces, step.multipliers())
}

/// Halfway where both holes count alike, and where the edge of one ends its way.
#[test]
fn a_loose_disk_lies_between_its_holes() {
    for (areas, way, wanted) in [
        ([1.0, 1.0], 0.12, 0.06),
        ([1.0, 3.0], 0.12, 0.09),
        ([1.0, 3.0], 0.16, CLEARANCE),
        ([3.0, 1.0], 0.16, 0.16 - CLEARANCE),
        ([3e8, 1e8], 0.16, 0.16 - CLEARANCE),
        ([1e-8, 3e-8], 0.16, CLEARANCE),
    ] {
        let problem = between(areas);
        let committed = ContactState::unloaded(&problem);
        let step = Step::new(&problem, &committed, &[way, 0.0, 0.0]);
        for place in [[0.08, 0.0, 0.0], [0.07, 0.01, 0.3], [0.08, -0.02, -0.1]] {
            let found = taken(&step, place);
            let off = [found[0] - wanted, found[1], found[2]];
            let off = off
                .into_iter()
                .fold(0.0, |most: f64, part| most.max(part.abs()));
            assert!(off < 1e-9, "{areas:?} {way}: {found:?}");
        }
    }
}

/// Two disks in one another that nothing holds: no point sees their common motion, which stays as it was.
#[test]
fn what_no_point_sees_does_not_move() {
    let normals: Vec<[f64; 2]> = [0.3, 1.7, 3.1, 4.9]
        .map(|angle: f64| [angle.cos(), angle.sin()])
        .into();
    let free = || RigidBody::sliding(normals.clone(), [true, true], &[[0.0; 2]]);
    let points = (normals.iter().enumerate())
        .map(|(k, &normal)| ContactPoint {
            first: k.into(),
            second: k.into(),
            normal,
            gap: CLEARANCE,
            area: 1.0,
            material_angle: 0.0,
        })
        .collect();
    let pair = ContactPair {
        name: "pair".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points,
        law: coulomb(0.2),
    };
    let problem = InterfaceProblem::new(&[&free(), &free()], vec![pair]).unwrap();
    let committed = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &committed, &[0.0]);
    for (pressed, apart) in [(false, 0.0), (true, 0.05)] {
        let rigid = DVector::from_row_slice(&[0.3, 0.4, 0.3, 0.4 - apart]);
        let forces = DVector::zeros(8);
        let mut trial = TrialState {
            motion: step.total_motion(step.motion(&forces, &rigid)),
            forces,
            rigid: rigid.clone(),
            status: vec![Status::Open; 4],
        };
        if pressed {
            // Along x and along y, so that only the common motion is free.
            for k in [0, 1] {
                trial.forces[2 * k] = 1.0;
                trial.status[k] = Status::Stick;
            }
        }
        let state = Increment::accept(&step, trial).state;
        assert!((&state.rigid - rigid).amax() < 1e-12, "{}", state.rigid);
    }
}

/// A body that is pressed stays at the slip that the solver found, with friction and without.
#[test]
fn what_is_pressed_does_not_slide() {
    for mu in [0.2, 0.0] {
        let problem = between([1.0, 1.0]);
        let problem = (0..2).fold(problem, |own, pair| {
            own.with_law(pair, coulomb(mu)).unwrap()
        });
        let committed = ContactState::unloaded(&problem);
        let step = Step::new(&problem, &committed, &[0.0; 3]);
        let mut trial = at(&step, [0.0; 3]);
        for (k, slip) in [(0, 3.0), (4, 4.0), (8, -1.0)] {
            trial.status[k] = Status::slip_along(slip);
            trial.forces[2 * k] = 1.0;
            trial.forces[2 * k + 1] = -mu * f64::signum(slip);
            trial.motion[2 * k + 1] = slip;
        }
        let before = trial.clone();
        let state = Increment::accept(&step, trial).state;
        assert_eq!((state.motion, state.forces), (before.motion, before.forces));
    }
}

/// A point that touches without force neither sticks nor slips once its body has moved.
#[test]
fn points_without_force_open_where_their_body_moves() {
    let problem = between([1.0, 1.0]);
    let committed = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &committed, &[0.0; 3]);
    let mut trial = at(&step, [CLEARANCE, 0.0, 0.3]);
    trial.status[0] = Status::Stick;
    trial.status[AROUND] = Status::SlipPositive;
    let end = Increment::accept(&step, trial);
    assert!(
        end.state
            .status
            .iter()
            .all(|status| *status == Status::Open)
    );
    assert!(end.slip.amax() == 0.0 && end.residuals.largest() < 1e-10);
    assert!(
        end.state
            .history
            .iter()
            .all(|own| *own == committed.history[0])
    );
}

/// A disk on two points that stand so close that turning about them counts as free: it stays where turning would lift one of them.
#[test]
fn pressed_points_keep_their_gaps() {
    const HALF: f64 = 1.5e-7;
    let problem = disk([-HALF, HALF, 2.0, 4.0].into_iter(), [1.0, 1.0]);
    let problem = (0..2).fold(problem, |own, pair| {
        own.with_law(pair, coulomb(0.0)).unwrap()
    });
    let committed = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &committed, &[0.05, 0.0, 1.0]);
    let mut trial = at(&step, [CLEARANCE, 0.0, 0.3]);
    for k in [0, 1] {
        trial.status[k] = Status::SlipPositive;
        trial.forces[2 * k] = 0.5;
    }
    let end = Increment::accept(&step, trial);
    assert!(end.residuals.largest() < 1e-10, "{:?}", end.residuals);
}

/// Bodies without contact have no place to take.
#[test]
fn without_contact_there_is_nothing_to_move() {
    let free = RigidBody::sliding(Vec::new(), [true, true], &[[0.0; 2]]);
    let problem = InterfaceProblem::new(&[&free], Vec::new()).unwrap();
    let committed = ContactState::unloaded(&problem);
    let step = Step::new(&problem, &committed, &[0.0]);
    let trial = TrialState {
        forces: DVector::zeros(0),
        motion: DVector::zeros(0),
        rigid: DVector::from_row_slice(&[0.1, 0.2]),
        status: Vec::new(),
    };
    let rigid = trial.rigid.clone();
    assert_eq!(Increment::accept(&step, trial).state.rigid, rigid);
}

proptest! {
    /// No place without penetration has moved less, and where a solver leaves the disk does not matter.
    #[test]
    fn the_least_motion_is_taken(
        areas in [0.1..1.0, 0.1..1.0],
        way in [-0.14..0.14, -0.1..0.1],
        others in prop::collection::vec([-0.1..0.1, -0.1..0.1, -0.2..0.2], 40),
    ) {
        let problem = between(areas);
        let committed = ContactState::unloaded(&problem);
        let step = Step::new(&problem, &committed, &[way[0], way[1], 0.0]);
        let moved = |state: &TrialState| -> f64 {
            let since = &state.motion - &committed.motion;
            let of = |row: usize| problem.points()[row / 2].area * since[row].powi(2);
            (0..since.len()).map(of).sum()
        };
        let middle = [0.5 * way[0], 0.5 * way[1], 0.0];
        let clear = |place: &[f64; 3]| gaps(&at(&step, *place)).all(|gap| gap >= 0.0);
        prop_assume!(clear(&middle));
        let found = taken(&step, middle);
        let found: [f64; 3] = found.try_into().unwrap();
        let least = at(&step, found);
        prop_assert!(gaps(&least).all(|gap| gap >= -1e-13));
        for place in others.into_iter().map(|by| [middle[0] + by[0], middle[1] + by[1], by[2]]).filter(clear) {
            prop_assert!(moved(&least) <= moved(&at(&step, place)) * (1.0 + 1e-9));
            let again = taken(&step, place);
            for (a, b) in found.iter().zip(again) {
                prop_assert!((a - b).abs() < 1e-8, "{found:?} from {place:?}");
            }
        }
    }
}
