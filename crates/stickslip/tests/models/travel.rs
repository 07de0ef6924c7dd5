//! Pins that travel through their clearance before they bear: the way without force is no slip.

use stickslip::results::{Finding, Results, StepResults};
use stickslip_contact::Status;

use super::solved;

/// A pin that starts in touch at θ = 0, with a tenth of a millimetre to the other side.
pub(super) const JOINT: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.plate]
material = "aluminium"
thickness = "1 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "3 mm"
outline.strip = { half_width = "12 mm", left = "12 mm", right = "12 mm" }
[bodies.pin]
material = "aluminium"
thickness = "1 mm"
shape.disk = { radius = "2.95 mm" }
[mesh]
spacing = "10 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[output]
fields = "none"
figures = false
"#;

fn steps(pulled: &str, changes: &[&str]) -> Vec<StepResults> {
    solved(&format!("{JOINT}{pulled}"), changes).steps
}

fn pull(edge: &str, direction: &str, loads: &str) -> String {
    format!(
        "[[loads]]\non = \"plate.{edge}\"\nforce = {{ direction = {direction}, steps = [{loads}] }}\n"
    )
}

/// Peak pressure, hoop stress, half-angle of sticking, and work of friction, which is the hardest to get right.
#[track_caller]
fn alike(one: &StepResults, other: &StepResults, tolerance: f64) {
    let numbers = |step: &StepResults| {
        let edge = &step.edges[0];
        let rows = edge.rows.iter();
        let most =
            |of: fn(&stickslip::results::EdgeRow) -> f64| rows.clone().map(of).fold(0.0, f64::max);
        let sticks = rows
            .clone()
            .filter(|row| row.status == Status::Stick)
            .count() as f64;
        [
            most(|row| row.pressure),
            most(|row| row.sigma_tangential),
            sticks,
            step.dissipation,
        ]
    };
    let [one, other] = [numbers(one), numbers(other)];
    for (one, other) in one.iter().zip(other) {
        let apart = (one - other).abs() / one.abs().max(other.abs());
        assert!(apart < tolerance, "{one:?} against {other:?}");
    }
}

#[test]
fn a_pin_pulled_to_its_far_side_is_the_mirror_image_of_one_that_touches() {
    for model in ["analysis.model=half", "analysis.model=whole"] {
        let near = steps(&pull("left", "[-1, 0]", "\"500 N\", \"2 kN\""), &[model]);
        let far = steps(&pull("right", "[1, 0]", "\"500 N\", \"2 kN\""), &[model]);
        for (near, far) in near.iter().zip(&far) {
            alike(near, far, 1e-7);
        }
    }
}

/// It starts where it bears as well; cells on that side of the plate are others.
#[test]
fn a_pin_pulled_aside_slips_as_little() {
    let near = steps(
        &pull("left", "[-1, 0]", "\"500 N\""),
        &["analysis.model=whole"],
    );
    let aside = steps(&pull("top", "[0, 1]", "\"500 N\""), &[]);
    alike(&near[0], &aside[0], 1e-2);
}

#[test]
fn a_driven_plate_slips_from_where_it_touches() {
    let drive = |edge: &str, way: &str| {
        format!("[[supports]]\non = \"plate.{edge}\"\nfix = [\"x\"]\ndisplacement = \"{way} mm\"\n")
    };
    let near = steps(&drive("left", "-0.1"), &[]);
    let mirrored = steps(&drive("right", "0.1"), &[]);
    alike(&near[0], &mirrored[0], 1e-7);
    // A force too small to matter says where the pin starts, on the far side.
    let start = pull("left", "[-1, 0]", "\"0.000001 N\"");
    let far = steps(&format!("{}{start}", drive("right", "0.2")), &[]);
    alike(&near[0], &far[0], 1e-7);
}

/// A load that reverses by a step without load is as one that pushed from the start; one that reverses at once is reported.
#[test]
fn a_load_that_reverses_by_a_step_without_load_begins_anew() {
    let reversed = |loads: &str| solved(&format!("{JOINT}{}", pull("left", "[-1, 0]", loads)), &[]);
    let parted = |results: &Results| -> Vec<Finding> {
        let parts = |finding: &&Finding| matches!(finding, Finding::ContactParts { .. });
        results.findings.iter().filter(parts).cloned().collect()
    };
    let through = reversed("\"1 kN\", \"0 N\", \"-1 kN\"");
    alike(&reversed("\"-1 kN\"").steps[0], &through.steps[2], 1e-6);
    assert_eq!(parted(&through), []);
    let steps = vec![2];
    let at_once = reversed("\"1 kN\", \"-1 kN\"");
    assert_eq!(parted(&at_once), [Finding::ContactParts { steps }]);
}
