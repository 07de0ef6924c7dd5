//! Supports: symmetry, skew directions, prescribed displacements.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_fem_core::{ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, mapped, nearest, rectangle, scattered, side_nodes};
use crate::reference::{largest, part, schur_complement, stiffness_matrix, unknowns, without};

const ROUNDING: f64 = 1e-12;

fn support(nodes: &[usize], direction: HeldDirection, displacement: f64) -> Support {
    Support {
        nodes: nodes.to_vec(),
        direction,
        displacement,
    }
}

/// A plate pulled at its left side, in balance with forces on its right side; both symmetric about y = 0.
struct Symmetric {
    body: Arc<ElasticBody>,
    /// Nodes of the right side's upper half, upwards.
    upper: Vec<usize>,
}

fn symmetric(kind: ElementKind, low: f64, rows: usize) -> Symmetric {
    let mesh = rectangle(kind, [0.0, 2.0], [low, 1.0], [4, rows]);
    let height = |&node: &usize| mesh.nodes()[node][1];
    let mut upper = side_nodes(&mesh, &["right"]);
    upper.retain(|node| height(node) > -1e-9);
    upper.sort_by(|a, b| height(a).total_cmp(&height(b)));
    let pull = edge_load(
        &mesh,
        &mesh.edge_set("left").unwrap().edges,
        THICKNESS,
        |at| [-1.0, 2.0 * at.position[1]],
    );
    let case = LoadCase {
        forces: pull,
        ..LoadCase::default()
    };
    let material = Arc::new(Isotropic::new(70.0, 0.33, PlaneState::Stress).unwrap());
    let cut = side_nodes(&mesh, &["bottom"]);
    let body = ElasticBody::new(Arc::new(mesh), vec![material], THICKNESS).unwrap();
    let body = body.with_load_cases(vec![case]).unwrap();
    let body = if low < 0.0 {
        body
    } else {
        body.with_supports([support(&cut, HeldDirection::Y, 0.0)])
    };
    Symmetric {
        body: Arc::new(body),
        upper,
    }
}

#[test]
fn half_a_symmetric_body_answers_like_the_whole() {
    // Quadrilaterals only: the triangles of the generator are not the mirror images of each other.
    for kind in [ElementKind::Q4, ElementKind::Q8, ElementKind::Q9] {
        let (half, whole) = (symmetric(kind, 0.0, 3), symmetric(kind, -1.0, 6));
        let condensed = half.body.condense(&half.upper).unwrap();
        let shift = condensed.modes();
        assert_eq!(shift.ncols(), 1, "only a translation along x is left");
        let expected = DVector::from_fn(shift.nrows(), |k, _| if k % 2 == 0 { 1.0 } else { 0.0 });
        assert!(without(shift, &expected).amax() < ROUNDING);

        // Forces on the right side, upper half: those of the axis node count half in the half body.
        let count = half.upper.len();
        let mut lambda = Noise::new(3).vector(2 * count);
        lambda[1] = 0.0;
        let missing = condensed.mode_load(0)[0] / shift[(0, 0)];
        let sum: f64 = lambda.iter().step_by(2).sum();
        lambda
            .iter_mut()
            .step_by(2)
            .for_each(|force| *force -= (sum + missing) / count as f64);
        let u = condensed.displacements(&lambda, &[1.0], &[0.0]);

        let mesh = whole.body.mesh();
        let mut interface = whole.upper.clone();
        let mut forces = lambda.clone();
        (0..2).for_each(|i| forces[i] *= 2.0);
        for (k, &node) in whole.upper.iter().enumerate().skip(1) {
            let [x, y] = mesh.nodes()[node];
            interface.push(nearest(mesh, [x, -y]));
            forces.extend([lambda[2 * k], -lambda[2 * k + 1]]);
        }
        let full = whole.body.condense(&interface).unwrap();
        let v = full.displacements(&forces, &[1.0], &[0.0; 3]);

        let nodes = half.body.mesh().nodes();
        let there: Vec<usize> = nodes.iter().map(|&p| nearest(mesh, p)).collect();
        let difference = DVector::from_fn(u.len(), |k, _| u[k] - v[2 * there[k / 2] + k % 2]);
        let rigid = crate::reference::rigid_motions(nodes);
        assert!(
            without(&rigid, &difference).amax() < ROUNDING * largest(&u),
            "{kind:?}"
        );
    }
}

/// A ply with a skew support, everything turned by `turn`.
fn turned(kind: ElementKind, turn: f64) -> (Arc<ElasticBody>, Vec<usize>) {
    let straight = scattered(kind, Distortion::Curved, 17);
    let (left, corner) = (
        side_nodes(&straight, &["left"]),
        nearest(&straight, [1.1, -0.2]),
    );
    let (s, c) = turn.sin_cos();
    let rotate = |[x, y]: Point| [c * x - s * y, s * x + c * y];
    let forces: Vec<f64> = Noise::new(2)
        .vector(2 * straight.nodes().len())
        .chunks_exact(2)
        .flat_map(|f| rotate([f[0], f[1]]))
        .collect();
    let mesh = mapped(straight, rotate);
    let interface = side_nodes(&mesh, &["left", "top"]);
    let direction = |angle: f64| HeldDirection::Angle(angle + turn);
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5 + turn)], THICKNESS).unwrap();
    let cases = vec![
        LoadCase {
            forces,
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
    ];
    let supports = [
        support(&left, direction(0.4), 0.2),
        support(&left[..1], direction(1.1), 0.1),
        support(&[corner], direction(-0.7), -0.3),
    ];
    let body = body.with_supports(supports).with_load_cases(cases).unwrap();
    (Arc::new(body), interface)
}

#[test]
fn turning_everything_turns_the_answer() {
    for kind in ElementKind::COMMON {
        let (body, interface) = turned(kind, 0.0);
        let here = body.condense(&interface).unwrap();
        for turn in [0.3, 1.9, -std::f64::consts::FRAC_PI_2] {
            let there = turned(kind, turn).0.condense(&interface).unwrap();
            let (s, c) = turn.sin_cos();
            let size = 2 * interface.len();
            let rotation =
                DMatrix::from_fn(size, size, |i, j| match (i / 2 == j / 2, i % 2, j % 2) {
                    (true, 0, 1) => -s,
                    (true, 1, 0) => s,
                    (true, _, _) => c,
                    _ => 0.0,
                });
            let compliance = here.compliance().unwrap();
            let back = rotation.transpose() * there.compliance().unwrap() * &rotation;
            assert!(
                (back - compliance).amax() < ROUNDING * compliance.amax(),
                "{kind:?}"
            );
            for case in 0..2 {
                let response = here.load_response(case).unwrap();
                let back = rotation.transpose() * there.load_response(case).unwrap();
                assert!(
                    (back - response).amax() < ROUNDING * response.amax(),
                    "{kind:?}"
                );
            }
        }
    }
}

/// Skew supports on interface nodes against dense algebra in turned coordinates.
#[test]
fn a_skew_support_leaves_the_direction_across_it() {
    let angle = 0.4_f64;
    let mesh = scattered(ElementKind::T6, Distortion::Straight, 17);
    let (left, foot) = (side_nodes(&mesh, &["left"]), nearest(&mesh, [1.1, -0.2]));
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS).unwrap();
    let supports = [
        support(&left, HeldDirection::Angle(angle), 0.0),
        support(&[foot], HeldDirection::Y, 0.0),
    ];
    let body = Arc::new(body.with_supports(supports));
    let condensed = body.condense(&left).unwrap();

    let (s, c) = angle.sin_cos();
    let matrix = stiffness_matrix(&body);
    let mut turn = DMatrix::identity(matrix.nrows(), matrix.nrows());
    for &node in &left {
        turn.view_mut((2 * node, 2 * node), (2, 2))
            .copy_from_slice(&[c, s, -s, c]);
    }
    // Columns of `turn` are the turned axes; the first of each left node is held.
    let matrix = turn.transpose() * matrix * &turn;
    let mut held: Vec<usize> = left.iter().map(|&node| 2 * node).collect();
    held.push(2 * foot + 1);
    let kept: Vec<usize> = left.iter().map(|&node| 2 * node + 1).collect();
    let schur = schur_complement(&matrix, &kept, &held);
    let axes = part(&turn, &unknowns(&left), &kept);
    let expected = &axes * schur.try_inverse().unwrap() * axes.transpose();
    let error = (condensed.compliance().unwrap() - &expected).amax();
    assert!(error < ROUNDING * expected.amax(), "{error:.1e}");
}

/// A bar stretched by δ, by its supports alone and together with a force: u = δ x/L and the stress E δ/L.
#[test]
fn prescribed_displacements_follow_their_load_case() {
    let (length, stretch, young) = (2.0, 0.01, 70.0);
    for kind in ElementKind::COMMON {
        let mesh = rectangle(kind, [0.0, length], [0.0, 1.0], [4, 2]);
        let (left, right) = (side_nodes(&mesh, &["left"]), side_nodes(&mesh, &["right"]));
        let corner = nearest(&mesh, [0.0, 0.0]);
        let forces = Noise::new(6).vector(2 * mesh.nodes().len());
        let body = bar(
            mesh,
            young,
            &[(&left, 0.0), (&right, stretch)],
            corner,
            forces,
        );
        let interface = side_nodes(body.mesh(), &["right", "top"]);
        let condensed = body.condense(&interface).unwrap();
        let no_force = vec![0.0; 2 * interface.len()];
        for factor in [1.0, -2.5] {
            let u = condensed.displacements(&no_force, &[0.0, factor], &[]);
            for (&[x, y], u) in body.mesh().nodes().iter().zip(u.chunks_exact(2)) {
                let strain = factor * stretch / length;
                assert!((u[0] - strain * x).abs() < ROUNDING * stretch);
                assert!((u[1] + 0.33 * strain * y).abs() < ROUNDING * stretch);
            }
            let reactions = condensed.residual_forces(&u, &no_force, &[0.0, factor]);
            let pull: f64 = right.iter().map(|&node| reactions[2 * node]).sum();
            let expected = young * factor * stretch / length * THICKNESS;
            assert!((pull - expected).abs() < ROUNDING * expected.abs() * right.len() as f64);
        }
        // The force case leaves the supports where they were.
        let u = condensed.displacements(&no_force, &[1.0, 0.0], &[]);
        let held = left.iter().chain(&right);
        assert!(held.into_iter().all(|&node| u[2 * node] == 0.0));
        // Supports of the interface move with their case also in its response.
        let response = condensed.load_response(1).unwrap();
        let of_right = interface
            .iter()
            .enumerate()
            .filter(|(_, node)| right.contains(node));
        assert!(
            of_right
                .into_iter()
                .all(|(k, _)| response[2 * k] == stretch)
        );
    }
}

fn bar(
    mesh: Mesh,
    young: f64,
    ends: &[(&[usize], f64)],
    corner: usize,
    forces: Vec<f64>,
) -> Arc<ElasticBody> {
    let material = Arc::new(Isotropic::new(young, 0.33, PlaneState::Stress).unwrap());
    let cases = vec![
        LoadCase {
            forces,
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
    ];
    let along = ends
        .iter()
        .map(|&(nodes, u)| support(nodes, HeldDirection::X, u));
    let body = ElasticBody::new(Arc::new(mesh), vec![material], THICKNESS).unwrap();
    let body = body
        .with_supports(along)
        .with_supports([support(&[corner], HeldDirection::Y, 0.0)]);
    Arc::new(body.with_load_cases(cases).unwrap())
}
