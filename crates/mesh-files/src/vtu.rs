//! Unstructured grids of VTK in XML (`.vtu`), with numbers as text or in base 64, plain or packed by zlib.
//!
//! Nodes and cells have no numbers of their own: they are counted from 0, as VTK does. What other formats call sets are arrays of
//! integers on points or cells here, see [`groups`].
//!
//! Sources: *VTK File Formats*, sections "XML File Formats" and "UnstructuredGrid"; cell types of `vtkCellType.h`.

mod arrays;
mod grid;
mod groups;
mod types;

use roxmltree::Document;

use crate::assemble::{Rules, assemble};
use crate::error::ReadError;
use crate::imported::{Coincident, Imported};
use crate::place::Spot;
use crate::raw::Raw;
use grid::{Grid, place};

/// Reads an unstructured grid.
///
/// # Errors
/// [`ReadError`].
pub(crate) fn read(text: &str, coincident: Coincident) -> Result<Imported, ReadError> {
    // A byte order mark is no part of the document.
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    let document = Document::parse(text).map_err(|cause| ReadError::Xml {
        at: place(cause.pos().row),
        cause: cause.to_string(),
    })?;
    let grid = Grid::new(&document)?;
    let mut raw = Raw::default();
    grid.nodes(&mut raw)?;
    grid.cells(&mut raw)?;
    let groups = groups::read(&grid, &mut raw)?;
    let end = Spot {
        file: 0,
        line: document.text_pos_at(text.len()).row,
    };
    let file = raw.number(end)?;
    let rules = Rules {
        coincident,
        edges_from_nodes: true,
        // Of a cell in two groups of MSH 2, converters write two.
        merge_twins: true,
    };
    assemble(file, &groups, rules)
}
