//! Tables as other tools write them, data given twice, results over data, and templates in the format that their file asks for.

use std::fs;

use serde_json::json;

use super::{TABLE, fails, findings, folder_with, grid, stickslip, succeeds};

fn linear(x: f64, y: f64) -> [f64; 2] {
    [1e-3 * x + 2e-4 * y, 2e-4 * x - 3e-4 * y]
}

/// The table of a spreadsheet of another country, with units.
fn spreadsheet(units: &str) -> String {
    let text = grid("x,y,u,v", linear);
    let (header, rows) = text.split_once('\n').unwrap();
    let rows = rows.replace(',', ";").replace('.', ",");
    format!("{};\n{units}\n{rows}", header.replace(',', ";"))
}

#[test]
fn decimal_commas_and_units_are_read_and_units_are_compared_with_the_scale() {
    let folder = folder_with(&[
        ("e.toml", TABLE),
        ("up.csv", &spreadsheet("[mm];[mm];[mm];[mm]")),
    ]);
    let path = folder.path();
    let summary = succeeds(path, &["reduce", "e.toml"]);
    for row in super::numbers(&path.join("e-results/measured-up.csv")) {
        let [u, v] = linear(row[0], row[1]);
        assert!(
            (row[2] - u).abs() < 1e-12 && (row[3] - v).abs() < 1e-12,
            "{row:?}"
        );
    }
    assert_eq!(
        summary["warnings"].as_array().unwrap().len(),
        0,
        "{summary}"
    );
    fs::write(path.join("up.csv"), spreadsheet("[mm];[mm];[um];[um]")).unwrap();
    let error = fails(path, &["check", "e.toml"]);
    for part in [
        "line 2",
        "column 'u' is in um",
        "displacement_scale = \"1 um\"",
        "e.toml:8",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    // The remedy helps.
    let stated = TABLE.replace("y_axis", "displacement_scale = \"1 um\", y_axis");
    fs::write(path.join("e.toml"), stated).unwrap();
    succeeds(path, &["check", "e.toml"]);
    fs::write(path.join("up.csv"), spreadsheet("px;px;um;um")).unwrap();
    succeeds(path, &["check", "e.toml"]);
    let summary = succeeds(path, &["reduce", "e.toml", "--force"]);
    let passed_over = findings(&summary, "unit_not_compared");
    for (found, column) in passed_over.iter().zip(["x", "y"]) {
        let reported = ["level", "line", "unit", "key"].map(|key| &found[key]);
        let expected = [json!("remark"), json!(2), json!("px"), json!("scale")];
        assert_eq!(reported, expected.each_ref(), "{found}");
        assert_eq!(found["column"], *column);
    }
    assert_eq!(passed_over.len(), 2, "{summary}");
}

#[test]
fn two_states_with_the_same_data_are_reported() {
    let second = "[[states]]\nname = \"again\"\ntable = { file = \"copy.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    let table = grid("x,y,u,v", linear);
    let folder = folder_with(&[
        ("e.toml", &format!("{TABLE}{second}")),
        ("up.csv", &table),
        ("copy.csv", &table),
    ]);
    let path = folder.path();
    for command in ["reduce", "check"] {
        let text = succeeds(path, &[command, "e.toml"]).to_string();
        assert!(
            text.contains("States 'up', 'again' have the same data"),
            "{text}"
        );
    }
    fs::write(
        path.join("copy.csv"),
        grid("x,y,u,v", |x, y| linear(x, y).map(|u| 2.0 * u)),
    )
    .unwrap();
    let text = succeeds(path, &["reduce", "e.toml", "--force"]).to_string();
    assert!(!text.contains("same data"), "{text}");
    // A state that is its own null field leaves nothing.
    let null = "null.table = { file = \"up.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    fs::write(path.join("e.toml"), format!("{TABLE}{null}")).unwrap();
    let error = fails(path, &["check", "e.toml"]);
    assert!(
        error.contains("null field has the data of the state itself"),
        "{error}"
    );
}

#[test]
fn results_are_not_written_over_the_experiment_or_its_data() {
    let folder = folder_with(&[]);
    let path = folder.path();
    fs::create_dir(path.join("data")).unwrap();
    let elsewhere = TABLE.replace("up.csv", "data/up.csv");
    fs::write(path.join("e.toml"), &elsewhere).unwrap();
    fs::write(path.join("data/up.csv"), grid("x,y,u,v", linear)).unwrap();
    // As a folder of results would have one.
    fs::write(path.join("data/summary.json"), "{}").unwrap();
    fs::write(path.join("summary.json"), "{}").unwrap();
    for folder in ["data", "."] {
        let error = fails(path, &["reduce", "e.toml", "--force", "--output", folder]);
        assert!(
            error.contains("which the experiment reads") && error.contains("--output"),
            "{error}"
        );
        assert!(path.join("data/up.csv").exists() && path.join("e.toml").exists());
    }
    // Beside the data and inside of their folder there is room.
    for folder in ["data/results", "beside"] {
        succeeds(path, &["reduce", "e.toml", "--output", folder]);
        assert!(path.join(folder).join("measured-up.csv").exists());
    }
    // Results that an experiment reads are not its own to replace.
    let again = TABLE
        .replace("up.csv", "e-results/measured-up.csv")
        .replace(
            "scale",
            "columns = { x = \"x [mm]\", y = \"y [mm]\", u = \"u [mm]\", v = \"v [mm]\" }, scale",
        );
    succeeds(path, &["reduce", "e.toml", "--output", "e-results"]);
    fs::write(path.join("e.toml"), again).unwrap();
    let error = fails(path, &["reduce", "e.toml", "--force"]);
    assert!(error.contains("measured-up.csv"), "{error}");
    succeeds(path, &["reduce", "e.toml", "--output", "again"]);
}

#[test]
fn templates_are_written_in_the_format_of_their_file() {
    let folder = folder_with(&[]);
    let path = folder.path();
    for template in [
        "pin-loaded-plate",
        "pin-infinite-plate",
        "laminate-joint",
        "hertz",
        "open-hole",
        "experiment",
    ] {
        let [toml, json] = ["toml", "json"].map(|end| format!("{template}-own.{end}"));
        succeeds(path, &["init", template, &toml]);
        if matches!(template, "pin-infinite-plate" | "experiment") {
            fs::remove_file(path.join(format!("{template}-own.csv"))).unwrap();
        }
        succeeds(path, &["init", template, &json]);
        for file in [&toml, &json] {
            let output = stickslip(path, &["check", file]);
            let error = String::from_utf8_lossy(&output.stderr);
            assert!(output.status.success(), "{file}: {error}");
        }
    }
    for file in ["x.png", "x.csv", "x.txt"] {
        let error = fails(path, &["init", "hertz", file]);
        assert!(
            error.contains("TOML or JSON") && error.contains("init hertz x.toml"),
            "{error}"
        );
        assert!(!path.join(file).exists());
    }
    succeeds(path, &["init", "hertz", "x.toml"]);
}
