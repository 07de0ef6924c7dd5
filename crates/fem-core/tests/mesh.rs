//! Meshes: what is refused, and how edges become chains.

use std::collections::BTreeMap;

use approx::assert_relative_eq;
use stickslip_fem_core::generate::{Generate, Rectangle};
use stickslip_fem_core::mesh::{
    Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshError, MeshParts,
};

/// Two unit squares side by side:
///
/// ```text
/// 3──4──5
/// │ 0│ 1│
/// 0──1──2
/// ```
fn two_squares() -> MeshParts {
    let edges = |list: &[(usize, usize)]| EdgeSet {
        edges: list
            .iter()
            .map(|&(element, edge)| EdgeRef { element, edge })
            .collect(),
        curve: None,
    };
    MeshParts {
        nodes: vec![
            [0.0, 0.0],
            [1.0, 0.0],
            [2.0, 0.0],
            [0.0, 1.0],
            [1.0, 1.0],
            [2.0, 1.0],
        ],
        blocks: vec![
            block(ElementKind::Q4, &[0, 1, 4, 3]),
            block(ElementKind::Q4, &[1, 2, 5, 4]),
        ],
        node_sets: BTreeMap::from([("corner".to_owned(), vec![0])]),
        edge_sets: BTreeMap::from([
            ("bottom".to_owned(), edges(&[(1, 0), (0, 0)])),
            (
                "around".to_owned(),
                edges(&[(0, 0), (1, 0), (1, 1), (1, 2), (0, 2), (0, 3)]),
            ),
            ("apart".to_owned(), edges(&[(0, 3), (1, 1)])),
            ("star".to_owned(), edges(&[(0, 0), (1, 0), (0, 1)])),
            ("two-sided".to_owned(), edges(&[(0, 1), (1, 3)])),
            ("empty".to_owned(), EdgeSet::default()),
        ]),
        element_sets: BTreeMap::from([("second".to_owned(), vec![1])]),
    }
}

fn block(kind: ElementKind, connectivity: &[usize]) -> ElementBlock {
    let name = format!("{kind:?}");
    ElementBlock {
        name,
        kind,
        connectivity: connectivity.to_vec(),
    }
}

fn refusal(change: impl FnOnce(&mut MeshParts)) -> MeshError {
    let mut parts = two_squares();
    change(&mut parts);
    Mesh::new(parts).expect_err("the mesh has a defect")
}

#[test]
fn a_sound_mesh_answers_for_its_parts() -> Result<(), MeshError> {
    let mesh = Mesh::new(two_squares())?;
    assert_eq!(mesh.element_count(), 2);
    assert_eq!(mesh.element(1), (ElementKind::Q4, &[1, 2, 5, 4][..], 1));
    assert_eq!(
        mesh.edge_nodes(EdgeRef {
            element: 1,
            edge: 3
        })
        .ends,
        [4, 1]
    );
    assert_eq!(mesh.node_set("corner")?, [0]);
    assert_eq!(mesh.element_set("second")?, [1]);
    assert_eq!(mesh.bounding_box(), [[0.0, 0.0], [2.0, 1.0]]);
    assert_eq!(mesh.node_set_names().collect::<Vec<_>>(), ["corner"]);
    assert_eq!(Mesh::new(mesh.clone().into_parts())?, mesh);
    let missing = mesh
        .node_set("bottom")
        .expect_err("there is no such node set");
    assert_eq!(
        missing.to_string(),
        "no node set 'bottom'; the mesh has: corner"
    );
    Ok(())
}

#[test]
fn defects_of_nodes_and_connectivity_are_refused() {
    assert_eq!(Mesh::new(MeshParts::default()), Err(MeshError::Empty));
    let ragged = refusal(|parts| parts.blocks[1].connectivity.truncate(3));
    assert!(matches!(
        ragged,
        MeshError::RaggedConnectivity { length: 3, .. }
    ));
    let outside = refusal(|parts| parts.blocks[1].connectivity[2] = 9);
    assert!(matches!(
        outside,
        MeshError::NodeOutOfRange {
            element: 1,
            node: 9,
            count: 6,
            ..
        }
    ));
    for bad in [f64::NAN, f64::INFINITY] {
        let error = refusal(|parts| parts.nodes[4][1] = bad);
        assert!(matches!(error, MeshError::NonFiniteNode { node: 4, .. }));
    }
    let unused = refusal(|parts| parts.nodes.push([9.0, 9.0]));
    assert_eq!(
        unused,
        MeshError::UnusedNode {
            node: 6,
            at: [9.0, 9.0]
        }
    );
}

#[test]
fn folded_cells_are_refused_with_their_determinant() {
    let clockwise = refusal(|parts| parts.blocks[1].connectivity.reverse());
    // A unit square has the determinant 1/4, clockwise −1/4, everywhere.
    let MeshError::Inverted {
        element: 1,
        block,
        determinant,
        ..
    } = clockwise
    else {
        panic!("{clockwise}")
    };
    assert_eq!(block, "Q4");
    assert_relative_eq!(determinant, -0.25);
    // A re-entrant corner: only the corner check sees it, the quadrature points are positive.
    let reentrant = refusal(|parts| parts.nodes[5] = [1.45, 0.45]);
    assert!(matches!(
        reentrant,
        MeshError::Inverted {
            element: 1,
            at: [1.0, 1.0],
            ..
        }
    ));
}

#[test]
fn cells_without_area_are_refused() {
    let flat = refusal(|parts| {
        for k in 3..6 {
            parts.nodes[k][1] = 0.0;
        }
    });
    assert!(matches!(flat, MeshError::ZeroArea { element: 0, .. }));
    // Flat far from the origin and askew: the determinant is rounding, of either sign.
    for slope in [0.1, 0.7, -1.3] {
        let nodes = [0.1, 0.2, 0.3].map(|x| [1e6 + x, 3e5 + slope * x]).to_vec();
        let blocks = vec![block(ElementKind::T3, &[0, 1, 2])];
        let flat = Mesh::new(MeshParts {
            nodes,
            blocks,
            ..MeshParts::default()
        });
        assert!(matches!(flat, Err(MeshError::ZeroArea { element: 0, .. })));
    }
    let repeated = refusal(|parts| parts.blocks[0].connectivity = vec![0, 1, 1, 3]);
    assert!(matches!(repeated, MeshError::ZeroArea { element: 0, .. }));
}

#[test]
fn quadratic_cells_with_a_displaced_mid_side_node_are_refused()
-> Result<(), Box<dyn std::error::Error>> {
    let square = Rectangle::uniform([0.0, 1.0], [0.0, 1.0], [1, 1], ElementKind::Q8)?.generate()?;
    // A mid-side node at the quarter point makes the Jacobian singular at the corner (Barsoum, 1976).
    let mut parts = square.into_parts();
    let middle = parts
        .nodes
        .iter()
        .position(|p| *p == [0.5, 0.0])
        .ok_or("no mid-side node")?;
    parts.nodes[middle][0] = 0.2;
    assert!(matches!(
        Mesh::new(parts.clone()),
        Err(MeshError::Inverted { .. })
    ));
    parts.nodes[middle][0] = 0.3;
    assert!(Mesh::new(parts).is_ok());
    Ok(())
}

#[test]
fn sets_must_name_existing_things_once() {
    let node = refusal(|parts| drop(parts.node_sets.insert("far".to_owned(), vec![0, 6])));
    let text = node.to_string();
    assert!(
        text.contains("contains node 6, but there are only 6"),
        "{text}"
    );
    assert!(matches!(
        node,
        MeshError::SetOutOfRange { family: "node", set, what, count: 6 } if set == "far" && what == "node 6"
    ));
    let cell = refusal(|parts| drop(parts.element_sets.insert("far".to_owned(), vec![2])));
    assert!(matches!(
        cell,
        MeshError::SetOutOfRange {
            family: "element",
            count: 2,
            ..
        }
    ));
    for edge in [
        EdgeRef {
            element: 2,
            edge: 0,
        },
        EdgeRef {
            element: 0,
            edge: 4,
        },
    ] {
        let far = EdgeSet {
            edges: vec![edge],
            curve: None,
        };
        let error = refusal(|parts| drop(parts.edge_sets.insert("far".to_owned(), far)));
        assert!(matches!(
            error,
            MeshError::SetOutOfRange { family: "edge", .. }
        ));
    }
    let twice = refusal(|parts| drop(parts.node_sets.insert("twice".to_owned(), vec![3, 3])));
    assert!(matches!(twice, MeshError::DuplicateInSet { .. }));
}

#[test]
fn edges_join_to_chains_with_the_cells_on_the_left() -> Result<(), MeshError> {
    let mesh = Mesh::new(two_squares())?;
    let bottom = mesh.edge_path("bottom")?;
    assert_eq!(
        (&bottom.nodes[..], bottom.closed, bottom.order),
        (&[0, 1, 2][..], false, 1)
    );
    assert_eq!(
        bottom.edges[0],
        EdgeRef {
            element: 0,
            edge: 0
        }
    );
    let around = mesh.edge_path("around")?;
    assert_eq!(
        (&around.nodes[..], around.closed),
        (&[0, 1, 2, 5, 4, 3][..], true)
    );
    assert_eq!(around.reversed().nodes, [0, 3, 4, 5, 2, 1]);
    assert_eq!(around.reversed().reversed(), around);
    assert_eq!(mesh.edge_weights(&bottom, None), [0.5, 1.0, 0.5]);
    assert_eq!(mesh.edge_weights(&around, Some(Curve::Line)), [1.0; 6]);
    Ok(())
}

#[test]
fn sets_that_are_not_one_chain_are_refused() -> Result<(), MeshError> {
    let mesh = Mesh::new(two_squares())?;
    let set = |name: &str| name.to_owned();
    let refused = |name: &str| mesh.edge_path(name).expect_err("not a chain");
    assert_eq!(refused("empty"), MeshError::EmptySet { set: set("empty") });
    assert_eq!(
        refused("apart"),
        MeshError::DisconnectedEdge {
            set: set("apart"),
            chains: 2
        }
    );
    let star = MeshError::NonManifoldEdge {
        set: set("star"),
        node: 1,
        edges: 3,
    };
    assert_eq!(refused("star"), star);
    let turned = MeshError::MixedOrientation {
        set: set("two-sided"),
        node: 1,
    };
    assert_eq!(refused("two-sided"), turned);
    assert!(matches!(refused("no such"), MeshError::MissingSet { .. }));
    Ok(())
}

#[test]
fn neighbours_seen_from_opposite_sides_are_refused() -> Result<(), MeshError> {
    let mut parts = two_squares();
    let edges = vec![
        EdgeRef {
            element: 0,
            edge: 0,
        },
        EdgeRef {
            element: 1,
            edge: 3,
        },
    ];
    parts
        .edge_sets
        .insert("turned".to_owned(), EdgeSet { edges, curve: None });
    let error = Mesh::new(parts)?
        .edge_path("turned")
        .expect_err("both edges arrive at node 1");
    assert_eq!(
        error,
        MeshError::MixedOrientation {
            set: "turned".to_owned(),
            node: 1
        }
    );
    Ok(())
}

#[test]
fn linear_and_quadratic_edges_do_not_mix() -> Result<(), MeshError> {
    let nodes = vec![
        [0.0, 0.0],
        [1.0, 0.0],
        [0.0, 1.0],
        [2.0, 0.0],
        [1.0, 1.0],
        [1.5, 0.0],
        [1.5, 0.5],
        [1.0, 0.5],
    ];
    let linear = block(ElementKind::T3, &[0, 1, 2]);
    let quadratic = block(ElementKind::T6, &[1, 3, 4, 5, 6, 7]);
    let edges = vec![
        EdgeRef {
            element: 0,
            edge: 0,
        },
        EdgeRef {
            element: 1,
            edge: 0,
        },
    ];
    let edge_sets = BTreeMap::from([("bottom".to_owned(), EdgeSet { edges, curve: None })]);
    let mesh = Mesh::new(MeshParts {
        nodes,
        blocks: vec![linear, quadratic],
        edge_sets,
        ..MeshParts::default()
    })?;
    let error = mesh.edge_path("bottom").expect_err("the orders differ");
    assert_eq!(
        error,
        MeshError::MixedOrder {
            set: "bottom".to_owned()
        }
    );
    Ok(())
}
