//! A round-ended lug with a hole: number of nodes, least angle of its cells, and its area beside the exact one.
//!
//! Run with `cargo run --release -p stickslip-mesher --example lug`. Lengths in units of half the lug's width.

use std::error::Error;
use std::f64::consts::PI;

use stickslip_fem_core::generate::{Extent, Generate, uniform_angles};
use stickslip_fem_core::mesh::Mesh;
use stickslip_mesher::{Contour, ContourMesh, Course, Division, Hole, Piece, quality};

fn main() -> Result<(), Box<dyn Error>> {
    let line = |name: &str, to| Piece {
        name: name.into(),
        to,
        course: Course::Line,
    };
    let end = Piece {
        course: Course::Arc([1.0, 0.0]),
        ..line("end", [0.0, 1.0])
    };
    let contour = Contour {
        start: [0.0, -1.0],
        pieces: vec![
            end,
            line("top", [-4.0, 1.0]),
            line("clamped", [-4.0, -1.0]),
            line("bottom", [0.0, -1.0]),
        ],
        cutouts: Vec::new(),
        holes: vec![Hole {
            name: "hole".into(),
            centre: [0.0, 0.0],
            radius: 0.5,
            angles: uniform_angles(Extent::Whole, 72),
            layers: None,
        }],
    };
    let division = Division::default();
    let mesh = ContourMesh { contour, division }.generate()?;
    let least = quality(&mesh).least_angle.to_degrees();
    let exact = 8.0 + PI / 2.0 - PI / 4.0;
    println!(
        "{} nodes, least angle {least:.1}°, area {:.7}, exactly {exact:.7}",
        mesh.nodes().len(),
        area(&mesh)?
    );
    Ok(())
}

/// Area inside the quadratic edges of all sets, ½ ∮ x × dx.
fn area(mesh: &Mesh) -> Result<f64, Box<dyn Error>> {
    let cross = |a: usize, b: usize| {
        let [a, b] = [mesh.nodes()[a], mesh.nodes()[b]];
        a[0] * b[1] - a[1] * b[0]
    };
    let mut twice = 0.0;
    for set in mesh.edge_set_names() {
        for &edge in &mesh.edge_set(set)?.edges {
            let nodes = mesh.edge_nodes(edge);
            let ([a, b], m) = (nodes.ends, nodes.inner[0]);
            twice += (4.0 * cross(a, m) + 4.0 * cross(m, b) - cross(a, b)) / 3.0;
        }
    }
    Ok(twice / 2.0)
}
