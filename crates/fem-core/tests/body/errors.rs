//! What is refused, and the small bodies that are not.

use std::sync::Arc;

use nalgebra::DVector;
use stickslip_fem_core::linalg::FactorError;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{ElementKind, Mesh, MeshParts};
use stickslip_fem_core::{
    BodyError, CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Platen,
    RigidBody, Support,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Noise, joined, nearest, rectangle};
use crate::reference::{rigid_motions, stiffness_matrix, unknowns, without};

fn body(mesh: Mesh) -> ElasticBody {
    let materials: Vec<Arc<dyn Material>> = mesh.blocks().iter().map(|_| ply(0.5)).collect();
    ElasticBody::new(Arc::new(mesh), materials, THICKNESS).unwrap()
}

fn square(cells: usize) -> ElasticBody {
    body(rectangle(
        ElementKind::Q4,
        [0.0, 1.0],
        [0.0, 1.0],
        [cells, cells],
    ))
}

fn hold(nodes: &[usize], direction: HeldDirection, displacement: f64) -> Support {
    Support {
        nodes: nodes.to_vec(),
        direction,
        displacement,
    }
}

fn clamp(nodes: &[usize]) -> [Support; 2] {
    [HeldDirection::X, HeldDirection::Y].map(|direction| hold(nodes, direction, 0.0))
}

fn refusal(body: ElasticBody, interface: &[usize]) -> BodyError {
    Arc::new(body).condense(interface).unwrap_err()
}

#[test]
fn material_thickness_and_loads_are_checked() {
    let mesh = Arc::new(joined());
    let one = ElasticBody::new(Arc::clone(&mesh), vec![ply(0.5)], 1.0).unwrap_err();
    assert_eq!(
        one,
        BodyError::MaterialCount {
            materials: 1,
            blocks: 2
        }
    );
    for thickness in [0.0, -1.0, f64::INFINITY, f64::NAN] {
        let refused = ElasticBody::new(Arc::clone(&mesh), vec![ply(0.5), ply(0.5)], thickness);
        assert!(matches!(refused, Err(BodyError::Thickness(_))));
    }
    let wrong = [
        LoadCase {
            forces: vec![0.0; 3],
            ..LoadCase::default()
        },
        LoadCase {
            initial_strain: vec![[0.0; 3]; 2],
            ..LoadCase::default()
        },
        LoadCase {
            initial_strain: vec![[0.0, f64::NAN, 0.0]],
            ..LoadCase::default()
        },
        LoadCase {
            forces: vec![f64::INFINITY; 18],
            ..LoadCase::default()
        },
    ];
    for case in wrong {
        let refused = square(2).with_load_cases(vec![LoadCase::default(), case]);
        assert!(matches!(refused, Err(BodyError::LoadCase { case: 1, .. })));
    }
}

#[test]
fn nodes_and_supports_are_checked() {
    assert_eq!(
        refusal(square(2), &[4, 9]),
        BodyError::NoSuchNode { node: 9 }
    );
    assert_eq!(
        refusal(square(2), &[4, 5, 4]),
        BodyError::RepeatedNode { node: 4 }
    );
    let missing = square(2).with_supports([hold(&[11], HeldDirection::X, 0.0)]);
    assert_eq!(refusal(missing, &[]), BodyError::NoSuchNode { node: 11 });
    let missing = square(2).with_platen(Platen {
        nodes: vec![12],
        free: [true; 2],
    });
    assert_eq!(refusal(missing, &[]), BodyError::NoSuchNode { node: 12 });

    let twice = [
        hold(&[0, 3], HeldDirection::X, 0.0),
        hold(&[3], HeldDirection::X, 0.1),
    ];
    assert_eq!(
        refusal(square(2).with_supports(twice), &[]),
        BodyError::ContradictingSupports { node: 3 }
    );
    let third = hold(&[3], HeldDirection::Angle(0.7), 0.1);
    let refused = refusal(
        square(2)
            .with_supports(clamp(&[0, 3]))
            .with_supports([third]),
        &[],
    );
    assert_eq!(refused, BodyError::ContradictingSupports { node: 3 });

    for (direction, displacement) in [
        (HeldDirection::X, f64::NAN),
        (HeldDirection::Y, f64::INFINITY),
        (HeldDirection::Angle(f64::NAN), 0.0),
    ] {
        let supports = clamp(&[0])
            .into_iter()
            .chain([hold(&[3], direction, displacement)]);
        let refused = refusal(square(2).with_supports(supports), &[]);
        assert_eq!(refused, BodyError::SupportNotFinite { support: 2 });
    }
}

/// Two meshes in one, `shift` apart along x; nodes at the same place are one node.
fn two_parts(kind: ElementKind, cells: [usize; 2], shift: [f64; 2]) -> Mesh {
    let single = rectangle(kind, [0.0, 1.0], [0.0, 1.0], cells).into_parts();
    let mut parts = MeshParts {
        nodes: single.nodes.clone(),
        blocks: single.blocks.clone(),
        ..MeshParts::default()
    };
    let numbers: Vec<usize> = single
        .nodes
        .iter()
        .map(|[x, y]| {
            let moved = [x + shift[0], y + shift[1]];
            parts
                .nodes
                .iter()
                .position(|p| *p == moved)
                .unwrap_or_else(|| {
                    parts.nodes.push(moved);
                    parts.nodes.len() - 1
                })
        })
        .collect();
    let mut block = single.blocks[0].clone();
    block
        .connectivity
        .iter_mut()
        .for_each(|node| *node = numbers[*node]);
    parts.blocks.push(block);
    Mesh::new(parts).unwrap()
}

/// Meshes among them whose factorisation, by rounding, meets no pivot that is not positive.
#[test]
fn parts_that_nothing_holds_are_refused() {
    for kind in ElementKind::COMMON {
        for cells in [[1, 1], [5, 4], [10, 10], [20, 20]] {
            let mesh = two_parts(kind, cells, [1.5, 0.0]);
            let second = nearest(&mesh, [1.5, 0.0]);
            let ends = [nearest(&mesh, [0.0, 0.0]), nearest(&mesh, [1.0, 0.0])];
            let refused = refusal(body(mesh.clone()).with_supports(clamp(&ends)), &[]);
            assert!(
                matches!(refused, BodyError::LoosePart { motions: 3, .. }),
                "{kind:?} {refused}"
            );
            let hinged = body(mesh.clone()).with_supports(clamp(&[ends[0], ends[1], second]));
            assert!(matches!(
                refusal(hinged, &[]),
                BodyError::LoosePart { motions: 1, .. }
            ));
            // Three motions can be held isostatically, six cannot.
            assert!(matches!(
                refusal(body(mesh.clone()), &[]),
                BodyError::LoosePart { .. }
            ));
            let other = nearest(&mesh, [2.5, 0.0]);
            let both = body(mesh).with_supports(clamp(&[ends[0], ends[1], second, other]));
            assert!(Arc::new(both).condense(&[]).is_ok());
        }
    }
}

/// Two squares that touch at a corner turn about it; the pivot that finds this is exact on one cell each.
#[test]
fn a_hinge_is_refused() {
    let mesh = two_parts(ElementKind::Q4, [1, 1], [1.0, 1.0]);
    assert_eq!(mesh.nodes().len(), 7);
    let ends = [nearest(&mesh, [0.0, 0.0]), nearest(&mesh, [1.0, 0.0])];
    let refused = refusal(body(mesh).with_supports(clamp(&ends)), &[]);
    assert!(matches!(
        refused,
        BodyError::Factor(FactorError::NotPositiveDefinite { .. })
    ));
}

#[test]
fn a_structure_serves_only_its_own_mesh_and_supports() {
    let strip = |cells| rectangle(ElementKind::Q4, [0.0, 1.0], [0.0, 1.0], cells);
    let structure = body(strip([2, 3])).analyse(&[0]).unwrap();
    let condense = |body: ElasticBody| CondensedBody::new(Arc::new(body), Arc::clone(&structure));
    let refused = condense(body(strip([3, 2]))).unwrap_err();
    assert_eq!(
        refused,
        BodyError::OtherStructure {
            expected: 12,
            found: 12
        }
    );
    let refused = condense(body(strip([2, 3])).with_supports(clamp(&[0]))).unwrap_err();
    assert_eq!(refused, BodyError::OtherSupports);
    let platen = Platen {
        nodes: vec![0, 1],
        free: [true; 2],
    };
    let refused = condense(body(strip([2, 3])).with_platen(platen)).unwrap_err();
    assert_eq!(refused, BodyError::OtherSupports);
    assert!(condense(body(strip([2, 3]))).is_ok());
}

/// With nearly all nodes on the interface, the isostatic supports sit on it too; balanced forces are still answered by
/// displacements in equilibrium with them.
#[test]
fn an_interface_may_take_every_node() {
    let body = Arc::new(square(2));
    let forces = DVector::from_vec(Noise::new(67).vector(18));
    let stiffness = stiffness_matrix(&body);
    for taken in [9, 8, 7] {
        let interface: Vec<usize> = (0..taken).map(|k| (k + 4) % 9).collect();
        let condensed = body.condense(&interface).unwrap();
        let motions = rigid_motions(condensed.points());
        let balanced = without(&motions, &forces.rows(0, 2 * taken).into_owned());
        let mut load = DVector::zeros(18);
        for (row, k) in unknowns(&interface).into_iter().enumerate() {
            load[k] = balanced[row];
        }
        let u = DVector::from_vec(condensed.displacements(balanced.as_slice(), &[], &[0.0; 3]));
        let error = (&stiffness * &u - load).amax();
        assert!(
            error < 1e-12 * stiffness.amax() * u.amax(),
            "{taken} of 9: {error:.1e}"
        );
        assert!(condensed.compliance().unwrap().amax() < 100.0 / stiffness.amax());
    }
}

#[test]
fn bodies_with_no_or_one_unknown_are_solved() {
    let all = square(1).with_supports(clamp(&[0, 1, 2, 3]));
    let rigid = Arc::new(all).condense(&[0]).unwrap();
    assert_eq!(rigid.compliance().unwrap().amax(), 0.0);
    assert!(
        rigid
            .displacements(&[1.0, 2.0], &[], &[])
            .iter()
            .all(|&u| u == 0.0)
    );

    let one = square(1).with_supports([
        hold(&[0, 1, 2, 3], HeldDirection::X, 0.0),
        hold(&[0, 1, 2], HeldDirection::Y, 0.0),
    ]);
    let stiffness = stiffness_matrix(&one)[(7, 7)];
    let condensed = Arc::new(one).condense(&[3]).unwrap();
    let expected = 1.0 / stiffness;
    assert!(
        (condensed.compliance().unwrap()[(1, 1)] - expected).abs() < 4.0 * f64::EPSILON * expected
    );
    let u = condensed.displacements(&[5.0, 2.0], &[], &[]);
    assert!((u[7] - 2.0 * expected).abs() < 8.0 * f64::EPSILON * expected);
    assert_eq!(u[..7], [0.0; 7]);
}

#[test]
fn rigid_bodies_have_motions_but_no_compliance() {
    let points = vec![[0.0, 0.0], [1.0, 2.0]];
    let held = RigidBody::held(points.clone(), 2);
    assert_eq!((held.modes().shape(), held.load_cases()), ((4, 0), 2));
    assert!(held.compliance().is_none() && held.load_response(1).is_none());

    let sliding = RigidBody::sliding(points, [false, true], &[[3.0, 4.0], [0.0, -1.0]]);
    assert_eq!(sliding.modes().as_slice(), [0.0, 1.0, 0.0, 1.0]);
    assert_eq!(sliding.mode_load(0).as_slice(), [4.0]);
    assert_eq!(sliding.mode_load(1).as_slice(), [-1.0]);
}
