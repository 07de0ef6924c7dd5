//! Nodal forces with exactly the resultant of the load on a closed circle that they stand for.
//!
//! ```text
//! f ← f + t ∫ N_a (a + b e_z × (x − c)) ds,     Σ f_a = F,   Σ (x_a − c) × f_a = M
//! ```
//!
//! The facets of a mesh move the line of action of a force on a rim by some 10⁻⁵ of the radius, and leave a resultant of the same relative
//! size of a self-balanced load. Both are negligible for the stresses. But where nothing resists a rigid motion, a pin with little friction
//! turns and a free ring drifts until contact stops it, which changes the problem. The smooth traction (a, b) removes both errors.

use nalgebra::{Matrix3, Vector3};
use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::{Curve, EdgeSet, Mesh, Point};

/// Centre of the circle that `edge` is part of, the origin for an edge of another shape.
pub(super) fn centre_of(edge: &EdgeSet) -> Point {
    match edge.curve {
        Some(Curve::Arc { centre, .. }) => centre,
        _ => [0.0; 2],
    }
}

/// `forces` on all nodes, interleaved, with the resultant `wanted` (force along x and y, moment about the centre), by a traction on the
/// closed circle `edge`. A half model has half of the force along its line of symmetry; the other half balances what acts across.
pub(super) fn matched(
    mesh: &Mesh,
    edge: &EdgeSet,
    mut forces: Vec<f64>,
    wanted: [f64; 3],
    half: bool,
) -> Vec<f64> {
    let centre = centre_of(edge);
    let around = |[x, y]: Point| [centre[1] - y, x - centre[0]];
    let parts = [
        edge_load(mesh, &edge.edges, 1.0, |_| [1.0, 0.0]),
        edge_load(mesh, &edge.edges, 1.0, |_| [0.0, 1.0]),
        edge_load(mesh, &edge.edges, 1.0, |at| around(at.position)),
    ];
    let resultant = |forces: &[f64]| {
        let each = mesh.nodes().iter().zip(forces.chunks_exact(2));
        each.fold(Vector3::zeros(), |sum, (&node, force)| {
            let [turn_x, turn_y] = around(node);
            sum + Vector3::new(force[0], force[1], turn_x * force[0] + turn_y * force[1])
        })
    };
    let mut columns = Matrix3::from_columns(&parts.each_ref().map(|part| resultant(part)));
    let mut missing = Vector3::from(wanted) - resultant(&forces);
    if half {
        columns = Matrix3::from_diagonal(&Vector3::new(columns[(0, 0)], 1.0, 1.0));
        missing = Vector3::new(missing[0] - 0.5 * wanted[0], 0.0, 0.0);
    }
    // Tractions along x, along y and around a circle are independent of each other.
    if let Some(amounts) = columns.lu().solve(&missing) {
        for (part, amount) in parts.iter().zip(&amounts) {
            for (force, share) in forces.iter_mut().zip(part) {
                *force += amount * *share;
            }
        }
    }
    forces
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::model::{Model, ModelBodyKind};
    use std::path::Path;
    use stickslip_scene::{Format, Scene};

    /// A pin whose rim is divided unevenly, with a force on it.
    fn pin(element: &str) -> String {
        format!(
            r#"
version = 1
[analysis]
model = "whole"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = {{ hole_radius = "10 mm", outline.ring.radius = "30 mm" }}
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "9.5 mm"
[mesh]
element = "{element}"
spacing = "15 deg"
fine_to = "50 deg"
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 1e-6
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
on = "pin.rim"
force = {{ direction = [0.6, -0.8], steps = ["1 N"] }}
"#
        )
    }

    #[test]
    fn a_force_on_a_rim_acts_through_its_centre() {
        for element in ["T3", "T6", "Q4", "Q8"] {
            let none: [&str; 0] = [];
            let text = pin(element);
            let scene = Scene::from_text(&text, Format::Toml, "pin.toml", Path::new(""), &none);
            let model = Model::build(&scene.unwrap()).unwrap();
            let pin = model.bodies.iter().find(|body| body.name == "pin").unwrap();
            let ModelBodyKind::Elastic(body) = &pin.kind else {
                panic!("the pin is elastic");
            };
            let [centre_x, centre_y] = centre_of(body.mesh().edge_set("rim").unwrap());
            let forces = body.load_cases()[0].forces.chunks_exact(2);
            let sum = body.mesh().nodes().iter().zip(forces).fold(
                [0.0; 3],
                |[x, y, moment], ([at_x, at_y], force)| {
                    let turn = (at_x - centre_x) * force[1] - (at_y - centre_y) * force[0];
                    [x + force[0], y + force[1], moment + turn]
                },
            );
            for (found, expected) in sum.iter().zip([0.6, -0.8, 0.0]) {
                assert!((found - expected).abs() < 1e-13, "{element}: {sum:?}");
            }
        }
    }
}
