//! Edge stresses and friction of tables and pictures, as the command reports them.

use std::fmt::Write as _;
use std::fs;
use std::path::Path;

use serde_json::Value;

use super::{FRINGES, SCENE, TABLE, finding, findings, folder_with, numbers, stickslip, succeeds};

const SIGMA: f64 = 1e-5;

/// Displacement `[mm]` of a plate of aluminium with a hole of 2 mm, stretched along x by 60 MPa (Kirsch 1898).
fn kirsch(x: f64, y: f64) -> [f64; 2] {
    let (radius, stress, modulus, ratio) = (2.0, 60.0, 71_700.0, 0.33);
    let (r, theta) = (x.hypot(y), y.atan2(x));
    let kappa = (3.0 - ratio) / (1.0 + ratio);
    let shear = modulus / (2.0 * (1.0 + ratio));
    let (q, cube) = (radius / r, (radius / r).powi(3));
    let u = (kappa + 1.0) * theta.cos() / q
        + 2.0 * q * ((1.0 + kappa) * theta.cos() + (3.0 * theta).cos())
        - 2.0 * cube * (3.0 * theta).cos();
    let v = (kappa - 3.0) * theta.sin() / q
        + 2.0 * q * ((1.0 - kappa) * theta.sin() + (3.0 * theta).sin())
        - 2.0 * cube * (3.0 * theta).sin();
    [u, v].map(|shape| stress * radius / (8.0 * shear) * shape)
}

/// A number between −√3 and √3, uniform: standard deviation 1.
fn noise(k: usize) -> f64 {
    let bits = (k as u64 + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    let bits = (bits ^ (bits >> 29)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    let part = ((bits ^ (bits >> 32)) >> 11) as f64 / (1_u64 << 53) as f64;
    (2.0 * part - 1.0) * 3.0_f64.sqrt()
}

/// The upper half of the plate; noise in standard deviations, and decimals where numbers are rounded.
fn table(deviations: f64, decimals: Option<usize>) -> String {
    let mut text = "x,y,u,v\n".to_owned();
    let mut k = 0;
    for i in -30..=30 {
        for j in -4..=30 {
            let (x, y) = (0.2 * f64::from(i), 0.2 * f64::from(j));
            if x.hypot(y) <= 2.0 {
                continue;
            }
            let [u, v] = kirsch(x, y).map(|u| {
                k += 1;
                u + deviations * SIGMA * noise(k)
            });
            match decimals {
                Some(decimals) => writeln!(text, "{x},{y},{u:.decimals$},{v:.decimals$}"),
                None => writeln!(text, "{x},{y},{u},{v}"),
            }
            .unwrap();
        }
    }
    text
}

const OPEN_HOLE: &str = r#"version = 1
title = "Open hole"
[specimen]
material.isotropic = { young = "71.7 GPa", poisson = 0.33 }
thickness = "1.5 mm"
hole = { centre = ["0 mm", "0 mm"], radius = "2 mm" }
[region]
sector = { angles = ["0 deg", "180 deg"], outer = "4 mm", cells = [24, 6] }
[[states]]
name = "pulled"
table = { file = "up.csv", scale = "1 mm", y_axis = "up", deviation = "1e-5 mm" }
"#;

const STATED: &str = ", deviation = \"1e-5 mm\"";

/// An open hole has hoop stress and no friction, and both commands say so as text.
#[test]
fn an_open_hole_in_tension_has_no_contact_and_no_friction_to_identify() {
    let folder = folder_with(&[("e.toml", OPEN_HOLE), ("up.csv", &table(1.0, None))]);
    let path = folder.path();
    let output = stickslip(path, &["identify", "e.toml"]);
    let text = String::from_utf8(output.stdout).unwrap();
    for part in [
        "State 'pulled': peak pressure",
        "largest hoop stress 17",
        "no contact: every pressure is negligible",
        "Dynamic friction μd: no pressure on the edge",
        "Static friction μs: no pressure on the edge",
    ] {
        assert!(text.contains(part), "{part}: {text}");
    }
    let none = "edge: no contact, no friction to identify";
    assert_eq!(text.matches(none).count(), 2, "{text}");
    let summary = succeeds(path, &["hybrid", "e.toml", "--output", "json"]);
    let found = &summary["edge_stresses"][0];
    assert_eq!(found["contact"], false);
    let hoop = &found["largest"]["hoop"];
    let number = |key: &str| hoop[key].as_f64().unwrap();
    // Three times the stress, where the hole's edge is along it.
    assert!(
        (number("value") - 180.0).abs() < 4.0 * number("deviation") + 2.0,
        "{hoop}"
    );
    assert!((number("theta_degrees") - 90.0).abs() < 10.0, "{hoop}");
    let friction = fs::read_to_string(path.join("e-results/friction.csv")).unwrap();
    assert_eq!(friction, "state,theta [deg],ratio tau/p,deviation\n");
}

fn hybrid(path: &Path, table: &str, experiment: &str) -> Value {
    fs::write(path.join("up.csv"), table).unwrap();
    fs::write(path.join("e.toml"), experiment).unwrap();
    succeeds(path, &["hybrid", "e.toml", "--force"])
}

/// Calculated data have no noise; their bands do not shrink below what was stated, or what rounds their digits.
#[test]
fn bands_of_calculated_data_are_those_of_the_stated_deviation_or_of_their_digits() {
    let folder = folder_with(&[]);
    let path = folder.path();
    let deviation = |summary: &Value| {
        let largest = &summary["edge_stresses"][0]["largest"]["hoop"];
        largest["deviation"].as_f64().unwrap()
    };
    let factor = |summary: &Value| {
        summary["edge_stresses"][0]["noise_factor"]
            .as_f64()
            .unwrap()
    };
    let noisy = hybrid(path, &table(1.0, None), OPEN_HOLE);
    assert!((0.7..1.5).contains(&factor(&noisy)), "{noisy}");
    assert_eq!(noisy["warnings"].as_array().unwrap().len(), 0, "{noisy}");
    let stated = hybrid(path, &table(0.0, None), OPEN_HOLE);
    assert_eq!(factor(&stated), 1.0);
    let small = finding(&stated, "small_residuals", "warning");
    assert_eq!(small["stated"], true, "{small}");
    assert!(small["variance_ratio"].as_f64().unwrap() < 0.1, "{small}");
    let ratio = deviation(&stated) / deviation(&noisy);
    // Less noise is smoothed less, by cross-validation, and never more.
    assert!(ratio > 0.8, "{ratio}");
    let estimated = OPEN_HOLE.replace(STATED, "");
    for (decimals, rounding) in [(6, 1e-6), (5, 1e-5)] {
        let rounded = hybrid(path, &table(0.0, Some(decimals)), &estimated);
        let data = &rounded["measured"][0]["u"]["deviation"];
        let errors = data.as_f64().unwrap() * factor(&rounded).sqrt();
        let least = rounding / 12.0_f64.sqrt();
        assert!(errors >= (1.0 - 1e-9) * least, "{errors} of {least}");
        assert!(deviation(&rounded) > 0.0);
    }
    let whole = hybrid(path, &table(0.0, None), &estimated);
    for found in findings(&whole, "as_calculated") {
        assert!(found["of_range"].as_f64().unwrap() < 1e-5, "{found}");
    }
    assert!(!findings(&whole, "as_calculated").is_empty(), "{whole}");
    assert!(factor(&whole) > 0.0);
}

/// Contact of pictures: one line per state in the terminal, states by name, static friction alike as text.
#[test]
fn friction_is_reported_by_the_names_of_states() {
    let text = FRINGES.replace(
        "[[\"2 mm\", \"-5 mm\"], [\"12 mm\", \"5 mm\"]]",
        "[[\"-2 mm\", \"-9 mm\"], [\"9 mm\", \"9 mm\"]]",
    ) + "order_error = 0.05\n[reduce]\nmargin = \"0.2 mm\"\n[region]\nsector = { angles = [\"-50 deg\", \"50 deg\"], outer = \"7.5 mm\", cells = [24, 6] }\n\
           [[states]]\nname = \"up\"\nstep = 2\n";
    let folder = folder_with(&[
        ("scene.toml", &SCENE.replace("\"1 kN\"", "\"0.4 kN\"")),
        ("e.toml", &text),
    ]);
    let path = folder.path();
    let output = stickslip(path, &["identify", "e.toml"]);
    let reported = String::from_utf8(output.stdout).unwrap();
    assert!(
        reported.contains("State 'up': peak pressure") && reported.contains("largest shear τ_rθ"),
        "{reported} {}",
        String::from_utf8_lossy(&output.stderr)
    );
    let friction = fs::read_to_string(path.join("e-results/friction.csv")).unwrap();
    assert!(friction.lines().count() > 10);
    assert!(
        friction.lines().skip(1).all(|line| line.starts_with("up,")),
        "{friction}"
    );
    let summary = fs::read_to_string(path.join("e-results/summary.json")).unwrap();
    let summary: Value = serde_json::from_str(&summary).unwrap();
    let fixed = &summary["friction"]["mu_static"];
    let words = fixed["in_words"].as_str().unwrap();
    assert_eq!(
        fixed["low"].is_null(),
        words.starts_with("not identifiable"),
        "{fixed}"
    );
    let page = fs::read_to_string(path.join("e-results/index.html")).unwrap();
    assert!(page.contains("Checks of the data") && page.contains("Free edge: "));
}

/// A ring begins at the first of its angles, in whichever turn it is stated, and its stresses stay with their places.
#[test]
fn a_ring_is_cut_at_the_first_of_its_angles() {
    const STRAIN: f64 = -1e-3;
    let mut table = "x,y,u,v\n".to_owned();
    for i in -36..=36 {
        for j in -36..=36 {
            let [x, y] = [i, j].map(|k| 0.25 * f64::from(k));
            if (5.0..9.0).contains(&x.hypot(y)) {
                writeln!(table, "{x},{y},{},0", STRAIN * x).unwrap();
            }
        }
    }
    let folder = folder_with(&[("e.toml", TABLE), ("up.csv", &table)]);
    let path = folder.path();
    // Uniform stresses in the plane; the traction of the edge is theirs, and no load of a plate with a hole.
    let stress = 70e3 / (1.0 - 0.33_f64.powi(2)) * STRAIN;
    for (first, last, cut) in [(-180, 180, -180.0), (0, 360, 0.0), (90, 450, -270.0)] {
        let region = format!(
            "region={{ sector = {{ angles = [\"{first} deg\", \"{last} deg\"], outer = \"7 mm\", cells = [40, 4] }} }}"
        );
        succeeds(path, &["hybrid", "e.toml", "--force", "--set", &region]);
        let rows = numbers(&path.join("e-results/edge-up.csv"));
        assert_eq!(rows.len(), 80);
        assert!((rows[0][0] - cut).abs() < 1e-6, "{:?}", rows[0]);
        assert!(rows.windows(2).all(|pair| pair[0][0] < pair[1][0]));
        for row in &rows {
            let (sin, cos) = row[0].to_radians().sin_cos();
            let pressure = -stress * (cos * cos + 0.33 * sin * sin);
            let shear = -stress * (1.0 - 0.33) * sin * cos;
            for (found, expected) in [(row[1], pressure), (row[5], shear)] {
                assert!((found - expected).abs() < 0.01 * stress.abs(), "{row:?}");
            }
        }
    }
}
