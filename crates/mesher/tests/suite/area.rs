//! Areas and lengths against exact ones.

use std::f64::consts::PI;

use stickslip_fem_core::mesh::{ElementKind, Mesh, Point};

use crate::shapes::{
    acute, angle_plate, disk, eccentric, hole, lug, meshed, notched, pattern, rectangle, rounded,
    row_of_five, slotted, strip,
};

fn cross(a: Point, b: Point) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

/// ∫ x × dx along an edge of order 1 or 2, exact.
pub(crate) fn swept(nodes: &[Point]) -> f64 {
    match *nodes {
        [a, m, b] => (4.0 * cross(a, m) + 4.0 * cross(m, b) - cross(a, b)) / 3.0,
        [a, b] => cross(a, b),
        _ => f64::NAN,
    }
}

/// Area inside the edges of all sets `[length²]`.
pub(crate) fn area(mesh: &Mesh) -> f64 {
    let edges = mesh.edge_set_names().flat_map(|name| {
        let set = mesh.edge_set(name).expect("a named set");
        set.edges.iter().copied()
    });
    let swept = edges.map(|edge| {
        let nodes: Vec<Point> = mesh
            .edge_nodes(edge)
            .walk()
            .map(|n| mesh.nodes()[n])
            .collect();
        swept(&nodes)
    });
    swept.sum::<f64>() / 2.0
}

fn length(mesh: &Mesh, set: &str) -> f64 {
    let edges = &mesh.edge_set(set).expect("a named set").edges;
    let chords = edges.iter().map(|&edge| {
        let [a, b] = mesh.edge_nodes(edge).ends.map(|n| mesh.nodes()[n]);
        (a[0] - b[0]).hypot(a[1] - b[1])
    });
    chords.sum()
}

#[test]
fn areas_are_exact_to_a_millionth() {
    let circle = |radius: f64| PI * radius * radius;
    let corner = 0.25 * (4.0 - PI);
    let cases = [
        ("strip", strip(), 24.0 - circle(0.5)),
        ("row", row_of_five(), 16.0 - 5.0 * circle(0.25)),
        ("pattern", pattern(), 28.0 - 6.0 * circle(0.3)),
        ("eccentric", eccentric(), 18.0 - circle(0.5)),
        ("lug", lug(72), 8.0 + circle(1.0) / 2.0 - circle(0.5)),
        ("rounded", rounded(), 60.0 - corner - circle(1.0)),
        ("angle plate", angle_plate(), 7.0),
        ("acute", acute(), 8.0 * (PI / 9.0).sin()),
        ("notched", notched(), 8.0 - circle(0.5) / 2.0 - circle(0.4)),
        (
            "slotted",
            slotted(),
            32.0 - circle(0.5) * 2.0 - circle(0.375) - 1.125 - 2.25,
        ),
        // 24 edges of 15°, each short of 2 φ⁵/30 with φ = 7.5°.
        ("disk", disk(), circle(1.0)),
    ];
    for (name, contour, exact) in cases {
        let found = area(&meshed(contour, ElementKind::T6));
        let bound = if name == "disk" { 1e-5 } else { 1e-6 };
        assert!(
            (found / exact - 1.0).abs() < bound,
            "{name}: {found} {exact}"
        );
    }
}

/// A parabola through three points of an arc of 2φ misses R² φ⁵/30 of its segment: with n edges, of order n⁻⁴.
#[test]
fn the_error_of_a_curved_boundary_is_of_fourth_order() {
    let error = |count: usize| {
        let contour = rectangle(4.0, 4.0, vec![hole("hole", [2.0, 2.0], 1.0, count)]);
        (area(&meshed(contour, ElementKind::T6)) - 16.0 + PI).abs()
    };
    for count in [12, 24, 48] {
        let half = PI / count as f64;
        let expected = count as f64 * half.powi(5) / 30.0;
        let found = error(count);
        // The next term of the series is smaller by about φ²/2.
        assert!(
            (found / expected - 1.0).abs() < half * half,
            "{count}: {found} {expected}"
        );
    }
}

#[test]
fn lengths_are_those_of_the_pieces() {
    let mesh = meshed(lug(60), ElementKind::T6);
    for (set, exact) in [("top", 4.0), ("clamped", 2.0), ("bottom", 4.0)] {
        assert!((length(&mesh, set) - exact).abs() < 1e-12, "{set}");
    }
    let polygon = 60.0 * (PI / 60.0).sin();
    assert!((length(&mesh, "hole") - polygon).abs() < 1e-12);
    // Chords of at most 15° are short of the arc by a fraction of at most 0.131²/6.
    let arc = length(&mesh, "end");
    assert!(arc < PI && arc > PI * (1.0 - 0.131 * 0.131 / 6.0), "{arc}");
}

/// Sums over cells and over the boundary agree, so that cells fit together without gaps.
#[test]
fn cells_fill_the_boundary() {
    for kind in [ElementKind::T3, ElementKind::T6] {
        let mesh = meshed(notched(), kind);
        let mut sum = 0.0;
        for element in 0..mesh.element_count() {
            for edge in 0..3 {
                let edge = stickslip_fem_core::mesh::EdgeRef { element, edge };
                let walk = mesh.edge_nodes(edge).walk();
                let nodes: Vec<Point> = walk.map(|n| mesh.nodes()[n]).collect();
                sum += swept(&nodes) / 2.0;
            }
        }
        assert!((sum / area(&mesh) - 1.0).abs() < 1e-12, "{kind:?}");
    }
}
