//! The assembled problem of points that stand on several nodes.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_contact::{
    ContactError, ContactPair, ContactPoint, InterfaceProblem, Stencil, StencilTerm,
};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{CondensedBody, HeldDirection, InterfaceOperator, RigidBody};
use stickslip_friction::Coulomb;

use crate::blocks::{hold, nodes_of, rectangle, stressed};
use crate::{along_x, resultant, solve};

/// Sums of some ten products each.
const ROUNDING: f64 = 1e-13;

fn block(held: bool) -> CondensedBody {
    let mesh = rectangle(&[0.0, 0.7, 1.5, 2.0], [0.0, 1.0], ElementKind::Q4);
    let (nodes, _) = along_x(&mesh, "bottom");
    let supports = if held {
        let top = || nodes_of(&mesh, "top");
        vec![hold(top(), HeldDirection::X), hold(top(), HeldDirection::Y)]
    } else {
        vec![]
    };
    let pulled = if held { "left" } else { "top" };
    stressed(mesh, &nodes, [0.3, -1.0, 0.2], &[pulled], supports)
}

fn point(first: Stencil, second: Stencil, angle: f64) -> ContactPoint {
    ContactPoint {
        first,
        second,
        normal: [-angle.sin(), angle.cos()],
        gap: 0.0,
        area: 0.5,
        material_angle: 0.0,
    }
}

/// One plain pair, one mean of two against three nodes, and one whose weights turn.
fn points() -> Vec<ContactPoint> {
    let turning = |node, c: f64, s: f64| StencilTerm {
        node,
        weights: [[c, s], [-s, c]],
    };
    vec![
        point(0.into(), 1.into(), 0.0),
        point(
            Stencil::weighted([(1, 0.25), (2, 0.75)]),
            Stencil::weighted([(0, 0.5), (2, 0.3), (3, 0.2)]),
            0.1,
        ),
        point(
            Stencil::new(vec![turning(2, 0.4, 0.1), turning(3, 0.5, -0.1)]),
            Stencil::new(vec![turning(3, 0.9, 0.05)]),
            -0.2,
        ),
    ]
}

/// B_b written out in full.
fn rows(points: &[ContactPoint], first: bool, nodes: usize) -> DMatrix<f64> {
    let mut matrix = DMatrix::zeros(2 * points.len(), 2 * nodes);
    for (k, point) in points.iter().enumerate() {
        let [nx, ny] = point.normal;
        let frame = [[nx, ny], [-ny, nx]];
        let (stencil, sign) = if first {
            (&point.first, 1.0)
        } else {
            (&point.second, -1.0)
        };
        for term in stencil.terms() {
            for (i, axis, via) in (0..8).map(|c| (c / 4, c / 2 % 2, c % 2)) {
                matrix[(2 * k + i, 2 * term.node + axis)] +=
                    sign * term.weights[i][via] * frame[via][axis];
            }
        }
    }
    matrix
}

fn assembled(bodies: [&CondensedBody; 2]) -> InterfaceProblem {
    let pair = ContactPair {
        name: "joint".into(),
        origin: [0.0; 2],
        first: 0,
        second: 1,
        points: points(),
        law: Arc::new(Coulomb::new(0.3).unwrap()),
    };
    InterfaceProblem::new(&[bodies[0], bodies[1]], vec![pair]).unwrap()
}

#[test]
fn operators_are_the_products_of_their_definition() {
    let bodies = [&block(false), &block(true)];
    let problem = assembled(bodies);
    let [one, two] = [true, false].map(|first| rows(&points(), first, 4));
    let expected: DMatrix<f64> = [&one, &two]
        .into_iter()
        .zip(bodies)
        .map(|(b, body)| b * body.compliance().unwrap() * b.transpose())
        .sum();
    let scale = expected.amax();
    assert!((&*problem.compliance().to_matrix() - &expected).amax() < ROUNDING * scale);
    let compliance = problem.compliance().to_matrix();
    assert_eq!(*compliance, compliance.transpose());
    assert!((problem.modes() - &one * bodies[0].modes()).amax() < ROUNDING);
    let response = |b: &DMatrix<f64>, body: &CondensedBody| b * body.load_response(0).unwrap();
    let motion = response(&one, bodies[0]) + response(&two, bodies[1]);
    assert!((problem.load_motion(&[1.0]) - &motion).amax() < ROUNDING * motion.amax());
    let forces = DVector::from_vec(vec![1.0, 0.2, 0.7, -0.1, 0.4, 0.3]);
    for (index, b) in [&one, &two].into_iter().enumerate() {
        let found = DVector::from_vec(problem.forces_on_body(index, 4, &forces));
        assert!((found - b.tr_mul(&forces)).amax() < ROUNDING);
    }
}

#[test]
fn the_audit_sees_the_forces_that_act_on_the_body() {
    let (first, second) = (block(true), block(true));
    let pressed: Vec<ContactPoint> = points()
        .into_iter()
        .map(|point| ContactPoint {
            gap: -0.01,
            ..point
        })
        .collect();
    let (problem, record) = solve([&first, &second], pressed, 0.2, &[1.0]);
    let forces = problem.forces_on_body(0, 4, &record.state.forces);
    let [x, y, moment] = resultant(first.points(), &forces);
    assert!(y > 0.0);
    let [audited_x, audited_y] = record.audit.pairs[0].resultant;
    for (audited, acting) in [
        (audited_x, x),
        (audited_y, y),
        (record.audit.pairs[0].moment, moment),
    ] {
        assert!(
            (audited - acting).abs() < ROUNDING * 10.0 * y,
            "{audited} {acting}"
        );
    }
}

#[test]
fn malformed_stencils_are_refused() {
    let refusal = |first: Stencil| {
        let bodies = [(); 2].map(|()| RigidBody::held(vec![[0.0; 2]; 2], 0));
        let pair = ContactPair {
            name: "joint".into(),
            origin: [0.0; 2],
            first: 0,
            second: 1,
            points: vec![point(first, 0.into(), 0.0)],
            law: Arc::new(Coulomb::new(0.3).unwrap()),
        };
        match InterfaceProblem::new(&[&bodies[0], &bodies[1]], vec![pair]) {
            Err(ContactError::InvalidPair { what, .. }) => what,
            other => panic!("{other:?}"),
        }
    };
    assert_eq!(refusal(Stencil::new(vec![])), "no node of body 0");
    let far = Stencil::weighted([(0, 0.5), (2, 0.5)]);
    assert_eq!(refusal(far), "contact node 2 of body 0, which has 2");
    assert!(refusal(Stencil::weighted([(1, f64::NAN)])).contains("NaN"));
}
