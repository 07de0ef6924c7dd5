//! Stresses inside the plate carry the load through every circle around the hole.
//!
//! Without body forces the stresses on a circle of any radius balance the contact forces on the hole. Recovered stresses do
//! so to the accuracy of the mesh: the error must fall as the mesh is refined, and end small.

use std::f64::consts::{PI, TAU};

use stickslip_tests::Draft;
use stickslip_tests::arcs::force_on_arc;

/// Steps around an arc: far more than cells, so that the sum errs less than the stresses.
const POINTS: usize = 1440;

/// Largest error of the force on circles of 1.3 to 2.5 hole radii, relative to the pull, with corner nodes every `degrees`.
fn arc_error(draft: &Draft, degrees: f64) -> f64 {
    const PULL: f64 = 1500.0;
    let solution = draft
        .clone()
        .set("mesh.spacing", format!("{degrees} deg"))
        .forces(0, &[PULL])
        .solve();
    let (plate, record) = (solution.body("plate"), &solution.records()[0]);
    let stress = solution.nodal_stress(plate, record);
    let elastic = solution.elastic(plate).expect("an elastic plate");
    let (turn, double) = if solution.model.half {
        (PI, 2.0)
    } else {
        (TAU, 1.0)
    };
    let error = |radius: f64| {
        let [x, y] = force_on_arc(
            elastic.mesh(),
            &stress,
            elastic.thickness(),
            radius,
            turn,
            POINTS,
        );
        let across = if solution.model.half { 0.0 } else { y };
        (double * x + PULL).hypot(across) / PULL
    };
    [6.5, 8.0, 10.0, 12.5]
        .into_iter()
        .map(error)
        .fold(0.0, f64::max)
}

/// Errors on meshes of 15°, 7.5° and 3.75°: the last below `bound`, and the mean rate of the two halvings at least `rate`.
fn converges(draft: &Draft, bound: f64, rate: f64) {
    let errors = [15.0, 7.5, 3.75].map(|degrees| arc_error(draft, degrees));
    let observed = (errors[0] / errors[2]).log2() / 2.0;
    assert!(
        errors[2] < bound && observed > rate,
        "{errors:?}, rate {observed:.2}:\n{draft:?}"
    );
}

#[test]
fn a_strip_carries_the_pull_through_every_circle() {
    // Bounds are twice the errors found, rates those of the elements' recovered stresses, less what the end of contact costs.
    for (element, bound, rate) in [
        ("T3", 4e-3, 1.5),
        ("Q4", 2.5e-3, 1.5),
        ("T6", 3e-4, 1.8),
        ("Q8", 8e-5, 1.8),
        ("Q9", 1.5e-4, 1.8),
    ] {
        converges(&Draft::pin().set("mesh.element", element), bound, rate);
    }
}

#[test]
fn so_does_a_ring_of_a_skew_ply() {
    let ply = r#"{ e1 = "140 GPa", e2 = "10 GPa", g12 = "5 GPa", nu12 = 0.3, angle = "30 deg" }"#;
    let draft = Draft::pin()
        .set(
            "bodies.plate.shape.plate_with_hole.outline",
            r#"{ ring = { radius = "25 mm" } }"#,
        )
        .set("loads.0.on", "plate.outer")
        .set("materials.plate.orthotropic", ply);
    converges(&draft, 3e-5, 1.8);
}
