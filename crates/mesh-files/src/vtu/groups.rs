//! Arrays of integers as sets.
//!
//! Points or cells with one value other than 0 are a set: that of the value 1 has the name of the array if there is no other value,
//! and otherwise the set of a value v is called `NAME-v`. Lines make edge sets, points node sets, cells element sets.

use std::collections::{BTreeMap, BTreeSet};

use super::arrays::{Array, has_integers};
use super::grid::Grid;
use crate::assemble::{RawEdge, Sets};
use crate::error::ReadError;
use crate::note::Note;
use crate::raw::{Raw, Shape};

/// Most sets of an array; with more it holds numbers of nodes or cells.
const MOST_SETS: usize = 1000;

/// Reads the sets of a grid, whose cells are in `raw`.
pub(super) fn read(grid: &Grid<'_>, raw: &mut Raw) -> Result<Sets, ReadError> {
    let mut sets = Sets::default();
    let mut is_named = vec![false; grid.cells];
    for (part, count) in [("CellData", grid.cells), ("PointData", grid.points)] {
        for node in grid.arrays(part) {
            let name = node.attribute("Name").unwrap_or_default();
            let components = node.attribute("NumberOfComponents").unwrap_or("1");
            let is_single = has_integers(node) && components == "1";
            let values = match is_single.then(|| grid.array(node)).transpose()? {
                Some(Array::Integers(values)) if values.len() != count => {
                    return Err(ReadError::MissingValue {
                        at: grid.place(node),
                        what: "a value for every point or cell",
                    });
                }
                Some(Array::Integers(values)) => values,
                _ => Vec::new(),
            };
            let kinds: BTreeSet<i64> = values.iter().copied().filter(|&value| value != 0).collect();
            if kinds.is_empty()
                || kinds.len() > MOST_SETS
                || name.is_empty()
                || name.starts_with("vtk")
            {
                raw.notes.push(Note::Skipped {
                    keyword: format!("array '{name}' of {part}"),
                    at: grid.place(node),
                    count: 1,
                });
                continue;
            }
            let is_plain = kinds.iter().eq([&1]);
            let members = values.iter().enumerate().filter(|(_, value)| **value != 0);
            for (member, value) in members {
                let set = if is_plain {
                    name.to_owned()
                } else {
                    format!("{name}-{value}")
                };
                if part == "PointData" {
                    sets.nodes.entry(set).or_default().push(member);
                } else {
                    is_named[member] = true;
                    add_cell(&mut sets, set, member, raw);
                }
            }
        }
    }
    note_unnamed(raw, &is_named);
    Ok(sets)
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
