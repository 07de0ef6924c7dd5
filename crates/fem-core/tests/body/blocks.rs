//! A compliance in blocks is that of one matrix.

use std::sync::Arc;

use stickslip_fem_core::body::BodyLoad;
use stickslip_fem_core::interface::contract::{Known, check};
use stickslip_fem_core::mesh::ElementKind;
use stickslip_fem_core::{ElasticBody, HeldDirection, InterfaceOperator, LoadCase, Support};

use crate::fields::{THICKNESS, ply};
use crate::meshes::{Noise, nearest, rectangle, side_nodes};

/// Rounding of either way, of which each solves with numbers of a condition up to 10⁵, and what blocks leave out.
const EQUAL: f64 = 1e-9;

/// A strip with contact at both ends and at some nodes of its upper side, held along the middle of the lower one or not at all.
fn strip(kind: ElementKind, held: bool, seed: u64) -> (Arc<ElasticBody>, Vec<usize>, Vec<usize>) {
    let mesh = rectangle(kind, [0.0, 6.0], [0.0, 1.0], [24, 4]);
    let mut interface = Vec::new();
    let mut ends = Vec::new();
    for side in ["left", "right"] {
        interface.extend(side_nodes(&mesh, &[side]));
        ends.push(interface.len());
    }
    let inside = |&node: &usize| (2.4..3.6).contains(&mesh.nodes()[node][0]);
    interface.extend(
        side_nodes(&mesh, &["top"])
            .iter()
            .filter(|node| inside(node)),
    );
    ends.push(interface.len());
    let middle = nearest(&mesh, [3.0, 0.0]);
    let cases = vec![
        LoadCase {
            forces: Noise::new(seed).vector(2 * mesh.nodes().len()),
            ..LoadCase::default()
        },
        LoadCase::default(),
    ];
    let hold = |direction| Support {
        nodes: vec![middle, middle + 1],
        direction,
        displacement: 0.0,
    };
    let supports = [HeldDirection::X, HeldDirection::Y].map(hold);
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS)
        .unwrap()
        .with_supports(supports.into_iter().filter(|_| held))
        .with_load_cases(cases)
        .unwrap();
    (Arc::new(body), interface, ends)
}

#[test]
fn blocks_are_the_parts_of_one_matrix() {
    for kind in [ElementKind::T3, ElementKind::T6, ElementKind::Q8] {
        for (held, seed) in [(true, 3), (false, 4)] {
            let (body, interface, ends) = strip(kind, held, seed);
            let whole = body.condense(&interface).unwrap();
            let own = body.condense_edges(&interface, &ends).unwrap();
            let blocks = own.blocks().unwrap();
            assert!(own.compliance().is_none() && whole.blocks().is_none());
            assert_eq!(blocks.blocks().len(), 3);
            let known = Known {
                placed: true,
                resultants: &[],
            };
            assert_eq!(check(&own, known), Ok(()));
            let (one, other) = (whole.compliance().unwrap(), blocks.matrix());
            let error = (one - &other).amax() / one.amax();
            assert!(error < EQUAL, "{kind:?} {held}: {error:.1e}");
            assert!(blocks.entries() < 2 * one.len());

            let [one, other] = [&whole, &own].map(|body| body.load_response(0).unwrap());
            let error = (one - other).amax() / one.amax();
            assert!(error < EQUAL, "{kind:?} {held}: {error:.1e}");
            assert!(own.load_response(1).is_none());

            let forces = Noise::new(seed + 7).vector(2 * interface.len());
            let still = vec![0.0; own.modes().ncols()];
            let state = BodyLoad {
                forces: &forces,
                multipliers: &[0.7, 1.0],
                motions: &still,
            };
            let inside = own.displacements_of(&[state]).swap_remove(0);
            let seen = InterfaceOperator::displacements(&own, &forces, &still, state.multipliers);
            for (row, &node) in seen.as_slice().chunks(2).zip(&interface) {
                for axis in 0..2 {
                    let error = (row[axis] - inside[2 * node + axis]).abs() / seen.amax();
                    assert!(error < EQUAL, "{kind:?} {held}: {error:.1e}");
                }
            }
        }
    }
}

#[test]
fn edges_that_share_a_cell_have_one_matrix() {
    let mesh = rectangle(ElementKind::Q8, [0.0, 2.0], [0.0, 1.0], [8, 4]);
    let mut interface = side_nodes(&mesh, &["left"]);
    let first = interface.len();
    let bottom = side_nodes(&mesh, &["bottom"]);
    interface.extend(bottom.iter().filter(|&&node| mesh.nodes()[node][0] > 0.01));
    let ends = [first, interface.len()];
    let body = ElasticBody::new(Arc::new(mesh), vec![ply(0.5)], THICKNESS).unwrap();
    let own = Arc::new(body).condense_edges(&interface, &ends).unwrap();
    assert!(own.blocks().is_none() && own.compliance().is_some());
}
