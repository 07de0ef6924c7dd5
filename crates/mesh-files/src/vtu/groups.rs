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

/// What the members of a set are.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Family {
    Nodes,
    Edges,
    Cells,
}

/// Reads the sets of a grid, whose cells are in `raw`.
pub(super) fn read(grid: &Grid<'_>, raw: &mut Raw) -> Result<Sets, ReadError> {
    let mut sets = Sets::default();
    let mut is_named = vec![false; grid.cells];
    let (mut passed, mut taken, mut total) = (Vec::new(), BTreeSet::new(), 0);
    for (part, count) in [("CellData", grid.cells), ("PointData", grid.points)] {
        for node in grid.arrays(part) {
            let name = node.attribute("Name").unwrap_or_default();
            let values = values(grid, node, count)?;
            let kinds: BTreeSet<i64> = values.iter().copied().collect();
            let is_numbering = count > 2 && kinds.len() == count;
            let kinds: Vec<i64> = kinds.into_iter().filter(|&value| value != 0).collect();
            if GHOSTS.contains(&name) && !kinds.is_empty() {
                let (at, array) = (grid.place(node), name.to_owned());
                return Err(ReadError::Ghosts { at, array });
            }
            if kinds.is_empty() || kinds.len() > MOST_SETS || is_numbering {
                passed.push(node);
                continue;
            }
            let set = |value: i64| {
                if kinds == [1] {
                    name.to_owned()
                } else {
                    format!("{name}-{value}")
                }
            };
            let mut own = BTreeSet::new();
            let members = values.iter().enumerate().filter(|(_, value)| **value != 0);
            for (member, &value) in members {
                let family = if part == "PointData" {
                    sets.nodes.entry(set(value)).or_default().push(member);
                    Family::Nodes
                } else {
                    is_named[member] = true;
                    add_cell(&mut sets, set(value), member, raw)
                };
                own.insert((family, value));
                total += 1;
            }
            if total > grid.most {
                let (at, limit) = (grid.place(node), grid.most);
                return Err(ReadError::SetsTooLarge { at, limit });
            }
            for (family, value) in own {
                if !taken.insert((family, set(value))) {
                    let (at, set) = (grid.place(node), set(value));
                    return Err(ReadError::SameSet { at, set });
                }
            }
        }
    }
    note_passed(grid, raw, &passed);
    note_unnamed(raw, &is_named);
    Ok(sets)
}

/// The values of an array of integers that may be sets or ghosts, none of another one.
fn values(grid: &Grid<'_>, node: Node<'_, '_>, count: usize) -> Result<Vec<i64>, ReadError> {
    let name = node.attribute("Name").unwrap_or_default();
    let is_declared = |of: &str| {
        let part = node.parent();
        part.and_then(|part| part.attribute(of)) == Some(name)
    };
    let is_ghost = GHOSTS.contains(&name);
    let is_other = name.is_empty() || name.starts_with("vtk") && !is_ghost;
    let components = node.attribute("NumberOfComponents").unwrap_or("1");
    if is_other
        || is_declared("GlobalIds")
        || is_declared("PedigreeIds")
        || !has_integers(node)
        || components != "1"
    {
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

/// Adds a cell, which `raw` has, to the set of its dimension. Cells are numbered as they stand, so that positions are numbers.
fn add_cell(sets: &mut Sets, set: String, element: usize, raw: &Raw) -> Family {
    match raw.elements[element].shape {
        Shape::Point => {
            let nodes = sets.nodes.entry(set).or_default();
            nodes.extend(raw.nodes_of(element).iter().map(|&node| node as usize));
            Family::Nodes
        }
        Shape::Line(_) => {
            let edges = sets.edges.entry(set).or_default();
            edges.push(RawEdge::Line { element });
            Family::Edges
        }
        Shape::Cell(_) => {
            sets.elements.entry(set).or_default().push(element);
            Family::Cells
        }
    }
}

fn note_passed(grid: &Grid<'_>, raw: &mut Raw, passed: &[Node<'_, '_>]) {
    let names = passed.iter().map(|node| node.attribute("Name"));
    let names: Vec<&str> = names.map(Option::unwrap_or_default).collect();
    if let Some(&first) = passed.first() {
        raw.notes.push(Note::Skipped {
            keyword: format!("arrays that are no sets, of reals, of several components, of zeros or with a number for each point or cell ({})", listed(&names)),
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
