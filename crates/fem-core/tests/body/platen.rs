//! Rigid platens: their nodes move together without turning, and carry what balances the body.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{
    BodyError, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Platen, Support,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, scattered, side_nodes};
use crate::reference::{largest, resultants, rigid_motions, stiffness_matrix, unknowns, without};

const ROUNDING: f64 = 1e-12;

fn with_platen(kind: ElementKind, free: [bool; 2]) -> ElasticBody {
    let mesh = scattered(kind, Distortion::Straight, 19);
    let nodes = side_nodes(&mesh, &["right"]);
    let forces = Noise::new(23).vector(2 * mesh.nodes().len());
    let case = LoadCase {
        forces,
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS).unwrap();
    body.with_platen(Platen { nodes, free })
        .with_load_cases(vec![case])
        .unwrap()
}

/// Displacements when all platen nodes share the free translations: Tᵀ K T q = Tᵀ f, in which the translations have no
/// stiffness of their own, so one solution is found by least norm.
fn tied(
    body: &ElasticBody,
    platen: &[usize],
    free: [bool; 2],
    forces: &DVector<f64>,
) -> DVector<f64> {
    let matrix = stiffness_matrix(body);
    let fixed = unknowns(platen);
    let mut columns: Vec<DVector<f64>> = Vec::new();
    for k in (0..matrix.nrows()).filter(|k| !fixed.contains(k)) {
        columns.push(DVector::from_fn(matrix.nrows(), |row, _| {
            if row == k { 1.0 } else { 0.0 }
        }));
    }
    for axis in (0..2).filter(|&axis| free[axis]) {
        let moves = |row: usize| row % 2 == axis && platen.contains(&(row / 2));
        columns.push(DVector::from_fn(matrix.nrows(), |row, _| {
            if moves(row) { 1.0 } else { 0.0 }
        }));
    }
    let tie = DMatrix::from_columns(&columns);
    let reduced = tie.transpose() * matrix * &tie;
    let eigen = nalgebra::SymmetricEigen::new(reduced);
    let side = tie.transpose() * forces;
    let threshold = 1e-10 * eigen.eigenvalues.amax();
    let mut solution = DVector::zeros(side.len());
    for (vector, &value) in eigen.eigenvectors.column_iter().zip(&eigen.eigenvalues) {
        if value > threshold {
            solution += vector * (vector.dot(&side) / value);
        }
    }
    tie * solution
}

#[test]
fn a_platen_moves_as_one_and_carries_the_rest() {
    for kind in ElementKind::COMMON {
        for free in [[true, false], [false, true], [true, true], [false, false]] {
            let body = Arc::new(with_platen(kind, free));
            let interface = side_nodes(body.mesh(), &["left"]);
            let platen = side_nodes(body.mesh(), &["right"]);
            let condensed = body.condense(&interface).unwrap();
            let axes: Vec<usize> = (0..2).filter(|&axis| free[axis]).collect();
            assert_eq!(condensed.modes().ncols(), axes.len());

            // Forces on the left side that balance the load along the free axes; the modes there are unit translations.
            let mut lambda = Noise::new(29).vector(2 * interface.len());
            let load = &body.load_cases()[0].forces;
            let total = resultants(body.mesh().nodes(), load);
            for (mode, &axis) in axes.iter().enumerate() {
                assert!(
                    (condensed.mode_load(0)[mode] - total[axis]).abs()
                        < ROUNDING * load.len() as f64
                );
                let sum: f64 = lambda.iter().skip(axis).step_by(2).sum();
                let correction = (sum + total[axis]) / interface.len() as f64;
                lambda
                    .iter_mut()
                    .skip(axis)
                    .step_by(2)
                    .for_each(|force| *force -= correction);
            }
            let motions: Vec<f64> = axes.iter().map(|&axis| 0.1 + axis as f64).collect();
            let u = condensed.displacements(&lambda, &[1.0], &motions);
            for &node in &platen {
                for axis in 0..2 {
                    let expected = axes
                        .iter()
                        .position(|&a| a == axis)
                        .map_or(0.0, |m| motions[m]);
                    assert_eq!(u[2 * node + axis], expected);
                }
            }

            let mut forces = DVector::from_column_slice(load);
            for (row, k) in unknowns(&interface).into_iter().enumerate() {
                forces[k] += lambda[row];
            }
            let reference = tied(&body, &platen, free, &forces);
            let translations = rigid_motions(body.mesh().nodes())
                .columns(0, 2)
                .into_owned();
            let difference = DVector::from_column_slice(&u) - &reference;
            let strange = if axes.is_empty() {
                difference
            } else {
                without(&translations, &difference)
            };
            assert!(
                strange.amax() < 10.0 * ROUNDING * reference.amax(),
                "{kind:?} {free:?}"
            );

            check_reactions(
                &condensed.residual_forces(&u, &lambda, &[1.0]),
                &body,
                &platen,
                free,
                &forces,
            );
        }
    }
}

/// Only platen nodes carry reactions; they balance the load, and have no resultant along a free axis.
fn check_reactions(
    reactions: &[f64],
    body: &ElasticBody,
    platen: &[usize],
    free: [bool; 2],
    load: &DVector<f64>,
) {
    let scale = ROUNDING * load.amax() * load.len() as f64;
    for (k, reaction) in reactions.iter().enumerate() {
        assert!(platen.contains(&(k / 2)) || reaction.abs() < scale);
    }
    let applied = resultants(body.mesh().nodes(), load.as_slice());
    let carried = resultants(body.mesh().nodes(), reactions);
    for i in 0..3 {
        assert!(
            (applied[i] + carried[i]).abs() < scale,
            "{applied:?} {carried:?}"
        );
    }
    for axis in (0..2).filter(|&axis| free[axis]) {
        assert!(carried[axis].abs() < scale);
    }
    assert!(largest(reactions) > 0.01 * load.amax());
}

/// On a half body the ends of the symmetry line belong to the platen too, held in the same direction.
#[test]
fn a_support_may_share_nodes_with_a_platen_that_does_not_move_there() {
    let symmetry = |body: &ElasticBody| Support {
        nodes: side_nodes(body.mesh(), &["bottom"]),
        // The bottom side runs along (1.3, −0.2).
        direction: HeldDirection::Angle(1.3_f64.atan2(0.2)),
        displacement: 0.0,
    };
    let along_x = |displacement| Support {
        nodes: vec![0],
        direction: HeldDirection::X,
        displacement,
    };

    let held = with_platen(ElementKind::Q8, [false, false]);
    let support = symmetry(&held);
    let condensed = Arc::new(held.with_supports([support]))
        .condense(&[])
        .unwrap();
    assert_eq!(condensed.modes().ncols(), 0);

    let upwards = with_platen(ElementKind::Q8, [false, true]).with_supports([along_x(0.0)]);
    let interface = side_nodes(upwards.mesh(), &["top"]);
    assert_eq!(
        Arc::new(upwards)
            .condense(&interface)
            .unwrap()
            .modes()
            .ncols(),
        1
    );

    let sideways = with_platen(ElementKind::Q8, [true, false]).with_supports([along_x(0.0)]);
    let refused = Arc::new(sideways).condense(&[]).unwrap_err();
    assert_eq!(refused, BodyError::PlatenResisted { free: 1, left: 0 });

    let body = with_platen(ElementKind::Q8, [true, false]);
    let support = symmetry(&body);
    let refused = Arc::new(body.with_supports([support]))
        .condense(&[])
        .unwrap_err();
    assert!(
        matches!(refused, BodyError::ContradictingSupports { .. }),
        "{refused}"
    );

    let moved = with_platen(ElementKind::Q8, [false, false]);
    let node = side_nodes(moved.mesh(), &["right"])[0];
    let support = Support {
        nodes: vec![node],
        direction: HeldDirection::X,
        displacement: 0.1,
    };
    let refused = Arc::new(moved.with_supports([support]))
        .condense(&[])
        .unwrap_err();
    assert_eq!(refused, BodyError::ContradictingSupports { node });
}

/// A platen glued to one node cannot keep the body from turning about it.
#[test]
fn a_platen_needs_two_nodes() {
    let body = with_platen(ElementKind::Q4, [true, true]);
    let body = body.with_platen(Platen {
        nodes: vec![3],
        free: [true, true],
    });
    let refused = Arc::new(body).condense(&[]).unwrap_err();
    assert!(matches!(
        refused,
        BodyError::LoosePart {
            node: 0,
            motions: 1,
            ..
        }
    ));
}
