//! Edge sets cover the boundary, each edge once, on its exact curve.

use std::collections::BTreeMap;

use stickslip_fem_core::mesh::{Curve, EdgeRef, ElementKind, Mesh, Point};
use stickslip_mesher::{ContourError, ContourMesh};

use crate::shapes::{acute, all, disk, lug, meshed, of_kind, slotted};

fn boundary(mesh: &Mesh) -> Vec<EdgeRef> {
    let mut uses: BTreeMap<[usize; 2], Vec<EdgeRef>> = BTreeMap::new();
    for element in 0..mesh.element_count() {
        for edge in 0..3 {
            let edge = EdgeRef { element, edge };
            let mut ends = mesh.edge_nodes(edge).ends;
            ends.sort_unstable();
            uses.entry(ends).or_default().push(edge);
        }
    }
    assert!(uses.values().all(|edges| edges.len() <= 2));
    let single = uses.values().filter(|edges| edges.len() == 1);
    let mut boundary: Vec<EdgeRef> = single.map(|edges| edges[0]).collect();
    boundary.sort_unstable();
    boundary
}

fn names(mesh: &ContourMesh) -> Vec<&str> {
    let contour = &mesh.contour;
    let cut = contour.cutouts.iter().flat_map(|own| &own.pieces);
    let pieces = contour.pieces.iter().chain(cut);
    let pieces = pieces.map(|piece| piece.name.as_str());
    let holes = contour.holes.iter().map(|hole| hole.name.as_str());
    let mut names: Vec<&str> = pieces.chain(holes).collect();
    names.sort_unstable();
    names.dedup();
    names
}

#[test]
fn every_boundary_edge_is_in_one_set() {
    let mut bodies = all();
    bodies.push(("acute", acute()));
    for (name, contour) in bodies {
        let description = of_kind(contour, ElementKind::T6);
        let mesh = description.mesh(1_000_000).expect("a mesh");
        let found: Vec<&str> = mesh.edge_set_names().collect();
        assert_eq!(found, names(&description), "{name}");
        let mut edges: Vec<EdgeRef> = Vec::new();
        for set in found {
            edges.extend(&mesh.edge_set(set).expect("a named set").edges);
        }
        edges.sort_unstable();
        assert_eq!(edges, boundary(&mesh), "{name}");
    }
}

/// All nodes of an arc, the inner ones of its edges too, lie on it to rounding.
#[test]
fn nodes_lie_on_the_exact_curve() {
    for (name, contour) in all() {
        let mesh = meshed(contour, ElementKind::T6);
        for set in mesh.edge_set_names() {
            let set = mesh.edge_set(set).expect("a named set");
            let nodes = set
                .edges
                .iter()
                .flat_map(|&edge| mesh.edge_nodes(edge).walk());
            let points: Vec<Point> = nodes.map(|n| mesh.nodes()[n]).collect();
            // Splines have tests of their own.
            let Some(curve) = set.curve else {
                assert_eq!(name, "crowned");
                continue;
            };
            match curve {
                Curve::Arc { centre, radius } => {
                    let off = |p: &Point| (p[0] - centre[0]).hypot(p[1] - centre[1]) - radius;
                    assert!(points.iter().all(|p| off(p).abs() < 1e-13 * 10.0), "{name}");
                }
                Curve::Line => {
                    let (a, b) = (points[0], points[1]);
                    let cross =
                        |p: &Point| (b[0] - a[0]) * (p[1] - a[1]) - (b[1] - a[1]) * (p[0] - a[0]);
                    assert!(points.iter().all(|p| cross(p).abs() < 1e-12), "{name}");
                }
            }
        }
    }
}

/// Nodes of a hole are at the angles given, in order against its circle: the body is on the left.
#[test]
fn holes_keep_their_angles() {
    let count = 40;
    let contour = lug(count);
    let angles = contour.holes[0].angles.clone();
    let mesh = meshed(contour, ElementKind::T3);
    let edges = &mesh.edge_set("hole").expect("a set").edges;
    assert_eq!(edges.len(), count);
    for (k, &edge) in edges.iter().enumerate() {
        let [from, to] = mesh.edge_nodes(edge).ends.map(|n| mesh.nodes()[n]);
        let expected = |angle: f64| [0.5 * angle.cos(), 0.5 * angle.sin()];
        let near = |a: Point, b: Point| (a[0] - b[0]).hypot(a[1] - b[1]) < 1e-15 * 4.0;
        assert!(near(from, expected(angles[(k + 1) % count])));
        assert!(near(to, expected(angles[k])));
    }
}

#[test]
fn neighbours_on_one_circle_share_a_set() {
    let mesh = meshed(disk(), ElementKind::T6);
    let set = mesh.edge_set("rim").expect("a set");
    // A tenth of the width of 2 is the spacing: 15.7 of it on each half.
    assert_eq!(set.edges.len(), 32);
    assert!(matches!(set.curve, Some(Curve::Arc { radius, .. }) if (radius - 1.0).abs() < 1e-15));
}

#[test]
fn points_are_nodes_where_edges_end() {
    let mut description = of_kind(slotted(), ElementKind::T6);
    let points = [("corner", [8.0, 4.0]), ("tangent", [3.25, 1.625])];
    let points = points.map(|(name, at)| (name.to_owned(), at));
    description.division.points = BTreeMap::from(points.clone());
    description.division.centre = [10.0, 0.0];
    let mesh = description.mesh(1_000_000).expect("a mesh");
    for (name, [x, y]) in points {
        let [node] = mesh.node_set(&name).expect("a set") else {
            panic!("one node of {name}");
        };
        let [own, level] = mesh.nodes()[*node];
        assert!((own - 10.0 - x).hypot(level - y) < 1e-12, "{name}");
    }
    description.division.points = BTreeMap::from([("nowhere".to_owned(), [4.0, 0.0])]);
    assert!(
        matches!(description.check(), Err(ContourError::NoEnd { point, .. }) if point == "nowhere")
    );
}

/// A circle of arcs is one edge on one circle, and the body is on the left of a cut-out.
#[test]
fn cutouts_are_walked_with_the_body_on_the_left() {
    let mesh = meshed(slotted(), ElementKind::T6);
    let set = mesh.edge_set("round").expect("a set");
    assert!(matches!(set.curve, Some(Curve::Arc { radius, .. }) if (radius - 0.5).abs() < 1e-12));
    assert!(mesh.edge_path("round").expect("a path").closed);
    for (set, direction) in [("slot below", [-1.0, 0.0]), ("slot above", [1.0, 0.0])] {
        for &edge in &mesh.edge_set(set).expect("a set").edges {
            let [from, to] = mesh.edge_nodes(edge).ends.map(|n| mesh.nodes()[n]);
            assert!((to[0] - from[0]) * direction[0] > 0.0, "{set}");
        }
    }
}
