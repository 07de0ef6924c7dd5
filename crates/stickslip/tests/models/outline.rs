//! Outlines and meshes of files: beside the shapes that say the same, beside series, beside themselves mirrored and moved, and what they
//! refuse.

use std::fs;
use std::path::Path;

use stickslip::host::HOST;
use stickslip::model::{Model, ModelError};
use stickslip::results::{ContactFinding, Finding, LadderEnd, Results, Stated};
use stickslip::run::run;
use stickslip::scene::shape::FileNote;
use stickslip::scene::{Format, Scene};
use stickslip_fem_core::generate::GenerateError;
use stickslip_fem_core::mesh::Mesh;
use tempfile::TempDir;

use super::{difference, refusal, scene, solved};

const FIVE: &str = include_str!("../../../../scenes/fasteners-five.toml");
const LUG: &str = include_str!("../../../../scenes/lug-oblique.toml");
const ECCENTRIC: &str = include_str!("../../../../scenes/eccentric-hole.toml");

const STRIP: &str = r#"plate_with_hole = { hole_radius = "5 mm", outline.strip = { half_width = "20 mm", left = "60 mm", right = "15 mm" } }"#;

/// The edges of that strip, moved by `x` and `y` and perhaps mirrored at y = 0.
fn outline([x, y]: [f64; 2]) -> String {
    let at = |a: f64, b: f64| format!(r#"["{} mm", "{} mm"]"#, a + x, b + y);
    format!(
        r#"outline = {{ start = {}, edges = [{{ name = "bottom", to = {} }}, {{ name = "right", to = {} }}, {{ name = "top", to = {} }}, {{ name = "left" }}], holes.hole = {{ centre = {}, radius = "5 mm" }} }}"#,
        at(-60.0, -20.0),
        at(15.0, -20.0),
        at(15.0, 20.0),
        at(-60.0, 20.0),
        at(0.0, 0.0),
    )
}

fn pinned(shape: &str) -> String {
    format!(
        r#"
version = 1
analysis.model = "whole"
materials.aluminium.isotropic = {{ young = "72 GPa", poisson = 0.33 }}
[bodies.plate]
material = "aluminium"
thickness = "2 mm"
shape.{shape}
[bodies.pin]
material = "aluminium"
thickness = "2 mm"
shape.disk.radius = "4.99 mm"
[mesh]
spacing = "3 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb.mu = 0.3
[[supports]]
on = "pin.section"
fix = ["x", "y"]
[[loads]]
on = "plate.left"
force = {{ direction = [-1, 0], steps = ["2 kN", "4 kN", "1 kN"] }}
"#
    )
}

/// The difference of two numbers, as a part of the larger.
fn apart(one: f64, other: f64) -> f64 {
    (one - other).abs() / one.abs().max(other.abs())
}

/// Peak pressure and half of the extent of contact `[MPa, rad]` in each step.
fn pressed(results: &Results) -> Vec<[f64; 2]> {
    let steps = results.steps.iter().map(|step| {
        let edge = &step.edges[0];
        [
            edge.peak_pressure.unwrap().0,
            edge.contact_half_extent.unwrap(),
        ]
    });
    steps.collect()
}

/// Forces of the contacts `[N]` in a step.
fn forces(results: &Results, step: usize) -> Vec<[f64; 2]> {
    let edges = results.steps[step].edges.iter();
    edges.map(|edge| edge.resultant).collect()
}

#[test]
fn an_outline_is_the_strip_that_it_draws() {
    let spacing = [r#"mesh.spacing="2 deg""#];
    let strip = pressed(&solved(&pinned(STRIP), &spacing));
    let same = pressed(&solved(&pinned(&outline([0.0, 0.0])), &spacing));
    for (own, other) in same.iter().zip(&strip) {
        assert!((own[0] / other[0] - 1.0).abs() < 1e-3, "{own:?} {other:?}");
        assert!((own[1] - other[1]).abs() < 0.2_f64.to_radians());
    }
}

/// All numbers of the contact: pressures and stresses, then lengths, then forces.
fn numbers(results: &Results) -> [Vec<f64>; 3] {
    let mut all = [const { Vec::new() }; 3];
    for edge in results.steps.iter().map(|step| &step.edges[0]) {
        all[0].push(edge.peak_pressure.unwrap().0);
        for row in &edge.rows {
            all[0].extend([row.pressure, row.shear, row.sigma_normal]);
            all[0].extend([row.sigma_tangential, row.tau]);
            all[1].extend([row.gap, row.slip]);
        }
        all[2].extend(edge.resultant);
    }
    all
}

/// Also on the deformed geometry, ten thousand times farther from the origin than the plate is long.
#[test]
fn where_a_scene_stands_changes_nothing() {
    let on_the_deformed = ["analysis.kinematics=deformed-gaps"];
    let plate = |by| pinned(&outline(by));
    let here = numbers(&solved(&plate([0.0; 2]), &on_the_deformed));
    let same = |text: &str| {
        let there = numbers(&solved(text, &on_the_deformed));
        for (own, other) in here.iter().zip(there) {
            let apart = difference(own.iter().copied(), other);
            assert!(apart < 1e-9, "{apart:e} in\n{text}");
        }
    };
    for by in [[37.5, -112.0], [50.3, 17.7], [3e3, 0.0], [1e6, -2e6]] {
        same(&plate(by));
    }
}

/// Two kinds of operator with nothing in common but the law of contact.
#[test]
fn a_series_about_an_eccentric_hole_agrees_with_elements() {
    let gaps = r#"analysis.kinematics="small""#;
    let series = solved(ECCENTRIC, &[gaps]);
    let accuracy = r#"analysis.accuracy={ peak_pressure = "2 %" }"#;
    let cells = solved(ECCENTRIC, &[gaps, accuracy, r#"mesh.spacing="1.5 deg""#]);
    for (step, (own, other)) in pressed(&series).iter().zip(pressed(&cells)).enumerate() {
        let error = |results: &Results| {
            let edge = &results.steps[step].edges[0];
            edge.errors
                .get(stickslip::results::Stated::PeakPressure)
                .unwrap()
        };
        let both = error(&series) + error(&cells);
        assert!(
            (own[0] - other[0]).abs() < both,
            "{own:?} {other:?} ± {both}"
        );
        assert!(both < 0.02 * own[0]);
    }
}

#[test]
fn shares_of_a_load_hang_neither_on_the_mesh_nor_on_the_kind_of_operator() {
    let coarse = solved(FIVE, &[r#"mesh.spacing="6 deg""#]);
    let fine = solved(FIVE, &[r#"mesh.spacing="3 deg""#]);
    let models: Vec<String> = (1..=5)
        .map(|k| format!("bodies.bolt-{k}.model=\"series\""))
        .collect();
    let models: Vec<&str> = models
        .iter()
        .map(String::as_str)
        .chain([r#"mesh.spacing="6 deg""#])
        .collect();
    let series = solved(FIVE, &models);
    for (step, load) in [2e3, 6e3, 12e3, 3e3].into_iter().enumerate() {
        let own = forces(&fine, step);
        let sum: f64 = own.iter().map(|force| force[0]).sum();
        assert!((sum / load - 1.0).abs() < 1e-9, "{sum} {load}");
        for other in [forces(&coarse, step), forces(&series, step)] {
            for (a, b) in own.iter().zip(&other) {
                assert!((a[0] - b[0]).abs() < 1e-3 * load, "{a:?} {b:?}");
            }
        }
    }
    let two = [
        "supports.0.fix=[\"x\"]",
        "supports.0.displacement=\"0.01 mm\"",
        "supports.5={ on = \"bolt-1.section\", fix = [\"x\"] }",
    ];
    let twice = Scene::from_text_on(FIVE, Format::Toml, "five.toml", Path::new(""), &two, HOST);
    let message = twice
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    assert!(message.contains("by another displacement"), "{message}");
    let held_at_points = |results: &Results| {
        let mut findings = results.findings.iter();
        findings.any(|finding| matches!(finding, Finding::PointSupports { .. }))
    };
    assert!(!held_at_points(&fine));
    let at_points = FIVE.replace(".section\"", ".centre\"");
    assert!(held_at_points(&solved(
        &at_points,
        &[r#"mesh.spacing="6 deg""#]
    )));
}

#[test]
fn a_mirrored_pull_gives_mirrored_numbers() {
    let force = |y: f64| format!("loads.0.force.direction=[1, {y}]");
    let coarse = r#"mesh.spacing="3 deg""#;
    let [up, down] = [1.0, -1.0].map(|y| solved(LUG, &[coarse, &force(y)]));
    // Triangles of a symmetric outline are not symmetric, which shows where pressure has turned points while unloading.
    let both = pressed(&up).into_iter().zip(pressed(&down));
    for ((own, other), bound) in both.zip([2e-3, 2e-3, 1e-2]) {
        assert!(apart(own[0], other[0]) < bound, "{own:?} {other:?}");
    }
    for step in 0..3 {
        let ([a], [b]) = (&forces(&up, step)[..], &forces(&down, step)[..]) else {
            panic!("one contact");
        };
        assert!(apart(a[0], b[0]) < 1e-9 && apart(a[1], -b[1]) < 1e-9);
    }
}

/// Meshes of a run read back, in another unit, as `.msh`, as `.inp`, and as one of two bodies of one file.
#[test]
fn a_mesh_that_was_written_gives_the_same_numbers() {
    let strip = solved(&pinned(STRIP), &[""; 0]);
    let folder = TempDir::new().unwrap();
    let mesh = strip
        .bodies
        .iter()
        .find(|body| body.name == "plate")
        .unwrap();
    let mesh = mesh.mesh.as_deref().unwrap();
    let state = stickslip_fem_core::material::PlaneState::Stress;
    let msh = stickslip_mesh_files::write_msh(mesh).unwrap();
    let inp = stickslip_mesh_files::write_inp(mesh, state).unwrap();
    // Neither forces nor springs are shared by the nodes of a set.
    let pads = format!("{inp}*NSET, NSET=pads\n1, 500, 900\n");
    fs::write(folder.path().join("pads.inp"), pads).unwrap();
    let text = pinned(r#"mesh = { file = "pads.inp", unit = "mm" }"#);
    let on_pads = text.replace("on = \"plate.left\"", "on = \"plate.pads\"");
    let refused = read(&on_pads, folder.path()).err().unwrap_or_default();
    assert!(
        refused.contains("plate.pads is a set of 3 nodes"),
        "{refused}"
    );
    for (name, text) in [("plate.msh", msh), ("plate.inp", inp)] {
        fs::write(folder.path().join(name), text).unwrap();
        let text = pinned(&format!(r#"mesh = {{ file = "{name}", unit = "mm" }}"#));
        let found = run(&read(&text, folder.path()).unwrap(), &mut |_| {}).unwrap();
        for (own, other) in pressed(&found).iter().zip(pressed(&strip)) {
            assert!(apart(own[0], other[0]) < 1e-6, "{name}: {own:?} {other:?}");
        }
    }
}

const BRACKET: &str = r#"
version = 1
mesh.spacing = "15 deg"
[materials.steel.isotropic]
young = "210 GPa"
poisson = 0.3
[bodies.bracket]
material = "steel"
thickness = "3 mm"
[[supports]]
on = "bracket.top"
fix = ["x", "y"]
[[loads]]
on = "bracket.right"
force = { direction = [0, -1], steps = ["1 kN"] }
[[edges]]
on = "bracket.inner"
[[edges]]
on = "bracket.hole"
[bodies.bracket.shape]
"#;

/// A mesh of a file has the corners of the outline that it was made of, and a hole of 24 chords has none.
#[test]
fn corners_of_meshes_from_files_have_no_limit_either() {
    let corners = |found: &Results| -> Vec<(String, f64)> {
        let own = found.findings.iter().filter_map(|own| match own {
            Finding::NoLimitAtReentrantCorner { edge, angle, .. } => Some((edge.clone(), *angle)),
            _ => None,
        });
        own.collect()
    };
    let drawn = BRACKET.to_owned()
        + r#"outline = { start = ["0 mm", "0 mm"], edges = [{ name = "bottom", to = ["30 mm", "0 mm"] }, { name = "right", to = ["30 mm", "10 mm"] }, { name = "inner", to = ["10 mm", "10 mm"] }, { name = "back", to = ["10 mm", "30 mm"] }, { name = "top", to = ["0 mm", "30 mm"] }, { name = "left" }], holes.hole = { centre = ["5 mm", "5 mm"], radius = "2 mm" } }"#;
    let found = solved(&drawn, &["mesh.element=T3"]);
    let wanted = corners(&found);
    assert_eq!(wanted.len(), 1, "{wanted:?}");
    let mesh = found.bodies[0].mesh.as_deref().unwrap();
    let state = stickslip_fem_core::material::PlaneState::Stress;
    let inp = stickslip_mesh_files::write_inp(mesh, state).unwrap();
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("bracket.inp"), inp).unwrap();
    let given = BRACKET.replace("mesh.spacing = \"15 deg\"\n", "")
        + r#"mesh = { file = "bracket.inp", unit = "mm" }"#;
    let read = run(&read(&given, folder.path()).unwrap(), &mut |_| {}).unwrap();
    let own = corners(&read);
    assert_eq!(own.len(), 1, "{own:?}");
    assert_eq!(own[0].0, wanted[0].0);
    assert!((own[0].1 - wanted[0].1).abs() < 1e-6, "{own:?} {wanted:?}");
}

/// A pulled strip on a pin, guided at its end because the best circle is not quite where the pull goes through.
fn guided(shape: &str) -> String {
    pinned(shape).replace(
        "[[loads]]",
        "[[supports]]\non = \"plate.left\"\nfix = [\"y\"]\n[[loads]]",
    )
}

/// Results of a guided strip, and its mesh as `rough.msh` in mm and `metres.msh` in m, with nodes of the hole off it by up to a thousandth.
fn with_rough_hole() -> (TempDir, Results) {
    let strip = solved(&guided(STRIP), &[""; 0]);
    let mut bodies = strip.bodies.iter();
    let plate = bodies.find(|body| body.name == "plate").unwrap();
    let mesh = plate.mesh.as_deref().unwrap();
    let hole = mesh.edge_path("hole").unwrap().nodes;
    let mut parts = mesh.clone().into_parts();
    for (k, &node) in hole.iter().enumerate() {
        let off = 1.0 + 1e-3 * (12.9898 * (k * k) as f64).sin();
        parts.nodes[node] = parts.nodes[node].map(|x| off * x);
    }
    let folder = TempDir::new().unwrap();
    for (file, scale) in [("rough.msh", 1.0), ("metres.msh", 1e-3)] {
        let mut own = parts.clone();
        own.nodes = own.nodes.iter().map(|at| at.map(|x| scale * x)).collect();
        let text = stickslip_mesh_files::write_msh(&Mesh::new(own).unwrap()).unwrap();
        fs::write(folder.path().join(file), text).unwrap();
    }
    (folder, strip)
}

/// Nodes of a hole that its file has off by 1e-3 of the radius press as those of the circle, once it is declared to be one.
#[test]
fn a_declared_circle_gets_its_nodes() {
    let (folder, strip) = with_rough_hole();
    let text = |circles: &str| {
        guided(&format!(
            r#"mesh = {{ file = "rough.msh", unit = "mm"{circles} }}"#
        ))
    };
    let scene = |circles: &str| read(&text(circles), folder.path());
    let no_circle = refusal(folder.path(), &text(""), &[]);
    assert!(no_circle.contains("name it in `circles`"), "{no_circle}");
    for (circles, expected) in [
        (r#", circles = ["left"]"#, "edge set 'left' is open"),
        (r#", circles = ["bore"]"#, "no edge set 'bore'"),
        (r#", circles = ["hole", "hole"]"#, "declared twice"),
        (
            r#", circles = ["hole"], splines = ["hole"]"#,
            "named in `circles` too",
        ),
        (
            r#", radii = ["5 mm"]"#,
            "numbers of circles (0) and of their radii (1) differ",
        ),
        (
            r#", circles = ["hole"], radii = ["5 mm", "5 mm"]"#,
            "numbers of circles (1) and of their radii (2) differ",
        ),
        (
            r#", circles = ["hole"], radii = ["5 in"]"#,
            "times the given radius",
        ),
    ] {
        let refused = scene(circles).err().unwrap_or_default();
        assert!(refused.contains(expected), "{refused}");
    }
    let found = run(&scene(r#", circles = ["hole"]"#).unwrap(), &mut |_| {}).unwrap();
    let note = found.findings.iter().find_map(|finding| match finding {
        Finding::MeshFile { notes, .. } => notes.iter().find_map(|note| match note {
            FileNote::DeclaredCircle { edge, radius, .. } => Some((edge, *radius)),
            _ => None,
        }),
        _ => None,
    });
    let (edge, radius) = note.expect("a note on the circle");
    assert_eq!(edge, "hole");
    assert!((radius - 5.0).abs() < 0.005, "{radius}");
    let (edge, off) = fitted(&found).expect("a finding on the radius");
    assert_eq!(edge, "plate.hole");
    assert!((4e-3..6e-3).contains(&off), "{off}");
    // The best circle is off by some 1e-4 of the radius, beside a clearance of 2e-3.
    for (own, other) in pressed(&found).iter().zip(pressed(&strip)) {
        assert!(apart(own[0], other[0]) < 1e-2, "{own:?} {other:?}");
    }
}

/// A known radius, in a unit of its own, is that of the circle: only its centre is fitted, and a pin that does not fit is refused with both radii.
#[test]
fn a_known_radius_is_that_of_the_circle() {
    let (folder, strip) = with_rough_hole();
    let known = guided(
        r#"mesh = { file = "metres.msh", unit = "m", circles = ["hole"], radii = ["0.5 cm"] }"#,
    );
    let found = run(&read(&known, folder.path()).unwrap(), &mut |_| {}).unwrap();
    for (own, other) in pressed(&found).iter().zip(pressed(&strip)) {
        assert!(apart(own[0], other[0]) < 3e-3, "{own:?} {other:?}");
    }
    assert!(fitted(&found).is_none() && other(&found).is_none());
    // Nodes off the hole by 0.005 mm are on no circle whose radius is larger by 0.05 mm.
    let wide = known.replace("0.5 cm", "0.505 cm");
    let found = run(&read(&wide, folder.path()).unwrap(), &mut |_| {}).unwrap();
    let (edge, radii) = other(&found).expect("a finding on the radius");
    assert_eq!((edge, radii[0]), ("plate.hole", 5.05));
    assert!(apart(radii[1], 5.0) < 1e-3, "{radii:?}");
    let fit = guided(r#"mesh = { file = "rough.msh", unit = "mm", circles = ["hole"] }"#);
    let tight = refusal(
        folder.path(),
        &fit,
        &["bodies.pin.shape.disk.radius=5.01 mm"],
    );
    assert!(
        tight.contains("`radii` of the mesh gives the true one"),
        "{tight}"
    );
}

fn read(text: &str, folder: &Path) -> Result<Scene, String> {
    let none: [&str; 0] = [];
    let scene = Scene::from_text_on(text, Format::Toml, "own.toml", folder, &none, HOST);
    scene.map_err(|error| error.to_string())
}

/// The circle whose radius is another one than that of its nodes, and both.
fn other(results: &Results) -> Option<(&str, [f64; 2])> {
    results.findings.iter().find_map(|finding| match finding {
        Finding::Contact {
            finding:
                ContactFinding::OtherRadius {
                    edge,
                    given,
                    fitted,
                    ..
                },
            ..
        } => Some((edge.as_str(), [given.value(), fitted.value()])),
        _ => None,
    })
}

/// The circle whose fitted radius is in doubt, and how far its nodes were off it.
fn fitted(results: &Results) -> Option<(&str, f64)> {
    results.findings.iter().find_map(|finding| match finding {
        Finding::Contact {
            finding: ContactFinding::FittedRadius { edge, off, .. },
            ..
        } => Some((edge.as_str(), off.value())),
        _ => None,
    })
}

#[test]
fn what_bounds_no_body_is_refused() {
    let good = outline([0.0, 0.0]);
    let folder = TempDir::new().unwrap();
    for (from, to, part) in [
        (
            r#"to = ["15 mm", "20 mm"]"#,
            r#"to = ["-70 mm", "0 mm"]"#,
            "meet near",
        ),
        (
            r#"{ name = "left" }"#,
            r#"{ name = "left", to = ["-60 mm", "-19 mm"] }"#,
            "is open",
        ),
        (
            r#"name = "right", to"#,
            r#"name = "hole", to"#,
            "two edges are called 'hole'",
        ),
        (
            r#"name = "right", to"#,
            r#"name = "right", through = ["15 mm", "0 mm"], to"#,
            "lie on a line",
        ),
        (
            r#"{ name = "bottom", to = ["15 mm", "-20 mm"] }"#,
            r#"{ name = "bottom" }"#,
            "has no end",
        ),
        (
            r#"centre = ["0 mm", "0 mm"]"#,
            r#"centre = ["12 mm", "0 mm"]"#,
            "crosses edge",
        ),
        (
            r#"centre = ["0 mm", "0 mm"]"#,
            r#"centre = ["99 mm", "0 mm"]"#,
            "lies outside",
        ),
    ] {
        assert!(good.contains(from), "{from}");
        let refused = read(&pinned(&good.replacen(from, to, 1)), folder.path());
        let message = refused.err().unwrap_or_default();
        assert!(message.contains(part), "{to}: {message}");
    }
}

#[test]
fn meshes_that_are_none_are_refused() {
    let folder = TempDir::new().unwrap();
    fs::write(
        folder.path().join("solid.inp"),
        "*NODE\n1,0,0,0\n*ELEMENT, TYPE=C3D8\n1,1,1,1,1,1,1,1,1\n",
    )
    .unwrap();
    for (shape, part) in [
        (r#"mesh = { file = "none.msh", unit = "mm" }"#, "none.msh"),
        (
            r#"mesh = { file = "solid.stl", unit = "mm" }"#,
            "none of .msh, .inp and .vtu",
        ),
        (r#"mesh = { file = "solid.inp", unit = "mm" }"#, "C3D8"),
        (r#"mesh = { file = "solid.inp" }"#, "unit"),
    ] {
        let message = read(&pinned(shape), folder.path())
            .err()
            .unwrap_or_default();
        assert!(message.contains(part), "{shape}: {message}");
    }
}

/// A plate and its pin in one file, away from the origin, each an element set of its own.
#[test]
fn two_bodies_of_one_file_stand_where_they_touch() {
    let strip = solved(&pinned(STRIP), &[""; 0]);
    let meshes = ["plate", "pin"].map(|name| {
        let body = strip.bodies.iter().find(|body| body.name == name);
        body.unwrap().mesh.clone().unwrap()
    });
    let mut nodes = vec!["*NODE".to_owned()];
    let mut rest = Vec::new();
    let mut first = 0;
    for (name, mesh) in ["plate", "pin"].into_iter().zip(&meshes) {
        let numbers = |list: &[usize], join: &str| {
            let each: Vec<String> = list
                .iter()
                .map(|node| (first + node + 1).to_string())
                .collect();
            each.join(join)
        };
        let places = mesh.nodes().iter().zip(first + 1..);
        nodes.extend(places.map(|([x, y], k)| format!("{k}, {:.14}, {:.14}", x + 40.0, y - 25.0)));
        rest.push(format!("*ELEMENT, TYPE=CPS8, ELSET={name}"));
        let cells = 0..mesh.element_count();
        rest.extend(
            cells.map(|k| format!("{}, {}", first + k + 1, numbers(mesh.element(k).1, ", "))),
        );
        for set in mesh.node_set_names() {
            rest.push(format!("*NSET, NSET={name}-{set}"));
            rest.push(numbers(mesh.node_set(set).unwrap(), ",\n"));
        }
        first += mesh.nodes().len();
    }
    nodes.extend(rest);
    let folder = TempDir::new().unwrap();
    fs::write(folder.path().join("both.inp"), nodes.join("\n") + "\n").unwrap();
    let given =
        |name: &str| format!(r#"mesh = {{ file = "both.inp", unit = "mm", elements = "{name}" }}"#);
    let scene = pinned(&given("plate"))
        .replace(
            r#"shape.disk.radius = "4.99 mm""#,
            &format!("shape.{}", given("pin")),
        )
        .replace("[mesh]\nspacing = \"3 deg\"\n", "")
        .replace("plate.hole", "plate.plate-hole")
        .replace("plate.left", "plate.plate-left")
        .replace("pin.rim", "pin.pin-rim");
    for kinematics in ["small", "deformed-gaps"] {
        let gaps = format!("analysis.kinematics=\"{kinematics}\"");
        let strip = solved(&pinned(STRIP), &[gaps.as_str()]);
        let scene = Scene::from_text_on(
            &scene,
            Format::Toml,
            "own.toml",
            folder.path(),
            &[gaps],
            HOST,
        );
        let found = run(&scene.unwrap(), &mut |_| {}).unwrap();
        for (own, other) in pressed(&found).iter().zip(pressed(&strip)) {
            assert!(
                apart(own[0], other[0]) < 1e-6,
                "{kinematics}: {own:?} {other:?}"
            );
        }
    }
}

/// Six bolts that were pushed and that nothing loads any more: no force is left, and no search among points that close without force is needed.
#[test]
fn unloaded_bolts_are_released() {
    let six = FIVE
        .replace("\"114 mm\"", "\"138 mm\"")
        .replace(
            "hole-5 =",
            "hole-6 = { centre = [\"120 mm\", \"0 mm\"], radius = \"3 mm\" }\nhole-5 =",
        )
        .replace(
            "[mesh]",
            "[bodies.bolt-6]\nmaterial = \"steel\"\nthickness = \"3 mm\"\nshape.disk.radius = \"2.985 mm\"\n[mesh]",
        );
    let changes = [
        "mesh.spacing=6 deg",
        "loads.0.force.steps=[\"-3 kN\", \"0 N\"]",
        "supports.5={ on = \"bolt-6.section\", fix = [\"x\", \"y\"] }",
        "contacts.5={ first = \"plate.hole-6\", second = \"bolt-6.rim\", friction.coulomb.mu = 0.2 }",
    ];
    let found = solved(&six, &changes);
    let last = &found.steps[1];
    assert!(!last.solvers.contains(&"pivoting"), "{:?}", last.solvers);
    assert_eq!(forces(&found, 1), [[0.0; 2]; 6]);
}

/// A plate without holes whose clamped edge ends at its corners, where stress has no bound: that is said, and no finer mesh is tried for it.
#[test]
fn a_clamped_corner_has_no_limit_and_ends_the_search() {
    let plate = r#"
version = 1
materials.aluminium.isotropic = { young = "72 GPa", poisson = 0.33 }
[bodies.plate]
material = "aluminium"
thickness = "2 mm"
shape.outline = { start = ["0 mm", "0 mm"], edges = [{ name = "bottom", to = ["40 mm", "0 mm"] }, { name = "right", to = ["40 mm", "20 mm"] }, { name = "top", to = ["0 mm", "20 mm"] }, { name = "left" }] }
[[supports]]
on = "plate.left"
fix = ["x", "y"]
[[loads]]
on = "plate.right"
force = { direction = [1, 0], steps = ["2 kN"] }
[[edges]]
on = "plate.bottom"
"#;
    let found = solved(plate, &[""; 0]);
    let ladder = found.ladder.as_ref().unwrap();
    assert_eq!(ladder.end, LadderEnd::Unstated);
    let said = |finding: &Finding| matches!(finding, Finding::NoLimitAtSupport { edge, .. } if edge == "plate.bottom");
    assert!(found.findings.iter().any(said), "{:?}", found.findings);
    assert!(
        found.steps[0].edges[0]
            .errors
            .get(Stated::PeakHoop)
            .is_none()
    );
}

/// What no mesh divides is reported at its place in the drawing.
#[test]
fn a_thin_ligament_is_reported_where_it_stands() {
    for [x, y] in [[0.0, 0.0], [100.0, -40.0]] {
        let text = pinned(&outline([x, y])).replace("\"5 mm\"", "\"14.9999 mm\"");
        let text = text.replace("\"4.99 mm\"", "\"14.98 mm\"");
        let refused = Model::build(&scene(&text, &[])).err();
        let Some(ModelError::Generate { cause, .. }) = refused else {
            panic!("{refused:?}");
        };
        let GenerateError::Contour { at: Some(at), .. } = cause else {
            panic!("{cause}");
        };
        let apart = (at[0] - x - 15.0).hypot(at[1] - y);
        assert!(apart < 0.5, "{at:?}");
    }
}
