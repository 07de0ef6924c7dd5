//! Copies of entries in a document, each with the places where the original was written.

use std::collections::BTreeMap;

use serde_json::{Map, Value};

use super::grid::{Cell, Grid, named};
use crate::document::{Document, Place, child};

/// Replaces the entry `name` of the table `table` by copies in the cells of `grid`, each put in its place. What is written under the name of a copy
/// replaces its keys.
pub(super) fn replace(
    document: &mut Document,
    table: &str,
    name: &str,
    grid: &Grid,
    put: fn(&mut Value, &Grid, Cell),
) {
    let Some(Value::Object(entries)) = document.get_mut(table) else {
        return;
    };
    let Some(mut own) = entries.remove(name) else {
        return;
    };
    if let Value::Object(keys) = &mut own {
        keys.remove("pattern");
    }
    let mut copies = Vec::new();
    for cell in grid.cells() {
        let mut copy = own.clone();
        put(&mut copy, grid, cell);
        let written = entries.remove(&named(name, cell));
        merge(
            &mut copy,
            written.unwrap_or_else(|| Value::Object(Map::new())),
        );
        entries.insert(named(name, cell), copy);
        copies.push((named(name, cell), name.to_owned()));
    }
    copy_places(document, table, &copies);
}

/// Replaces values of `table` by those of `other` that are no tables.
fn merge(table: &mut Value, other: Value) {
    match (table, other) {
        (Value::Object(own), Value::Object(other)) => {
            for (key, value) in other {
                merge(own.entry(key).or_insert(Value::Null), value);
            }
        }
        (own, other) => *own = other,
    }
}

/// Moves the places of the entries of `table` to their copies: pairs of a new name and the old one, each old name in all of its pairs. What is written
/// under the new name already keeps its place.
pub(super) fn copy_places(document: &mut Document, table: &str, copies: &[(String, String)]) {
    let mut taken: BTreeMap<String, Vec<(String, Place)>> = BTreeMap::new();
    for (_, old) in copies {
        if taken.contains_key(old) {
            continue;
        }
        let entry = child(table, old);
        let below = child(&entry, "");
        let is_own = |key: &str| key == entry || key.starts_with(&below);
        let own: Vec<String> = (document.places.range(entry.clone()..))
            .map(|(key, _)| key)
            .take_while(|key| key.starts_with(&entry))
            .filter(|key| is_own(key))
            .cloned()
            .collect();
        let own = own.into_iter().filter_map(|key| {
            let place = document.places.remove(&key)?;
            Some((key[entry.len()..].to_owned(), place))
        });
        let own: Vec<_> = own.collect();
        taken.insert(old.clone(), own);
    }
    for (new, old) in copies {
        let entry = child(table, new);
        let own = taken.get(old).into_iter().flatten();
        let own = own.map(|(rest, place)| (format!("{entry}{rest}"), place.clone()));
        for (key, place) in own {
            document.places.entry(key).or_insert(place);
        }
    }
}

/// The keys of the table `table`, if it is one.
pub(super) fn keys_of(document: &Document, table: &str) -> Vec<String> {
    let table = document.get(table).and_then(Value::as_object);
    table.map_or(Vec::new(), |table| table.keys().cloned().collect())
}
