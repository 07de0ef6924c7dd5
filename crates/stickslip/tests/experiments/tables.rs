//! Measured fields from tables and fringe lines.

use std::fmt::Write as _;
use std::fs;

use serde_json::json;

use super::{TABLE, fails, finding, folder_with, grid, numbers, succeeds};

fn linear(x: f64, y: f64) -> [f64; 2] {
    [1e-3 * x + 2e-4 * y, 2e-4 * x - 3e-4 * y]
}

#[test]
fn a_table_of_ones_own_needs_other_column_names_only() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let first = succeeds(path, &["reduce", "mine.toml", "--output", "sample"]);
    assert!(
        first["measured"][0]["u"]["valid"].as_u64().unwrap() > 500,
        "{first}"
    );
    let table = fs::read_to_string(path.join("mine.csv")).unwrap();
    let renamed = table
        .replacen("X_mm,Y_mm,DX_um,DY_um", "east;north;ue;un", 1)
        .replace(',', ";");
    fs::write(path.join("mine.csv"), renamed).unwrap();
    let columns = "states.0.table.columns={ x = \"East\", y = \"north\", u = \"ue\", v = \"un\" }";
    let second = succeeds(
        path,
        &["reduce", "mine.toml", "--output", "own", "--set", columns],
    );
    assert_eq!(first["measured"], second["measured"]);
}

#[test]
fn scale_origin_and_axes_are_as_stated() {
    // Pixels of 0.05 mm, the hole's centre at (400, 300), rows downwards.
    let mut text = "COORDINATE_X,COORDINATE_Y,DISPLACEMENT_X,DISPLACEMENT_Y,SIGMA\n".to_owned();
    for (k, place) in [[600, 300], [400, 100], [600, 500], [200, 300]]
        .iter()
        .enumerate()
    {
        let sigma = if k == 3 { -1 } else { 0 };
        writeln!(text, "{},{},0.2,0.4,{sigma}", place[0], place[1]).unwrap();
    }
    let state = "table = { file = \"up.csv\", preset = \"dice\", scale = \"0.05 mm\", y_axis = \"down\", origin = [400, 300], deviation = \"1 um\" }";
    let experiment = TABLE.lines().take(7).collect::<Vec<_>>().join("\n") + "\n" + state;
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &text)]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(summary["measured"][0]["u"]["valid"], 3);
    let rows = numbers(&folder.path().join("e-results/measured-up.csv"));
    let expected = [[10.0, 0.0], [0.0, 10.0], [10.0, -10.0], [-10.0, 0.0]];
    for (k, (row, place)) in rows.iter().zip(expected).enumerate() {
        assert!(
            (row[0] - place[0]).abs() < 1e-12 && (row[1] - place[1]).abs() < 1e-12,
            "{row:?}"
        );
        if k < 3 {
            assert!(
                (row[2] - 0.01).abs() < 1e-15 && (row[3] + 0.02).abs() < 1e-15,
                "{row:?}"
            );
        } else {
            assert!(row[2].is_nan() && row[3].is_nan());
        }
    }
}

#[test]
fn displacements_in_another_unit_than_places_are_noticed() {
    let folder = folder_with(&[]);
    let path = folder.path();
    succeeds(path, &["init", "experiment", "mine.toml"]);
    let reduce = |output: &str| {
        succeeds(path, &["reduce", "mine.toml", "--output", output]);
        fs::read_to_string(path.join(output).join("index.html")).unwrap()
    };
    assert!(!reduce("right").contains("beyond small strains"));
    let text = fs::read_to_string(path.join("mine.toml")).unwrap();
    let forgotten: String = text
        .split_inclusive('\n')
        .filter(|line| !line.starts_with("displacement_scale"))
        .collect();
    assert!(forgotten.len() < text.len());
    fs::write(path.join("mine.toml"), forgotten).unwrap();
    assert!(reduce("wrong").contains("beyond small strains"));
}

/// The scatter of a smooth field is that of its errors: here an alternating one that is normal by construction of its quantiles.
#[test]
fn a_deviation_that_is_not_stated_is_estimated() {
    let quantiles = [-1.5, -0.9, -0.5, -0.25, 0.0, 0.25, 0.5, 0.9, 1.5];
    let error = |x: f64, y: f64| {
        let k = ((7.0 * x + 13.0 * y + 3.0 * x * y).rem_euclid(97.0) * 31.0).rem_euclid(9.0);
        1e-4 * quantiles[k as usize]
    };
    let table = grid("x,y,u,v", |x, y| {
        let [u, v] = linear(x, y);
        [u + error(x, y), v]
    });
    let experiment = TABLE.replace(", deviation = \"1e-4 mm\"", "");
    let folder = folder_with(&[("e.toml", &experiment), ("up.csv", &table)]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let deviation = summary["measured"][0]["u"]["deviation"].as_f64().unwrap();
    // The quantiles have the standard deviation 0.88e-4.
    assert!((0.6e-4..1.2e-4).contains(&deviation), "{deviation}");
    let none = summary["measured"][0]["v"]["deviation"].as_f64().unwrap();
    assert!(none < 1e-12, "{none}");
}

#[test]
fn the_initial_load_is_taken_off_and_masks_mask() {
    let up = grid("x,y,u,v", |x, y| linear(x, y).map(|u| 3.0 * u));
    let initial = grid("x,y,u,v", linear);
    let null = "null.table = { file = \"initial.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    let mask = "[reduce]\nmargin = \"1.5 mm\"\nmask = [{ window = [[\"8 mm\", \"-2 mm\"], [\"10 mm\", \"2 mm\"]] }]\n";
    let experiment = format!("{TABLE}{null}{mask}");
    let folder = folder_with(&[
        ("e.toml", &experiment),
        ("up.csv", &up),
        ("initial.csv", &initial),
    ]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let deviation = summary["measured"][0]["u"]["deviation"].as_f64().unwrap();
    assert!((deviation - 2e-8_f64.sqrt()).abs() < 1e-12, "{deviation}");
    for row in numbers(&folder.path().join("e-results/measured-up.csv")) {
        let [x, y] = [row[0], row[1]];
        let masked = x.hypot(y) < 6.5 || ((8.0..=10.0).contains(&x) && y.abs() <= 2.0);
        assert_eq!(row[2].is_nan(), masked, "{row:?}");
        if !masked {
            let [u, v] = linear(x, y);
            assert!((row[2] - 2.0 * u).abs() < 1e-12 && (row[3] - 2.0 * v).abs() < 1e-12);
        }
    }
}

#[test]
fn fringe_lines_are_measured_along_both_fields() {
    let lines = |k: f64| {
        let mut text = "line,x,y,order\n".to_owned();
        for (name, y) in [("a", 0.0), ("b", 2.0)] {
            for n in 0..6 {
                let x = 6.0 + f64::from(n);
                writeln!(text, "{name},{x},{y},{}", k * f64::from(n)).unwrap();
            }
        }
        text
    };
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    let experiment = format!(
        "{head}\nlines = {{ u = \"u.csv\", v = \"v.csv\", scale = \"1 mm\", y_axis = \"up\", tolerance = \"0.01 mm\" }}\n[grating]\nwavelength = \"0.5 um\"\nangle = \"30 deg\"\n"
    );
    let folder = folder_with(&[
        ("e.toml", &experiment),
        ("u.csv", &lines(1.0)),
        ("v.csv", &lines(-2.0)),
    ]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(summary["measured"][0]["u"]["valid"], 12);
    // 2 sin 30° / 0.5 µm = 2000 lines/mm, read to a quarter of a fringe.
    let deviation = summary["measured"][0]["v"]["deviation"].as_f64().unwrap();
    assert!(
        (deviation - 0.25 / 3.0_f64.sqrt() / 2000.0).abs() < 1e-12,
        "{deviation}"
    );
    let rows = numbers(&folder.path().join("e-results/measured-up.csv"));
    assert!(
        rows.iter()
            .any(|row| row[0] == 11.0 && (row[2] - 5.0 / 2000.0).abs() < 1e-12)
    );
    assert!(
        rows.iter()
            .any(|row| row[0] == 11.0 && (row[3] + 10.0 / 2000.0).abs() < 1e-12)
    );
}

/// A null field without V would leave no V at all, or all of the initial load in it.
#[test]
fn a_null_field_that_lacks_a_component_is_refused() {
    let null = "null.table = { file = \"initial.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    let folder = folder_with(&[
        ("e.toml", &format!("{TABLE}{null}")),
        ("up.csv", &grid("x,y,u,v", linear)),
        (
            "initial.csv",
            &grid("x,y,u,v", |x, y| [linear(x, y)[0], f64::NAN]),
        ),
    ]);
    let says = || fails(folder.path(), &["reduce", "e.toml"]);
    let error = says();
    for part in [
        "state 'up': the null field has no V",
        "initial.csv",
        "e.toml:9",
        "states.0.null",
        "leave V out",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    // A V that is nowhere near the state's.
    let right = grid("x,y,u,v", |x, y| {
        [linear(x, y)[0], if x > 6.0 { 0.0 } else { f64::NAN }]
    });
    let left = grid("x,y,u,v", |x, y| {
        [linear(x, y)[0], if x < 0.0 { 0.0 } else { f64::NAN }]
    });
    std::fs::write(folder.path().join("initial.csv"), right).unwrap();
    std::fs::write(folder.path().join("up.csv"), left).unwrap();
    let error = says();
    assert!(error.contains("no V where the state has one"), "{error}");
    // What the state has not needs no null field.
    let u_alone = grid("x,y,u,v", |x, y| [linear(x, y)[0], f64::NAN]);
    std::fs::write(folder.path().join("up.csv"), u_alone).unwrap();
    succeeds(folder.path(), &["reduce", "e.toml"]);
}

/// Two gross errors, one of each kind people meet: a slipped decimal point, and a correlation that failed.
#[test]
fn outliers_of_a_table_are_masked_and_reported() {
    let spoil = |text: &str| {
        let mut lines: Vec<String> = text.lines().map(str::to_owned).collect();
        for (line, u) in [(101, "0.5"), (203, "-0.01")] {
            let cells: Vec<&str> = lines[line - 1].split(',').collect();
            lines[line - 1] = format!("{},{},{u},{}", cells[0], cells[1], cells[3]);
        }
        lines.join("\n") + "\n"
    };
    let clean = grid("x,y,u,v", linear);
    let folder = folder_with(&[("e.toml", TABLE), ("up.csv", &spoil(&clean))]);
    let path = folder.path();
    let reduce = |output: &str, set: &str| {
        let arguments = ["reduce", "e.toml", "--output", output, "--set", set];
        succeeds(path, &arguments)
    };
    let summary = reduce("default", "version=1");
    let measured = &summary["measured"][0];
    assert_eq!(measured["outliers"], 2, "{summary}");
    let places = measured["u"]["places"].as_u64().unwrap();
    for field in ["u", "v"] {
        assert_eq!(measured[field]["valid"].as_u64().unwrap(), places - 2);
    }
    let found = finding(&summary, "outliers", "warning");
    assert_eq!(
        (&found["count"], &found["places"]),
        (&2.into(), &places.into())
    );
    let worst =
        json!({ "line": 101, "field": "U", "value": 0.5, "expected": found["worst"]["expected"] });
    assert_eq!(found["worst"], worst);
    let warning = summary["warnings"][0].as_str().unwrap();
    for part in [
        "2 of",
        "up.csv",
        "line 101",
        "U = 0.5 mm",
        "outliers = false",
    ] {
        assert!(warning.contains(part), "{part}: {warning}");
    }
    let page = fs::read_to_string(path.join("default/index.html")).unwrap();
    assert!(page.contains("as outliers") && page.contains("outliers, masked: 2"));
    for row in numbers(&path.join("default/measured-up.csv")) {
        if !row[2].is_nan() {
            assert!(
                (row[2] - linear(row[0], row[1])[0]).abs() < 1e-12,
                "{row:?}"
            );
        }
    }
    for (output, set, expected) in [
        ("off", "reduce.outliers=false", Some(0)),
        ("on", "reduce.outliers=true", Some(2)),
        ("coarse", "reduce.outliers=1e9", Some(0)),
    ] {
        let summary = reduce(output, set);
        assert_eq!(
            summary["measured"][0]["outliers"].as_u64(),
            expected,
            "{set}"
        );
        assert_eq!(
            summary["warnings"].as_array().unwrap().is_empty(),
            expected == Some(0)
        );
    }
    for wrong in ["0.0", "-3", "\"many\""] {
        let set = format!("reduce.outliers={wrong}");
        let error = fails(path, &["reduce", "e.toml", "--output", "no", "--set", &set]);
        assert!(
            error.contains("outliers") && error.contains("false"),
            "{error}"
        );
    }
}

/// Outliers of the null field are reported as its own.
#[test]
fn outliers_of_a_null_field_are_reported_as_its_own() {
    let null = "null.table = { file = \"initial.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }\n";
    let initial = grid("x,y,u,v", |x, y| {
        let [u, v] = linear(x, y);
        [u, if [x, y] == [7.0, 3.0] { 1.0 } else { v }]
    });
    let folder = folder_with(&[
        ("e.toml", &format!("{TABLE}{null}")),
        (
            "up.csv",
            &grid("x,y,u,v", |x, y| linear(x, y).map(|u| 3.0 * u)),
        ),
        ("initial.csv", &initial),
    ]);
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(summary["measured"][0]["outliers"], 0);
    let found = finding(&summary, "outliers", "warning");
    assert_eq!(
        (&found["part"], &found["count"]),
        (&"null_field".into(), &1.into())
    );
    let worst = ["field", "value"].map(|key| &found["worst"][key]);
    assert_eq!(worst, [&json!("V"), &json!(1.0)]);
    let warning = summary["warnings"][0].as_str().unwrap();
    assert!(
        warning.starts_with("State 'up': The null field: 1 of"),
        "{warning}"
    );
    for row in numbers(&folder.path().join("e-results/measured-up.csv")) {
        // Interpolated over the gap.
        let v = linear(row[0], row[1])[1];
        assert!(
            row[3].is_nan() || (row[3] - 2.0 * v).abs() < 1e-12,
            "{row:?}"
        );
    }
}

/// Places of the null field elsewhere: how far, and what to do about it.
#[test]
fn a_null_field_measured_elsewhere_is_refused_with_a_remedy() {
    let null = "null.table = { file = \"initial.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\", origin = [0.5, 0] }\n";
    let folder = folder_with(&[
        (
            "e.toml",
            &format!("{TABLE}{null}[reduce]\ncommon_places = \"0.1 mm\"\n"),
        ),
        ("up.csv", &grid("x,y,u,v", linear)),
        ("initial.csv", &grid("x,y,u,v", linear)),
    ]);
    let path = folder.path();
    let error = fails(path, &["reduce", "e.toml"]);
    for part in [
        "common_places = 0.1 mm",
        "0.5 mm apart",
        "leave common_places out",
        "e.toml:9",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    let far = [
        "reduce",
        "e.toml",
        "--set",
        "states.0.null.table.origin=[100, 0]",
    ];
    let elsewhere = [&far[..], &["--set", "reduce.common_places=0.1 mm"]].concat();
    assert!(fails(path, &elsewhere).contains("apart"));
    let text = fs::read_to_string(path.join("e.toml")).unwrap();
    let interpolated = text.replace("common_places = \"0.1 mm\"", "");
    fs::write(path.join("e.toml"), interpolated).unwrap();
    let error = fails(path, &far);
    for part in ["x = −112 … −88 mm", "check scale, origin and y_axis"] {
        assert!(error.contains(part), "{part}: {error}");
    }
}

/// U and V, as everywhere, not numbers of components.
#[test]
fn components_are_named_in_errors() {
    let text = "x,y,u,v\n6,0,1e-3,1e-3\n7,0,1e-3,1e-3\n8,0,1e-3,1e-3\n9,1,1e-3,\n";
    let folder = folder_with(&[
        ("e.toml", &TABLE.replace(", deviation = \"1e-4 mm\"", "")),
        ("up.csv", text),
    ]);
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(error.contains("U is valid at"), "{error}");
    assert!(error.contains("deviation"), "{error}");
}
