//! A cylinder pressed on a stiffer block with friction: edges that do not match against edges that do.

use std::sync::Arc;

use stickslip_contact::{
    ContactPoint, InitialGap, Multipliers, Projected, Projection, gap, mortar,
};
use stickslip_fem_core::generate::{CylinderOnBlock, CylinderOnBlockMeshes, Extent, Generate};
use stickslip_fem_core::material::{Isotropic, PlaneState};
use stickslip_fem_core::mesh::{ElementKind, Mesh};
use stickslip_fem_core::{CondensedBody, ElasticBody, HeldDirection, LoadCase, Support};

use crate::blocks::nodes_of;
use crate::{BOTH, along_x, solve, tractions};

const RADIUS: f64 = 100.0;
const INNER: f64 = 2.0;

fn meshes(cells: usize, kind: ElementKind) -> CylinderOnBlockMeshes {
    CylinderOnBlock {
        radius: RADIUS,
        half_width: 16.0,
        height: 16.0,
        inner: INNER,
        spacing: INNER / cells as f64,
        // The whole mesh is refined, not the contact alone.
        growth: 1.0 + 1.6 / cells as f64,
        columns: None,
        extent: Extent::Half,
        kind,
    }
    .generate()
    .unwrap()
}

fn body(
    mesh: Mesh,
    interface: &[usize],
    young: f64,
    far: &str,
    displacement: f64,
) -> CondensedBody {
    let support = |side: &str, direction, displacement| Support {
        nodes: nodes_of(&mesh, side),
        direction,
        displacement,
    };
    let supports = [
        support(far, HeldDirection::Y, displacement),
        support("symmetry", HeldDirection::X, 0.0),
    ];
    let material = Arc::new(Isotropic::new(young, 0.3, PlaneState::Strain).unwrap());
    let case = LoadCase {
        moves_supports: true,
        ..LoadCase::default()
    };
    let body = ElasticBody::new(Arc::new(mesh), vec![material], 1.0)
        .unwrap()
        .with_supports(supports)
        .with_load_cases(vec![case])
        .unwrap();
    Arc::new(body).condense(interface).unwrap()
}

#[derive(Clone, Copy)]
enum How {
    Mortar(Multipliers),
    NodePairs,
}

/// Normal force, pressure at the centre, and friction Σ |λ_t|, of half the contact; meshes of `cells` cells in the middle.
fn pressed(cells: [usize; 2], kind: ElementKind, how: How) -> [f64; 3] {
    let (upper, lower) = (meshes(cells[0], kind).upper, meshes(cells[1], kind).lower);
    let (upper_nodes, over) = along_x(&upper, "contact");
    let (lower_nodes, under) = along_x(&lower, "contact");
    let exact = |x: f64| gap::cylinder(RADIUS, x);
    let projection = |multipliers| Projection {
        multipliers,
        length: 1.0,
        thickness: 1.0,
        normal: &|_| [0.0, 1.0],
        gap: InitialGap::Exact(&exact),
        material_angle: 0.0,
        symmetry: [true, false],
    };
    let points = match how {
        How::Mortar(multipliers) => {
            mortar::project(&over, &under, &projection(multipliers))
                .unwrap()
                .points
        }
        How::NodePairs => {
            let Projected { points, .. } =
                mortar::project(&over, &over, &projection(Multipliers::Dual)).unwrap();
            let pair = |(k, point): (usize, ContactPoint)| ContactPoint {
                first: k.into(),
                second: k.into(),
                gap: exact(over.parameter()[k]),
                ..point
            };
            points.into_iter().enumerate().map(pair).collect()
        }
    };
    let first = body(upper, &upper_nodes, 100.0, "top", -0.03);
    let second = body(lower, &lower_nodes, 300.0, "bottom", 0.0);
    let (problem, record) = solve([&first, &second], points, 0.1, &[1.0]);
    let friction = record.audit.pairs[0];
    [
        friction.normal,
        tractions(&problem, &record)[0][0],
        friction.friction,
    ]
}

/// The normal force converges with h² on linear edges as it does between nodes that match; the pressure of one point ripples
/// with the pattern of the two spacings, of the order h. Bounds are the errors measured when this was written, with half
/// as much again; the reference's own error is some 10⁻⁵.
#[test]
fn edges_that_do_not_match_converge_as_those_that_do() {
    let reference = pressed([48, 48], ElementKind::Q8, How::NodePairs);
    let errors = |cells, kind, how| -> [f64; 3] {
        let found = pressed(cells, kind, how);
        std::array::from_fn(|i| (found[i] / reference[i] - 1.0).abs())
    };
    for multipliers in BOTH {
        let how = How::Mortar(multipliers);
        for ratio in [2, 3, 4] {
            let what = format!("{multipliers:?}, 3 : {ratio}");
            let [coarse, fine] = [4, 8].map(|k| errors([3 * k, ratio * k], ElementKind::Q4, how));
            assert!(
                (coarse[0] / fine[0]).log2() > 1.8,
                "{what}: {coarse:?} {fine:?}"
            );
            for (error, bound) in fine.into_iter().zip([1e-3, 4e-3, 7e-3]) {
                assert!(error < bound, "{what}: {fine:?}");
            }
            let quadratic = errors([24, 8 * ratio], ElementKind::Q8, how);
            for (error, bound) in quadratic.into_iter().zip([3e-5, 3e-4, 6e-4]) {
                assert!(error < bound, "{what}: {quadratic:?}");
            }
        }
    }
}

/// On edges that match, quadratic dual points differ from pairs of nodes by the gap's mean alone.
#[test]
fn edges_that_match_give_the_answer_of_node_pairs() {
    for kind in [ElementKind::Q4, ElementKind::Q8] {
        let pairs = pressed([24, 24], kind, How::NodePairs);
        for multipliers in BOTH {
            let mortar = pressed([24, 24], kind, How::Mortar(multipliers));
            for (a, b) in mortar.into_iter().zip(pairs) {
                // Both err by h², here (1/12)² of half the contact.
                assert!(
                    (a / b - 1.0).abs() < 5e-3,
                    "{kind:?} {multipliers:?}: {a} {b}"
                );
            }
        }
    }
}
