//! Pictures that a test makes: a dislocation that no unwrapping closes, and light without fringes.

use std::f64::consts::TAU;
use std::fs;
use std::path::Path;

use serde_json::{Value, json};
use stickslip_hybrid::fringe::{Depth, Format, Frame, PixelMap, encode};

use super::refusals::check;
use super::{TABLE, fails, finding, findings, folder_with, succeeds};

const WINDOW: [[f64; 2]; 2] = [[6.0, -5.0], [16.0, 5.0]];

/// Writes a picture of orders, or of no fringes at all.
fn write(path: &Path, order: Option<&dyn Fn(f64, f64) -> f64>) {
    let frame = Frame::over(WINDOW, 0.05).unwrap();
    let map = PixelMap::of(frame, |[x, y]| {
        Some(order.map_or(0.5, |order| 0.5 + 0.4 * (TAU * order(x, y)).cos()))
    });
    let bytes = encode(&map.unwrap(), Format::Png, Depth::Eight).unwrap();
    fs::write(path, bytes).unwrap();
}

fn experiment(carrier: &str) -> String {
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    format!(
        "{head}\npictures = {{ u = \"u.png\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\"{carrier} }}\n[grating]\nfrequency = \"2400 1/mm\"\n"
    )
}

const CARRIER: &str = ", carrier = { u = [\"4 1/mm\", \"0 1/mm\"], v = [\"0 1/mm\", \"4 1/mm\"] }";

/// Around the end of a fringe orders rise by one: no path through the pixels is right, and the map says where.
#[test]
fn loops_that_do_not_close_are_flagged_on_the_map() {
    let folder = folder_with(&[("e.toml", &experiment(CARRIER))]);
    let dislocation = |x: f64, y: f64| 4.0 * x + (y - 1.0).atan2(x - 11.0) / TAU;
    write(&folder.path().join("u.png"), Some(&dislocation));
    let all = ["reduce", "e.toml", "--set", "reduce.least_modulation=0"];
    let summary = succeeds(folder.path(), &all);
    let field = &summary["measured"][0]["u"];
    assert!(field["open_loops"].as_u64().unwrap() >= 1, "{summary}");
    assert!(field["jumps"].as_u64().unwrap() >= 1, "{summary}");
    let open = &finding(&summary, "unwrapping", "warning")["fields"][0];
    let reported = ["field", "loops", "jumps"].map(|key| &open[key]);
    assert_eq!(
        reported,
        [&"U".into(), &field["open_loops"], &field["jumps"]]
    );
    let map = fs::read_to_string(folder.path().join("e-results/figures/phase-up.svg")).unwrap();
    assert!(map.contains("loops that do not close: 1") && map.contains("jumps of half a fringe"));
    assert_eq!(summary["measured"][0]["v"]["valid"], 0);
    // At the fringe's end there is no amplitude. Without those pixels no loop of four is open, and the jump across is still reported.
    let summary = succeeds(folder.path(), &["reduce", "e.toml", "--force"]);
    assert!(
        summary["measured"][0]["u"]["jumps"].as_u64().unwrap() >= 1,
        "{summary}"
    );
    let open = &finding(&summary, "unwrapping", "warning")["fields"][0];
    assert_eq!(open["jumps"], summary["measured"][0]["u"]["jumps"]);
}

#[test]
fn a_picture_without_carrier_is_refused() {
    let folder = folder_with(&[("e.toml", &experiment(CARRIER))]);
    write(&folder.path().join("u.png"), None);
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    for part in [
        "state 'up', U field",
        "no carrier",
        "e.toml:",
        "states.0.pictures",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    // Fringes twice as many as the carrier stated.
    write(&folder.path().join("u.png"), Some(&|x, _| 9.0 * x));
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(
        error.contains("carrier") && error.contains("fringes"),
        "{error}"
    );
}

#[test]
fn a_carrier_that_cannot_be_determined_is_refused() {
    let folder = folder_with(&[("e.toml", &experiment(""))]);
    write(&folder.path().join("u.png"), Some(&|x, _| 4.0 * x));
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(
        error.contains("nothing distinguishes the carrier's part"),
        "{error}"
    );
    // With the initial load's picture it drops out.
    let null = "null.pictures = { u = \"n.png\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\" }\n[grating]";
    let text = experiment("").replace("[grating]", null);
    fs::write(folder.path().join("e.toml"), text).unwrap();
    write(&folder.path().join("n.png"), Some(&|x, _| 4.0 * x));
    write(
        &folder.path().join("u.png"),
        Some(&|x, y| 4.3 * x + 0.1 * y),
    );
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(
        summary["warnings"].as_array().unwrap().len(),
        0,
        "{summary}"
    );
    let rows = super::numbers(&folder.path().join("e-results/measured-up.csv"));
    let at = |place: [f64; 2]| {
        let distance = |row: &Vec<f64>| (row[0] - place[0]).hypot(row[1] - place[1]);
        rows.iter()
            .min_by(|a, b| distance(a).total_cmp(&distance(b)))
            .unwrap()
    };
    let (left, right) = (at([9.0, 0.0]), at([13.0, 0.0]));
    let slope = 2400.0 * (right[2] - left[2]) / (right[0] - left[0]);
    assert!((slope - 0.3).abs() < 0.005, "{slope}");
}

/// Before anything is said of a picture it must be there, and be one.
#[test]
fn errors_of_picture_files_come_first() {
    let folder = folder_with(&[("e.toml", &experiment(""))]);
    let path = folder.path();
    for command in ["reduce", "check"] {
        let error = fails(path, &[command, "e.toml"]);
        assert!(
            error.contains("u.png' cannot be read") && error.contains("states.0.pictures"),
            "{error}"
        );
        assert!(!error.contains("carrier"), "{error}");
    }
    fs::write(path.join("u.png"), "no picture").unwrap();
    let error = fails(path, &["reduce", "e.toml"]);
    assert!(
        error.contains("u.png'") && error.contains("PNG or TIFF"),
        "{error}"
    );
    assert!(!error.contains("nothing distinguishes"), "{error}");
    // The other field's picture is missing, and this one has no fringes.
    write(&path.join("u.png"), None);
    let both = experiment(CARRIER).replace("u = \"u.png\"", "u = \"u.png\", v = \"gone.png\"");
    fs::write(path.join("e.toml"), both).unwrap();
    let error = fails(path, &["reduce", "e.toml"]);
    assert!(error.contains("gone.png' cannot be read"), "{error}");
}

#[test]
fn a_list_of_pictures_has_four() {
    for (list, found) in [
        ("[\"a.png\", \"b.png\", \"c.png\"]", "a list of 3 values"),
        ("[\"a.png\"]", "a list of 1 value"),
        ("{ file = \"a.png\" }", "a table"),
        ("7", "the number 7"),
    ] {
        let text = experiment(CARRIER).replace("\"u.png\"", list);
        let folder = folder_with(&[("e.toml", &text)]);
        let error = fails(folder.path(), &["reduce", "e.toml"]);
        for part in [
            "\"up-u-1.png\", \"up-u-2.png\", \"up-u-3.png\", \"up-u-4.png\"",
            &format!("found {found}"),
            "states.0.pictures.u",
            "e.toml:",
        ] {
            let words: String = error.split_whitespace().collect::<Vec<_>>().join(" ");
            assert!(words.contains(part), "{part}: {error}");
        }
    }
}

/// The initial load's U alone leaves nothing to take off V.
#[test]
fn a_null_field_without_the_picture_of_a_field_is_refused() {
    let null = "null.pictures = { u = \"n.png\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\" }\n[grating]";
    let text = experiment(CARRIER)
        .replace("u = \"u.png\"", "u = \"u.png\", v = \"v.png\"")
        .replace("[grating]", null);
    let folder = folder_with(&[("e.toml", &text)]);
    for name in ["n.png", "u.png"] {
        write(&folder.path().join(name), Some(&|x, _| 4.1 * x));
    }
    write(&folder.path().join("v.png"), Some(&|_, y| 4.1 * y));
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    for part in [
        "state 'up': the null field has no V",
        "n.png",
        "e.toml:9",
        "states.0.null",
        "leave V out",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
}

#[test]
fn a_picture_in_colour_or_none_at_all_is_refused() {
    let folder = folder_with(&[("e.toml", &experiment(CARRIER)), ("u.png", "no picture")]);
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(error.contains("picture file"), "{error}");
    fs::remove_file(folder.path().join("u.png")).unwrap();
    let error = fails(folder.path(), &["reduce", "e.toml"]);
    assert!(
        error.contains("u.png") && error.contains("cannot be read"),
        "{error}"
    );
}

/// A table as null field of pictures, and the reverse: maps, marks and warnings of the pictures stay.
#[test]
fn pictures_and_tables_are_taken_off_each_other() {
    let dislocation = |x: f64, y: f64| 4.0 * x + (y - 1.0).atan2(x - 11.0) / TAU;
    let table =
        "table = { file = \"t.csv\", scale = \"1 mm\", y_axis = \"up\", deviation = \"1e-4 mm\" }";
    let pictures = "pictures = { u = \"u.png\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\" }";
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    let grid = super::grid("x,y,u,v", |x, _| [1e-4 * x, f64::NAN]);
    // Finer than the grid of places, so that jumps in the way are of no interest.
    for (own, null, of_null) in [(pictures, table, false), (table, pictures, true)] {
        let text = format!(
            "{head}\n{own}\nnull.{null}\n[reduce]\nleast_modulation = 0\n[grating]\nfrequency = \"2400 1/mm\"\n"
        );
        let folder = folder_with(&[("e.toml", &text), ("t.csv", &grid)]);
        write(&folder.path().join("u.png"), Some(&dislocation));
        let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
        let field = &summary["measured"][0]["u"];
        assert!(field["open_loops"].as_u64().unwrap() >= 1, "{summary}");
        let whose = if of_null {
            json!("null_field")
        } else {
            Value::Null
        };
        let carrier = finding(&summary, "carrier_found", "warning");
        assert_eq!((&carrier["field"], &carrier["part"]), (&"U".into(), &whose));
        assert_eq!(carrier["carrier_per_mm"], field["carrier_per_mm"]);
        let open = finding(&summary, "unwrapping", "warning");
        assert_eq!((&open["state"], &open["part"]), (&"up".into(), &whose));
        assert_eq!(open["fields"][0]["loops"], field["open_loops"]);
        let maps = findings(&summary, "maps_before_null_field");
        assert_eq!(maps.len(), usize::from(!of_null));
        let figures = folder.path().join("e-results/figures");
        let map = fs::read_to_string(figures.join("phase-up.svg")).unwrap();
        assert!(map.contains("loops that do not close: "));
        assert_eq!(figures.join("orders-up.svg").exists(), !of_null);
        assert_eq!(figures.join("data-up.svg").exists(), of_null);
    }
}

/// Loops that are open in the initial load's picture are open in the difference.
#[test]
fn one_warning_counts_the_loops_of_both_fields_and_of_the_null_field() {
    let dislocation = |x: f64, y: f64| 4.0 * x + (y - 1.0).atan2(x - 11.0) / TAU;
    let of = |u: &str, v: &str| {
        format!(
            "pictures = {{ u = \"{u}\", v = \"{v}\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\"{CARRIER} }}"
        )
    };
    let head = TABLE.lines().take(7).collect::<Vec<_>>().join("\n");
    let text = format!(
        "{head}\n{}\nnull.{}\n[reduce]\nleast_modulation = 0\n[grating]\nfrequency = \"2400 1/mm\"\n",
        of("even-u.png", "open-v.png"),
        of("open-u.png", "even-v.png")
    );
    let folder = folder_with(&[("e.toml", &text)]);
    let path = |name: &str| folder.path().join(name);
    write(&path("even-u.png"), Some(&|x, _| 4.0 * x));
    write(&path("even-v.png"), Some(&|_, y| 4.0 * y));
    write(&path("open-u.png"), Some(&dislocation));
    write(
        &path("open-v.png"),
        Some(&|x, y| 4.0 * y + (y - 1.0).atan2(x - 11.0) / TAU),
    );
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    let open = finding(&summary, "unwrapping", "warning");
    let mut counts = Vec::new();
    for (k, (name, field)) in [("u", "U"), ("v", "V")].into_iter().enumerate() {
        let own = &summary["measured"][0][name];
        let [loops, jumps] = ["open_loops", "jumps"].map(|key| own[key].as_u64().unwrap());
        assert!(loops >= 1, "{summary}");
        let expected = json!({ "field": field, "loops": loops, "jumps": jumps });
        assert_eq!(open["fields"][k], expected);
        counts.push(format!("{loops} and {jumps} in the {field} field"));
    }
    let warnings = summary["warnings"].as_array().unwrap();
    assert_eq!(warnings.len(), 1, "{summary}");
    let words = warnings[0].as_str().unwrap();
    check(
        words,
        &["State 'up': Unwrapping is inconsistent", &counts.join(", ")],
    );
}

/// What the pictures of the back cannot be trusted in is said.
#[test]
fn warnings_of_the_back_are_reported() {
    let back = "back.pictures = { u = \"b.png\", pixel = \"0.05 mm\", top_left = [\"6 mm\", \"5 mm\"], y_axis = \"up\"";
    let symmetry = "[reduce]\nleast_modulation = 0\nsymmetry = { from = [\"13 mm\", \"-4 mm\"], to = [\"15 mm\", \"-4 mm\"] }\n[grating]";
    let text = experiment(CARRIER).replace("[grating]", &format!("{back}{CARRIER} }}\n{symmetry}"));
    let folder = folder_with(&[("e.toml", &text)]);
    let dislocation = |x: f64, y: f64| 4.0 * x + (y - 1.0).atan2(x - 11.0) / TAU;
    write(&folder.path().join("u.png"), Some(&|x, _| 4.0 * x));
    write(&folder.path().join("b.png"), Some(&dislocation));
    let summary = succeeds(folder.path(), &["reduce", "e.toml"]);
    assert_eq!(finding(&summary, "unwrapping", "warning")["part"], "back");
    let words = summary["warnings"][0].as_str().unwrap();
    assert!(
        words.starts_with("State 'up': The back: Unwrapping is inconsistent: "),
        "{summary}"
    );
}

/// Which file it is, what it should be, and where the fringes are that were looked for elsewhere.
#[test]
fn pictures_that_are_refused_are_named_with_a_remedy() {
    let folder = folder_with(&[("e.toml", &experiment(CARRIER)), ("u.png", "no picture")]);
    let path = folder.path();
    let error = fails(path, &["reduce", "e.toml"]);
    for part in [
        "U field, 'u.png'",
        "PNG or TIFF in grey, 8 or 16",
        "-colorspace Gray",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    write(&path.join("u.png"), Some(&|x, _| 9.0 * x));
    let error = fails(path, &["reduce", "e.toml"]);
    let error = error
        .split_whitespace()
        .filter(|word| *word != "│")
        .collect::<Vec<_>>();
    let error = error.join(" ");
    for part in [
        "'u.png'",
        "carrier stated is (4, 0) fringes/mm",
        "strongest fringes have (9.0",
    ] {
        assert!(error.contains(part), "{part}: {error}");
    }
    let per_pixel = "states.0.pictures.carrier={ u = [\"0.2 1/mm\", \"0 1/mm\"], v = [\"0 1/mm\", \"0.2 1/mm\"] }";
    let error = fails(path, &["reduce", "e.toml", "--set", per_pixel]);
    assert!(error.contains("not per pixel"), "{error}");
}
