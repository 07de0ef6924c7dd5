//! A specimen that turns between two pictures, and pictures that are dilated: friction of the sample table of `stickslip init experiment`.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use tempfile::TempDir;

use super::{finding, findings, folder_with, succeeds};

const SECTOR: &str = "region.sector={ angles = [\"-10 deg\", \"115 deg\"], outer = \"13 mm\", cells = [24, 6], growth = 2.0 }";

fn sample() -> TempDir {
    let folder = folder_with(&[]);
    succeeds(folder.path(), &["init", "experiment", "mine.toml"]);
    folder
}

/// Writes the table of the sample after another motion, which takes a place and where it was seen `[mm]` to where it is seen then.
fn moved(path: &Path, name: &str, motion: impl Fn([f64; 2], [f64; 2]) -> [f64; 2]) {
    let text = fs::read_to_string(path.join("mine.csv")).unwrap();
    let mut lines = text.lines();
    let mut own = format!("{}\n", lines.next().unwrap());
    for line in lines {
        let row: Vec<f64> = line.split(',').map(|cell| cell.parse().unwrap()).collect();
        let place = [row[0], row[1]];
        let seen = motion(place, [row[0] + 1e-3 * row[2], row[1] + 1e-3 * row[3]]);
        let [u, v] = [0, 1].map(|c| 1e3 * (seen[c] - place[c]));
        writeln!(own, "{},{},{u:.9},{v:.9}", row[0], row[1]).unwrap();
    }
    fs::write(path.join(name), own).unwrap();
}

fn turned_by(degrees: f64) -> impl Fn([f64; 2], [f64; 2]) -> [f64; 2] {
    let (sine, cosine) = f64::to_radians(degrees).sin_cos();
    move |_, [x, y]| {
        let (x, y) = (x - 30.0, y + 12.0);
        [30.2 + cosine * x - sine * y, -12.1 + sine * x + cosine * y]
    }
}

fn identified(path: &Path, table: &str, settings: &[&str]) -> Value {
    let file = format!("states.0.table.file=\"{table}\"");
    let mut arguments = vec![
        "identify",
        "mine.toml",
        "--force",
        "--set",
        SECTOR,
        "--set",
        &file,
    ];
    arguments.extend(settings.iter().flat_map(|setting| ["--set", setting]));
    succeeds(path, &arguments)
}

/// Coefficient, and the ends of its interval.
fn friction(summary: &Value) -> [f64; 3] {
    let own = &summary["friction"]["mu_dynamic"];
    ["best", "low", "high"].map(|name| {
        own[name]
            .as_f64()
            .unwrap_or_else(|| panic!("{name}: {own}"))
    })
}

/// A rotation of 0.2° strains linear displacements by 6e-6, one of 5° by 4e-3. Taken off, it leaves the digits of the table, 1e-9 µm.
#[test]
fn friction_does_not_depend_on_how_far_the_specimen_turned() {
    let folder = sample();
    let path = folder.path();
    moved(path, "still.csv", |_, seen| seen);
    let still = identified(path, "still.csv", &[]);
    let [own, low, high] = friction(&still);
    let angle = |summary: &Value| {
        let rotation = &summary["measured"][0]["rotations"][0];
        ["degrees", "deviation_degrees"].map(|name| rotation[name].as_f64().unwrap())
    };
    println!("unturned: {own} in {low} … {high}, {:?}", angle(&still));
    assert!((low..high).contains(&0.25));
    for degrees in [0.2, 5.0] {
        moved(path, "turned.csv", turned_by(degrees));
        let summary = identified(path, "turned.csv", &[]);
        let found = friction(&summary);
        let [turned, deviation] = angle(&summary);
        println!("{degrees}°: {found:?}, {turned}° ± {deviation}°");
        for (a, b) in found.into_iter().zip([own, low, high]) {
            assert!((a - b).abs() < 1e-6, "{degrees}°: {a} {b}");
        }
        assert!((turned - angle(&still)[0] - degrees).abs() < 1e-9);
        assert!(deviation > 0.0 && deviation < 1e-3);
        assert_eq!(summary["warnings"], still["warnings"]);
    }
}

/// The null field turned otherwise than the state.
#[test]
fn a_null_field_that_turned_is_turned_back_by_its_own_angle() {
    let folder = sample();
    let path = folder.path();
    let null = "states.0.null.table={ file = \"null.csv\", columns = { x = \"X_mm\", y = \"Y_mm\", u = \"DX_um\", v = \"DY_um\" }, scale = \"1 mm\", displacement_scale = \"1 um\", y_axis = \"up\", deviation = \"0.01 um\" }";
    let reduced = |table: &str, turn: f64| {
        moved(path, "null.csv", |place, [x, y]| {
            // Half of the load, which turns the field by more than 1e-5 rad.
            turned_by(turn)(
                place,
                [
                    place[0] + 0.5 * (x - place[0]),
                    place[1] + 0.5 * (y - place[1]),
                ],
            )
        });
        let file = format!("states.0.table.file=\"{table}\"");
        let arguments = [
            "reduce",
            "mine.toml",
            "--force",
            "--set",
            &file,
            "--set",
            null,
        ];
        let summary = succeeds(path, &arguments);
        let rotations = summary["measured"][0]["rotations"]
            .as_array()
            .unwrap()
            .clone();
        (
            super::numbers(&path.join("mine-results/measured-up.csv")),
            rotations,
        )
    };
    moved(path, "turned.csv", turned_by(1.0));
    let (still, _) = reduced("mine.csv", 0.0);
    let (turned, rotations) = reduced("turned.csv", -0.4);
    let of = |name: &str| {
        rotations.iter().find(|own| own["of"] == name).unwrap()["degrees"]
            .as_f64()
            .unwrap()
    };
    assert!(
        (of("state") - 1.0).abs() < 0.05 && (of("null") + 0.4).abs() < 0.01,
        "{rotations:?}"
    );
    let offset = |c: usize| turned[400][c] - still[400][c];
    let (du, dv) = (offset(2), offset(3));
    for (a, b) in turned.iter().zip(&still).filter(|(a, _)| !a[2].is_nan()) {
        assert!(
            (a[2] - b[2] - du).abs() < 1e-9 && (a[3] - b[3] - dv).abs() < 1e-9,
            "{a:?} {b:?}"
        );
    }
}

/// A dilation of 1e-4 adds 10 MPa to the pressure of an aluminium plate: the edge clear of contact says how much it is, and takes it off.
#[test]
fn a_dilation_is_found_at_the_free_edge_and_taken_off_where_it_is_declared_free() {
    let folder = sample();
    let path = folder.path();
    moved(path, "dilated.csv", |_, seen| {
        seen.map(|x| x * (1.0 + 1e-4))
    });
    let free = "reduce.free=[\"dilation\"]";
    let picture = |summary: &Value| {
        let own = summary["edge_stresses"][0]["picture"][0].clone();
        assert_eq!(
            (&own["name"], &own["separable"]),
            (&"dilation".into(), &true.into()),
            "{own}"
        );
        (
            own["value"].as_f64().unwrap(),
            own["deviation"].as_f64().unwrap(),
            own["taken_off"] == true,
        )
    };
    let still = identified(path, "mine.csv", &[]);
    let [own, low, high] = friction(&still);
    let (none, deviation, taken) = picture(&still);
    println!("undilated: {own} in {low} … {high}; dilation {none:.2e} ± {deviation:.2e}");
    assert!(none.abs() < 3.0 * deviation && !taken);
    let dilated = identified(path, "dilated.csv", &[]);
    let (found, _, taken) = picture(&dilated);
    println!("dilated: {:?}; dilation {found:.2e}", friction(&dilated));
    assert!((found - none - 1e-4).abs() < deviation && !taken);
    for failed in findings(&dilated, "check_fails") {
        let own = &dilated["edge_stresses"][0]["picture"][0];
        assert_eq!(failed["dilation"], json!([own["value"], own["deviation"]]));
    }
    assert!(!findings(&dilated, "check_fails").is_empty(), "{dilated}");
    assert!(
        dilated["warnings"].to_string().contains("[reduce] free"),
        "{}",
        dilated["warnings"]
    );
    let freed = identified(path, "dilated.csv", &[free]);
    let (value, deviation, taken) = picture(&freed);
    let [mu, from, to] = friction(&freed);
    println!("freed: {mu} in {from} … {to}; dilation {value:.2e} ± {deviation:.2e}");
    assert!(taken && (value - 1e-4).abs() < 3.0 * deviation);
    assert!((from..to).contains(&0.25) && (mu - own).abs() < high - low);
    let both = identified(
        path,
        "dilated.csv",
        &["reduce.free=[\"tilt\", \"dilation\"]"],
    );
    let names: Vec<&Value> = both["edge_stresses"][0]["picture"]
        .as_array()
        .unwrap()
        .iter()
        .map(|own| &own["name"])
        .collect();
    assert_eq!(names, ["dilation", "tilt along x", "tilt along y"]);
    println!(
        "with tilt: {:?}; {}",
        friction(&both),
        both["edge_stresses"][0]["picture"]
    );
}

/// A region that ends inside of the contact has no evidence of a dilation, and says so instead of taking the load for one.
#[test]
fn a_dilation_that_cannot_be_distinguished_from_the_load_is_not_taken_off() {
    let folder = sample();
    let path = folder.path();
    let sector = "region.sector={ angles = [\"0 deg\", \"60 deg\"], outer = \"13 mm\", cells = [14, 6], growth = 2.0 }";
    let hybrid = |settings: &[&str]| {
        let mut arguments = vec!["hybrid", "mine.toml", "--force", "--set", sector];
        arguments.extend(settings.iter().flat_map(|setting| ["--set", setting]));
        succeeds(path, &arguments)
    };
    let still = hybrid(&[]);
    let freed = hybrid(&["reduce.free=[\"dilation\"]"]);
    for summary in [&still, &freed] {
        let own = &summary["edge_stresses"][0]["picture"][0];
        assert_eq!(
            (&own["separable"], &own["taken_off"]),
            (&false.into(), &false.into()),
            "{own}"
        );
        assert!(own["value"].is_null() && own["pressure_per_unit"].as_f64().unwrap() > 0.0);
        assert_eq!(
            summary["edge_stresses"][0]["largest"],
            still["edge_stresses"][0]["largest"]
        );
    }
    let open = finding(&freed, "not_separable", "warning");
    let own = &freed["edge_stresses"][0]["picture"][0];
    assert_eq!(open["motion"], "dilation");
    assert_eq!(open["pressure_per_unit"], own["pressure_per_unit"]);
}
