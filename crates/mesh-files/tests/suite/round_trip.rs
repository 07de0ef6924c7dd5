//! Meshes of the generators, written and read again.

use std::collections::BTreeMap;

use stickslip_fem_core::generate::{
    Disk, Extent, Generate, Growth, Outline, PlateWithHole, Rectangle, uniform_angles,
};
use stickslip_fem_core::material::PlaneState;
use stickslip_fem_core::mesh::{
    Curve, EdgeRef, EdgeSet, ElementBlock, ElementKind, Mesh, MeshParts, Point,
};
use stickslip_mesh_files::{
    CurveError, Format, WriteError, put_on_circles, recognise_set, snap, write_inp, write_msh,
};

use super::{ends, imported};

pub(super) fn meshes(kind: ElementKind) -> Vec<Mesh> {
    let growth = Growth::Geometric { aspect: 1.0 };
    let angles = uniform_angles(Extent::Whole, 16);
    let plate = PlateWithHole {
        hole_radius: 0.375,
        outline: Outline::Strip {
            half_width: 1.495,
            left: 4.0,
            right: 1.5,
        },
        extent: Extent::Whole,
        angles: angles.clone(),
        layers: 4,
        growth: growth.clone(),
        far_cells: 3,
        kind,
    };
    let disk = Disk {
        radius: 0.4,
        centre: [1.0, 2.0],
        extent: Extent::Whole,
        angles,
        core: Disk::CORE,
        layers: 3,
        growth,
        kind,
    };
    let rectangle = Rectangle::uniform([0.0, 2.0], [0.0, 1.0], [4, 3], kind);
    vec![
        plate.generate().expect("a plate"),
        disk.generate().expect("a disk"),
        rectangle.and_then(|r| r.generate()).expect("a rectangle"),
    ]
}

fn edges(parts: &MeshParts) -> BTreeMap<&str, Vec<EdgeRef>> {
    let sets = parts.edge_sets.iter().map(|(name, set)| {
        let mut edges = set.edges.clone();
        edges.sort_unstable();
        (name.as_str(), edges)
    });
    sets.collect()
}

fn nodes(parts: &MeshParts) -> BTreeMap<&str, Vec<usize>> {
    let sets = parts.node_sets.iter().map(|(name, nodes)| {
        let mut nodes = nodes.clone();
        nodes.sort_unstable();
        (name.as_str(), nodes)
    });
    sets.collect()
}

#[test]
fn msh_gives_the_same_mesh() {
    for kind in ElementKind::COMMON {
        for mesh in meshes(kind) {
            let text = write_msh(&mesh).expect("a kind that Gmsh has");
            let file = imported(&text, Format::Gmsh);
            let parts = mesh.clone().into_parts();
            assert_eq!(file.parts.nodes, parts.nodes);
            assert_eq!(file.parts.blocks, parts.blocks);
            assert_eq!(nodes(&file.parts), nodes(&parts));
            assert_eq!(edges(&file.parts), edges(&parts));
            assert_eq!(file.notes, []);
        }
    }
}

#[test]
fn inp_gives_the_same_mesh() {
    use ElementKind::{Q4, Q8, T3, T6};
    for kind in [T3, T6, Q4, Q8] {
        for mesh in meshes(kind) {
            let text = write_inp(&mesh, PlaneState::Stress).expect("a kind that Abaqus has");
            let file = imported(&text, Format::Abaqus);
            let parts = mesh.clone().into_parts();
            // 20 characters hold at least 13 digits.
            let scale = 5.0;
            for (a, b) in file.parts.nodes.iter().zip(&parts.nodes) {
                let off = (a[0] - b[0]).abs().max((a[1] - b[1]).abs());
                assert!(off <= 1e-13 * scale, "{off}");
            }
            assert_eq!(file.parts.blocks, parts.blocks);
            assert_eq!(nodes(&file.parts), nodes(&parts));
            assert_eq!(edges(&file.parts), edges(&parts));
        }
    }
}

#[test]
fn sets_of_cells_survive_beside_their_block() {
    let rectangle = Rectangle::uniform([0.0, 2.0], [0.0, 1.0], [4, 3], ElementKind::Q4);
    let mut parts = rectangle
        .and_then(|r| r.generate())
        .expect("a rectangle")
        .into_parts();
    parts.blocks[0].name = "my block".to_owned();
    parts.element_sets.insert("soft".to_owned(), vec![0, 5, 7]);
    parts.element_sets.insert("my block".to_owned(), vec![1]);
    let mesh = Mesh::new(parts.clone()).expect("a valid mesh");
    let msh = imported(&write_msh(&mesh).expect("text"), Format::Gmsh);
    let inp = write_inp(&mesh, PlaneState::Strain).expect("text");
    assert!(inp.contains("*ELEMENT, TYPE=CPE4, ELSET=\"my block-block\""));
    for file in [msh, imported(&inp, Format::Abaqus)] {
        assert_eq!(file.parts.element_sets["soft"], [0, 5, 7]);
        assert_eq!(file.parts.element_sets["my block"], [1]);
        assert_eq!(file.parts.element_sets["my block-block"].len(), 12);
        assert_eq!(
            file.parts.blocks[0].connectivity,
            parts.blocks[0].connectivity
        );
        assert_eq!(ends(&file, "left").len(), 3);
    }
}

#[test]
fn cells_and_names_without_a_place_in_the_format_are_refused() {
    let refused = |kind| {
        let rectangle = Rectangle::uniform([0.0, 1.0], [0.0, 1.0], [1, 1], kind);
        rectangle.and_then(|r| r.generate()).expect("a rectangle")
    };
    let kind = |result| matches!(result, Err(WriteError::Kind { .. }));
    assert!(kind(write_inp(
        &refused(ElementKind::Q9),
        PlaneState::Stress
    )));
    assert!(kind(write_msh(&refused(ElementKind::P3))));
    assert!(write_msh(&refused(ElementKind::P2)).is_ok());
    for name in ["a\"b", "", " a", "a\nb"] {
        let mut parts = refused(ElementKind::Q4).into_parts();
        parts.node_sets.insert(name.to_owned(), vec![0]);
        let mesh = Mesh::new(parts).expect("a valid mesh");
        assert!(
            matches!(write_msh(&mesh), Err(WriteError::Name { .. })),
            "{name:?}"
        );
    }
    let mut parts = refused(ElementKind::Q4).into_parts();
    parts.node_sets.insert("LEFT".to_owned(), vec![0]);
    let mesh = Mesh::new(parts).expect("a valid mesh");
    assert!(write_msh(&mesh).is_ok());
    assert!(matches!(
        write_inp(&mesh, PlaneState::Stress),
        Err(WriteError::Name { .. })
    ));
}

#[test]
fn mid_nodes_snap_from_chords_to_the_circle() {
    for kind in [ElementKind::T6, ElementKind::Q8, ElementKind::Q9] {
        let mesh = meshes(kind).swap_remove(0);
        let exact = mesh.clone().into_parts();
        let mut chords = exact.clone();
        let edges = mesh.edge_set("hole").expect("a hole").edges.clone();
        for &edge in &edges {
            let nodes = mesh.edge_nodes(edge);
            let [a, b] = nodes.ends.map(|node| mesh.nodes()[node]);
            chords.nodes[nodes.inner[0]] = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        }
        chords.edge_sets.get_mut("hole").expect("a hole").curve = None;
        let moved = snap(&mut chords, "hole").expect("a circle");
        assert_eq!(moved, edges.len());
        for (a, b) in chords.nodes.iter().zip(&exact.nodes) {
            // The fit and the projection err by rounding of coordinates of size 1.
            assert!(
                (a[0] - b[0]).abs() + (a[1] - b[1]).abs() < 1e-14,
                "{a:?} {b:?}"
            );
        }
        assert_eq!(snap(&mut chords, "hole"), Ok(0));
        // Nor are nodes counted that miss the circle by the digits of a file.
        for node in &mut chords.nodes {
            *node = node.map(|x| (1e9 * x).round() / 1e9);
        }
        assert_eq!(snap(&mut chords, "hole"), Ok(0));
        assert!(snap(&mut chords, "no such set").is_err());
        assert_eq!(snap(&mut chords, "left"), Ok(0));
    }
}

/// Where the radius is known, it is that of the circle, and must be near that of the fit.
#[test]
fn a_declared_circle_takes_a_known_radius() {
    let mut parts = meshes(ElementKind::Q8).swap_remove(0).into_parts();
    let set = parts.edge_sets.get_mut("hole").expect("a hole");
    let Some(Curve::Arc { centre, radius }) = set.curve.take() else {
        panic!("no circle");
    };
    let mut given = |radii: &[f64]| put_on_circles(&mut parts, &["hole".to_owned()], radii);
    let (circles, radii) = (1, 2);
    assert_eq!(
        given(&[radius; 2]),
        Err(CurveError::Radii { circles, radii })
    );
    for other in [1.2 * radius, 0.9 * radius, f64::NAN] {
        let refused = given(&[other]).expect_err("another radius");
        let is_named = |found: f64| (found / radius - 1.0).abs() < 1e-9;
        assert!(
            matches!(refused, CurveError::OtherRadius { found, .. } if is_named(found)),
            "{refused}"
        );
    }
    let put = given(&[1.002 * radius]).expect("a circle")[0];
    assert!((put.circle.residual / radius - 0.002).abs() < 1e-9);
    assert!((put.fitted / radius - 1.0).abs() < 1e-9 && put.scatter < 1e-9 * radius);
    let moved = put.moved;
    let Some(Curve::Arc { radius: own, .. }) = parts.edge_sets["hole"].curve else {
        panic!("no circle");
    };
    assert_eq!(own, 1.002 * radius);
    let distance = |[x, y]: &Point| (x - centre[0]).hypot(y - centre[1]);
    let on = |point: &&Point| (distance(point) / own - 1.0).abs() < 1e-9;
    assert_eq!(parts.nodes.iter().filter(on).count(), moved);
}

/// What is no circle is refused for what it is: six corners on a circle, a set named twice.
#[test]
fn refusals_of_declared_circles_say_why() {
    let mut parts = meshes(ElementKind::Q4).swap_remove(0).into_parts();
    let twice = ["hole".to_owned(), "hole".to_owned()];
    let set = || "hole".to_owned();
    assert_eq!(
        put_on_circles(&mut parts, &twice, &[]),
        Err(CurveError::Twice { set: set() })
    );
    let corner = |k: usize| {
        let angle = std::f64::consts::FRAC_PI_3 * k as f64;
        [angle.cos(), angle.sin()]
    };
    let edges = (0..6).map(|element| EdgeRef { element, edge: 0 });
    let edges = edges.collect();
    let cells = (0..6).flat_map(|k| [k, (k + 1) % 6, 6]);
    let mut hexagon = MeshParts {
        nodes: (0..6).map(corner).chain([[0.0; 2]]).collect(),
        blocks: vec![ElementBlock {
            name: "cells".to_owned(),
            kind: ElementKind::T3,
            connectivity: cells.collect(),
        }],
        edge_sets: [(set(), EdgeSet { edges, curve: None })].into(),
        ..MeshParts::default()
    };
    let refused = put_on_circles(&mut hexagon, &[set()], &[]).expect_err("a refusal");
    assert!(refused.to_string().contains("60.0° apart"), "{refused}");
}

/// Corners of a hole a thousandth off, mid nodes on the chords between them: all are put onto the circle, and nothing else moves.
#[test]
fn a_declared_circle_gets_all_its_nodes() {
    for kind in [ElementKind::Q4, ElementKind::T6, ElementKind::Q8] {
        let mesh = meshes(kind).swap_remove(0);
        let exact = mesh.clone().into_parts();
        let path = mesh.edge_path("hole").expect("a hole");
        let Some(Curve::Arc { centre, radius }) = exact.edge_sets["hole"].curve else {
            panic!("no circle");
        };
        let off = |[x, y]: Point| (x - centre[0]).hypot(y - centre[1]) - radius;
        let moved_by =
            |point: Point, part: f64| [0, 1].map(|k| point[k] + part * (point[k] - centre[k]));
        let mut rough = exact.clone();
        rough.edge_sets.get_mut("hole").expect("a hole").curve = None;
        let corners: Vec<usize> = path.nodes.iter().step_by(path.order).copied().collect();
        for (k, &node) in corners.iter().enumerate() {
            let part = if k % 2 == 0 { 1e-3 } else { -1e-3 };
            rough.nodes[node] = moved_by(rough.nodes[node], part);
        }
        for edge in path.nodes.chunks(path.order).filter(|edge| edge.len() > 1) {
            let at = corners
                .iter()
                .position(|&node| node == edge[0])
                .expect("a corner");
            let [a, b] = [edge[0], corners[(at + 1) % corners.len()]].map(|node| rough.nodes[node]);
            rough.nodes[edge[1]] = [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
        }
        assert!(recognise_set(&rough, "hole").is_err());
        let before = rough.clone();
        let put = put_on_circles(&mut rough, &["hole".to_owned()], &[]).expect("a circle");
        let (found, moved) = (put[0].circle, put[0].moved);
        assert_eq!(moved, path.nodes.len());
        assert_eq!(put[0].scatter, found.residual);
        // Corners are even in number, so that the best circle stays but for the square of the part.
        assert!((found.residual / radius - 1e-3).abs() < 1e-5, "{found:?}");
        let Some(Curve::Arc { radius: put, .. }) = rough.edge_sets["hole"].curve else {
            panic!("no circle");
        };
        assert!((put / radius - 1.0).abs() < 1e-5);
        for (node, (&own, &old)) in rough.nodes.iter().zip(&before.nodes).enumerate() {
            if path.nodes.contains(&node) {
                assert!(off(own).abs() < 1e-5 * radius, "{own:?}");
            } else {
                assert_eq!(own, old);
            }
        }
        let refused = |parts: &mut MeshParts, set: &str| {
            put_on_circles(parts, &[set.to_owned()], &[]).expect_err("a refusal")
        };
        let set = || "hole".to_owned();
        let open = refused(&mut rough, "left");
        assert_eq!(open, CurveError::Open { set: "left".into() });
        // An ellipse with axes in the ratio of 1.15.
        let mut oval = exact.clone();
        for node in &mut oval.nodes {
            node[0] = centre[0] + 1.15 * (node[0] - centre[0]);
        }
        let CurveError::NoCircle {
            set: name,
            radius: best,
            off,
            ..
        } = refused(&mut oval, "hole")
        else {
            panic!("no refusal of an oval");
        };
        assert_eq!(name, set());
        // Half axes of 1.15 and 1 about their mean.
        assert!((best / radius - 1.075).abs() < 2e-3, "{best}");
        assert!((off / radius - 0.075).abs() < 2e-3, "{off}");
        // A node in the hole whose neighbour in the plate follows it: the way back passes that.
        let cells = &exact.blocks[0].connectivity;
        let cell = cells
            .chunks(kind.nodes())
            .find(|cell| cell.contains(&corners[0]));
        let mut inner = cell.expect("a cell").iter().take(kind.edges());
        let inner = *inner
            .find(|node| !path.nodes.contains(node))
            .expect("a node");
        let mut thin = exact.clone();
        thin.nodes[inner] = moved_by(thin.nodes[corners[0]], -0.01);
        thin.nodes[corners[0]] = moved_by(thin.nodes[corners[0]], -0.04);
        assert_eq!(
            refused(&mut thin, "hole"),
            CurveError::Squeezed { sets: set() }
        );
    }
}
