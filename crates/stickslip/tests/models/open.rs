//! Open edges in contact: against closed forms, meshes that do not match, the two bodies exchanged, and what is refused.

mod ends;

use std::f64::consts::PI;

use stickslip::model::Model;
use stickslip::results::{ContactFinding, EdgeResults, Finding, Results};

use super::{scene, solved};

const PUNCH: &str = include_str!("../../../../scenes/rounded-punch.toml");

/// E* of two like bodies of the scene in plane strain `[MPa]`.
const MODULUS: f64 = 73_100.0 / (2.0 * (1.0 - 0.33 * 0.33));

/// π − 2φ − sin 2φ.
fn shape(angle: f64) -> f64 {
    PI - 2.0 * angle - (2.0 * angle).sin()
}

pub(crate) fn close(found: f64, expected: f64, part: f64) {
    assert!(
        (found - expected).abs() <= part * expected.abs(),
        "{found} {expected}: {:.2e}",
        found / expected - 1.0
    );
}

fn edge(results: &Results, step: usize) -> &EdgeResults {
    &results.steps[step].edges[0]
}

#[test]
fn a_rounded_punch_is_that_of_the_closed_form() {
    let results = solved(PUNCH, &[]);
    let (force, end) = (73.8556, 1.2);
    let pressed = edge(&results, 0);
    close(pressed.contact_half_extent.unwrap(), end, 0.005);
    // Pushed by half of what friction holds, stick ends where the contact under the force that is left would end.
    let stick = edge(&results, 1).stick_half_extent.unwrap();
    close(stick, 1.127_905, 0.005);
    close(edge(&results, 1).resultant[0], -14.7711, 1e-6);
    close(edge(&results, 1).resultant[1], force, 1e-6);
    close(
        4.0 * force * 50.0 / (MODULUS * end * end),
        shape((1.0 / end).asin()),
        1e-4,
    );
}

#[test]
fn the_bodies_can_be_exchanged() {
    let swapped = [
        r#"contacts.0.first="block.top""#,
        r#"contacts.0.second="punch.face""#,
    ];
    let [own, other] = [solved(PUNCH, &[]), solved(PUNCH, &swapped)];
    for step in 0..3 {
        let [a, b] = [&own, &other].map(|results| edge(results, step));
        close(
            a.contact_half_extent.unwrap(),
            b.contact_half_extent.unwrap(),
            0.01,
        );
        close(a.peak_pressure.unwrap().0, b.peak_pressure.unwrap().0, 0.01);
        close(a.resultant[1], -b.resultant[1], 1e-6);
    }
}

/// Two bodies with `between` of the lower one's edges from (10, 0) to (0, 0), and of the upper one's back.
fn stacked(lower: &str, upper: &str) -> String {
    format!(
        r#"
version = 1
materials.metal.isotropic = {{ young = "70 GPa", poisson = 0.3 }}
[bodies.lower]
material = "metal"
thickness = "2 mm"
shape.outline = {{ start = ["0 mm", "-6 mm"], edges = [{{ name = "bottom", to = ["10 mm", "-6 mm"] }}, {{ name = "right", to = ["10 mm", "0 mm"] }}, {lower}, {{ name = "left" }}] }}
mesh.spacing = "1.1 mm"
[bodies.upper]
material = "metal"
thickness = "2 mm"
shape.outline = {{ start = ["0 mm", "6 mm"], edges = [{{ name = "left", to = ["0 mm", "0 mm"] }}, {upper}, {{ name = "right", to = ["10 mm", "6 mm"] }}, {{ name = "top" }}] }}
mesh.spacing = "1.7 mm"
[[contacts]]
first = "upper.face"
second = "lower.face"
friction.coulomb.mu = 0
[[supports]]
on = "lower.bottom"
fix = ["y"]
[[supports]]
on = "lower.left"
fix = ["x"]
[[supports]]
on = "upper.left"
fix = ["x"]
[[loads]]
on = "upper.top"
pressure.steps = ["5 MPa"]
[[loads]]
on = "upper.right"
pressure.steps = ["5 MPa"]
[[loads]]
on = "lower.right"
pressure.steps = ["5 MPa"]
"#
    )
}

/// Largest deviation of the pressures from 5 MPa, as a part of it.
fn uneven(text: &str) -> f64 {
    let results = solved(text, &[]);
    let rows = edge(&results, 0).rows.iter();
    assert!(rows.len() > 8);
    rows.map(|row| (row.pressure / 5.0 - 1.0).abs())
        .fold(0.0, f64::max)
}

#[test]
fn meshes_that_do_not_match_carry_uniform_pressure() {
    let straight = stacked(
        r#"{ name = "face", to = ["0 mm", "0 mm"] }"#,
        r#"{ name = "face", to = ["10 mm", "0 mm"] }"#,
    );
    assert!(uneven(&straight) < 1e-9, "{}", uneven(&straight));
    // Along an arc of radius 13 the error is that of the facets of quadratic cells.
    let round = stacked(
        r#"{ name = "face", to = ["0 mm", "0 mm"], through = ["5 mm", "1 mm"], refine = 2 }"#,
        r#"{ name = "face", to = ["10 mm", "0 mm"], through = ["5 mm", "1 mm"], refine = 2 }"#,
    );
    assert!(uneven(&round) < 2e-3, "{}", uneven(&round));
}

#[test]
fn edges_that_overlap_or_look_away_are_refused() {
    let refused = |overrides: &[&str]| {
        let built = Model::build(&scene(PUNCH, overrides)).map(|_| ());
        built.unwrap_err().to_string()
    };
    let lower = r#"bodies.block.shape.outline.edges.1.to=["41 mm", "0.1 mm"]"#;
    let raised: Vec<String> = (1..=4)
        .map(|k| {
            let x = ["", "41", "1.6", "-1.6", "-41"][k];
            format!(r#"bodies.block.shape.outline.edges.{k}.to=["{x} mm", "0.1 mm"]"#)
        })
        .collect();
    let raised: Vec<&str> = raised.iter().map(String::as_str).collect();
    assert_eq!(raised[0], lower);
    let message = refused(&raised);
    assert!(
        message.contains("overlap by 0.1 mm") && message.contains("interference = true"),
        "{message}"
    );
    let deep: Vec<String> = raised
        .iter()
        .map(|own| own.replace("0.1 mm", "5 mm"))
        .collect();
    let mut deep: Vec<&str> = deep.iter().map(String::as_str).collect();
    deep.push("contacts.0.interference=true");
    let message = refused(&deep);
    assert!(message.contains("overlap by 5 mm"), "{message}");
    assert!(message.contains("move one of the bodies"), "{message}");
    let message = refused(&[
        r#"contacts.0.second="block.bottom""#,
        "supports.0.on=block.left",
    ]);
    assert!(message.contains("do not face each other"), "{message}");
    let message = refused(&["analysis.kinematics=deformed-gaps"]);
    assert!(message.contains("deformed-gaps"), "{message}");
}

/// A round nose at the origin pressed on a block below it; `place` stands in both tables.
fn nose(place: &str) -> String {
    let block = r#"shape.outline = { start = ["-10 mm", "-8 mm"], edges = [{ name = "bottom", to = ["10 mm", "-8 mm"] }, { name = "right", to = ["10 mm", "0 mm"] }, { name = "face", to = ["-10 mm", "0 mm"], refine = 6 }, { name = "left" }] }"#;
    let nose = r#"shape.outline = { start = ["-4 mm", "6 mm"], edges = [{ name = "face", to = ["4 mm", "6 mm"], through = ["0 mm", "0 mm"], refine = 6 }, { name = "top" }] }"#;
    let force = r#"{ direction = [0, -1], steps = ["1 kN", "0.5 kN"] }"#;
    nose_on_block(place, [block, nose], force)
}

/// A nose pressed by `force` on a block, with the keys `shapes` of both; `place` stands in both tables.
pub(crate) fn nose_on_block(place: &str, [block, nose]: [&str; 2], force: &str) -> String {
    format!(
        r#"
version = 1
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.3
[bodies.block]
material = "metal"
thickness = "1 mm"
{place}
{block}
[bodies.nose]
material = "metal"
thickness = "1 mm"
{place}
{nose}
[mesh]
spacing = "1.5 mm"
[[contacts]]
first = "nose.face"
second = "block.face"
friction.coulomb.mu = 0.3
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "nose.top"
free = ["x", "y"]
[[loads]]
on = "nose.top"
force = {force}
"#
    )
}

#[test]
fn bodies_stand_and_are_turned_as_their_tables_say() {
    let still = solved(&nose(""), &[]);
    let far = solved(&nose(r#"position = ["64 mm", "-32 mm"]"#), &[]);
    let turned = solved(
        &nose(r#"angle = "90 deg""#),
        &["loads.0.force.direction=[1, 0]"],
    );
    for (other, tolerance) in [(&far, 1e-9), (&turned, 1e-9)] {
        for step in 0..2 {
            let [a, b] = [&still, other].map(|results| edge(results, step));
            close(
                b.peak_pressure.unwrap().0,
                a.peak_pressure.unwrap().0,
                tolerance,
            );
            close(
                b.contact_half_extent.unwrap(),
                a.contact_half_extent.unwrap(),
                tolerance,
            );
        }
    }
    close(edge(&turned, 0).resultant[0], -1000.0, 1e-9);
}

#[test]
fn a_rigid_punch_presses_as_a_stiff_one() {
    let text = nose("").replace(
        "[bodies.nose]\nmaterial = \"metal\"\nthickness = \"1 mm\"",
        "[bodies.nose]\nrigid = true",
    );
    let swapped = [
        r#"contacts.0.first="block.face""#,
        r#"contacts.0.second="nose.face""#,
        "platens=[]",
        r#"supports.1={ on = "nose.top", fix = ["x"] }"#,
    ];
    let rigid = solved(&text, &swapped);
    let stiff = solved(
        &nose("").replace("[bodies.nose]\nmaterial = \"metal\"", "[materials.stiff.isotropic]\nyoung = \"70000 GPa\"\npoisson = 0.3\n[bodies.nose]\nmaterial = \"stiff\""),
        &swapped[..2],
    );
    let [a, b] = [&rigid, &stiff].map(|results| edge(results, 0));
    close(a.peak_pressure.unwrap().0, b.peak_pressure.unwrap().0, 0.02);
    close(
        a.contact_half_extent.unwrap(),
        b.contact_half_extent.unwrap(),
        0.05,
    );
    close(a.resultant[1], -1000.0, 1e-9);
}

#[test]
fn bodies_that_start_apart_press_as_those_that_touch() {
    let exchanged = [
        r#"contacts.0.first="block.face""#,
        r#"contacts.0.second="nose.face""#,
    ];
    for changes in [&[][..], &exchanged] {
        let touching = solved(&nose(""), changes);
        for apart in ["0.3 mm", "3 mm"] {
            let away = format!(r#"bodies.nose.position=["0 mm", "{apart}"]"#);
            let changes: Vec<&str> = changes.iter().copied().chain([away.as_str()]).collect();
            let found = solved(&nose(""), &changes);
            let [a, b] = [&touching, &found].map(|results| edge(results, 0));
            close(b.peak_pressure.unwrap().0, a.peak_pressure.unwrap().0, 1e-5);
            close(
                b.contact_half_extent.unwrap(),
                a.contact_half_extent.unwrap(),
                1e-5,
            );
        }
    }
}

#[test]
fn without_friction_nothing_holds_a_body_along_a_flat() {
    for changes in [
        &["contacts.0.friction.coulomb.mu=0"][..],
        &[
            "contacts.0.friction.coulomb.mu=0",
            r#"contacts.0.first="block.face""#,
            r#"contacts.0.second="nose.face""#,
        ],
    ] {
        let pushed: Vec<&str> = changes
            .iter()
            .copied()
            .chain(["loads.0.force.direction=[0.01, -1]"])
            .collect();
        let scene = scene(&nose(""), &pushed);
        let refused = stickslip::run::run(&scene, &mut |_| {})
            .unwrap_err()
            .to_string();
        assert!(
            refused.contains("rigid motion") || refused.contains("balance"),
            "{refused}"
        );
    }
}

#[test]
fn a_second_edge_of_few_cells_is_reported() {
    let unresolved = |changes: &[&str]| {
        let results = solved(&nose(""), changes);
        let mut findings = results.findings.iter();
        findings.any(|own| {
            matches!(
                own,
                Finding::Contact {
                    finding: ContactFinding::Unresolved { .. },
                    ..
                }
            )
        })
    };
    let face = "bodies.block.shape.outline.edges.2.refine";
    assert!(!unresolved(&[&format!("{face}=12.0")]));
    assert!(unresolved(&[&format!("{face}=1.0")]));
}

/// Two noses of different loads on the face of one block, which has the names `left` and `right` for its halves.
fn two_noses([left, right]: [&str; 2], is_block_first: bool) -> Results {
    let block = format!(
        r#"{{ name = "{right}", to = ["0 mm", "0 mm"], refine = 6 }}, {{ name = "{left}", to = ["-10 mm", "0 mm"], refine = 6 }}"#
    );
    let text = nose("").replace(
        r#"{ name = "face", to = ["-10 mm", "0 mm"], refine = 6 }"#,
        &block,
    );
    let start = text.find("[bodies.nose]").unwrap();
    let (head, rest) = text.split_at(start);
    let (own, tail) = rest.split_at(rest.find("[mesh]").unwrap());
    let (mesh, tail) = tail.split_at(tail.find("[[contacts]]").unwrap());
    let (contact, tail) = tail.split_at(tail.find("[[supports]]").unwrap());
    let (support, nose) = tail.split_at(tail.find("[[platens]]").unwrap());
    let placed = |name: &str, x: &str, force: &str| {
        let at = format!("position = [\"{x} mm\", \"0 mm\"]\nshape.outline");
        let own = own
            .replace("shape.outline", &at)
            .replace("bodies.nose", &format!("bodies.{name}"));
        let nose = nose.replace("nose.", &format!("{name}."));
        (own, nose.replace("1 kN", force))
    };
    let [(one, push), (other, press)] =
        [placed("one", "-5", "0.6 kN"), placed("other", "5", "1 kN")];
    let touching = |name: &str, edge: &str| {
        let [first, second] = if is_block_first {
            ["second", "first"]
        } else {
            ["first", "second"]
        };
        let own = contact.replace("first = ", &format!("name = \"{name}\"\nFIRST = "));
        let own = own
            .replace("second = ", &format!("{second} = "))
            .replace("FIRST", first);
        own.replace("nose.face", &format!("{name}.face"))
            .replace("block.face", &format!("block.{edge}"))
    };
    let contacts = touching("one", left) + &touching("other", right);
    solved(
        &format!("{head}{one}{other}{mesh}{contacts}{support}{push}{press}"),
        &[],
    )
}

#[test]
fn an_edge_touches_several_others_as_its_parts_would() {
    for is_block_first in [false, true] {
        let whole = two_noses(["face", "face"], is_block_first);
        let split = two_noses(["left-face", "right-face"], is_block_first);
        let sign = if is_block_first { -1.0 } else { 1.0 };
        for step in 0..2 {
            for (index, force) in [[600.0, 500.0], [1000.0, 500.0]].iter().enumerate() {
                let [a, b] = [&whole, &split].map(|results| &results.steps[step].edges[index]);
                close(a.resultant[1], sign * force[step], 1e-6);
                close(a.peak_pressure.unwrap().0, b.peak_pressure.unwrap().0, 1e-9);
                close(
                    a.contact_half_extent.unwrap(),
                    b.contact_half_extent.unwrap(),
                    1e-9,
                );
            }
        }
    }
    let twice = nose("").replace("[[supports]]", "[[contacts]]\nname = \"again\"\nfirst = \"block.face\"\nsecond = \"nose.face\"\nfriction.coulomb.mu = 0\n[[supports]]");
    let refused = stickslip::scene::Scene::from_text(
        &twice,
        stickslip::scene::Format::Toml,
        "twice.toml",
        std::path::Path::new(""),
        &[] as &[&str],
    );
    let message = refused
        .err()
        .map(|error| error.to_string())
        .unwrap_or_default();
    assert!(
        message.contains("block.face and nose.face are in contact 'block' already"),
        "{message}"
    );
}

/// Of an open edge in contact only what faces the other one is reported.
#[test]
fn an_open_edge_in_contact_is_not_reported_again() {
    let scene = scene(PUNCH, &[r#"edges=[{ on = "punch.face" }]"#]);
    let first = scene.contacts[0].first.to_string();
    assert_eq!(first, scene.edges[0].to_string(), "the scene's own names");
    let refusal = Model::build(&scene).unwrap_err().to_string();
    assert!(refusal.contains("reports the part of"), "{refusal}");
}
