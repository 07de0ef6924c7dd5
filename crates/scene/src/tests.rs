//! Scenes that are right, and what tests of wrong ones share.

mod collected;
mod lists;
mod refusals;

use std::path::Path;

use serde_json::Value;

use crate::diagnostic::{Finding, SceneError, SceneProblem};
use crate::schema::{Division, Hold, LoadKind, Shape, Substance};
use crate::shape::Strip;
use crate::{Format, Scene};

const SCENE: &str = r#"version = 1
title = "Pin"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.plate]
material = "steel"
thickness = "2 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "90 mm", right = "20 mm" }
[bodies.pin]
material = "steel"
thickness = "2 mm"
shape.disk = { radius = "4.99 mm" }
[mesh]
spacing = "2 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = { direction = [-2, 0], steps = ["1 kN", "2 kN"] }
"#;

fn read(text: &str) -> Result<Scene, SceneError> {
    Scene::from_text(text, Format::Toml, "a.toml", Path::new(""), &[] as &[&str])
}

/// The only finding of the scene with `from` replaced by `to`.
fn refused(from: &str, to: &str) -> Finding {
    assert!(SCENE.contains(from), "{from}");
    let error = read(&SCENE.replace(from, to)).unwrap_err();
    assert_eq!(error.findings().len(), 1, "{error}");
    error.findings()[0].clone()
}

/// The text that a finding points at.
fn shown(finding: &Finding) -> &str {
    &finding.source.text[finding.span.clone().unwrap()]
}

/// Its message, and its remedy on the next line.
fn said(finding: &Finding) -> String {
    let help = finding.summary().help.unwrap_or_default();
    format!("{finding}\n{help}")
}

#[test]
fn a_scene_arrives_in_base_units() {
    let scene = read(SCENE).unwrap();
    assert_eq!((scene.steps(), scene.title.as_str()), (2, "Pin"));
    let plate = &scene.bodies["plate"];
    assert_eq!(
        plate.substance,
        Substance::Elastic {
            material: "steel".into(),
            thickness: 2.0
        }
    );
    assert_eq!(
        plate.shape,
        Shape::Strip(Strip {
            hole_radius: 5.0,
            half_width: 20.0,
            left: 90.0,
            right: 20.0,
        })
    );
    let LoadKind::Force {
        direction, steps, ..
    } = &scene.loads[0].kind
    else {
        panic!("{:?}", scene.loads);
    };
    assert_eq!(
        (*direction, steps.as_slice()),
        ([-1.0, 0.0], &[1000.0, 2000.0][..])
    );
    let Division::Angular(grading) = scene.mesh.division else {
        panic!("{:?}", scene.mesh);
    };
    assert_eq!(grading.spacing, 2.0_f64.to_radians());
    assert!(matches!(scene.supports[0].hold, Hold::Axes(axes) if axes.x && axes.y));
    assert_eq!(scene.contacts[0].law.name(), "coulomb");
}

/// Increments that are left to the program are not those of a scene that gives them.
#[test]
fn increments_that_are_left_to_the_program_stay_so_in_the_resolved_scene() {
    let free = SCENE.replace("[mesh]\nspacing = \"2 deg\"\n", "");
    let (meshed, free) = (read(SCENE).unwrap(), read(&free).unwrap());
    assert_eq!(meshed.analysis.substeps, Some(1));
    assert_eq!(free.analysis.substeps, None);
    assert!(!free.resolved().contains("substeps") && !free.resolved().contains("ramp"));
    let again = read(free.resolved()).unwrap();
    assert_eq!(
        (again.analysis, again.hash),
        (free.analysis, free.hash.clone())
    );
    let given = free
        .resolved()
        .replace("[analysis]\n", "[analysis]\nsubsteps = 1\n");
    assert_ne!(read(&given).unwrap().hash, free.hash);
}

#[test]
fn the_resolved_scene_reads_back_to_itself() {
    let scene = read(SCENE).unwrap();
    let again = read(scene.resolved()).unwrap();
    assert_eq!(scene.resolved(), again.resolved());
    assert_eq!(scene.hash, again.hash);
    for default in [
        "plane = \"stress\"",
        "solver = \"auto\"",
        "element = \"Q8\"",
        "fields = \"peak\"",
        "gap = \"exact\"",
    ] {
        assert!(
            scene.resolved().contains(default),
            "{default} in {}",
            scene.resolved()
        );
    }
}

#[test]
fn the_hash_sees_numbers_and_not_their_units() {
    let scene = read(SCENE).unwrap();
    assert_eq!(scene.hash.len(), 64);
    let other = |from: &str, to: &str| read(&SCENE.replace(from, to)).unwrap().hash;
    assert_eq!(
        scene.hash,
        other("\"210 GPa\"", "\"210e3 MPa\"   # a comment")
    );
    assert_ne!(scene.hash, other("\"210 GPa\"", "\"211 GPa\""));
}

#[test]
fn json_has_the_same_schema() {
    let table: Value = toml::from_str(SCENE).unwrap();
    let text = serde_json::to_string_pretty(&table).unwrap();
    let scene =
        Scene::from_text(&text, Format::Json, "a.json", Path::new(""), &[] as &[&str]).unwrap();
    assert_eq!(scene.hash, read(SCENE).unwrap().hash);
    let wrong = text.replace("\"2 mm\"", "2");
    let error = Scene::from_text(
        &wrong,
        Format::Json,
        "a.json",
        Path::new(""),
        &[] as &[&str],
    )
    .unwrap_err();
    let line = wrong
        .lines()
        .position(|line| line.contains("\"thickness\": 2"))
        .unwrap()
        + 1;
    assert!(
        error.to_string().starts_with(&format!("a.json:{line}:")),
        "{error}"
    );
}

#[test]
fn no_typing_error_makes_it_panic() {
    let table: Value = toml::from_str(SCENE).unwrap();
    let json = serde_json::to_string_pretty(&table).unwrap();
    for (text, format) in [(SCENE, Format::Toml), (json.as_str(), Format::Json)] {
        for at in (0..text.len()).filter(|at| text.is_char_boundary(*at)) {
            for insert in ["", "\"", "[", "{", "-", ".", "9e9", "\n", "ü", "null"] {
                let next = text[at..].chars().next().map_or(0, char::len_utf8);
                for rest in [&text[at..], &text[at + next..]] {
                    let broken = format!("{}{insert}{rest}", &text[..at]);
                    let read =
                        Scene::from_text(&broken, format, "a", Path::new(""), &[] as &[&str]);
                    if let Err(error) = read {
                        assert!(
                            error
                                .findings()
                                .iter()
                                .all(|finding| finding.position().is_some()),
                            "{error}"
                        );
                    }
                }
            }
        }
    }
}

#[test]
fn a_body_takes_from_the_scene_what_its_own_mesh_leaves_out() {
    let with = |own: &str| {
        let text = SCENE
            .replace("[bodies.plate]", "[bodies.plate]\nmesh = { layers = 4 }")
            .replace(
                "[mesh]\nspacing = \"2 deg\"",
                "[mesh]\nspacing = \"2 deg\"\nfine_to = \"90 deg\"\ncoarse_spacing = \"5 deg\"\nlayers = 9",
            )
            .replace(
                "shape.disk = { radius = \"4.99 mm\" }",
                &format!("shape.disk = {{ radius = \"4.99 mm\" }}\nmesh = {{ {own} }}"),
            );
        let scene = read(&text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(
            (scene.mesh_of("plate").layers, scene.mesh.layers),
            (Some(4), Some(9))
        );
        assert_eq!(scene.mesh_of("plate").division, scene.mesh.division);
        let again = read(scene.resolved()).unwrap();
        for body in ["plate", "pin"] {
            assert_eq!(again.mesh_of(body), scene.mesh_of(body), "{own}");
        }
        scene
    };
    let graded = |scene: &Scene| match scene.mesh_of("pin").division {
        Division::Angular(grading) => {
            let degrees = |value: Option<f64>| value.map(|value| value.to_degrees().round());
            (
                grading.spacing.to_degrees().round(),
                degrees(grading.fine_to),
                degrees(grading.coarse_spacing),
            )
        }
        _ => panic!("{:?}", scene.mesh_of("pin")),
    };
    let scene = with("element = \"Q4\"");
    assert_eq!(graded(&scene), (2.0, Some(90.0), Some(5.0)));
    assert_eq!(scene.mesh_of("pin").layers, Some(9));
    assert_ne!(scene.mesh_of("pin").element, scene.mesh.element);
    let scene = with("spacing = \"3 deg\"");
    assert_eq!(graded(&scene), (3.0, Some(90.0), None));
    assert_eq!(
        graded(&with("fine_to = \"60 deg\"")),
        (2.0, Some(60.0), Some(5.0))
    );
    let scene = with("angles = [\"0 deg\", \"90 deg\", \"180 deg\"]");
    assert!(
        matches!(&scene.mesh_of("pin").division, Division::AngleList(angles) if angles.len() == 3)
    );
}

/// A wedge of 8 by 6 mm beside the joint, whose face has cells `refine` times smaller than the largest.
#[test]
fn the_program_divides_round_bodies_by_angles_and_others_by_lengths() {
    let divided = |refine: f64| {
        let wedge = format!(
            r#"[bodies.wedge]
material = "steel"
thickness = "2 mm"
[bodies.wedge.shape.outline]
start = ["0 mm", "0 mm"]
edges = [
  {{ name = "face", to = ["8 mm", "0 mm"], refine = {refine} }},
  {{ name = "side", to = ["8 mm", "6 mm"] }},
  {{ name = "back" }},
]
[[supports]]
on = "wedge.side"
fix = ["x", "y"]
"#
        );
        let scene = SCENE.replace("[mesh]\nspacing = \"2 deg\"\n", "") + &wedge;
        let scene = read(&scene).unwrap_or_else(|error| panic!("{error}"));
        let Division::Angular(round) = scene.mesh_of("plate").division else {
            panic!("{:?}", scene.mesh);
        };
        assert!((round.spacing.to_degrees() - 3.0).abs() < 1e-12);
        match scene.mesh_of("wedge").division {
            Division::Linear(grading) => grading.spacing,
            _ => panic!("{:?}", scene.mesh_of("wedge")),
        }
    };
    let spacings = [1.0, 3.0, 50.0].map(divided);
    assert_eq!(spacings, [6.0 / 32.0, 18.0 / 32.0, 6.0 / 4.0]);
}
