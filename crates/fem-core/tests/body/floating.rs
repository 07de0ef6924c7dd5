//! Bodies that float: rigid motions, balance, and independence of how the stiffness matrix is made regular.
//!
//! For loads in balance, Rᵀλ + Σ m r = 0, the answer is unique up to R α. The reference is the pseudo-inverse K⁺.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector, SymmetricEigen};
use stickslip_fem_core::body::internal_forces;
use stickslip_fem_core::interface::contract::{Known, check};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{
    CondensedBody, ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, nearest, scattered, side_nodes};
use crate::reference::{largest, rigid_motions, stiffness_matrix, unknowns, without};

const ROUNDING: f64 = 1e-12;

fn floating(kind: ElementKind) -> ElasticBody {
    let mesh = scattered(kind, Distortion::Straight, 21);
    let cases = vec![
        LoadCase {
            forces: Noise::new(31).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase {
            initial_strain: vec![[1e-3, -2e-3, 3e-3]],
            ..LoadCase::default()
        },
    ];
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS).unwrap();
    body.with_load_cases(cases).unwrap()
}

/// Interface forces in balance with load case 0, an arbitrary self-balanced part included.
fn balancing(condensed: &CondensedBody) -> DVector<f64> {
    let modes = condensed.modes();
    let arbitrary = DVector::from_vec(Noise::new(41).vector(modes.nrows()));
    let needed = condensed.mode_load(0) + modes.transpose() * &arbitrary;
    let gram = modes.transpose() * modes;
    arbitrary - modes * gram.lu().solve(&needed).unwrap()
}

fn interface(body: &ElasticBody) -> Vec<usize> {
    side_nodes(body.mesh(), &["right", "bottom"])
}

#[test]
fn free_motions_are_the_rigid_ones_and_cost_no_force() {
    for kind in ElementKind::COMMON {
        let body = Arc::new(floating(kind));
        let interface = interface(&body);
        let condensed = body.condense(&interface).unwrap();
        assert_eq!(condensed.modes().shape(), (2 * interface.len(), 3));
        let rigid = rigid_motions(body.mesh().nodes());
        let stiffness = stiffness_matrix(&body).amax();
        for motion in 0..3 {
            let mut amounts = [0.0; 3];
            amounts[motion] = 1.0;
            let no_force = vec![0.0; 2 * interface.len()];
            let u = condensed.displacements(&no_force, &[0.0, 0.0], &amounts);
            let scale = largest(&u);
            assert!(largest(&internal_forces(&body, &u)) < ROUNDING * stiffness * scale);
            assert!(without(&rigid, &DVector::from_column_slice(&u)).amax() < ROUNDING * scale);
            let here = condensed.modes().column(motion);
            for (row, k) in unknowns(&interface).into_iter().enumerate() {
                assert!((here[row] - u[k]).abs() <= f64::EPSILON * scale);
            }
            let work: f64 = u
                .iter()
                .zip(&body.load_cases()[0].forces)
                .map(|(a, b)| a * b)
                .sum();
            assert!(
                (condensed.mode_load(0)[motion] - work).abs() < ROUNDING * scale * u.len() as f64
            );
        }
        // Three independent motions, and a thermal strain has no resultant.
        assert!((rigid.transpose() * &rigid).determinant() > 0.0);
        assert!(
            condensed
                .modes()
                .clone()
                .svd(false, false)
                .singular_values
                .min()
                > 0.1
        );
        assert!(condensed.mode_load(1).amax() < ROUNDING);
    }
}

#[test]
fn balanced_loads_give_the_answer_of_the_pseudo_inverse() {
    for kind in ElementKind::COMMON {
        let body = Arc::new(floating(kind));
        let interface = interface(&body);
        let condensed = body.condense(&interface).unwrap();
        let lambda = balancing(&condensed);
        let u = DVector::from_vec(condensed.displacements(
            lambda.as_slice(),
            &[1.0, 0.0],
            &[0.2, -0.1, 0.3],
        ));

        let mut forces = DVector::from_column_slice(&body.load_cases()[0].forces);
        for (row, k) in unknowns(&interface).into_iter().enumerate() {
            forces[k] += lambda[row];
        }
        let reference = pseudo_solve(&stiffness_matrix(&body), &forces);
        let rigid = rigid_motions(body.mesh().nodes());
        let error = (without(&rigid, &u) - without(&rigid, &reference)).amax();
        assert!(
            error < 10.0 * ROUNDING * reference.amax(),
            "{kind:?}: {error:.1e}"
        );

        let here = condensed.compliance().unwrap() * &lambda + condensed.load_response(0).unwrap();
        let there = DVector::from_iterator(
            here.len(),
            unknowns(&interface).into_iter().map(|k| reference[k]),
        );
        let error = without(condensed.modes(), &(here - there)).amax();
        assert!(
            error < 10.0 * ROUNDING * reference.amax(),
            "{kind:?}: {error:.1e}"
        );
    }
}

/// K⁺ f by eigenvectors, leaving out the three of zero energy.
fn pseudo_solve(matrix: &DMatrix<f64>, forces: &DVector<f64>) -> DVector<f64> {
    let eigen = SymmetricEigen::new(matrix.clone());
    let mut order: Vec<usize> = (0..matrix.nrows()).collect();
    order.sort_by(|&a, &b| eigen.eigenvalues[a].total_cmp(&eigen.eigenvalues[b]));
    order[3..]
        .iter()
        .fold(DVector::zeros(forces.len()), |sum, &k| {
            let vector = eigen.eigenvectors.column(k);
            sum + vector * (vector.dot(forces) / eigen.eigenvalues[k])
        })
}

/// The same body held at three unknowns of our choice: different C and u₀, the same answer to balanced loads.
#[test]
fn the_choice_of_isostatic_supports_does_not_matter() {
    for kind in ElementKind::COMMON {
        let free = Arc::new(floating(kind));
        let interface = interface(&free);
        let condensed = free.condense(&interface).unwrap();
        let lambda = balancing(&condensed);
        let (a, b) = (
            nearest(free.mesh(), [0.6, 0.4]),
            nearest(free.mesh(), [-0.2, 0.0]),
        );
        let support = |node, direction| Support {
            nodes: vec![node],
            direction,
            displacement: 0.0,
        };
        let held = Arc::new(floating(kind).with_supports([
            support(a, HeldDirection::X),
            support(a, HeldDirection::Y),
            support(b, HeldDirection::Angle(2.0)),
        ]));
        let other = held.condense(&interface).unwrap();
        assert_eq!(other.modes().ncols(), 0);

        let answer =
            |c: &CondensedBody| c.compliance().unwrap() * &lambda + c.load_response(0).unwrap();
        let (here, there) = (answer(&condensed), answer(&other));
        let scale = here.amax().max(there.amax());
        let error = without(condensed.modes(), &(&here - &there)).amax();
        assert!(
            error < 10.0 * ROUNDING * scale,
            "{kind:?}: {error:.1e} of {scale:.1e}"
        );
        assert!(
            (here - there).amax() > 1e-3 * scale,
            "the two condensations do differ"
        );
    }
}

/// Supports that leave one motion free: on rollers, and turning about a hinge.
#[test]
fn partly_held_bodies_keep_what_is_left() {
    let mesh = scattered(ElementKind::Q8, Distortion::Straight, 21);
    let (bottom, hinge) = (side_nodes(&mesh, &["bottom"]), nearest(&mesh, [-0.2, 0.0]));
    // The bottom side runs along (1.3, −0.2).
    let normal = HeldDirection::Angle(1.3_f64.atan2(0.2));
    let support = |nodes: Vec<usize>, direction| Support {
        nodes,
        direction,
        displacement: 0.0,
    };
    let rollers = vec![support(bottom, normal)];
    let turning = vec![
        support(vec![hinge], HeldDirection::X),
        support(vec![hinge], HeldDirection::Y),
    ];
    let at = mesh.nodes()[hinge];
    let slide = |_: [f64; 2]| [1.3, -0.2];
    let turn = move |[x, y]: [f64; 2]| [at[1] - y, x - at[0]];
    let motions: [&dyn Fn([f64; 2]) -> [f64; 2]; 2] = [&slide, &turn];
    for (supports, motion) in [rollers, turning].into_iter().zip(motions) {
        let body = ElasticBody::new(Arc::new(mesh.clone()), vec![ply(0.5)], THICKNESS).unwrap();
        let interface = side_nodes(&mesh, &["top"]);
        let condensed = Arc::new(body.with_supports(supports))
            .condense(&interface)
            .unwrap();
        let expected = condensed.points().iter().flat_map(|&p| motion(p));
        let expected = DVector::from_iterator(2 * interface.len(), expected);
        assert_eq!(condensed.modes().ncols(), 1);
        assert!(without(condensed.modes(), &expected).amax() < ROUNDING * expected.amax());
    }
}

/// Condensed bodies of all elements keep the contract of operators, their resultants being those of the nodal forces.
#[test]
fn condensed_bodies_keep_the_contract() {
    for kind in ElementKind::ALL {
        let body = Arc::new(floating(kind));
        let forces = body.load_cases()[0].forces.chunks_exact(2);
        let mut sum = [0.0; 3];
        for (node, force) in body.mesh().nodes().iter().zip(forces) {
            sum[0] += force[0];
            sum[1] += force[1];
            sum[2] += node[0] * force[1] - node[1] * force[0];
        }
        let known = Known {
            placed: true,
            resultants: &[sum, [0.0; 3]],
        };
        let condensed = body.condense(&interface(&body)).unwrap();
        assert_eq!(check(&condensed, known), Ok(()), "{kind:?}");

        let left = Support {
            nodes: side_nodes(body.mesh(), &["left"]),
            direction: HeldDirection::X,
            displacement: 0.0,
        };
        let rolling = Arc::new(floating(kind).with_supports([left]));
        let condensed = rolling.condense(&interface(&rolling)).unwrap();
        let known = Known {
            placed: true,
            resultants: &[],
        };
        assert_eq!(check(&condensed, known), Ok(()), "{kind:?}");
    }
}
