//! Cut-outs of outlines: beside holes, closed forms and finer meshes, and as edges under loads, on supports and in contact.

use std::f64::consts::{PI, TAU};

use stickslip::results::{EdgeResults, Results};

use super::solved;

const STRIP: &str = r#"start = ["-120 mm", "-20 mm"]
edges = [{ name = "bottom", to = ["120 mm", "-20 mm"] }, { name = "right", to = ["120 mm", "20 mm"] }, { name = "top", to = ["-120 mm", "20 mm"] }, { name = "left" }]"#;

/// A plate between the outline `keys` with cells of `spacing`, held at the edge `held`, under a pressure on the edge `loaded`, with the edges that are reported.
fn plate(
    keys: &str,
    spacing: &str,
    held: &str,
    (loaded, pressure): (&str, f64),
    reported: &[&str],
) -> String {
    let edges = reported
        .iter()
        .map(|on| format!("[[edges]]\non = \"plate.{on}\"\n"));
    format!(
        r#"
version = 1
analysis.model = "whole"
materials.metal.isotropic = {{ young = "70 GPa", poisson = 0.33 }}
[bodies.plate]
material = "metal"
thickness = "1 mm"
mesh.spacing = "{spacing}"
[bodies.plate.shape.outline]
{keys}
[[supports]]
on = "plate.{held}"
fix = ["x", "y"]
[[loads]]
on = "plate.{loaded}"
pressure.steps = ["{pressure} MPa"]
{}[output]
fields = "none"
figures = false
"#,
        edges.collect::<String>()
    )
}

/// The strip of 40 mm with something cut out of it, under 100 MPa of tension.
fn pulled(inside: &str, spacing: &str, reported: &[&str]) -> Results {
    let keys = format!("{STRIP}\n{inside}");
    solved(
        &plate(&keys, spacing, "left", ("right", -100.0), reported),
        &[],
    )
}

/// A loop of arcs with these names along a circle of radius 10 mm.
fn circle(names: &[&str], refine: f64) -> String {
    let count = names.len();
    let at = |turn: f64| {
        let (sin, cos) = (TAU * turn / count as f64).sin_cos();
        format!(r#"["{} mm", "{} mm"]"#, 10.0 * cos, 10.0 * sin)
    };
    let arc = |(k, name): (usize, &&str)| {
        let from = k as f64;
        let to = format!("to = {}, ", at(from + 1.0));
        let to = if k + 1 < count { to.as_str() } else { "" };
        let through = at(from + 0.5);
        format!(r#"{{ name = "{name}", {to}through = {through}, refine = {refine} }}"#)
    };
    let edges: Vec<String> = names.iter().enumerate().map(arc).collect();
    format!(
        "cutouts.round = {{ start = {}, edges = [{}] }}",
        at(0.0),
        edges.join(", ")
    )
}

fn edge(results: &Results, index: usize) -> &EdgeResults {
    &results.steps[0].edges[index]
}

/// The largest stress along a reported edge over the remote one.
fn concentration(results: &Results, index: usize) -> f64 {
    edge(results, index).peak_hoop.unwrap().0 / 100.0
}

fn close(found: f64, expected: f64, part: f64) {
    assert!(
        (found - expected).abs() <= part * expected.abs(),
        "{found} {expected}: {:.2e}",
        found / expected - 1.0
    );
}

/// Howland's problem of an infinitely long strip, solved to 6 digits.
#[test]
fn a_circle_of_arcs_concentrates_stresses_as_a_hole_does() {
    const HOWLAND: f64 = 4.347_60;
    let hole = r#"holes.round = { centre = ["0 mm", "0 mm"], radius = "10 mm" }"#;
    let hole = concentration(&pulled(hole, "1.5 deg", &["round"]), 0);
    close(hole, HOWLAND, 1e-3);
    for count in [2, 4] {
        let cut = pulled(&circle(&vec!["round"; count], 16.0), "4 mm", &["round"]);
        close(concentration(&cut, 0), hole, 1e-3);
        close(concentration(&cut, 0), HOWLAND, 1e-3);
    }
    // Arcs with names of their own stand over their lengths: the second of six from 60° to 120°, the fifth below it.
    let names = ["a", "b", "c", "d", "e", "f"];
    let cut = pulled(&circle(&names, 16.0), "4 mm", &["b", "e"]);
    for index in [0, 1] {
        close(concentration(&cut, index), HOWLAND, 1e-3);
        let (_, at) = edge(&cut, index).peak_hoop.unwrap();
        assert!(at.abs() < 0.3, "{at}");
    }
}

/// A slot across the strip with ends of radius 2 mm, 12 mm long.
fn slot(refine: f64) -> String {
    format!(
        r#"[bodies.plate.shape.outline.cutouts.slot]
start = ["2 mm", "-4 mm"]
edges = [
  {{ name = "ahead", to = ["2 mm", "4 mm"] }},
  {{ name = "upper", to = ["-2 mm", "4 mm"], through = ["0 mm", "6 mm"], refine = {refine} }},
  {{ name = "behind", to = ["-2 mm", "-4 mm"] }},
  {{ name = "lower", through = ["0 mm", "-6 mm"], refine = {refine} }},
]"#
    )
}

/// An ellipse of length 2a with ends of radius ρ across a tension has 1 + 2 √(a/ρ) in an infinite plate, a slot about as much. A crack of that length
/// raises stresses in a strip of width W by 1/√cos(π a/W).
#[test]
fn a_slot_concentrates_stresses_as_on_finer_meshes_and_about_as_an_ellipse() {
    let found = |refine| {
        let results = pulled(&slot(refine), "4 mm", &["upper", "lower"]);
        [0, 1].map(|index| concentration(&results, index))
    };
    // Cells of 15°, 7.5° and 2° along the ends.
    let [coarse, fine, [finest, other]] = [8.0, 16.0, 64.0].map(found);
    close(other, finest, 1e-3);
    for (own, tolerance) in [(coarse, 0.01), (fine, 1e-3)] {
        for end in own {
            close(end, finest, tolerance);
        }
    }
    let ellipse = (1.0 + 2.0 * 3.0_f64.sqrt()) / (PI * 6.0 / 40.0).cos().sqrt();
    close(finest, ellipse, 0.05);
}

/// A ring between circles of arcs, held outside and under pressure within: u = A (r − b²/r), σ_r = E/(1 − ν²) (u′ + ν u/r).
#[test]
fn pressure_in_a_cutout_is_that_of_lame() {
    let keys = format!(
        r#"start = ["30 mm", "0 mm"]
edges = [{{ name = "rim", to = ["-30 mm", "0 mm"], through = ["0 mm", "30 mm"] }}, {{ name = "rim", through = ["0 mm", "-30 mm"] }}]
{}"#,
        circle(&["round"; 3], 8.0)
    );
    let results = solved(
        &plate(&keys, "4 mm", "rim", ("round", 100.0), &["round"]),
        &[],
    );
    let (nu, inner, outer) = (0.33, 10.0_f64, 30.0_f64);
    let [along, across] = [1.0, -1.0].map(|sign| 1.0 + sign * (outer / inner).powi(2));
    let hoop = -100.0 * (across + nu * along) / (along + nu * across);
    for row in &edge(&results, 0).rows {
        close(row.sigma_normal, -100.0, 1e-9);
        close(row.sigma_tangential, hoop, 2e-3);
    }
}

/// What holds a window carries the load, on its four sides together.
#[test]
fn supports_in_a_window_take_the_load() {
    let window = r#"[bodies.plate.shape.outline.cutouts.window]
start = ["-10 mm", "-5 mm"]
edges = [{ name = "low", to = ["10 mm", "-5 mm"] }, { name = "low", to = ["10 mm", "5 mm"] }, { name = "high", to = ["-10 mm", "5 mm"] }, { name = "high" }]"#;
    let text = plate(
        &format!("{STRIP}\n{window}"),
        "8 mm",
        "low",
        ("right", -100.0),
        &["left"],
    );
    let results = solved(&text, &[]);
    let [_, Some(along), Some(across)] = &results.steps[0].sets[..] else {
        panic!("a load and two directions of a support");
    };
    close(along.force, -100.0 * 40.0, 1e-9);
    assert!(across.force.abs() < 1e-5, "{}", across.force);
    // Nothing is left of the tension behind what holds it.
    assert!(
        edge(&results, 0)
            .rows
            .iter()
            .all(|row| row.sigma_tangential.abs() < 1.0)
    );
}

/// Edges in any direction are reported over their lengths, with the normal into the body.
#[test]
fn uniform_tension_stands_on_edges_of_any_direction() {
    let text = plate(
        STRIP,
        "20 mm",
        "left",
        ("right", -100.0),
        &["left", "right", "top"],
    );
    let text = text.replace("poisson = 0.33", "poisson = 0");
    for turn in ["0 deg", "30 deg", "-75 deg", "180 deg"] {
        let results = solved(&text, &[&format!("bodies.plate.angle=\"{turn}\"")]);
        for (index, expected) in [[100.0, 0.0], [100.0, 0.0], [0.0, 100.0]]
            .iter()
            .enumerate()
        {
            for row in &edge(&results, index).rows {
                let found = [row.sigma_normal, row.sigma_tangential, row.tau];
                let wrong = [found[0] - expected[0], found[1] - expected[1], found[2]];
                assert!(
                    wrong.iter().all(|part| part.abs() < 1e-6),
                    "{turn} {index} {row:?}"
                );
            }
        }
    }
}

/// The strip with a hole of 10 mm, into whose right side 1 kN presses a rigid pin of 9.9 mm.
fn pressed(inside: &str, spacing: &str, [hole, pin]: [&str; 2]) -> Results {
    let [shape, rim] = match pin {
        "disk" => ["disk.radius = \"9.9 mm\"", "rim"],
        _ => [ROLLER, "face"],
    };
    let strip = plate(
        &format!("{STRIP}\n{inside}"),
        spacing,
        "left",
        ("right", 0.0),
        &[],
    );
    let pin = format!(
        r#"
[bodies.pin]
rigid = true
shape.{shape}
[[contacts]]
first = "plate.{hole}"
second = "pin.{rim}"
friction.coulomb.mu = 0
[[supports]]
on = "pin.{rim}"
fix = ["y"]
[[loads]]
on = "pin.{rim}"
force = {{ direction = [1, 0], steps = ["1 kN"] }}
"#
    );
    solved(&format!("{strip}{pin}"), &[])
}

/// A circle of radius 9.9 mm whose face spans 120° about +x.
const ROLLER: &str = r#"outline = { start = ["4.95 mm", "-8.573651497465942 mm"], edges = [{ name = "face", to = ["4.95 mm", "8.573651497465942 mm"], through = ["9.9 mm", "0 mm"] }, { name = "back", through = ["-9.9 mm", "0 mm"] }] }"#;

/// One problem as a pin in a hole, a pin in a circle of arcs, and a roller in a concave arc, with results over angles and over lengths.
#[test]
fn a_roller_in_a_concave_arc_is_a_pin_in_a_hole() {
    let hole = r#"holes.round = { centre = ["0 mm", "0 mm"], radius = "10 mm" }"#;
    let numbers = |results: &Results, radius: f64| {
        let edge = edge(results, 0);
        let extent = edge.contact_half_extent.unwrap() / radius;
        (edge.peak_pressure.unwrap().0, extent)
    };
    let pin = pressed(hole, "1.5 deg", ["round", "disk"]);
    let (pressure, extent) = numbers(&pin, 1.0);
    assert!(extent > 0.3 && extent < 0.9, "{extent}");
    let arcs = circle(&["round"; 3], 16.0);
    let arcs = numbers(&pressed(&arcs, "4 mm", ["round", "disk"]), 1.0);
    let concave = circle(&["face", "b", "c", "d", "e", "face"], 16.0);
    let concave = numbers(&pressed(&concave, "4 mm", ["face", "roller"]), 10.0);
    for (own, end) in [arcs, concave] {
        close(own, pressure, 0.01);
        close(end, extent, 0.01);
    }
}
