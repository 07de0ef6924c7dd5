//! Rigid motions that no contact resists.

use nalgebra::{DMatrix, DVector};
use stickslip_contact::freedom::{FreeBody, free_bodies};
use stickslip_contact::{ContactPair, ContactPoint, InterfaceProblem};
use stickslip_fem_core::{GivenBody, InterfaceOperator, RigidBody};

use crate::coulomb;

/// A rigid disk that floats in a held hole, eight points around the circle.
fn disk(mu: f64) -> InterfaceProblem {
    let normals: Vec<[f64; 2]> = (0..8)
        .map(|k| f64::from(k) * std::f64::consts::TAU / 8.0)
        .map(|angle| [angle.cos(), angle.sin()])
        .collect();
    let hole = RigidBody::held(normals.clone(), 1);
    let motions = DMatrix::from_fn(16, 3, |row, motion| {
        let [x, y] = normals[row / 2];
        [[1.0, 0.0, -y], [0.0, 1.0, x]][row % 2][motion]
    });
    let load = DVector::from_vec(vec![1.0, 0.0, 0.0]);
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
    assert_eq!(free_bodies(&disk(0.0)), [free]);
    assert!(free_bodies(&disk(0.1)).is_empty());
}

#[test]
fn a_block_without_friction_slides_on_its_plane() {
    let free = FreeBody {
        body: 0,
        turns: false,
        slipping: vec![0],
    };
    assert_eq!(free_bodies(&block(0.0)), [free]);
    assert!(free_bodies(&block(0.1)).is_empty());
}

#[test]
fn without_rigid_motions_or_without_contact_there_is_nothing_to_resist() {
    let places = vec![[0.0, 0.0], [1.0, 0.0]];
    let [first, second] = [0, 1].map(|_| RigidBody::held(places.clone(), 1));
    assert!(free_bodies(&pair([&first, &second], &[[0.0, 1.0]; 2], 0.0)).is_empty());
    assert!(free_bodies(&InterfaceProblem::new(&[&first], Vec::new()).unwrap()).is_empty());
    let loose = RigidBody::sliding(Vec::new(), [true, false], &[[0.0, 0.0]]);
    let alone = free_bodies(&InterfaceProblem::new(&[&loose], Vec::new()).unwrap());
    assert_eq!(alone.len(), 1);
}
