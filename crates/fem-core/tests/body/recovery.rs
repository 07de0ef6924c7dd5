//! Fields from the interface, and the same bits however they are computed.

use std::sync::Arc;

use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::material::Material;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{
    CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support,
};

use crate::fields::{THICKNESS, materials, ply};
use crate::meshes::{Distortion, Noise, nearest, rectangle, scattered, side_nodes};
use crate::reference::{largest, resultants};

const ROUNDING: f64 = 1e-12;

/// A body with skew supports under forces, heat and support movement.
fn supported(kind: ElementKind, material: Arc<dyn Material>) -> ElasticBody {
    let mesh = scattered(kind, Distortion::Curved, 43);
    let (left, corner) = (side_nodes(&mesh, &["left"]), nearest(&mesh, [1.1, -0.2]));
    let cases = vec![
        LoadCase {
            forces: Noise::new(47).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase {
            initial_strain: vec![[2e-3, -1e-3, 3e-3]],
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
    ];
    let hold = |nodes: Vec<usize>, angle, displacement| Support {
        nodes,
        direction: HeldDirection::Angle(angle),
        displacement,
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![material], THICKNESS).unwrap();
    let supports = [hold(left, 0.3, 0.01), hold(vec![corner], 1.4, -0.02)];
    body.with_supports(supports).with_load_cases(cases).unwrap()
}

#[test]
fn recovered_fields_are_in_equilibrium() {
    for kind in ElementKind::COMMON {
        for material in materials() {
            let body = Arc::new(supported(kind, material));
            let mesh = body.mesh();
            let (left, corner) = (side_nodes(mesh, &["left"]), nearest(mesh, [1.1, -0.2]));
            let interface = side_nodes(mesh, &["top", "right"]);
            let condensed = body.condense(&interface).unwrap();
            let lambda = Noise::new(53).vector(2 * interface.len());
            let multipliers = [1.0, 0.5, -1.5];
            let u = condensed.displacements(&lambda, &multipliers, &[]);
            let residual = condensed.residual_forces(&u, &lambda, &multipliers);
            // Rounding of K u is relative to its terms, of which heat and forced displacements are the largest.
            let terms = largest(&u) * largest(crate::reference::stiffness_matrix(&body).as_slice());
            for (node, force) in residual.chunks_exact(2).enumerate() {
                let size = force[0].hypot(force[1]);
                let across = |angle: f64| (force[1] * angle.cos() - force[0] * angle.sin()).abs();
                let free = match node {
                    _ if node == corner => across(1.4),
                    _ if left.contains(&node) => across(0.3),
                    _ => size,
                };
                assert!(free < ROUNDING * terms, "{kind:?}, node {node}: {free:.1e}");
            }
            assert!(
                condensed.relative_imbalance(&residual, &lambda, &multipliers)
                    < ROUNDING * terms.max(1.0)
            );

            // Reactions balance forces and interface forces; heat has no resultant.
            let applied = resultants(mesh.nodes(), &body.load_cases()[0].forces);
            let contact = resultants(condensed.points(), &lambda);
            let reaction = resultants(mesh.nodes(), &residual);
            for i in 0..3 {
                let sum = applied[i] + contact[i] + reaction[i];
                assert!(
                    sum.abs() < 10.0 * ROUNDING * terms,
                    "{kind:?}: {sum:.1e} of {terms:.1e}"
                );
            }
        }
    }
}

/// A state loaded a billion times less is balanced by a thousandth of the history's load: its rounding does not grow into a defect.
#[test]
fn balance_has_a_floor_in_the_most_loaded_state() {
    let body = Arc::new(supported(ElementKind::Q8, ply(0.5)));
    let interface = side_nodes(body.mesh(), &["top", "right"]);
    let condensed = body.condense(&interface).unwrap();
    let lambda = Noise::new(53).vector(2 * interface.len());
    let little: Vec<f64> = lambda.iter().map(|force| 1e-9 * force).collect();
    let state = |forces| BodyLoad {
        forces,
        multipliers: &[0.0; 3],
        motions: &[],
    };
    let states = [state(&lambda[..]), state(&little[..])];
    let displacements = condensed.displacements_of(&states);
    let residuals = condensed.residual_forces_of(&displacements, &states);
    let alone = condensed.balances_of(&residuals[1..], &displacements[1..], &states[1..])[0];
    let both = condensed.balances_of(&residuals, &displacements, &states);
    assert_eq!(both[1].reaction, alone.reaction);
    for (of_both, of_one) in [
        (both[1].force, alone.force),
        (both[1].moment, alone.moment),
        (both[1].nodal, alone.nodal),
    ] {
        // Two roundings of the scale.
        assert!((of_both - 1e-6 * of_one).abs() <= 1e-14 * 1e-6 * of_one);
        assert!(of_both < 1e-15);
    }
    assert!(both[0].force.max(both[0].moment).max(both[0].nodal) < 1e-10);
}

/// Every number that a contact solver can ask for, bit by bit.
fn bits(condensed: &CondensedBody) -> Vec<u64> {
    let lambda = Noise::new(59).vector(2 * condensed.interface_nodes().len());
    let multipliers = vec![1.0; condensed.load_cases()];
    let motions = vec![0.5; condensed.modes().ncols()];
    let mut numbers = condensed.displacements(&lambda, &multipliers, &motions);
    numbers.extend(condensed.compliance().unwrap());
    numbers.extend(condensed.modes());
    for case in 0..condensed.load_cases() {
        numbers.extend(condensed.load_response(case).unwrap());
        numbers.extend(condensed.mode_load(case));
    }
    numbers.iter().map(|number| number.to_bits()).collect()
}

#[test]
fn a_reused_structure_changes_no_bit() {
    for kind in ElementKind::COMMON {
        let first = Arc::new(supported(kind, ply(0.5)));
        let interface = side_nodes(first.mesh(), &["top", "right"]);
        let structure = first.analyse(&interface).unwrap();
        for material in materials() {
            // The mesh is another allocation, equal in all numbers.
            let body = Arc::new(supported(kind, material));
            let reused = CondensedBody::new(Arc::clone(&body), Arc::clone(&structure)).unwrap();
            let fresh = body.condense(&interface).unwrap();
            assert_eq!(bits(&reused), bits(&fresh), "{kind:?}");
            assert!(Arc::ptr_eq(reused.structure(), &structure));
        }
    }
}

#[test]
fn the_number_of_threads_changes_no_bit() {
    for kind in [ElementKind::T3, ElementKind::Q4, ElementKind::Q8] {
        // More cells than are assembled at once.
        let mesh = rectangle(kind, [0.0, 3.0], [0.0, 1.0], [72, 32]);
        let interface = side_nodes(&mesh, &["right"]);
        let case = LoadCase {
            forces: Noise::new(61).vector(2 * mesh.nodes().len()),
            initial_strain: vec![[2e-3, -1e-3, 3e-3]],
            ..LoadCase::default()
        };
        let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS).unwrap();
        let body = Arc::new(body.with_load_cases(vec![case]).unwrap());
        let run = |threads| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| bits(&body.condense(&interface).unwrap()))
        };
        let alone = run(1);
        assert!(
            [2, 3].into_iter().all(|threads| run(threads) == alone),
            "{kind:?}"
        );
    }
}
