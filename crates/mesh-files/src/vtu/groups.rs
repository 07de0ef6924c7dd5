//! Arrays of integers as sets.
//!
//! Points or cells with one value other than 0 are a set: that of the value 1 has the name of the array if there is no other value,
//! and otherwise the set of a value v is called `NAME-v`. Lines make edge sets, points node sets, cells element sets.
//!
//! Other arrays are passed over: those of reals, of several components, of VTK's own names, and those that number points or cells.

use std::collections::{BTreeMap, BTreeSet};

use roxmltree::Node;

use super::arrays::{Array, has_integers};
use super::grid::Grid;
use crate::assemble::{RawEdge, Sets};
use crate::error::ReadError;
use crate::names::listed;
use crate::note::Note;
use crate::raw::{Raw, Shape};

/// Most sets of an array; with more it holds numbers of nodes or cells.
const MOST_SETS: usize = 1000;

/// The arrays by which VTK marks copies and what is hidden, of today and of before 2014.
const GHOSTS: [&str; 2] = ["vtkGhostType", "vtkGhostLevels"];

/// Reads the sets of a grid, whose cells are in `raw`.
pub(super) fn read(grid: &Grid<'_>, raw: &mut Raw) -> Result<Sets, ReadError> {
    let mut sets = Sets::default();
    let mut is_named = vec![false; grid.cells];
    let mut passed = Vec::new();
    for (part, count) in [("CellData", grid.cells), ("PointData", grid.points)] {
        let mut taken = BTreeSet::new();
        for node in grid.arrays(part) {
            let name = node.attribute("Name").unwrap_or_default();
            let values = values(grid, node, count)?;
            let kinds: BTreeSet<i64> = values.iter().copied().filter(|&value| value != 0).collect();
            if GHOSTS.contains(&name) && !kinds.is_empty() {
                let (at, array) = (grid.place(node), name.to_owned());
                return Err(ReadError::Ghosts { at, array });
            }
            if numbers(node, count, kinds.len()) {
                passed.push(node);
                continue;
            }
            let is_plain = kinds.iter().eq([&1]);
            let set = |value: i64| {
                if is_plain {
                    name.to_owned()
                } else {
                    format!("{name}-{value}")
                }
            };
            if let Some(set) = kinds
                .iter()
                .map(|&value| set(value))
                .find(|set| !taken.insert(set.clone()))
            {
                let at = grid.place(node);
                return Err(ReadError::SameSet { at, set });
            }
            let members = values.iter().enumerate().filter(|(_, value)| **value != 0);
            for (member, &value) in members {
                if part == "PointData" {
                    sets.nodes.entry(set(value)).or_default().push(member);
                } else {
                    is_named[member] = true;
                    add_cell(&mut sets, set(value), member, raw);
                }
            }
        }
    }
    note_passed(grid, raw, &passed);
    note_unnamed(raw, &is_named);
    Ok(sets)
}

/// The integers of an array, none of another one.
fn values(grid: &Grid<'_>, node: Node<'_, '_>, count: usize) -> Result<Vec<i64>, ReadError> {
    let components = node.attribute("NumberOfComponents").unwrap_or("1");
    if !has_integers(node) || components != "1" {
        return Ok(Vec::new());
    }
    match grid.array(node, count)? {
        Array::Integers(values) if values.len() == count => Ok(values),
        _ => Err(ReadError::MissingValue {
            at: grid.place(node),
            what: "a value for every point or cell",
        }),
    }
}

/// Whether an array of `kinds` values other than 0 on `count` points or cells is no set: it has none, or numbers them.
fn numbers(node: Node<'_, '_>, count: usize, kinds: usize) -> bool {
    let name = node.attribute("Name").unwrap_or_default();
    let is_declared = |of: &str| {
        let part = node.parent();
        part.and_then(|part| part.attribute(of)) == Some(name)
    };
    let counts = count > 2 && kinds + 1 >= count;
    let is_own = name.is_empty() || name.starts_with("vtk");
    is_own
        || kinds == 0
        || kinds > MOST_SETS
        || counts
        || is_declared("GlobalIds")
        || is_declared("PedigreeIds")
}

/// Adds a cell, which `raw` has, to the set of its dimension. Cells are numbered as they stand, so that positions are numbers.
fn add_cell(sets: &mut Sets, set: String, element: usize, raw: &Raw) {
    match raw.elements[element].shape {
        Shape::Point => {
            let nodes = sets.nodes.entry(set).or_default();
            nodes.extend(raw.nodes_of(element).iter().map(|&node| node as usize));
        }
        Shape::Line(_) => {
            let edges = sets.edges.entry(set).or_default();
            edges.push(RawEdge::Line { element });
        }
        Shape::Cell(_) => sets.elements.entry(set).or_default().push(element),
    }
}

fn note_passed(grid: &Grid<'_>, raw: &mut Raw, passed: &[Node<'_, '_>]) {
    let names = passed.iter().map(|node| node.attribute("Name"));
    let names: Vec<&str> = names.map(Option::unwrap_or_default).collect();
    if let Some(&first) = passed.first() {
        raw.notes.push(Note::Skipped {
            keyword: format!("arrays that are no sets ({})", listed(&names)),
            at: grid.place(first),
            count: passed.len(),
        });
    }
}

fn note_unnamed(raw: &mut Raw, is_named: &[bool]) {
    let mut unnamed = BTreeMap::new();
    for (element, _) in raw
        .elements
        .iter()
        .zip(is_named)
        .filter(|(_, named)| !**named)
    {
        let what = match element.shape {
            Shape::Point => "point",
            Shape::Line(_) => "line",
            Shape::Cell(_) => continue,
        };
        *unnamed.entry(what).or_insert(0) += 1;
    }
    let notes = unnamed.into_iter();
    raw.notes
        .extend(notes.map(|(what, count)| Note::Unnamed { what, count }));
}
