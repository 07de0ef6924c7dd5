//! Angles, sizes and repeatability of cells.

use std::collections::BTreeMap;

use stickslip_fem_core::generate::Generate;
use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};
use stickslip_mesher::{Contour, ContourMesh, Division, quality};

use crate::shapes::{acute, all, angle_plate, hole, meshed, rectangle, slot, strip};

/// Least angle that the crate states for cells away from acute corners, in degrees.
const LEAST: f64 = 25.0;

fn corners(mesh: &Mesh, cell: usize) -> [Point; 3] {
    let (_, nodes, _) = mesh.element(cell);
    [0, 1, 2].map(|k| mesh.nodes()[nodes[k]])
}

fn distance(a: Point, b: Point) -> f64 {
    (a[0] - b[0]).hypot(a[1] - b[1])
}

fn least_angle(corners: [Point; 3]) -> f64 {
    let sides = [0, 1, 2].map(|k| distance(corners[k], corners[(k + 1) % 3]));
    let angles = [0, 1, 2].map(|k| {
        let [a, b, c] = [sides[k], sides[(k + 1) % 3], sides[(k + 2) % 3]];
        ((b * b + c * c - a * a) / (2.0 * b * c))
            .acos()
            .to_degrees()
    });
    angles.into_iter().fold(180.0, f64::min)
}

#[test]
fn cells_are_well_shaped() {
    for (name, contour) in all() {
        let mesh = meshed(contour, ElementKind::T3);
        let quality = quality(&mesh);
        let least = quality.least_angle.to_degrees();
        assert!(least > LEAST, "{name}: {least}");
        let again = least_angle(corners(&mesh, quality.worst));
        assert!((again - least).abs() < 1e-9, "{name}: {again} {least}");
        // Two angles of at least 25° leave 130° for the third.
        assert!(quality.greatest_angle.to_degrees() < 130.0, "{name}");
    }
}

/// Only the cell that fills an acute corner has its angle.
#[test]
fn acute_corners_harm_one_cell() {
    let mesh = meshed(acute(), ElementKind::T3);
    let flat: Vec<f64> = (0..mesh.element_count())
        .map(|cell| least_angle(corners(&mesh, cell)))
        .filter(|&angle| angle < LEAST)
        .collect();
    assert_eq!(flat.len(), 1);
    assert!((flat[0] - 20.0).abs() < 1e-9, "{flat:?}");
}

/// Narrow gaps beside a hole and between holes have cells as good as elsewhere.
#[test]
fn gaps_are_filled() {
    for gap in [0.02, 0.05, 0.1, 0.2] {
        let below = hole("below", [3.0, 0.5 + gap], 0.5, 90);
        let above = hole("above", [3.0, 1.5 + 2.0 * gap], 0.5, 90);
        let mesh = meshed(rectangle(6.0, 3.0, vec![below, above]), ElementKind::T6);
        let least = quality(&mesh).least_angle.to_degrees();
        // Edges of 0.035 face each other across 0.02: cells between them are as flat as a right triangle of these sides.
        let bound = if gap < 0.035 { 20.0 } else { LEAST };
        assert!(least > bound, "{gap}: {least}");
    }
}

/// A wall of a twentieth of the thickness beside a slot has cells across it as good as elsewhere.
#[test]
fn walls_beside_cutouts_are_filled() {
    for wall in [0.05, 0.2, 1.0] {
        let contour = Contour {
            cutouts: vec![slot("slot", [3.0, 0.5 + wall], 1.0, 0.5)],
            ..rectangle(6.0, 3.0, Vec::new())
        };
        let mesh = meshed(contour, ElementKind::T6);
        let least = quality(&mesh).least_angle.to_degrees();
        assert!(least > LEAST, "{wall}: {least}");
        let near = |x: &f64| (x - 3.0).abs() < 0.5 && *x > 0.0;
        let below = mesh.node_set("bottom").expect("a set").iter();
        let below = below
            .map(|&node| mesh.nodes()[node][0])
            .filter(near)
            .count();
        // Corner and mid nodes of cells of a quarter of the wall, or a tenth of the width.
        let expected = 2.0 / (wall / 4.0).min(0.3);
        assert!(below as f64 > 0.5 * expected, "{wall}: {below} {expected}");
    }
}

/// Fifty holes of ninety nodes.
#[test]
fn many_holes_are_meshed() {
    let place = |k: i32| [1.0 + 1.5 * f64::from(k % 10), 1.0 + 1.5 * f64::from(k / 10)];
    let holes = (0..50).map(|k| hole(&format!("hole {k}"), place(k), 0.25, 90));
    let mesh = meshed(rectangle(15.5, 8.0, holes.collect()), ElementKind::T3);
    let least = quality(&mesh).least_angle.to_degrees();
    assert!(least > LEAST, "{least}");
}

/// Where the angles of a hole jump by a factor of 3, cells are still good.
#[test]
fn abrupt_angles_are_meshed() {
    let mut contour = strip();
    let fine = (0..60).map(|k| 0.02 * f64::from(k));
    let coarse = (0..85).map(|k| 1.2 + 0.06 * f64::from(k) - 0.0005 * f64::from(k));
    contour.holes[0].angles = fine.chain(coarse).collect();
    let mesh = meshed(contour, ElementKind::T6);
    let least = quality(&mesh).least_angle.to_degrees();
    assert!(least > 20.0, "{least}");
    assert_eq!(mesh.edge_set("hole").expect("a set").edges.len(), 145);
}

#[test]
fn layers_are_as_asked() {
    let cells = |layers| {
        let mut contour = strip();
        contour.holes[0].layers = Some(layers);
        let mesh = meshed(contour, ElementKind::T3);
        let [centre, radius] = [[6.0, 1.5], [0.5; 2]];
        let ring = (1.0 + std::f64::consts::TAU / 72.0).powi(layers as i32);
        let near = |p: Point| distance(p, centre) < radius[0] * ring * (1.0 + 1e-9);
        let within = |cell: &usize| corners(&mesh, *cell).into_iter().all(near);
        (0..mesh.element_count()).filter(within).count()
    };
    for layers in [1, 2, 5] {
        assert_eq!(cells(layers), 2 * 72 * layers);
    }
}

/// Spacing on fine pieces is what is asked for, and cells far from everything have the overall spacing.
#[test]
fn spacings_are_kept() {
    let fine = BTreeMap::from([(0, 6.0)]);
    let division = Division {
        kind: ElementKind::T3,
        spacing: Some(0.3),
        refined: fine,
        ..Division::default()
    };
    let contour = angle_plate();
    let mesh = ContourMesh { contour, division }
        .generate()
        .expect("a mesh");
    let edges = |name: &str| &mesh.edge_set(name).expect("a set").edges;
    // Refinement may halve a few.
    assert!((80..90).contains(&edges("edge 0").len()));
    for &edge in edges("edge 0") {
        let [a, b] = mesh.edge_nodes(edge).ends.map(|node| mesh.nodes()[node]);
        assert!(distance(a, b) < 0.0501);
    }
    // One long edge without fine neighbours.
    let coarse = 4.0 / edges("edge 5").len() as f64;
    assert!(coarse < 0.3 && coarse > 0.15, "{coarse}");
}

#[test]
fn the_same_input_gives_the_same_bits() {
    for (name, contour) in all() {
        let [a, b] = [0, 1].map(|_| meshed(contour.clone(), ElementKind::T6));
        let bits = |mesh: &Mesh| -> Vec<[u64; 2]> {
            mesh.nodes().iter().map(|p| p.map(f64::to_bits)).collect()
        };
        assert_eq!(bits(&a), bits(&b), "{name}");
        assert_eq!(a, b, "{name}");
    }
}
