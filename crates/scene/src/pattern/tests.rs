//! Scenes with patterns beside the same scenes written out, and what is refused.

use std::fmt::Write as _;
use std::path::Path;

use crate::document::Format;
use crate::scene::Scene;
use crate::schema::Springs;

const HEAD: &str = r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[mesh]
spacing = "6 deg"
[bodies.plate]
material = "metal"
thickness = "3 mm"
[bodies.plate.shape.outline]
start = ["-40 mm", "-12 mm"]
edges = [{ name = "bottom", to = ["114 mm", "-12 mm"] }, { name = "right", to = ["114 mm", "32 mm"] }, { name = "top", to = ["-40 mm", "32 mm"] }, { name = "left" }]
[[supports]]
on = "plate.bottom"
fix = ["y"]
[[loads]]
name = "pull"
on = "plate.left"
force = { direction = [-1, 0], steps = ["2 kN"] }
"#;

const PATTERN: &str = r#"
[bodies.plate.shape.outline.holes.hole]
centre = ["0.1 mm", "0 mm"]
radius = "3 mm"
pattern = { rows = 2, columns = 3, pitch = ["24.2 mm", "20 mm"] }
[bodies.bolt]
material = "metal"
thickness = "3 mm"
shape.disk.radius = "2.985 mm"
pattern = { rows = 2, columns = 3 }
[bodies.bolt_2_1]
shape.disk.radius = "2.99 mm"
[[contacts]]
name = "joint"
first = "plate.hole"
second = "bolt.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "bolt.section"
fix = ["x"]
[[loads]]
name = "aside"
on = "bolt.section"
force = { direction = [0, 1], steps = ["1 N"] }
"#;

fn written_out() -> String {
    let mut text = HEAD.to_owned();
    for row in 1..=2 {
        for column in 1..=3 {
            let x = ["0.1 mm", "24.3 mm", "48.5 mm"][column - 1];
            let y = ["0 mm", "20 mm"][row - 1];
            let radius = if [row, column] == [2, 1] {
                "2.99"
            } else {
                "2.985"
            };
            let name = format!("{row}_{column}");
            write!(
                text,
                r#"
[bodies.plate.shape.outline.holes.hole_{name}]
centre = ["{x}", "{y}"]
radius = "3 mm"
[bodies.bolt_{name}]
material = "metal"
thickness = "3 mm"
shape.disk.radius = "{radius} mm"
[[contacts]]
name = "joint_{name}"
first = "plate.hole_{name}"
second = "bolt_{name}.rim"
friction.coulomb = {{ mu = 0.2 }}
[[supports]]
on = "bolt_{name}.section"
fix = ["x"]
[[loads]]
name = "aside_{name}"
on = "bolt_{name}.section"
force = {{ direction = [0, 1], steps = ["1 N"] }}
"#
            )
            .unwrap();
        }
    }
    text
}

fn read(text: &str, overrides: &[&str]) -> Result<Scene, String> {
    let scene = Scene::from_text(text, Format::Toml, "a.toml", Path::new(""), overrides);
    scene.map_err(|error| error.to_string())
}

fn read_pattern(overrides: &[&str]) -> Scene {
    read(&format!("{HEAD}{PATTERN}"), overrides).unwrap()
}

#[test]
fn a_pattern_is_the_scene_written_out() {
    let out = read(&written_out(), &[]).unwrap();
    let own = read_pattern(&[]);
    assert_eq!(own.resolved(), out.resolved());
    assert_eq!(own.hash, out.hash);
    assert_eq!(own.contacts.len(), 6);
}

#[test]
fn overrides_change_all_copies_or_one() {
    let radius = |scene: &Scene, pin: &str| scene.bodies[pin].shape.circle("rim").unwrap();
    let scene = read_pattern(&["bodies.bolt.shape.disk.radius=2.97 mm"]);
    assert_eq!(radius(&scene, "bolt_1_2"), 2.97);
    assert_eq!(radius(&scene, "bolt_2_1"), 2.99);
    let one = [
        "bodies.bolt_1_2.shape.disk.radius=2.96 mm",
        "contacts.4.friction.coulomb.mu=0.4",
        "bodies.bolt.pattern.columns=4",
        "bodies.plate.shape.outline.holes.hole.pattern.columns=4",
    ];
    let scene = read_pattern(&one);
    assert_eq!(radius(&scene, "bolt_1_2"), 2.96);
    assert_eq!(radius(&scene, "bolt_1_3"), 2.985);
    assert_eq!(scene.contacts.len(), 8);
    assert_eq!(scene.contacts[4].name, "joint_2_1");
    let shown = format!("{:?}", scene.contacts[4].law);
    assert!(shown.contains("0.4"), "{shown}");
}

#[test]
fn a_table_that_an_override_brings_is_copied_too() {
    let pattern = "\npattern = { rows = 2, columns = 3, pitch = [\"24.2 mm\", \"20 mm\"] }";
    let text = format!("{HEAD}{PATTERN}");
    assert!(text.contains(pattern));
    let whole = r#"bodies.plate.shape.outline.holes.hole={ centre = ["0.1 mm", "0 mm"], radius = "3 mm", pattern = { rows = 2, columns = 3, pitch = ["24.2 mm", "20 mm"] } }"#;
    let scene = read(&text.replacen(pattern, "", 1), &[whole]).unwrap();
    assert_eq!(scene.resolved(), read_pattern(&[]).resolved());
}

#[test]
fn slots_and_bodies_with_places_are_copied() {
    let text = HEAD.to_owned()
        + r#"
[bodies.plate.shape.outline.cutouts.slot]
start = ["-4 mm", "-2 mm"]
edges = [{ name = "low", to = ["4 mm", "-2 mm"] }, { name = "end", to = ["4 mm", "2 mm"], through = ["6 mm", "0 mm"] }, { name = "high", to = ["-4 mm", "2 mm"], spline = [["2 mm", "2.5 mm"], ["-1 mm", "2.25 mm"]], leaves = "160 deg" }, { name = "back" }]
pattern = { columns = 2, pitch = ["30 mm", "0 mm"] }
[bodies.stud]
material = "metal"
thickness = "3 mm"
shape.rectangle = { width = "1 mm", height = "1 mm" }
position = ["0 mm", "60 mm"]
mesh.spacing = "1 mm"
pattern = { columns = 2, pitch = ["30 mm", "0 mm"] }
[[supports]]
on = "plate.back"
fix = ["x", "y"]
[[supports]]
on = "stud.top"
fix = ["x", "y"]
[[loads]]
name = "push"
on = "stud.bottom"
pressure.steps = ["1 MPa"]
"#;
    let scene = read(&text, &["mesh.spacing=4 mm"]).unwrap();
    let edge = scene.bodies["plate"].shape.edge("end_1_2").unwrap();
    assert!(edge.curve.path().unwrap().at(0.0)[0] > 33.0);
    // The walk around a cut-out has the body on its left.
    let curves = ["high_1_1", "high_1_2"].map(|name| {
        let edge = scene.bodies["plate"].shape.edge(name).unwrap();
        edge.curve.path().unwrap()
    });
    assert_eq!(curves[0].at(0.0), [-4.0, 2.0]);
    for part in [0.0, 0.3, 0.8, 1.0] {
        let [own, copy] = curves.each_ref().map(|path| path.at(part * path.length()));
        assert!((copy[0] - own[0] - 30.0).abs() < 1e-12 && (copy[1] - own[1]).abs() < 1e-12);
    }
    assert_eq!(scene.bodies["stud_1_2"].position, [30.0, 60.0]);
    assert_eq!(scene.supports[2].on.to_string(), "plate.back_1_2");
    assert_eq!(scene.loads.len(), 3);
}

#[test]
fn the_failure_of_a_pattern_is_that_of_its_copies() {
    let text = HEAD.to_owned()
        + r#"
[plies.tape]
e1 = "140 GPa"
e2 = "10 GPa"
g12 = "5 GPa"
nu12 = 0.3
thickness = "0.25 mm"
strengths = { xt = "1500 MPa", xc = "1200 MPa", yt = "50 MPa", yc = "200 MPa", s12 = "70 MPa" }
[materials.sheet.laminate]
layup = "[0/90]s"
ply = "tape"
[bodies.strip]
material = "sheet"
shape.rectangle = { width = "10 mm", height = "5 mm" }
position = ["0 mm", "60 mm"]
mesh.spacing = "1 mm"
pattern = { columns = 2, pitch = ["30 mm", "0 mm"] }
[[supports]]
on = "strip.left"
fix = ["x", "y"]
[[loads]]
name = "bend"
on = "strip.top"
pressure.steps = ["0.1 MPa"]
[failure]
bodies = ["strip"]
criteria = ["tsai_wu"]
"#;
    let scene = read(&text, &["mesh.spacing=4 mm"]).unwrap();
    let failure = scene.failure.unwrap();
    assert_eq!(failure.bodies, ["strip_1_1", "strip_1_2"]);
}

#[test]
fn patterns_that_do_not_fit_are_refused_where_they_stand() {
    let text = format!("{HEAD}{PATTERN}");
    for (from, to, part) in [
        (
            "rows = 2, columns = 3 }",
            "rows = 3, columns = 2 }",
            "'plate.hole' has 2 rows and 3 columns, and 'bolt.rim' 3 and 2",
        ),
        ("rows = 2, columns = 3 }", "rows = 0, columns = 3 }", "rows"),
        (
            "rows = 2, columns = 3 }",
            "rows = 1000, columns = 1000 }",
            "1000000 copies",
        ),
        (
            "pattern = { rows = 2, columns = 3 }",
            "position = [\"0 mm\", \"0 mm\"]\npattern = { rows = 2, columns = 3 }",
            "pitch",
        ),
        (
            "rows = 2, columns = 3 }",
            "rows = 2, colums = 3 }",
            "colums",
        ),
        (", pitch = [\"24.2 mm\", \"20 mm\"]", "", "pitch"),
        (
            "pitch = [\"24.2 mm\", \"20 mm\"]",
            "pitch = [\"24.2\", \"20 mm\"]",
            "has no unit",
        ),
        (
            "pitch = [\"24.2 mm\", \"20 mm\"]",
            "pitch = [\"4 mm\", \"20 mm\"]",
            "overlap",
        ),
        (
            "pitch = [\"24.2 mm\", \"20 mm\"]",
            "pitch = [\"24.2 mm\", \"0 mm\"]",
            "the pitch of its rows is 0",
        ),
    ] {
        assert!(text.contains(from), "{from}");
        let message = read(&text.replacen(from, to, 1), &[]).unwrap_err();
        assert!(message.contains(part), "{to}: {message}");
        assert!(message.starts_with("a.toml:"), "{message}");
    }
}

/// Two bolts through three plates, written once.
fn lap() -> String {
    let mut text = "version = 1\n[materials.metal.isotropic]\nyoung = \"70 GPa\"\npoisson = 0.3\n[mesh]\nspacing = \"6 deg\"\n".to_owned();
    for plate in ["one", "two", "three"] {
        write!(
            text,
            r#"
[bodies.{plate}]
material = "metal"
thickness = "3 mm"
[bodies.{plate}.shape.outline]
start = ["-20 mm", "-15 mm"]
edges = [
    {{ name = "low", to = ["50 mm", "-15 mm"] }}, {{ name = "end", to = ["50 mm", "15 mm"] }},
    {{ name = "high", to = ["-20 mm", "15 mm"] }}, {{ name = "near" }},
]
holes.hole = {{ centre = ["0 mm", "0 mm"], radius = "4 mm", pattern = {{ columns = 2, pitch = ["28 mm", "0 mm"] }} }}
[bodies.slice-{plate}]
material = "metal"
thickness = "3 mm"
shape.disk.radius = "3.98 mm"
pattern = {{ columns = 2 }}
[[contacts]]
name = "{plate}"
first = "{plate}.hole"
second = "slice-{plate}.rim"
friction.coulomb.mu = 0.1
"#
        )
        .unwrap();
    }
    text + r#"
[fasteners.bolt]
slices = ["slice-one", "slice-two", "slice-three"]
springs.beam = { head = "clamped", nut = "clamped" }
[[supports]]
on = "one.near"
fix = ["x", "y"]
[[supports]]
on = "three.near"
fix = ["x", "y"]
[[loads]]
on = "two.end"
force = { direction = [1, 0], steps = ["4 kN"] }
"#
}

#[test]
fn overrides_of_a_fastener_of_copies_change_all_or_one() {
    let clamped = |overrides: &[&str]| -> Vec<[bool; 2]> {
        let scene = read(&lap(), overrides).unwrap();
        let springs = scene.fasteners.iter().map(|own| &own.springs);
        let ends = springs.map(|springs| match springs {
            Springs::Beam { clamped } => *clamped,
            other => panic!("{other:?}"),
        });
        ends.collect()
    };
    assert_eq!(clamped(&[]), [[true; 2]; 2]);
    assert_eq!(
        clamped(&["fasteners.bolt.springs.beam.head=free"]),
        [[false, true]; 2]
    );
    let one = clamped(&["fasteners.bolt_1_2.springs.beam.head=free"]);
    assert_eq!(one, [[true, true], [false, true]]);
    let error = read(&lap(), &["fasteners.other.springs.beam.head=free"]).unwrap_err();
    assert!(error.contains("fasteners.other"), "{error}");
}
