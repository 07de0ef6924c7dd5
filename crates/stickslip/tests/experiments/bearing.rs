//! What the measured force says of the stated bearing point and load.

use std::path::Path;

use serde_json::Value;

use super::friction::turn;
use super::refusals::check;
use super::{fails, finding, findings, folder_with, succeeds};

/// Summary of `identify` with the region between `angles` in degrees and what is `set`.
fn summary(folder: &Path, file: &str, angles: [i32; 2], set: &[&str]) -> Value {
    let [from, to] = angles;
    let sector = format!(
        "region.sector={{ angles = [\"{from} deg\", \"{to} deg\"], outer = \"13 mm\", cells = [40, 10], growth = 2.0 }}"
    );
    let mut arguments = vec!["identify", file, "--force", "--set", &sector];
    for set in set {
        arguments.extend(["--set", set]);
    }
    succeeds(folder, &arguments)
}

/// The warning of a summary that has this kind.
fn warning(summary: &Value, kind: &str) -> Option<Value> {
    let found = findings(summary, kind);
    assert!(found.iter().all(|own| own["level"] == "warning"));
    found.first().map(|own| (*own).clone())
}

#[test]
fn a_bearing_point_that_the_force_contradicts_is_reported() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    succeeds(path, &["init", "experiment", "turned.toml"]);
    turn(path);
    let reported = |file: &str, angles: [i32; 2], bearing: Option<i32>| {
        let set = bearing.map(|at| format!("identify.bearing={at} deg"));
        let set: Vec<&str> = set.iter().map(String::as_str).collect();
        let summary = summary(path, file, angles, &set);
        let found = warning(&summary, "bearing_fails");
        let check = &summary["friction"]["bearing"][0];
        assert_eq!(
            check["doubtful"].as_bool(),
            Some(found.is_some()),
            "{summary}"
        );
        for key in ["direction_degrees", "deviation_degrees", "beyond_degrees"] {
            assert!(found.iter().all(|own| own[key] == check[key]), "{summary}");
        }
        found
    };
    // Half of the contact, and all of it.
    let [half, whole] = [[-10, 110], [-110, 110]];
    let turned = |angles: [i32; 2]| angles.map(|at| at + 90);
    for (file, angles, bearing) in [
        ("mine.toml", half, None),
        ("mine.toml", whole, Some(0)),
        ("turned.toml", turned(half), Some(90)),
        ("turned.toml", half, Some(90)),
        ("turned.toml", turned(whole), None),
        ("turned.toml", turned(whole), Some(-270)),
    ] {
        let found = reported(file, angles, bearing);
        assert!(found.is_none(), "{file} {angles:?} {bearing:?}: {found:?}");
    }
    for (file, angles, bearing) in [
        ("mine.toml", half, Some(90)),
        ("mine.toml", half, Some(180)),
        ("mine.toml", whole, Some(-30)),
        ("turned.toml", turned(half), None),
        ("turned.toml", half, None),
        ("turned.toml", turned(half), Some(-90)),
    ] {
        let found = reported(file, angles, bearing).expect("a warning");
        assert_eq!(found["stated"], bearing.is_some(), "{found}");
        assert_eq!(found["is_whole"], angles == whole, "{found}");
        let at = found["bearing_degrees"].as_f64().unwrap();
        assert!(
            (at - f64::from(bearing.unwrap_or(0))).abs() < 1e-9,
            "{found}"
        );
    }
    let found = reported("turned.toml", turned(whole), Some(0)).unwrap();
    let direction = found["direction_degrees"].as_f64().unwrap();
    assert_eq!(direction.round(), 90.0, "{found}");
    let summary = summary(
        path,
        "turned.toml",
        turned(whole),
        &["identify.bearing=0 deg"],
    );
    let words = summary["warnings"].to_string();
    let parts = [
        "State 'up': the force on the edge",
        "stated by identify.bearing",
        "bearing = \\\"90 deg\\\"",
    ];
    assert!(parts.iter().all(|part| words.contains(part)), "{words}");
    let arguments = ["check", "mine.toml", "--set", "identify.bearing=400 deg"];
    let refused = fails(path, &arguments);
    check(
        &refused,
        &["400 deg", "from -360 to 360 deg", "identify.bearing"],
    );
}

#[test]
fn a_force_of_another_size_than_the_load_is_reported() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let half = [-10, 110];
    let reported = |angles: [i32; 2], set: &[&str]| {
        let summary = summary(path, "mine.toml", angles, set);
        let ratio = &summary["edge_stresses"][0]["force"]["by_load"]["ratio"];
        (ratio.as_f64(), warning(&summary, "load_fails"))
    };
    // By symmetry half of the contact says what all of it does: 5516 N.
    for angles in [half, [-110, 110]] {
        let (ratio, found) = reported(angles, &[]);
        assert!(found.is_none(), "{found:?}");
        assert!((ratio.unwrap() - 1.0).abs() < 0.02, "{ratio:?}");
    }
    for (set, factor) in [
        ("specimen.thickness=1.524 in", 25.4),
        ("specimen.material.isotropic.young=71.7 MPa", 1e-3),
        ("states.0.load=5.516 N", 1e3),
        ("states.0.load=16548 N", 1.0 / 3.0),
        ("states.0.load=1839 N", 3.0),
        ("identify.bearing=30 deg", 0.65),
    ] {
        let (ratio, found) = reported(half, &[set]);
        let found = found.expect(set);
        let ratio = ratio.unwrap();
        assert!((ratio / factor - 1.0).abs() < 0.03, "{set}: {ratio}");
        let [force, load] = ["force", "load"].map(|key| found[key].as_f64().unwrap());
        assert!((force / load / ratio - 1.0).abs() < 1e-9, "{found}");
        assert!(found["bearing_degrees"].is_number() && found["above_null"] == false);
    }
    // Without a load nothing is compared, and a note says so and what would check it.
    let page = || std::fs::read_to_string(path.join("mine-results/index.html")).unwrap();
    let unchecked = summary(path, "mine.toml", half, &["states.0.load=0 N"]);
    let found = finding(&unchecked, "load_not_checked", "remark");
    assert_eq!(found["reason"], "zero_load");
    let text = page();
    assert!(
        text.contains("not checked, for the load is zero")
            && text.contains("is not that of its null field")
            && !text.contains("State load"),
        "{text}"
    );
    let file = path.join("mine.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replace("\nload = ", "\n# load = ")).unwrap();
    let unchecked = summary(path, "mine.toml", half, &["specimen.thickness=1.524 in"]);
    let found = finding(&unchecked, "load_not_checked", "remark");
    assert_eq!(found["reason"], "no_load");
    assert_eq!(warning(&unchecked, "load_fails"), None);
}

/// Displacements of the wrong sign pull at the edge, as no contact does.
#[test]
fn an_edge_in_tension_is_reported() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let reported = |set: &[&str]| {
        let summary = summary(path, "mine.toml", [-10, 110], set);
        warning(&summary, "pulled")
    };
    assert_eq!(reported(&[]), None);
    let found = reported(&["states.0.table.reversed=[true,true]"]).unwrap();
    assert!(found["tension"].as_f64().unwrap() > 0.0, "{found}");
    let theta = found["theta_degrees"].as_f64().unwrap();
    assert!((-10.0..110.0).contains(&theta), "{found}");
}
