//! Bodies with one tangent per quadrature point: the ordinary ones where all tangents agree, equilibrium where they do not.

use std::sync::Arc;

use nalgebra::DVector;
use stickslip_fem_core::body::BodyError;
use stickslip_fem_core::interface::contract::{Known, check};
use stickslip_fem_core::material::{PlaneStiffness, apply};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::points::{internal_forces, strains};
use stickslip_fem_core::{
    ElasticBody, HeldDirection, InterfaceOperator, LoadCase, QuadraturePoints, Support, TangentBody,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, nearest, scattered, side_nodes};

/// Relative rounding allowed, as in the tests of condensation.
const ROUNDING: f64 = 1e-12;

/// A ply on rollers along a slanted direction at its left side, pushed at a corner, under nodal forces; and its interface.
fn body(kind: ElementKind) -> (Arc<ElasticBody>, Vec<usize>) {
    let mesh = Arc::new(scattered(kind, Distortion::Curved, 3));
    let support = |nodes: Vec<usize>, direction, displacement| Support {
        nodes,
        direction,
        displacement,
    };
    let supports = [
        support(side_nodes(&mesh, &["left"]), HeldDirection::Angle(0.3), 0.0),
        support(vec![nearest(&mesh, [1.1, -0.2])], HeldDirection::Y, 0.3),
    ];
    let cases = vec![
        LoadCase {
            forces: Noise::new(5).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
    ];
    let interface = side_nodes(&mesh, &["top"]);
    let body = ElasticBody::new(mesh, vec![ply(0.5)], THICKNESS)
        .unwrap()
        .with_supports(supports)
        .with_load_cases(cases)
        .unwrap();
    (Arc::new(body), interface)
}

fn largest(values: impl IntoIterator<Item = f64>) -> f64 {
    values.into_iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// Tangents that differ from point to point, symmetric and positive definite.
fn scattered_tangents(count: usize) -> Vec<PlaneStiffness> {
    let mut noise = Noise::new(8);
    let material = ply(0.5).stiffness();
    let tangent = |_| {
        let [a, b, c] = [0, 1, 2].map(|_| 1.0 + 0.4 * noise.next());
        let scale = [a, b, c];
        let mut d = material;
        for (i, row) in d.iter_mut().enumerate() {
            for (j, value) in row.iter_mut().enumerate() {
                *value *= scale[i] * scale[j];
            }
        }
        d
    };
    (0..count).map(tangent).collect()
}

#[test]
fn equal_tangents_make_the_ordinary_body() {
    for kind in ElementKind::COMMON {
        let (body, interface) = body(kind);
        let ordinary = body.condense(&interface).unwrap();
        let count = QuadraturePoints::of(body.mesh()).count();
        let tangents = vec![ply(0.5).stiffness(); count];
        let structure = Arc::clone(ordinary.structure());
        let tangent = TangentBody::new(Arc::clone(&body), structure, tangents).unwrap();
        let ours = tangent.condensed();
        let (a, b) = (ordinary.compliance().unwrap(), ours.compliance().unwrap());
        assert!((a - b).amax() <= ROUNDING * a.amax(), "{kind:?}");
        for case in 0..2 {
            let (a, b) = (ordinary.load_response(case), ours.load_response(case));
            let (a, b) = (a.unwrap(), b.unwrap());
            assert!((a - b).amax() <= ROUNDING * a.amax(), "{kind:?}");
        }
    }
}

/// From any state with any stresses the linearised body finds the displacement at which the stresses, carried on along the
/// tangents, balance loads, interface forces and driven supports; and its interface moves as the operator says.
#[test]
fn a_linearised_body_is_in_equilibrium() {
    for kind in ElementKind::COMMON {
        let (body, interface) = body(kind);
        let mesh: &Mesh = body.mesh();
        let structure = body.analyse(&interface).unwrap();
        let count = QuadraturePoints::of(mesh).count();
        let tangents = scattered_tangents(count);
        let mut noise = Noise::new(21);
        let start = noise.vector(2 * mesh.nodes().len());
        let before = strains(mesh, &start);
        let size = ply(0.5).stiffness()[1][1];
        let stress: Vec<[f64; 3]> = (0..count)
            .map(|_| [0, 1, 2].map(|_| size * noise.next()))
            .collect();
        let forces: Vec<f64> = noise.vector(2 * interface.len());
        let forces: Vec<f64> = forces.iter().map(|f| f * size).collect();
        let multipliers = [0.7 * size, 1.3];

        let tangent = TangentBody::new(Arc::clone(&body), structure, tangents).unwrap();
        let tangent = Arc::new(tangent);
        let linear = tangent.about(&before, &stress).unwrap();
        let known = Known {
            placed: true,
            resultants: &[],
        };
        assert_eq!(check(&linear, known), Ok(()), "{kind:?}");
        let u = linear.displacements(&forces, &multipliers, &[]);
        let after: Vec<[f64; 3]> = (strains(mesh, &u).iter().zip(&before))
            .zip(tangent.tangents().iter().zip(&stress))
            .map(|((new, old), (d, s))| {
                let change = apply(d, [0, 1, 2].map(|i| new[i] - old[i]));
                [0, 1, 2].map(|i| s[i] + change[i])
            })
            .collect();
        let mut rest = internal_forces(mesh, THICKNESS, &after);
        let scale = largest(rest.iter().copied());
        for (total, force) in rest.iter_mut().zip(&body.load_cases()[0].forces) {
            *total -= multipliers[0] * force;
        }
        for (force, node) in forces.chunks_exact(2).zip(&interface) {
            rest[2 * node] -= force[0];
            rest[2 * node + 1] -= force[1];
        }
        let structure = tangent.condensed().structure();
        let left = structure.largest_on_unknowns(&rest);
        assert!(
            left <= 10.0 * ROUNDING * scale,
            "{kind:?}: {left:e} of {scale:e}"
        );

        let mut expected = linear.compliance().unwrap() * DVector::from_vec(forces);
        assert_eq!(linear.load_cases(), 3);
        for (case, factor) in multipliers.iter().chain(&[1.0]).enumerate() {
            expected += linear.load_response(case).unwrap() * *factor;
            assert!(linear.mode_load(case).is_empty());
        }
        let moved = interface
            .iter()
            .flat_map(|&node| [u[2 * node], u[2 * node + 1]]);
        let off = largest(moved.zip(expected.iter()).map(|(a, b)| a - b));
        assert!(
            off <= 10.0 * ROUNDING * expected.amax(),
            "{kind:?}: {off:e}"
        );

        let driven = structure.support_motion();
        let pushed = nearest(mesh, [1.1, -0.2]);
        assert!((driven[2 * pushed + 1] - 0.3).abs() < 1e-15);
        assert!((largest(driven.iter().copied()) - 0.3).abs() < 1e-15);
    }
}

/// Virtual work of any stress on any displacement, and the area of the mesh.
#[test]
fn points_carry_area_strain_and_work() {
    for kind in ElementKind::COMMON {
        let mesh = scattered(kind, Distortion::Curved, 17);
        let points = QuadraturePoints::of(&mesh);
        let mut noise = Noise::new(2);
        let u = noise.vector(2 * mesh.nodes().len());
        let stress: Vec<[f64; 3]> = (0..points.count())
            .map(|_| [0, 1, 2].map(|_| noise.next()))
            .collect();
        let forces = internal_forces(&mesh, THICKNESS, &stress);
        let outside: f64 = forces.iter().zip(&u).map(|(f, u)| f * u).sum();
        let strain = strains(&mesh, &u);
        let inside: f64 = (0..points.count())
            .map(|q| {
                let work: f64 = (0..3).map(|i| stress[q][i] * strain[q][i]).sum();
                THICKNESS * points.areas()[q] * work
            })
            .sum();
        assert!(
            (outside - inside).abs()
                <= 1e-12
                    * largest(u.iter().copied())
                    * largest(forces.iter().copied())
                    * u.len() as f64
        );
        let cells: f64 = (0..points.cell_count())
            .map(|cell| points.cell_area(cell))
            .sum();
        assert!((cells / points.areas().iter().sum::<f64>() - 1.0).abs() < 1e-14);
        let last = points.count() - 1;
        assert_eq!(points.cell(last), points.cell_count() - 1);
        assert!(points.of_cell(points.cell(last)).contains(&last));
        let field = |x: [f64; 2]| [2.0 * x[0] - x[1], 0.5 * x[0] + 3.0 * x[1]];
        let linear: Vec<f64> = mesh.nodes().iter().flat_map(|&x| field(x)).collect();
        for strain in strains(&mesh, &linear) {
            let off = [strain[0] - 2.0, strain[1] - 3.0, strain[2] + 0.5];
            assert!(largest(off) < 1e-12);
        }
    }
}

#[test]
fn wrong_counts_and_initial_strains_are_refused() {
    let (body, interface) = body(ElementKind::Q4);
    let structure = body.analyse(&interface).unwrap();
    let count = QuadraturePoints::of(body.mesh()).count();
    let few = vec![ply(0.5).stiffness(); count - 1];
    let refused = TangentBody::new(Arc::clone(&body), Arc::clone(&structure), few);
    let expected = BodyError::PointCount {
        what: "tangents",
        expected: count,
        found: count - 1,
    };
    assert_eq!(refused.unwrap_err(), expected);
    let tangents = vec![ply(0.5).stiffness(); count];
    let made = TangentBody::new(Arc::clone(&body), Arc::clone(&structure), tangents.clone());
    let made = Arc::new(made.unwrap());
    assert!(made.about(&[], &vec![[0.0; 3]; count]).is_err());
    assert!(made.about(&vec![[0.0; 3]; count], &[]).is_err());
    let strained = ElasticBody::clone(&body)
        .with_load_cases(vec![LoadCase {
            initial_strain: vec![[1e-3; 3]],
            ..LoadCase::default()
        }])
        .unwrap();
    let refused = TangentBody::new(Arc::new(strained), Arc::clone(&structure), tangents.clone());
    assert!(matches!(refused, Err(BodyError::LoadCase { case: 2, .. })));
    let lost = vec![[[0.0; 3]; 3]; count];
    assert!(matches!(
        TangentBody::new(body, structure, lost),
        Err(BodyError::Factor(_))
    ));
}
