//! Patch tests: fields that a cell can represent come back to rounding.
//!
//! An isoparametric cell of any shape contains the linear displacements, and its quadrature integrates ∫ Bᵀσ dA of a
//! constant stress exactly, so they return on curved cells too. A quadratic displacement returns where the cell contains it
//! and ∫ Bᵀσ dA of a linear stress is integrated exactly: straight-sided T6 and Q9, and Q8 that are parallelograms.

use std::sync::Arc;

use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::stress::ElasticField;
use stickslip_fem_core::{HeldDirection, InterfaceOperator};

use crate::fields::{Field, both, driven, linear, materials, quadratic};
use crate::meshes::{Distortion, SIDES, mapped, nearest, rectangle, scattered, side_nodes};

/// Relative error allowed: the stiffness matrices of cells of order 1 and 2 have condition numbers below 10⁴ here, which grow with the cube of
/// the order (Bernardi and Maday 1997, spectral methods on Gauss–Lobatto nodes).
fn rounding(mesh: &Mesh) -> f64 {
    1e-12 * (mesh.element(0).0.order() as f64 / 2.0).max(1.0).powi(3)
}

fn largest(values: &[f64]) -> f64 {
    values.iter().fold(0.0, |m, v| m.max(v.abs()))
}

/// Nodes held, each in a direction, and sides with tractions.
type Boundary = (Vec<(usize, HeldDirection)>, Vec<&'static str>);

/// The ways to impose a field on a mesh: displacements all around; tractions all around and an isostatic support;
/// displacements on one side and tractions on the rest.
fn boundary_conditions(mesh: &Mesh) -> [Boundary; 3] {
    let first = nearest(mesh, [-0.2, 0.0]);
    let second = nearest(mesh, [1.1, -0.2]);
    let isostatic = vec![
        (first, HeldDirection::X),
        (first, HeldDirection::Angle(1.2)),
        (second, HeldDirection::Y),
    ];
    [
        (both(&side_nodes(mesh, &SIDES)), vec![]),
        (isostatic, SIDES.to_vec()),
        (
            both(&side_nodes(mesh, &["left"])),
            vec!["bottom", "right", "top"],
        ),
    ]
}

fn check(mesh: &Mesh, material: &Arc<dyn Material>, field: &Field, what: &str) {
    let exact = field.at_nodes(mesh);
    let scale = largest(&exact);
    let allowed = rounding(mesh) * scale;
    for (held, pulled) in boundary_conditions(mesh) {
        let body = driven(mesh.clone(), Arc::clone(material), field, &held, &pulled);
        let interface: Vec<usize> = (0..mesh.nodes().len()).step_by(3).collect();
        let condensed = body.condense(&interface).unwrap();
        let no_force = vec![0.0; 2 * interface.len()];
        let u = condensed.displacements(&no_force, &[1.0], &[]);
        let error = u
            .iter()
            .zip(&exact)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(
            error < allowed,
            "{what}, {pulled:?}: {error:.1e} of {scale:.1e}"
        );

        let response = condensed.load_response(0).unwrap();
        for (point, &node) in interface.iter().enumerate() {
            for i in 0..2 {
                let error = (response[2 * point + i] - exact[2 * node + i]).abs();
                assert!(error < allowed, "{what}, {pulled:?}, node {node}");
            }
        }
        check_stress(mesh, material.as_ref(), &u, field, what);
    }
}

fn check_stress(mesh: &Mesh, material: &dyn Material, u: &[f64], field: &Field, what: &str) {
    let materials = [material];
    let solution = ElasticField::new(mesh, &materials, u, None).unwrap();
    let exact_u = field.at_nodes(mesh);
    let exact = ElasticField::new(mesh, &materials, &exact_u, None).unwrap();
    let (found, expected) = (solution.gauss_stresses(), exact.gauss_stresses());
    let values = || expected.values().iter().flatten();
    let scale = values().fold(0.0_f64, |m, v| m.max(v.abs()));
    for (a, b) in found.values().iter().flatten().zip(values()) {
        // A gradient loses the ratio of the body's to a cell's size, here up to ten.
        assert!(
            (a - b).abs() < 10.0 * rounding(mesh) * scale,
            "{what}: {a} for {b}"
        );
    }
}

#[test]
fn linear_fields_return_on_distorted_cells() {
    for kind in ElementKind::ALL {
        for (k, material) in materials().iter().enumerate() {
            let field = linear(&material.stiffness());
            for distortion in [Distortion::Straight, Distortion::Curved] {
                let mesh = scattered(kind, distortion, 7 + k as u64);
                let what = format!("{kind:?}, material {k}, {distortion:?}");
                check(&mesh, material, &field, &what);
            }
        }
    }
}

#[test]
fn quadratic_fields_return_where_the_cells_contain_them() {
    for (k, material) in materials().iter().enumerate() {
        let field = quadratic(material.as_ref());
        let parallelograms = mapped(
            rectangle(ElementKind::Q8, [0.0, 1.0], [0.0, 1.0], [4, 3]),
            |[x, y]| [1.3 * x + 0.4 * y - 0.2, 0.9 * y - 0.2 * x],
        );
        check(
            &parallelograms,
            material,
            &field,
            &format!("Q8, material {k}"),
        );
        for kind in [ElementKind::T6, ElementKind::Q9] {
            let mesh = scattered(kind, Distortion::Straight, 3);
            check(&mesh, material, &field, &format!("{kind:?}, material {k}"));
        }
    }
}

/// A serendipity cell that is not a parallelogram lacks ξ²η², hence some quadratics: the limits of the test above.
#[test]
fn quadratic_fields_do_not_return_on_trapezoidal_q8() {
    let material = &materials()[0];
    let field = quadratic(material.as_ref());
    let mesh = scattered(ElementKind::Q8, Distortion::Straight, 3);
    let body = driven(
        mesh.clone(),
        Arc::clone(material),
        &field,
        &both(&side_nodes(&mesh, &SIDES)),
        &[],
    );
    let u = body.condense(&[]).unwrap().displacements(&[], &[1.0], &[]);
    let exact = field.at_nodes(&mesh);
    let error = u
        .iter()
        .zip(&exact)
        .map(|(a, b)| (a - b).abs())
        .fold(0.0, f64::max);
    assert!(error > 1e-5 * largest(&exact));
}
