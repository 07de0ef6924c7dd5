//! Scenes as they are declared and documented: `docs/scene-format.md` has the declared tables, every example is accepted, and
//! defaults are those that `check` prints.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use serde_json::Value;
use stickslip::diagnostic::{SceneError, SceneProblem};
use stickslip::host::HOST;
use stickslip::model::Model;
use stickslip::scene::declaration::{Key, Table};
use stickslip::scene::keys::{document, tables};
use stickslip::scene::{Format, Scene};

const DOCUMENT: &str = include_str!("../../../docs/scene-format.md");

/// A scene that leaves out whatever it may, so that any key can be set in it; `expansion`, `accuracy`, `fine_to` and a laminate with a hole are
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
[analysis]
accuracy = "1 %"
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

/// Keys that only an outline or a mesh has, and an outline.
const OF_OUTLINES: [(&str, &str); 2] = [("bodies.NAME", "position"), ("bodies.NAME", "angle")];
const OUTLINE: &str = r#"{ outline = { start = ["-60 mm", "-20 mm"], edges = [{ name = "bottom", to = ["20 mm", "-20 mm"] }, { name = "right", to = ["20 mm", "20 mm"] }, { name = "top", to = ["-60 mm", "20 mm"] }, { name = "left" }] } }"#;

/// Keys that say something of what another key of their table names.
const GO_WITH: [((&str, &str), &str); 1] = [(("bodies.NAME.shape.mesh", "radii"), "circles")];

fn scenes() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../../scenes")
}

fn read(overrides: &[String]) -> Result<Scene, SceneError> {
    Scene::from_text_on(BASE, Format::Toml, "base.toml", &scenes(), overrides, HOST)
}

fn child(parent: &str, name: &str) -> String {
    if parent.is_empty() {
        name.to_owned()
    } else {
        format!("{parent}.{name}")
    }
}

/// The table's place in [`BASE`], as `--set` names it.
fn place(table: &Table) -> String {
    let (first, rest) = table.path.split_once('.').unwrap_or((table.path, ""));
    let rest = match first {
        "materials" => rest.replacen("NAME", "aluminium", 1),
        "plies" => rest.replacen("NAME", "carbon", 1),
        "bodies" => rest
            .replacen("NAME", "plate", 1)
            .replacen("outline.edges", "outline.edges.0", 1)
            .replacen("NAME.edges", "NAME.edges.0", 1),
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

/// Whether `key` is a table with keys of its own.
fn has_keys(table: &Table, key: &Key) -> bool {
    let own = child(table.path, key.name);
    tables().any(|table| table.path == own || table.path == child(&own, "NAME"))
}

#[test]
fn the_document_has_the_declared_tables() {
    let written = document(DOCUMENT).unwrap();
    assert!(written == DOCUMENT, "run `cargo xtask docs`");
}

#[test]
fn declarations_name_the_choices_that_the_reader_knows() {
    let mut count = 0;
    for table in tables() {
        for key in table.keys.iter().filter(|key| !has_keys(&table, key)) {
            let text = format!("{} {}", key.type_text(), key.meaning);
            for choice in known(&child(&place(&table), key.name)).unwrap_or_default() {
                let named = [format!("`\"{choice}\"`"), format!("`{choice}`")];
                assert!(
                    named.iter().any(|name| text.contains(name)),
                    "[{}] {} does not name {choice}",
                    table.path,
                    key.name
                );
                count += 1;
            }
        }
    }
    assert!(count >= 40, "{count}");
}

/// The override that the key's example makes: `mesh.spacing = "1 deg"`.
fn example(table: &Table, key: &Key) -> Option<String> {
    Some(child(&place(table), &key.assignment()?))
}

/// The examples of a table's required keys.
fn needed(table: &Table) -> Vec<String> {
    let required = table.keys.iter().filter(|key| key.is_required());
    required.filter_map(|key| example(table, key)).collect()
}

#[test]
fn the_reader_accepts_every_example() {
    let mut count = 0;
    for table in tables() {
        let place = place(&table);
        for key in table.keys {
            let Some(own) = example(&table, key) else {
                continue;
            };
            let outline = OF_OUTLINES.contains(&(table.path, key.name));
            let outline = outline.then(|| format!("{place}.shape={OUTLINE}"));
            let other = GO_WITH
                .iter()
                .find(|(own, _)| *own == (table.path, key.name));
            let other = other.and_then(|(_, other)| {
                let other = table.keys.iter().find(|key| key.name == *other)?;
                example(&table, other)
            });
            let needed = needed(&table).into_iter().chain(outline).chain(other);
            let overrides: Vec<_> = needed.chain([own]).collect();
            // Elsewhere the base may no longer fit: a plate that became a block has no hole. Nor has it the bolts of a fastener.
            let findings = read(&overrides)
                .err()
                .map_or(Vec::new(), |error| error.findings().to_vec());
            for finding in findings {
                let is_own = finding.key.starts_with(&place);
                let lacks_bolt = finding.to_string().contains("there is no body 'bolt-");
                assert!(!is_own || lacks_bolt, "{overrides:?}: {finding}");
            }
            count += 1;
        }
    }
    assert!(count >= 100, "{count}");
}

#[test]
fn defaults_are_those_that_check_prints() {
    let mut count = 0;
    for table in tables() {
        let Ok(scene) = read(&needed(&table)) else {
            continue;
        };
        let resolved: Value = toml::from_str(scene.resolved()).unwrap();
        for key in table.keys {
            let default = key
                .default
                .strip_prefix('`')
                .and_then(|rest| rest.strip_suffix('`'));
            let pointer = format!("/{}", child(&place(&table), key.name).replace('.', "/"));
            let printed = resolved.pointer(&pointer).map(Value::to_string);
            if let (Some(default), Some(printed)) =
                (default.filter(|text| !text.contains('`')), printed)
            {
                assert_eq!(default, printed, "[{}] {}", table.path, key.name);
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
