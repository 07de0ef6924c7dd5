//! What cannot be calculated and is assumed, or left out, with its reason.

use std::fmt::Write as _;
use std::fs;

use super::refusals::{check, field};
use super::{TABLE, fails, finding, folder_with, grid, succeeds};

/// Cells so small beside the data, 1 mm apart, that nothing but smoothing holds their nodes.
const FINE: &str = r#"[region]
sector = { angles = ["-60 deg", "60 deg"], outer = "10 mm", cells = [80, 6], stand_off = "1.5 mm" }
smoothing = { order = 2, amount = 0.0 }
"#;

#[test]
fn a_noise_factor_that_no_fit_gives_is_called_assumed() {
    let experiment = format!("{TABLE}[reduce]\nmethod = \"linear\"\n{FINE}");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &grid("x,y,u,v", field))]);
    let summary = succeeds(folder.path(), &["hybrid", "e.toml"]);
    let own = &summary["edge_stresses"][0];
    assert_eq!(own["noise_factor"], 1.0);
    check(
        own["noise_factor_assumed"].as_str().unwrap(),
        &[
            "the data do not determine",
            "the region's node at (",
            "mm), θ = ",
        ],
    );
    let assumed = finding(&summary, "noise_factor_assumed", "warning");
    assert_eq!(
        (&assumed["state"], &assumed["factor"]),
        (&"up".into(), &1.0.into())
    );
    assert_eq!(assumed["cause"], own["noise_factor_assumed"]);
    let page = fs::read_to_string(folder.path().join("e-results/index.html")).unwrap();
    assert!(page.contains("1.00, assumed"));
    // The fit itself is refused with the same place.
    let error = fails(
        folder.path(),
        &["hybrid", "e.toml", "--set", "reduce.method=fit", "--force"],
    );
    check(&error, &["the data do not determine", "mm), θ = "]);
}

#[test]
fn nodes_that_data_do_not_cover_are_named_with_unit_and_angle() {
    let region = "[region]\nsector = { angles = [\"-60 deg\", \"60 deg\"], outer = \"10 mm\", cells = [24, 4] }\n";
    let experiment = format!("{TABLE}[reduce]\nmethod = \"linear\"\n{region}");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &grid("x,y,u,v", field))]);
    let error = fails(folder.path(), &["hybrid", "e.toml"]);
    check(
        &error,
        &[
            "not covered by the data: U at (",
            " mm), θ = ",
            "in a gap of the data",
            "a side of",
        ],
    );
}

/// Seventeen places, where the polynomials of the comparison need 24; the one kept out to check the fit lies outside of the region.
#[test]
fn a_comparison_that_the_data_do_not_give_is_reported() {
    let mut table = "x,y,u,v\n".to_owned();
    for place in [4.0, 6.0, 8.0, 10.0].map(|x| [-6.0, -3.0, 0.0, 3.0, 6.0].map(|y| [x, y])) {
        for [x, y] in place {
            if f64::hypot(x, y) > 5.0 {
                let [u, v] = field(x, y);
                writeln!(table, "{x},{y},{u:e},{v:e}").unwrap();
            }
        }
    }
    let region = "[region]\nsector = { angles = [\"-25 deg\", \"25 deg\"], outer = \"9 mm\", cells = [4, 2], stand_off = \"1.5 mm\" }\n";
    let experiment = format!("{TABLE}[reduce]\noutliers = false\n{region}");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &table)]);
    let summary = succeeds(folder.path(), &["hybrid", "e.toml"]);
    let found = finding(&summary, "no_direct_stresses", "remark");
    check(
        found["cause"].as_str().unwrap(),
        &["U is valid at", "24 are needed around each node"],
    );
    let page = fs::read_to_string(folder.path().join("e-results/index.html")).unwrap();
    check(&page, &["no direct interpolation", "U is valid at"]);
}
