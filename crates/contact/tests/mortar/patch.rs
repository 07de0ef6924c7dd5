//! The contact patch test: a constant stress passes an interface of any two divisions.

use stickslip_contact::problem::InterfaceProblem;
use stickslip_contact::{
    ContactPoint, EdgeSide, InitialGap, Multipliers, Projection, StepRecord, mortar,
};
use stickslip_fem_core::element::edge_nodes;
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{CondensedBody, HeldDirection, InterfaceOperator, RigidBody};

use crate::blocks::{THICKNESS, hold, nodes_of, rectangle, stress_error, stressed};
use crate::{BOTH, along_x, solve, tractions};

/// Condition numbers of the bodies are below 10⁴, and a stress loses the ratio of the body's to a cell's size, below ten.
const ROUNDING: f64 = 1e-11;
/// Of tractions, whose points lose less.
const EXACT: f64 = 1e-12;

const UPPER: [f64; 5] = [0.0, 0.5, 1.3, 2.2, 3.0];
const LOWER: [f64; 6] = [0.0, 0.8, 1.1, 1.9, 2.5, 3.0];
const ALL: [ElementKind; 7] = [
    ElementKind::Q4,
    ElementKind::Q8,
    ElementKind::Q9,
    ElementKind::T3,
    ElementKind::T6,
    ElementKind::P3,
    ElementKind::P6,
];

fn projection(multipliers: Multipliers) -> Projection<'static> {
    Projection {
        multipliers,
        length: 1.0,
        thickness: THICKNESS,
        normal: &|_| [0.0, 1.0],
        gap: InitialGap::Exact(&|_| 0.0),
        material_angle: 0.0,
        symmetry: [false; 2],
    }
}

/// The upper block carries `stress` on its free sides and floats; the lower one stands on rollers.
fn two_blocks(kinds: [ElementKind; 2], stress: [f64; 3]) -> [(CondensedBody, EdgeSide); 2] {
    let upper = rectangle(&UPPER, [0.0, 1.0], kinds[0]);
    let lower = rectangle(&LOWER, [-1.0, 0.0], kinds[1]);
    let (upper_nodes, upper_side) = along_x(&upper, "bottom");
    let (lower_nodes, lower_side) = along_x(&lower, "top");
    let supports = vec![
        hold(nodes_of(&lower, "bottom"), HeldDirection::Y),
        hold(vec![nodes_of(&lower, "bottom")[0]], HeldDirection::X),
    ];
    // Rollers carry σ_yy; the shear of the lower side is a load.
    let sheared = [stress[0], 0.0, stress[2]];
    let sides = ["left", "right", "top"];
    let first = stressed(upper, &upper_nodes, stress, &sides, vec![]);
    let second = stressed(
        lower,
        &lower_nodes,
        sheared,
        &["left", "right", "bottom"],
        supports,
    );
    [(first, upper_side), (second, lower_side)]
}

fn check_stress(
    body: &CondensedBody,
    index: usize,
    made: &(InterfaceProblem, StepRecord),
    stress: [f64; 3],
) -> f64 {
    let (problem, record) = made;
    let count = body.points().len();
    let forces = problem.forces_on_body(index, count, &record.state.forces);
    let motions = problem.motions_of_body(
        index,
        &record.state.rigid,
        &record.state.forces,
        &record.state.multipliers,
    );
    stress_error(body, &body.displacements(&forces, &[1.0], &motions), stress)
}

#[test]
fn constant_stress_passes_edges_that_do_not_match() {
    let stress = [0.4, -2.0, 0.6];
    for upper in ALL {
        for lower in ALL {
            for multipliers in BOTH {
                let what = format!("{upper:?} on {lower:?}, {multipliers:?}");
                let [(first, over), (second, under)] = two_blocks([upper, lower], stress);
                let made = mortar::project(&over, &under, &projection(multipliers)).unwrap();
                assert_eq!(made.nodes.len(), over.nodes().len());
                let solved = solve([&first, &second], made.points, 1.0, &[1.0]);
                for [pressure, shear] in tractions(&solved.0, &solved.1) {
                    // e_t = −e_x, and the traction on the upper block's lower side is −σ e_y.
                    assert!((pressure - 2.0).abs() < EXACT * 100.0, "{what}: {pressure}");
                    assert!((shear - 0.6).abs() < EXACT * 100.0, "{what}: {shear}");
                }
                for (index, body) in [&first, &second].into_iter().enumerate() {
                    let error = check_stress(body, index, &solved, stress);
                    assert!(error < 2.0 * ROUNDING, "{what}, body {index}: {error:.1e}");
                }
                assert!(
                    solved.1.audit.balance() < EXACT,
                    "{what}: {}",
                    solved.1.audit.balance()
                );
            }
        }
    }
}

/// What the projection is for: nodes joined to the nearest node of the other side do not pass the test.
#[test]
fn pairs_of_nearest_nodes_do_not_pass_it() {
    let stress = [0.0, -2.0, 0.0];
    let [(first, over), (second, under)] = two_blocks([ElementKind::Q4; 2], stress);
    let matched = mortar::project(&over, &under, &projection(Multipliers::Dual)).unwrap();
    let nearest = |x: f64| {
        let distance = |k: &usize| (under.parameter()[*k] - x).abs();
        (0..under.nodes().len())
            .min_by(|i, j| distance(i).total_cmp(&distance(j)))
            .unwrap()
    };
    let points: Vec<ContactPoint> = matched
        .points
        .into_iter()
        .zip(over.parameter())
        .map(|(point, &x)| ContactPoint {
            second: nearest(x).into(),
            ..point
        })
        .collect();
    let solved = solve([&first, &second], points, 0.0, &[1.0]);
    assert!(check_stress(&second, 1, &solved, stress) > 0.1);
}

/// The first edge reaches past the second at both ends, whose ends lie anywhere within its edges.
#[test]
fn constant_stress_passes_edges_that_overlap_in_part() {
    let stress = [0.0, -2.0, 0.0];
    let ground: [&[f64]; 3] = [
        &[-3.0, -1.2, 0.35, 1.0, 2.9, 4.4, 6.0],
        &[-1.0, 0.999_99, 2.0, 3.000_01, 3.5],
        &[-10.0, 10.0],
    ];
    for xs in ground {
        for order in [1, 2, 4] {
            let mut parameter = vec![xs[0]];
            let line = edge_nodes(order).unwrap();
            for pair in xs.windows(2) {
                let inner = line[1..order].iter().map(|(t, _)| 0.5 * (1.0 + t));
                parameter.extend(inner.map(|t| (1.0 - t) * pair[0] + t * pair[1]));
                parameter.push(pair[1]);
            }
            for (kind, multipliers) in ALL.into_iter().flat_map(|k| BOTH.map(|m| (k, m))) {
                let what = format!("{kind:?} under {xs:?} of order {order}, {multipliers:?}");
                let places = parameter.iter().map(|&x| [x, 0.0]).collect();
                let held = RigidBody::held(places, 1);
                let nodes = (0..parameter.len()).collect();
                let over = EdgeSide::open(nodes, parameter.clone(), order).unwrap();
                let lower = rectangle(&LOWER, [-1.0, 0.0], kind);
                let (lower_nodes, under) = along_x(&lower, "top");
                let left = hold(vec![nodes_of(&lower, "bottom")[0]], HeldDirection::X);
                let body = stressed(lower, &lower_nodes, stress, &["bottom"], vec![left]);
                let made = mortar::project(&over, &under, &projection(multipliers)).unwrap();
                let length: f64 = made.points.iter().map(|point| point.area).sum();
                assert!((length - 3.0 * THICKNESS).abs() < EXACT, "{what}: {length}");
                let solved = solve([&held, &body], made.points, 0.0, &[1.0]);
                // More points than nodes of the block leave the forces of single points undetermined, not the stress.
                let error = check_stress(&body, 1, &solved, stress);
                assert!(error < 10.0 * ROUNDING, "{what}: {error:.1e}");
            }
        }
    }
}
