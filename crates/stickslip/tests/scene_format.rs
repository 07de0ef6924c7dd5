//! `docs/scene-format.md` against the program: the document names every key that the reader knows and no other, its examples
//! are accepted, and its defaults are those that `check` prints.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;
use stickslip::diagnostic::{SceneError, SceneProblem};
use stickslip::host::HOST;
use stickslip::model::Model;
use stickslip::scene::{Format, Scene};

const DOCUMENT: &str = include_str!("../../../docs/scene-format.md");

/// A scene that leaves out whatever it may, so that any key can be set in it; `expansion`, `fine_to` and a laminate with a hole are
/// there for keys that need them.
const BASE: &str = r#"
version = 1
[materials.aluminium.isotropic]
young = "70 GPa"
poisson = 0.33
expansion = "2.3e-5 1/K"
[plies.carbon]
e1 = "140 GPa"
e2 = "9 GPa"
g12 = "5 GPa"
nu12 = 0.3
thickness = "0.125 mm"
strengths = { xt = "1500 MPa", xc = "1200 MPa", yt = "50 MPa", yc = "200 MPa", s12 = "70 MPa", s23 = "100 MPa" }
[materials.composite.laminate]
layup = "[0/90]s"
ply = "carbon"
[bodies.coupon]
material = "composite"
shape.plate_with_hole = { hole_radius = "5 mm", outline.ring = { radius = "25 mm" } }
[bodies.coupon-pin]
material = "aluminium"
thickness = "0.5 mm"
shape.disk = { radius = "5 mm" }
[failure]
criteria = ["max_stress"]
[bodies.plate]
material = "aluminium"
thickness = "1 mm"
[bodies.plate.shape.plate_with_hole]
hole_radius = "5 mm"
outline.strip = { half_width = "20 mm", left = "80 mm", right = "20 mm" }
[bodies.pin]
material = "aluminium"
thickness = "1 mm"
shape.disk = { radius = "5 mm" }
[mesh]
spacing = "5 deg"
fine_to = "100 deg"
[[contacts]]
first = "plate.hole"
second = "pin.rim"
friction.coulomb = { mu = 0.2 }
[[contacts]]
first = "coupon.hole"
second = "coupon-pin.rim"
friction.coulomb = { mu = 0.2 }
[[supports]]
on = "pin.centre"
fix = ["x", "y"]
[[supports]]
on = "coupon.outer"
fix = ["x", "y"]
[[loads]]
on = "plate.hole"
force = { direction = [-1, 0], steps = ["1 kN"] }
"#;

/// A row of a table: its cells by the table's headings.
type Row = BTreeMap<&'static str, String>;

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn read(overrides: &[String]) -> Result<Scene, SceneError> {
    Scene::from_text_on(BASE, Format::Toml, "base.toml", &scenes(), overrides, HOST)
}

fn cells(line: &'static str) -> Vec<String> {
    let shielded = line.trim().trim_matches('|').replace("\\|", "\u{0}");
    let plain = |cell: &str| cell.trim().replace('\u{0}', "|");
    shielded.split('|').map(plain).collect()
}

/// The document's tables of keys, by section: `materials.NAME.isotropic`, or nothing for the top level.
fn sections() -> BTreeMap<String, BTreeMap<String, Row>> {
    let mut sections: BTreeMap<String, BTreeMap<String, Row>> = BTreeMap::new();
    let (mut section, mut headings) = (String::new(), Vec::new());
    for line in DOCUMENT.lines() {
        if let Some(heading) = line.strip_prefix('#') {
            let name = heading.trim_start_matches('#').trim();
            name.trim_matches(['`', '[', ']']).clone_into(&mut section);
            if name == "Top level" {
                section.clear();
            }
        }
        if !line.starts_with('|') {
            headings.clear();
        } else if headings.is_empty() {
            headings = line.trim_matches('|').split('|').map(str::trim).collect();
        } else if headings[0] == "key" && !line.starts_with("| ---") {
            let cells = cells(line);
            assert_eq!(cells.len(), headings.len(), "{line}");
            let key = cells[0].trim_matches('`').to_owned();
            let row: Row = headings.iter().copied().zip(cells).collect();
            let twice = sections
                .entry(section.clone())
                .or_default()
                .insert(key, row);
            assert!(twice.is_none(), "{line}");
        }
    }
    sections
}

fn child(parent: &str, name: &str) -> String {
    if parent.is_empty() {
        name.to_owned()
    } else {
        format!("{parent}.{name}")
    }
}

/// The section's place in [`BASE`], as `--set` names it.
fn place(section: &str) -> String {
    let (first, rest) = section.split_once('.').unwrap_or((section, ""));
    let rest = match first {
        "materials" => rest.replacen("NAME", "aluminium", 1),
        "plies" => rest.replacen("NAME", "carbon", 1),
        "bodies" => rest.replacen("NAME", "plate", 1),
        "contacts" | "supports" | "platens" | "loads" | "edges" => {
            format!("0.{rest}").trim_end_matches('.').to_owned()
        }
        _ => rest.to_owned(),
    };
    child(first, &rest).trim_end_matches('.').to_owned()
}

/// The keys or choices that the reader knows at this place, if there are any: what it answers to an unknown one.
fn known(place: &str) -> Option<BTreeSet<String>> {
    let error = read(&[format!("{}=1", child(place, "unheard_of"))]).unwrap_err();
    error
        .findings()
        .iter()
        .find_map(|finding| match &finding.problem {
            SceneProblem::UnknownKey {
                key: found, known, ..
            }
            | SceneProblem::UnknownName { found, known, .. }
                if found == "unheard_of" =>
            {
                Some(known.iter().cloned().collect())
            }
            _ => None,
        })
}

/// Compares a section with the reader, then all that are below it.
fn compare(
    section: &str,
    sections: &BTreeMap<String, BTreeMap<String, Row>>,
    visited: &mut BTreeSet<String>,
) {
    visited.insert(section.to_owned());
    let rows = &sections[section];
    let documented: BTreeSet<String> = rows.keys().cloned().collect();
    assert_eq!(Some(documented), known(&place(section)), "[{section}]");
    for (key, row) in rows {
        let mut below = child(section, key);
        if section.is_empty() && ["plies", "materials", "bodies"].contains(&key.as_str()) {
            below.push_str(".NAME");
        }
        if sections.contains_key(&below) {
            compare(&below, sections, visited);
            continue;
        }
        let text: String = row.values().cloned().collect();
        for choice in known(&place(&below)).unwrap_or_default() {
            let named = [format!("`\"{choice}\"`"), format!("`{choice}`")];
            assert!(
                named.iter().any(|name| text.contains(name)),
                "[{section}] {key} does not name {choice}"
            );
        }
    }
}

#[test]
fn the_document_has_the_keys_and_choices_that_the_reader_knows() {
    let sections = sections();
    let mut visited = BTreeSet::new();
    compare("", &sections, &mut visited);
    let documented: BTreeSet<String> = sections.into_keys().collect();
    assert_eq!(visited, documented);
    assert!(known("analysis.ramp").is_some_and(|choices| choices.len() == 2));
}

/// Every key of a resolved scene must have its row.
fn covered(value: &Value, section: &str, sections: &BTreeMap<String, BTreeMap<String, Row>>) {
    match value {
        Value::Array(list) => list
            .iter()
            .for_each(|entry| covered(entry, section, sections)),
        Value::Object(map) => {
            for (key, value) in map {
                if ["plies", "materials", "bodies"].contains(&section) {
                    covered(value, &child(section, "NAME"), sections);
                    continue;
                }
                let row = sections.get(section).and_then(|rows| rows.get(key));
                assert!(row.is_some(), "[{section}] {key} is not described");
                if key != "friction" {
                    covered(value, &child(section, key), sections);
                }
            }
        }
        _ => {}
    }
}

#[test]
fn the_document_describes_every_key_that_check_prints() {
    let sections = sections();
    let mut count = 0;
    for folder in [scenes(), scenes().join("validation")] {
        for entry in fs::read_dir(folder).unwrap() {
            let path = entry.unwrap().path();
            if path.extension().is_some_and(|end| end == "toml") {
                let scene = Scene::from_file(&path, &[] as &[&str], HOST).unwrap();
                let resolved: Value = toml::from_str(scene.resolved()).unwrap();
                covered(&resolved, "", &sections);
                count += 1;
            }
        }
    }
    assert!(count >= 13, "{count}");
}

/// The override that the row's example makes: `mesh.spacing = "1 deg"`.
fn example(section: &str, row: &Row) -> Option<String> {
    let cell = row.get("example")?;
    let assignment = cell.strip_prefix('`')?.strip_suffix('`')?;
    Some(child(&place(section), assignment))
}

/// The examples of a section's required keys.
fn needed(section: &str, rows: &BTreeMap<String, Row>) -> Vec<String> {
    let required = |row: &&Row| {
        row.get("default")
            .is_some_and(|cell| cell.starts_with("required"))
    };
    rows.values()
        .filter(required)
        .filter_map(|row| example(section, row))
        .collect()
}

#[test]
fn the_reader_accepts_every_example() {
    let mut count = 0;
    for (section, rows) in &sections() {
        let place = place(section);
        for (key, row) in rows {
            let Some(own) = example(section, row) else {
                let links = |column| {
                    row.get(column)
                        .is_some_and(|cell| cell.starts_with("[below](#"))
                };
                assert!(
                    links("example") || links("sizes"),
                    "[{section}] {key} has no example"
                );
                continue;
            };
            assert!(
                own.starts_with(&child(&place, key)),
                "[{section}] {key}: {own}"
            );
            let overrides: Vec<_> = needed(section, rows).into_iter().chain([own]).collect();
            // Elsewhere the base may no longer fit: a plate that became a block has no hole.
            let findings = read(&overrides)
                .err()
                .map_or(Vec::new(), |error| error.findings().to_vec());
            for finding in findings {
                assert!(!finding.key.starts_with(&place), "{overrides:?}: {finding}");
            }
            count += 1;
        }
    }
    assert!(count >= 60, "{count}");
}

#[test]
fn defaults_are_those_that_check_prints() {
    let mut count = 0;
    for (section, rows) in &sections() {
        let Ok(scene) = read(&needed(section, rows)) else {
            continue;
        };
        let resolved: Value = toml::from_str(scene.resolved()).unwrap();
        for (key, row) in rows {
            let default = row
                .get("default")
                .and_then(|cell| cell.strip_prefix('`')?.strip_suffix('`'));
            let pointer = format!("/{}", child(&place(section), key).replace('.', "/"));
            let printed = resolved.pointer(&pointer).map(Value::to_string);
            if let (Some(default), Some(printed)) =
                (default.filter(|text| !text.contains('`')), printed)
            {
                assert_eq!(default, printed, "[{section}] {key}");
                count += 1;
            }
        }
    }
    assert!(count >= 16, "{count}");
}

#[test]
fn whole_scenes_in_the_document_can_be_modelled() {
    for (fence, format) in [("```toml\n", Format::Toml), ("```json\n", Format::Json)] {
        let blocks: Vec<_> = DOCUMENT
            .split(fence)
            .skip(1)
            .filter_map(|rest| rest.split_once("```"))
            .collect();
        assert_eq!(blocks.len(), 1);
        for (text, _) in blocks {
            let scene =
                Scene::from_text_on(text, format, "document", &scenes(), &[] as &[&str], HOST)
                    .unwrap();
            Model::build(&scene).unwrap();
        }
    }
}

#[test]
fn links_inside_the_document_lead_to_headings() {
    let mut anchors = BTreeSet::new();
    for heading in DOCUMENT.lines().filter_map(|line| line.strip_prefix("##")) {
        let kept = |letter: &char| letter.is_alphanumeric() || ['_', '-', ' '].contains(letter);
        let text: String = heading
            .trim_start_matches('#')
            .trim()
            .chars()
            .filter(kept)
            .collect();
        let anchor = text.to_lowercase().replace(' ', "-");
        if !anchors.insert(anchor.clone()) {
            anchors.insert(format!("{anchor}-1"));
        }
    }
    for link in DOCUMENT.split("](#").skip(1) {
        let anchor = link.split(')').next().unwrap_or_default();
        assert!(anchors.contains(anchor), "{anchor}");
    }
}
