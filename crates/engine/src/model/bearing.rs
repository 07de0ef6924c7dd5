//! Nodal forces of an assumed bearing pressure.
//!
//! ```text
//! f_a = t ∫ N_a p(a) e_r ds,     p = p₀(a) + c p₀(a) sin a,     Σ f_a = P
//! ```
//!
//! The pressure p₀ acts along the circle's radii, so its nodal forces have no moment about the centre, whatever the facets of the
//! mesh. Its resultant is the force up to the error of the quadrature and of facets; a factor, and in a whole model a small odd part c,
//! make it the force to rounding. The odd part is needed where the mesh is not symmetric about the force.

use stickslip_fem_core::load::edge_load;
use stickslip_fem_core::mesh::{EdgeSet, Mesh};

use super::resultant::centre_of;
use stickslip_scene::schema::BearingLaw;

/// Forces on all nodes, interleaved, of a unit force along the unit vector `direction` on the whole hole with the edge `hole`. A half
/// model has half of the force along its line of symmetry.
pub(super) fn unit_forces(
    mesh: &Mesh,
    hole: &EdgeSet,
    law: BearingLaw,
    direction: [f64; 2],
    half: bool,
) -> Vec<f64> {
    let [along_x, along_y] = direction;
    let centre = centre_of(hole);
    let of = |weight: fn(f64) -> f64| {
        edge_load(mesh, &hole.edges, 1.0, |at| {
            let [x, y] = [at.position[0] - centre[0], at.position[1] - centre[1]];
            let radius = x.hypot(y);
            // Sine and cosine of the angle from the force.
            let (sine, cosine) = (along_x * y - along_y * x, along_x * x + along_y * y);
            let pressure = law.pressure(sine.atan2(cosine)) * weight(sine / radius);
            [pressure * x / radius, pressure * y / radius]
        })
    };
    let resultant = |forces: &[f64]| {
        let total = |i: usize| forces.iter().skip(i).step_by(2).sum::<f64>();
        let (x, y) = (total(0), total(1));
        [along_x * x + along_y * y, along_x * y - along_y * x]
    };
    let mut forces = of(|_| 1.0);
    let [along, across] = resultant(&forces);
    if half {
        return forces.iter().map(|force| 0.5 * force / along).collect();
    }
    let odd = of(|sine| sine);
    let [odd_along, odd_across] = resultant(&odd);
    // Both parts together: all along the force, nothing across it. The odd part's own resultant lies across.
    let determinant = along * odd_across - across * odd_along;
    let (even_factor, odd_factor) = (odd_across / determinant, -across / determinant);
    for (force, odd) in forces.iter_mut().zip(&odd) {
        *force = even_factor * *force + odd_factor * odd;
    }
    forces
}

#[cfg(test)]
mod tests {
    use std::f64::consts::FRAC_1_PI;
    use std::path::Path;
    use std::sync::Arc;

    use super::*;
    use crate::model::{Model, ModelBodyKind};
    use stickslip_scene::{Format, Scene};

    fn mesh(element: &str, spacing: &str, model: &str) -> Arc<Mesh> {
        let text = format!(
            r#"
version = 1
analysis.model = "{model}"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.plate]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = {{ hole_radius = "5 mm", outline.ring.radius = "25 mm" }}
[mesh]
element = "{element}"
spacing = "{spacing}"
[[supports]]
on = "plate.outer"
fix = ["x", "y"]
[[loads]]
on = "plate.hole"
bearing = {{ direction = [1, 0], law = "cosine", steps = ["1 kN"] }}
"#
        );
        let none: [&str; 0] = [];
        let scene = Scene::from_text(&text, Format::Toml, "bearing", Path::new(""), &none).unwrap();
        let model = Model::build(&scene).unwrap();
        let ModelBodyKind::Elastic(body) = &model.bodies[0].kind else {
            panic!("the plate is elastic");
        };
        Arc::clone(body.mesh())
    }

    /// Force along x and y, and moment about the centre.
    fn resultant(mesh: &Mesh, forces: &[f64]) -> [f64; 3] {
        let mut total = [0.0; 3];
        for (node, force) in mesh.nodes().iter().zip(forces.chunks_exact(2)) {
            total[0] += force[0];
            total[1] += force[1];
            total[2] += node[0] * force[1] - node[1] * force[0];
        }
        total
    }

    #[test]
    fn the_resultant_is_exact_on_coarse_meshes_and_in_any_direction() {
        for element in ["T3", "T6", "Q4", "Q8", "Q9"] {
            // 7.2° has no node at ±90°.
            for spacing in ["15 deg", "7.2 deg"] {
                let whole = mesh(element, spacing, "whole");
                let hole = whole.edge_set("hole").unwrap();
                for law in [BearingLaw::Cosine, BearingLaw::Uniform] {
                    for degrees in [0.0_f64, 37.0, 180.0, 271.0] {
                        let (s, c) = degrees.to_radians().sin_cos();
                        let forces = unit_forces(&whole, hole, law, [c, s], false);
                        let [x, y, moment] = resultant(&whole, &forces);
                        let error = (x - c).abs().max((y - s).abs()).max(moment.abs() / 5.0);
                        assert!(error < 1e-13, "{element} {law:?} {degrees}°: {error:e}");
                    }
                }
            }
        }
    }

    #[test]
    fn a_half_model_has_half_of_the_force() {
        for element in ["Q4", "Q8"] {
            let half = mesh(element, "15 deg", "half");
            let hole = half.edge_set("hole").unwrap();
            for side in [1.0, -1.0] {
                let forces = unit_forces(&half, hole, BearingLaw::Cosine, [side, 0.0], true);
                let [x, y, _] = resultant(&half, &forces);
                assert!((x - 0.5 * side).abs() < 1e-14, "{element} {side}: {x}");
                // The other half balances what acts across: P/π of a cosine.
                assert!((y - FRAC_1_PI).abs() < 0.01, "{element} {side}: {y}");
            }
        }
    }
}
