//! Rigid motions that no contact resists.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::freedom::{FreeBody, free_bodies, loose_pairs, sliding_pairs};
use stickslip_contact::{ContactPair, ContactPoint, ContactState, InterfaceProblem, Status};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::coulomb;

/// A rigid disk that floats in a held hole, eight points around the circle.
fn disk(mu: f64) -> InterfaceProblem {
    disk_with(mu, 0)
}

/// The same without the first `held` of its motions along x, along y, about its centre.
fn disk_with(mu: f64, held: usize) -> InterfaceProblem {
    let normals: Vec<[f64; 2]> = (0..8)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 8.0)
        .map(|angle| [angle.cos(), angle.sin()])
        .collect();
    let hole = RigidBody::held(normals.clone(), 1);
    let motions = DMatrix::from_fn(16, 3, |row, motion| {
        let [x, y] = normals[row / 2];
        [[1.0, 0.0, -y], [0.0, 1.0, x]][row % 2][motion]
    });
    let motions = motions.remove_columns(0, held);
    let mut load = DVector::zeros(3 - held);
    if held == 0 {
        load[0] = 1.0;
    }
    let disk = GivenBody::floating(
        DMatrix::zeros(16, 16),
        motions,
        vec![DVector::zeros(16)],
        vec![load],
    )
    .unwrap();
    pair([&hole, &disk], &normals, mu)
}

/// A rigid block that may slide on a held plane.
fn block(mu: f64) -> InterfaceProblem {
    let places = vec![[0.0, 0.0], [1.0, 0.0]];
    let plane = RigidBody::held(places.clone(), 1);
    let block = RigidBody::sliding(places, [true, true], &[[0.0, -1.0]]);
    pair([&block, &plane], &[[0.0, 1.0]; 2], mu)
}

fn pair(bodies: [&dyn InterfaceOperator; 2], normals: &[[f64; 2]], mu: f64) -> InterfaceProblem {
    let points = normals.iter().enumerate().map(|(k, &normal)| ContactPoint {
        first: k.into(),
        second: k.into(),
        normal,
        gap: 0.0,
        area: 1.0,
        material_angle: 0.0,
    });
    let pair = ContactPair {
        name: "pair".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: points.collect(),
        law: coulomb(mu),
    };
    InterfaceProblem::new(&bodies, vec![pair]).unwrap()
}

#[test]
fn a_disk_without_friction_turns_in_its_hole() {
    let free = FreeBody {
        body: 1,
        turns: true,
        slipping: vec![0],
    };
    assert_eq!(free_bodies(&disk(0.0), 0.0), [free]);
    assert!(free_bodies(&disk(0.1), 0.0).is_empty());
}

/// Held at its centre, its only motion moves no point along a normal but for rounding.
#[test]
fn a_disk_held_at_its_centre_turns_without_friction() {
    let free = FreeBody {
        body: 1,
        turns: true,
        slipping: vec![0],
    };
    assert_eq!(free_bodies(&disk_with(0.0, 2), 0.0), [free]);
    assert!(free_bodies(&disk_with(0.1, 2), 0.0).is_empty());
}

/// A disk that no point presses, or one point alone, may lie elsewhere; between two sticking points it cannot.
#[test]
fn gaps_are_undetermined_where_too_few_points_press() {
    let problem = disk(0.1);
    let pressed = |points: &[usize]| {
        let mut state = ContactState::unloaded(&problem);
        for &k in points {
            state.status[k] = Status::Stick;
            state.forces[2 * k] = 1.0;
        }
        loose_pairs(&problem, &state)
    };
    assert_eq!(pressed(&[]), [0]);
    assert_eq!(pressed(&[0]), [0]);
    assert!(pressed(&[0, 1]).is_empty());
}

/// A disk held at its centre that slips one way at two points and the other way at two may turn a little further: its friction stays.
/// It may not if one of them sticks within its bound, nor if two that stand still at their bound hold it from both sides.
#[test]
fn slip_is_undetermined_where_no_pressed_point_sticks() {
    let problem = disk_with(0.1, 2);
    let points = [0, 2, 4, 6];
    let found = |friction: [f64; 4], slips: [f64; 4]| {
        let mut state = ContactState::unloaded(&problem);
        let mut slip = DVector::zeros(8);
        for (k, (friction, slipped)) in points.into_iter().zip(friction.into_iter().zip(slips)) {
            state.forces[2 * k] = 1.0;
            state.forces[2 * k + 1] = friction;
            slip[k] = slipped;
            state.status[k] = match slipped {
                0.0 => Status::Stick,
                _ if slipped > 0.0 => Status::SlipPositive,
                _ => Status::SlipNegative,
            };
        }
        let committed = ContactState::unloaded(&problem);
        sliding_pairs(&problem, &committed, &state, &slip)
    };
    let at_bound = [-0.1, -0.1, 0.1, 0.1];
    assert_eq!(found(at_bound, [1.0, 2.0, -1.0, -2.0]), [0]);
    assert_eq!(found(at_bound, [0.0, 2.0, -1.0, -2.0]), [0]);
    assert!(found(at_bound, [0.0, 2.0, -1.0, 0.0]).is_empty());
    assert!(found([-0.09, -0.1, 0.1, 0.1], [0.0, 2.0, -1.0, -2.0]).is_empty());
}

#[test]
fn a_block_without_friction_slides_on_its_plane() {
    let free = FreeBody {
        body: 0,
        turns: false,
        slipping: vec![0],
    };
    assert_eq!(free_bodies(&block(0.0), 0.0), [free]);
    assert!(free_bodies(&block(0.1), 0.0).is_empty());
}

#[test]
fn without_rigid_motions_or_without_contact_there_is_nothing_to_resist() {
    let places = vec![[0.0, 0.0], [1.0, 0.0]];
    let [first, second] = [0, 1].map(|_| RigidBody::held(places.clone(), 1));
    assert!(free_bodies(&pair([&first, &second], &[[0.0, 1.0]; 2], 0.0), 0.0).is_empty());
    assert!(free_bodies(&InterfaceProblem::new(&[&first], Vec::new()).unwrap(), 0.0).is_empty());
    let loose = RigidBody::sliding(Vec::new(), [true, false], &[[0.0, 0.0]]);
    let alone = free_bodies(&InterfaceProblem::new(&[&loose], Vec::new()).unwrap(), 0.0);
    assert_eq!(alone.len(), 1);
}
