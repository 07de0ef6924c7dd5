//! Fringe centres along lines: the tracks that are stated for single lines, and those that were forgotten.

use std::fmt::Write as _;

use serde_json::Value;
use tempfile::TempDir;

use super::refusals::{check, field};
use super::stated::warnings;
use super::{TABLE, fails, folder_with, grid, stickslip, succeeds};

const EXPERIMENT: &str = r#"version = 1
[specimen]
material.isotropic = { young = "70 GPa", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "5 mm" }
[grating]
frequency = "2000 1/mm"
[[states]]
name = "up"
lines = { u = "u.csv", v = "v.csv", scale = "0.1 mm", y_axis = "up" }
"#;

/// Centres in tenths of a millimetre: on half a circle of radius 70 around the hole, and on the x axis.
fn centres() -> String {
    let mut text = "line,x,y,order\n".to_owned();
    for k in 0..=12 {
        let (sine, cosine) = (f64::from(k) * 15.0_f64.to_radians()).sin_cos();
        writeln!(text, "ring,{},{},{k}", 70.0 * cosine, 70.0 * sine).unwrap();
    }
    for k in 0..=5 {
        writeln!(text, "axis,{},0,{k}", 60 + 5 * k).unwrap();
    }
    text
}

fn folder(u: &str) -> TempDir {
    folder_with(&[("e.toml", EXPERIMENT), ("u.csv", u), ("v.csv", &centres())])
}

fn checked(folder: &TempDir, keys: &[&str]) -> Value {
    let mut arguments = vec!["check", "e.toml"];
    for key in keys {
        arguments.extend(["--set", key]);
    }
    succeeds(folder.path(), &arguments)
}

const RING: &str = "states.0.lines.tracks.u.ring.circle={ centre = [\"0 mm\", \"0 mm\"] }";

#[test]
fn a_forgotten_track_is_reported_and_single_lines_have_their_own() {
    let folder = folder(&centres());
    let found = checked(&folder, &[]);
    let reported = warnings(&found);
    assert_eq!(reported.len(), 2, "{reported:?}");
    check(
        reported[0],
        &[
            "state 'up': 'u.csv', line ",
            // The mean of the 13 sines is 0.5843, and the ends are the farthest.
            "lies 4.09 mm off",
            "fringe line 'ring', and 11 of its 13",
            "half of 1.45 mm, their median spacing",
            "or tracks for single lines",
        ],
    );
    check(reported[1], &["'v.csv', line "]);
    let found = checked(&folder, &[RING]);
    let reported = warnings(&found);
    assert!(
        reported.len() == 1 && reported[0].contains("'v.csv'"),
        "{reported:?}"
    );
    let drawn = "states.0.lines.tracks.v.ring=drawn";
    assert!(warnings(&checked(&folder, &[RING, drawn])).is_empty());
    // Who states a tolerance says how far off centres may be.
    let tolerance = "states.0.lines.tolerance=7 mm";
    assert!(warnings(&checked(&folder, &[tolerance])).is_empty());
    let error = fails(
        folder.path(),
        &[
            "check",
            "e.toml",
            "--set",
            "states.0.lines.tracks.v.rnig=drawn",
        ],
    );
    check(
        &error,
        &[
            "v.csv: there is no line 'rnig'",
            "ring, axis",
            "states.0.lines.tracks.v",
        ],
    );
}

#[test]
fn centres_that_make_no_line_are_reported_by_the_numbers_of_their_rows() {
    let says = |text: &str| fails(folder(text).path(), &["check", "e.toml"]);
    check(
        &says(&format!("{}rest,80,80,1\n", centres())),
        &["u.csv: line 21: ", "'rest' has 1 fringe centre"],
    );
    check(
        &says(&format!("{}axis,60,0,9\n", centres())),
        &[
            "u.csv: lines 15 and 21: ",
            "'axis' has orders 0 and 9",
            "at one place along it, (60, 0)",
        ],
    );
}

#[test]
fn signs_that_were_assumed_are_reported() {
    let folder = folder(&centres());
    let signs = |keys: &[&str]| {
        let found = checked(&folder, keys);
        let lines = found["checked"].as_array().unwrap().clone();
        let own = lines.into_iter().find(|line| line["what"] == "signs");
        own.unwrap()["text"].as_str().unwrap().to_owned()
    };
    check(
        &signs(&[]),
        &[
            "tables points up;",
            "u and v count along its x and y",
            "neither is `reversed`",
        ],
    );
    check(
        &signs(&[
            "states.0.lines.reversed=[true, false]",
            "states.0.lines.y_axis=down",
        ]),
        &[
            "tables points down;",
            "u count against its x, as `reversed` says",
            "v along its y",
        ],
    );
}

#[test]
fn a_null_field_with_other_signs_is_reported() {
    let experiment = format!(
        "{TABLE}null.table = {{ file = \"up.csv\", scale = \"1 mm\", y_axis = \"up\", reversed = [true, true] }}\n"
    );
    let table = grid("x,y,u,v", field);
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &table)]);
    let output = stickslip(folder.path(), &["reduce", "e.toml"]);
    check(
        &String::from_utf8(output.stdout).unwrap(),
        &[
            "Signs of up: y of",
            "table points up; u and v count along its x and y",
            "as neither is `reversed`; the null field: y of",
            "table points up; u and v count against its x and y",
            "as both are `reversed`",
        ],
    );
}
