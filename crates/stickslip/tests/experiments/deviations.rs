//! Standard deviations that are not stated: the page reports those in use.

use std::fs;

use super::{TABLE, close, fails, findings, folder_with, grid, succeeds};

const STATED: &str = ", deviation = \"1e-4 mm\"";
const REGION: &str = "[region]\nsector = { angles = [\"-90 deg\", \"90 deg\"], outer = \"9 mm\", cells = [12, 3] }\n";

/// A field without noise, in whole micrometres: neighbours agree better than their digits can say.
#[test]
fn of_rounded_data_the_deviation_of_rounding_is_reported() {
    let steps = |x: f64, y: f64| [(2.0 * x + y) / 1e3, -y / 1e3];
    let folder = folder_with(&[
        ("e.toml", &TABLE.replace(STATED, "")),
        ("up.csv", &grid("x,y,u,v", steps)),
    ]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let used = summary["measured"][0]["u"]["deviation"].as_f64().unwrap();
    assert!((used - 1e-3 / 12.0_f64.sqrt()).abs() < 1e-12, "{used}");
    assert_eq!(
        summary["warnings"].as_array().unwrap().len(),
        0,
        "{summary}"
    );
    let reported = findings(&summary, "deviation");
    assert_eq!(reported.len(), 2, "{reported:?}");
    for (found, field) in reported.iter().zip(["U", "V"]) {
        assert_eq!(
            (&found["field"], &found["by_digits"]),
            (&field.into(), &true.into())
        );
        assert!(close(&found["deviation"], used), "{found}");
    }
    let page = fs::read_to_string(folder.path().join("e-results/index.html")).unwrap();
    assert!(page.contains("deviation of U: 0.0002887 mm, by which its digits"));
}

/// A component that is zero everywhere has no standard deviation, and cannot be weighted.
#[test]
fn a_component_that_does_not_scatter_needs_a_stated_deviation() {
    let text = format!("{TABLE}{REGION}").replace(STATED, "");
    for zero in 0..2 {
        let table = grid("x,y,u,v", |x, y| {
            let mut u = [1e-3 * x + 1e-5 * (7.0 * x + 3.0 * y * x).sin(), -3e-4 * y];
            u[zero] = 0.0;
            u
        });
        let folder = folder_with(&[("e.toml", &text), ("up.csv", &table)]);
        let path = folder.path();
        let error = fails(path, &["hybrid", "e.toml"]);
        for part in [
            &format!("the {} data do not scatter at all", ["U", "V"][zero]),
            "e.toml:8",
            "deviation = \"0.5 um\"",
        ] {
            assert!(error.contains(part), "{part}: {error}");
        }
        let set = "states.0.table.deviation=0.01 um";
        succeeds(path, &["hybrid", "e.toml", "--set", set]);
        // Fields alone need none.
        fs::write(path.join("e.toml"), TABLE.replace(STATED, "")).unwrap();
        succeeds(path, &["reduce", "e.toml", "--output", "fields"]);
    }
}
