//! Bodies by series beside the same bodies of finite elements.

use stickslip::results::{LadderEnd, Results, Stated};
use stickslip::scene::schema::Accuracy;

use super::{difference, model, results, scene, solved, tractions, upper};

/// A pin in a strip without a mesh.
pub(super) const PIN: &str = r#"
version = 1
[analysis]
substeps = 1
[materials.aluminium.isotropic]
young = "72 GPa"
poisson = 0.33
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "aluminium"
thickness = "3 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "60 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "3 mm"
shape.disk = { radius = "4.99 mm" }
[[contacts]]
name = "pin"
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-1, 0], steps = ["1 kN", "4 kN", "1.5 kN"] }
[output]
fields = "none"
figures = false
"#;

const NODES: &str = "analysis.contact_nodes=241";
const SMALL: &str = "analysis.kinematics=small";
const MESH: &str = "mesh.spacing=0.75 deg";
/// A second load, so that the pin bears off the axis.
const ASIDE: &str = r#"loads.1={ on = "plate.top", force = { direction = [0, 1], steps = ["0.5 kN", "2 kN", "1 kN"] } }"#;

/// The largest relative difference of peak pressures, friction forces and hoop stresses at the bearing point of two results.
fn apart(one: &Results, other: &Results) -> [f64; 3] {
    [
        Stated::PeakPressure,
        Stated::FrictionForce,
        Stated::HoopAtBearing,
    ]
    .map(|stated| {
        let values = |own: &Results| -> Vec<f64> {
            let steps = own.steps.iter();
            steps
                .filter_map(|step| stated.value(&step.edges[0]))
                .collect()
        };
        difference(values(one), values(other))
    })
}

#[test]
fn series_and_elements_agree() {
    // Of half and whole, plane stress and strain, a load aside and a pressure instead of a force.
    let pressure =
        r#"loads.0={ on = "plate.left", pressure = { steps = ["-8 MPa", "-30 MPa", "-10 MPa"] } }"#;
    for changes in [
        vec![],
        vec!["analysis.plane=strain"],
        vec![pressure],
        vec![
            "contacts.0.interference=true",
            "bodies.pin.shape.disk.radius=5.01 mm",
        ],
        vec![
            ASIDE,
            r#"bodies.plate.shape.plate_with_hole.outline.strip.right="60 mm""#,
        ],
    ] {
        let by = |own: &[&str]| solved(PIN, &[&changes, own].concat());
        let series = by(&[NODES, SMALL]);
        let elements = by(&[MESH]);
        let [pressure, friction, hoop] = apart(&series, &elements);
        // Unloading off the axis both kinds converge more slowly, as their differences to finer models show.
        let slow = if changes.contains(&ASIDE) { 5.0 } else { 1.0 };
        assert!(
            pressure < slow * 1e-4 && friction < slow * 1e-3 && hoop < slow * 5e-4,
            "{changes:?}: {pressure:e} {friction:e} {hoop:e}"
        );
        assert_eq!((series.factorisations, elements.factorisations), (0, 2));
    }
}

#[test]
fn half_and_whole_series_agree() {
    let [half, whole] = ["half", "whole"].map(|own| {
        let model = format!("analysis.model={own}");
        solved(PIN, &[NODES, &model])
    });
    for step in 0..3 {
        let [one, other] = [&half, &whole].map(|own| tractions(&upper(own, step, 0)));
        assert!(difference(one, other) < 1e-7, "step {step}");
    }
}

#[test]
fn a_quasi_isotropic_laminate_is_a_series() {
    let laminate = r#"materials.aluminium={ laminate = { layup = "[0/60/-60]s", ply = "carbon", thickness = "3 mm" } }"#;
    let ply = r#"plies.carbon={ e1 = "140 GPa", e2 = "9 GPa", g12 = "5 GPa", nu12 = 0.3, thickness = "0.5 mm" }"#;
    let laminate = laminate.replace(r#", thickness = "3 mm""#, "");
    let changes = [ply, &laminate];
    let series = solved(PIN, &[&changes[..], &[NODES, SMALL]].concat());
    let elements = solved(PIN, &[&changes[..], &[MESH]].concat());
    let [pressure, ..] = apart(&series, &elements);
    assert!(pressure < 4e-4, "{pressure:e}");
}

/// Laminates whose planes are apart, images of each other, and aside of the axis. Loading only: the cusp where slip turns round, the peak pressure of unloading, is
/// half a percent low in cells of 0.75°.
#[test]
fn anisotropic_plates_agree_with_elements() {
    let ply = r#"plies.carbon={ e1 = "140 GPa", e2 = "9 GPa", g12 = "5 GPa", nu12 = 0.3, thickness = "0.25 mm" }"#;
    let load = r#"loads.0={ on = "plate.left", force = { direction = [-1, 0], steps = ["1 kN", "4 kN"] } }"#;
    for layup in [
        "[0_2/90]2s",
        "[90/45/-45/90/0/90]s",
        "[45/-45/45/-45/0/45]s",
        "[30_4/90_2]s",
    ] {
        let laminate = format!(
            r#"materials.aluminium={{ laminate = {{ layup = "{layup}", ply = "carbon" }} }}"#
        );
        let own = r#"bodies.plate.thickness="3 mm""#;
        let changes = [ply, &laminate, load, own];
        let series = solved(PIN, &[&changes[..], &[NODES, SMALL]].concat());
        let elements = solved(PIN, &[&changes[..], &[MESH]].concat());
        let [pressure, friction, hoop] = apart(&series, &elements);
        assert!(
            pressure < 4e-4 && friction < 4e-3 && hoop < 2e-3,
            "{layup}: {pressure:e} {friction:e} {hoop:e}"
        );
        assert_eq!((series.factorisations, elements.factorisations), (0, 2));
    }
}

#[test]
fn a_series_and_a_body_of_elements_touch() {
    let mixed = [
        r#"bodies.plate.model="series""#,
        "mesh.spacing=1.5 deg",
        "mesh.element=Q4",
    ];
    let own = model(PIN, &mixed);
    let series: Vec<bool> = own
        .bodies
        .iter()
        .map(|body| body.series.is_some())
        .collect();
    assert_eq!(series, [false, true], "pin, plate");
    let [pressure, friction, _] = apart(&solved(PIN, &mixed), &solved(PIN, &[NODES]));
    assert!(
        pressure < 2e-3 && friction < 1e-2,
        "{pressure:e} {friction:e}"
    );
}

#[test]
fn fields_of_series_are_those_of_elements() {
    let fields = ["output.fields=last"];
    let series = solved(PIN, &[&fields[..], &[NODES]].concat());
    let elements = solved(PIN, &[&fields[..], &["mesh.spacing=1.5 deg"]].concat());
    for (body, far) in [(0, [6.5, 3.0]), (1, [-30.0, 10.0]), (1, [12.0, 12.0])] {
        let at = |own: &Results| {
            let mesh = own.bodies[body].mesh.as_ref().unwrap();
            let away = |place: &[f64; 2]| (place[0] - far[0]).hypot(place[1] - far[1]);
            let nodes = mesh.nodes().iter().enumerate();
            let (node, place) = nodes
                .min_by(|one, other| away(one.1).total_cmp(&away(other.1)))
                .unwrap();
            let field = own.steps[2]
                .fields
                .iter()
                .find(|field| field.body == body)
                .unwrap();
            (*place, field.stress[node])
        };
        let ((one, stress), (other, expected)) = (at(&series), at(&elements));
        let moved = (one[0] - other[0]).hypot(one[1] - other[1]);
        assert!(moved < 3.0, "{one:?} {other:?}");
        let size = expected
            .iter()
            .fold(0.0_f64, |most, part| most.max(part.abs()));
        for (one, other) in stress.iter().zip(expected) {
            assert!(
                (one - other).abs() < 0.25 * size + 1.0,
                "body {body} {stress:?} {expected:?}"
            );
        }
    }
}

/// A whole disk that is free to turn has a moment of rounding, which is infinite at its centre.
#[test]
fn displacements_of_a_whole_disk_are_finite() {
    let changes = [
        "analysis.model=whole",
        NODES,
        "output.fields=last",
        "supports.0.on=pin.section",
    ];
    let results = solved(PIN, &changes);
    let fields = &results.steps[2].fields;
    assert_eq!(fields.len(), 2);
    for own in fields {
        assert!(own.displacement.iter().all(|part| part.is_finite()));
    }
}

#[test]
fn what_no_series_holds_is_named() {
    let of_plate = r#"bodies.plate.model="series""#;
    for (change, why) in [
        (
            r#"bodies.plate.shape={ plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "30 mm" } } }"#,
            "several curved edges",
        ),
        (
            r#"supports.1={ on = "plate.right", fix = ["y"] }"#,
            "held along an outer edge",
        ),
        (
            r#"materials.aluminium={ orthotropic = { e1 = "210 GPa", e2 = "2 GPa", g12 = "1 GPa", nu12 = 0.3 } }"#,
            "polynomials",
        ),
        ("contacts.0.projection=mortar", "mortar projection"),
    ] {
        let loads = r#"loads.0={ on = "plate.outer", pressure = { steps = ["1 MPa"] } }"#;
        let ring = change.contains("ring").then_some(loads);
        let changes: Vec<&str> = [change].into_iter().chain(ring).collect();
        let own = scene(PIN, &[&changes[..], &[of_plate]].concat());
        let error = stickslip::model::Model::build(&own)
            .unwrap_err()
            .to_string();
        assert!(error.contains(why) && error.contains("plate"), "{error}");
        // Left to the program, the scene is modelled by elements, and the result says why.
        let own = model(PIN, &changes);
        assert!(own.bodies.iter().all(|body| body.series.is_none()));
        let choice = own
            .choices
            .iter()
            .find(|choice| choice.what == "bodies by series");
        assert!(
            choice.is_some_and(|own| own.reason.contains(why)),
            "{change}"
        );
    }
    let pinned = scene(PIN, &["mesh.spacing=3 deg", NODES]);
    let error = stickslip::model::Model::build(&pinned)
        .unwrap_err()
        .to_string();
    assert!(error.contains("contact_nodes"), "{error}");
}

#[test]
fn half_the_accuracy_moves_a_value_by_less_than_its_error() {
    let by = |accuracy: &str| {
        let accuracy = format!("analysis.accuracy=\"{accuracy}\"");
        solved(PIN, &["contacts.0.friction.coulomb.mu=0", &accuracy])
    };
    let (coarse, fine) = (by("2 %"), by("1 %"));
    for (step, other) in coarse.steps.iter().zip(&fine.steps) {
        let (edge, other) = (&step.edges[0], &other.edges[0]);
        for stated in Stated::ASKED {
            let (Some(value), Some(better)) = (stated.value(edge), stated.value(other)) else {
                panic!("{stated:?}");
            };
            let error = edge.errors.get(stated).unwrap();
            assert!(
                (value - better).abs() <= error,
                "{stated:?} {value} {better} {error}"
            );
        }
    }
    let ladder = fine.ladder.unwrap();
    let asked = (ladder.asked, ladder.end);
    assert_eq!(asked, (Some(Accuracy::DEFAULT), LadderEnd::Reached));
}

#[test]
fn a_budget_ends_the_climb_with_an_honest_error() {
    let changes = [r#"analysis.accuracy="1e-6 %""#, r#"analysis.budget="1 ms""#];
    let found = results(&scene(PIN, &changes));
    let ladder = found.ladder.unwrap();
    assert_eq!(ladder.end, LadderEnd::Budget);
    let error = ladder.rungs.last().and_then(|rung| rung.error);
    assert!(error.is_some_and(|(error, _)| error > 1e-8), "{ladder:?}");
}

/// Where everything slips one, two and four increments agree, so eight are taken whatever the budget is.
#[test]
fn a_budget_leaves_eight_increments() {
    let text = PIN.replace("substeps = 1\n", "");
    let found = solved(
        &text,
        &[r#"analysis.accuracy="1e-4 %""#, r#"analysis.budget="1 ms""#],
    );
    let ladder = found.ladder.unwrap();
    assert_eq!(ladder.end, LadderEnd::Budget);
    let last = ladder.rungs.iter().rfind(|rung| !rung.stopped).unwrap();
    assert!(last.increments.iter().all(|&count| count >= 8), "{last:?}");
}

#[test]
fn a_mesh_of_the_scene_is_kept_and_its_errors_are_stated() {
    let found = solved(
        PIN,
        &["mesh.spacing=1.5 deg", r#"analysis.accuracy="0.001 %""#],
    );
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Pinned);
    let fine = solved(PIN, &["mesh.spacing=0.375 deg"]);
    for (step, truth) in found.steps.iter().zip(&fine.steps) {
        let (edge, truth) = (&step.edges[0], &truth.edges[0]);
        let stated = Stated::PeakPressure;
        let apart = stated.value(edge).unwrap() - stated.value(truth).unwrap();
        assert!(apart.abs() <= edge.errors.get(stated).unwrap());
    }
}

/// The scene at `path` without its mesh.
pub(super) fn without_mesh(path: &str) -> String {
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../").to_owned() + path;
    let text = std::fs::read_to_string(path).unwrap();
    let from = text.find("[mesh]").unwrap();
    let to = from + text[from..].find("\n\n").unwrap();
    text[..from].to_owned() + &text[to..]
}

/// Howland's strip with d/W = 0.5, σ_θ = 4.347599 of the far stress (solved anew, scenes/open-hole.toml).
#[test]
fn an_open_hole_reaches_its_accuracy_by_an_estimate() {
    let text = without_mesh("scenes/open-hole.toml");
    for accuracy in ["1 %", "0.01 %"] {
        let found = solved(&text, &[&format!("analysis.accuracy=\"{accuracy}\"")]);
        let ladder = found.ladder.as_ref().unwrap();
        let error = ladder.rungs.last().and_then(|rung| rung.error);
        let (error, of) = error.unwrap();
        assert_eq!(ladder.end, LadderEnd::Reached);
        assert_eq!(of, Stated::PeakHoop.into());
        assert!(error <= of.bound(ladder.asked.unwrap()).unwrap());
        let edge = &found.steps[0].edges[0];
        let apart = edge.peak_hoop.unwrap().0 - 434.7599;
        assert!(
            apart.abs() <= edge.errors.get(Stated::PeakHoop).unwrap(),
            "{apart:e}"
        );
    }
}

/// Beside a frictionless line contact σ_xx is nearly nothing, and relative to itself never accurate.
#[test]
fn a_stress_that_vanishes_does_not_decide() {
    let text = without_mesh("crates/scene/src/templates/hertz.toml");
    let found = solved(&text, &["output.figures=false", "output.fields=none"]);
    assert_eq!(found.ladder.unwrap().end, LadderEnd::Reached);
}
