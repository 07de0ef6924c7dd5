//! A body some of whose displacements are prescribed, against the same body with moving supports.

use std::sync::Arc;

use stickslip_fem_core::body::PartitionedBody;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::material::{Isotropic, Material, PlaneState};
use stickslip_fem_core::mesh::{ElementBlock, ElementKind, Mesh, MeshParts};
use stickslip_fem_core::{BodyError, ElasticBody, HeldDirection, LoadCase, Support};

fn held(nodes: &[usize], direction: HeldDirection, displacement: f64) -> Support {
    Support {
        nodes: nodes.to_vec(),
        direction,
        displacement,
    }
}

/// A rectangle that rolls on a skew plane along its right side.
fn body() -> ElasticBody {
    let rectangle = Rectangle::uniform([0.0, 3.0], [0.0, 2.0], [6, 4], ElementKind::Q8).unwrap();
    let mesh = Arc::new(rectangle.generate().unwrap());
    let material = Isotropic::new(10.0, 0.3, PlaneState::Stress).unwrap();
    let materials: Vec<Arc<dyn Material>> = vec![Arc::new(material)];
    let skew = held(
        mesh.node_set("right").unwrap(),
        HeldDirection::Angle(0.4),
        0.0,
    );
    ElasticBody::new(mesh, materials, 0.5)
        .unwrap()
        .with_supports([skew])
}

#[test]
fn prescribed_displacements_are_moving_supports() {
    let body = body();
    let left = body.mesh().node_set("left").unwrap().to_vec();
    let count = body.mesh().nodes().len();
    let forces: Vec<f64> = (0..2 * count).map(|k| 1e-2 * (k as f64).sin()).collect();
    let case = LoadCase {
        forces: forces.clone(),
        moves_supports: true,
        ..LoadCase::default()
    };
    let moved = [
        held(&left, HeldDirection::X, 0.1),
        held(&left, HeldDirection::Y, -0.2),
    ];
    let moved = body
        .clone()
        .with_supports(moved)
        .with_load_cases(vec![case])
        .unwrap();
    let exact = Arc::new(moved)
        .condense(&[])
        .unwrap()
        .displacements(&[], &[1.0], &[]);

    let dofs: Vec<usize> = left
        .iter()
        .flat_map(|&node| [2 * node, 2 * node + 1])
        .collect();
    let partitioned = PartitionedBody::new(&Arc::new(body), &dofs).unwrap();
    let values: Vec<f64> = left.iter().flat_map(|_| [0.1, -0.2]).collect();
    let states = partitioned.solve(&values, &forces);
    assert_eq!(states.count(), 1);
    let found = states.displacements(0);
    assert!(found.iter().zip(&exact).all(|(a, b)| (a - b).abs() < 1e-12));
}

#[test]
fn derivatives_are_differences() {
    let body = Arc::new(body());
    let left = body.mesh().node_set("left").unwrap().to_vec();
    let dofs: Vec<usize> = left
        .iter()
        .flat_map(|&node| [2 * node, 2 * node + 1])
        .collect();
    let partitioned = PartitionedBody::new(&body, &dofs).unwrap();
    let size = 2 * body.mesh().nodes().len();
    // An output that reads prescribed, free and skew-supported displacements.
    let row: Vec<(usize, f64)> = (0..size).map(|k| (k, (0.7 * k as f64).cos())).collect();
    let derivatives = partitioned.derivatives(std::slice::from_ref(&row));
    for (k, derivative) in derivatives.iter().enumerate() {
        let mut values = vec![0.0; dofs.len()];
        values[k] = 1.0;
        let u = partitioned.solve(&values, &[]).displacements(0);
        let output: f64 = row.iter().map(|&(dof, weight)| weight * u[dof]).sum();
        assert!((output - derivative).abs() < 1e-11, "{output} {derivative}");
    }
}

#[test]
fn what_cannot_be_prescribed_is_refused() {
    let body = Arc::new(body());
    let refused = |dofs: &[usize]| PartitionedBody::new(&body, dofs).unwrap_err();
    let right = body.mesh().node_set("right").unwrap()[1];
    assert_eq!(refused(&[0, 0]), BodyError::RepeatedNode { node: 0 });
    assert_eq!(refused(&[100_000]), BodyError::NoSuchNode { node: 50_000 });
    assert!(matches!(
        refused(&[]),
        BodyError::LoosePart {
            node: 0,
            motions: 1,
            ..
        }
    ));
    let left = body.mesh().node_set("left").unwrap()[0];
    assert_eq!(
        refused(&[2 * left, 2 * left + 1, 2 * right]),
        BodyError::ContradictingSupports { node: right }
    );
}

/// Two squares side by side that share no node, nodes 0 to 3 and 4 to 7.
fn two_squares() -> ElasticBody {
    let nodes = [0.0, 5.0].iter().flat_map(|&x| {
        let right = x + 1.0;
        [[x, 0.0], [right, 0.0], [right, 1.0], [x, 1.0]]
    });
    let block = ElementBlock {
        name: "squares".to_owned(),
        kind: ElementKind::Q4,
        connectivity: (0..8).collect(),
    };
    let parts = MeshParts {
        nodes: nodes.collect(),
        blocks: vec![block],
        ..MeshParts::default()
    };
    let material = Isotropic::new(10.0, 0.3, PlaneState::Stress).unwrap();
    let mesh = Arc::new(Mesh::new(parts).unwrap());
    ElasticBody::new(mesh, vec![Arc::new(material)], 0.5).unwrap()
}

/// What is named as loose is: the part that nothing holds, and only where the whole body moves any node of it.
#[test]
fn the_loose_part_is_named() {
    let body = Arc::new(two_squares());
    let both = |node: usize| [2 * node, 2 * node + 1];
    let refused = |dofs: &[usize]| PartitionedBody::new(&body, dofs).unwrap_err();
    let first: Vec<usize> = [0, 1].into_iter().flat_map(both).collect();
    let second: Vec<usize> = [4, 5].into_iter().flat_map(both).collect();
    let loose = |node| BodyError::LoosePart {
        node,
        at: body.mesh().nodes()[node],
        parts: 2,
        motions: 3,
    };
    assert_eq!(refused(&first), loose(4));
    assert_eq!(refused(&second), loose(0));
    // Both roll along x: the hold that takes the common motion off the first part leaves it to the second.
    let rollers = [0, 1, 4, 5].map(|node| 2 * node + 1);
    let BodyError::LoosePart {
        node, motions: 1, ..
    } = refused(&rollers)
    else {
        panic!("both parts can roll");
    };
    assert!(node == 0 || node == 4);
    // The second cannot roll, the first can.
    let rollers = [0, 1, 4, 5].map(|node| 2 * node + 1);
    let held: Vec<usize> = rollers.into_iter().chain([8]).collect();
    assert!(matches!(
        refused(&held),
        BodyError::LoosePart {
            node: 0,
            parts: 2,
            motions: 1,
            ..
        }
    ));
    let all: Vec<usize> = first.into_iter().chain(second).collect();
    assert!(PartitionedBody::new(&body, &all).is_ok());
}
