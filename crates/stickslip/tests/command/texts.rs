//! Names and messages that would steer a terminal, a page or a spreadsheet.

use std::fs;

use super::{SCENE, fails, folder_with, succeeds};

fn has_controls(text: &str) -> bool {
    text.chars()
        .any(|letter| letter.is_control() && !matches!(letter, '\n' | '\t'))
}

#[test]
fn control_characters_in_a_file_are_refused_at_their_line() {
    let places = [
        ("title = \"Pin\"", "title = \"Pin\\u001b[2J\"", 2),
        ("name = \"pin\"", "name = \"p\\u009bin\"", 19),
        ("name = \"pin\"", "name = \"p\\u202ein\"", 19),
        ("title = \"Pin\"", "title = \"Pin\\nsecond\"", 2),
    ];
    for (old, new, line) in places {
        let folder = folder_with("pin.toml", &SCENE.replace(old, new));
        let message = fails(folder.path(), &["check", "pin.toml"]);
        for part in [
            "control character U+",
            &format!("pin.toml:{line}:"),
            "remove it",
        ] {
            assert!(message.contains(part), "{part}: {message}");
        }
        assert!(!has_controls(&message), "{message:?}");
    }
    let folder = folder_with("pin.toml", SCENE);
    let set = ["check", "pin.toml", "--set", "title=a\u{7}b"];
    let message = fails(folder.path(), &set);
    assert!(message.contains("U+0007"), "{message}");
    let described = SCENE.replace("title", "description = \"two\\n\\tlines\"\ntitle");
    fs::write(folder.path().join("pin.toml"), described).unwrap();
    succeeds(folder.path(), &["check", "pin.toml"]);
}

#[test]
fn errors_in_long_lines_show_what_is_beside_them() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    let long = "é".repeat(50_000);
    let toml = format!("{SCENE}title2 = \"{long}\"\n");
    let before = format!("{{\"description\": \"{long}\", \"version\": 1, \"bodis\": {{}}}}");
    let value = format!("{{\"version\": 1, \"bodies\": [\"{long}\"]}}");
    for (name, text, place) in [
        ("after.toml", &toml, "title2 = \"é"),
        ("before.json", &before, "\"bodis\": {}"),
        ("value.json", &value, "\"bodies\": [\"é"),
    ] {
        fs::write(path.join(name), text).unwrap();
        let message = fails(path, &["check", name]);
        let longest = message.lines().map(|line| line.chars().count()).max();
        assert!(message.contains(place), "{name}: {message}");
        assert!(longest < Some(500), "{name}: {longest:?} columns");
    }
}

#[test]
fn control_characters_from_elsewhere_are_written_out() {
    let folder = folder_with("pin.toml", SCENE);
    let path = folder.path();
    let message = fails(path, &["check", "a\u{1b}]0;b\u{7}.toml"]);
    assert!(message.contains("\\u{1b}]0;b\\u{7}"), "{message}");
    assert!(!has_controls(&message), "{message:?}");
    // What the parser shows of a line.
    fs::write(path.join("c.toml"), "version = 1 # \u{9b}31m\nx = = 1\n").unwrap();
    let message = fails(path, &["check", "c.toml"]);
    assert!(!has_controls(&message), "{message:?}");
    // A title that is the file's name.
    let name = "t\u{1b}[1m.toml";
    fs::write(path.join(name), SCENE.replace("title = \"Pin\"\n", "")).unwrap();
    let run = ["run", name, "--output", "r", "--set", "mesh.spacing=15 deg"];
    let printed = succeeds(path, &run);
    assert!(!has_controls(&printed), "{printed:?}");
    let page = fs::read_to_string(path.join("r/report.html")).unwrap();
    assert!(!has_controls(&page) && page.contains("t\\u{1b}[1m"));
}

#[test]
fn no_cell_of_a_table_is_a_formula() {
    for name in ["=1+1", "+pin", "-pin", "@pin"] {
        let scene = SCENE.replace("name = \"pin\"", &format!("name = \"{name}\""));
        let folder = folder_with("pin.toml", &scene);
        let path = folder.path();
        succeeds(
            path,
            &[
                "run",
                "pin.toml",
                "--set",
                "mesh.spacing=15 deg",
                "--set",
                "output.figures=false",
            ],
        );
        let mut tables = 0;
        for entry in fs::read_dir(path.join("pin-results")).unwrap() {
            let file = entry.unwrap().path();
            if file.extension().is_none_or(|end| end != "csv") {
                continue;
            }
            tables += 1;
            let mut reader = csv::ReaderBuilder::new()
                .has_headers(false)
                .from_path(&file)
                .unwrap();
            for cell in reader.records().flat_map(|row| {
                let row = row.unwrap();
                row.iter().map(str::to_owned).collect::<Vec<_>>()
            }) {
                let formula =
                    cell.starts_with(['=', '+', '-', '@']) && cell.parse::<f64>().is_err();
                assert!(!formula, "{}: {cell}", file.display());
            }
        }
        assert!(tables >= 3, "{tables}");
    }
}
