//! Forces that hold a region, on the sample table of `stickslip init experiment`.

use std::fs;
use std::path::Path;

use serde_json::Value;
use tempfile::TempDir;

use super::{finding, findings, folder_with, stickslip, succeeds};

const SECTOR: &str = "region.sector={ angles = [\"0 deg\", \"110 deg\"], outer = \"13 mm\", cells = [30, 8], growth = 2.0 }";
/// All of the contact: the whole load goes through the edge.
const WHOLE: &str = "region.sector={ angles = [\"-110 deg\", \"110 deg\"], outer = \"12 mm\", cells = [50, 8], growth = 2.0 }";
const INSIDE: &str = "region.interior=[{ centre = [\"4 mm\", \"11 mm\"], radius = \"0.8 mm\" }]";

fn sample() -> TempDir {
    let folder = folder_with(&[]);
    succeeds(folder.path(), &["init", "experiment", "mine.toml"]);
    folder
}

fn hybrid(path: &Path, settings: &[&str]) -> Value {
    let mut arguments = vec!["hybrid", "mine.toml", "--force", "--set", SECTOR];
    for setting in settings {
        arguments.extend(["--set", setting]);
    }
    succeeds(path, &arguments)
}

#[test]
fn stresses_on_the_edge_carry_the_known_force_unless_the_material_is_wrong() {
    let folder = sample();
    let path = folder.path();
    let both = "states.0.edge_force={ x = \"5516 N\", y = \"0 N\" }";
    let half = "states.0.edge_force={ x = \"2758 N\" }";
    for (sector, known, components) in [(WHOLE, both, 2), (SECTOR, half, 1)] {
        let found = hybrid(path, &[sector, known]);
        let force = &found["edge_stresses"][0]["force"];
        for axis in 0..components {
            let number = |name: &str| force[name][axis].as_f64().unwrap();
            let (excess, deviation) = (number("excess_over_known"), number("excess_deviation"));
            println!("excess {excess:.1} ± {deviation:.1} N");
            assert!(deviation > 0.0 && deviation < 50.0, "{force}");
            assert!(excess.abs() < 3.0 * deviation, "{force}");
        }
        let reported = force["excess_over_known"].as_array().unwrap();
        assert_eq!(
            reported.iter().filter_map(Value::as_f64).count(),
            components
        );
        assert_eq!(found["warnings"].as_array().unwrap().len(), 0, "{found}");
    }
    let softer = [
        half,
        "specimen.material.isotropic={ young = \"60 GPa\", poisson = 0.33 }",
    ];
    let found = hybrid(path, &softer);
    let fails = finding(&found, "edge_force_fails", "warning");
    let force = &found["edge_stresses"][0]["force"];
    assert_eq!(fails["axis"], "x");
    assert_eq!(fails["excess"], force["excess_over_known"][0]);
    assert_eq!(fails["explained"], force["excess_explained"][0]);
}

/// The region of one half of the contact ends where pressure is greatest and stresses are not trusted. The forces on its nodes show a modulus
/// that is a tenth off; where the nodes at the ends bear much of them, the check says that it is no evidence.
#[test]
fn a_region_that_cuts_the_contact_sees_a_wrong_modulus_or_says_that_it_cannot() {
    let folder = sample();
    let path = folder.path();
    let half = "states.0.edge_force={ x = \"2758 N\" }";
    let hybrid = |young: f64, sector: &str| {
        let material =
            format!("specimen.material.isotropic={{ young = \"{young} GPa\", poisson = 0.33 }}");
        let found = hybrid(path, &[sector, half, &material]);
        let force = found["edge_stresses"][0]["force"].clone();
        println!("{young} GPa, {sector}: {force}\n{}", found["warnings"]);
        (force, found)
    };
    for (young, is_seen) in [(71.7, false), (71.7 * 1.1, true), (71.7 / 1.1, true)] {
        let (force, found) = hybrid(young, SECTOR);
        assert_eq!(force["is_evidence"][0], true, "{force}");
        let fails = findings(&found, "edge_force_fails");
        assert_eq!(fails.len(), usize::from(is_seen), "{fails:?}");
    }
    let few =
        "region.sector={ angles = [\"0 deg\", \"110 deg\"], outer = \"13 mm\", cells = [2, 2] }";
    let (force, found) = hybrid(71.7 * 1.1, few);
    assert_eq!(force["is_evidence"][0], false, "{force}");
    let silent = finding(&found, "edge_force_is_no_evidence", "warning");
    assert_eq!(silent["explained"], force["excess_explained"][0]);
    assert!(silent["of_force"].as_f64().unwrap() >= 0.1, "{silent}");
}

/// Columns x, y, force x, its standard deviation, force y, its standard deviation, and whether the node lies inside.
fn forces(path: &Path) -> Vec<Vec<f64>> {
    let text = fs::read_to_string(path.join("mine-results/forces-up.csv")).unwrap();
    let rows = text.lines().skip(1);
    rows.map(|row| {
        row.split(',')
            .map(|number| number.parse().unwrap())
            .collect()
    })
    .collect()
}

#[test]
fn forces_that_hold_a_region_are_in_balance_and_those_on_nodes_inside_are_noise() {
    let folder = sample();
    let path = folder.path();
    for method in ["fit", "polynomial"] {
        let method = format!("reduce.method=\"{method}\"");
        let found = hybrid(path, &[INSIDE, &method, "region.sector.cells=[16, 4]"]);
        let rows = forces(path);
        let size: f64 = rows.iter().map(|row| row[2].hypot(row[4])).sum();
        let sum = |term: fn(&[f64]) -> f64| rows.iter().map(|row| term(row)).sum::<f64>().abs();
        assert!(sum(|row| row[2]) < 1e-9 * size, "along x");
        assert!(sum(|row| row[4]) < 1e-9 * size, "along y");
        let moment = sum(|row| row[0] * row[4] - row[1] * row[2]);
        assert!(moment < 1e-9 * 13.0 * size, "moment");
        let inside: Vec<&Vec<f64>> = rows.iter().filter(|row| row[6] > 0.0).collect();
        let off = |row: &&Vec<f64>| (row[0] - 4.0).hypot(row[1] - 11.0) < 0.8;
        assert!(!inside.is_empty() && inside.iter().all(off));
        let check = &found["edge_stresses"][0]["nodes_inside"];
        assert_eq!(check["count"].as_u64().unwrap() as usize, 2 * inside.len());
        let number = |name: &str| check[name].as_f64().unwrap();
        let excess = (number("value") - number("count")) / number("deviation");
        println!("{method}: χ² of the forces inside {excess:.1} deviations above its mean");
        assert!(excess < 4.0, "{check}");
    }
}

#[test]
fn areas_without_a_node_inside_are_refused() {
    let folder = sample();
    let nowhere = "region.interior=[{ centre = [\"4 mm\", \"30 mm\"], radius = \"0.8 mm\" }]";
    let arguments = ["hybrid", "mine.toml", "--set", SECTOR, "--set", nowhere];
    let output = stickslip(folder.path(), &arguments);
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(!output.status.success());
    for part in ["no node inside of the region", "region.interior", "larger"] {
        assert!(text.contains(part), "{part}: {text}");
    }
    assert!(!folder.path().join("mine-results").exists());
}
