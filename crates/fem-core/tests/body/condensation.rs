//! The interface operator of a held body is the dense Schur complement.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{
    CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, nearest, scattered, side_nodes};
use crate::reference::{schur_complement, solve, stiffness_matrix, unknowns};

/// Relative rounding allowed: condition numbers of the matrices here are below 10⁴, those of the reference included.
const ROUNDING: f64 = 1e-12;

/// Displacement of the right end of the bottom side along y in the load case that moves the supports.
const PUSH: f64 = 0.3;

struct Held {
    body: Arc<ElasticBody>,
    /// Unknowns that the supports hold, at which displacement.
    supports: Vec<(usize, f64)>,
    interface: Vec<usize>,
}

/// A ply clamped at its left side, with the bottom's right end pushed along y, under nodal forces, under a thermal
/// strain and under the push alone. The interface is the top side walked backwards and a node inside, so that its order is
/// not the mesh's and its left end is held.
fn held(kind: ElementKind) -> Held {
    let mesh = scattered(kind, Distortion::Curved, 11);
    let left = side_nodes(&mesh, &["left"]);
    let pushed = nearest(&mesh, [1.1, -0.2]);
    let mut interface = side_nodes(&mesh, &["top"]);
    interface.reverse();
    interface.push(nearest(&mesh, [0.6, 0.4]));
    let mut supports: Vec<(usize, f64)> = unknowns(&left).iter().map(|&k| (k, 0.0)).collect();
    supports.push((2 * pushed + 1, PUSH));

    let support = |nodes: &[usize], direction, displacement| Support {
        nodes: nodes.to_vec(),
        direction,
        displacement,
    };
    let cases = vec![
        LoadCase {
            forces: Noise::new(5).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase {
            initial_strain: vec![[1e-3, -2e-3, 3e-3]],
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
        LoadCase::default(),
    ];
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS)
        .unwrap()
        .with_supports([
            support(&left, HeldDirection::X, 0.0),
            support(&left, HeldDirection::Y, 0.0),
            support(&[pushed], HeldDirection::Y, PUSH),
        ])
        .with_load_cases(cases)
        .unwrap();
    Held {
        body: Arc::new(body),
        supports,
        interface,
    }
}

impl Held {
    fn condense(&self) -> CondensedBody {
        self.body.condense(&self.interface).unwrap()
    }

    /// Displacement of all unknowns under load case `case` by dense algebra.
    fn reference(&self, case: usize) -> DVector<f64> {
        let matrix = stiffness_matrix(&self.body);
        let load = &self.body.load_cases()[case];
        let mut forces = DVector::zeros(matrix.nrows());
        if !load.forces.is_empty() {
            forces = DVector::from_column_slice(&load.forces);
        }
        if !load.initial_strain.is_empty() {
            // The forces that hold u = ε₀ x: linear, so the cells contain it exactly.
            let [xx, yy, xy] = load.initial_strain[0];
            let nodes = self.body.mesh().nodes().iter();
            let u = nodes.flat_map(|&[x, y]| [xx * x + xy * y, yy * y]);
            forces += &matrix * DVector::from_iterator(matrix.nrows(), u);
        }
        let scale = if load.moves_supports { 1.0 } else { 0.0 };
        let supports: Vec<_> = self.supports.iter().map(|&(k, u)| (k, scale * u)).collect();
        solve(&matrix, &forces, &supports)
    }
}

#[test]
fn compliance_inverts_the_schur_complement() {
    for kind in ElementKind::COMMON {
        let held = held(kind);
        let condensed = held.condense();
        let compliance = condensed.compliance().unwrap();
        assert_eq!(
            *compliance,
            compliance.transpose(),
            "symmetric to the last bit"
        );
        assert_eq!(condensed.modes().shape(), (2 * held.interface.len(), 0));

        let fixed: Vec<usize> = held.supports.iter().map(|&(k, _)| k).collect();
        let all = unknowns(&held.interface);
        let (open, closed): (Vec<usize>, Vec<usize>) =
            (0..all.len()).partition(|&k| !fixed.contains(&all[k]));
        assert_eq!(closed.len(), 2, "the top's left end is clamped");
        for &k in &closed {
            assert_eq!(compliance.row(k).amax(), 0.0);
            assert_eq!(compliance.column(k).amax(), 0.0);
        }
        let kept: Vec<usize> = open.iter().map(|&k| all[k]).collect();
        let schur = schur_complement(&stiffness_matrix(&held.body), &kept, &fixed);
        let product = crate::reference::part(compliance, &open, &open) * &schur;
        let identity = DMatrix::<f64>::identity(kept.len(), kept.len());
        // Each entry of the product sums terms as large as |C| |S|.
        let scale = compliance.amax() * schur.amax();
        assert!((product - identity).amax() < ROUNDING * scale, "{kind:?}");
    }
}

#[test]
fn responses_are_those_of_the_whole_body() {
    for kind in ElementKind::COMMON {
        let held = held(kind);
        let condensed = held.condense();
        assert_eq!(condensed.load_cases(), 4);
        for case in 0..3 {
            let reference = held.reference(case);
            let response = condensed.load_response(case).unwrap();
            for (row, k) in unknowns(&held.interface).into_iter().enumerate() {
                let error = (response[row] - reference[k]).abs();
                assert!(error < ROUNDING * reference.amax(), "{kind:?}, case {case}");
            }
            assert_eq!(condensed.mode_load(case).len(), 0);
        }
        assert_eq!(
            condensed.load_response(3),
            None,
            "the last case loads nothing"
        );
    }
}

/// Fields inside are those of forces and load cases together, and agree at the interface with C λ + Σ m u.
#[test]
fn displacements_superpose() {
    for kind in ElementKind::COMMON {
        let held = held(kind);
        let condensed = held.condense();
        let lambda = DVector::from_vec(Noise::new(9).vector(2 * held.interface.len()));
        let multipliers = [0.7, -1.3, 2.0, 5.0];
        let u = condensed.displacements(lambda.as_slice(), &multipliers, &[]);

        let mut at_interface = condensed.compliance().unwrap() * &lambda;
        let mut forces = DVector::zeros(u.len());
        for (row, k) in unknowns(&held.interface).into_iter().enumerate() {
            forces[k] = lambda[row];
        }
        let fixed: Vec<_> = held.supports.iter().map(|&(k, _)| (k, 0.0)).collect();
        let mut reference = solve(&stiffness_matrix(&held.body), &forces, &fixed);
        for case in 0..3 {
            at_interface += condensed.load_response(case).unwrap() * multipliers[case];
            reference += held.reference(case) * multipliers[case];
        }
        let error = (DVector::from_column_slice(&u) - &reference).amax();
        assert!(error < ROUNDING * reference.amax(), "{kind:?}: {error:.1e}");
        for (row, k) in unknowns(&held.interface).into_iter().enumerate() {
            assert!(
                (at_interface[row] - u[k]).abs() < ROUNDING * reference.amax(),
                "{kind:?}"
            );
        }
    }
}

/// Two materials glued along a line of nodes, one of them of triangles.
#[test]
fn blocks_of_different_kinds_and_materials_join() {
    let mesh = crate::meshes::joined();
    let left = side_nodes(&mesh, &["left"]);
    let hold = |direction| Support {
        nodes: left.clone(),
        direction,
        displacement: 0.0,
    };
    let interface = side_nodes(&mesh, &["right"]);
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.2), ply(-1.0)], THICKNESS).unwrap();
    let body = Arc::new(body.with_supports([hold(HeldDirection::X), hold(HeldDirection::Y)]));
    let condensed = body.condense(&interface).unwrap();
    let (kept, fixed) = (unknowns(&interface), unknowns(&left));
    let schur = schur_complement(&stiffness_matrix(&body), &kept, &fixed);
    let compliance = condensed.compliance().unwrap();
    let error = (compliance * &schur - DMatrix::identity(kept.len(), kept.len())).amax();
    assert!(
        error < ROUNDING * compliance.amax() * schur.amax(),
        "{error:.1e}"
    );
}
