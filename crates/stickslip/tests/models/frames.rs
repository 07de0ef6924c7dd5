//! Places are measured from where a contact bears: turned and mirrored scenes have the numbers and sentences of the scene.

use std::f64::consts::TAU;
use std::fs;

use serde_json::{Map, Value};
use stickslip::folder::{Overwrite, ResultFolder};
use stickslip::keep;
use stickslip::output::{summary_json, summary_table};
use stickslip::results::{ContactFinding, Finding, Results};

use super::solved;

/// A rigid pin without clearance in a ring, pulled and then pushed sideways with friction: nothing in it has a direction but its
/// loads.
const RING: &str = r#"
version = 1
title = "Ring"
analysis.model = "whole"
[materials.metal.isotropic]
young = "70 GPa"
poisson = 0.33
[bodies.ring]
material = "metal"
thickness = "2 mm"
[bodies.ring.shape.plate_with_hole]
hole_radius = "10 mm"
outline.ring = { radius = "30 mm" }
[bodies.pin]
rigid = true
shape.disk = { radius = "10 mm" }
[mesh]
spacing = "7.5 deg"
[[contacts]]
name = "pin"
first = "ring.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "ring.outer"
fix = ["x", "y"]
[[loads]]
name = "pull"
on = "pin.rim"
force = { direction = [1, 0], steps = ["2 kN", "4 kN", "3.5 kN", "3.5 kN"] }
[[loads]]
name = "push"
on = "pin.rim"
force = { direction = [0, 1], steps = ["0 kN", "0 kN", "1.5 kN", "-0.5 kN"] }
[output]
fields = "none"
"#;

/// A pin that touches all around until it is pulled.
const PRESSED: [&str; 2] = [
    "bodies.pin.shape.disk.radius=10.005 mm",
    "contacts.0.interference=true",
];

/// A clearance of 2 % of the radius, so that gaps depend on where the pin starts.
const LOOSE: [&str; 1] = ["bodies.pin.shape.disk.radius=9.8 mm"];

/// A pin as soft as the ring; its mesh comes to itself again by quarter turns only.
const ELASTIC: [&str; 1] =
    ["bodies.pin={ material = \"metal\", thickness = \"2 mm\", shape.disk.radius = \"10 mm\" }"];

/// Keys that say how a scene was solved and not what it does.
const OF_THE_SOLUTION: [&str; 14] = [
    "other_solver",
    "finer_increments",
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

/// A turn about the origin `[rad]`, after a mirror on the x axis.
#[derive(Clone, Copy, Debug)]
struct Motion {
    turn: f64,
    mirror: bool,
}

impl Motion {
    fn of(self, [x, y]: [f64; 2]) -> [f64; 2] {
        let y = if self.mirror { -y } else { y };
        let (s, c) = self.turn.sin_cos();
        [c * x - s * y, s * x + c * y]
    }

    fn angle(self, angle: f64) -> f64 {
        let turned = if self.mirror { -angle } else { angle } + self.turn.to_degrees();
        (turned + 180.0).rem_euclid(360.0) - 180.0
    }
}

fn moved(changes: &[&str], motion: Motion) -> Results {
    let directions = [[1.0, 0.0], [0.0, 1.0]].map(|direction| motion.of(direction));
    let directions: Vec<String> = (directions.iter().enumerate())
        .map(|(k, [x, y])| format!("loads.{k}.force.direction=[{x:.15}, {y:.15}]"))
        .collect();
    let directions = directions.iter().map(String::as_str);
    let all: Vec<&str> = changes.iter().copied().chain(directions).collect();
    solved(RING, &all)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or(f64::NAN)
}

fn close(one: f64, other: f64, path: &str) {
    // Ends of zones between nodes follow from p², the difference of two solutions from their rounding; forces of some N and
    // angles of some degrees.
    let size = one.abs().max(other.abs()).max(1e-2);
    assert!((one - other).abs() <= 1e-6 * size, "{path}: {one} {other}");
}

fn ends(zone: &Value) -> [f64; 2] {
    ["start", "end"].map(|key| number(&zone[key]))
}

/// Whether `other` is the image of `one` by `motion`, all but the keys of the solution.
fn is_image(one: &Value, other: &Value, motion: Motion, path: &str) {
    match (one, other) {
        (Value::Object(one), Value::Object(other)) => {
            assert!(one.keys().eq(other.keys()), "{path}");
            for (key, value) in one {
                if !OF_THE_SOLUTION.contains(&key.as_str()) {
                    entry_is_image(key, value, other, motion, &format!("{path}.{key}"));
                }
            }
        }
        (Value::Array(one), Value::Array(other)) => {
            assert_eq!(one.len(), other.len(), "{path}: {one:?} {other:?}");
            for (k, (one, other)) in one.iter().zip(other).enumerate() {
                is_image(one, other, motion, &format!("{path}.{k}"));
            }
        }
        (Value::Number(_), Value::Number(_)) => close(number(one), number(other), path),
        (one, other) => assert_eq!(one, other, "{path}"),
    }
}

fn entry_is_image(
    key: &str,
    value: &Value,
    others: &Map<String, Value>,
    motion: Motion,
    path: &str,
) {
    let other = &others[key];
    match key {
        // Reactions are components along axes that do not turn.
        "sets" => {
            let loaded = |sets: &Value| {
                let sets = sets.as_array().unwrap().iter();
                let loaded = sets.filter(|set| set["kind"] != "held");
                Value::Array(loaded.cloned().collect())
            };
            is_image(&loaded(value), &loaded(other), motion, path);
        }
        "bearing_angle_deg" | "direction_deg" => {
            let apart = (motion.angle(number(value)) - number(other)).rem_euclid(360.0);
            close(100.0 + apart.min(360.0 - apart), 100.0, path);
        }
        "resultant" => {
            let part = |value: &Value| ["x", "y"].map(|key| number(&value[key]));
            let (image, found) = (motion.of(part(value)), part(other));
            close(image[0], found[0], path);
            close(image[1], found[1], path);
        }
        // Of equal peaks on both sides the positive one is reported, also in the mirror.
        "peak_pressure_angle_deg" | "peak_hoop_angle_deg" if motion.mirror => {
            close(number(value).abs(), number(other).abs(), path);
        }
        "contact_zones_deg" | "stick_zones_deg" | "slip_zones_deg" if motion.mirror => {
            let mut zones = value.as_array().unwrap().clone();
            for zone in &mut zones {
                let [start, end] = ends(zone);
                let turn = if -end < -180.0 - 1e-9 { 360.0 } else { 0.0 };
                let whole = end - start > 360.0 - 1e-6;
                let turn = if whole { 0.0 } else { turn };
                zone["start"] = (turn - end).into();
                zone["end"] = (turn - start).into();
            }
            zones.sort_by(|a, b| ends(a)[0].total_cmp(&ends(b)[0]));
            is_image(
                &Value::Array(zones),
                other,
                Motion {
                    mirror: false,
                    ..motion
                },
                path,
            );
        }
        _ => is_image(value, other, motion, path),
    }
}

/// The words of a text with # for each number, and the magnitudes of its numbers in order of size.
fn words(text: &str) -> (String, Vec<f64>) {
    let (mut words, mut numbers) = (String::new(), Vec::new());
    let letters: Vec<char> = text.chars().collect();
    let mut k = 0;
    while k < letters.len() {
        if !letters[k].is_ascii_digit() {
            words.push(letters[k]);
            k += 1;
            continue;
        }
        let start = k;
        let digit = |k: usize| letters.get(k).is_some_and(char::is_ascii_digit);
        while digit(k) {
            k += 1;
        }
        if letters.get(k) == Some(&'.') && digit(k + 1) {
            k += 1;
            while digit(k) {
                k += 1;
            }
        }
        if letters.get(k) == Some(&'e') && letters.get(k + 1) == Some(&'-') && digit(k + 2) {
            k += 2;
            while digit(k) {
                k += 1;
            }
        }
        let number: String = letters[start..k].iter().collect();
        numbers.push(number.parse().unwrap());
        if words.ends_with(['−', '-']) {
            words.pop();
        }
        words.push('#');
    }
    numbers.sort_by(f64::total_cmp);
    (words, numbers)
}

/// The text of a page without figures and tags, and its captions.
fn page(results: &Results) -> (String, Vec<String>) {
    let place = tempfile::tempdir().unwrap();
    let folder = ResultFolder::create(&place.path().join("run"), Overwrite::Refuse).unwrap();
    let folder = keep::results(results, folder, true).unwrap();
    let page = fs::read_to_string(folder.join("report.html")).unwrap();
    let page = without(&without(&page, "<style", "</style>"), "<svg", "</svg>");
    let captions = page.split("<figcaption").skip(1);
    let captions = captions.map(|rest| rest.split("</figcaption>").next().unwrap());
    let captions = captions.map(|caption| reported(&format!("<figcaption{caption}")));
    (reported(&page), captions.collect())
}

fn without(text: &str, start: &str, end: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some((before, after)) = rest.split_once(start) {
        kept += before;
        rest = after.split_once(end).map_or("", |(_, after)| after);
    }
    kept + rest
}

/// Text between tags, without where the bearing point lies from +x and without the scene's hash.
fn reported(text: &str) -> String {
    // Cells of tables stand apart.
    let text = without(&text.replace('<', " <"), "<", ">");
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let text = text.split("· scene").next().unwrap();
    text.split("θ = ")
        .enumerate()
        .map(|(k, part)| {
            if k == 0 {
                part
            } else {
                part.split_once('°').map_or("", |(_, rest)| rest)
            }
        })
        .collect()
}

fn assert_equal_captions(one: &Results, other: &Results, what: &str) {
    let ((text, captions), (other_text, other_captions)) = (page(one), page(other));
    assert_eq!(words(&text).0, words(&other_text).0, "{what}");
    assert_eq!(captions.len(), other_captions.len());
    assert!(captions.len() > 5, "{captions:?}");
    for (one, other) in captions.iter().zip(&other_captions) {
        let (numbers, others) = (words(one).1, words(other).1);
        for (a, b) in numbers.iter().zip(&others) {
            // Four digits are shown.
            assert!(
                (a - b).abs() <= 2e-3 * a.abs().max(0.1),
                "{what}: {one} {other}"
            );
        }
    }
    let table = |results: &Results| words(&summary_table(results, 400).unwrap()).0;
    let row = |text: String| {
        text.replace('─', "")
            .split_whitespace()
            .collect::<Vec<_>>()
            .join(" ")
    };
    assert_eq!(row(table(one)), row(table(other)), "{what}");
}

fn compare(changes: &[&str], motions: &[Motion]) {
    let still = Motion {
        turn: 0.0,
        mirror: false,
    };
    let own = moved(changes, still);
    let summary = summary_json(&own).unwrap();
    for &motion in motions {
        let image = moved(changes, motion);
        let what = format!("{changes:?} {motion:?}");
        let other = summary_json(&image).unwrap();
        for part in ["edges", "steps"] {
            is_image(
                &summary[part],
                &other[part],
                motion,
                &format!("{what} {part}"),
            );
        }
        assert_equal_captions(&own, &image, &what);
    }
}

#[test]
fn turned_and_mirrored_scenes_have_the_same_numbers_and_sentences() {
    let motion = |degrees: f64, mirror| Motion {
        turn: degrees / 360.0 * TAU,
        mirror,
    };
    compare(
        &[],
        &[motion(30.0, false), motion(90.0, false), motion(0.0, true)],
    );
    compare(&LOOSE, &[motion(30.0, false), motion(-75.0, true)]);
    compare(&PRESSED, &[motion(-127.5, false), motion(52.5, true)]);
    compare(&ELASTIC, &[motion(-90.0, false), motion(180.0, true)]);
}

/// Half of a symmetric scene that bears at 180° reads as its mirror image does.
#[test]
fn a_half_that_bears_behind_reads_as_its_mirror_image() {
    let pulls = [
        "analysis.model=half",
        "loads.1.force.direction=[1, 0]",
        "loads.1.force.steps=[\"0 kN\", \"0 kN\", \"0 kN\", \"0 kN\"]",
    ];
    let motion = Motion {
        turn: 0.5 * TAU,
        mirror: true,
    };
    let ahead = solved(RING, &pulls);
    let behind = solved(
        RING,
        &[
            &pulls[..],
            &[
                "loads.0.force.direction=[-1, 0]",
                "loads.1.force.direction=[-1, 0]",
            ],
        ]
        .concat(),
    );
    assert!(ahead.edges[0].half && behind.edges[0].half);
    let [one, other] = [&ahead, &behind].map(|results| summary_json(results).unwrap());
    for part in ["edges", "steps"] {
        is_image(&one[part], &other[part], motion, part);
    }
    assert_eq!(other["steps"][1]["bearing_angle_deg"], 180.0);
    assert!(number(&other["steps"][1]["stick_half_angle_deg"]) > 1.0);
    assert_equal_captions(&ahead, &behind, "half");
}

#[test]
fn a_load_along_y_is_measured_from_there() {
    let pulls = [
        "loads.0.force.direction=[0, 1]",
        "loads.1.force.direction=[-1, 0]",
    ];
    let results = solved(RING, &pulls);
    let summary = summary_json(&results).unwrap();
    let step = &summary["steps"][1];
    assert_eq!(summary["edges"][0]["bearing_angle_deg"], 90.0);
    let [start, end] = ends(&step["contact_zones_deg"][0]);
    assert!((start + end).abs() < 1e-5 && end > 60.0, "{start} {end}");
    close(number(&step["contact_half_angle_deg"]), end, "half-angle");
    assert!(number(&step["stick_half_angle_deg"]) > 1.0);
    // Under a rising load friction pulls the ring's edge towards the bearing point.
    let ratio = number(&step["friction_force"]["value"]) / number(&step["normal_force"]["value"]);
    assert!(ratio > 0.02, "{ratio}");
    for zone in step["slip_zones_deg"].as_array().unwrap() {
        assert_eq!(zone["direction"], "away", "{zone}");
    }
    // The sideways force turns the bearing point, which is reported.
    let wanders = |finding: &Finding| match finding {
        Finding::Contact { contact, finding } => {
            contact == "pin" && matches!(finding, ContactFinding::BearingPointWanders { .. })
        }
        _ => false,
    };
    assert!(
        results.findings.iter().any(wanders),
        "{:?}",
        results.findings
    );
}

/// A cylinder that is pressed on a stiffer block and pushed along it.
const LINE: &str = r#"
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
material = "stiff"
thickness = "1 mm"
shape.block = { half_length = "10 mm", depth = "10 mm" }
[bodies.roller]
material = "soft"
thickness = "1 mm"
shape.cylinder = { radius = "50 mm", half_length = "10 mm", depth = "10 mm" }
[mesh]
spacing = "0.2 mm"
fine_to = "1.6 mm"
[[contacts]]
name = "roller"
first = "roller.contact"
second = "block.contact"
friction.coulomb = { mu = 0.3 }
[[supports]]
on = "block.bottom"
fix = ["x", "y"]
[[platens]]
on = "roller.top"
free = ["x", "y"]
[[loads]]
name = "press"
on = "roller.top"
force = { direction = [0, -1], steps = ["300 N", "600 N", "600 N"] }
[[loads]]
name = "push"
on = "roller.top"
force = { direction = [1, 0], steps = ["0 N", "60 N", "-30 N"] }
[output]
fields = "none"
figures = false
"#;

#[test]
fn a_mirrored_line_contact_has_the_mirrored_numbers() {
    let [one, other] = ["[1, 0]", "[-1, 0]"].map(|way| {
        summary_json(&solved(LINE, &[&format!("loads.1.force.direction={way}")])).unwrap()
    });
    for step in 0..3 {
        let [one, other] = [&one, &other].map(|summary| &summary["steps"][step]);
        let value = |step: &Value, key: &str| number(&step[key]["value"]);
        for key in [
            "contact_half_width",
            "stick_half_width",
            "peak_pressure",
            "normal_force",
        ] {
            close(value(one, key), value(other, key), key);
        }
        for key in ["bearing_position", "friction_force"] {
            close(value(one, key), -value(other, key), key);
        }
        for key in ["contact_zones", "stick_zones", "slip_zones"] {
            let [zones, mut images] =
                [one, other].map(|step| step[key].as_array().unwrap().clone());
            images.reverse();
            assert_eq!(zones.len(), images.len(), "{key} {step}");
            for (zone, image) in zones.iter().zip(&images) {
                let ([start, end], [image_start, image_end]) = (ends(zone), ends(image));
                close(start, -image_end, key);
                close(end, -image_start, key);
                // e_t keeps its direction, so the mirror turns the sign of slip.
                if key == "slip_zones" {
                    assert_ne!(zone["direction"], image["direction"], "{step}");
                }
            }
        }
    }
    // Pushed aside, the middle of what sticks and the centre of pressure leave x = 0, and one lies around the other.
    let pushed = &one["steps"][1];
    let [start, end] = ends(&pushed["stick_zones"][0]);
    let at = number(&pushed["bearing_position"]["value"]);
    assert!(
        start < at && at < end && (start + end).abs() > 1e-3,
        "{start} {at} {end}"
    );
    close(
        number(&pushed["stick_half_width"]["value"]),
        0.5 * (end - start),
        "stick",
    );
}
