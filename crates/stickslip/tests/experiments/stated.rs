//! What is stated twice, and what is stated for nothing.

use serde_json::Value;

use super::refusals::check;
use super::{FRINGES, SCENE, TABLE, fails, folder_with, grid, succeeds};

/// What `stickslip check` warns of.
pub(super) fn warnings(checked: &Value) -> Vec<&str> {
    let lines = checked["checked"].as_array().unwrap().iter();
    let warnings = lines.filter(|line| line["what"] == "warning");
    warnings
        .map(|line| line["text"].as_str().unwrap())
        .collect()
}

#[test]
fn a_load_that_is_not_that_of_its_step_is_refused() {
    let state = "[[states]]\nname = \"up\"\nload = \"1 kN\"\ndirection = \"loading\"\nstep = 2\n";
    let experiment = format!("{FRINGES}{state}");
    let folder = folder_with(&[("e.toml", &experiment), ("scene.toml", SCENE)]);
    let with = |key: &str| ["check", "e.toml", "--set", key].map(String::from);
    let says = |key: &str| fails(folder.path(), &with(key).each_ref().map(String::as_str));
    succeeds(folder.path(), &["check", "e.toml"]);
    // The same load, rounded in another unit.
    for rounded in ["225 lbf", "224 lbf"] {
        let key = format!("states.0.load={rounded}");
        succeeds(folder.path(), &with(&key).each_ref().map(String::as_str));
    }
    check(
        &says("states.0.load=226 lbf"),
        &[
            "load is 226 lbf",
            "step 2 of the scene has 1000 N",
            "states.0.load",
            "remove load",
        ],
    );
    check(
        &says("states.0.step=1"),
        &[
            "load is 1 kN",
            "step 1 of the scene has 100 N",
            "e.toml:14",
            "name the step that has this load",
        ],
    );
    check(
        &says("states.0.direction=unloading"),
        &[
            "direction is unloading",
            "step 2",
            "scene is reached in loading",
            "states.0.direction",
            "remove direction",
        ],
    );
}

#[test]
fn ignored_keys_are_reported() {
    let keys = "[reduce]\norder = 3\nneighbours = 12\nreach = \"1 mm\"\nlongest_side = \"3 mm\"\nstride = 2\nband = 0.5\nsettled = 0.01\n\
                least_modulation = 0.1\ncommon_places = \"0.1 mm\"\noutliers = 9.0\n";
    let table = grid("x,y,u,v", |x, y| [1e-3 * x, -3e-4 * y]);
    let experiment = format!("{TABLE}{keys}");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &table)]);
    let checked = succeeds(folder.path(), &["check", "e.toml"]);
    let own = [
        "order",
        "neighbours",
        "reach",
        "longest_side",
        "common_places",
    ];
    let of_pictures = ["stride", "least_modulation", "band", "settled"];
    let reported = warnings(&checked);
    assert_eq!(
        reported.len(),
        own.len() + of_pictures.len(),
        "{reported:?}"
    );
    for key in own.iter().chain(&of_pictures) {
        let quoted = format!("'reduce.{key}' has no effect: ");
        assert!(
            reported.iter().any(|words| words.contains(&quoted)),
            "{key}: {reported:?}"
        );
    }
    check(
        reported[0],
        &[
            "e.toml:10: 'reduce.order'",
            "only reduce.method = \"polynomial\" uses it",
            "remove it",
        ],
    );
    // The page and the summary say so too.
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let all = summary["warnings"].as_array().unwrap();
    assert!(
        reported
            .iter()
            .all(|words| all.iter().any(|own| own == words))
    );
}

#[test]
fn what_waits_for_another_method_is_used_by_it() {
    let keys = "[reduce]\norder = 2\nlongest_side = \"3 mm\"\n[region]\nsmoothing = { order = 2 }\n\
                sector = { angles = [\"-60 deg\", \"60 deg\"], outer = \"10 mm\", cells = [8, 3] }\n";
    let table = grid("x,y,u,v", |x, y| [1e-3 * x, -3e-4 * y]);
    let experiment = format!("{TABLE}{keys}");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &table)]);
    let with = |method: &str| {
        let set = format!("reduce.method={method}");
        let checked = succeeds(folder.path(), &["check", "e.toml", "--set", &set]);
        let reported = warnings(&checked).into_iter();
        reported
            .map(|words| words.split('\'').nth(1).unwrap().to_owned())
            .collect::<Vec<String>>()
    };
    assert_eq!(with("polynomial"), ["reduce.longest_side"]);
    assert_eq!(with("linear"), ["reduce.order"]);
    assert_eq!(
        with("lines"),
        ["reduce.order", "reduce.longest_side", "region.smoothing"]
    );
}
