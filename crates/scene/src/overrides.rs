//! `--set key=value`: any key of a scene, replaced or added before the scene is read.
//!
//! The key names tables and list entries with dots: `contacts.0.friction.coulomb.mu`. The value is TOML; what is not TOML, such
//! as `2.25 deg`, is a text. Missing tables are made. Where a scene holds one of several alternatives, as one law under
//! `friction`, setting another one replaces it.

mod mistyped;

use std::sync::Arc;

use serde_json::{Map, Value};

use super::document::{Document, Format, Place, child};
use super::friction::is_choice;
use super::keys::table_at;
use super::read::described;
use crate::diagnostic::{SceneError, SceneProblem, SourceText};

pub(super) use mistyped::mistyped;

/// Name of the source that errors in an override are shown in.
const SOURCE: &str = "--set";

/// Applies one argument `key=value`.
pub(crate) fn apply(document: &mut Document, argument: &str) -> Result<(), SceneError> {
    let source = Arc::new(SourceText {
        name: SOURCE.to_owned(),
        text: argument.to_owned(),
    });
    let refuse = |problem| SceneError::in_text(problem, &source, Some(0..argument.len()));
    let form = || {
        refuse(SceneProblem::OverrideForm {
            argument: argument.to_owned(),
        })
    };
    let (left, right) = argument.split_once('=').ok_or_else(form)?;
    let key = left.trim();
    if key.is_empty()
        || key
            .split('.')
            .any(|segment| segment.trim() != segment || segment.is_empty())
    {
        return Err(form());
    }
    let right = right.trim();
    let value = if is_layup(key) && right.starts_with(['[', '(']) {
        Value::String(right.to_owned())
    } else {
        read_value(right, &source, left.len() + 1)?
    };
    let place = Place {
        source: Arc::clone(&source),
        key: Some(0..left.len()),
        value: left.len() + 1..argument.len(),
    };
    let changed = set(&mut document.root, key, value).map_err(|problem| refuse(*problem))?;
    for gone in changed.replaced {
        let below = child(&gone, "");
        document
            .places
            .retain(|key, _| *key != gone && !key.starts_with(&below));
    }
    for made in changed.made {
        document.places.insert(made, place.clone());
    }
    Ok(())
}

/// Whether the value is a lay-up, whose brackets are not those of a list.
fn is_layup(key: &str) -> bool {
    key.starts_with("materials.") && key.ends_with(".laminate.layup")
}

/// The right-hand side: TOML, or else a text.
fn read_value(text: &str, source: &Arc<SourceText>, offset: usize) -> Result<Value, SceneError> {
    let line = SourceText {
        name: SOURCE.to_owned(),
        text: format!("value = {text}"),
    };
    let failed = match Document::parse(line, Format::Toml) {
        Ok(mut document) => match document.root.get_mut("value") {
            Some(value) => return Ok(value.take()),
            None => return Ok(Value::String(text.to_owned())),
        },
        Err(error) => error,
    };
    let problem = failed
        .findings()
        .first()
        .map(|finding| finding.problem.clone());
    match problem {
        // A list, a table or a quoted text that is broken is no plain text.
        Some(SceneProblem::Syntax { .. }) if !text.starts_with(['[', '{', '"', '\'']) => {
            Ok(Value::String(text.to_owned()))
        }
        // A date is a text that happens to look like one.
        Some(SceneProblem::WrongKind { .. }) if !text.starts_with(['[', '{']) => {
            Ok(Value::String(text.to_owned()))
        }
        Some(problem) => {
            let span = Some(offset..source.text.len());
            Err(SceneError::in_text(problem, source, span))
        }
        None => Err(failed),
    }
}

/// What [`set`] did, as keys.
#[derive(Default)]
struct Changed {
    replaced: Vec<String>,
    made: Vec<String>,
}

fn set(root: &mut Value, key: &str, value: Value) -> Result<Changed, Box<SceneProblem>> {
    let segments: Vec<&str> = key.split('.').collect();
    let mut changed = Changed::default();
    let mut at = root;
    let mut path = String::new();
    for (depth, segment) in segments.iter().enumerate() {
        let is_last = depth + 1 == segments.len();
        let here = child(&path, segment);
        if let Value::Object(map) = at
            && !(is_last && value == Value::Bool(false))
        {
            for rival in rivals(&path, segment, map) {
                map.remove(&rival);
                changed.replaced.push(child(&path, rival));
            }
        }
        let empty = || match segments.get(depth + 1) {
            Some(next) if next.parse::<usize>().is_ok() => Value::Array(Vec::new()),
            _ => Value::Object(Map::new()),
        };
        at = match at {
            Value::Object(map) => {
                if !map.contains_key(*segment) {
                    changed.made.push(here.clone());
                }
                map.entry(*segment).or_insert_with(empty)
            }
            Value::Array(list) => {
                let index = index_of(list, &path, segment, key)?;
                if index == list.len() {
                    changed.made.push(here.clone());
                    list.push(empty());
                }
                &mut list[index]
            }
            other => {
                return Err(Box::new(SceneProblem::OverridePath {
                    key: key.to_owned(),
                    parent: path,
                    found: described(other),
                }));
            }
        };
        path = here;
    }
    *at = value;
    changed.replaced.push(key.to_owned());
    changed.made.push(key.to_owned());
    Ok(changed)
}

/// The index `segment` of the list at `path`, of an entry or of one behind the last.
fn index_of(
    list: &[Value],
    path: &str,
    segment: &str,
    key: &str,
) -> Result<usize, Box<SceneProblem>> {
    let length = list.len();
    let index = segment.parse().ok().filter(|index| *index <= length);
    index.ok_or_else(|| {
        Box::new(SceneProblem::OverrideIndex {
            key: key.to_owned(),
            list: path.to_owned(),
            length,
            index: segment.to_owned(),
        })
    })
}

/// Entries of the table at `path` that cannot stand beside `name`.
fn rivals(path: &str, name: &str, map: &Map<String, Value>) -> Vec<String> {
    let others = map.keys().filter(|other| *other != name);
    let table = table_at(path);
    if table.is_some_and(|table| table.is_choice) || is_choice(path) {
        return others.cloned().collect();
    }
    let exclusive = table.and_then(|table| table.exclusive);
    let groups = exclusive.map_or(&[][..], |exclusive| exclusive.groups);
    let Some(own) = groups.iter().find(|group| group.contains(&name)) else {
        return Vec::new();
    };
    let excluded = |other: &&String| {
        groups
            .iter()
            .any(|group| group != own && group.contains(&other.as_str()))
    };
    others.filter(excluded).cloned().collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::document::Part;
    use serde_json::json;

    fn document() -> Document {
        let text = "[mesh]\nspacing = \"1 deg\"\nfine_to = \"9 deg\"\n\
                    [[contacts]]\nfriction.static_dynamic = { static = 0.35, dynamic = 0.25 }\n\
                    [bodies.pin]\nmaterial = \"steel\"\n\
                    [bodies.disc]\nmesh.spacing = \"2 deg\"\n";
        let source = SourceText {
            name: "a.toml".into(),
            text: text.into(),
        };
        Document::parse(source, Format::Toml).unwrap()
    }

    fn after(argument: &str) -> Value {
        let mut document = document();
        apply(&mut document, argument).unwrap();
        document.root
    }

    fn refused(argument: &str) -> String {
        apply(&mut document(), argument).unwrap_err().to_string()
    }

    #[test]
    fn values_are_toml_or_text() {
        assert_eq!(
            after("mesh.spacing=2.25 deg")["mesh"]["spacing"],
            "2.25 deg"
        );
        assert_eq!(
            after("mesh.spacing=\"2.25 deg\"")["mesh"]["spacing"],
            "2.25 deg"
        );
        assert_eq!(after("mesh.layers = 12")["mesh"]["layers"], 12);
        assert_eq!(after("title=2026-01-01")["title"], "2026-01-01");
        assert_eq!(after("output.figures=false")["output"]["figures"], false);
        assert_eq!(after("a.b={ c = [1, 2] }")["a"]["b"], json!({"c": [1, 2]}));
    }

    #[test]
    fn another_choice_replaces_the_first() {
        let friction = &after("contacts.0.friction.coulomb.mu=0.15")["contacts"][0]["friction"];
        assert_eq!(*friction, json!({"coulomb": {"mu": 0.15}}));
        let friction =
            &after("contacts.0.friction.static_dynamic.static=0.3")["contacts"][0]["friction"];
        assert_eq!(
            *friction,
            json!({"static_dynamic": {"static": 0.3, "dynamic": 0.25}})
        );
        assert_eq!(
            after("mesh.angles=[\"0 deg\", \"180 deg\"]")["mesh"],
            json!({"angles": ["0 deg", "180 deg"]})
        );
        assert_eq!(
            after("bodies.disc.mesh.angles=[\"0 deg\", \"180 deg\"]")["bodies"]["disc"]["mesh"],
            json!({"angles": ["0 deg", "180 deg"]})
        );
        assert_eq!(
            after("bodies.pin.rigid=true")["bodies"]["pin"],
            json!({"rigid": true})
        );
        assert_eq!(
            after("bodies.pin.rigid=false")["bodies"]["pin"],
            json!({"rigid": false, "material": "steel"})
        );
    }

    #[test]
    fn lists_grow_by_one_and_missing_tables_are_made() {
        assert_eq!(
            after("edges.0.on=plate.hole")["edges"],
            json!([{"on": "plate.hole"}])
        );
        assert_eq!(
            after("contacts.1.name=b")["contacts"][1],
            json!({"name": "b"})
        );
        let error = refused("contacts.2.name=b");
        assert!(
            error.starts_with("--set:1:1: 'contacts.2.name'")
                && error.contains("'contacts' has 1 entry and '2'"),
            "{error}"
        );
    }

    #[test]
    fn bad_arguments_are_shown_as_they_are() {
        assert_eq!(
            refused("mesh.spacing"),
            "--set:1:1: 'mesh.spacing' is not of the form key=value"
        );
        assert!(refused("=3").contains("not of the form"));
        assert!(refused("mesh..spacing=3").contains("not of the form"));
        assert!(refused("mesh.angles=[1, 2").starts_with("--set:1:13: this is not valid TOML"));
        assert_eq!(refused("a.b=nan"), "--set:1:5: nan is not a finite number");
        assert!(refused("mesh.spacing.x=3").contains("'mesh.spacing' is the text \"1 deg\""));
    }

    #[test]
    fn errors_below_an_override_name_it() {
        let mut document = document();
        apply(&mut document, "contacts.0.friction.coulomb.mu=-1").unwrap();
        let problem = || SceneProblem::MissingVersion { supported: 1 };
        let finding = document.finding("contacts.0.friction.coulomb.mu", Part::Value, problem());
        assert_eq!(
            (finding.source.name.as_str(), finding.span),
            ("--set", Some(31..33))
        );
        let finding = document.finding("mesh.spacing", Part::Value, problem());
        assert_eq!(finding.source.name, "a.toml");
        let finding = document.finding(
            "contacts.0.friction.static_dynamic.static",
            Part::Value,
            problem(),
        );
        // What the override removed is shown at the table that it was in.
        assert_eq!(&finding.source.text[finding.span.unwrap()], "friction");
    }
}
