//! A mesh as it comes out of a file.

use stickslip_fem_core::mesh::MeshParts;

use crate::note::Note;

/// What to do with two nodes of the boundary at one place: closer than 1e-9 of the mesh's size.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Coincident {
    /// Refuse the mesh: it is most often torn along an inner line by mistake.
    #[default]
    Refuse,
    /// Keep them: the mesh holds several bodies that touch, or a crack.
    Allow,
}

/// A mesh and where it comes from.
#[derive(Clone, Debug, PartialEq)]
pub struct Imported {
    /// Nodes, cells and sets, ready for [`Mesh::new`](stickslip_fem_core::mesh::Mesh::new).
    pub parts: MeshParts,
    /// The file's number of each node, ascending.
    pub node_numbers: Vec<u64>,
    /// The file's number of each cell, in the order of the global cell index.
    pub cell_numbers: Vec<u64>,
    /// What was passed over or changed.
    pub notes: Vec<Note>,
}
