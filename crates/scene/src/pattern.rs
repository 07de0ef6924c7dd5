//! Patterns: holes, cut-outs and bodies that a scene writes once and that stand in rows and columns.
//!
//! A table with a `pattern` is replaced by copies of it, `NAME_ROW_COLUMN` from 1, and what names it by copies that name these: entries of lists such as
//! `contacts` and `supports`, and fasteners. The scene is then read as if it had been written out, with the keys of single copies changed by tables of
//! their names. Columns follow each other along x, rows along y.

mod copies;
mod grid;
mod names;
mod places;
#[cfg(test)]
mod tests;

use serde_json::Value;

use crate::diagnostic::SceneError;
use crate::document::{Document, child};

use self::copies::{keys_of, replace};
use self::grid::{Cell, Grid};
use self::names::{Names, expand_lists};
use self::places::{move_edges, move_place};

/// Whether the override of `key` changes what a pattern copies, and so comes before the scene is written out.
pub(crate) fn is_copied(document: &Document, key: &str) -> bool {
    let ends = key.match_indices('.').map(|(at, _)| at).chain([key.len()]);
    let mut tables = ends.map(|end| &key[..end]);
    key.split('.').any(|name| name == "pattern")
        || tables.any(|table| document.get(&child(table, "pattern")).is_some())
        || is_of_copied_fastener(document, key)
}

/// Whether `key` is one of a fastener whose slices are copied.
fn is_of_copied_fastener(document: &Document, key: &str) -> bool {
    let Some(name) = (key.strip_prefix("fasteners.")).and_then(|rest| rest.split('.').next())
    else {
        return false;
    };
    let slices = document.get(&child(&child("fasteners", name), "slices"));
    let slices = slices.and_then(Value::as_array).into_iter().flatten();
    slices.filter_map(Value::as_str).any(|body| {
        let pattern = child(&child("bodies", body), "pattern");
        document.get(&pattern).is_some()
    })
}

/// Writes out all patterns of a scene.
///
/// # Errors
/// [`SceneError`] at a pattern that is no table of its keys, that has no rows, columns or pitch, or at an entry that names two patterns of different
/// rows or columns.
pub(crate) fn write_out(document: &mut Document) -> Result<(), SceneError> {
    let mut names = Names::default();
    for body in keys_of(document, "bodies") {
        let shape = child(&child("bodies", &body), "shape.outline");
        for (family, place) in [
            ("holes", place_of_hole as fn(&mut Value, &Grid, Cell)),
            ("cutouts", place_of_cutout),
        ] {
            let table = child(&shape, family);
            for set in keys_of(document, &table) {
                let key = child(&table, &set);
                let Some(grid) = Grid::of(document, &key, true)? else {
                    continue;
                };
                for own in sets_of(document.get(&key), &set) {
                    names.add(child(&body, own), grid.clone());
                }
                replace(document, &table, &set, &grid, place);
            }
        }
        let key = child("bodies", &body);
        if let Some(grid) = Grid::of(document, &key, false)? {
            replace(document, "bodies", &body, &grid, place_of_body);
            names.add(body, grid);
        }
    }
    if names.is_empty() {
        return Ok(());
    }
    expand_lists(document, &names)
}

/// The names by which scenes call the edges of a hole or of a cut-out.
fn sets_of(written: Option<&Value>, name: &str) -> Vec<String> {
    let edges = written.and_then(|own| own.get("edges")?.as_array());
    let Some(edges) = edges else {
        return vec![name.to_owned()];
    };
    let names = edges.iter().filter_map(|edge| edge.get("name")?.as_str());
    let mut names: Vec<String> = names.map(str::to_owned).collect();
    names.sort_unstable();
    names.dedup();
    names
}

fn place_of_hole(own: &mut Value, grid: &Grid, cell: Cell) {
    if let Some(centre) = own.get_mut("centre") {
        move_place(centre, &grid.steps(cell));
    }
}

fn place_of_cutout(own: &mut Value, grid: &Grid, cell: Cell) {
    let steps = grid.steps(cell);
    if let Some(start) = own.get_mut("start") {
        move_place(start, &steps);
    }
    if let Some(edges) = own.get_mut("edges") {
        move_edges(edges, &steps, cell);
    }
}

fn place_of_body(own: &mut Value, grid: &Grid, cell: Cell) {
    let steps = grid.steps(cell);
    if let (Value::Object(own), false) = (own, steps.is_empty()) {
        let origin = || serde_json::json!(["0 mm", "0 mm"]);
        let position = own.entry("position").or_insert_with(origin);
        move_place(position, &steps);
    }
}
