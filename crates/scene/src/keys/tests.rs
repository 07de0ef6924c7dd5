//! The declarations against the reader: what it knows is declared, and what is declared it knows.

use std::collections::BTreeSet;

use serde::Deserialize;
use serde_json::{Value, json};

use super::*;
use crate::declaration::*;
use crate::diagnostic::SceneProblem;
use crate::document::child;
use crate::examples::example;
use crate::format::SceneFormat;
use crate::read::Reader;
use crate::templates::TEMPLATES;
use crate::units::Expected;

fn names(table: &Table) -> BTreeSet<String> {
    table.keys.iter().map(|key| key.name.to_owned()).collect()
}

/// What the reader says of a scene that holds nothing but `value` in `table`.
fn refusal(table: &Table, value: Value) -> SceneProblem {
    let is_list = |key: &str| {
        let kind = declared(key).map(|key| key.kind.to_string());
        kind.as_deref() == Some("list of tables")
    };
    let path: Vec<&str> = table
        .path
        .split('.')
        .filter(|name| !name.is_empty())
        .collect();
    let inside = |value: Value, depth: usize| {
        let value = if is_list(&path[..=depth].join(".")) {
            json!([value])
        } else {
            value
        };
        json!({ path[depth]: value })
    };
    let scene = (0..path.len()).rev().fold(value, inside);
    let error = SceneFormat::deserialize(Reader::new(&scene, "")).unwrap_err();
    *error.problem
}

/// The keys that the reader knows in `table`.
fn known(table: &Table) -> BTreeSet<String> {
    match refusal(table, json!({ "unheard_of": 1 })) {
        SceneProblem::UnknownKey { known, .. } | SceneProblem::UnknownName { known, .. } => {
            known.into_iter().collect()
        }
        problem => panic!("[{}]: {problem}", table.path),
    }
}

fn parse(text: &str) -> Value {
    serde_json::to_value(toml::from_str::<toml::Table>(text).unwrap()).unwrap()
}

/// The scenes among the templates.
fn scenes() -> Vec<Value> {
    let texts = TEMPLATES.iter().map(|template| template.text);
    texts.map(parse).collect()
}

#[test]
fn scenes_have_the_declared_keys() {
    for table in tables() {
        assert_eq!(names(&table), known(&table), "[{}]", table.path);
    }
    let scenes = scenes();
    assert!(!scenes.is_empty());
    for table in tables() {
        let written = scenes.iter().flat_map(|scene| tables_at(table.path, scene));
        for (place, value) in written {
            let own: BTreeSet<_> = value.as_object().unwrap().keys().cloned().collect();
            assert!(own.is_subset(&names(&table)), "{place}: {own:?}");
        }
    }
}

/// The words by which the reader asks for a value of this kind; `None` where they differ from key to key.
fn asked(kind: Kind) -> Option<String> {
    let quantity = |expected: Expected| format!("{expected} with its unit in quotes");
    match kind {
        Kind::Quantity(dimensions) => Some(quantity(Expected::any(dimensions))),
        Kind::List(dimension) => Some(quantity(Expected::one(dimension))),
        Kind::Names(_) => None,
        Kind::Described(text) => Some(
            match text {
                "number" => "a number",
                "integer" => "a whole number, at least 0",
                "text" | "path" | "`body.set`" => "a text in quotes",
                "`true`, `false`" => "true or false",
                _ => return None,
            }
            .to_owned(),
        ),
    }
}

#[test]
fn the_reader_asks_for_the_declared_types() {
    let mut count = 0;
    for table in tables() {
        for key in table.keys {
            let Some(wanted) = asked(key.kind) else {
                continue;
            };
            let value = match key.kind {
                Kind::List(_) => json!([[]]),
                _ => json!([]),
            };
            match refusal(&table, json!({ key.name: value })) {
                SceneProblem::WrongKind { expected, .. } => {
                    assert_eq!(expected, wanted, "[{}] {}", table.path, key.name);
                }
                problem => panic!("[{}] {}: {problem}", table.path, key.name),
            }
            count += 1;
        }
    }
    assert!(count >= 90, "{count}");
}

#[test]
fn every_key_has_an_example_or_a_table_of_its_own() {
    for table in tables() {
        for key in table.keys {
            let own = child(table.path, key.name);
            let below =
                tables().any(|table| table.path == own || table.path == child(&own, "NAME"));
            assert!(below || key.assignment().is_some(), "{own}");
            assert!(!key.meaning.is_empty() && !key.default.is_empty(), "{own}");
        }
    }
}

#[test]
fn declarations_are_found_by_their_keys() {
    assert_eq!(
        example("materials.steel.isotropic.young"),
        "young = \"70 GPa\""
    );
    assert_eq!(example("loads.3.force.steps"), "steps = [\"1 kN\"]");
    assert_eq!(
        example("bodies.pin.shape"),
        "shape.disk = { radius = \"5 mm\" }"
    );
    assert!(declared("bodies.pin.colour").is_none());
}
