//! From nodes, elements and sets of a file to the parts of a mesh, the same for all formats.

mod cells;
mod coincident;
mod edges;
mod orient;
mod raw;
mod sets;

pub(crate) use raw::{RawEdge, Sets};

use stickslip_fem_core::mesh::{Mesh, MeshError, MeshParts};

use crate::error::ReadError;
use crate::imported::{Coincident, Imported};
use crate::note::Note;
use crate::quality;
use crate::raw::Numbered;
use cells::Cells;
use edges::EdgeTable;

/// What differs between formats.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Rules {
    pub(crate) coincident: Coincident,
    /// Whether node sets that form whole boundary edges become edge sets.
    pub(crate) edges_from_nodes: bool,
    /// Whether the same cell under two numbers is one cell in two groups.
    pub(crate) merge_twins: bool,
}

/// Makes the parts of a mesh.
///
/// # Errors
/// Every [`ReadError`] that concerns the mesh as a whole, in the file's numbers.
pub(crate) fn assemble(
    mut file: Numbered,
    sets: &Sets,
    rules: Rules,
) -> Result<Imported, ReadError> {
    let turned = orient::turn_clockwise(&mut file)?;
    let cells = Cells::new(&mut file, rules.merge_twins)?;
    let numbers = cells.numbers(&file);
    let parts = cells.parts(&file);
    let mesh = Mesh::new(parts).map_err(|error| translate(error, &file, &cells))?;
    let edges = EdgeTable::new(&mesh);
    if let Some([first, second]) = edges.overlap() {
        // `cells.order` has an entry for every cell of the mesh.
        let [first, second] = [first, second].map(|cell| cells.order[cell]);
        return Err(ReadError::Overlap {
            at: file.place(second),
            element: file.elements[second].number,
            other_at: file.place(first),
            other: file.elements[first].number,
        });
    }
    if rules.coincident == Coincident::Refuse {
        coincident::check(&mesh, &edges, &file, &cells)?;
    }
    check_shapes(&mesh, &file, &cells)?;
    let mut resolver = sets::Resolver {
        file: &file,
        cells: &cells,
        mesh: &mesh,
        edges: &edges,
        turned: &turned,
        notes: Vec::new(),
    };
    let mut named = resolver.all(sets)?;
    if rules.edges_from_nodes {
        resolver.edges_from_nodes(&mut named);
    }
    let sets_notes = resolver.notes;
    file.notes.extend(sets_notes);
    let shapes = Note::on_shapes(mesh.nodes(), mesh.blocks(), &numbers.1);
    file.notes.extend(shapes);
    Ok(Imported {
        parts: MeshParts {
            node_sets: named.node_sets,
            edge_sets: named.edge_sets,
            element_sets: named.element_sets,
            ..mesh.into_parts()
        },
        node_numbers: numbers.0,
        cell_numbers: numbers.1,
        notes: file.notes,
    })
}

/// Refuses cells of a shape that no solution bears.
fn check_shapes(mesh: &Mesh, file: &Numbered, cells: &Cells) -> Result<(), ReadError> {
    let flaws = quality::of_cells(mesh.nodes(), mesh.blocks());
    for (flaws, &element) in flaws.zip(&cells.order) {
        if let Some(flaw) = flaws.into_iter().find(|flaw| flaw.is_refused()) {
            return Err(ReadError::Flawed {
                at: file.place(element),
                element: file.elements[element].number,
                flaw,
            });
        }
    }
    Ok(())
}

/// A defect of the mesh in the numbers of the file.
fn translate(error: MeshError, file: &Numbered, cells: &Cells) -> ReadError {
    let (element, determinant, reference) = match error {
        MeshError::Inverted {
            element,
            determinant,
            at,
            ..
        }
        | MeshError::ZeroArea {
            element,
            determinant,
            at,
            ..
        } => (element, determinant, at),
        other => return ReadError::Mesh(other),
    };
    match cells.order.get(element) {
        Some(&element) => ReadError::Distorted {
            at: file.place(element),
            element: file.elements[element].number,
            determinant,
            reference,
        },
        None => ReadError::Mesh(error),
    }
}
