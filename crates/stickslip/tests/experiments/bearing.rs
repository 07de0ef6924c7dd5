//! What the measured force says of the stated bearing point and load.

use std::path::Path;

use serde_json::Value;

use super::friction::turn;
use super::refusals::check;
use super::{fails, folder_with, succeeds};

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

/// The warning of a summary that holds `words`.
fn warning<'a>(summary: &'a Value, words: &str) -> Option<&'a str> {
    let all = summary["warnings"].as_array().unwrap().iter();
    all.filter_map(Value::as_str)
        .find(|own| own.contains(words))
}

#[test]
fn a_bearing_point_that_the_force_contradicts_is_reported() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    succeeds(path, &["init", "experiment", "turned.toml"]);
    turn(path);
    let told = |file: &str, angles: [i32; 2], bearing: Option<i32>| {
        let set = bearing.map(|at| format!("identify.bearing={at} deg"));
        let set: Vec<&str> = set.iter().map(String::as_str).collect();
        let summary = summary(path, file, angles, &set);
        let words = warning(&summary, "the force on the edge in sight points to");
        let doubtful = summary["friction"]["bearing"][0]["doubtful"].as_bool();
        assert_eq!(doubtful, Some(words.is_some()), "{summary}");
        words.map(str::to_owned)
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
        let words = told(file, angles, bearing);
        assert!(words.is_none(), "{file} {angles:?} {bearing:?}: {words:?}");
    }
    for (file, angles, bearing) in [
        ("mine.toml", half, Some(90)),
        ("mine.toml", half, Some(180)),
        ("mine.toml", whole, Some(-30)),
        ("turned.toml", turned(half), None),
        ("turned.toml", half, None),
        ("turned.toml", turned(half), Some(-90)),
    ] {
        let words = told(file, angles, bearing).expect("a warning");
        let assumed = match bearing {
            Some(_) => "stated by identify.bearing",
            None => "identify.bearing is not stated",
        };
        assert!(words.contains(assumed), "{words}");
        assert!(words.contains("The region cuts the contact") == (angles != whole));
    }
    let words = told("turned.toml", turned(whole), Some(0)).unwrap();
    assert!(words.contains("bearing = \"90 deg\""), "{words}");
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
    let told = |angles: [i32; 2], set: &[&str]| {
        let summary = summary(path, "mine.toml", angles, set);
        let ratio = &summary["edge_stresses"][0]["force"]["by_load"]["ratio"];
        let words = warning(&summary, "times the stated load");
        (ratio.as_f64(), words.map(str::to_owned))
    };
    // By symmetry half of the contact says what all of it does: 5516 N.
    for angles in [half, [-110, 110]] {
        let (ratio, words) = told(angles, &[]);
        assert!(words.is_none(), "{words:?}");
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
        let (ratio, words) = told(half, &[set]);
        let words = words.expect(set);
        assert!(
            (ratio.unwrap() / factor - 1.0).abs() < 0.03,
            "{set}: {ratio:?}"
        );
        let keys = ["thickness", "moduli", "load", "displacement_scale"];
        assert!(keys.iter().all(|key| words.contains(key)), "{words}");
    }
    // Without a load nothing is compared, and a note says so and what would check it.
    let page = || std::fs::read_to_string(path.join("mine-results/index.html")).unwrap();
    told(half, &["states.0.load=0 N"]);
    let text = page();
    assert!(
        text.contains("not checked, for the load is zero")
            && text.contains("A state whose load is not that of its null field")
            && !text.contains("State load"),
        "{text}"
    );
    let file = path.join("mine.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, text.replace("\nload = ", "\n# load = ")).unwrap();
    let (ratio, words) = told(half, &["specimen.thickness=1.524 in"]);
    assert_eq!((ratio, words), (None, None));
    let text = page();
    assert!(
        text.contains("not checked, for no load is stated") && text.contains("State load, with"),
        "{text}"
    );
}

/// Displacements of the wrong sign pull at the edge, as no contact does.
#[test]
fn an_edge_in_tension_is_reported() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let told = |set: &[&str]| {
        let summary = summary(path, "mine.toml", [-10, 110], set);
        warning(&summary, "and no contact pulls").map(str::to_owned)
    };
    assert_eq!(told(&[]), None);
    let words = told(&["states.0.table.reversed=[true,true]"]).unwrap();
    assert!(words.contains("table.reversed"), "{words}");
}
