//! What names a pattern, copied with it.

use std::collections::BTreeMap;

use serde_json::Value;

use super::copies::{copy_places, keys_of, replace};
use super::grid::{Cell, Grid, named};
use crate::diagnostic::{SceneError, SceneProblem};
use crate::document::{Document, Part, child};

/// Lists whose entries name edges, and the keys that do.
const LISTS: [(&str, &[&str]); 5] = [
    ("contacts", &["first", "second"]),
    ("supports", &["on"]),
    ("platens", &["on"]),
    ("loads", &["on"]),
    ("edges", &["on"]),
];

/// The patterns of a scene by what names them: a body, or an edge as `body.set`.
#[derive(Debug, Default)]
pub(super) struct Names {
    grids: BTreeMap<String, Grid>,
}

impl Names {
    pub(super) fn add(&mut self, name: String, grid: Grid) {
        self.grids.insert(name, grid);
    }

    pub(super) fn is_empty(&self) -> bool {
        self.grids.is_empty()
    }

    /// The pattern that `text`, a body or `body.set`, names; as an error where both the body and the set are patterns.
    fn grid(&self, text: &str) -> Result<Option<&Grid>, ()> {
        let body = text.split('.').next().unwrap_or_default();
        let of_body = self.grids.get(body);
        match self.grids.get(text).filter(|_| body != text) {
            Some(_) if of_body.is_some() => Err(()),
            of_set => Ok(of_set.or(of_body)),
        }
    }

    /// `text` with the name of the pattern replaced by that of its copy.
    fn copied(&self, text: &str, cell: Cell) -> String {
        match text.split_once('.') {
            Some((body, set)) if self.grids.contains_key(body) => child(&named(body, cell), set),
            _ => named(text, cell),
        }
    }
}

/// Copies the entries of lists, and the fasteners, that name patterns.
///
/// # Errors
/// [`SceneError`] at a name that stands for a pattern in a pattern, or for one of other rows or columns than another in its entry.
pub(super) fn expand_lists(document: &mut Document, names: &Names) -> Result<(), SceneError> {
    for (list, keys) in LISTS {
        let Some(entries) = document.get(list).and_then(Value::as_array).cloned() else {
            continue;
        };
        let (mut all, mut copies) = (Vec::new(), Vec::new());
        for (index, entry) in entries.into_iter().enumerate() {
            let at = child(list, index);
            let texts = keys.iter().filter_map(|key| {
                let text = entry.get(key)?.as_str()?;
                Some((child(&at, key), text.to_owned()))
            });
            let texts: Vec<_> = texts.collect();
            let Some(grid) = common(document, names, &texts)? else {
                copies.push((all.len().to_string(), index.to_string()));
                all.push(entry);
                continue;
            };
            for cell in grid.cells() {
                copies.push((all.len().to_string(), index.to_string()));
                let mut copy = entry.clone();
                for key in keys {
                    if let Some(text) = copy.get_mut(*key) {
                        rename(text, names, cell);
                    }
                }
                if let Some(Value::String(name)) = copy.get_mut("name") {
                    *name = named(name, cell);
                }
                all.push(copy);
            }
        }
        if let Some(written) = document.get_mut(list) {
            *written = Value::Array(all);
        }
        copy_places(document, list, &copies);
    }
    failing_bodies(document, names);
    fasteners(document, names)
}

/// Bodies listed in `failure.bodies` that are patterns.
fn failing_bodies(document: &mut Document, names: &Names) {
    let key = "failure.bodies";
    let Some(Value::Array(bodies)) = document.get(key).cloned() else {
        return;
    };
    let (mut all, mut copies) = (Vec::new(), Vec::new());
    for (index, body) in bodies.into_iter().enumerate() {
        let grid = body.as_str().and_then(|text| names.grids.get(text));
        let cells = grid.into_iter().flat_map(Grid::cells);
        let mut named: Vec<Value> = cells
            .map(|cell| {
                let mut copy = body.clone();
                rename(&mut copy, names, cell);
                copy
            })
            .collect();
        if named.is_empty() {
            named.push(body);
        }
        copies.extend(
            (all.len()..all.len() + named.len()).map(|k| (k.to_string(), index.to_string())),
        );
        all.extend(named);
    }
    if let Some(written) = document.get_mut(key) {
        *written = Value::Array(all);
    }
    copy_places(document, key, &copies);
}

fn fasteners(document: &mut Document, names: &Names) -> Result<(), SceneError> {
    for name in keys_of(document, "fasteners") {
        let key = child(&child("fasteners", &name), "slices");
        let slices = document.get(&key).and_then(Value::as_array);
        let texts = slices.into_iter().flatten().enumerate();
        let texts = texts.filter_map(|(k, text)| Some((child(&key, k), text.as_str()?.to_owned())));
        let texts: Vec<_> = texts.collect();
        let Some(grid) = common(document, names, &texts)?.cloned() else {
            continue;
        };
        replace(document, "fasteners", &name, &grid, |_, _, _| {});
        for cell in grid.cells() {
            let key = child(&child("fasteners", named(&name, cell)), "slices");
            if let Some(Value::Array(slices)) = document.get_mut(&key) {
                for slice in slices {
                    rename(slice, names, cell);
                }
            }
        }
    }
    Ok(())
}

/// Puts the name of the copy in a cell for that of a pattern.
fn rename(text: &mut Value, names: &Names, cell: Cell) {
    if let Value::String(text) = text
        && let Ok(Some(_)) = names.grid(text)
    {
        *text = names.copied(text, cell);
    }
}

/// The rows and columns of all patterns that the texts, each with its key, name; `None` where they name none.
fn common<'a>(
    document: &Document,
    names: &'a Names,
    texts: &[(String, String)],
) -> Result<Option<&'a Grid>, SceneError> {
    let refuse = |key: &str, message: String, remedy: &str| {
        let problem = SceneProblem::conflict(message, remedy);
        Err(document.error(key, Part::Value, problem))
    };
    let mut found: Option<(&str, &Grid)> = None;
    for (key, text) in texts {
        let Ok(grid) = names.grid(text) else {
            let message = format!("'{text}' is a pattern in a body that is a pattern itself");
            let remedy = "name its copies, such as plate_1_1.hole_1_2, or write the bodies out";
            return refuse(key, message, remedy);
        };
        let Some(grid) = grid else {
            continue;
        };
        match found {
            Some((other, first)) if [first.rows, first.columns] != [grid.rows, grid.columns] => {
                let message = format!(
                    "'{other}' has {} rows and {} columns, and '{text}' {} and {}",
                    first.rows, first.columns, grid.rows, grid.columns
                );
                return refuse(key, message, "give both patterns the same rows and columns");
            }
            Some(_) => {}
            None => found = Some((text, grid)),
        }
    }
    Ok(found.map(|(_, grid)| grid))
}
