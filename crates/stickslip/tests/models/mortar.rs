//! Bodies whose meshes do not match: the mortar projection in scenes.

use stickslip::host::HOST;
use stickslip::model::{Model, ModelError};
use stickslip::results::Results;
use stickslip::scene::Scene;

use super::{BUSHING, difference, model, scene, solved, tractions, upper};

const MU: f64 = 0.25;

/// A pin in a strip, loaded and unloaded.
const PIN: &str = r#"
version = 1
[materials.metal.isotropic]
young = "72 GPa"
poisson = 0.33
[bodies.plate]
material = "metal"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.pin]
material = "metal"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "2 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.25 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["4 kN", "1 kN"] }
[output]
fields = "none"
figures = false
"#;

/// A cylinder that is pressed on a block and pushed along it.
const ROLLER: &str = r#"
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
spacing = "0.06 mm"
fine_to = "1.5 mm"
[[contacts]]
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.25 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["x", "y"]
[[loads]]
on = "roller.top"
force = { direction = [0, -1], steps = ["600 N", "600 N"] }
[[loads]]
on = "roller.top"
force = { direction = [1, 0], steps = ["0 N", "75 N"] }
[output]
fields = "none"
figures = false
"#;

/// Two blocks, the upper one a cylinder without measurable curvature, pressed on each other.
const BLOCKS: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.block]
material = "metal"
thickness = "1 mm"
shape.block = { half_length = "10 mm", depth = "10 mm" }
[bodies.upper]
material = "metal"
thickness = "1 mm"
shape.cylinder = { radius = "1e15 mm", half_length = "10 mm", depth = "10 mm" }
[mesh]
spacing = "0.5 mm"
fine_to = "5 mm"
[[contacts]]
first = "upper.contact"
second = "block.contact"
gap = "linearised"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "block.bottom"
fix = ["y"]
[[loads]]
on = "upper.top"
pressure.steps = ["50 MPa"]
[output]
fields = "none"
figures = false
"#;

/// Peak pressure, half extent of contact, and friction over μ times the normal force, after a step.
fn figures(results: &Results, step: usize) -> [f64; 3] {
    let edge = &results.steps[step].edges[0];
    let (peak, _) = edge.peak_pressure.unwrap();
    [
        peak,
        edge.contact_half_extent.unwrap(),
        edge.friction_force / (MU * edge.normal_force),
    ]
}

fn deviations(results: &Results, reference: &Results, step: usize) -> [f64; 3] {
    let (found, known) = (figures(results, step), figures(reference, step));
    std::array::from_fn(|i| (found[i] / known[i] - 1.0).abs())
}

fn worst_balance(results: &Results) -> f64 {
    let steps = results.steps.iter();
    steps.fold(0.0, |worst, step| worst.max(step.balance_residual))
}

fn discretisation(model: &Model) -> [&str; 2] {
    let found = model
        .choices
        .iter()
        .find(|choice| choice.what.starts_with("contact discretisation"));
    found
        .map(|choice| [choice.value.as_str(), choice.reason.as_str()])
        .unwrap()
}

/// The second body's spacing beside 2 deg of the plate; friction over μ N and peak pressure barely see it, the end of contact lies
/// between two nodes.
#[test]
fn pins_of_other_spacing_give_the_answer_of_matching_ones() {
    let reference = solved(PIN, &[]);
    for other in ["1.3 deg", "3.1 deg", "4 deg"] {
        let spacing = format!("bodies.pin.mesh.spacing={other}");
        let half = solved(PIN, &[&spacing]);
        let whole = solved(PIN, &[&spacing, "analysis.model=whole"]);
        for results in [&half, &whole] {
            for step in 0..2 {
                let found = deviations(results, &reference, step);
                for (value, bound) in found.into_iter().zip([6e-3, 6e-3, 2e-3]) {
                    assert!(value < bound, "{other}, step {step}: {found:?}");
                }
            }
            assert!(worst_balance(results) < 1e-10);
        }
        let apart = difference(
            tractions(&upper(&half, 0, 0)),
            tractions(&upper(&whole, 0, 0)),
        );
        assert!(apart < 1e-3, "{other}: {apart:.1e}");
        let standard = solved(PIN, &[&spacing, "contacts.0.projection=mortar"]);
        let found = deviations(&standard, &reference, 0);
        assert!(found.iter().all(|value| *value < 0.02), "{found:?}");
    }
}

#[test]
fn blocks_of_other_spacing_give_the_answer_of_matching_ones() {
    let reference = solved(ROLLER, &[]);
    for other in ["0.04 mm", "0.09 mm"] {
        let results = solved(ROLLER, &[&format!("bodies.block.mesh.spacing={other}")]);
        let found = deviations(&results, &reference, 1);
        for (value, bound) in found.into_iter().zip([2e-3, 1e-2, 1e-10]) {
            assert!(value < bound, "{other}: {found:?}");
        }
        let [pressed, known] = [&results, &reference].map(|results| figures(results, 0)[0]);
        assert!((pressed / known - 1.0).abs() < 2e-3, "{pressed} {known}");
        assert!(worst_balance(&results) < 1e-10);
    }
}

/// Quadratic dual points differ from pairs of nodes by what the normal turns along a cell; standard ones spread a node's pressure.
#[test]
fn on_meshes_that_match_a_projection_is_close_to_pairs_of_nodes() {
    for text in [PIN, ROLLER] {
        let nodes = solved(text, &[]);
        let of = |how: &str| solved(text, &[&format!("contacts.0.projection={how}")]);
        let said = of("nodes");
        assert_eq!(
            tractions(&upper(&nodes, 1, 0)),
            tractions(&upper(&said, 1, 0))
        );
        let dual = of("dual-mortar");
        let apart = difference(
            tractions(&upper(&nodes, 0, 0)),
            tractions(&upper(&dual, 0, 0)),
        );
        assert!(apart < 5e-4, "{apart:.1e}");
        let [standard, known] = [of("mortar"), nodes].map(|results| figures(&results, 1));
        for (value, known) in standard.into_iter().zip(known) {
            assert!((value / known - 1.0).abs() < 1e-2, "{standard:?}");
        }
    }
}

#[test]
fn uniform_pressure_passes_meshes_that_do_not_match() {
    for element in ["T3", "Q4", "T6", "Q8", "Q9"] {
        for projection in ["mortar", "dual-mortar"] {
            let results = solved(
                BLOCKS,
                &[
                    "bodies.upper.mesh.spacing=0.3 mm",
                    "bodies.upper.mesh.fine_to=4 mm",
                    &format!("mesh.element={element}"),
                    &format!("contacts.0.projection={projection}"),
                ],
            );
            for row in &results.steps[0].edges[0].rows {
                let off = (row.pressure / 50.0 - 1.0)
                    .abs()
                    .max(row.shear.abs() / 50.0);
                assert!(off < 1e-10, "{element} {projection}: {row:?}");
                assert!((row.sigma_normal / -50.0 - 1.0).abs() < 1e-10);
            }
        }
    }
}

#[test]
fn the_choice_is_said_with_its_reason() {
    let matching = model(PIN, &[]);
    assert_eq!(discretisation(&matching)[0], "matching node pairs");
    let other = model(PIN, &["bodies.pin.mesh.spacing=3 deg"]);
    assert_eq!(
        discretisation(&other),
        [
            "mortar projection, dual multipliers",
            "181 nodes of plate.hole face 121 of pin.rim"
        ]
    );
    let asked = model(PIN, &["contacts.0.projection=mortar"]);
    assert_eq!(
        discretisation(&asked),
        [
            "mortar projection, standard multipliers",
            "the scene says so; the meshes match"
        ]
    );
    let shifted = model(
        PIN,
        &[
            "bodies.pin.mesh.angles=[\"0 deg\", \"40 deg\", \"90 deg\", \"135 deg\", \"180 deg\"]",
            "mesh.spacing=45 deg",
        ],
    );
    let reason = &discretisation(&shifted)[1];
    assert!(
        reason.contains("plate.hole and pin.rim lie up to 5.000° apart"),
        "{reason}"
    );
    // Cells of another kind on the same nodes still match.
    let kinds = model(PIN, &["bodies.pin.mesh.element=Q9"]);
    assert_eq!(discretisation(&kinds)[0], "matching node pairs");
}

#[test]
fn pairs_of_nodes_need_nodes_that_match() {
    let changes = ["bodies.pin.mesh.element=Q4", "contacts.0.projection=nodes"];
    let refused = Model::build(&scene(PIN, &changes)).unwrap_err();
    assert!(
        matches!(refused, ModelError::Projection { .. }),
        "{refused}"
    );
}

#[test]
fn chains_mix_pairs_of_nodes_and_projections() {
    let whats = |changes: &[&str]| -> Vec<String> {
        let choices = model(BUSHING, changes).choices.into_iter();
        let found = choices.filter(|choice| choice.what.starts_with("contact discretisation"));
        found
            .map(|choice| format!("{}: {}", choice.what, choice.value))
            .collect()
    };
    assert_eq!(
        whats(&["bodies.pin.mesh.spacing=4 deg"]),
        [
            "contact discretisation of 'bushing': matching node pairs",
            "contact discretisation of 'pin': mortar projection, dual multipliers"
        ]
    );
    let reference = solved(BUSHING, &[]);
    for model in ["half", "whole"] {
        let results = solved(
            BUSHING,
            &[
                "bodies.bushing.mesh.spacing=4 deg",
                &format!("analysis.model={model}"),
            ],
        );
        assert!(worst_balance(&results) < 1e-10);
        for (edge, known) in results.steps[1].edges.iter().zip(&reference.steps[1].edges) {
            let [[peak, _], [other, _]] =
                [edge, known].map(|edge| edge.peak_pressure.map_or([0.0; 2], <[f64; 2]>::from));
            assert!((peak / other - 1.0).abs() < 0.02, "{peak} {other}");
            let along = edge.resultant[0] / known.resultant[0];
            assert!((along - 1.0).abs() < 1e-9, "{along}");
        }
    }
}

/// A rigid pin has no nodes of its own.
#[test]
fn rigid_pins_can_be_projected_on() {
    let rigid = "bodies.pin.rigid=true";
    let nodes = solved(PIN, &[rigid]);
    for (projection, bound) in [("dual-mortar", 2e-3), ("mortar", 1e-2)] {
        for model in ["half", "whole"] {
            let results = solved(
                PIN,
                &[
                    rigid,
                    &format!("contacts.0.projection={projection}"),
                    &format!("analysis.model={model}"),
                ],
            );
            let [peak, _, friction] = deviations(&results, &nodes, 0);
            assert!(peak < bound && friction < bound, "{peak} {friction}");
            assert!(worst_balance(&results) < 1e-10);
        }
    }
}

#[test]
fn gaps_between_meshes_and_other_cells_can_be_projected() {
    let reference = solved(PIN, &[]);
    let faceted = ["contacts.0.gap=faceted", "bodies.pin.mesh.spacing=1.3 deg"];
    let linear = [
        "bodies.pin.mesh.element=Q4",
        "bodies.pin.mesh.spacing=2.6 deg",
    ];
    for changes in [faceted, linear] {
        let results = solved(PIN, &changes);
        let found = deviations(&results, &reference, 0);
        assert!(
            found.iter().all(|value| *value < 0.02),
            "{changes:?}: {found:?}"
        );
        assert!(worst_balance(&results) < 1e-10);
    }
}

#[test]
fn the_scene_of_a_coarser_pin_agrees_with_matching_meshes() {
    let path =
        std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes/pin-mortar.toml");
    let run = |changes: &[&str]| {
        let quiet = ["output.fields=none", "output.figures=false"];
        let all: Vec<&str> = quiet.iter().chain(changes).copied().collect();
        super::results(&Scene::from_file(&path, &all, HOST).unwrap())
    };
    let (own, matching) = (
        run(&[]),
        run(&[
            "bodies.pin.mesh.spacing=1.125 deg",
            "bodies.pin.mesh.coarse_spacing=4.5 deg",
            "contacts.0.projection=nodes",
        ]),
    );
    for step in 0..own.steps.len() {
        let found = deviations(&own, &matching, step);
        for (value, bound) in found.into_iter().zip([5e-3, 1e-2, 1e-2]) {
            assert!(value < bound, "step {step}: {found:?}");
        }
    }
    assert!(worst_balance(&own) < 1e-10);
}
