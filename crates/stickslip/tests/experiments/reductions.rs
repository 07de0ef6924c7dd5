//! Ways from data to displacements of a region's nodes, on the sample table of `stickslip init experiment`.

use serde_json::Value;
use tempfile::TempDir;

use super::{folder_with, stickslip, succeeds};

/// Off the hole, where triangles of data reach.
const OFF: &str = "region.sector={ angles = [\"-100 deg\", \"100 deg\"], outer = \"12.5 mm\", cells = [40, 6], stand_off = \"0.8 mm\" }";
const ON: &str = "region.sector={ angles = [\"-100 deg\", \"100 deg\"], outer = \"12.5 mm\", cells = [40, 8], growth = 2.0 }";

fn sample() -> TempDir {
    let folder = folder_with(&[]);
    succeeds(folder.path(), &["init", "experiment", "mine.toml"]);
    folder
}

fn hybrid(folder: &TempDir, sector: &str, method: &str) -> Value {
    let method = format!("reduce.method=\"{method}\"");
    let arguments = [
        "hybrid",
        "mine.toml",
        "--force",
        "--set",
        sector,
        "--set",
        &method,
    ];
    succeeds(folder.path(), &arguments)
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

/// Whatever the way, pressures agree within their standard deviations, the noise factor is that of the data, and an arc inside of the body
/// is taken for no free edge.
#[test]
fn all_ways_agree_off_the_hole() {
    let folder = sample();
    let fitted = hybrid(&folder, OFF, "fit")["edge_stresses"][0].clone();
    for method in ["fit", "linear", "polynomial"] {
        let found = hybrid(&folder, OFF, method);
        assert_eq!(found["warnings"].as_array().unwrap().len(), 0, "{found}");
        let own = &found["edge_stresses"][0];
        assert!(own["free_edge"].is_null(), "{method}: {own}");
        assert_eq!(own["noise_factor"], fitted["noise_factor"], "{method}");
        let [pressure, expected] = [own, &fitted].map(|one| &one["largest"]["pressure"]);
        let difference = number(&pressure["value"]) - number(&expected["value"]);
        let deviation = number(&pressure["deviation"]).hypot(number(&expected["deviation"]));
        println!("{method}: {difference:.1} ± {deviation:.1} MPa");
        // The largest of noisy values lies above that of smooth ones.
        assert!(difference.abs() < 4.0 * deviation, "{method}: {own}");
    }
}

/// Triangles do not reach into a concave edge: those that bridge it are gaps unless they are asked for.
#[test]
fn linear_interpolation_does_not_bridge_the_hole_by_default() {
    let folder = sample();
    let arguments = [
        "hybrid",
        "mine.toml",
        "--set",
        ON,
        "--set",
        "reduce.method=\"linear\"",
    ];
    let output = stickslip(folder.path(), &arguments);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success());
    for part in ["in a gap of the data", "stand-off", "state 'up'"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let mut reported = arguments.to_vec();
    reported.extend(["--set", "reduce.longest_side=\"100 mm\""]);
    succeeds(folder.path(), &reported);
}

#[test]
fn local_polynomials_reach_the_edge() {
    let folder = sample();
    let [fitted, local] = ["fit", "polynomial"]
        .map(|method| hybrid(&folder, ON, method)["edge_stresses"][0]["largest"]["hoop"].clone());
    let [expected, value] = [&fitted, &local].map(|hoop| number(&hoop["value"]));
    println!("largest hoop stress {value:.1} MPa, by the fit {expected:.1} MPa");
    assert!((value / expected - 1.0).abs() < 0.1, "{local}");
}
