//! Half or whole: what breaks the symmetry, and that both give the same.

use std::fmt::Write as _;
use std::fs;

use serde_json::Value;
use stickslip::model::{Model, ModelError};
use stickslip::output::summary_json;
use tempfile::TempDir;

use super::{BUSHING, difference, model, results, scene, scene_in, solved, tractions, upper};

/// A cylinder that is pressed on a block.
pub(super) const ROLLER: &str = r#"
version = 1
[analysis]
plane = "strain"
[materials.stiff.isotropic]
young = "210 GPa"
poisson = 0.3
[materials.soft.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "soft"
thickness = "1 mm"
shape.block = { half_length = "12 mm", depth = "12 mm" }
[bodies.roller]
material = "stiff"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "12 mm", depth = "12 mm" }
[mesh]
spacing = "0.2 mm"
fine_to = "1.6 mm"
[[contacts]]
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.05 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["y"]
[[loads]]
on = "roller.top"
force = { direction = [0, -1], steps = ["300 N", "600 N", "200 N"] }
[output]
fields = "none"
figures = false
"#;

/// A hole whose edge is loaded by the stresses of a table.
const TABLE: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.ring]
material = "metal"
thickness = "2 mm"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring.radius = "25 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk.radius = "4.99 mm"
[mesh]
spacing = "6 deg"
[[contacts]]
first = "ring.hole"
second = "pin.rim"
friction.coulomb.mu = 0.2
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "ring.outer"
polar_traction = { file = "table.csv", stress = "MPa", steps = [1.0, 0.4] }
[output]
fields = "none"
figures = false
"#;

/// README's pin, and the fibre coverage of one or two plies as its friction.
const PIN: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.plate]
material = "aluminium"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "80 mm", right = "20 mm" }
[bodies.pin]
material = "aluminium"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "3 deg"
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
[contacts.friction.fibre_coverage]
plies = [{ angle = "45 deg", fraction = 1.0 }]
fibre_fraction = 0.6
kernel.tangent.width = "40 deg"
fibre.coulomb = { mu = 0.0 }
matrix.coulomb = { mu = 0.8 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["4 kN"] }
[output]
fields = "none"
figures = false
"#;

const BALANCED: &str = "contacts.0.friction.fibre_coverage.plies=[{ angle = \"70 deg\", fraction = 0.5 }, \
                        { angle = \"-70 deg\", fraction = 0.5 }]";

fn why(model: &Model) -> (&str, &str) {
    let choice = model.choices.iter().find(|choice| choice.what == "model");
    choice
        .map(|choice| (choice.value.as_str(), choice.reason.as_str()))
        .unwrap()
}

#[test]
fn a_platen_on_one_side_needs_the_whole() {
    let model_with = |platen: &str| model(BUSHING, &[&format!("platens.0={platen}")]);
    let top = model_with("{ on = \"plate.top\", free = [\"x\"] }");
    let (value, reason) = why(&top);
    assert_eq!(value, "whole");
    assert!(reason.contains("plate.top has no mirror image"), "{reason}");
    let left = model_with("{ on = \"plate.left\", free = [\"x\"] }");
    assert_eq!(why(&left).0, "half");
}

#[test]
fn an_edge_that_a_half_lacks_needs_the_whole() {
    let bottom = "edges=[{ on = \"plate.bottom\" }]";
    let whole = model(BUSHING, &[bottom]);
    let (value, reason) = why(&whole);
    assert_eq!(value, "whole");
    assert!(
        reason.contains("plate.bottom is to be reported"),
        "{reason}"
    );
    assert_eq!(
        why(&model(BUSHING, &["edges=[{ on = \"plate.top\" }]"])).0,
        "half"
    );
    let refused = Model::build(&scene(BUSHING, &[bottom, "analysis.model=half"])).unwrap_err();
    assert!(matches!(refused, ModelError::NotSymmetric(_)));
    let words = refused.to_string();
    assert!(
        words.contains("plate.bottom") && words.contains("\"whole\" or \"auto\""),
        "{words}"
    );
}

#[test]
fn a_law_without_mirror_symmetry_needs_the_whole() {
    let peak = |changes: &[&str]| {
        let edge = solved(PIN, changes).steps[0].edges[0].clone();
        edge.peak_pressure.unwrap()
    };
    let (pressure, at) = peak(&[]);
    // A half model would have 182.2 MPa at 0°; the last digit is that of the mesh.
    assert!((pressure - 198.0).abs() < 0.1, "{pressure}");
    assert!((at.to_degrees() + 27.0).abs() < 1e-6, "{at}");
    let (mirrored, there) = peak(&["contacts.0.friction.fibre_coverage.plies.0.angle=-45 deg"]);
    assert!((mirrored / pressure - 1.0).abs() < 1e-8, "{mirrored}");
    assert!((there + at).abs() < 1e-9, "{there}");
    let auto = model(PIN, &[]);
    let (value, reason) = why(&auto);
    assert_eq!(value, "whole");
    for part in ["'fibre_coverage' of contact 'pin'", "no symmetry"] {
        assert!(reason.contains(part), "{part}: {reason}");
    }
    let refused = Model::build(&scene(PIN, &["analysis.model=half"])).unwrap_err();
    assert!(matches!(refused, ModelError::NotSymmetric(_)));
    let words = refused.to_string();
    assert!(
        words.contains(reason) && words.contains("\"whole\" or \"auto\""),
        "{words}"
    );
}

#[test]
fn balanced_plies_keep_the_half() {
    let half = model(PIN, &[BALANCED]);
    let (value, reason) = why(&half);
    assert_eq!(value, "half");
    assert!(reason.contains("friction laws, supports and loads are symmetric"));
    halves_agree(PIN, &[BALANCED]);
}

#[test]
fn a_table_of_half_the_circle_is_mirrored_exactly() {
    let folder = TempDir::new().unwrap();
    let mut table = "theta_deg,sigma_r,tau_rtheta\n".to_owned();
    for degrees in [0.0_f64, 5.0, 17.0, 40.0, 71.0, 90.0, 118.0, 150.0, 180.0] {
        let theta = degrees.to_radians();
        let (radial, shear) = (20.0 - 30.0 * theta.cos(), 30.0 * theta.sin());
        // Writing into a string does not fail.
        let _ = writeln!(table, "{degrees},{radial},{shear}");
    }
    fs::write(folder.path().join("table.csv"), table).unwrap();
    let [half, whole] = ["half", "whole"].map(|kind| {
        let model = format!("analysis.model={kind}");
        results(&scene_in(folder.path(), TABLE, &[model.as_str()]))
    });
    for step in 0..2 {
        let resultant =
            |results: &stickslip::results::Results| results.steps[step].edges[0].resultant;
        let [x, y] = resultant(&whole);
        assert!(x.abs() > 100.0 && y.abs() < 1e-8 * x.abs(), "{x}, {y}");
        assert!((resultant(&half)[0] / x - 1.0).abs() < 1e-9);
        let apart = difference(
            tractions(&upper(&half, step, 0)),
            tractions(&upper(&whole, step, 0)),
        );
        assert!(apart < 1e-8, "step {step}: {apart:e}");
    }
}

/// Keys that say how a scene was modelled and not what it does.
const OF_THE_MODEL: [&str; 12] = [
    "wall_time_s",
    "solvers",
    "iterations",
    "pivots",
    "increments",
    "cutbacks",
    "solver_notes",
    "solutions_counted",
    "uniqueness_estimate",
    "balance_residual",
    "complementarity_residual",
    "cone_violation",
];

/// Whether both have the same keys and texts, and numbers within `tolerance` of the larger one, or of `floor`.
fn agree(one: &Value, other: &Value, path: &str, tolerance: f64, floor: f64) {
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            assert!(one.keys().eq(other.keys()), "{path}");
            for (key, value) in one {
                if OF_THE_MODEL.contains(&key.as_str()) {
                    continue;
                }
                agree(
                    value,
                    &other[key],
                    &format!("{path}.{key}"),
                    tolerance,
                    floor,
                );
            }
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len(), "{path}: {one:?} {other:?}");
            for (k, (one, other)) in one.iter().zip(other).enumerate() {
                agree(one, other, &format!("{path}.{k}"), tolerance, floor);
            }
        }
        (Value::Number(one), Value::Number(other)) => {
            let [one, other] = [one, other].map(|number| number.as_f64().unwrap());
            let size = one.abs().max(other.abs()).max(floor);
            assert!(
                (one - other).abs() <= tolerance * size,
                "{path}: {one} {other}"
            );
        }
        // The comparison with another solver may be too dear for the whole, as notes say.
        (Value::Object(_), Value::Null) if path.ends_with("other_solver") => {}
        (one, other) => assert_eq!(one, other, "{path}"),
    }
}

fn halves_agree(scene: &str, changes: &[&str]) {
    let [half, whole] = ["half", "whole"].map(|extent| {
        let extent = format!("analysis.model={extent}");
        summary_json(&solved(scene, &[changes, &[&extent]].concat())).unwrap()
    });
    // Ends of zones between nodes follow from p², the difference of two solutions from their rounding; forces of some N and
    // angles of some degrees.
    agree(&half["steps"], &whole["steps"], "steps", 1e-6, 1e-2);
}

#[test]
fn half_and_whole_have_one_summary() {
    halves_agree(BUSHING, &[]);
    // Contact around the far side.
    halves_agree(BUSHING, &["loads.0.force.direction=[1, 0]"]);
    // Contact all around, then opening behind.
    halves_agree(
        BUSHING,
        &[
            "bodies.pin.shape.disk.radius=5.01 mm",
            "contacts.1.interference=true",
            "loads.0.force.steps=[\"0 N\", \"500 N\", \"4 kN\", \"500 N\"]",
        ],
    );
}

/// The scene that comes with the program, coarser.
#[test]
fn a_bushed_pin_is_one_scene_by_half_and_whole() {
    let scene = include_str!("../../../../scenes/bushed-pin.toml");
    let coarse = [
        "mesh.spacing=4.5 deg",
        "output.fields=none",
        "output.figures=false",
    ];
    // Pulled from the first step on: the press fit alone may rest anywhere in the clearance of the pin.
    let pulled = "loads.0.force.steps=[\"2 kN\", \"6 kN\", \"12 kN\", \"24 kN\", \"18 kN\", \"6 kN\", \"1 kN\"]";
    halves_agree(scene, &[&coarse[..], &[pulled]].concat());
    let results = solved(scene, &coarse);
    let pulls = [0.0, 2e3, 6e3, 12e3, 18e3, 24e3, 18e3, 12e3, 6e3, 1e3];
    assert_eq!(results.steps.len(), pulls.len());
    for (step, pull) in results.steps.iter().zip(pulls) {
        assert!(step.balance_residual < 1e-10, "{}", step.balance_residual);
        for edge in &step.edges {
            assert!(
                (edge.resultant[0] - pull).abs() < 1e-9 * 24e3,
                "{:?}",
                edge.resultant
            );
        }
    }
    // The press fit alone; then the bushing keeps more friction on the way back than on the way there.
    let [bushing, pin] = [0, 1].map(|edge| &results.steps[0].edges[edge]);
    assert_eq!(bushing.contact_half_extent, Some(std::f64::consts::PI));
    assert_eq!(pin.contact_half_extent, None);
    assert!(results.steps[8].edges[1].stick_half_extent.unwrap() < 0.1);
}

#[test]
fn half_and_whole_lines_have_one_summary() {
    halves_agree(ROLLER, &[]);
}
