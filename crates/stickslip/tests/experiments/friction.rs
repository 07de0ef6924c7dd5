//! Friction from the sample table of `stickslip init experiment`, which was computed with a dynamic coefficient of 0.25.

use std::path::Path;

use super::{folder_with, succeeds};

#[test]
fn the_mesh_and_the_order_of_smoothing_do_not_decide_the_coefficient() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    for (order, cells) in [(2, "[30, 8]"), (2, "[60, 14]"), (3, "[80, 18]")] {
        let sector = format!(
            "region.sector={{ angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = {cells}, growth = 2.0 }}"
        );
        let smoothing = format!("region.smoothing={{ order = {order} }}");
        let arguments = [
            "identify",
            "mine.toml",
            "--force",
            "--set",
            &sector,
            "--set",
            &smoothing,
        ];
        let summary = succeeds(path, &arguments);
        let friction = &summary["friction"];
        let number = |name: &str| friction["mu_dynamic"][name].as_f64().unwrap();
        let [low, mu, high] = ["low", "best", "high"].map(number);
        println!("{cells}, order {order}: {low:.4} {mu:.4} {high:.4}");
        assert!(low < 0.25 && 0.25 < high, "{friction}");
        assert!((mu - 0.25).abs() < 0.02, "{friction}");
        let coarser = &friction["half_the_cells"];
        assert_eq!(coarser["cells"].as_array().unwrap().len(), 2, "{friction}");
        if let Some(coarse) = coarser["mu_dynamic"]["best"].as_f64() {
            assert!((coarse - mu).abs() < 0.5 * (high - low), "{friction}");
        }
    }
}

/// Noise that hides the pressure does not make an edge free.
#[test]
fn a_pressure_within_its_uncertainty_is_not_identifiable_rather_than_none() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let sector = "region.sector={ angles = [\"-10 deg\", \"110 deg\"], outer = \"13 mm\", cells = [40, 10], growth = 2.0 }";
    let arguments = [
        "identify",
        "mine.toml",
        "--set",
        sector,
        "--set",
        "states.0.table.deviation=20 um",
    ];
    let summary = succeeds(path, &arguments);
    let words = summary["friction"]["mu_static"]["in_words"].as_str();
    assert!(words.unwrap().starts_with("not identifiable"), "{summary}");
    let page = std::fs::read_to_string(path.join("mine-results/index.html")).unwrap();
    assert!(
        page.contains("no pressure on the edge exceeds its uncertainty"),
        "{page}"
    );
    assert!(!page.contains("no contact"), "{page}");
}

/// Turns the table of the sample `turned.toml` by a quarter.
pub(super) fn turn(folder: &Path) {
    let file = folder.join("turned.csv");
    let table = std::fs::read_to_string(&file).unwrap();
    let mut rows = table.lines();
    let mut turned = rows.next().unwrap().to_owned() + "\n";
    for row in rows {
        let [x, y, u, v] = [0, 1, 2, 3].map(|k| row.split(',').nth(k).unwrap());
        let minus = |text: &str| match text.strip_prefix('-') {
            Some(rest) => rest.to_owned(),
            None => format!("-{text}"),
        };
        turned += &[&minus(y), x, &minus(v), u].join(",");
        turned.push('\n');
    }
    std::fs::write(file, turned).unwrap();
}

/// The sample turned by a quarter, as of a test that pulls along y: the bearing point is found where all of the contact is in sight, and
/// stated where the region cuts it.
#[test]
fn a_turned_specimen_has_the_same_friction() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    succeeds(path, &["init", "experiment", "turned.toml"]);
    turn(path);
    let friction = |file: &str, angles: [i32; 2], further: &[&str]| {
        let [from, to] = angles;
        let sector = format!(
            "region.sector={{ angles = [\"{from} deg\", \"{to} deg\"], outer = \"13 mm\", cells = [40, 10], growth = 2.0 }}"
        );
        let mut arguments = vec!["identify", file, "--force", "--set", &sector];
        for set in further {
            arguments.extend(["--set", set]);
        }
        succeeds(path, &arguments)["friction"].clone()
    };
    let zones = |friction: &serde_json::Value| {
        let zones = friction["zones"].as_array().unwrap().iter();
        zones
            .map(|zone| zone["along_theta"].as_bool().unwrap())
            .collect::<Vec<_>>()
    };
    for (angles, stated) in [([-110, 110], None), ([-10, 110], Some("90 deg"))] {
        let own = friction("mine.toml", angles, &[]);
        let set = stated.map(|at| format!("identify.bearing={at}"));
        let further: Vec<&str> = set.iter().map(String::as_str).collect();
        let other = friction("turned.toml", angles.map(|at| at + 90), &further);
        // Held-out places and blocks of residuals lie along x and y, so smoothing and noise are not quite the same.
        let [a, b] = [&own, &other].map(|found| {
            ["low", "best", "high"].map(|key| found["mu_dynamic"][key].as_f64().unwrap())
        });
        println!("{a:.4?} {b:.4?}");
        assert!((a[1] - b[1]).abs() < 0.2 * (a[2] - a[0]), "{a:?} {b:?}");
        assert!(b[0] < 0.25 && 0.25 < b[2], "{b:?}");
        assert!(!zones(&own).is_empty());
        assert_eq!(zones(&own), zones(&other));
    }
}
