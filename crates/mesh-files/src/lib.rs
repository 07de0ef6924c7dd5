//! Plane finite-element meshes from files of other programs, and back.
//!
//! Text goes in, [`MeshParts`](stickslip_fem_core::mesh::MeshParts) come out, with the file's own numbers of nodes and elements and [`Note`]s on what was passed over.
//! What [`read`] returns is accepted by [`Mesh::new`](stickslip_fem_core::mesh::Mesh::new). No file is opened: whoever calls reads
//! the text, and an `*INCLUDE` is resolved by a closure.
//!
//! | format | node sets | edge sets | element sets |
//! | --- | --- | --- | --- |
//! | Gmsh, MSH 2.2 and 4.1 as text | physical points | physical curves | physical surfaces |
//! | VTK, unstructured grids in XML, `.vtu`, with arrays as text or in base 64 | arrays of integers on points, but those that number them | the same on lines; node sets that form whole boundary edges | the same on cells |
//! | Abaqus and CalculiX, `.inp` | `*NSET`, `*SURFACE, TYPE=NODE` | `*SURFACE, TYPE=ELEMENT`; node sets that form whole boundary edges; element sets of lines (T3D2, T3D3) | `*ELSET` |
//!
//! A physical group without a name is called `physical-3`. Of an array of integers the points or cells with a value other than 0 are a
//! set: of its name if that value is always 1, otherwise one of the name `NAME-3` for each value. Cells are triangles of 3 and 6 and quadrilaterals of 4, 8 and 9 nodes, one
//! block for each kind and group. Nodes are sorted by the file's numbers, and so are the cells of a block.
//!
//! ```
//! use stickslip_mesh_files::{Format, read};
//!
//! let text = "*NODE\n1, 0, 0\n2, 1, 0\n3, 1, 1\n4, 0, 1\n\
//!             *ELEMENT, TYPE=CPS4, ELSET=plate\n10, 1, 2, 3, 4\n\
//!             *NSET, NSET=left\n4, 1\n";
//! let no_includes = |name: &str| Err(std::io::Error::other(format!("no file {name}")));
//! let file = read(text, Format::Abaqus, &no_includes)?;
//! assert_eq!(file.parts.edge_sets["left"].edges.len(), 1);
//! assert_eq!(file.cell_numbers, [10]);
//! # Ok::<(), stickslip_mesh_files::ReadError>(())
//! ```
//!
//! [`write_msh`] and [`write_inp`] write meshes; [`recognise`] finds the line or circle that a chain of edges approximates, and [`snap`]
//! moves mid nodes from chords onto it.
//!
//! Sources: Gmsh reference manual, sections "MSH file format" and "MSH file format version 2 (Legacy)"; Abaqus Keywords Reference Guide;
//! Dhondt, *CalculiX CrunchiX User's Manual*, chapter "Input deck format"; *VTK File Formats*, section "XML File Formats".

mod abaqus;
mod assemble;
mod chain;
mod curves;
mod error;
mod foreign;
mod gmsh;
mod imported;
mod lines;
mod names;
mod note;
mod numbers;
mod pieces;
mod place;
mod quality;
mod raw;
mod recognise;
mod subset;
mod vtu;
mod write;

use std::io;

/// The crate of the meshes.
pub use stickslip_fem_core;

pub use curves::{PutOnCircle, put_on_circles, recognise_set, snap, snap_pieces};
pub use error::{CurveError, ReadError, Unsupported, WriteError};
pub use foreign::Foreign;
pub use imported::{Coincident, Imported};
pub use note::Note;
pub use pieces::{Piece, recognise_pieces};
pub use place::Place;
pub use quality::Flaw;
pub use recognise::{Recognised, nearly_circle, recognise};
pub use write::{write_inp, write_msh};

/// A format of mesh files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[non_exhaustive]
pub enum Format {
    /// MSH of Gmsh, versions 2.2 and 4.1, as text.
    Gmsh,
    /// Input files of Abaqus and CalculiX.
    Abaqus,
    /// Unstructured grids of VTK in XML.
    Vtk,
}

impl Format {
    /// The format of a file of this name, by its [`extension`](Self::extension) in either case.
    pub fn of_name(name: &str) -> Option<Self> {
        let (_, own) = name.rsplit_once('.')?;
        let mut all = [Self::Gmsh, Self::Abaqus, Self::Vtk].into_iter();
        all.find(|format| own.eq_ignore_ascii_case(format.extension()))
    }

    /// The extension of its files: `msh`, `inp` or `vtu`.
    pub const fn extension(self) -> &'static str {
        match self {
            Self::Gmsh => "msh",
            Self::Abaqus => "inp",
            Self::Vtk => "vtu",
        }
    }
}

/// Reads a mesh; coincident nodes of the boundary are refused.
///
/// `includes` returns the text of a file that the text includes by this name; only Abaqus files include others.
///
/// # Errors
/// [`ReadError`], with the line, the file's own number, and what to do.
pub fn read(
    text: &str,
    format: Format,
    includes: &dyn Fn(&str) -> io::Result<String>,
) -> Result<Imported, ReadError> {
    read_with(text, format, includes, Coincident::Refuse)
}

/// As [`read`], with the choice of what to do with coincident nodes.
///
/// # Errors
/// As [`read`].
pub fn read_with(
    text: &str,
    format: Format,
    includes: &dyn Fn(&str) -> io::Result<String>,
    coincident: Coincident,
) -> Result<Imported, ReadError> {
    match format {
        Format::Gmsh => gmsh::read(text, coincident),
        Format::Abaqus => abaqus::read(text, includes, coincident),
        Format::Vtk => vtu::read(text, coincident),
    }
}
