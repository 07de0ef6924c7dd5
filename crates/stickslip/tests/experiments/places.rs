//! Places of a table that cannot be right: inside of the hole, and two rows at one.

use std::fmt::Write as _;

use super::refusals::{check, field, says};
use serde_json::Value;

use super::{TABLE, close, folder_with, grid, succeeds};

/// The findings that are warnings.
fn warnings(experiment: &str, table: &str) -> Vec<Value> {
    let folder = folder_with(&[("e.toml", experiment), ("up.csv", table)]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let found = summary["findings"].as_array().unwrap().iter();
    found
        .filter(|own| own["level"] == "warning")
        .cloned()
        .collect()
}

/// A forgotten origin moves the places into the hole, and those masked there are reported.
#[test]
fn places_inside_of_the_hole_are_warned_of() {
    let table = grid("x,y,u,v", field);
    assert!(warnings(TABLE, &table).is_empty());
    let moved = TABLE.replace("y_axis = \"up\"", "y_axis = \"up\", origin = [-3, 0]");
    let found = warnings(&moved, &table);
    assert_eq!(found.len(), 1, "{found:?}");
    // The hole is at (−3, 0) of the table now.
    let mut inside = 0;
    let mut places = 0;
    let mut deepest = 0.0_f64;
    for i in -12..=12 {
        for j in -12..=12 {
            let (x, y) = (f64::from(i), f64::from(j));
            if x.hypot(y) > 5.0 {
                places += 1;
                let depth = 5.0 - (x + 3.0).hypot(y);
                inside += usize::from(depth > 0.25);
                deepest = deepest.max(depth);
            }
        }
    }
    let found = &found[0];
    assert_eq!(found["kind"], "inside_hole");
    assert!(found["file"].as_str().unwrap().ends_with("up.csv"));
    assert_eq!(
        (&found["count"], &found["places"]),
        (&inside.into(), &places.into())
    );
    assert!(close(&found["depth"], deepest), "{found}");
}

/// A stray place or two, or what the edge's own errors do, is no wrong origin.
#[test]
fn stray_places_inside_of_the_hole_are_not() {
    let mut table = grid("x,y,u,v", field);
    table += "4.9,0.0,0.0049,0\n0,0,0,0\n";
    assert!(warnings(TABLE, &table).is_empty());
    let mut rim = grid("x,y,u,v", field);
    for k in 0..60 {
        let (sin, cos) = f64::from(6 * k).to_radians().sin_cos();
        let [x, y] = [4.8 * cos, 4.8 * sin];
        let [u, v] = field(x, y);
        writeln!(rim, "{x},{y},{u:e},{v:e}").unwrap();
    }
    assert!(warnings(TABLE, &rim).is_empty());
}

/// The numbers are those that stand in the file, whatever scale, axis and origin make of them.
#[test]
fn two_rows_at_one_place_are_named_as_they_stand_in_the_table() {
    let pixels = TABLE
        .replace("scale = \"1 mm\"", "scale = \"0.05 mm\"")
        .replace(
            "y_axis = \"up\"",
            "y_axis = \"down\", origin = [602.5, 585]",
        );
    let table = "x,y,u,v\n300.5,200,0,0\n900,250,0,0\n300.5,200,1,1\n";
    check(
        &says(&pixels, table),
        &["lines 2 and 4 are both at (300.5, 200)", "keep one of them"],
    );
    let mudic = pixels.replace("\"up.csv\"", "\"up.csv\", preset = \"mudic\"");
    let table = "x,y,ux,uy\n300.5,200,0.5,0\n900,250,0,0\n301,200,1,0\n";
    check(
        &says(&mudic, table),
        &[
            "lines 2 and 4",
            "one place before the deformation",
            "(300.5, 200) and (301, 200)",
        ],
    );
}
