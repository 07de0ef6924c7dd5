//! The mean displacement over a body's area, held by a reaction that is spread over it, against the bordered system of all nodes.

use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use stickslip_fem_core::body::{BodyError, BodyLoad};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{
    ElasticBody, HeldDirection, InterfaceOperator, LoadCase, SectionHold, Support, load,
};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Distortion, Noise, nearest, scattered, side_nodes};
use crate::reference::{largest, stiffness_matrix};

const HOLD: SectionHold = SectionHold {
    held: [true; 2],
    displacement: [0.01, -0.02],
};

/// Displacement of the support beside it.
const MOVED: f64 = 0.03;

/// A body under forces and motion of its supports, of which one keeps it from turning if `turns` is false.
fn body(kind: ElementKind, turns: bool) -> ElasticBody {
    let mesh = scattered(kind, Distortion::Curved, 43);
    let corner = nearest(&mesh, [1.1, -0.2]);
    let cases = vec![
        LoadCase {
            forces: Noise::new(47).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase {
            moves_supports: true,
            ..LoadCase::default()
        },
    ];
    let support = Support {
        nodes: vec![corner],
        direction: HeldDirection::Angle(0.4),
        displacement: MOVED,
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.3)], THICKNESS).unwrap();
    let supports = (!turns).then_some(support);
    let body = body.with_supports(supports).with_load_cases(cases).unwrap();
    body.with_section_hold(HOLD)
}

/// K u + Σ b ρ + c σ = f, bᵀ u = d, cᵀ u = e: all displacements, d and e times `scale`.
fn bordered(body: &ElasticBody, forces: &[f64], scale: f64) -> Vec<f64> {
    let stiffness = stiffness_matrix(body);
    let (count, mesh) = (stiffness.nrows(), body.mesh());
    let weights = load::area_load(mesh);
    let area: f64 = weights.iter().sum();
    let corner = nearest(mesh, [1.1, -0.2]);
    let mut system = DMatrix::zeros(count + 3, count + 3);
    system
        .view_mut((0, 0), (count, count))
        .copy_from(&stiffness);
    let mut border = |row: usize, column: usize, value: f64| {
        system[(row, count + column)] = value;
        system[(count + column, row)] = value;
    };
    for (node, weight) in weights.iter().enumerate() {
        border(2 * node, 0, weight / area);
        border(2 * node + 1, 1, weight / area);
    }
    border(2 * corner, 2, 0.4_f64.cos());
    border(2 * corner + 1, 2, 0.4_f64.sin());
    let mut side = DVector::zeros(count + 3);
    side.rows_mut(0, count).copy_from_slice(forces);
    side[count] = scale * HOLD.displacement[0];
    side[count + 1] = scale * HOLD.displacement[1];
    side[count + 2] = scale * MOVED;
    let solution = system.lu().solve(&side).unwrap();
    solution.rows(0, count).iter().copied().collect()
}

#[test]
fn displacements_are_those_of_the_bordered_system() {
    for kind in ElementKind::COMMON {
        let body = Arc::new(body(kind, false));
        let interface = side_nodes(body.mesh(), &["top", "right"]);
        let condensed = body.condense(&interface).unwrap();
        assert_eq!(condensed.modes().ncols(), 0);
        let lambda = Noise::new(53).vector(2 * interface.len());
        let multipliers = [0.7, -1.5];
        let mut forces: Vec<f64> = body.load_cases()[0]
            .forces
            .iter()
            .map(|f| 0.7 * f)
            .collect();
        for (force, &node) in lambda.chunks_exact(2).zip(&interface) {
            forces[2 * node] += force[0];
            forces[2 * node + 1] += force[1];
        }
        let wanted = bordered(&body, &forces, -1.5);
        let found = condensed.displacements(&lambda, &multipliers, &[]);
        let size = largest(&wanted);
        for (own, other) in found.iter().zip(&wanted) {
            assert!(
                (own - other).abs() < 1e-10 * size,
                "{kind:?}: {own} {other}"
            );
        }
        let at_points = InterfaceOperator::displacements(&condensed, &lambda, &[], &multipliers);
        for (k, &node) in interface.iter().enumerate() {
            for axis in 0..2 {
                let apart = at_points[2 * k + axis] - wanted[2 * node + axis];
                assert!(apart.abs() < 1e-10 * size, "{kind:?}: {apart:e}");
            }
        }
        let residual = condensed.residual_forces(&found, &lambda, &multipliers);
        assert!(condensed.relative_imbalance(&residual, &lambda, &multipliers) < 1e-10);
    }
}

/// A body that nothing else holds keeps its turn, about the point that the mean does not move with.
#[test]
fn the_turn_stays_free_and_moves_no_mean() {
    let body = Arc::new(body(ElementKind::Q8, true));
    let interface = side_nodes(body.mesh(), &["top"]);
    let condensed = body.condense(&interface).unwrap();
    assert_eq!(condensed.modes().ncols(), 1);
    let compliance = condensed.compliance().unwrap();
    let skew = (compliance - compliance.transpose()).amax();
    assert!(skew < 1e-12 * compliance.amax(), "{skew:e}");
    // Forces whose moment the load case balances.
    let mut lambda = Noise::new(59).vector(2 * interface.len());
    let mode = condensed.modes().column(0);
    let missing = mode.dot(&DVector::from_column_slice(&lambda)) + condensed.mode_load(0)[0];
    let norm = mode.norm_squared();
    for (force, along) in lambda.iter_mut().zip(mode.iter()) {
        *force -= missing * along / norm;
    }
    let multipliers = [1.0, 2.0];
    let state = BodyLoad {
        forces: &lambda,
        multipliers: &multipliers,
        motions: &[0.3],
    };
    let u = condensed.displacements_of(&[state]).remove(0);
    let weights = load::area_load(body.mesh());
    let area: f64 = weights.iter().sum();
    for axis in 0..2 {
        let moved = u.iter().skip(axis).step_by(2).zip(&weights);
        let mean = moved.map(|(u, weight)| u * weight).sum::<f64>() / area;
        let given = 2.0 * HOLD.displacement[axis];
        assert!((mean - given).abs() < 1e-12 * largest(&u), "{mean} {given}");
    }
    let residuals = condensed.residual_forces_of(std::slice::from_ref(&u), &[state]);
    let balance = condensed.balances_of(&residuals, std::slice::from_ref(&u), &[state])[0];
    assert!(
        balance.nodal < 1e-10 && balance.force < 1e-12,
        "{balance:?}"
    );
    let applied = InterfaceOperator::displacements(&condensed, &lambda, &[0.3], &multipliers);
    for (k, &node) in interface.iter().enumerate() {
        assert!((applied[2 * k] - u[2 * node]).abs() < 1e-11 * largest(&u));
    }
}

/// In other units of length all is the same, and with it what counts as held.
#[test]
fn a_rescaled_section_has_the_same_compliance() {
    let kind = ElementKind::Q4;
    let compliance = |scale: f64, held: bool| {
        let mut parts = scattered(kind, Distortion::Curved, 43).into_parts();
        for node in &mut parts.nodes {
            *node = node.map(|x| scale * x);
        }
        let mesh = Mesh::new(parts).unwrap();
        let points = [[1.0, 1.0], [1.1, -0.2]].map(|at| nearest(&mesh, at.map(|x| scale * x)));
        let left = side_nodes(&mesh, &["left"]);
        let own = ElasticBody::new(Arc::new(mesh), vec![ply(0.3)], THICKNESS).unwrap();
        let directions = [HeldDirection::X, HeldDirection::Y].into_iter();
        let supports = directions.filter(|_| held).map(|direction| Support {
            nodes: left.clone(),
            direction,
            displacement: 0.0,
        });
        let own = own.with_supports(supports).with_section_hold(HOLD);
        Arc::new(own).condense(&points)
    };
    let [own, small] = [1.0, 1e-9].map(|scale| compliance(scale, false).unwrap());
    let (own, small) = (own.compliance().unwrap(), small.compliance().unwrap());
    assert!((own - small).amax() < 1e-11 * own.amax());
    let refused = [1.0, 1e-9, 1e9].map(|scale| compliance(scale, true));
    assert!(
        (refused.iter()).all(|own| matches!(own, Err(BodyError::SectionHeld))),
        "{refused:?}"
    );
}

#[test]
fn a_section_that_supports_hold_already_is_refused() {
    let own = body(ElementKind::Q4, true);
    let left = side_nodes(own.mesh(), &["left"]);
    let hold = |direction| Support {
        nodes: left.clone(),
        direction,
        displacement: 0.0,
    };
    let own = own.with_supports([hold(HeldDirection::X), hold(HeldDirection::Y)]);
    let refused = Arc::new(own).condense(&[nearest(
        &scattered(ElementKind::Q4, Distortion::Curved, 43),
        [1.0, 1.0],
    )]);
    assert!(
        matches!(refused, Err(BodyError::SectionHeld)),
        "{refused:?}"
    );
}

/// A body without supports moves by its means, under whatever forces: what does not balance among them is spread over its area.
#[test]
fn a_carried_section_moves_by_its_means() {
    const LENGTH: f64 = 0.7;
    let mesh = Arc::new(scattered(ElementKind::Q8, Distortion::Curved, 43));
    let interface = side_nodes(&mesh, &["top", "right"]);
    let case = LoadCase {
        forces: Noise::new(61).vector(2 * mesh.nodes().len()),
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::clone(&mesh), vec![ply(0.3)], THICKNESS).unwrap();
    let body = body.with_load_cases(vec![case]).unwrap();
    let condensed = Arc::new(body.with_carried_section(LENGTH))
        .condense(&interface)
        .unwrap();
    let compliance = condensed.compliance().unwrap();
    let skew = (compliance - compliance.transpose()).amax();
    assert!(skew < 1e-12 * compliance.amax(), "{skew:e}");
    let lambda = Noise::new(67).vector(2 * interface.len());
    let (multipliers, motions) = ([0.8], [0.3, -0.2, 0.1]);
    let state = BodyLoad {
        forces: &lambda,
        multipliers: &multipliers,
        motions: &motions,
    };
    let u = condensed.displacements_of(&[state]).remove(0);
    let weighted = |weights: &[f64], axis: usize| -> f64 {
        let own = u.iter().skip(axis).step_by(2).zip(weights);
        own.map(|(u, weight)| u * weight).sum()
    };
    let ones = load::area_load(&mesh);
    let area: f64 = ones.iter().sum();
    let middle = [0, 1].map(|axis| {
        load::area_integral(&mesh, |at| at[axis])
            .iter()
            .sum::<f64>()
            / area
    });
    let arm = |axis: usize| load::area_integral(&mesh, |at| at[axis] - middle[axis]);
    let polar = load::area_integral(&mesh, |[x, y]| {
        (x - middle[0]).powi(2) + (y - middle[1]).powi(2)
    });
    let turned = weighted(&arm(0), 1) - weighted(&arm(1), 0);
    let found = [
        weighted(&ones, 0) / area,
        weighted(&ones, 1) / area,
        LENGTH * turned / polar.iter().sum::<f64>(),
    ];
    let size = largest(&u);
    for (found, wanted) in found.iter().zip(motions) {
        assert!((found - wanted).abs() < 1e-11 * size, "{found} {wanted}");
    }
    let at_points = InterfaceOperator::displacements(&condensed, &lambda, &motions, &multipliers);
    for (k, &node) in interface.iter().enumerate() {
        assert!((at_points[2 * k] - u[2 * node]).abs() < 1e-10 * size);
        assert!((at_points[2 * k + 1] - u[2 * node + 1]).abs() < 1e-10 * size);
    }
    let residuals = condensed.residual_forces_of(std::slice::from_ref(&u), &[state]);
    let balance = condensed.balances_of(&residuals, std::slice::from_ref(&u), &[state])[0];
    assert!(
        balance.nodal < 1e-10 && balance.force < 1e-12 && balance.moment < 1e-12,
        "{balance:?}"
    );
    // The forces on it in its motions are what carries it.
    let pushed = condensed.modes().tr_mul(&DVector::from_vec(lambda.clone()))
        + condensed.mode_load(0) * multipliers[0];
    for axis in 0..2 {
        assert!((pushed[axis] + balance.reaction[axis]).abs() < 1e-10 * pushed.amax());
    }
}
